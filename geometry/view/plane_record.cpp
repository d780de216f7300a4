#include "geometry/view/plane_record.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

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

std::optional<ScreenPlane> PlaneRecords::of(const ModelPlane& plane, const glm::ivec2& near) const {
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
  const double alpha = slopeU * scale_.step.x, beta = -slopeV * scale_.step.y;
  const double steepest = std::max(std::abs(alpha), std::abs(beta));
  if (!(steepest < 0x1p60 && std::abs(z) < 0x1p31)) return {};  // also if one is not a number

  int exponent = 0;
  std::frexp(steepest, &exponent);
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

}  // namespace xnewell
