#include "x11/server/fill_polygons.h"

#include <algorithm>
#include <vector>

#include "depthsort/fragment_spans.h"

namespace xnewell {

namespace {

/// Appends a vertex as a pixel, unless it repeats the last one. A repeated pixel does not change the polygon.
/// Without repeats no polygon is too long for a request: a convex outline within the guard band passes fewer
/// than 4 * 16384 pixels.
void appendPixel(std::vector<XPoint>& points, const glm::ivec3& v, const Rect& area) {
  const XPoint p{static_cast<short>(area.x + (v.x >> kGridBits)),
                 static_cast<short>(area.y + (v.y >> kGridBits))};
  if (points.empty() || points.back().x != p.x || points.back().y != p.y) points.push_back(p);
}

/// The pixels on the piece's side of all its cuts, row by row, within the rows that its face may reach.
void clipToPiece(std::vector<XRectangle>& rows, const SnappedScene& scene, const SortedScene& sorted,
                 const Fragment& fragment, const Rect& area) {
  const SnappedFace& face = scene.faces[fragment.face];
  const Piece& piece = sorted.pieces[fragment.piece];
  const auto [top, bottom] =
      std::minmax_element(&scene.vertices[face.first], &scene.vertices[face.first] + face.count,
                          [](auto& a, auto& b) { return a.y < b.y; });
  const PieceWalk walk{scene, sorted, piece};
  rows.clear();
  const int end = std::min(piece.area.bottom, (bottom->y >> kGridBits) + 1);
  for (int j = std::max(piece.area.top, top->y >> kGridBits); j < end; ++j) {
    const Columns columns = walk.within(j, {piece.area.left, piece.area.right});
    if (columns.from < columns.to)
      rows.push_back({static_cast<short>(area.x + columns.from), static_cast<short>(area.y + j),
                      static_cast<unsigned short>(columns.to - columns.from), 1});
  }
}

}  // namespace

void fillPolygons(Display* display, Canvas& canvas, const Picture& picture, const Rect& area,
                  std::uint8_t ground) {
  XRectangle clip{static_cast<short>(area.x), static_cast<short>(area.y),
                  static_cast<unsigned short>(area.width), static_cast<unsigned short>(area.height)};
  const Drawable to = canvas.drawable();
  const GC gc = canvas.gc();
  XSetClipRectangles(display, gc, 0, 0, &clip, 1, YXBanded);
  canvas.setFill(ground);
  XFillRectangle(display, to, gc, clip.x, clip.y, clip.width, clip.height);

  const SnappedScene& scene = picture.snapped();
  std::vector<XPoint> points;
  std::vector<XRectangle> rows;
  int current = ground;
  bool clipped = false;
  for (const Fragment& fragment : picture.sorted().fragments) {
    const int i = fragment.face;
    const SnappedFace& face = scene.faces[i];
    points.clear();
    for (int v = face.first; v < face.first + face.count; ++v) appendPixel(points, scene.vertices[v], area);
    if (points.size() < 3) continue;  // thinner than a pixel: it covers no pixel centre
    if (current != picture.cells()[i]) {
      current = picture.cells()[i];
      canvas.setFill(picture.cells()[i]);
    }
    if (fragment.piece >= 0) {
      clipToPiece(rows, scene, picture.sorted(), fragment, area);
      XSetClipRectangles(display, gc, 0, 0, rows.data(), static_cast<int>(rows.size()), YXBanded);
      clipped = true;
    } else if (clipped) {
      XSetClipRectangles(display, gc, 0, 0, &clip, 1, YXBanded);
      clipped = false;
    }
    XFillPolygon(display, to, gc, points.data(), static_cast<int>(points.size()),
                 face.count == 3 ? Convex : Complex, CoordModeOrigin);
  }
  XSetClipMask(display, gc, Pixmap{});
}

}  // namespace xnewell
