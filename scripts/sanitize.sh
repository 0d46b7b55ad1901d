#!/usr/bin/env bash
# Builds with sanitizers and runs the parts of the suite that fit: scripts/sanitize.sh [asan|tsan] [ctest's arguments]
# asan: addresses, leaks and undefined behaviour; tsan: threads. Both after each other when none is named.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/lib/prepare.sh

install_missing
install_missing scripts/developer_packages.txt  # clang, for asan

# Builds a preset's tests of these folders and runs those whose names fit.
check() {
  local preset=$1 tests=$2
  shift 2
  local targets=()
  for name in $tests; do targets+=("test_$name"); done
  cmake --preset "$preset" -DERG_UNITY=ON >/dev/null
  cmake --build --preset "$preset" --target "${targets[@]}"
  # The others are not built, and what is installed is tested without sanitizers.
  ctest --preset "$preset" --no-tests=error -E '_NOT_BUILT$|^Install\.' "$@"
}

case "${1:-both}" in
  asan) check asan "unit laws cuda studio ui window" "${@:2}" ;;
  tsan) check tsan "laws cuda studio ui" "${@:2}" ;;
  both)
    scripts/sanitize.sh asan
    scripts/sanitize.sh tsan
    ;;
  *)
    echo "usage: scripts/sanitize.sh [asan|tsan] [arguments of ctest]" >&2
    exit 2
    ;;
esac
