#pragma once

#include <cstdint>

#ifndef __SIZEOF_INT128__
#include "geometry/exact/wide_int128.h"
#endif

namespace xnewell {

/// A 128-bit integer, for products of grid coordinates: the compiler's, or one of Boost's where it has none.
/// `>>` rounds down, and `&` sees two's complement. Only results and casts that fit are the same for both.
#ifdef __SIZEOF_INT128__
__extension__ using Int128 = __int128;
#else
using Int128 = WideInt128;
#endif

/// n as a double, with a relative error of at most 2^-52. The compiler's own conversion rounds to nearest,
/// but takes three times as long.
template <class Integer>
[[nodiscard]] double approximately(const Integer& n) {
  const Integer magnitude = n < 0 ? Integer{-n} : n;
  const double d = static_cast<double>(static_cast<std::uint64_t>(magnitude >> 64)) * 0x1p64 +
                   static_cast<double>(static_cast<std::uint64_t>(magnitude & ~std::uint64_t{0}));
  return n < 0 ? -d : d;
}

}  // namespace xnewell
