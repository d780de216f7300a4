#pragma once

#include "shading/color/palette.h"
#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_view.h"

namespace xnewell {

/// Why is this polygon painted now? The page shows one step of Newell's depth sort: the picture so far with P
/// and Q, both under a loupe, the tests in order with their numbers, a finding, both polygons from the side,
/// the list, counts, and the run as a timeline.

/// Draws the whole body of the window. The run goes to the step of the view.
SortDrawn drawSortPage(IndexImage& image, const SortLayout& at, SortRun& run, const SortView& view,
                       const CellPlan& plan);

}  // namespace xnewell
