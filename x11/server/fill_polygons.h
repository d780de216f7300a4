#pragma once

#include "shading/picture/picture.h"
#include "x11/server/canvas.h"

namespace xnewell {

/// `--fill x11`: the server fills the polygons, one XFillPolygon a face, back to front, into the
/// canvas's picture at `area` (as large as the picture's settings say), on `ground`. Nothing is shown yet.
///
/// Integer coordinates are pixel centres to X, ours are half-way between: a vertex at x goes to
/// round(x - 1/2). The guard band of 8192 pixels keeps every coordinate far from where 16 bits would
/// wrap. A polygon of more than three corners may lose its convexity in that rounding and is not promised
/// to be convex: the server would silently paint it wrong.
///
/// A piece of a split face is the whole face's polygon under a clip list: the pixels on its side of the cuts.
/// So the pieces paint exactly what the face would have, and no background shows between them, as it
/// would where cut vertices are rounded to pixels.
void fillPolygons(Display* display, Canvas& canvas, const Picture& picture, const Rect& area,
                  std::uint8_t ground);

}  // namespace xnewell
