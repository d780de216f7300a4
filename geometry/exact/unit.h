#pragma once

#include <glm/vec3.hpp>

namespace xnewell {

/// v / |v|, without overflow or underflow on the way. For the zero vector, and if a coordinate is not finite,
/// the result is 0. Each coordinate is off by at most 2^-51 of itself (three roundings under the root count
/// half, then come the root and the quotient) or 2^-1073.
[[nodiscard]] glm::dvec3 unit(glm::dvec3 v);

}  // namespace xnewell
