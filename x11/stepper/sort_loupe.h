#pragma once

#include "x11/stepper/sort_pen.h"

namespace xnewell {

/// Draws P and Q enlarged, in the corner of the picture that is farthest from them: their corners with the
/// distances that decide, and the line where their planes meet. Returns the area of the loupe.
Rect drawLoupe(SortPen& pen, Painter& picture);

}  // namespace xnewell
