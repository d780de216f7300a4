#!/usr/bin/env bash
# tests/text/plain.sh [FOLDER]: what the sources and documents have no use for. Exit status: 0, or 1 after a line for
# each such place.
set -euo pipefail
cd "${1:-"$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."}"

# Keys and controls belong to the kit. Elsewhere no code tells keys apart, tests a list of them, or draws the parts of a
# control: views give the kit rows. Two files have another meaning for such words: the letter of a typed text, and a
# speed that has words beside its track.
shopt -s nullglob
views=(x11/{window,views,sides,trade,stepper,lessons,app}/*.{cpp,h})
((${#views[@]} > 80)) || { echo "only ${#views[@]} files of views are found"; exit 1; }
keys() {
  grep -nE "case '[^']+':"'|"[^" ]{4,}"\}?\.find(_first_of)?\(|\.find(_first_of)?\((key|letter)\b' "${views[@]}"
  grep -nE '\b(drawOptions|optionFrames|drawToggle|drawNumber)\(' "${views[@]}"
  grep -nE '\b(key|event)\.letter\b' "${views[@]}" | grep -v '^x11/app/workbench_keys.cpp:'
  grep -nE '\bdrawTrack\(' "${views[@]}" | grep -v '^x11/stepper/sort_controls.cpp:'
}

# Only the server's room and the event loop, one file of the app, include Xlib, and the student's program, which is none
# of ours. So its macros (None, Bool, Status) reach no file of another room.
xlib() {
  local including
  including=$(grep -rl --include='*.cpp' --include='*.h' '^#include <X11/' geometry depthsort shading x11)
  grep -q '^x11/server/' <<<"$including" || echo "no file of x11/server includes Xlib"
  grep -vE '^x11/(server|app|example)/' <<<"$including"
  (($(grep -c '^x11/app/' <<<"$including") == 1)) || grep '^x11/app/' <<<"$including" || echo "the event loop does not"
}

# What people read is plain: the documents, and the words of scenes and lessons. These are turns of phrase that nobody
# says to a class. Instead, name the thing again; say who has it, or who says it to whom; begin a new sentence, or begin
# with what goes; write `so` and `to`.
phrases='(is that of|are those of|is told|are told|the one that|by it go|thereby|in order to|so as to)'
words() {
  local file documents=0
  while read -r file; do
    documents=$((documents + 1))
    tr -s '[:space:]' ' ' <"$file" | grep -oE ".{0,40}(\b$phrases\b|, of which\b).{0,40}" | sed "s|^|$file: |"
  done < <(find . \( -name build -o -name '.?*' \) -prune -o -name '*.md' -print -o -path './data/*.json' -print)
  ((documents > 40)) || echo "only $documents documents are found"
}

# The README is short enough to be read.
short() { (($(wc -l <README.md) <= 150)) || echo "README.md has more than 150 lines"; }

{ keys || true; xlib || true; words || true; short; } | { ! grep .; }
