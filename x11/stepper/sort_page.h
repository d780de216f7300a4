#pragma once

#include "shading/color/color_table.h"
#include "x11/kit/control.h"
#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_state.h"

namespace xnewell {

/// Why is this polygon painted now? The page shows one step of Newell's depth sort: the picture so far with P
/// and Q, both under a loupe, the tests in order with their numbers, a finding, both polygons from the side,
/// the list, counts, and the run as a timeline.

/// The name of a control of the page beside those of transport.h: its part of the page, and its index there.
/// The buttons there are 20 to 26; rows have the last numbers, as a page may have any number of them.
enum class SortPart { Toggle = 10, Answer = 30, Act = 40, Test = 50, Ring = 60, Row = 100 };
[[nodiscard]] constexpr ControlId sortId(SortPart part, int index = 0) {
  return {0, static_cast<int>(part) + index};
}
/// The kinds of step to jump to, and a box, as the page shows them.
[[nodiscard]] Control kindsControl(const SortRun& run, const SortState& view);
[[nodiscard]] Control toggleControl(const SortState& view, int index);

/// Draws the whole body of the window. The run goes to the step of the view. The list says which control is
/// under the pointer, dragged or selected, and learns where they are; without it they are drawn at rest.
SortDrawn drawSortPage(Painter paint, const SortLayout& at, SortRun& run, const SortState& view,
                       const CellPlan& plan, ControlList* list = nullptr);

}  // namespace xnewell
