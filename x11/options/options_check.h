#pragma once

#include "x11/options/options.h"

namespace xnewell {

/// What no option can tell alone: which need, and which exclude each other.
/// @throws UsageError
void checkTogether(const Options& options);

}  // namespace xnewell
