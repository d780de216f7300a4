#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "shading/fill/face_triangles.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What the picture's own loops have at one sample. explain.h puts it beside the definitions.

struct LoopValue {
  double I = 0;                          ///< in [0, 1], as precise as the loop; it picks the cell
  std::uint8_t cell = 0;                 ///< or the value of a channel, where the cells hold colours
  std::optional<glm::ivec2> place = {};  ///< environment: column and row of the map
  bool away = false;
};

/// `face` is an index into snapped().faces and owns the sample of pixel (i, j). One channel, 0 to 2.
[[nodiscard]] LoopValue loopValueOf(const Picture& picture, int face, int channel, int i, int j);

/// What Gouraud shading interpolates, at a vertex of the face: the value on the ramp (Ramp::value). `vertex`
/// is an index into snapped().vertices.
[[nodiscard]] double gouraudValueAt(const Picture& picture, int face, int channel, int vertex);
/// What environment maps interpolate there: column and row of the map, and which of two maps.
[[nodiscard]] glm::dvec3 mapPlaceAt(const Picture& picture, int face, int channel, int vertex);

/// The triangle of a face that owns the sample of pixel (i, j), which the face owns.
[[nodiscard]] FaceTriangle triangleAt(const SnappedScene& scene, const SnappedFace& face, int i, int j);

/// A value along the edges and the row (Polygons::Rows); `v` has one for each vertex of the face.
[[nodiscard]] double alongRow(const SnappedScene& scene, const SnappedFace& face,
                              const std::vector<double>& v, int i, int j);

}  // namespace xnewell
