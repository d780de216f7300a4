#!/usr/bin/env bash
# tests/text/one_name.sh [FOLDER]: no name has two definitions in the program and its tests.
# If two files define a name, the linker silently takes one of the two, and the other file goes on with the wrong one
# (the one-definition rule, [basic.def.odr]). No compiler sees that, because no file includes both. Also, a type that
# only its own source file of the program knows stands in an anonymous namespace, so that it meets no other.
# Universal Ctags reads the sources. Exit status: 0, or 1 after a line for each such name.
set -euo pipefail
cd "${1:-"$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."}"

# KIND|NAME WITH SCOPE AND TYPES OF PARAMETERS|FILE. Left out: what other files do not see, main(), and the two
# operators that a program may replace ([replacement.functions]), and what stands before the C library. A file of tests has a namespace THIS_FILE of its own.
# The window of the room browser stands in the place of the viewer, and never beside it.
tags() {
  ctags -R --exclude=x11/browser/window.cpp --languages=C++ --langmap=C++:.h.cpp --kinds-C++=cgsufv --fields=+fS \
    --_xformat='%{file}|%K|%{scope}::%N%{signature}|%F' -x "$@" |
    sed -E '/__anon|::THIS_FILE|::main\(|operator (new|delete)|::pthread_create\(/d; /^file\|(function|variable)/d; s/^[^|]*\|//; s/-\|/|/
      s/([A-Za-z0-9_>&*]) +\**&*[A-Za-z_][A-Za-z0-9_]*([,)])/\1\2/g'
}
(($#)) && rooms=(.) || rooms=(geometry depthsort shading x11 tests)
all=$(tags "${rooms[@]}")
types=$(grep -cE '^(struct|class|enum|union)' <<<"$all")
(($# || types > 500)) || { echo "only $types types are found"; exit 1; }

{
  sort -u <<<"$all" | awk -F'|' '{ if (files[$2]++) print $2 " is defined in " first[$2] " and " $3; else first[$2] = $3 }'
  declared=$(grep -rhoE --include='*.h' '\b(class|struct|enum class) [A-Za-z0-9_]+' "${rooms[@]}" | awk '{ print $NF }' | sort -u)
  grep -E '^(struct|class|enum|union)[^|]*\|(xnewell)?::[A-Za-z0-9_]+\|.*\.cpp$' <<<"$all" | grep -v '|\(\./\)\?tests/' |
    while IFS='|' read -r _ name file; do
      grep -qxF "${name##*::}" <<<"$declared" || echo "$file: $name belongs into an anonymous namespace"
    done || true
} | { ! grep .; }
