#include "geometry/view/stages.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "geometry/exact/scale.h"

namespace xnewell {

ViewStages::ViewStages(const ViewSpec& view, int width, int height)
    : projection_{view.projection},
      vrp_{view.vrp},
      rotation_{vrcRotation(view)},
      planes_{clipPlanes(frontDepth(view, width), kMaxPicture)} {
  const ViewMatrices m = viewMatrices(view);
  matrix_.fill(glm::dmat4{1.0});
  matrix_[index(ViewStage::Vrc)] = m.R * m.minusVrp;
  matrix_[index(ViewStage::Sheared)] = m.SH * m.minusPrp;
  matrix_[index(ViewStage::Warped)] = m.M * m.S * m.T;
  matrix_[index(ViewStage::Viewport)] = screenFromCanonical(view, width, height);
  glm::dmat4 product{1.0};
  for (std::size_t k = 0; k < matrix_.size(); ++k) soFar_[k] = product = matrix_[k] * product;
}

std::string_view ViewStages::letters(ViewStage stage) const {
  return projection_ == Projection::Parallel ? rowOf(stage).parallel : rowOf(stage).perspective;
}

glm::dmat4 ViewStages::toScreen(ViewStage stage) const {
  glm::dmat4 product{1.0};
  for (std::size_t k = index(stage) + 1; k < matrix_.size(); ++k) product = matrix_[k] * product;
  return product;
}

glm::dvec4 ViewStages::at(ViewStage stage, const glm::dvec3& place) const {
  if (stage == ViewStage::World) return {place, 1.0};
  glm::dvec4 p{rotation_ * (place - vrp_), 1.0};  // as vrcRotation() says
  for (std::size_t k = index(ViewStage::Sheared); k <= index(stage); ++k) p = matrix_[k] * p;
  if (stage >= ViewStage::Viewport) p = {glm::dvec3{p} / p.w, 1.0};
  return p;
}

// The place p / w moves along d by (p' w - p w') / w^2, where p' and w' are what the matrix makes of (d, 0).
glm::dmat3 ViewStages::derivative(ViewStage stage, const glm::dvec3& place) const {
  const glm::dmat4& m = soFar(stage);
  const glm::dvec4 q = stage >= ViewStage::Viewport
                           ? matrix(ViewStage::Viewport) * at(ViewStage::Clipped, place)
                           : at(stage, place);
  const glm::dvec3 p = glm::dvec3{q} / q.w;
  glm::dmat3 d{};
  for (int k = 0; k < 3; ++k) d[k] = (glm::dvec3{m[k]} - p * m[k].w) / q.w;
  return d;
}

unsigned ViewStages::outside(const glm::dvec3& place) const {
  return outcode(planes_, matrix(ViewStage::Viewport) * at(ViewStage::Clipped, place));
}

glm::dvec3 carried(const glm::dmat3& derivative, const glm::dvec3& direction) {
  return unit(derivative * direction);
}

// The inverse transposed is that of the cofactors, divided by the determinant.
glm::dvec3 carriedNormal(const glm::dmat3& d, const glm::dvec3& N) {
  const double scale = std::max({glm::length(d[0]), glm::length(d[1]), glm::length(d[2])});
  if (!(scale > 0.0)) return glm::dvec3{0.0};
  const glm::dvec3 x = d[0] / scale, y = d[1] / scale, z = d[2] / scale;
  const glm::dmat3 cofactors{glm::cross(y, z), glm::cross(z, x), glm::cross(x, y)};
  const double side = glm::dot(x, cofactors[0]);
  return side == 0.0 ? glm::dvec3{0.0} : unit(cofactors * N) * (side > 0.0 ? 1.0 : -1.0);
}

bool keepsAngles(const glm::dmat3& d) {
  constexpr double kRounded = 0x1p-30;
  const glm::dmat3 products = glm::transpose(d) * d;
  const double scale = (products[0][0] + products[1][1] + products[2][2]) / 3.0;
  if (!(scale > 0.0)) return false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(products[i][j] / scale - (i == j ? 1.0 : 0.0)) > kRounded) return false;
  return true;
}

}  // namespace xnewell
