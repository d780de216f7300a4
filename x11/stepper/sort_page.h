#pragma once

#include "shading/color/palette.h"
#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_view.h"

namespace xnewell {

/// Why is this polygon painted now? One step of Newell's depth sort: the picture so far with P and Q, the two
/// under a loupe, the tests in order with their numbers, a finding, both from the side, the list, counts, and
/// the run as a timeline.

/// Draws the body; what lies between the parts is paper. The run goes to the view's step.
SortDrawn drawSortPage(IndexImage& image, const SortLayout& at, SortRun& run, const SortView& view,
                       const CellPlan& plan);

}  // namespace xnewell
