#!/usr/bin/env bash
# tests/fuzz/run.sh SECONDS [FUZZER...] gives made-up files to the readers, for SECONDS each. It says in a line
# for each fuzzer how many it tried, and keeps what fails in build/fuzz/found. First it installs missing packages
# and builds.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../x11/setup.sh"

(($#)) && [[ $1 =~ ^[1-9][0-9]*$ ]] || { say "usage: tests/fuzz/run.sh SECONDS [FUZZER...]"; exit 2; }
time=$1
shift
fuzzers=("$@")
(($#)) || fuzzers=(obj mtl ply off bpt scene lesson setup polygons)

# clang 14 and 15 refuse parts of C++20 that the program uses. So we take the newest clang that is installed, or
# else the newest that there is. Its run-time library is a package of its own.
versions=$(apt-cache pkgnames clang- 2>/dev/null | sed -n 's/^clang-\([0-9]*\)$/\1/p' | sort -n | awk '$1 >= 16')
clang='' there=''
for version in $versions; do
  apt-cache show "libclang-rt-$version-dev" >/dev/null 2>&1 || continue
  there=$version
  ! command -v "clang++-$version" >/dev/null || clang=$version
done
[[ ${clang:=$there} ]] || { say "the fuzzers need clang 16 or newer, and this system has no package of it"; exit 1; }
need "${program_packages[@]}" "clang-$clang" "libclang-rt-$clang-dev"
build fuzz "-DCMAKE_CXX_COMPILER=clang++-$clang"

fuzz=$root/build/fuzz
rm -rf "$fuzz/seeds"
mkdir -p "$fuzz/found"
"$fuzz/tests/fuzz/fuzz_seeds" "$fuzz/seeds"
failed=0
for name in "${fuzzers[@]}"; do
  mkdir -p "$fuzz/corpus/$name" "$fuzz/seeds/$name"
  log=$fuzz/$name.log status=0
  TMPDIR=$fuzz/found UBSAN_OPTIONS=print_stacktrace=1 \
    "$fuzz/tests/fuzz/fuzz" "$name" "$fuzz/corpus/$name" "$fuzz/seeds/$name" \
    -max_total_time="$time" -max_len=65536 -timeout=30 -rss_limit_mb=3000 -print_final_stats=1 \
    -artifact_prefix="$fuzz/found/$name-" >"$log" 2>&1 || status=$?
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  if ((status == 0)); then
    say "fuzz $name: ${runs:-?} inputs, nothing found"
  else
    what=$(grep -m1 -E 'ERROR|runtime error|Assertion' "$log" || tail -n 1 "$log")
    say "fuzz $name: FAILED after ${runs:-?} inputs: $what; see $log and $fuzz/found"
    failed=1
  fi
done
exit "$failed"
