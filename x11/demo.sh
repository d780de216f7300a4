#!/usr/bin/env bash
# x11/demo.sh [SCENE] [options]: the teapot, or SCENE, in a window. Installs the packages that are
# missing and builds first. The options are those of `xnewell view`.
# Without a display, an 8-bit PseudoColor server (Xvfb) is started for a moment, and the window, as that
# server shows it, is saved as build/demo.png.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

scene=teapot
if (($#)) && [[ $1 != -* ]]; then
  scene=$1
  shift
fi

packages=("${program_packages[@]}")
[[ -n ${DISPLAY:-} ]] || packages+=(xvfb)
need "${packages[@]}"
build release -DXNEWELL_TESTS=OFF -- xnewell
xnewell=$root/build/release/x11/xnewell

if [[ -n ${DISPLAY:-} ]]; then
  exec "$xnewell" view "$scene" "$@"
fi

# Both run beside this script, so that Ctrl-C or kill is answered at once, and takes them along.
server='' program=''
finish() {
  trap '' INT TERM HUP
  local child
  for child in $program $server; do
    kill "$child" 2>/dev/null || true
    wait "$child" || true
  done
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
trap 'exit 129' HUP

log=$root/build/xvfb.log
exec {ready}< <(exec Xvfb -displayfd 1 -screen 0 1280x1024x8 -nolisten tcp 2>"$log")
server=$!
if ! read -r -t 60 -u "$ready" number; then
  cat "$log" >&2
  say "Xvfb did not start"
  exit 1
fi
say "no display: an 8-bit Xvfb stands in, :$number"

picture=$root/build/demo.png
rm -f "$picture"
DISPLAY=:$number "$xnewell" snapshot "$scene" --whole-window -o "$picture" "$@" &
program=$!
status=0
wait "$program" || status=$?
program=''
if ((status == 0)) && [[ -f $picture ]]; then  # `--help` makes none
  echo "the window: $picture"
fi
exit "$status"
