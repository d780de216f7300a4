#!/usr/bin/env bash
# tests/compare/run.sh OUTPUT_FOLDER [PROGRAM [SCENE]...]
# Who draws a scene right: xnewell (PROGRAM, build/release/x11/xnewell) and other programs get the same polygons in
# front of the same camera, each in a colour of its own, and draw them as vectors. A judge that compares all faces
# at each pixel counts the pixels that show a wrong face. OUTPUT_FOLDER gets the tables (table.md), the pictures
# (compare-*.png), all numbers (results.json) and, in work, what each program read and wrote. README.md has the
# tables, and says how the judge works. It takes about nine minutes; six of them are for pictures that do not come.
# Exit status: 0 if the judge could be trusted, 1 if one of its checks failed, 77 if a package is missing.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
[[ $# -ge 1 ]] || { echo 'usage: tests/compare/run.sh OUTPUT_FOLDER [PROGRAM [SCENE]...]' >&2; exit 2; }
program=$(readlink -f "${2:-$here/../../build/release/x11/xnewell}")
[[ -x $program ]] || { echo "run.sh: build xnewell first, there is no $program" >&2; exit 2; }
mkdir -p "$1"
folder=$(readlink -f "$1")
python=/usr/bin/python3 # the one that has the packages of the system
missing=()
# wants PACKAGE COMMAND...: the package is missing if the command fails.
wants() {
  local package=$1
  shift
  "$@" >/dev/null 2>&1 || missing+=("$package")
}
wants python3-numpy "$python" -c 'import numpy'
wants python3-pil "$python" -c 'import PIL'
wants python3-matplotlib "$python" -c 'import mpl_toolkits.mplot3d'
wants gnuplot-nox command -v gnuplot
wants asymptote command -v asy
wants sketch command -v sketch
wants gcc command -v gcc
wants libgl2ps-dev test -e /usr/include/gl2ps.h
wants libosmesa6-dev test -e /usr/include/GL/osmesa.h
wants librsvg2-bin command -v rsvg-convert
wants ghostscript command -v gs
if ((${#missing[@]})); then
  echo "run.sh: packages are missing: apt-get install ${missing[*]}" >&2
  exit 77
fi
gcc -O1 "$here/draw_gl2ps.c" -o "$folder/draw_gl2ps" -lgl2ps -lOSMesa -lGL
export PYTHONDONTWRITEBYTECODE=1
status=0
"$python" "$here/compare.py" "$folder" "$program" "${@:3}" || status=1
"$python" "$here/page.py" "$folder"
cat "$folder/table.md"
exit "$status"
