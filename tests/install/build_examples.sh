#!/usr/bin/env bash
# build_examples.sh CMAKE PREFIX BUILD OPTION...: builds the installed examples against the installed library.
set -euo pipefail
rm -rf "$3"
env -u CPATH "$1" -S "$2/share/erg/examples" -B "$3" "-DCMAKE_PREFIX_PATH=$2" "${@:4}" >/dev/null
"$1" --build "$3" >/dev/null
