#!/usr/bin/env bash
# All that a change is held to, in parts that have a build of their own each: scripts/ci.sh [PART...]
#   lint   format of all files, clang-tidy
#   debug  without optimisation: the golden hashes are the same
#   asan   addresses, leaks, undefined behaviour: the unit tests, compiled by clang, which is quicker at it
#   tsan   threads: the tests of the window's worker, compiled by clang too
#   clang  a second compiler: the golden hashes are the same (`lint` reads the whole program with its warnings)
#   test   scripts/test.sh, the release build and every test; its line "N passed, N failed" comes last
# Without names it does all of them, whether or not one fails, and fails if one did. scripts/sanitize.sh does more.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/lib/prepare.sh

# build PRESET TARGET...: nvcc and the graphics card have their say in the part `test`.
build() {
  cmake --preset "$1" -DERG_CUDA=OFF -DERG_UNITY=ON >/dev/null &&
    cmake --build --preset "$1" --target "${@:2}" -- --quiet
}

# run_tests PRESET PROGRAM: in one process for each processor.
run_tests() {
  local program=build/$1/tests/$2 shards status=0 pids=() shard
  shards=$(nproc)
  for ((shard = 0; shard < shards; ++shard)); do
    GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard "$program" --gtest_brief=1 &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do wait "$pid" || status=1; done
  return "$status"
}

part_lint() { scripts/lint.sh; }
part_debug() { build debug test_golden && run_tests debug test_golden; }
part_asan() { build asan test_unit && run_tests asan test_unit; }
part_tsan() { build tsan test_session && run_tests tsan test_session; }
part_clang() { build clang test_golden && run_tests clang test_golden; }
part_test() { scripts/test.sh; }

parts=(lint debug asan tsan clang test)
[ $# -eq 0 ] || parts=("$@")
install_missing
install_missing scripts/developer_packages.txt
status=0
summary=()
for part in "${parts[@]}"; do
  if ! declare -F "part_$part" >/dev/null; then
    echo "usage: scripts/ci.sh [lint|debug|asan|tsan|clang|test]..." >&2
    exit 2
  fi
  [ "$part" != test ] || [ "${#summary[@]}" -eq 0 ] || printf '%s\n' "${summary[@]}"
  echo "--- $part ---"
  begin=$SECONDS
  outcome=ok
  "part_$part" || { outcome=FAILED && status=1; }
  summary+=("$part: $outcome, $((SECONDS - begin)) s")
done
[ "${parts[-1]}" = test ] || printf '%s\n' "${summary[@]}"
exit "$status"
