#pragma once

#include <array>
#include <glm/vec3.hpp>

struct BezierPatch { std::array<glm::dvec3, 16> p; };  ///< p[4 * row + column], row along u, column along v
