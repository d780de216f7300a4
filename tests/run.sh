#!/usr/bin/env bash
# tests/run.sh [ctest options]: runs every test. It first installs missing packages and builds. Its exit
# status is that of the tests. The tests start their own X servers.
# With XNEWELL_PRESET=developer it builds that preset instead of `release`: warnings are errors.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../x11/setup.sh"

preset=${XNEWELL_PRESET:-release}
need "${program_packages[@]}" "${test_packages[@]}"
build "$preset" -DXNEWELL_TESTS=ON
cd "$root"
exec ctest --preset "$preset" --output-on-failure -j "$(($(nproc) + 1))" "$@"
