#!/usr/bin/env bash
# tests/front_door.sh [--tests] [--sudo] [--with "PACKAGE..."] [12|13]...
# Checks that the README's first command works on a bare machine. It makes a root folder of Debian 12 and one
# of Debian 13, or of the ones named, with debootstrap's smallest variant and git. In a copy of each it clones
# the last commit and runs the command. All figures of all scenes must have the same bytes in both.
#   --tests             runs the README's second command, too
#   --sudo              runs them as a user with sudo, not as root
#   --with "PACKAGE..." installs these packages first
# The bare roots are kept in ~/.cache/xnewell. The copies are removed, except after a failure.
# Exit status: 0 if all commands succeeded, 1 if one failed, 77 if nothing failed but a root could not be made
# here.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/bare_roots.sh"

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

# The README's two commands are the first two lines of its first block.
mapfile -t commands < <(sed -n '/^```sh$/,/^```$/p' "$root/README.md" | sed -n 's/^\([^`# ]\+\) *#.*/\1/p' | head -2)
((${#commands[@]} == 2)) || { say "README.md: its first block should have two commands"; exit 1; }
[[ $with_tests ]] || unset 'commands[1]'

# indented RELEASE: puts the release before what a command prints. Of ctest it keeps only the failures and the end.
indented() { sed -uE "/(Start +[0-9]+:| Passed +[0-9.]+ sec)/d; s/^/    Debian $1: /" >&2; }

# prepare RELEASE COPY HOME: makes a copy of the bare root, with the user, the packages asked for and a clone.
prepare() {
  local copy=$2 home=$3 with=$preinstalled
  [[ $user == root ]] || with=${with:+$with }sudo
  copy_root "$1" "$copy" || return
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

# Every command reads its options: another version of CLI11 may refuse what this machine's accepts.
# shellcheck disable=SC2016  # these are variables of the inner shell
every_command='
  names=$(build/release/x11/xnewell --help | sed -n "s/^  xnewell \([a-z-]*\) .*/\1/p" | sort -u)
  for name in ${names:?}; do build/release/x11/xnewell "$name" --help >/dev/null || exit; done'

# The sums of the figures of all scenes: flat as SVG, Gouraud as PDF, Phong as EPS. So all pixels of Phong's
# picture count, and no compressed file, since libraries compress in different ways.
# shellcheck disable=SC2016  # these are variables of the inner shell
figure_sums='
  for scene in teapot $(basename -s .json -a data/scenes/*.json); do
    for kind in flat:svg gouraud:pdf phong:eps; do
      build/release/x11/xnewell figure "$scene" --size 400x300 --shade "${kind%:*}" --tolerance 0 -o "figure.${kind#*:}" \
        2>/dev/null || exit
      echo "$scene ${kind%:*} $(sha256sum <"figure.${kind#*:}")"
    done
  done'

# The milliseconds for one fixed file, compiled once for each processor at the same time. A multiple of them says more
# about the build than seconds do, on a slow or busy machine.
# shellcheck disable=SC2016  # these are variables of the inner shell
fixed_file='
  printf "%s\n" "#include <regex>" "bool b(const char* s) { return std::regex_match(s, std::regex{\"a*b\"}); }" >/tmp/f.cpp
  start=$(date +%s%N)
  for ((k = $(nproc); k; --k)); do g++ -std=c++20 -O3 -c /tmp/f.cpp -o "/tmp/f$k.o" & done
  wait
  echo $((($(date +%s%N) - start) / 1000000))'

# front_door RELEASE: succeeds if the commands succeed in that release.
front_door() {
  local copy=$roots/debian-$1-copy home=/root run=(bash -c) log=$root/build/front-door-$1.log command start built fixed
  [[ $user == root ]] || home=/home/$user run=(su --login "$user" --command)
  if ! prepare "$1" "$copy" "$home"; then
    say "Debian $1: the copy of the bare root could not be prepared"
    return 1
  fi
  : >"$log"
  for command in "${commands[@]}"; do
    say "Debian $1, as $user: $command"
    start=$SECONDS
    if ! inside "$copy" "${run[@]}" "cd $home/xnewell && $command" </dev/null 2>&1 | tee -a "$log" | indented "$1"; then
      say "Debian $1, as $user: $command FAILED after $((SECONDS - start)) s; the root is $copy, the log $log"
      return 1
    fi
    say "Debian $1, as $user: $command succeeded in $((SECONDS - start)) s"
  done
  fixed=$(inside "$copy" "${run[@]}" "$fixed_file") &&
    built=$(sed -n 's/.*building build.release: done in \([0-9]*\) s.*/\1/p;T;q' "$log") &&
    say "Debian $1: building took $built s, $((1000 * built / fixed)) times one fixed file"
  if ! inside "$copy" "${run[@]}" "cd $home/xnewell && $every_command" >&2; then
    say "Debian $1, as $user: a command cannot read its options; the root is $copy"
    return 1
  fi
  if ! inside "$copy" "${run[@]}" "cd $home/xnewell && $figure_sums" >"$root/build/front-door-$1.sums"; then
    say "Debian $1, as $user: the figures could not be made; the root is $copy"
    return 1
  fi
  if ! cp "$copy$home/xnewell/build/demo.png" "$root/build/front-door-$1.png"; then
    say "Debian $1, as $user: no picture of the window was made; the root is $copy"
    return 1
  fi
  say "Debian $1: the window is build/front-door-$1.png"
  remove_root "$copy"
}

one_at_a_time
status=0
declare -A running=()
# While one root is made or installs its packages, another uses the processors. Each runs in a process group of
# its own, which ends with this script.
set -m
trap 'for job in "${running[@]}"; do kill -- "-$job" 2>/dev/null || true; done' EXIT
trap 'exit 130' INT TERM
for release in "${releases[@]}"; do
  if bare_root "$release"; then
    front_door "$release" &
    running[$release]=$!
  else
    say "front door: Debian $release NOT TRIED: $why"
    status=77
  fi
done
for release in "${!running[@]}"; do
  if ! wait "${running[$release]}"; then
    say "front door: Debian $release FAILED"
    status=1
  fi
  unset "running[$release]"
done
first=$root/build/front-door-${releases[0]}.sums
for release in "${releases[@]:1}"; do
  ((status == 0)) || break
  if ! diff "$first" "$root/build/front-door-$release.sums" >&2; then
    say "front door: figures have other bytes in Debian $release"
    status=1
  else
    say "front door: $(wc -l <"$first") figures have the same bytes in Debian ${releases[0]} and $release"
  fi
done
exit "$status"
