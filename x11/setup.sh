# shellcheck shell=bash disable=SC2034  # the lists of packages are for those who source this
# For the other scripts to source: installs what Debian or Ubuntu lacks, and builds.
#   need PACKAGE...         installs the missing ones; the network is not touched when there are none
#   build PRESET [-D...] [-- TARGET]    into build/PRESET, quietly; the log is shown if it fails
# XNEWELL_NO_INSTALL=1 installs nothing: what is missing is named, and that is a failure.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

program_packages=(g++ cmake ninja-build libx11-dev libxext-dev libglm-dev libpng-dev
  nlohmann-json3-dev libcli11-dev libfreetype-dev xfonts-base)
test_packages=(libgtest-dev libgmock-dev libxres-dev libxtst-dev libboost-dev twm x11-apps xvfb xserver-xephyr)

# All messages go to standard error: standard output belongs to the program.
say() { printf 'xnewell: %s\n' "$*" >&2; }

# Those of the packages that are not installed, one a line. A system without dpkg is trusted to have them.
missing() {
  command -v dpkg-query >/dev/null || return 0
  local package
  for package; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done
}

# Runs a command with its output in a log; if it fails, shows the log and passes the exit status on.
logged() {
  local log=$1 status=0
  shift
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 || status=$?
  if ((status)); then
    cat "$log" >&2
    say "failed with status $status: $*"
  fi
  return "$status"
}

need() {
  local absent as_root=()
  mapfile -t absent < <(missing "$@")
  ((${#absent[@]})) || return 0
  if [[ ${XNEWELL_NO_INSTALL:-} == 1 ]]; then
    say "missing packages: ${absent[*]}"
    return 1
  fi
  if ((EUID)); then
    if ! command -v sudo >/dev/null; then
      say "missing packages, and neither root nor sudo to install them: ${absent[*]}"
      return 1
    fi
    as_root=(sudo)
  fi
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
  say "installing with apt-get: ${absent[*]}"
  logged "$root/build/apt-update.log" "${apt[@]}" update &&
    logged "$root/build/apt-install.log" "${apt[@]}" install -y --no-install-recommends "${absent[@]}"
}

build() {
  local preset=$1
  shift
  say "building build/$preset"
  logged "$root/build/$preset.log" configure_and_build "$preset" "$@"
}

# A body in (): the caller's folder and options stay as they are.
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
