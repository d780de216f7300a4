#include "shading/fill/intensities.h"

#include <algorithm>

#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "shading/fill/dispatch.h"
#include "shading/fill/reflect.h"

namespace xnewell {

namespace {

constexpr int kSideBySide = 4;
using Four = Lanes<double, kSideBySide>;

/// The number of points from `first` on that have the same material, at most four.
std::size_t runOf(const std::vector<int>& material, std::size_t first) {
  std::size_t end = first + 1;
  while (end < material.size() && end < first + kSideBySide && material[end] == material[first]) ++end;
  return end - first;
}

[[gnu::always_inline]] inline Vec<Four> gathered(const std::vector<glm::dvec3>& from, std::size_t first,
                                                 std::size_t count) {
  Vec<Four> v;
  for (int k = 0; k < kSideBySide; ++k) {
    const glm::dvec3& p = from[first + std::min<std::size_t>(k, count - 1)];
    v.x[k] = p.x, v.y[k] = p.y, v.z[k] = p.z;
  }
  return v;
}

[[gnu::always_inline]] inline void add(Terms& sums, std::size_t first, std::size_t count, double share,
                                       const FrontBack<Four>& term) {
  for (int k = 0; k < static_cast<int>(count); ++k) {
    sums[first + k].front += share * term.front[k];
    sums[first + k].back += share * term.back[k];
  }
}

/// One of the terms with a mistake: place by place, each side for itself.
void mistakenTerms(Terms& sums, double LightTerms::*term, const ShadingPoints& points,
                   const Lighting& lighting, int channel) {
  for (const Lighting::Source& light : lighting.sources)
    for (std::size_t k = 0; k < points.count(); ++k) {
      const glm::dvec3& P = points.at[k];
      const Incident<double> in = incident<double>(light, {P.x, P.y, P.z});
      const Vec<double> V = towardsEye<double>(lighting, {P.x, P.y, P.z});
      const auto of = [&](const glm::dvec3& N) {
        return mistakenTerms(lighting, light, in, lighting.materials[points.material[k] + 1], channel, N,
                             {V.x, V.y, V.z}).*
               term;
      };
      const double front = of(points.N[k]);
      sums[k].front += front;
      sums[k].back += lighting.twoSided ? of(-points.N[k]) : front;
    }
}

}  // namespace

ShadingPoints facePoints(const Mesh& mesh) {
  ShadingPoints points;
  points.at.resize(mesh.faceCount());
  points.N.resize(mesh.faceCount());
  points.material = mesh.material;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    points.N[f] = unit(newellVector(mesh.points, mesh.face(f)));
    points.at[f] = centroid(mesh.points, mesh.face(f));
  }
  return points;
}

ShadingPoints vertexPoints(const Mesh& mesh, const Vertices& vertices) {
  ShadingPoints points;
  points.at.reserve(vertices.vertices.size());
  points.N.reserve(vertices.vertices.size());
  points.material.reserve(vertices.vertices.size());
  for (const Vertex& v : vertices.vertices) {
    points.at.push_back(mesh.points[v.point]);
    points.N.push_back(v.N);
    points.material.push_back(v.material);
  }
  return points;
}

ShadingPoints ShadingPoints::slice(std::size_t first, std::size_t end) const {
  const auto part = [&](const auto& all) {
    return all.empty() ? all : std::decay_t<decltype(all)>(all.begin() + first, all.begin() + end);
  };
  return {part(at), part(N), part(material)};
}

XNEWELL_DISPATCHED
void diffuseIntensities(Terms& diffuse, const ShadingPoints& points, const Lighting& lighting, int channel) {
  diffuse.assign(points.count(), {0.0, 0.0});
  if (lighting.mistake != Mistake::None)
    return mistakenTerms(diffuse, &LightTerms::diffuse, points, lighting, channel);
  for (const Lighting::Source& light : lighting.sources)
    for (std::size_t first = 0, count = 0; first < points.count(); first += count) {
      count = runOf(points.material, first);
      const Incident<Four> in = incident(light, gathered(points.at, first, count));
      const double kd = lighting.materials[points.material[first] + 1].kd[channel];
      add(diffuse, first, count, light.Ip[channel] * kd,
          diffuseTerm(in, gathered(points.N, first, count), lighting.twoSided));
    }
}

XNEWELL_DISPATCHED
void specularIntensities(Terms& specular, const ShadingPoints& points, const Lighting& lighting,
                         int channel) {
  specular.assign(points.count(), {0.0, 0.0});
  if (!lighting.specular) return;
  if (lighting.mistake != Mistake::None)
    return mistakenTerms(specular, &LightTerms::specular, points, lighting, channel);
  for (const Lighting::Source& light : lighting.sources)
    for (std::size_t first = 0, count = 0; first < points.count(); first += count) {
      count = runOf(points.material, first);
      const Material& material = lighting.materials[points.material[first] + 1];
      if (material.ks[channel] == 0.0) continue;
      const Vec<Four> at = gathered(points.at, first, count);
      add(specular, first, count, light.Ip[channel] * material.ks[channel],
          specularTerm(incident(light, at), gathered(points.N, first, count), towardsEye(lighting, at),
                       material, lighting));
    }
}

void addTerms(Intensities& intensities, const Terms& diffuse, const Terms& specular,
              const ShadingPoints& points, const Lighting& lighting, int channel) {
  intensities.I.resize(points.count());
  intensities.clamped = 0;
  for (std::size_t k = 0; k < points.count(); ++k) {
    const double ambient = lighting.materials[points.material[k] + 1].ambient[channel];
    const FrontBack<double>&d = diffuse[k], &s = specular[k];
    const FrontBack<double> sum{ambient + d.front + s.front, ambient + d.back + s.back};
    intensities.clamped += sum.front > 1.0 || sum.back > 1.0;
    intensities.I[k] = {std::clamp(sum.front, 0.0, 1.0),
                        std::clamp(sum.back, 0.0, 1.0)};  // a mistake may be below 0
  }
}

}  // namespace xnewell
