#pragma once

#include <glm/vec3.hpp>

namespace xnewell {

/// v / |v|, without overflow or underflow on the way. For the zero vector the result is 0.
[[nodiscard]] glm::dvec3 unit(glm::dvec3 v);

}  // namespace xnewell
