#!/usr/bin/env bash
# tests/bench/run.sh [FILTER [options of Google Benchmark]] runs all benchmarks, or those whose names match
# the regular expression FILTER. First it installs missing packages and builds.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../x11/setup.sh"

need "${program_packages[@]}" libbenchmark-dev
build bench
# The memory of the program: x11/terminal/memory.h.
export GLIBC_TUNABLES=glibc.malloc.mmap_threshold=33554432:glibc.malloc.trim_threshold=268435456:glibc.malloc.hugetlb=1
for program in depthsort shading; do
  "$root/build/bench/tests/bench/${program}_bench" --benchmark_filter="${1:-.}" "${@:2}"
done
