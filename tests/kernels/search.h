#pragma once

#include <array>
#include <string_view>

#include "tests/kernels/kernel.h"

namespace xnewell {

/// A search for the input of a kernel whose error is the largest share of its bound.

struct RoundingMode {
  int mode;  ///< as fesetround() takes it
  std::string_view name;
};
/// To nearest, up, down, to zero.
extern const std::array<RoundingMode, 4> kRoundingModes;

/// Judges the kernel at one input. Only Kernel::run is in that rounding mode. The result is a share of the
/// bound that holds in it. A result that is not a number counts as wrong.
[[nodiscard]] double shareAt(const Kernel& kernel, const Numbers& input, const RoundingMode& mode);

struct Worst {
  double share = 0;
  Numbers input;
};

/// The same effort and seed find the same input. In this order, the search
///  - takes the kernel's hard inputs, and others that are hard for most kernels: ends of the ranges,
///    multiples of 1/1000, powers of two and their neighbours, exponential lengths, denormal numbers;
///  - three times: bisects boxes of encodings, again and again the one in which it saw the largest error,
///    beginning with the whole range and with the neighbourhoods of the worst inputs so far; then steps from
///    the worst inputs by powers of two in their encodings, as long as this makes them worse;
///  - goes through all encodings next to the worst input.
[[nodiscard]] Worst searchWorst(const Kernel& kernel, const RoundingMode& mode, int evaluations,
                                std::uint64_t seed);

}  // namespace xnewell
