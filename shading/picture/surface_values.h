#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "shading/picture/surface_evaluator.h"

namespace xnewell {

/// What surfaces have at the samples of a picture, in double precision and before a colour table rounds it:
/// what plots show, and what pictures are measured by.

/// Of some rows of a picture, the face that each sample shows.
struct SeenRows {
  int width = 0, firstRow = 0;
  std::vector<int> faces;  ///< indices into SnappedScene::faces, row by row; kNothing where there is none

  [[nodiscard]] int endRow() const { return firstRow + static_cast<int>(faces.size()) / width; }
};

/// The intensity of one channel, clamped to [0, 1]; NaN where nothing shows. `ofFaces` has that of each face
/// where the method gives a face one. Interpolated values are those of a method's definition: nothing of the
/// fixed point, single precision and tables with which pictures are filled.
[[nodiscard]] std::vector<double> intensitiesAt(const SeenRows& seen, const Surfaces& surfaces, int channel,
                                                const std::vector<double>& ofFaces);

/// Unit vectors in the world, on the side of the face that the light is computed for: interpolated where the
/// method interpolates, else the face's. 0 where nothing shows.
[[nodiscard]] std::vector<glm::dvec3> normalsAt(const SeenRows& seen, const Surfaces& surfaces);

}  // namespace xnewell
