#include "shading/explain/equation_at.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geometry/exact/box.h"
#include "geometry/exact/power.h"
#include "geometry/exact/unit.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

/// R, H or L: the vector whose cosine `form` takes.
glm::dvec3 vectorOf(Form form, const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V) {
  switch (form) {
    case Form::Textbook:
      return 2.0 * N * glm::dot(N, L) - L;
    case Form::HalfVector:
      return unit(L + V);
    case Form::Tutorial:
      break;
  }
  return L;
}

}  // namespace

EquationAt::EquationAt(const Surfaces& s, int material)
    : user_{s.settings.light}, lighting_{s.shading.lighting()}, unit_{s.scene.light.unit} {
  const Box box = boxOf(s.scene.mesh.points);
  centre_ = box.centre();
  if (!lighting_.onlyAmbient()) lights_ = lightsOf(s.scene, user_);
  const Material& m = lighting_.materials[material];
  const glm::dvec3 Ia = s.scene.light.Ia.value_or(glm::dvec3{user_.Ia});
  for (int c = 0; c < lighting_.channels; ++c) {
    everywhere_.Ia[c] = lighting_.channels == 3 ? Ia[c] : luminance(Ia);
    everywhere_.ambient[c] = m.ambient[c];
    const double ka = everywhere_.Ia[c] > 0.0 ? m.ambient[c] / everywhere_.Ia[c] : 0.0;
    everywhere_.surface[c] = {.ka = ka, .kd = m.kd[c], .ks = m.ks[c], .n = m.n};
  }
}

ExplainedEquation EquationAt::operator()(const glm::dvec3& P, const glm::dvec3& N,
                                         const ByChannel& texel) const {
  ExplainedEquation at = everywhere_;
  at.P = P, at.N = N;
  at.V = user_.constantV ? lighting_.farV : unit(lighting_.eye - P);
  at.I = at.ambient;
  for (const Light& light : lights_) {
    at.lights.push_back(explained(light, at, texel));
    for (int c = 0; c < lighting_.channels; ++c)
      at.I[c] += at.lights.back().diffuse[c] + at.lights.back().specular[c];
  }
  return at;
}

ExplainedLight EquationAt::explained(const Light& light, const ExplainedEquation& at,
                                     const ByChannel& texel) const {
  ExplainedLight e;
  const bool directional = light.kind == LightKind::Directional;
  // A light with the same L everywhere has that of the scene's centre. The cone of a spot stays where it is.
  const glm::dvec3 towards = directional       ? light.direction
                             : user_.constantL ? light.position - centre_
                                               : light.position - at.P;
  e.L = unit(towards);
  if (!directional) {
    e.fatt = attenuation(light, glm::dot(towards, e.L), unit_);
    e.spot = spotShare(light, unit(light.position - at.P));
  }
  e.NdotL = glm::dot(at.N, e.L);
  e.R = vectorOf(user_.form, at.N, e.L, at.V);
  e.cosine = specularCosine(user_.form, at.N, e.L, at.V);
  if (e.NdotL > 0.0) e.power = power(std::clamp(e.cosine, 0.0, 1.0), at.surface[0].n);
  for (int c = 0; c < lighting_.channels; ++c) {
    e.Ip[c] = lighting_.channels == 3 ? light.Ip[c] : luminance(light.Ip);
    const IlluminationTerms terms = termsOf(0.0, e.Ip[c], e.fatt, e.spot, at.surface[c], e.NdotL, e.cosine);
    e.diffuse[c] = terms.diffuse * texel[c];
    e.specular[c] = terms.specular;
  }
  return e;
}

}  // namespace xnewell
