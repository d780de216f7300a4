# shellcheck shell=bash
# Other scripts source this file. It makes bare roots: folders with the smallest Debian and git, kept in
# ~/.cache/xnewell. Needs root, debootstrap and a package server.
#   bare_root RELEASE         makes the root of Debian 12 or 13, unless it exists; or `why` gets the reason
#   inside ROOT COMMAND...    runs a command in a root
#   copy_root RELEASE COPY    makes a copy of the root
#   install_in COPY PACKAGE...    reads the lists of packages and installs these; the log is in $results
#   step NAME COMMAND...      runs the command with its output in $results/NAME.log; $what says what it is about
#   remove_root ROOT          removes a copy
#   one_at_a_time             waits until no other script uses the roots
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../x11/setup.sh"

roots=${XDG_CACHE_HOME:-$HOME/.cache}/xnewell
declare -A suites=([12]=bookworm [13]=trixie)

# Runs a command with its own mounts and processes, which end with it. So nothing outside is ever mounted into
# a root, and removing a root cannot reach anything mounted there.
apart() { unshare --mount --pid --fork --kill-child --propagation private "$@"; }

# inside ROOT COMMAND...: runs the command as root in that root, in a fresh environment without a display.
inside() {
  # shellcheck disable=SC2016  # $1 belongs to the inner shell
  apart sh -c '
    mount -t proc proc "$1/proc" &&
      mount -t devpts -o newinstance,ptmxmode=0666,mode=620 devpts "$1/dev/pts" &&
      mount -t tmpfs tmpfs "$1/dev/shm" &&
      exec chroot "$@"' inside "$1" env -i HOME=/root TERM=dumb \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${@:2}"
}

# Removes a folder, unless something is mounted in it. mountinfo writes a space as \040.
remove_root() {
  if grep -qF " ${1// /\\040}/" /proc/self/mountinfo; then
    say "something is mounted in $1, so it is not removed"
    return 1
  fi
  rm -rf --one-file-system "$1"
}

# Prints the package server of this machine that has the suite: the first one in its apt sources.
package_server() {
  local uri
  # shellcheck disable=SC2016  # REPO_URI is apt's own variable
  while read -r uri; do
    if /usr/lib/apt/apt-helper download-file "${uri%/}/dists/$1/Release" "$roots/Release" >/dev/null 2>&1; then
      rm "$roots/Release"
      echo "$uri"
      return
    fi
  done < <(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Component: main' | awk '!seen[$0]++')
  return 1
}

# Copies what this machine needs to reach the package server: names, proxies, certificates.
copy_apt_settings() {
  local file
  apt-config dump | grep -E '^Acquire::(https?|Check-|ForceIP|Retries)' >"$1/etc/apt/apt.conf.d/00machine" || true
  for file in /etc/resolv.conf /etc/hosts /etc/apt/auth.conf /etc/apt/auth.conf.d \
    /etc/ssl/certs/ca-certificates.crt; do
    if [[ -e $file ]]; then
      mkdir -p "$1$(dirname "$file")"
      cp -rL "$file" "$1$(dirname "$file")/"
    fi
  done
}

# bare_root RELEASE: makes the root, unless it exists. If that is impossible, `why` gets the reason.
bare_root() {
  local suite=${suites[$1]} bare=$roots/debian-$1 server refused
  if ((EUID)); then
    why="only root can make a root folder"
  elif ! refused=$(apart true 2>&1); then
    why="this machine does not allow private mounts (${refused:-unshare failed})"
  elif ! server=$(package_server "$suite"); then
    why="no package server in this machine's apt sources has $suite"
  elif [[ -d $bare ]]; then
    return 0
  elif ! need debootstrap debian-archive-keyring; then
    why="debootstrap is missing"
  elif remove_root "$bare.new" && logged "$root/build/bare-$1.log" "making a bare root of Debian $1" \
    apart debootstrap --variant=minbase --include=git "$suite" "$bare.new" "$server"; then
    mv "$bare.new" "$bare"
    return 0
  else
    why="debootstrap failed"
  fi
  return 1
}

copy_root() {
  remove_root "$2" && cp -a --reflink=auto "$roots/debian-$1" "$2" && copy_apt_settings "$2" || return
  # dpkg need not wait for the disk in a folder that is thrown away.
  mkdir -p "$2/etc/dpkg/dpkg.cfg.d" && echo force-unsafe-io >"$2/etc/dpkg/dpkg.cfg.d/unsafe-io"
}

# shellcheck disable=SC2154  # the script that sources this sets `results` and `what`
install_in() {
  # shellcheck disable=SC2016  # $@ belongs to the inner shell
  logged "$results/prepare.log" "$what: preparing a bare root" inside "$1" sh -c '
    export DEBIAN_FRONTEND=noninteractive
    apt-get update && { [ $# = 0 ] || apt-get install -y --no-install-recommends "$@"; }' sh "${@:2}"
}

step() { logged "$results/$1.log" "$what: $1" "${@:2}"; }

one_at_a_time() {
  mkdir -p "$roots" "$root/build"
  exec {lock}>"$roots/lock"
  flock --nonblock "$lock" || { say "waiting for another run with bare roots" && flock "$lock"; }
  [[ -z $(git -C "$root" status --porcelain) ]] || say "changes that are not committed are not tested"
}
