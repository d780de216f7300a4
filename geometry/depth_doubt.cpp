#include "geometry/depth_doubt.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

DepthDoubt::DepthDoubt(const ViewSpec& view, int width, int height, int zShift)
    : perspective_{view.projection == Projection::Perspective},
      step_{(view.windowMax - view.windowMin) / glm::dvec2{width, height} / double{kGrid}},
      corner_{view.windowMin.x - view.prp.x, view.windowMax.y - view.prp.y},
      D_{view.prp.z},
      magnificationPerZ_{std::ldexp(step_.x, zShift) / D_},
      backMagnification_{D_ / (D_ - view.back)},
      slant_{glm::length((view.windowMin + view.windowMax) / 2.0 - glm::dvec2{view.prp}) / D_},
      steps_{std::sqrt(3.0) / std::min(step_.x, step_.y)},
      zSteps_{std::ldexp(1.0, -zShift)} {}

double DepthDoubt::of(const glm::ivec3* outline, int count, const ScreenPlane& plane, double u) const {
  double q = 1.0, slant = slant_;
  if (perspective_) {
    slant = q = 0.0;
    for (const glm::ivec3* p = outline; p != outline + count; ++p) {
      q = std::max(q, p->z * magnificationPerZ_ + backMagnification_);
      const glm::dvec2 seen = corner_ + glm::dvec2{p->x, -p->y} * step_;
      slant = std::max(slant, std::abs(seen.x) + std::abs(seen.y));
    }
    slant /= D_;
  }
  const double slope = (std::abs(static_cast<double>(plane.A)) + std::abs(static_cast<double>(plane.B))) /
                       static_cast<double>(plane.C);
  const double steps = steps_ * std::min(u, kMostRounding);
  const double dxy = 0.5 + steps * q * (1.0 + slant), dz = 0.5 + steps * q * q * zSteps_;
  return 4.0 * (dz + dxy * slope);
}
