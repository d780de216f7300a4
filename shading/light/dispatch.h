#pragma once

namespace xnewell {

/// Functions that are compiled twice, for any processor and for those with AVX2; the program takes the better
/// one when it starts. Without contraction of products and sums (-ffp-contract=off) both give the same bits:
/// tests/x11/command/baseline_test.cpp, which has them compiled with XNEWELL_BASELINE, once and for any
/// processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(XNEWELL_BASELINE)
#define XNEWELL_DISPATCHED [[gnu::target_clones("default", "avx2")]]
#else
#define XNEWELL_DISPATCHED
#endif

}  // namespace xnewell
