#!/usr/bin/env bash
# x11/demo.sh [SCENE] [options]: shows the teapot, or SCENE, in a window. It first installs missing packages
# and builds. The options are those of `xnewell view`.
# Without a display, it starts an 8-bit PseudoColor server (Xvfb) for a moment and saves the window, as that
# server shows it, to build/demo.png.
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

# Both run in the background, so that Ctrl-C or kill ends this script at once, and them with it.
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
say "no display: using an 8-bit Xvfb server, :$number"

picture=$root/build/demo.png
rm -f "$picture"
DISPLAY=:$number "$xnewell" snapshot "$scene" --whole-window -o "$picture" "$@" &
program=$!
status=0
wait "$program" || status=$?
program=''
if ((status == 0)) && [[ -f $picture ]]; then  # `--help` makes no picture
  echo "the window: $picture"
fi
exit "$status"
