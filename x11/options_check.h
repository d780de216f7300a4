#pragma once

#include "x11/options.h"

/// What no option can tell alone: which need, and which exclude each other.
/// @throws UsageError
void checkTogether(const Options& options);
