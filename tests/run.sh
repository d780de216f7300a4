#!/usr/bin/env bash
# tests/run.sh [ctest options]: every test. Installs the packages that are missing and builds first.
# The exit status is that of the tests. They start X servers of their own.
# XNEWELL_PRESET=developer builds that preset instead of `release`: warnings are errors.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../x11/setup.sh"

preset=${XNEWELL_PRESET:-release}
need "${program_packages[@]}" "${test_packages[@]}"
build "$preset" -DXNEWELL_TESTS=ON
cd "$root"
exec ctest --preset "$preset" --output-on-failure -j "$(($(nproc) + 1))" "$@"
