#!/usr/bin/env bash
# tests/figures.sh [PROGRAM] [SCENE]...
# Checks figures with other people's renderers: rsvg-convert, pdftoppm, pdftocairo, gs and mutool. A figure of
# each scene is drawn as SVG, PDF and EPS on magenta paper, once in its colours and once in the colours of the
# faces' numbers. At each pixel whose eight neighbours show the same face, it must have the colour of
# `xnewell draw`, and the number of `--ids`. It also tells how much of the paper shows between areas.
# Exit status: 0 if no pixel is wrong, 1 if one is, 77 if a renderer, Pillow or NumPy is missing.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
program=${1:-$root/build/release/x11/xnewell}
shift || true
scenes=("$@")
((${#scenes[@]})) || scenes=(cubes cycle tori pinwheels crossing-sheets penetrate nested-cycles teapot)
for needed in rsvg-convert pdftoppm pdftocairo gs mutool qpdf xmllint; do
  command -v "$needed" > /dev/null || { echo "figures.sh: $needed is missing" >&2; exit 77; }
done
python=/usr/bin/python3  # the one that has the packages of the system
"$python" -c 'import numpy, PIL' 2> /dev/null || { echo 'figures.sh: NumPy or Pillow is missing' >&2; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for scene in "${scenes[@]}"; do
  file=$folder/$scene
  "$program" draw "$scene" --shade flat --colors one -o "$file.png" --ids "$file.ids.png"
  for format in svg pdf eps; do
    "$program" figure "$scene" --shade flat --colors one --paper '#ff00ff' \
      -o "$file.$format" --ids "$file.ids.$format"
  done
  qpdf --check "$file.pdf" > /dev/null
  xmllint --noout "$file.svg"
done
"$python" "$root/tests/figures.py" "$folder" "${scenes[@]}"
