#pragma once

#include <glm/vec3.hpp>

namespace xnewell {

/// v / |v| without overflow or underflow on the way; 0 for the zero vector.
[[nodiscard]] glm::dvec3 unit(glm::dvec3 v);

}  // namespace xnewell
