#include "shading/illumination.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/plane.h"
#include "geometry/power.h"
#include "geometry/view.h"

double luminance(glm::dvec3 color) { return 0.30 * color.r + 0.59 * color.g + 0.11 * color.b; }

std::vector<FaceShade> shadeFaces(const Mesh& mesh, const Illumination& light) {
  std::vector<double> share(mesh.materials.size());
  std::ranges::transform(mesh.materials, share.begin(),
                         [](const MeshMaterial& m) { return luminance(m.diffuse); });

  glm::dvec3 centre{0.0};  // where a constant L is taken
  if (light.lightPosition && light.constantL && !mesh.points.empty()) {
    glm::dvec3 low = mesh.points[0], high = low;
    for (const glm::dvec3& p : mesh.points) low = glm::min(low, p), high = glm::max(high, p);
    centre = (low + high) / 2.0;
  }
  const glm::dvec3 farL = light.lightPosition ? unit(*light.lightPosition - centre) : unit(light.light);

  std::vector<FaceShade> faces(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    FaceShade& face = faces[f];
    const glm::dvec3 area = newellVector(mesh.points, mesh.face(f));
    const double length = std::sqrt(glm::dot(area, area));
    if (length > 0.0) face.N = area / length;
    face.at = centroid(mesh.points, mesh.face(f));
    face.L = light.lightPosition && !light.constantL ? unit(*light.lightPosition - face.at) : farL;
    face.NdotL = std::clamp(glm::dot(face.N, face.L), -1.0, 1.0);
    const double color = mesh.material[f] < 0 ? 1.0 : share[mesh.material[f]];
    const double lit = light.twoSided ? std::abs(face.NdotL) : std::max(0.0, face.NdotL);
    face.ambient = light.ka * color * light.Ia;
    face.diffuse = light.Ip * light.kd * color * lit;
  }
  return faces;
}

void shadeSpecular(std::span<FaceShade> faces, const Illumination& light, glm::dvec3 eye, glm::dvec3 lookAt) {
  const glm::dvec3 farV = unit(eye - lookAt);
  for (FaceShade& face : faces) {
    const bool lit = light.twoSided ? face.NdotL != 0.0 : face.NdotL > 0.0;
    face.specular = 0.0;
    if (light.ks > 0.0 && lit) {
      const glm::dvec3 R = 2.0 * face.NdotL * face.N - face.L;
      const glm::dvec3 V = light.constantV ? farV : unit(eye - face.at);
      face.specular = light.Ip * light.ks * power(std::clamp(glm::dot(R, V), 0.0, 1.0), light.n);
    }
    const double brightest = face.ambient + face.diffuse + face.specular;
    const double bright = std::min(1.0, brightest), dark = face.ambient;
    face.clamped = brightest > 1.0;
    if (!light.twoSided)
      face.I = {bright, bright};
    else
      face.I = face.NdotL >= 0.0 ? std::array{bright, dark} : std::array{dark, bright};
  }
}
