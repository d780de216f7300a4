#!/usr/bin/env bash
# manual.sh PREFIX [words]: prints what the man page in PREFIX lacks of what --help and `scenes` print, and which options
# it has beyond them; with `words`, which of their words `man` does not show. It leaves the names of the commands and of
# the built-in scenes in files of this folder, commands and built-in. Exit status: 1 if --help or `scenes` cannot be read.
set -euo pipefail
page=$1/share/man/man1/xnewell.1
help=$("$1/bin/xnewell" --help) scenes=$("$1/bin/xnewell" scenes)

# A command is `  xnewell draw SCENE`, an option `  -o,--output TEXT`, a scene `teapot  what it shows`. Lessons and
# lectures say so first.
sed -nE 's/^  xnewell \[?([a-z-]+).*/\1/p' <<<"$help" | sort -u >commands
grep -vE '^(lesson|lecture) ' <<<"$scenes" | cut -d ' ' -f 1 >built-in
options=$(sed -nE 's/^  (-.,)?(--[a-zA-Z0-9-]+) .*/\2/p' <<<"$help" | sort -u)
names=$(sed -E 's/^(lesson|lecture) //; s/ .*//' <<<"$scenes")
grep -qx draw commands
grep -qx scenes commands
grep -qx teapot built-in
grep -qx cycles <<<"$names"
grep -qx -- --output <<<"$options"
(($(wc -l <<<"$options") > 60))

# The page has `\-` for `-`. What it explains stands in bold at the begin of a line.
plain=$(sed 's/\\-/-/g' "$page")
sed -nE 's/^(\\fB-.\\fR, )?\\fB(--[a-zA-Z0-9-]+)\\fR.*/\2/p' <<<"$plain" | sort -u | diff <(echo "$options") - || true
for name in $(<commands); do grep -qE '^\\fBxnewell \[?'"$name"'\]?\\fR' <<<"$plain" || echo "no command $name"; done
for name in $names 0 1 2 130; do grep -qxF '\fB'"$name"'\fR' <<<"$plain" || echo "no scene or status $name"; done

# What --help says about an option, and `scenes` about a scene, stands there word for word, and `man` shows it as it was
# written.
[[ ${2:-} ]] || exit 0
shown=$(LC_ALL=C.UTF-8 MANWIDTH=2000 MAN_KEEP_FORMATTING='' man --warnings -l "$page" | col -bx |
  tr -d '`' | tr -s '[:space:]' ' ')
{
  sed -nE 's/^  (-.,)?--[a-zA-Z0-9-]+ +(.+)$/\2/p' <<<"$help"
  sed -nE 's/^((lesson|lecture) )?[^ ]+ +(.+)$/\3/p' <<<"$scenes"
} | tr -d '`' | tr -s ' ' | while read -r words; do [[ $shown == *"$words"* ]] || echo "no words $words"; done
