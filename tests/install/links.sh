#!/usr/bin/env bash
# links.sh FOLDER: every relative link of the pages under FOLDER leads to a file.
set -euo pipefail
cd "$1"
checked=0
while IFS= read -r page; do
  while IFS= read -r link; do
    checked=$((checked + 1))
    [ -e "$(dirname "$page")/$link" ] || { echo "$page links to $link, which is not there"; exit 1; }
  done < <(grep -oE '\]\([^)#: ]+[)#]' "$page" | sed 's/^..//; s/.$//')
done < <(find . -name '*.md')
[ "$checked" -gt 40 ] || { echo "only $checked links found"; exit 1; }
