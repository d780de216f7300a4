#!/usr/bin/env bash
# tests/planted/run.sh [--check] [TEXT]: plants each mistake of mistakes.txt whose line contains TEXT, by itself, and
# expects that its test fails. --check only looks whether each old text stands in its file exactly once. It works in a
# copy of the tree, build/planted. Exit status: 0, or 1 if a mistake was not found or could not be planted.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd -P)
copy=$root/build/planted rows=() lost=0 planted='' check=''
[[ ${1:-} != --check ]] || { check=yes && shift; }
# Reads a row into file, old, new, program, filter and what, and the file into text.
take() {
  IFS=$'\x1f' read -r file old new test what <<<"${1// ### /$'\x1f'}"
  read -r program filter <<<"$test"
  text=$(cat "$root/$file" 2>/dev/null || true)
}
restore() { [[ ! $planted ]] || cp "$root/$planted" "$copy/$planted"; planted=''; }
sources() { (cd "$1" && find . \( -path ./build -o -path ./.git \) -prune -o -type f -print0); }
# Writes only what differs, so that only this is compiled again.
renew() {
  mkdir -p "$copy"
  while IFS= read -r -d '' file; do [[ -f $root/$file ]] || rm "$copy/$file"; done < <(sources "$copy")
  while IFS= read -r -d '' file; do
    cmp -s "$root/$file" "$copy/$file" || { mkdir -p "$copy/${file%/*}" && cp "$root/$file" "$copy/$file"; }
  done < <(sources "$root")
}
build() { (cd "$copy" && cmake --build --preset release --target "$1") >"$copy/build/log" 2>&1 </dev/null; }
passes() { (cd "$copy/build" && timeout 600 "release/tests/$1" --gtest_filter="$2") >"$copy/build/log" 2>&1 </dev/null; }
fail() { printf '%s\n' "$1" && lost=$((lost + 1)); }

while IFS= read -r row; do
  [[ $row == *' ### '* && $row != '#'* && $row == *"${1:-}"* ]] || continue
  take "$row"
  if [[ $old && $text == *"$old"* && ${text#*"$old"} != *"$old"* && $what ]]; then
    rows+=("$row")
  else
    fail "cannot be planted: $file: $old"
  fi
done <"$root/tests/planted/mistakes.txt"
[[ ! $check ]] || { echo "${#rows[@]} mistakes can be planted, $lost cannot" && exit $((lost > 0)); }

trap restore EXIT && trap 'exit 130' INT TERM
renew
command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
(cd "$copy" && cmake --preset release -DXNEWELL_TESTS=ON >/dev/null)
declare -A filters=()
for row in "${rows[@]}"; do take "$row" && [[ $program == none ]] || filters[$program]+=$filter:; done
for program in "${!filters[@]}"; do  # without a mistake
  { build "$program" && passes "$program" "${filters[$program]}"; } || { cat "$copy/build/log" && exit 1; }
done
for row in "${rows[@]}"; do
  take "$row"
  [[ $program != none ]] || { fail "no test:   $file: $what" && continue; }
  planted=$file
  printf '%s\n' "${text%%"$old"*}$new${text#*"$old"}" >"$copy/$file"
  if ! build "$program"; then fail "no build:  $file: $what"
  elif passes "$program" "$filter"; then fail "NOT FOUND: $file: $what ($filter)"
  else echo "found:     $file: $what ($filter)"; fi
  restore
done
echo "${#rows[@]} mistakes, $lost not found"
exit $((lost > 0))
