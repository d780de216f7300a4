#pragma once

#include <vector>

#include "shading/explain/scanline_run.h"
#include "x11/kit/pseudocode.h"

namespace xnewell {

/// Filling a polygon line by line, with the lines that a step has run and the values of their variables.
/// @see Foley & van Dam 2e §3.6, §16.2.4
[[nodiscard]] std::vector<CodeLine> scanlineCode(const ScanlineRun& run, int step);

}  // namespace xnewell
