#!/usr/bin/env bash
# Installs what is missing, builds, and grows dunes from CONFIG (a file, or the name of a preset; default: a field of
# barchans) into the folder out/.
set -euo pipefail
config=${1:-barchans}
[ ! -f "$config" ] || config=$(realpath "$config")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/lib/prepare.sh

install_missing
build_release
exec build/release/src/erg run "$config" --out out
