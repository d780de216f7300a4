#!/usr/bin/env bash
# tests/front_door.sh [--tests] [--sudo] [--with "PACKAGE..."] [12|13]...
# Checks that the README's first command works on a bare machine. It makes a root folder of Debian 12 and one
# of Debian 13, or of the ones named, with debootstrap's smallest variant and git. In a copy of each it clones
# the last commit and runs the command.
#   --tests             runs the README's second command, too
#   --sudo              runs them as a user with sudo, not as root
#   --with "PACKAGE..." installs these packages first
# The bare roots are kept in ~/.cache/xnewell. The copies are removed, except after a failure.
# Exit status: 0 if all commands succeeded, 1 if one failed, 77 if nothing failed but a root could not be made
# here.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../x11/setup.sh"

roots=${XDG_CACHE_HOME:-$HOME/.cache}/xnewell
declare -A suites=([12]=bookworm [13]=trixie)
with_tests='' user=root preinstalled='' releases=()
usage() {
  say 'usage: tests/front_door.sh [--tests] [--sudo] [--with "PACKAGE..."] [12|13]...'
  exit 2
}
while (($#)); do
  case $1 in
    --tests) with_tests=yes ;;
    --sudo) user=student ;;
    --with)
      [[ ${2:-} ]] || usage
      preinstalled=$2 && shift
      ;;
    12 | 13) releases+=("$1") ;;
    *) usage ;;
  esac
  shift
done
((${#releases[@]})) || releases=(12 13)

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
  elif remove_root "$bare.new" && logged "$root/build/front-door-$1-bare.log" "making a bare root of Debian $1" \
    apart debootstrap --variant=minbase --include=git "$suite" "$bare.new" "$server"; then
    mv "$bare.new" "$bare"
    return 0
  else
    why="debootstrap failed"
  fi
  return 1
}

# The README's two commands are the first two lines of its first block.
mapfile -t commands < <(sed -n '/^```sh$/,/^```$/p' "$root/README.md" | sed -n 's/^\([^`# ]\+\) *#.*/\1/p' | head -2)
((${#commands[@]} == 2)) || { say "README.md: its first block should have two commands"; exit 1; }
[[ $with_tests ]] || unset 'commands[1]'

# Indents what a command prints. Of ctest it keeps only the failures and the end.
indented() { sed -uE '/(Start +[0-9]+:| Passed +[0-9.]+ sec)/d; s/^/    /' >&2; }

# prepare RELEASE COPY HOME: makes a copy of the bare root, with the user, the packages asked for and a clone.
prepare() {
  local copy=$2 home=$3 with=$preinstalled
  [[ $user == root ]] || with=${with:+$with }sudo
  remove_root "$copy" && cp -a --reflink=auto "$roots/debian-$1" "$copy" && copy_apt_settings "$copy" || return
  if [[ $with ]]; then
    # shellcheck disable=SC2086  # names of packages
    logged "$root/build/front-door-$1-with.log" "installing beforehand: $with" inside "$copy" sh -c '
      export DEBIAN_FRONTEND=noninteractive
      apt-get update && apt-get install -y --no-install-recommends "$@"' sh $with || return
  fi
  if [[ $user != root ]]; then
    inside "$copy" useradd --create-home --shell /bin/bash "$user" &&
      echo "$user ALL=(ALL) NOPASSWD: ALL" >"$copy/etc/sudoers.d/$user" || return
  fi
  git clone --quiet "$root" "$copy$home/xnewell" && inside "$copy" chown -R "$user:" "$home/xnewell"
}

# front_door RELEASE: succeeds if the commands succeed in that release.
front_door() {
  local copy=$roots/debian-$1-copy home=/root run=(bash -c) log=$root/build/front-door-$1.log command start
  [[ $user == root ]] || home=/home/$user run=(su --login "$user" --command)
  if ! prepare "$1" "$copy" "$home"; then
    say "Debian $1: the copy of the bare root could not be prepared"
    return 1
  fi
  : >"$log"
  for command in "${commands[@]}"; do
    say "Debian $1, as $user: $command"
    start=$SECONDS
    if ! inside "$copy" "${run[@]}" "cd $home/xnewell && $command" </dev/null 2>&1 | tee -a "$log" | indented; then
      say "Debian $1, as $user: $command FAILED after $((SECONDS - start)) s; the root is $copy, the log $log"
      return 1
    fi
    say "Debian $1, as $user: $command succeeded in $((SECONDS - start)) s"
  done
  if ! cp "$copy$home/xnewell/build/demo.png" "$root/build/front-door-$1.png"; then
    say "Debian $1, as $user: no picture of the window was made; the root is $copy"
    return 1
  fi
  say "Debian $1: the window is build/front-door-$1.png"
  remove_root "$copy"
}

mkdir -p "$roots" "$root/build"
exec {lock}>"$roots/lock"
flock --nonblock "$lock" || { say "waiting for another run of this check" && flock "$lock"; }
[[ -z $(git -C "$root" status --porcelain) ]] || say "changes that are not committed are not tested"
status=0
for release in "${releases[@]}"; do
  if ! bare_root "$release"; then
    say "front door: Debian $release NOT TRIED: $why"
    ((status)) || status=77
  elif ! front_door "$release"; then
    say "front door: Debian $release FAILED"
    status=1
  fi
done
exit "$status"
