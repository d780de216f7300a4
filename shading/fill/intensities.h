#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/model/mesh.h"
#include "geometry/model/vertex_normals.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// The illumination that is evaluated once and kept: at the centroids of faces for flat shading, at vertices
/// for Gouraud shading. It is in world coordinates, so no transformation changes it. When the depth sort
/// splits a face, it copies the face's number and thus its intensities.

struct ShadingPoints {
  /// N is a unit vector, or 0 for a face without area. Both are empty where all light is ambient.
  std::vector<glm::dvec3> at, N;
  std::vector<int> material;  ///< as in Mesh::material
  [[nodiscard]] std::size_t count() const { return material.size(); }
  /// Those from `first` on, before `end`.
  [[nodiscard]] ShadingPoints slice(std::size_t first, std::size_t end) const;
};
/// One point for each face: the centroid of its area, and its normal by Newell's method.
[[nodiscard]] ShadingPoints facePoints(const Mesh& mesh);
/// One point for each vertex.
[[nodiscard]] ShadingPoints vertexPoints(const Mesh& mesh, const Vertices& vertices);

/// One term of the equation in one channel at each point, times Ip and kd or ks and summed over the lights.
/// Both sides of the face are kept: a light reaches one of them, and the projected outline says which one the
/// eye sees (SnappedFace::back).
using Terms = std::vector<FrontBack<double>>;

/// The intensities of one channel at each point.
struct Intensities {
  std::vector<FrontBack<double>> I;  ///< the sum of all terms, clamped to [0, 1]
  int clamped = 0;                   ///< points where the sum was above 1 on either side
};

/// Makes the diffuse terms.
void diffuseIntensities(Terms& diffuse, const ShadingPoints& points, const Lighting& lighting, int channel);
/// Makes the specular terms, again whenever the eye moves.
void specularIntensities(Terms& specular, const ShadingPoints& points, const Lighting& lighting, int channel);
/// Makes I from these terms and the ambient one.
void addTerms(Intensities& intensities, const Terms& diffuse, const Terms& specular,
              const ShadingPoints& points, const Lighting& lighting, int channel);

}  // namespace xnewell
