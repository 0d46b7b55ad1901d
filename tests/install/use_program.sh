#!/usr/bin/env bash
# use_program.sh PREFIX SOURCE CONTEXT: the installed program at work in an empty folder and without any environment.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "$1"; exit 1; }
erg() { env -i "$1/bin/erg" "${@:2}"; }

# No path of the source tree is in the program, so it cannot go there.
! grep -qF "$2" "$1/bin/erg" || fail "the program names the folder that it was built from"

erg "$1" presets >presets.txt
grep -q '^barchans ' presets.txt || fail "the presets are not found"
erg "$1" run barchans --set nx=48 --set ny=32 --steps 5 --threads 1 --quiet --out out || fail "the run failed"
saved=out/barchans-000005.checkpoint
[ -s out/barchans-000005.png ] && [ -s "$saved" ] || fail "the run left: $(ls out)"
erg "$1" render "$saved" --context "$3" --size 64x48 --quiet --out barchans.png || fail "render failed"
[ -s barchans.png ] || fail "no picture was drawn"

# Without its files the program says which folder it misses, and takes no other.
mkdir -p bare/bin
cp "$1/bin/erg" bare/bin
for arguments in "presets" "render $saved --context $3 --size 64x48 --quiet --out none.png"; do
  # shellcheck disable=SC2086 # one word for each argument
  ! message=$(erg bare $arguments 2>&1) || fail "without its files \`erg $arguments\` found some elsewhere"
  grep -qF "$work/bare/share/erg/" <<<"$message" || fail "erg $arguments: $message"
done
