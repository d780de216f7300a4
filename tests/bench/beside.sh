#!/usr/bin/env bash
# tests/bench/beside.sh OUTPUT_FOLDER [PROGRAM [SHADING_BENCH]] [--only ROW,ROW]
# How fast whole programs are: xnewell (PROGRAM, build/release/x11/xnewell) beside Sketch on the same scenes, beside
# Mesa's llvmpipe on the same torus, and by itself on large, dense and odd scenes. The commands of a row run in turns.
# The frames of xnewell are those of SHADING_BENCH (build/bench/tests/bench/shading_bench); without it they are left
# out. OUTPUT_FOLDER gets the table (table.md), all numbers (results.json) and, in work, the scenes and pictures.
# README.md says what each row is. It takes under ten minutes, and more on a busy machine. `--only knot,ball` measures
# these rows alone; `--only help` lists all. It ends with status 77 if a package is missing.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
missing=()
# wants PACKAGE COMMAND...: the package is missing if the command fails.
wants() {
  local package=$1
  shift
  "$@" >/dev/null 2>&1 || missing+=("$package")
}
wants python3 test -x /usr/bin/python3
wants sketch command -v sketch
wants gcc command -v gcc
wants libosmesa6-dev test -e /usr/include/GL/osmesa.h
wants libgl-dev test -e /usr/include/GL/gl.h
if ((${#missing[@]})); then
  echo "beside.sh: packages are missing: apt-get install ${missing[*]}" >&2
  exit 77
fi
export PYTHONDONTWRITEBYTECODE=1
exec /usr/bin/python3 "$here/beside.py" "$@"
