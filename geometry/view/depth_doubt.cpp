#include "geometry/view/depth_doubt.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace xnewell {

DepthDoubt::DepthDoubt(const ViewSpec& view, int width, int height, int zShift)
    : scale_{view, width, height, zShift},
      worldFromVrc_{glm::transpose(vrcRotation(view))},
      axis_{-scale_.corner.x / scale_.step.x, scale_.corner.y / scale_.step.y},
      perZ_{scale_.zStep / (scale_.D * scale_.D)},
      perBack_{1.0 / (scale_.D - scale_.back)},
      q0_{perBack_ / perZ_},
      perSlope_{perZ_ * scale_.D / scale_.step.x, -perZ_ * scale_.D / scale_.step.y} {}

Doubt DepthDoubt::of(const ScreenPlane& record, double u) const {
  const double perC = 1.0 / static_cast<double>(record.C);
  const double alpha = static_cast<double>(record.A) * perC, beta = static_cast<double>(record.B) * perC;
  const double snap = 0.5 + 0.5 * (std::abs(alpha) + std::abs(beta));
  const auto moved = [&](const glm::dvec3& m) {
    const glm::dvec3 n = glm::abs(worldFromVrc_ * m);
    return u * (n.x + n.y + n.z);
  };
  if (!scale_.perspective) {
    glm::dvec3 m{-alpha * scale_.zStep / scale_.step.x, beta * scale_.zStep / scale_.step.y, 1.0};
    m.z -= m.x * scale_.lean.x + m.y * scale_.lean.y;
    return {static_cast<float>(snap + moved(m) / scale_.zStep), 0.0f};
  }
  const double zAtAxis = alpha * axis_.x + beta * axis_.y + approximately(record.D) * perC;
  const double byZ = moved({alpha * perSlope_.x, beta * perSlope_.y, -(zAtAxis * perZ_ + perBack_)});
  return {static_cast<float>(snap + byZ * q0_), static_cast<float>(byZ)};
}

}  // namespace xnewell
