#!/usr/bin/env bash
# tests/extremes.sh [FOLDER]: drives every built-in scene to its extremes (`xnewell extremes`) and writes the
# report into FOLDER (build/extremes): a table and a chart for each scene, and summary.md with one row a scene.
# It takes about a minute a scene.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../x11/setup.sh"

need "${program_packages[@]}"
build release
folder=${1:-$root/build/extremes}
mkdir -p "$folder"
xnewell=$root/build/release/x11/xnewell
for scene in $("$xnewell" scenes | awk '$1 != "lesson" {print $1}'); do
  echo "$scene"
  "$xnewell" extremes "$scene" -o "$folder/$scene.png" >"$folder/$scene.txt"
done
# The least value at which any scene is wrong, for each way.
awk '
  FNR == 1 { next }
  /^[^ ]/ {
    way = substr($0, 1, 32); sub(/ +$/, "", way)
    finding = substr($0, 53)
    if (!(way in total)) order[++ways] = way
    ++total[way]
    if (finding ~ /^right/) ++right[way]
    else { split(finding, word, " "); list[way] = list[way] " " word[2] }
  }
  END {
    print "| way | scenes right to the end | first wrong at |"
    print "| --- | --- | --- |"
    for (k = 1; k <= ways; ++k) {
      way = order[k]
      n = split(list[way], v, " "); least = ""; most = ""
      for (i = 1; i <= n; ++i) { value = v[i]; sub(/:$/, "", value)
        if (least == "" || value + 0 < least + 0) least = value
        if (most == "" || value + 0 > most + 0) most = value }
      at = n == 0 ? "-" : least == most ? least : least " to " most
      printf "| %s | %d of %d | %s |\n", way, right[way], total[way], at
    }
  }' "$folder"/*.txt >"$folder/summary.md"
cat "$folder/summary.md"
