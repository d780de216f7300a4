#!/usr/bin/env bash
# tests/bench/run.sh [FILTER [options of Google Benchmark]] runs all benchmarks, or those whose names match
# the regular expression FILTER. First it installs missing packages and builds.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../x11/setup.sh"

need "${program_packages[@]}" libbenchmark-dev
build bench
for program in geometry depthsort shading x11; do
  "$root/build/bench/tests/bench/${program}_bench" --benchmark_filter="${1:-.}" "${@:2}"
done
