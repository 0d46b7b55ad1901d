#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Ends with the line "N passed, N failed" (and ", N skipped" when
# some were); fails when a test fails or none ran. Arguments go to ctest: scripts/test.sh -R Checkpoint
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/lib/prepare.sh

install_missing
build_release
result=build/release/test-result.xml
rm -f "$result"
status=0
ctest --preset release --parallel "$(nproc)" --no-tests=error --output-junit test-result.xml "$@" || status=$?

# A number among the attributes of the result's <testsuite ...> element, which ctest spreads over lines.
count() { sed -n '/<testsuite/,/>/{s/.*[[:space:]]'"$1"'="\([0-9]*\)".*/\1/p}' "$result" | head -n 1; }
if [ ! -f "$result" ] || [ "$(count tests)" = 0 ]; then
  echo "no test ran" >&2
  exit 1
fi
skipped=$(($(count skipped) + $(count disabled)))
line="$(($(count tests) - $(count failures) - skipped)) passed, $(count failures) failed"
[ "$skipped" -eq 0 ] || line="$line, $skipped skipped"
echo "$line"
exit "$status"
