#pragma once

#include <cstdint>

namespace xnewell {

/// A 128-bit integer, for products of grid coordinates. It is a compiler extension of gcc and clang.
__extension__ using Int128 = __int128;

/// n as a double, with a relative error of at most 2^-52. The compiler's own conversion rounds to nearest,
/// but takes three times as long.
[[nodiscard]] inline double approximately(Int128 n) {
  __extension__ using Unsigned = unsigned __int128;
  const auto magnitude = static_cast<Unsigned>(n < 0 ? -n : n);
  const double d = static_cast<double>(static_cast<std::uint64_t>(magnitude >> 64)) * 0x1p64 +
                   static_cast<double>(static_cast<std::uint64_t>(magnitude));
  return n < 0 ? -d : d;
}

}  // namespace xnewell
