#include "geometry/view/touch.h"

namespace xnewell {

bool mayTouch(const SnappedScene& scene, const SnappedFace& front, const SnappedFace& behind, std::int64_t x,
              std::int64_t y) {
  const double zFront = depthAt(scene.planes[front.plane], x, y),
               zBehind = depthAt(scene.planes[behind.plane], x, y);
  double lead = zFront - zBehind;
  if (!scene.ahead.empty()) lead += scene.ahead[front.part].at(x, y) - scene.ahead[behind.part].at(x, y);
  return lead <= front.doubt.at(zFront) + behind.doubt.at(zBehind);
}

}  // namespace xnewell
