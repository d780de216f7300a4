#pragma once

#include "x11/stepper/sort_pen.h"

namespace xnewell {

/// P and Q enlarged in the corner of the picture that is farthest from them: their corners with the distances
/// that decide, and where their planes meet. Returns where it stands; empty: there is nothing to enlarge.
Rect drawLoupe(SortPen& pen, Painter& picture);

}  // namespace xnewell
