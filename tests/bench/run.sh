#!/usr/bin/env bash
# tests/bench/run.sh [FILTER [options of Google Benchmark]]: the benchmarks, or those whose name matches
# the regular expression. Installs the packages that are missing and builds first.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../x11/setup.sh"

need "${program_packages[@]}" libbenchmark-dev
build bench
for program in geometry depthsort shading x11; do
  "$root/build/bench/tests/bench/${program}_bench" --benchmark_filter="${1:-.}" "${@:2}"
done
