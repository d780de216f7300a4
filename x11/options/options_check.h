#pragma once

#include "x11/options/options.h"

namespace xnewell {

/// Checks what no option can check alone: which options need others, and which exclude each other.
/// @throws UsageError
void checkTogether(const Options& options);

}  // namespace xnewell
