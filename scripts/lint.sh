#!/usr/bin/env bash
# Checks the format of every source file (clang-format) and runs clang-tidy over src/: scripts/lint.sh [FILE...]
# With files named, clang-tidy looks at those alone. Else it reads them together as the preset `clang` compiles them:
# what takes its time are headers, and those that a lot shares it reads once. Files taken in by others (.h, .inl, .k, and
# the kernels of cuda_calls.cu, through their emulation) are looked at there, those of the engine for one instruction set.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/lib/prepare.sh

install_missing
install_missing scripts/developer_packages.txt

git ls-files '*.h' '*.cpp' '*.inl' '*.cu' '*.k' | xargs clang-format --dry-run -Werror

cmake --preset clang >/dev/null
files=("$@")
if [ $# -eq 0 ]; then
  mapfile -t files < <(sed -n 's/^ *"file": "\(.*\)",\?$/\1/p' build/clang/compile_commands.json |
    grep -E "^$PWD/(build/clang/)?(src/|tests/CMakeFiles/test_cuda)" | grep -v '_avx.*\.cpp$')
fi
# Its count of warnings in the system's headers is no news.
tidy() { clang-tidy --quiet --warnings-as-errors='*' -p build/clang "$1" 2> >(grep -v ' generated\.$' >&2); }
export -f tidy
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'tidy "$1"' tidy
