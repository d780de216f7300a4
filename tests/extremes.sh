#!/usr/bin/env bash
# tests/extremes.sh [FOLDER [SIZE]]: drives every built-in scene to its extremes (`xnewell extremes`) and writes
# the report into FOLDER (build/extremes): a table and a chart for each scene, and summary.md with one row for
# each way. Pictures have the SIZE (160x120). It takes about ten minutes.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../x11/setup.sh"

need "${program_packages[@]}"
build release
folder=${1:-$root/build/extremes} size=${2:-160x120}
mkdir -p "$folder"
xnewell=$root/build/release/x11/xnewell
for scene in $("$xnewell" scenes | awk '$1 != "lesson" {print $1}'); do
  echo "$scene"
  "$xnewell" extremes "$scene" --size "$size" -o "$folder/$scene.png" >"$folder/$scene.txt"
done
# For each way: at how many scenes it is right to its end, or as wrong as the set-up all the way, and between which
# values it becomes wrong at the others. Rows that begin with a space go on with the finding of the row above.
awk '
  FNR == 1 { in_table = 0; name = FILENAME; sub(/.*\//, "", name); sub(/\.txt$/, "", name) }
  /^The set-up itself/ { setups = setups "- `" name "`: " $0 "\n" }
  /^way / { in_table = 1; next }
  !in_table { next }
  /^[^ ]/ {
    way = substr($0, 1, 32); sub(/ +$/, "", way)
    finding = substr($0, 53)
    if (!(way in total)) order[++ways] = way
    ++total[way]
    if (finding ~ /^(right|shows no face)/) ++right[way]
    else if (finding ~ /^wrong as the set-up/) ++asSetUp[way]
    else { split(finding, word, " "); list[way] = list[way] " " word[3] }
  }
  END {
    print "| way | right in all pictures | wrong as the set-up | the others are wrong from |"
    print "| --- | --- | --- | --- |"
    for (k = 1; k <= ways; ++k) {
      way = order[k]
      n = split(list[way], v, " "); least = ""; most = ""
      for (i = 1; i <= n; ++i) { value = v[i]; sub(/:$/, "", value)
        if (least == "" || value + 0 < least + 0) least = value
        if (most == "" || value + 0 > most + 0) most = value }
      at = n == 0 ? "-" : least == most ? least : least " to " most
      printf "| %s | %d of %d | %d | %s |\n", way, right[way], total[way], asSetUp[way], at
    }
    if (setups != "") printf "\n%s", setups
  }' "$folder"/*.txt >"$folder/summary.md"
cat "$folder/summary.md"
