#include "shading/fill/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "shading/fill/reflect.h"

namespace xnewell {

namespace {

constexpr int kSide = 256;

struct FarLight {
  glm::dvec3 L;  ///< in the axes of the look-up
  double Ip, fatt;
  double brightness;  ///< by which the axes of the look-up go
};

/// A rotation that turns L into (0, 0, 1). Its rows are two vectors perpendicular to L, and L.
glm::dmat3 rotationTo(const glm::dvec3& L) {
  const glm::dvec3 a = glm::abs(L);
  const glm::dvec3 other = a.x <= a.y && a.x <= a.z ? glm::dvec3{1, 0, 0}
                           : a.y <= a.z             ? glm::dvec3{0, 1, 0}
                                                    : glm::dvec3{0, 0, 1};
  const glm::dvec3 u = glm::normalize(glm::cross(other, L));
  return glm::transpose(glm::dmat3{u, glm::cross(L, u), L});
}

/// cos x by the published look-up. For a light behind (z < 0) it takes the opposite light, and the centre of
/// the map and its edges change places.
double publishedCosine(const glm::dvec3& light, double x, double y) {
  const bool behind = light.z < 0.0;
  glm::dvec2 d = (behind ? -1.0 : 1.0) * glm::dvec2{light} - glm::dvec2{x, y};
  if (behind)
    for (int axis = 0; axis < 2; ++axis) d[axis] = std::copysign(1.0 - std::abs(d[axis]), d[axis]);
  return std::sqrt(std::max(0.0, 1.0 - glm::dot(d, d)));
}

}  // namespace

Environment makeEnvironment(EnvironmentForm form, const Lighting& lighting, const Material& material,
                            int channel, const glm::dmat3& viewFrame, const glm::dvec3& centre) {
  std::vector<FarLight> lights;  // L in world coordinates
  for (const Lighting::Source& source : lighting.sources) {
    const Incident<double> in = incident<double>(source, {centre.x, centre.y, centre.z});
    // The three maps of a luminance are added, so they need the same axes.
    const double Ip =
        lighting.luminance ? luminance({source.Ip[0], source.Ip[1], source.Ip[2]}) : source.Ip[channel];
    lights.push_back({{in.L.x, in.L.y, in.L.z}, source.Ip[channel], in.f, in.f * Ip});
  }
  Environment map;
  const bool rotated = form == EnvironmentForm::Rotated;
  if (!rotated || lights.empty()) {
    map.frame = viewFrame;
  } else {
    const FarLight& brightest = *std::ranges::max_element(lights, {}, &FarLight::brightness);
    map.frame = brightest.L == glm::dvec3{0.0} ? glm::dmat3{1.0} : rotationTo(brightest.L);
  }
  map.twoMaps = rotated;
  for (FarLight& light : lights) light.L = map.frame * light.L;

  const Reflection surface{0.0, material.kd[channel], material.ks[channel], material.n};
  const auto reflected = [&](double x, double y, double side) {
    const double z = side * std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    double I = material.ambient[channel];
    for (const FarLight& light : lights) {
      const double cosine = rotated ? std::clamp(x * light.L.x + y * light.L.y + z * light.L.z, 0.0, 1.0)
                                    : publishedCosine(light.L, x, y);
      const IlluminationTerms terms = termsOf(0.0, light.Ip, light.fatt, 1.0, surface, cosine,
                                              cosine > material.leastCosine ? cosine : 0.0);
      I += terms.diffuse + terms.specular;
    }
    return static_cast<float>(I);
  };
  const auto fill = [&](std::vector<float>& cells, double side) {
    cells.resize(kSide * kSide);
    for (int row = 0; row < kSide; ++row)
      for (int column = 0; column < kSide; ++column)
        cells[kSide * row + column] =
            reflected((column + 0.5 - kMapCentre) / kMapScale, (row + 0.5 - kMapCentre) / kMapScale, side);
  };
  fill(map.front, 1.0);
  if (map.twoMaps) fill(map.away, -1.0);
  return map;
}

}  // namespace xnewell
