#include "geometry/view/touch.h"

namespace xnewell {

namespace {

/// How far a face may be shown behind a nearer one, in units of what the rounding of both explains.
constexpr double kMostError = 1.5;

}  // namespace

bool mayTouch(const SnappedScene& scene, const SnappedFace& front, const SnappedFace& behind, std::int64_t x,
              std::int64_t y) {
  const double zFront = depthAt(scene.planes[front.plane], x, y),
               zBehind = depthAt(scene.planes[behind.plane], x, y);
  const double doubt = scene.doubtOf(front).at(zFront) + scene.doubtOf(behind).at(zBehind),
               lead = zFront - zBehind;
  const double own =
      lead + scene.planes.ahead(front.part).at(x, y) - scene.planes.ahead(behind.part).at(x, y);
  return own <= doubt || (lead <= doubt && own <= kMostError * doubt);
}

}  // namespace xnewell
