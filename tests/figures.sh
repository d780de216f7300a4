#!/usr/bin/env bash
# tests/figures.sh [PROGRAM] [--size WxH] [--views N] [SCENE]...
# Checks figures with other people's renderers: rsvg-convert, pdftoppm, pdftocairo, gs and mutool. A figure of
# each scene is drawn as SVG, PDF and EPS on magenta paper, once in its colours and once in the colours of the
# faces' numbers. A pixel is away from edges if it and its eight neighbours show one face, also at four times
# the size. There it must have the colour of `xnewell draw`, and the number of `--ids`. It also tells how much of
# the paper shows between areas. With --size there is no picture of four times the size. With --views 12 each
# scene is seen from twelve sides; `all` stands for all scenes of data/scenes and the teapot.
# Exit status: 0 if no pixel is wrong, 1 if one is, 77 if a renderer, Pillow or NumPy is missing.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
program=${1:-$root/build/release/x11/xnewell}
shift || true
size=800x600 fine=3200x2400 views=0
if [[ ${1:-} == --size ]]; then
  size=$2 fine=$2
  shift 2
fi
if [[ ${1:-} == --views ]]; then
  views=$2
  shift 2
fi
scenes=("$@")
if [[ ${scenes[*]} == all ]]; then
  scenes=(teapot)
  for file in "$root"/data/scenes/*.json; do scenes+=("$(basename "$file" .json)"); done
fi
((${#scenes[@]})) || scenes=(cubes cycle tori pinwheels crossing-sheets penetrate nested-cycles teapot)
for needed in rsvg-convert pdftoppm pdftocairo gs mutool qpdf xmllint; do
  command -v "$needed" > /dev/null || { echo "figures.sh: $needed is missing" >&2; exit 77; }
done
python=/usr/bin/python3  # the one that has the packages of the system
"$python" -c 'import numpy, PIL' 2> /dev/null || { echo 'figures.sh: NumPy or Pillow is missing' >&2; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
names=()
# draw NAME SCENE [OPTION]...: makes the files of one view.
draw() {
  local file=$folder/$1
  names+=("$1")
  shift
  "$program" draw "$@" --shade flat --colors one --size "$size" -o "$file.png" --ids "$file.ids.png"
  "$program" draw "$@" --shade flat --colors one --size "$fine" -o "$file.fine.png" --ids "$file.fine.ids.png"
  for format in svg pdf eps; do
    "$program" figure "$@" --size "$size" --shade flat --colors one --paper '#ff00ff' -o "$file.$format" --ids "$file.ids.$format"
  done
  qpdf --check "$file.pdf" > "$file.qpdf" || { cat "$file.qpdf"; exit 1; }
  xmllint --noout "$file.svg"
}
for scene in "${scenes[@]}"; do
  ((views)) || draw "$scene" "$scene"
  for ((k = 0; k < views; ++k)); do
    towards=$(awk -v k="$k" -v n="$views" 'BEGIN { a = 6.2831853 * k / n; printf "%.3f,%.3f,%.3f", cos(a), 0.6 * sin(2.5 * k + 1), sin(a) }')
    draw "$scene-$k" "$scene" --vpn "$towards"
  done
done
"$python" "$root/tests/figures.py" "$folder" "${names[@]}"
