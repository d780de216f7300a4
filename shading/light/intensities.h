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
  std::vector<glm::dvec3> at, N;  ///< N is a unit vector, or 0 for a face without area
  std::vector<int> material;      ///< as in Mesh::material
};
/// One point for each face: its centroid, and its normal by Newell's method.
[[nodiscard]] ShadingPoints facePoints(const Mesh& mesh);
/// One point for each vertex.
[[nodiscard]] ShadingPoints vertexPoints(const Mesh& mesh, const Vertices& vertices);

/// The intensities of one channel at each point, for the front and the back of the face. A light reaches one
/// of the two; the projected outline says which one the eye sees (SnappedFace::back).
struct Intensities {
  std::vector<FrontBack<double>> diffuse, specular;  ///< the terms of the equation, summed over the lights
  std::vector<FrontBack<double>> I;                  ///< the sum with the ambient term, clamped to [0, 1]
  int clamped = 0;                                   ///< points where the sum was above 1 on either side
};

/// Makes the diffuse terms. It sets the specular terms to 0.
void diffuseIntensities(Intensities& intensities, const ShadingPoints& points, const Lighting& lighting,
                        int channel);
/// Makes the specular terms, again whenever the eye moves.
void specularIntensities(Intensities& intensities, const ShadingPoints& points, const Lighting& lighting,
                         int channel);
/// Makes I from the terms.
void addTerms(Intensities& intensities, const ShadingPoints& points, const Lighting& lighting, int channel);

}  // namespace xnewell
