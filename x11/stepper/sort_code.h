#pragma once

#include <vector>

#include "x11/kit/pseudocode.h"
#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_state.h"

namespace xnewell {

/// Newell's sort line by line, with the line that a step of the run is. While a question is open, the tests
/// and what follows them are not told. @see Newell, Newell and Sancha 1972; Foley & van Dam 2e §15.5.1
[[nodiscard]] std::vector<CodeLine> sortCode(SortRun& run, const SortState& view);

}  // namespace xnewell
