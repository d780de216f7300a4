#!/usr/bin/env bash
# x11/browser/build.sh: makes build/browser/xnewell.html, the window for browsers in one file that opens from a disk,
# and xnewell.js with xnewell.wasm, the commands for Node. Emscripten, zlib and libpng are those of Debian 13, in a copy
# of a bare root (tests/bare_roots.sh) that stays for the next time, in ~/.cache/xnewell/browser. What is not committed
# counts, too.
# Exit status: 77 if the root cannot be made here.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../tests/bare_roots.sh"

copy=$roots/browser results=$root/build/browser what='the page'
mkdir -p "$roots" "$results"

prepare() {
  copy_root 13 "$copy" && install_in "$copy" emscripten cmake ninja-build g++ zopfli libfreetype-dev xfonts-base \
    libglm-dev libboost-dev nlohmann-json3-dev libcli11-dev libfast-float-dev || return
  # shellcheck disable=SC2016
  step libraries inside "$copy" sh -ec '
    sed "s/^deb /deb-src /" /etc/apt/sources.list >/etc/apt/sources.list.d/sources.list
    mkdir -p /srv/libraries/include && cd /srv/libraries && apt-get update
    apt-get source --download-only --tar-only zlib libpng1.6
    for archive in *.orig.tar.*; do tar xf "$archive"; done
    mv zlib-* zlib && mv libpng-* libpng
    cp libpng/scripts/pnglibconf.h.prebuilt libpng/pnglibconf.h
    for headers in glm boost nlohmann CLI fast_float; do ln -s "/usr/include/$headers" include; done'
}
if [[ ! -x $copy/usr/bin/zopfli || ! -L $copy/srv/libraries/include/fast_float ]]; then
  bare_root 13 || { say "the page NOT MADE: $why"; exit 77; }
  prepare
fi

mkdir -p "$copy/srv/xnewell"
(cd "$root" && git ls-files -z --cached --others --exclude-standard | tar c --null --ignore-failed-read -T -) |
  tar x -C "$copy/srv/xnewell"
# shellcheck disable=SC2016
step build inside "$copy" env "CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" sh -ec '
  cd /srv/xnewell
  g++ -std=c++20 -I. -I/usr/include/freetype2 shading/color/make_font.cpp -lfreetype -o /srv/make_font
  /srv/make_font /usr/share/fonts/X11/misc/6x13.pcf.gz /srv/font.cpp
  cmp -s /srv/font.cpp /srv/libraries/font.cpp || cp /srv/font.cpp /srv/libraries
  emcmake cmake --preset release -DCMAKE_INSTALL_PREFIX=/usr -DXNEWELL_LIBRARIES=/srv/libraries \
    -DXNEWELL_FONT_TABLE=/srv/libraries/font.cpp
  cmake --build --preset release --target xnewell'
cp "$copy"/srv/xnewell/build/release/x11/xnewell.{js,wasm} "$results"
page=$root/x11/browser/page.html
{
  sed '/^PROGRAM$/,$d' "$page"
  printf '<script type="text/plain" id="program">'
  inside "$copy" zopfli --i5 -c /srv/xnewell/build/release/x11/xnewell.wasm | base64 -w 0
  printf '</script>\n'
  printf '<script type="text/plain" id="js">' && cat "$results/xnewell.js" && printf '</script>\n'
  sed '1,/^PROGRAM$/d' "$page"
} >"$results/xnewell.html"
say "build/browser/xnewell.html: $(stat -c %s "$results/xnewell.html") bytes, $(gzip -9c "$results/xnewell.html" | wc -c) packed"
