#!/usr/bin/env bash
# run_examples.sh PREFIX BUILD: what the examples print and leave is what their comments say.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "$1"; exit 1; }

cat >small.json <<'JSON'
{ "erg": 1, "model": "werner", "grid": {"nx": 96, "ny": 64}, "scene": {"kind": "random"},
  "run": {"steps": 1000, "seed": 3, "threads": 1} }
JSON
"$2/grow_and_measure" small.json dunes >numbers.csv
[ "$(wc -l <numbers.csv)" -eq 11 ] || fail "expected a heading and ten rows: $(cat numbers.csv)"
# Dunes grow: the standard deviation of the height in the last row is over twice that of the first.
awk -F, 'NR == 2 { first = $2 } END { exit !($2 > 2 * first) }' numbers.csv || fail "no dunes: $(cat numbers.csv)"
[ -s dunes.png ] || fail "no heightmap"
"$1/bin/erg" run --resume dunes.checkpoint --steps 1001 --threads 1 --quiet --out more || fail "the program does not go on with the checkpoint"
! "$2/grow_and_measure" none.json dunes 2>errors.txt || fail "a missing config is no error"
grep -q 'none.json' errors.txt || fail "the error does not name the file: $(cat errors.txt)"

# The same sand over a deep and over a high water table: wet flats, and nothing dug out below them.
"$2/own_model" . | tee tables.txt
[ "$(wc -l <tables.txt)" -eq 2 ] || fail "expected two lines"
[ -s water_table_0m.png ] && [ -s water_table_0.7m.png ] || fail "no pictures"
