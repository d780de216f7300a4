#pragma once

#include <cfloat>

#if LDBL_MANT_DIG != 64
#include "geometry/exact/soft_extended.h"
#endif

namespace xnewell {

/// A number with a mantissa of 64 bits, for judges of what doubles computed. It is x86's long double; that of
/// other processors has 53, 106 or 113 bits. Sums, products, quotients and roots have the same bits
/// everywhere.
#if LDBL_MANT_DIG == 64
using Extended = long double;
#else
using Extended = SoftExtended;
#endif

}  // namespace xnewell
