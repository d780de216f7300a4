#pragma once

namespace xnewell {

/// Marks a function that may use a fused multiply-add, if the processor has one.
#if defined(__x86_64__) && defined(__GNUC__)
#define XNEWELL_WITH_FMA [[gnu::target("fma"), gnu::noinline]]
inline bool hasFma() { return __builtin_cpu_supports("fma"); }
#else
#define XNEWELL_WITH_FMA [[gnu::noinline]]
#ifdef __FP_FAST_FMA
inline bool hasFma() { return true; }
#else
inline bool hasFma() { return false; }
#endif
#endif

/// a b + c from a file whose options allow one rounding for both.
double contracted(double a, double b, double c);

}  // namespace xnewell
