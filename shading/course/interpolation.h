#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace xnewell {

/// Interpolation over a triangle, as the textbook teaches it. It is written to be read. The fillers step the
/// same values along rows, or evaluate eight pixels at once (shading/fill); tests hold them against this
/// file.

/// How much each vertex counts at a place. The three add up to 1.
using Weights = std::array<double, 3>;

/// The weights of the vertices at the sample of pixel (i, j), on the screen: each is the area of the triangle
/// between the sample and the opposite side, over the whole area. Vertices are on the grid of 1/65536 pixel.
/// A triangle narrower than 2^-12 pixel has the mean everywhere, because the grid decides how its values
/// grow.
[[nodiscard]] Weights weightsOnScreen(const std::array<glm::ivec3, 3>& p, int i, int j);
/// The same at the origin, where the vertices are in pixels.
[[nodiscard]] Weights weightsOfOrigin(const std::array<glm::dvec2, 3>& p);

/// The weights at the place of the surface that is seen there. In perspective the far end of a side takes
/// less of the screen than the near end. 1/w is linear over the screen (w is the depth), and so is a value
/// over w. So each weight is divided by its vertex' depth, and all by their sum.
[[nodiscard]] Weights weightsInWorld(const Weights& onScreen, const std::array<double, 3>& overDepth);

/// The weighted sum of the values at the vertices. Gouraud's intensity takes the weights on the screen; a
/// texture coordinate, a place and a normal take those in the world. Phong's N is the sum of the normals made
/// a unit vector.
template <class Value>
[[nodiscard]] Value interpolated(const Weights& weights, const std::array<Value, 3>& v) {
  return weights[0] * v[0] + weights[1] * v[1] + weights[2] * v[2];
}

}  // namespace xnewell
