#include "geometry/view/depth_doubt.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace xnewell {

DepthDoubt::DepthDoubt(const ViewSpec& view, int width, int height, int zShift)
    : picture_{width * kGrid, height * kGrid},
      perspective_{view.projection == Projection::Perspective},
      step_{(view.windowMax - view.windowMin) / glm::dvec2{width, height} / double{kGrid}},
      corner_{view.windowMin.x - view.prp.x, view.windowMax.y - view.prp.y},
      D_{view.prp.z},
      magnificationPerZ_{perspective_ ? std::ldexp(step_.x, zShift) / D_ : 0.0},
      backMagnification_{perspective_ ? D_ / (D_ - view.back) : 1.0},
      slant_{glm::length((view.windowMin + view.windowMax) / 2.0 - glm::dvec2{view.prp}) / D_},
      steps_{std::sqrt(3.0) / std::min(step_.x, step_.y)},
      zSteps_{std::ldexp(1.0, -zShift)} {}

Doubt DepthDoubt::of(const glm::ivec3* outline, int count, const ScreenPlane& plane, double u) const {
  double slant = slant_;
  if (perspective_) {
    slant = 0.0;
    for (const glm::ivec3* p = outline; p != outline + count; ++p) {
      const glm::ivec2 inPicture = glm::clamp(glm::ivec2{p->x, p->y}, glm::ivec2{0}, picture_);
      const glm::dvec2 seen = corner_ + glm::dvec2{inPicture.x, -inPicture.y} * step_;
      slant = std::max(slant, std::abs(seen.x) + std::abs(seen.y));
    }
    slant /= D_;
  }
  const double slope = (std::abs(static_cast<double>(plane.A)) + std::abs(static_cast<double>(plane.B))) /
                       static_cast<double>(plane.C);
  const double steps = steps_ * std::min(u, kMostRounding);
  const double byQ = steps * (1.0 + slant) * slope;
  double byQQ = steps * zSteps_;
  const auto magnification = [&](double z) { return z * magnificationPerZ_ + backMagnification_; };
  const auto sum = [&](double q) { return 4.0 * (0.5 + 0.5 * slope + q * (byQ + q * byQQ)); };
  // The bound must hold for every corner, even where rounding put the plane further off.
  double beyond = 0.0;
  for (const glm::ivec3* p = outline; u > 0.0 && p != outline + count; ++p) {
    const double z = depthAt(plane, p->x, p->y), q = magnification(z);
    beyond = std::max(beyond, (std::abs(p->z - z) - sum(q)) / (q * q));
  }
  byQQ += beyond / 4.0;

  // Expand the sum in powers of z.
  const double m = magnificationPerZ_, q0 = backMagnification_;
  return {static_cast<float>(sum(q0)), static_cast<float>(4.0 * m * (byQ + 2.0 * q0 * byQQ)),
          static_cast<float>(4.0 * m * m * byQQ)};
}

}  // namespace xnewell
