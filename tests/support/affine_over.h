#pragma once

#include "shading/fill/affine.h"

namespace xnewell {

[[nodiscard]] inline AffineValue affineOver(const glm::ivec3* p, const std::array<double, 3>& v) {
  return AffineOver{p}(v);
}

}  // namespace xnewell
