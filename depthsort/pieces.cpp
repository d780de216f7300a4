#include "depthsort/pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace xnewell {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int floorToInt(double z) {
  return static_cast<int>(std::clamp(std::floor(z), double{std::numeric_limits<int>::min()},
                                     double{std::numeric_limits<int>::max()}));
}

}  // namespace

Extents extentsOf(const SnappedScene& scene, const SnappedFace& face) {
  const glm::ivec3* const v = &scene.vertices[face.first];
  Extents e{{v->x, v->y, v->x, v->y}, v->z, v->z};
  for (const glm::ivec3* p = v + 1; p != v + face.count; ++p) {
    e.box = {std::min(e.box.x0, p->x), std::min(e.box.y0, p->y), std::max(e.box.x1, p->x),
             std::max(e.box.y1, p->y)};
    e.zFar = std::min(e.zFar, p->z);
    e.zNear = std::max(e.zNear, p->z);
  }
  if (face.throughVertices) return e;
  double far = kInfinity, near = -far;
  for (const glm::ivec3* p = v; p != v + face.count; ++p) {
    const double z = depthAt(scene.planes[face.plane], p->x, p->y), rounding = 0x1p-50 * std::abs(z);
    far = std::min(far, z - rounding);
    near = std::max(near, z + rounding);
  }
  e.zFar = floorToInt(far);
  e.zNear = floorToInt(near + 1.0);
  return e;
}

Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, const Region& piece,
                  const Extents& parent) {
  const ScreenPlane& plane = scene.planes[face.plane];
  const double A = static_cast<double>(plane.A) / static_cast<double>(plane.C),
               B = static_cast<double>(plane.B) / static_cast<double>(plane.C);
  const glm::ivec3& anchor = scene.vertices[face.first];
  const double z0 = depthAt(plane, anchor.x, anchor.y);
  double x0 = kInfinity, x1 = -x0, y0 = x0, y1 = -x0, far = x0, near = -x0;
  for (const Side& side : piece) {
    const Corner& c = side.corner;
    x0 = std::min(x0, c.x - c.radius), x1 = std::max(x1, c.x + c.radius);
    y0 = std::min(y0, c.y - c.radius), y1 = std::max(y1, c.y + c.radius);
    const double dx = c.x - anchor.x, dy = c.y - anchor.y, z = A * dx + B * dy + z0;
    const double rounding = (std::abs(A) + std::abs(B)) * c.radius +
                            0x1p-50 * (std::abs(A * dx) + std::abs(B * dy) + std::abs(z0));
    far = std::min(far, z - rounding), near = std::max(near, z + rounding);
  }
  return {{std::max(parent.box.x0, floorToInt(x0)), std::max(parent.box.y0, floorToInt(y0)),
           std::min(parent.box.x1, floorToInt(x1 + 1.0)), std::min(parent.box.y1, floorToInt(y1 + 1.0))},
          std::max(parent.zFar, floorToInt(far)),
          std::min(parent.zNear, floorToInt(near + 1.0))};
}

PixelArea rowsOf(const ScreenBox& box, const PixelArea& area, bool inPixels) {
  if (inPixels) return area;
  const int top = std::max(area.top, box.y0 >> kGridBits);
  return {area.left, top, area.right, std::max(top, std::min(area.bottom, (box.y1 >> kGridBits) + 1))};
}

void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const PixelArea& area) {
  Piece piece{of.face, static_cast<int>(sorted.cuts.size()), 0, area, of.parent};
  for (const Side& side : region)
    if (side.line.kind == Line::Kind::Cut) {
      sorted.cuts.push_back({side.line.p, side.line.q});
      ++piece.cuts;
    }
  sorted.pieces.push_back(piece);
}

}  // namespace xnewell
