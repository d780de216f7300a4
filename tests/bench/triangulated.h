#pragma once

#include <array>

#include "geometry/model/mesh.h"

namespace xnewell {

/// Cuts every face of a mesh of convex faces into a fan of triangles from its first corner. Each triangle
/// becomes a face.
[[nodiscard]] inline Mesh triangulated(Mesh mesh) {
  Mesh triangles;
  triangles.groupNames = mesh.groupNames;
  triangles.points = std::move(mesh.points);
  for (int f = 0; f < mesh.faceCount(); ++f)
    for (std::size_t i = 2; i < mesh.face(f).size(); ++i)
      triangles.addFace(std::array{mesh.face(f)[0], mesh.face(f)[i - 1], mesh.face(f)[i]}, 0);
  return triangles;
}

}  // namespace xnewell
