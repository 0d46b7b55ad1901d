#!/usr/bin/env bash
# Checks that every source file is formatted, and runs clang-tidy over those named (default: all of src/).
# Needs the Debian packages clang-format and clang-tidy, and a configured build/release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run -Werror
[ $# -gt 0 ] || mapfile -t files < <(git ls-files 'src/*.cpp')
clang-tidy --quiet --warnings-as-errors='*' --extra-arg=-Wno-unknown-warning-option -p build/release "${@:-${files[@]}}"
