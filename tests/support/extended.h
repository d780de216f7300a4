#pragma once

#include <cfloat>
#include <cmath>

#include "geometry/exact/two_doubles.h"

namespace xnewell {

/// A number with a mantissa of 64 bits or more, for judges of what doubles computed.
#if LDBL_MANT_DIG >= 64
using Extended = long double;
#else
using Extended = TwoDoubles;
inline TwoDoubles operator+(const TwoDoubles& x) { return x; }
inline bool isfinite(const TwoDoubles& x) { return std::isfinite(x.high); }
#endif

}  // namespace xnewell
