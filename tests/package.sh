#!/usr/bin/env bash
# tests/package.sh [--once] [12|13]...: checks the Debian package of the last commit in bare roots of Debian 12 and 13,
# or of the ones named. In the first copy of a root it builds the package twice, in different folders, time
# zones and languages, and compares the bytes; lintian and blhc look at it. In the second copy it installs the
# package, runs the program, purges the package and compares all files with those of before; then autopkgtest
# tries the installed program on X servers of depth 8 and 24, and builds the example with the library.
#   --once    builds it once and compares no bytes, which takes half the time
# The packages and all logs are in build/package-RELEASE. Exit status as that of tests/front_door.sh.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/bare_roots.sh"

once=''
if [[ ${1-} == --once ]]; then
  once=yes
  shift
fi
releases=("$@")
((${#releases[@]})) || releases=(12 13)
for release in "${releases[@]}"; do
  [[ ${suites[$release]-} ]] || { say "usage: tests/package.sh [--once] [12|13]..." && exit 2; }
done

# fresh_copy COPY: makes a copy of the release's bare root with fresh lists of packages.
fresh_copy() { copy_root "$release" "$1" && install_in "$1"; }

build_once() {
  local copy=$1 here=/srv/first
  git clone --quiet "$root" "$copy$here" || return
  step build inside "$copy" "$here/x11/install/package.sh" /srv/package || return
  find "$copy/srv/package" -maxdepth 1 -name '*xnewell*_*' ! -name '*-dbgsym_*' -exec cp -t "$results" {} + &&
    cp "$copy/srv/package/build.log" "$results/compiler.log"
}

build_again() {
  local copy=$1 there=/srv/second/place file
  git clone --quiet "$root" "$copy$there/xnewell" || return
  # shellcheck disable=SC2016
  step build-again inside "$copy" env TZ=Pacific/Kiritimati LC_ALL=C.UTF-8 \
    sh -c 'umask 027 && "$1/xnewell/x11/install/package.sh" "$1/package"' sh "$there" || return
  for file in "$copy"/srv/package/*.deb; do
    step same-bytes cmp "$file" "$copy$there/package/${file##*/}" || return
  done
}

# Prints each file of a root with its kind and its contents, except for what belongs to apt and dpkg.
files_of() {
  (cd "$1" && find . -xdev \( -path ./proc -o -path ./sys -o -path ./dev -o -path ./tmp -o -path ./root \
    -o -path ./var/log -o -path ./var/cache -o -path ./var/lib/apt -o -path ./var/lib/dpkg \) -prune -o \
    \( -type f -exec sha256sum {} + -o -printf '%y %p %l\n' \) | sort -k 2)
}

install_and_purge() {
  local copy=$1
  files_of "$copy" >"$results/files-before" && cp "$results"/*.deb "$copy/tmp/" || return
  step install inside "$copy" sh -c 'apt-get install -y --no-install-recommends /tmp/*.deb' || return
  # shellcheck disable=SC2016
  step run inside "$copy" sh -ec '
    cd /
    xnewell --version
    xnewell draw teapot -o /tmp/teapot.png
    xnewell draw textured-cube -o /tmp/cube.png
    xnewell lesson cycles --frames /tmp/lesson
    xnewell scenes
    for package in xnewell libxnewell-dev; do
      dpkg-query -W -f "\${Package}: \${Installed-Size} KiB installed; depends on \${Depends}\n" "$package"
    done' || return
  tail -n 2 "$results/run.log"
  step remove inside "$copy" apt-get remove -y xnewell libxnewell-dev || return
  step purge inside "$copy" sh -ec '
    dpkg --purge xnewell libxnewell-dev
    apt-get autoremove --purge -y' || return
  files_of "$copy" >"$results/files-after" || return
  step nothing-left diff "$results/files-before" "$results/files-after" || return
  [[ -z $(find "$copy" -xdev -path "$copy/tmp" -prune -o -iname '*xnewell*' -print) ]]
}

autopkgtests() {
  local copy=$1
  step autopkgtest-install inside "$copy" sh -c '
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends autopkgtest dpkg-dev' || return
  cp "$results"/*xnewell*_* "$copy/tmp/" || return
  step autopkgtest inside "$copy" sh -c '
    cd /tmp && autopkgtest --no-built-binaries *.deb xnewell_*.dsc -- null'
}

check_package() {
  local copy=$roots/debian-$release-package
  fresh_copy "$copy" || return
  build_once "$copy" || return
  # shellcheck disable=SC2016
  step lintian inside "$copy" sh -ec '
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends lintian blhc >/dev/null
    lintian --fail-on error,warning --info --display-info --allow-root /srv/package/*.changes' || return
  step blhc inside "$copy" blhc --debian --bindnow /srv/package/build.log || return
  [[ $once ]] || build_again "$copy" || return
  fresh_copy "$copy" || return
  install_and_purge "$copy" || return
  autopkgtests "$copy" || return
  remove_root "$copy"
}

one_at_a_time
status=0
for release in "${releases[@]}"; do
  results=$root/build/package-$release what="Debian $release"
  rm -rf "$results" && mkdir -p "$results"
  if ! bare_root "$release"; then
    say "package: Debian $release NOT TRIED: $why"
    ((status)) || status=77
  elif ! check_package; then
    say "package: Debian $release FAILED; the logs are in $results"
    status=1
  else
    say "package: Debian $release: all well"
  fi
done
exit "$status"
