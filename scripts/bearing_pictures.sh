#!/bin/bash
# Draws docs/images/bearings_barchan.jpg and bearings_two_winds.jpg: a barchan under winds from seven bearings, turned so
# that the wind blows from the left, and crests under two winds 60 degrees apart at four bearings of their middle;
# without a spread above, with the models' own below.
# Usage: scripts/bearing_pictures.sh [PROGRAM]   (default: build/release/src/erg)
set -euo pipefail
cd "$(dirname "$0")/.."
program=${1:-build/release/src/erg}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
draw() {  # PICTURE CONFIG SETTINGS...
  "$program" render "$2" --camera top --copies 0 --no-legend --supersample 1 --quiet --out "$1" "${@:3}"
}

barchans=()
for spread in 0 10; do
  for bearing in 225 250 270 285 300 315 330; do
    picture=$work/barchan_${spread}_$bearing.png
    draw "$picture" barchans --size 768x768 --steps 192 --set nx=384 --set ny=384 --set scene.kind=cone --set sand=0 \
      --set scene.height=12 --set scene.radius=36 --set "wind.bearing=$bearing" --set "wind.spread=$spread"
    # The dune has gone some 110 cells; a cell is two points.
    convert "$picture" -rotate $((270 - bearing)) +repage -gravity center -crop 220x200+260+0 +repage "$picture"
    barchans+=(-label "$bearing, spread $spread" "$picture")
  done
done
montage "${barchans[@]}" -tile 7x2 -geometry +2+2 -pointsize 14 -quality 85 docs/images/bearings_barchan.jpg

crests=()
for spread in 0 10; do
  for middle in 270 285 300 315; do
    picture=$work/crests_${spread}_$middle.png
    season="\"strength\": 5, \"steps\": 10, \"spread\": $spread"
    cat > "$work/config.json" <<END
{"erg": 1, "model": "momiji", "scene": {"sand": 10}, "run": {"steps": 1500},
 "wind": {"seasons": [{"bearing": $(((middle + 30) % 360)), $season}, {"bearing": $((middle - 30)), $season}]}}
END
    draw "$picture" "$work/config.json" --size 280x280
    crests+=(-label "$middle, spread $spread" "$picture")
  done
done
montage "${crests[@]}" -tile 4x2 -geometry +2+2 -pointsize 14 -quality 85 docs/images/bearings_two_winds.jpg
