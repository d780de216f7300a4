#!/usr/bin/env bash
# tests/run.sh [ctest options]: every test. Installs the packages that are missing and builds first;
# the exit status is that of the tests, which start X servers of their own.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../x11/setup.sh"

need "${program_packages[@]}" "${test_packages[@]}"
build release -DXNEWELL_TESTS=ON
cd "$root"
exec ctest --preset release --output-on-failure -j "$(($(nproc) + 1))" "$@"
