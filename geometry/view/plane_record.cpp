#include "geometry/view/plane_record.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace xnewell {

GridScale::GridScale(const ViewSpec& view, int width, int height, int zShift)
    : perspective{view.projection == Projection::Perspective},
      step{(view.windowMax - view.windowMin) / glm::dvec2{width, height} / double{kGrid}},
      zStep{std::ldexp(step.x, zShift)},
      corner{view.windowMin.x - view.prp.x, view.windowMax.y - view.prp.y},
      D{view.prp.z},
      back{view.back},
      lean{(glm::dvec2{view.prp} - (view.windowMin + view.windowMax) / 2.0) / view.prp.z} {}

PlaneRecords::PlaneRecords(const ViewSpec& view, int width, int height, int zShift)
    : scale_{view, width, height, zShift}, rotation_{vrcRotation(view)}, vrp_{view.vrp}, prp_{view.prp} {}

bool PlaneRecords::Depth::fits() const {  // false if one is not a number
  return std::max(std::abs(alpha), std::abs(beta)) < 0x1p60 && std::abs(z) < 0x1p31;
}

PlaneRecords::Depth PlaneRecords::depthOf(const ModelPlane& plane, const glm::ivec2& near) const {
  const glm::dvec3 m = rotation_ * plane.N;
  const double k = glm::dot(m, rotation_ * (plane.at - vrp_) - prp_);
  const glm::dvec2 at = scale_.onViewPlane(near.x, near.y);
  double slopeU = 0.0, slopeV = 0.0, z = 0.0;  // slopes in z steps for each unit of u and v
  if (scale_.perspective) {
    const double unit = scale_.D / scale_.zStep / k;
    slopeU = unit * m.x, slopeV = unit * m.y;
    z = unit * (m.x * at.x + m.y * at.y - m.z * scale_.D) -
        scale_.D * scale_.D / scale_.zStep / (scale_.D - scale_.back);
  } else {
    const double along = m.z + m.x * scale_.lean.x + m.y * scale_.lean.y;
    slopeU = -m.x / along / scale_.zStep, slopeV = -m.y / along / scale_.zStep;
    // at n = D the projector through (u, v) is at (u, v) + lean D, from the projection reference point
    const glm::dvec2 there = at + scale_.lean * scale_.D;
    z = (scale_.D + (k - m.x * there.x - m.y * there.y) / along - scale_.back) / scale_.zStep;
  }
  return {slopeU * scale_.step.x, -slopeV * scale_.step.y, z};
}

std::optional<ScreenPlane> PlaneRecords::of(const ModelPlane& plane, const glm::ivec2& near) const {
  const Depth depth = depthOf(plane, near);
  if (!depth.fits()) return {};
  const auto [alpha, beta, z] = depth;
  int exponent = 0;
  std::frexp(std::max(std::abs(alpha), std::abs(beta)), &exponent);
  const int K = std::min(60, 60 - exponent);
  ScreenPlane record;
  record.A = std::llrint(std::ldexp(alpha, K));
  record.B = std::llrint(std::ldexp(beta, K));
  record.C = std::int64_t{1} << K;
  // z has 31 bits before the point, so 22 after it are exact in any case.
  record.D = (Int128{std::llrint(std::ldexp(z, 22))} << K >> 22) - Int128{record.A} * near.x -
             Int128{record.B} * near.y;
  record.ofModel = true;
  return record;
}

Ahead PlaneRecords::ahead(const ModelPlane& plane, const ModelPlane& other, const glm::ivec2& near) const {
  const Depth mine = depthOf(plane, near), its = depthOf(other, near);
  if (!mine.fits() || !its.fits()) return {};
  const double x = mine.alpha - its.alpha, y = mine.beta - its.beta;
  return {x, y, mine.z - its.z - x * near.x - y * near.y};
}

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
