#!/usr/bin/env bash
# install.sh CMAKE BUILD PREFIX: installs, then moves everything to PREFIX, so that only what can be moved passes.
set -euo pipefail
first=$3.first
rm -rf "$first" "$3"
"$1" --install "$2" --prefix "$first" >/dev/null
mv "$first" "$3"

for there in bin/erg share/erg/shaders share/erg/cfg/barchans.json share/erg/cfg/gallery/barchans.jpg \
  share/erg/README.md share/erg/LICENSE share/erg/CHANGELOG.md share/erg/docs/guide.md share/erg/docs/images \
  share/erg/examples/CMakeLists.txt include/erg/sim/simulation.h include/erg/io/checkpoint/checkpoint.h; do
  [ -e "$3/$there" ] || { echo "$there is not installed"; exit 1; }
done
for name in ErgConfig.cmake ErgConfigVersion.cmake ErgTargets.cmake liberg_io_checkpoint.a; do
  find "$3" -name "$name" | grep -q . || { echo "$name is not installed"; exit 1; }
done
