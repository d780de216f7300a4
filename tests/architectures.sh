#!/usr/bin/env bash
# tests/architectures.sh [--quick] [amd64|arm64|armhf|ppc64el|riscv64|s390x]...: checks that the last commit gives the
# same bytes on these architectures, or on the ones named. In a copy of a bare root of Debian 13 or 12 it builds the
# program and the tests of geometry, depthsort and shading with Debian's cross compiler, and runs them under qemu-user.
# The test `manifest_tests` draws all scenes and compares every file and text with tests/data/manifest.txt.
#   --quick   the manifest alone, without the tests of the floors
# The logs are in build/architecture-ARCH. A copy is removed, except after a failure. CMAKE_BUILD_PARALLEL_LEVEL says
# how many files are compiled at a time. Exit status as that of tests/front_door.sh.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/bare_roots.sh"

declare -A triplets=([amd64]=x86_64-linux-gnu [arm64]=aarch64-linux-gnu [armhf]=arm-linux-gnueabihf
  [ppc64el]=powerpc64le-linux-gnu [riscv64]=riscv64-linux-gnu [s390x]=s390x-linux-gnu)
declare -A emulators=([amd64]='' [arm64]=qemu-aarch64 [armhf]=qemu-arm [ppc64el]=qemu-ppc64le
  [riscv64]=qemu-riscv64 [s390x]=qemu-s390x)

programs=(manifest_tests geometry_tests depthsort_tests shading_tests)
if [[ ${1-} == --quick ]]; then
  programs=(manifest_tests)
  shift
fi
architectures=("$@")
((${#architectures[@]})) || architectures=(amd64 arm64 armhf ppc64el riscv64 s390x)
for architecture in "${architectures[@]}"; do
  [[ ${triplets[$architecture]-} ]] || {
    say "usage: tests/architectures.sh [--quick] [amd64|arm64|armhf|ppc64el|riscv64|s390x]..."
    exit 2
  }
done

# prepare ARCH COPY: makes a copy of a bare root with the cross compiler, the emulator and the libraries: of Debian 13,
# or of Debian 12 where the package server lacks some of Debian 13.
prepare() {
  local architecture=$1 copy=$2 release libraries=(libx11 libxext libpng libfreetype libgtest libgmock libxres libxtst)
  libraries=("${libraries[@]/%/-dev:$architecture}" "libstdc++6:$architecture")
  local tools=(cmake ninja-build xfonts-base libglm-dev libboost-dev nlohmann-json3-dev libcli11-dev)
  [[ $architecture == amd64 ]] && tools+=(g++) || tools+=("crossbuild-essential-$architecture" qemu-user)
  for release in 13 12; do
    what="$architecture, Debian $release"
    bare_root "$release" || { say "$what: $why"; continue; }
    copy_root "$release" "$copy" && inside "$copy" dpkg --add-architecture "$architecture" || return
    install_in "$copy" "${tools[@]}" "${libraries[@]}" && return
  done
  return 1
}

# same_bytes ARCH COPY: builds and runs everything there.
same_bytes() {
  local architecture=$1 copy=$2 program here=/srv/xnewell emulator=${emulators[$1]}
  git clone --quiet "$root" "$copy$here" || return
  # shellcheck disable=SC2016
  step build inside "$copy" env "CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" sh -ec '
    cd "$1" && triplet=$2 emulator=$3 && shift 3
    cmake --preset release -DXNEWELL_TESTS=ON ${emulator:+-DCMAKE_SYSTEM_NAME=Linux
      -DCMAKE_SYSTEM_PROCESSOR=${triplet%%-*} -DCMAKE_CROSSCOMPILING_EMULATOR=$emulator
      -DCMAKE_CXX_COMPILER=$triplet-g++}
    cmake --build --preset release --target xnewell "$@"' sh \
    "$here" "${triplets[$architecture]}" "$emulator" "${programs[@]}" || return
  for program in "${programs[@]}"; do
    # shellcheck disable=SC2016
    step "$program" inside "$copy" env "XNEWELL_EMULATOR=$emulator" sh -c '
      cd "$1" && exec ${XNEWELL_EMULATOR:-env} build/release/tests/$2 --gtest_brief=1' sh "$here" "$program" || return
    say "$architecture: $(grep -F '[  PASSED  ]' "$results/$program.log")"
  done
}

one_at_a_time
status=0
for architecture in "${architectures[@]}"; do
  results=$root/build/architecture-$architecture copy=$roots/debian-$architecture
  rm -rf "$results" && mkdir -p "$results"
  if ! prepare "$architecture" "$copy"; then
    say "$architecture NOT TRIED: its packages cannot be had"
    ((status)) || status=77
  elif ! same_bytes "$architecture" "$copy"; then
    say "$architecture FAILED; the logs are in $results, the root is $copy"
    status=1
    continue
  else
    say "$architecture: all well"
  fi
  remove_root "$copy"
done
exit "$status"
