#!/usr/bin/env bash
# tests/same_files.sh A B [all|quick]: whether two programs `xnewell` write the same. It draws every scene of data/
# with each pair of method, order and table (`quick`: with each of them once), and with the options below about the
# light, the camera and the cells. It traces every scene, explains pixels, drives scenes to their extremes, and writes
# all lessons. Files, outputs, messages and exit statuses are compared, all but the milliseconds of --stats. It
# prints each command that does not give the same, and ends with status 1 if there is one. A program finds its data in
# ../../../data, seen from its folder, or in ../share/xnewell. `all` takes about ten minutes.
set -uo pipefail
[[ $# -ge 2 && -x $1 && -x $2 ]] || { echo "usage: tests/same_files.sh A B [all|quick]: two programs" >&2; exit 2; }
A=$(readlink -f "$1") B=$(readlink -f "$2") much=${3:-all}
unset DISPLAY
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/A" "$folder/B"
runs=0 others=0

# Runs both programs in folders of their own, with the same arguments, and compares all that they leave there.
same() {
  local side program
  for side in A B; do
    program=${!side}
    find "$folder/$side" -mindepth 1 -delete
    (cd "$folder/$side" && "$program" "$@" >out.raw 2>err; echo "$?" >status
      sed -E 's/"ms":\{[^}]*\}//; s/: [0-9.]+ ms//' out.raw >out; rm out.raw)
  done
  ((++runs))
  diff -rq "$folder/A" "$folder/B" >"$folder/differ" && return
  ((++others))
  echo "not the same: xnewell $*"
  sed -E "s|$folder/||g; s/^/    /" "$folder/differ"
}

methods="none depth flat gouraud phong envmap"
orders="none zmean zsort newell bsp zbuffer16 zbuffer24 zbuffer32 oracle"
tables="brief linear corrected"
# Each row is drawn with every scene.
options=(
  "--light-at=2,3,4" "--light-at=-1,5,2 --attenuation inverse" "--light-at=-1,5,2 --attenuation inverse-square"
  "--light-at=-1,5,2 --attenuation linear" "--light-at=-1,5,2 --attenuation linear --range 9"
  "--light-at=-1,5,2 --attenuation textbook" "--light-at=-1,5,2 --attenuation textbook --coefficients 0.5,0.1,0.02"
  "--attenuation inverse" "--attenuation linear --range 7" "--attenuation textbook --coefficients 1,0.2,0.01"
  "--attenuation none" "--light=1,0,1 --ip 0.8 --ia 0.1" "--light-at=1e300,0,0" "--light-at=2,3,4 --constant-l"
  "--eye=3,4,9" "--eye=3,4,9 --look-at=0.1,0.2,0.3 --up=0.1,1,0.2 --fov 50" "--eye=1e200,3,9" "--eye=1e-200,3,9"
  "--parallel 5" "--parallel 5 --oblique cabinet:30 --look-at=0,1,0" "--vrp=0,1,0 --vpn=1,2,3 --vup=0,1,0"
  "--vrp=0,1,0 --vpn=1,2,3 --prp=0.1,0.2,9 --view-window=-1,1,-1,1" "--front=1 --back=-1" "--eye=3,4,9 --front=0.5"
  "--parallel 6 --front=0.5 --back=-2 --cull back" "--constant-v" "--form half-vector" "--form tutorial" "--sided one"
  "--adapt 0.02" "--shade gouraud --adapt 0.02 --light-at=2,3,4" "--shade gouraud --polygons rows"
  "--shade gouraud --interpolate cell" "--unnormalized" "--normals area --shade gouraud"
  "--crease 30 --shade gouraud" "--environment published --shade envmap --eye=3,4,9" "--mapping affine"
  "--colors one" "--colors hues --shade gouraud" "--colors cube" "--colors cube --dither" "--colors chosen"
  "--colors chosen --dither --shade gouraud --light-at=2,3,4" "--ka 0.5 --kd 0.5 --ks 0.5 --n 5"
  "--shades 12 --hue 0,1,0.5 --bits 8" "--table corrected --i0 0.1 --pick search" "--ids faces.png" "--divisions 3"
  "--keep ka,n --ka 0.1 --n 3 --kd 0.2" "--texel multiplies" "--size 70x150" "--max-fragments 2")

for scene in $("$A" scenes | awk '$1 != "lesson" {print $1}'); do
  draw=(draw "$scene" --size 120x90 -o picture.png --stats)
  if [[ $much == all ]]; then
    for method in $methods; do for order in $orders; do for table in $tables; do
      same "${draw[@]}" --shade "$method" --order "$order" --table "$table"
    done; done; done
  else
    for method in $methods; do same "${draw[@]}" --shade "$method"; done
    for order in $orders; do same "${draw[@]}" --order "$order"; done
    for table in $tables; do same "${draw[@]}" --shade phong --table "$table"; done
  fi
  for row in "${options[@]}"; do
    read -ra given <<<"$row"
    [[ $row == *--shade* ]] || given+=(--shade phong)
    same "${draw[@]}" "${given[@]}"
  done
  for method in flat gouraud phong; do
    same draw "$scene" --size 64x48 --shade "$method" --errors -o picture.png
    same draw "$scene" --size 64x48 --shade "$method" --errors -o picture.png --front=0.5 --back=-2 --light-at=2,3,4 \
      --attenuation textbook --coefficients 0.5,0.1,0.02
    same explain "$scene" 31,25 --size 64x48 --shade "$method" --light-at=2,3,4
    same explain "$scene" 29,20 --size 64x48 --shade "$method" --json
  done
  same trace "$scene" --size 64x48 --quick
  same trace "$scene" --size 64x48 --quick --eye=3,4,9
  [[ $much == all ]] && same extremes "$scene" --size 32x24 --json
done
# Few faces, for the textbook's run; lights and coefficients of the settings, for the extremes.
for scene in cycle five-tests two-cards penetrate; do same trace "$scene" --size 64x48; done
for scene in cubes tori; do
  same extremes "$scene" --size 32x24 --json --light-at=2,3,4 --attenuation linear --range 9
  same extremes "$scene" --size 32x24 --json --eye=3,4,9 --shade gouraud
  same extremes "$scene" --size 32x24 --json --parallel 6 --front=2 --back=-2
done
for lesson in $("$A" scenes | awk '$1 == "lesson" {print $2}'); do
  same lesson "$lesson" --frames frames
  same lesson "$lesson" --worksheet sheet.html
done
echo "$runs commands, $others not the same"
[[ $others == 0 ]]
