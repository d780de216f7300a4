#pragma once

namespace xnewell {

/// Marks a function that is compiled twice: for any processor, and for processors with AVX2. The program
/// chooses one when it starts. Both give the same bits, because products and sums are not contracted
/// (-ffp-contract=off). The test Baseline.GivesTheSameBits shows this: it compares with a program that is
/// compiled with XNEWELL_BASELINE, for any processor only. Without optimisation the functions that such a
/// function calls are not inlined, so they would take its vectors in other registers than it passes them in.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && \
    !defined(XNEWELL_BASELINE)
#define XNEWELL_DISPATCHED [[gnu::target_clones("default", "avx2")]]
#else
#define XNEWELL_DISPATCHED
#endif

}  // namespace xnewell
