#include "x11/fill_polygons.h"

#include <vector>

namespace {

/// Repeated pixels in a row say nothing to the server, and without them no polygon outgrows a request:
/// a convex outline within the guard band passes fewer than 4 * 16384 pixels.
void appendPixel(std::vector<XPoint>& points, const glm::ivec3& v, const Rect& area) {
  const XPoint p{static_cast<short>(area.x + (v.x >> kGridBits)),
                 static_cast<short>(area.y + (v.y >> kGridBits))};
  if (points.empty() || points.back().x != p.x || points.back().y != p.y) points.push_back(p);
}

}  // namespace

void fillPolygons(::Display* display, Canvas& canvas, const ServerColormap& colormap, const Picture& picture,
                  const Rect& area, std::uint8_t ground) {
  XRectangle clip{static_cast<short>(area.x), static_cast<short>(area.y),
                  static_cast<unsigned short>(area.width), static_cast<unsigned short>(area.height)};
  const ::Drawable to = canvas.drawable();
  const ::GC gc = canvas.gc();
  XSetClipRectangles(display, gc, 0, 0, &clip, 1, Unsorted);
  XSetForeground(display, gc, colormap.pixel(ground));
  XFillRectangle(display, to, gc, clip.x, clip.y, clip.width, clip.height);

  const SnappedScene& scene = picture.snapped();
  std::vector<XPoint> points;
  int current = ground;
  for (const int i : picture.order()) {
    const SnappedFace& face = scene.faces[i];
    points.clear();
    for (int v = face.first; v < face.first + face.count; ++v) appendPixel(points, scene.vertices[v], area);
    if (points.size() < 3) continue;  // thinner than a pixel: the server would own no centre of it
    if (current != picture.cells()[i]) {
      current = picture.cells()[i];
      XSetForeground(display, gc, colormap.pixel(picture.cells()[i]));
    }
    XFillPolygon(display, to, gc, points.data(), static_cast<int>(points.size()),
                 face.count == 3 ? Convex : Complex, CoordModeOrigin);
  }
  XSetClipMask(display, gc, None);
}
