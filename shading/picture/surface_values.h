#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "shading/picture/surface_evaluator.h"

namespace xnewell {

/// Values of the surfaces at the samples of a picture, in double precision, before a colour table rounds
/// them. Plots show these values, and pictures are measured against them.

/// The face that each sample shows, for some rows of a picture.
struct SeenRows {
  int width = 0, firstRow = 0;
  std::vector<int> faces;  ///< indices into SnappedScene::faces, row by row; kNothing where no face shows

  [[nodiscard]] int endRow() const { return firstRow + static_cast<int>(faces.size()) / width; }
};

/// The intensity of one channel, clamped to [0, 1]; NaN where nothing shows. `ofFaces` has the intensity of
/// each face if the method gives each face a single one. Values are interpolated as the method defines it,
/// without the fixed point, the single precision and the tables that the fillers use. Only an environment is
/// looked up in its map, whose entries have single precision. Where cell numbers are interpolated
/// (Interpolated), it is the intensity of which they are the cells at the vertices.
[[nodiscard]] std::vector<double> intensitiesAt(const SeenRows& seen, const Surfaces& surfaces, int channel,
                                                const std::vector<double>& ofFaces);

/// Unit vectors in the world, or 0 where nothing shows. They point to the side of the face that the light is
/// computed for. They are interpolated if the method interpolates; otherwise they are the normal of the face.
[[nodiscard]] std::vector<glm::dvec3> normalsAt(const SeenRows& seen, const Surfaces& surfaces);

}  // namespace xnewell
