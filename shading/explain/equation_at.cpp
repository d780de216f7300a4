#include "shading/explain/equation_at.h"

#include <glm/geometric.hpp>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"
#include "geometry/view/stages.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

double sumOver(const std::vector<ExplainedLight>& lights, ByChannel ExplainedLight::*term, int channel) {
  double sum = 0.0;
  for (const ExplainedLight& light : lights) sum += (light.*term)[channel];
  return sum;
}

}  // namespace

double ExplainedEquation::diffuse(int channel) const {
  return sumOver(lights, &ExplainedLight::diffuse, channel);
}

double ExplainedEquation::specular(int channel) const {
  return sumOver(lights, &ExplainedLight::specular, channel);
}

EquationAt::EquationAt(const Surfaces& s, int material)
    : user_{s.settings.light}, lighting_{s.shading.lighting()}, unit_{s.scene.light.unit} {
  const Box box = boxOf(s.scene.mesh.points);
  centre_ = box.centre();
  if (!lighting_.onlyAmbient()) lights_ = lightsOf(s.scene, user_);
  const Material& m = lighting_.materials[material];
  const glm::dvec3 Ia = ambientOf(s.scene.light, user_);
  for (int c = 0; c < lighting_.channels; ++c) {
    everywhere_.Ia[c] = lighting_.channels == 3 ? Ia[c] : luminance(Ia);
    everywhere_.ambient[c] = m.ambient[c];
    everywhere_.surface[c] = {.ka = m.ka[c], .kd = m.kd[c], .ks = m.ks[c], .n = m.n};
  }
}

ExplainedEquation EquationAt::evaluate(const glm::dvec3& P, const glm::dvec3& N, const ByChannel& texel,
                                       const glm::dmat3* derivative) const {
  ExplainedEquation at = everywhere_;
  at.P = P, at.N = derivative ? carriedNormal(*derivative, N) : N;
  at.V = user_.constantV ? lighting_.farV : unit(lighting_.eye - P);
  if (derivative) at.V = carried(*derivative, at.V);
  at.I = at.ambient;
  for (const Light& light : lights_) {
    at.lights.push_back(explained(light, at, texel, derivative));
    for (int c = 0; c < lighting_.channels; ++c)
      at.I[c] += at.lights.back().diffuse[c] + at.lights.back().specular[c];
  }
  // L counts for itself: there may be several.
  const EquationVectors said = taken(rowOf(lighting_.mistake), {at.N, glm::dvec3{0.0}, at.V});
  at.N = said.N, at.V = said.V;
  return at;
}

ExplainedLight EquationAt::explained(const Light& light, const ExplainedEquation& at, const ByChannel& texel,
                                     const glm::dmat3* derivative) const {
  ExplainedLight e;
  const bool directional = light.kind == LightKind::Directional;
  const glm::dvec3 towards = directional       ? light.direction
                             : user_.constantL ? light.position - centre_
                                               : light.position - at.P;
  e.L = unit(towards);
  if (!directional) {
    e.fatt = attenuation(light, glm::dot(towards, e.L), unit_);
    const glm::dvec3 ownL = unit(light.position - at.P);
    e.spot = spotShare(light, ownL);
    if (user_.constantL && light.kind == LightKind::Spot) e.ownL = ownL;
  }
  if (derivative) e.L = carried(*derivative, e.L);
  const EquationVectors vectors{at.N, e.L, at.V};
  for (int c = 0; c < lighting_.channels; ++c) {
    e.Ip[c] = lighting_.channels == 3 ? light.Ip[c] : luminance(light.Ip);
    const LightTerms terms =
        lightTerms(lighting_.mistake, e.fatt * e.spot, e.Ip[c], at.surface[c], vectors, user_.form);
    e.diffuse[c] = terms.diffuse * texel[c];
    e.specular[c] = terms.specular;
    if (c > 0) continue;  // the vectors and cosines are the same in every channel
    e.L = terms.at.L, e.R = terms.R;
    e.NdotL = terms.NdotL, e.cosine = terms.cosine;
    e.facing = terms.facing, e.counted = terms.counted, e.power = terms.power;
  }
  return e;
}

}  // namespace xnewell
