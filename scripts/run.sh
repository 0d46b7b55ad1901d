#!/usr/bin/env bash
# Installs what is missing, builds, and opens the window on CONFIG (a file, or the name of a preset; default: a field of
# barchans). Where there is no display it grows the dunes of CONFIG into the folder out/ instead.
set -euo pipefail
config=${1:-barchans}
[ ! -f "$config" ] || config=$(realpath "$config")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/lib/prepare.sh

install_missing
build_release
if [ -n "${DISPLAY:-}" ]; then
  exec build/release/src/erg gui "$config"
fi
echo "No display: growing $config into out/ without the window."
exec build/release/src/erg run "$config" --out out
