#include "tests/support/contracted.h"

namespace xnewell {

// This file alone is compiled with -ffp-contract=fast.
XNEWELL_WITH_FMA double contracted(double a, double b, double c) { return a * b + c; }

}  // namespace xnewell
