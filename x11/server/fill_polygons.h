#pragma once

#include "shading/picture/picture.h"
#include "x11/server/canvas.h"

namespace xnewell {

/// `--fill x11`: the server fills the polygons. Each face is one XFillPolygon, from back to front, drawn into
/// the canvas's picture at `area` on `ground`. `area` is as large as the picture's settings say. The window
/// does not change yet.
///
/// In X, integer coordinates are pixel centres; ours lie half-way between. So a vertex at x goes to round(x -
/// 1/2). The guard band of 8192 pixels keeps every coordinate far from the values where 16 bits would wrap.
/// This rounding may make a polygon of more than three corners concave. So we do not promise the server that
/// it is convex: the server would paint it wrong without an error.
///
/// A piece of a split face is drawn as the whole face's polygon under a clip list: the pixels on the piece's
/// side of the cuts. So the pieces together paint exactly what the face would. If the vertices of the cut
/// were rounded to pixels instead, the background would show between the pieces.
void fillPolygons(Display* display, Canvas& canvas, const Picture& picture, const Rect& area,
                  std::uint8_t ground);

}  // namespace xnewell
