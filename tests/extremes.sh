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
# values it becomes wrong or doubtful at the others. Rows that begin with a space go on with the finding of the row
# above, or after two more spaces explain it.
awk '
  # The value at which the finding becomes `verdict`; "" if it does not.
  function first(verdict,   word) {
    if (!match(finding, verdict " (from|at) [^ :;]+")) return ""
    split(substr(finding, RSTART, RLENGTH), word, " ")
    return word[3]
  }
  function finish() {
    if (way == "") return
    if (finding ~ /^(right|shows no face)/) ++right[way]
    if (finding ~ /wrong as the set-up/) ++asSetUp[way]
    wrong[way] = wrong[way] " " first("wrong")
    doubtful[way] = doubtful[way] " " first("doubtful")
    way = ""
  }
  function range(values,   n, v, i, least, most) {
    n = split(values, v, " ")
    if (n == 0) return "-"
    least = most = v[1]
    for (i = 2; i <= n; ++i) {
      if (v[i] + 0 < least + 0) least = v[i]
      if (v[i] + 0 > most + 0) most = v[i]
    }
    return least == most ? least : least " to " most
  }
  FNR == 1 { finish(); in_table = 0; name = FILENAME; sub(/.*\//, "", name); sub(/\.txt$/, "", name) }
  /^The set-up itself/ { setups = setups "- `" name "`: " $0 "\n" }
  /^way / { in_table = 1; next }
  !in_table { next }
  /^[^ ]/ {
    finish()
    way = substr($0, 1, 32); sub(/ +$/, "", way)
    finding = substr($0, 53)
    if (!(way in total)) order[++ways] = way
    ++total[way]
    next
  }
  substr($0, 53) !~ /^  / { finding = finding " " substr($0, 53) }
  END {
    finish()
    print "| way | right in all pictures | wrong as the set-up | the others are wrong from | or doubtful from |"
    print "| --- | --- | --- | --- | --- |"
    for (k = 1; k <= ways; ++k) {
      w = order[k]
      printf "| %s | %d of %d | %d | %s | %s |\n", w, right[w], total[w], asSetUp[w], range(wrong[w]), range(doubtful[w])
    }
    if (setups != "") printf "\n%s", setups
  }' "$folder"/*.txt >"$folder/summary.md"
cat "$folder/summary.md"
