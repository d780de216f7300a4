#include "shading/laboratory/reference.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "depthsort/oracle.h"
#include "geometry/exact/give_up.h"
#include "geometry/exact/unit.h"
#include "shading/scene/units.h"

namespace xnewell {

Reference::Reference(const Picture& of) : TrueView{of}, gray_{isGray(picture().scene())} {
  const Scene& scene = picture().scene();
  const Illumination& user = picture().settings().light;
  Ia_ = scene.light.Ia.value_or(glm::dvec3{user.Ia});
  lights_ = lightsOf(scene, user);
  const auto add = [&](const MeshMaterial& m) {
    materials_.push_back({reflectionOf(m, user, 0), reflectionOf(m, user, 1), reflectionOf(m, user, 2)});
  };
  add({});
  for (const MeshMaterial& m : scene.mesh.materials) add(m);

  const int channels = gray_ ? 1 : 3;
  for (int c = 0; c < channels; ++c) I_[c].assign(faces().size(), 0.0);
  GiveUpNowAndThen giveUp;
  for (std::size_t k = 0; k < faces().size(); ++k) {
    giveUp();
    if (faces()[k] == kNothing) continue;
    const glm::dvec3 I = illumination(place(k), picture().snapped().faces[faces()[k]]);
    for (int c = 0; c < channels; ++c) I_[c][k] = std::clamp(I[c], 0.0, 1.0);
  }
}

glm::dvec3 Reference::illumination(const SurfacePlace& place, const SnappedFace& face) const {
  const Illumination& user = picture().settings().light;
  const Scene& scene = picture().scene();
  const Rgb& material = materials_[scene.mesh.material[face.number] + 1];
  const glm::dvec3 N = face.back && user.twoSided ? -place.N : place.N;
  const glm::dvec3 V = unit(picture().camera().eye - place.origin - place.at);
  const glm::dvec3 texel = this->texel(place, face.number);
  const int channels = gray_ ? 1 : 3;
  glm::dvec3 I{0.0};
  for (int c = 0; c < channels; ++c) I[c] = rowOf(user.mistake).ambient * Ia_[c] * material[c].ka;
  for (const Light& light : lights_) {
    const bool directional = light.kind == LightKind::Directional;
    const glm::dvec3 towards = directional ? light.direction : light.position - place.origin - place.at;
    const glm::dvec3 L = unit(towards);
    const double fatt = directional ? 1.0 : attenuation(light, glm::dot(towards, L), scene.light.unit);
    const double f = fatt * spotShare(light, L);
    for (int c = 0; c < channels; ++c) {
      const LightTerms terms = lightTerms(user.mistake, f, light.Ip[c], material[c], {N, L, V}, user.form);
      I[c] += terms.diffuse * texel[c] + terms.specular;
    }
  }
  return I;
}

glm::dvec3 Reference::texel(const SurfacePlace& place, int face) const {
  const Mesh& mesh = picture().scene().mesh;
  const int material = mesh.material[face];
  if (material < 0 || mesh.materials[material].texture < 0 || mesh.uvOfCorner.empty()) return glm::dvec3{1.0};
  for (int corner = mesh.firstCorner[face]; corner < mesh.firstCorner[face + 1]; ++corner)
    if (mesh.uvOfCorner[corner] < 0) return glm::dvec3{1.0};
  glm::dvec2 uv{0.0};
  for (int k = 0; k < 3; ++k) uv += place.share[k] * mesh.uv[mesh.uvOfCorner[place.corner[k]]];
  const Texture& texture = picture().scene().textures[mesh.materials[material].texture];
  const auto index = [](double share, int size) {  // share in [0, 1]
    return std::min(static_cast<int>(share * size), size - 1);
  };
  // v runs up the columns, and rows run down. The texture repeats.
  const int column = index(uv.x - std::floor(uv.x), texture.width);
  const int row = index(1.0 - (uv.y - std::floor(uv.y)), texture.height);
  const auto at = static_cast<std::size_t>(row) * texture.width + column;
  glm::dvec3 result;
  for (int c = 0; c < 3; ++c) result[c] = texture.channel[c][at] / 255.0;
  return result;
}

}  // namespace xnewell
