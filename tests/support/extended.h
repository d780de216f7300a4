#pragma once

#include <cfloat>

#include "geometry/exact/two_doubles.h"

namespace xnewell {

/// A number with a mantissa of 64 bits or more, for judges of what doubles computed.
#if LDBL_MANT_DIG >= 64
using Extended = long double;
#else
using Extended = TwoDoubles;
#endif

}  // namespace xnewell
