#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/model/mesh.h"
#include "geometry/model/vertex_normals.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// The illumination where it is evaluated once and kept: at the centroids of faces for flat shading, at
/// vertices for Gouraud's. In world coordinates: no transformation ever touches what is kept here, and
/// splitting copies it by copying a number.

struct ShadingPoints {
  std::vector<glm::dvec3> at, N;  ///< N unit, or 0 where a face has no area
  std::vector<int> material;      ///< as Mesh::material
};
/// One a face: its centroid, its normal by Newell's method.
[[nodiscard]] ShadingPoints facePoints(const Mesh& mesh);
/// One a vertex.
[[nodiscard]] ShadingPoints vertexPoints(const Mesh& mesh, const Vertices& vertices);

/// One channel's term at each point: times Ip and kd or ks, summed over the lights. Both sides are kept: the
/// light reaches one of them, and which one the eye sees is the projected outline's to say
/// (SnappedFace::back).
using Terms = std::vector<FrontBack<double>>;

/// One channel at each point.
struct Intensities {
  std::vector<FrontBack<double>> I;  ///< the sum of the terms, clamped to [0, 1]
  int clamped = 0;               ///< points where one side was above 1
};

void diffuseIntensities(Terms& diffuse, const ShadingPoints& points, const Lighting& lighting, int channel);
/// Again whenever the eye moves.
void specularIntensities(Terms& specular, const ShadingPoints& points, const Lighting& lighting, int channel);
/// I from these terms and the ambient one.
void addTerms(Intensities& intensities, const Terms& diffuse, const Terms& specular, const ShadingPoints& points,
              const Lighting& lighting, int channel);

}  // namespace xnewell
