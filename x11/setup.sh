# shellcheck shell=bash disable=SC2034  # the scripts that source this use the lists of packages
# Other scripts source this file. need() installs the packages that Debian or Ubuntu lacks, and build() builds.
# Both show their progress.
#   need PACKAGE...         installs those that are missing; if there are none, it does not use the network
#   build PRESET [-D...] [-- TARGET]    builds into build/PRESET
# With XNEWELL_NO_INSTALL=1, need() installs nothing: it lists what is missing and fails.
# With CXX set, that compiler is used, and g++ is not needed.

set -o pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd -P)

# tests/front_door.sh checks that these lists are complete.
program_packages=(cmake ninja-build libx11-dev libxext-dev libglm-dev libpng-dev libboost-dev
  nlohmann-json3-dev libcli11-dev libfreetype-dev xfonts-base)
[[ ${CXX:-} ]] || program_packages=(g++ "${program_packages[@]}")
test_packages=(libgtest-dev libgmock-dev libxres-dev libxtst-dev
  xvfb xserver-xephyr tigervnc-standalone-server twm universal-ctags)

# All messages go to standard error, because standard output belongs to the program.
say() { printf 'xnewell: %s\n' "$*" >&2; }

# Prints the packages that are not installed, one per line. If there is no dpkg, we assume that all are
# installed.
missing() {
  command -v dpkg-query >/dev/null || return 0
  local package
  for package; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done
}

# Reads the output of apt-get or ninja and shows the progress: on a terminal in one line that changes,
# elsewhere with a new line every ten seconds.
show_progress() {
  local what=$1 line percent=0 now='' start=$SECONDS shown=$SECONDS every=10
  local apt='^(dl|pm)status:[^:]*:([0-9]+)[0-9.]*:(.*)' ninja='^\[([0-9]+)/([0-9]+)\] (.*)'
  [[ ! -t 2 ]] || every=1
  trap 'say "$what: interrupted; it ends as soon as it can"' INT
  while IFS= read -r -t "$every" line || (($? > 128)); do  # above 128: no line came in that time
    if [[ $line =~ $apt ]]; then
      percent=${BASH_REMATCH[2]} now=${BASH_REMATCH[3]}
      # apt-get counts to 100 twice: while it downloads, and while it installs, which takes about twice as
      # long.
      [[ ${BASH_REMATCH[1]} == dl ]] && percent=$((percent / 3)) || percent=$((33 + percent * 2 / 3))
    elif [[ $line =~ $ninja ]]; then
      percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2])) now=${BASH_REMATCH[3]%/CMakeFiles/*}
      now=${now##* }  # the folder that is compiled, or the program that is linked
    elif [[ $line == *'Waiting for'* ]]; then
      now=$line  # another program is installing packages
    fi
    if [[ -t 2 ]]; then
      printf '\r\033[K%.79s' "xnewell: $what: $percent %, $((SECONDS - start)) s  $now" >&2
    elif ((SECONDS - shown >= every)); then
      shown=$SECONDS
      say "$what: $percent %, $((SECONDS - start)) s  $now"
    fi
  done
  [[ ! -t 2 ]] || printf '\r\033[K' >&2
}

# Prints the part of a failed command's log that says why it failed.
why_it_failed() {
  if grep -q '^E: ' "$1"; then
    grep '^E: ' "$1" | sort -u | head -3
  else
    sed -n '/FAILED:\|[Ee]rror:\|CMake Error/,$p' "$1" | head -40 | grep . || tail -20 "$1"
  fi
}

# logged LOG WHAT COMMAND...: runs the command, shows its progress and writes its output to the log. Returns
# its status; an interrupt ends the script.
logged() {
  local log=$1 what=$2 start=$SECONDS status=0 interrupted=''
  shift 2
  mkdir -p "$(dirname "$log")" && : >"$log" || return
  say "$what"
  trap 'interrupted=yes' INT
  "$@" 2>&1 </dev/null | (trap '' INT && exec tee "$log") | show_progress "$what" || status=${PIPESTATUS[0]}
  trap - INT
  [[ ! $interrupted ]] || exit 130
  if ((status)); then
    why_it_failed "$log" >&2
    say "$what: FAILED; the whole log is $log"
    return "$status"
  fi
  say "$what: done in $((SECONDS - start)) s"
}

need() {
  local absent as_root=()
  mapfile -t absent < <(missing "$@")
  ((${#absent[@]})) || return 0
  if [[ ${XNEWELL_NO_INSTALL:-} == 1 ]]; then
    say "${0#"$root/"} needs packages that are missing here. As root, this installs them:"
    say "  apt-get update && apt-get install --no-install-recommends ${absent[*]}"
    return 1
  fi
  if ((EUID)); then
    if ! command -v sudo >/dev/null; then
      say "only root or sudo can install the missing packages: ${absent[*]}"
      return 1
    fi
    as_root=(sudo)
  fi
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
    apt-get -y -o DPkg::Lock::Timeout=300 -o APT::Status-Fd=1)
  say "missing packages: ${absent[*]}"
  local lists=$root/build/apt-update.log
  logged "$lists" "reading the lists of packages" "${apt[@]}" update || return
  # If no server answers, apt-get prints errors but succeeds.
  if grep -q '^Err:' "$lists" && ! grep -qE '^(Get|Hit):' "$lists"; then
    grep -m 1 '^W: ' "$lists" >&2 || true
    say "no package server answers; the whole log is $lists"
    return 1
  fi
  logged "$root/build/apt-install.log" "installing packages" \
    "${apt[@]}" install --no-install-recommends "${absent[@]}"
}

build() {
  local cache=$root/build/$1/CMakeCache.txt
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    say "build/$1 was made for another folder, so it is built again"
    rm -rf "$root/build/$1"
  fi
  logged "$root/build/$1.log" "building build/$1" configure_and_build "$@"
}

# The body is in (), a subshell, so that the caller's folder and options do not change.
configure_and_build() (
  preset=$1 definitions=()
  shift
  while (($#)) && [[ $1 != -- ]]; do
    definitions+=("$1")
    shift
  done
  (($#)) && shift
  cd "$root" && cmake --preset "$preset" "${definitions[@]}" && cmake --build --preset "$preset" ${1:+--target "$1"}
)
