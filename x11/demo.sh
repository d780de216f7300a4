#!/usr/bin/env bash
# x11/demo.sh [--pseudocolor] [SCENE] [options]: shows the teapot, or SCENE, in a window. It first installs
# missing packages and builds. The options are those of `xnewell view`.
# With --pseudocolor the window is on an 8-bit PseudoColor server of its own (Xephyr), inside your desktop.
# Without a display, it starts an 8-bit PseudoColor server (Xvfb) for a moment and saves the window, as that
# server shows it, to build/demo.png.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

nested=''
if [[ ${1:-} == --pseudocolor ]]; then
  nested=yes
  shift
  [[ -n ${DISPLAY:-} ]] || { say "--pseudocolor opens a server inside a desktop, and DISPLAY is not set"; exit 2; }
fi
scene=teapot
if (($#)) && [[ $1 != -* ]]; then
  scene=$1
  shift
fi

packages=("${program_packages[@]}")
[[ -n ${DISPLAY:-} ]] || packages+=(xvfb)
[[ ! $nested ]] || packages+=(xserver-xephyr)
need "${packages[@]}"
build release -DXNEWELL_TESTS=OFF -- xnewell
xnewell=$root/build/release/x11/xnewell

if [[ -n ${DISPLAY:-} && ! $nested ]]; then
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

# start_server COMMAND...: starts an X server and sets `number` to that of its display.
start_server() {
  local log=$root/build/$1.log
  exec {ready}< <(exec "$@" 2>"$log")
  server=$!
  if ! read -r -t 60 -u "$ready" number; then
    cat "$log" >&2
    say "$1 did not start"
    exit 1
  fi
}

if [[ $nested ]]; then
  start_server Xephyr -displayfd 1 -screen 1280x1024x8 -nolisten tcp -title "xnewell: 8-bit PseudoColor"
  say "on an 8-bit Xephyr server, :$number; Ctrl+Shift gives it the keyboard and takes it back"
  DISPLAY=:$number "$xnewell" view "$scene" "$@" &
else
  start_server Xvfb -displayfd 1 -screen 0 1280x1024x8 -nolisten tcp
  say "no display: using an 8-bit Xvfb server, :$number"
  picture=$root/build/demo.png
  rm -f "$picture"
  DISPLAY=:$number "$xnewell" snapshot "$scene" --whole-window -o "$picture" "$@" &
fi
program=$!
status=0
wait "$program" || status=$?
program=''
if ((status == 0)) && [[ ! $nested && -f $picture ]]; then  # `--help` makes no picture
  echo "the window: $picture"
fi
exit "$status"
