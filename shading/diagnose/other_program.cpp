#include "shading/diagnose/other_program.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/view/screen_grid.h"

namespace xnewell {

namespace {

constexpr std::array<double, 3> kNoTexel{1, 1, 1};

glm::dvec3 unitVector(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : v;
}

double clamped01(double v) { return std::clamp(v, 0.0, 1.0); }

double clampedBy(ClampWay way, double cosine) {
  switch (way) {
    case ClampWay::Positive:
      return std::max(0.0, cosine);
    case ClampWay::Signed:
      return cosine;
    case ClampWay::Absolute:
      return std::abs(cosine);
    case ClampWay::ByAngle:
      return std::max(0.0, 1.0 - std::acos(std::clamp(cosine, -1.0, 1.0)) / (std::numbers::pi / 2));
  }
  return cosine;
}

/// v^n, as far as a picture can tell.
double toThe(double v, double n) { return std::clamp(n == 0.0 ? 1.0 : std::pow(v, n), -1e6, 1e6); }

/// What a spot's cone leaves of the light in direction -L.
double coneShare(const Light& light, const glm::dvec3& L) {
  if (light.kind != LightKind::Spot) return 1.0;
  const double degree = std::numbers::pi / 180, cosine = -glm::dot(unitVector(light.direction), L);
  const double inner = std::cos(light.inner * degree), outer = std::cos(light.outer * degree);
  if (cosine >= inner) return 1.0;
  if (cosine <= outer) return 0.0;
  return toThe((cosine - outer) / (inner - outer), light.falloff);
}

/// The number, or the one that takes its place.
double numberOr(const Approach& way, NumberOf which, double v) {
  return way.number && way.number->which == which && way.number->was == v ? way.number->is : v;
}

TableSettings tableOf(const Approach& way, TableSettings table) {
  table.kind = way.table.value_or(table.kind);
  table.I0 = numberOr(way, NumberOf::I0, table.I0);
  return table;
}

}  // namespace

OtherProgram::OtherProgram(OtherModel& model, const Approach& way)
    : model_{model},
      way_{way},
      table_{tableOf(way, model.picture().settings().table)},
      faces_(2 * static_cast<std::size_t>(model.mesh().faceCount())),
      corners_(2 * model.mesh().corners.size()) {}

double OtherProgram::fade(const Light& light, double d) const {
  if (light.kind == LightKind::Directional) return 1.0;
  const double scene = d / model_.unit;
  double f = 1.0;
  switch (light.attenuation) {
    case Attenuation::None:
      break;
    case Attenuation::Inverse:
      f = 1.0 / d;
      break;
    case Attenuation::InverseSquare:
      f = 1.0 / (d * d);
      break;
    case Attenuation::Linear:
      f = std::max(0.0, 1.0 - scene / light.range);
      break;
    case Attenuation::Textbook:
      f = 1.0 / (light.c.x + light.c.y * scene + light.c.z * scene * scene);
      break;
  }
  if (way_.fade == FadeWay::Forgotten) return 1.0;
  if (way_.fade == FadeWay::Inverse) f = 1.0 / d;
  if (way_.fade == FadeWay::InverseSquare) f = 1.0 / (d * d);
  return way_.fade == FadeWay::NoLimit ? f : std::min(1.0, f);
}

void OtherProgram::addLight(LitPlace& sum, const Light& light, const glm::dvec3& P, const glm::dvec3& N,
                            const glm::dvec3& V, const std::array<Reflection, 3>& surface) const {
  const bool far = light.kind == LightKind::Directional;
  const auto changed = [&](glm::dvec3 v) {
    v *= way_.lightSigns;
    return way_.swapsLightYz ? glm::dvec3{v.x, v.z, v.y} : v;
  };
  const glm::dvec3 place = changed(far ? light.direction : light.position);
  glm::dvec3 towards = far ? place : place - P;
  double d = glm::length(towards);
  if (!far && way_.light == TowardsLight::Constant) towards = place - model_.centre, d = glm::length(towards);
  if (far && way_.light == TowardsLight::DirectionAsPlace) towards = place - P;
  if (!far && way_.light == TowardsLight::PlaceAsDirection) towards = place;
  if (!far && way_.light == TowardsLight::FarPlace) towards = place, d = glm::length(place);
  const glm::dvec3 unitL = unitVector(towards);
  glm::dvec3 L = way_.light == TowardsLight::NotUnit ? towards : unitL;
  if (way_.light == TowardsLight::Away) L = -L;
  const double cone = far ? 1.0 : coneShare(light, unitVector(place - P));
  const double f = fade(light, d) * cone;

  const double NL = glm::dot(N, L), facing = clampedBy(way_.facing, NL);
  const double inR = way_.facingFlowsOn ? facing : NL;
  const Form form = model_.picture().settings().light.form;
  CosineWay which = way_.cosine;
  if (which == CosineWay::AsAsked && form == Form::HalfVector) which = CosineWay::Halfway;
  if (which == CosineWay::AsAsked && form == Form::Tutorial) which = CosineWay::Facing;
  double RV = 0.0;
  switch (which) {
    case CosineWay::AsAsked:
      RV = glm::dot(2.0 * inR * N - L, V);
      break;
    case CosineWay::Reversed:
      RV = glm::dot(L - 2.0 * inR * N, V);
      break;
    case CosineWay::Without2:
      RV = glm::dot(inR * N - L, V);
      break;
    case CosineWay::PlusL:
      RV = glm::dot(2.0 * inR * N + L, V);
      break;
    case CosineWay::Halfway:
      RV = glm::dot(N, unitVector(L + V));
      break;
    case CosineWay::Facing:
      RV = NL;
      break;
  }
  if (std::isnan(sum.NdotL)) sum.NdotL = NL, sum.RdotV = RV;
  const double counted = clampedBy(way_.reflected, RV);
  const bool shines = inR > 0.0 || way_.highlightBehind;
  for (int c = 0; c < model_.channels; ++c) {
    const Reflection& s = surface[c];
    const double n = s.n * way_.nTimes;
    double Ip = numberOr(way_, NumberOf::Ip, light.Ip[c]), IpOfHighlight = Ip;
    if (way_.Ip == IpWay::Forgotten) Ip = IpOfHighlight = 1.0;
    if (way_.Ip == IpWay::OnDiffuse) IpOfHighlight = 1.0;
    if (way_.power == PowerWay::OfSum) {
      sum.diffuse[c] += f * Ip * toThe(s.kd * facing + (shines ? s.ks * counted : 0.0), n);
      continue;
    }
    sum.diffuse[c] += way_.diffuse * f * Ip * s.kd * facing;
    if (!shines) continue;
    double highlight = s.ks * toThe(counted, n);
    if (way_.power == PowerWay::Forgotten) highlight = s.ks * counted;
    if (way_.power == PowerWay::WithKs) highlight = toThe(s.ks * counted, n);
    if (way_.highlightTimesFacing) highlight *= facing;
    sum.rest[c] += way_.specular * f * IpOfHighlight * highlight;
  }
}

LitPlace OtherProgram::lit(const glm::dvec3& P, const glm::dvec3& N, int material) const {
  std::array<Reflection, 3> surface = model_.surface[material + 1];
  for (Reflection& s : surface) {
    s.ka = numberOr(way_, NumberOf::ka, s.ka), s.ks = numberOr(way_, NumberOf::ks, s.ks);
    s.kd = numberOr(way_, NumberOf::kd, s.kd);
    s.n = static_cast<decltype(s.n)>(numberOr(way_, NumberOf::n, s.n));
    const double whole = s.kd;
    if (way_.swapsKaKd) s.kd = s.ka, s.ka = whole;
    if (way_.swapsKdKs) s.kd = s.ks, s.ks = whole;
    if (way_.noKa) s.ka = 1.0;
  }
  glm::dvec3 towards = model_.eye - P;
  if (way_.eye == TowardsEye::Constant) towards = model_.eye - model_.lookAt;
  if (way_.eye == TowardsEye::PlaceOfEye) towards = model_.eye;
  glm::dvec3 V = way_.eye == TowardsEye::NotUnit ? towards : unitVector(towards);
  if (way_.eye == TowardsEye::Away) V = -V;
  LitPlace sum;
  for (int c = 0; c < model_.channels; ++c)
    sum.rest[c] = way_.ambient * surface[c].ka * numberOr(way_, NumberOf::Ia, model_.Ia[c]);
  if (way_.fade == FadeWay::OnAmbient)
    for (const Light& light : model_.lights) {
      const double f = fade(light, glm::length(light.position - P));
      for (double& ambient : sum.rest) ambient *= f;
    }
  const bool away = way_.turnsByV && way_.twoSided && glm::dot(N, V) < 0.0;
  for (const Light& light : model_.lights) addLight(sum, light, P, away ? -N : N, V, surface);
  return sum;
}

const LitPlace& OtherProgram::ofFace(int face, bool back) {
  std::optional<LitPlace>& known = faces_[2 * static_cast<std::size_t>(face) + back];
  if (!known)
    known = lit(model_.centroid(face, way_.centroid), side(back) * model_.faceNormal(face, way_.normal),
                model_.mesh().material[face]);
  return *known;
}

LitPlace OtherProgram::meanOfFaces(int point) {
  LitPlace mean;
  const std::vector<int>& faces = model_.facesAt()[point];
  for (const int face : faces) {
    const LitPlace& one = ofFace(face, model_.isBack(face));
    for (int c = 0; c < 3; ++c)
      mean.rest[c] += one.rest[c] / static_cast<double>(faces.size()),
          mean.diffuse[c] += one.diffuse[c] / static_cast<double>(faces.size());
  }
  return mean;
}

const LitPlace& OtherProgram::atCorner(int face, int corner, bool back) {
  std::optional<LitPlace>& known = corners_[2 * static_cast<std::size_t>(corner) + back];
  if (!known && way_.meansOfFaces) known = meanOfFaces(model_.mesh().corners[corner]);
  if (!known)
    known = lit(model_.place(corner), side(back) * model_.cornerNormals(way_.vertex, way_.normal)[corner],
                model_.mesh().material[face]);
  return *known;
}

LitPlace OtherProgram::gouraud(const SnappedFace& face, const InTriangle& in, bool clamps) {
  LitPlace sum;
  for (int k = 0; k < 3; ++k) {
    const LitPlace& corner = atCorner(face.number, in.corner[k], face.back);
    if (k == 0) sum.NdotL = corner.NdotL, sum.RdotV = corner.RdotV;
    for (int c = 0; c < model_.channels; ++c) {
      if (clamps) {
        sum.rest[c] += in.onScreen[k] * clamped01(corner.rest[c] + corner.diffuse[c]);
        continue;
      }
      sum.rest[c] += in.onScreen[k] * corner.rest[c];
      sum.diffuse[c] += in.onScreen[k] * corner.diffuse[c];
    }
  }
  return sum;
}

LitPlace OtherProgram::alongRow(const SnappedFace& face, int i, int j, bool clamps) {
  const SnappedScene& scene = model_.snapped();
  const double y = j + 0.5, x = i + 0.5;
  struct Crossing {
    double x = 0;
    std::array<double, 3> I{};
  };
  std::vector<Crossing> ends;
  for (int k = 0; k < face.count; ++k) {
    const int a = face.first + k, b = face.first + (k + 1) % face.count;
    const glm::dvec2 p{scene.vertices[a].x / double{kGrid}, scene.vertices[a].y / double{kGrid}};
    const glm::dvec2 q{scene.vertices[b].x / double{kGrid}, scene.vertices[b].y / double{kGrid}};
    if ((p.y <= y) == (q.y <= y)) continue;
    const double t = (y - p.y) / (q.y - p.y);
    const LitPlace &A = atCorner(face.number, scene.source[a], face.back),
                   &B = atCorner(face.number, scene.source[b], face.back);
    Crossing here{p.x + t * (q.x - p.x), {}};
    for (int c = 0; c < model_.channels; ++c) {
      const double first = A.rest[c] + A.diffuse[c], second = B.rest[c] + B.diffuse[c];
      here.I[c] = clamps ? clamped01(first) + t * (clamped01(second) - clamped01(first))
                         : first + t * (second - first);
    }
    ends.push_back(here);
  }
  LitPlace sum;
  if (ends.size() < 2) return sum;
  const double width = ends[1].x - ends[0].x, t = width != 0.0 ? (x - ends[0].x) / width : 0.5;
  for (int c = 0; c < model_.channels; ++c) sum.rest[c] = ends[0].I[c] + t * (ends[1].I[c] - ends[0].I[c]);
  return sum;
}

LitPlace OtherProgram::phong(const SnappedFace& face, const InTriangle& in) {
  const std::vector<glm::dvec3>& normals = model_.cornerNormals(way_.vertex, way_.normal);
  const auto& weights = way_.onScreen || way_.longNormals ? in.onScreen : in.inWorld;
  const bool isLong =
      way_.longNormals || way_.normal == NormalWay::Newell || way_.normal == NormalWay::CornerProduct;
  glm::dvec3 P{0.0}, N{0.0};
  for (int k = 0; k < 3; ++k) {
    P += (way_.onScreen ? in.onScreen : in.inWorld)[k] * model_.place(in.corner[k]);
    N += weights[k] * normals[in.corner[k]];
  }
  return lit(P, side(face.back) * (isLong ? N : unitVector(N)), model_.mesh().material[face.number]);
}

double OtherProgram::intensity(const LitPlace& place, const std::array<double, 3>& texel) const {
  std::array<double, 3> I{};
  for (int c = 0; c < model_.channels; ++c) I[c] = place.rest[c] + place.diffuse[c] * texel[c];
  if (model_.channels == 1) return I[0];
  if (!way_.cellWraps)
    for (double& v : I) v = clamped01(v);
  return 0.30 * I[0] + 0.59 * I[1] + 0.11 * I[2];
}

bool OtherProgram::canShow(int face) const {
  const SnappedFace& f = model_.snapped().faces[face];
  for (int k = 0; k < f.count; ++k)
    if (model_.snapped().source[f.first + k] < 0) return way_.method == Shading::Flat;
  return true;
}

/// Where each hue has a ramp: the shade of the brightest channel of the hue, and what its cell holds.
void OtherProgram::onRamp(ShownHere& shown, const std::array<double, 3>& I, const ColorTable& table) {
  const glm::dvec3& hue = table.settings().hue;
  int brightest = 0;
  for (int c = 1; c < 3; ++c)
    if (hue[c] > hue[brightest]) brightest = c;
  const int j = table.shade(I[brightest]), last = table.shades() - 1;
  const Rgb16 held = table.color(j);
  shown.value = {double(held.r >> 8), double(held.g >> 8), double(held.b >> 8)};
  const int low = std::max(0, j - 1), high = std::min(last, j + 1);
  shown.step = std::max(1.0, 255.0 * (table.level(high) - table.level(low)) / (high - low));
}

ShownHere OtherProgram::at(int face, int i, int j) {
  const SnappedFace& f = model_.snapped().faces[face];
  const int material = model_.mesh().material[f.number];
  const bool textured = material >= 0 && model_.mesh().materials[material].texture >= 0;
  const bool clamps = !way_.clampsLate && !way_.cellWraps && !textured;
  ShownHere shown;
  LitPlace place;
  InTriangle in;
  const bool smooth = way_.method == Shading::Gouraud || way_.method == Shading::Phong;
  if (smooth || textured) in = triangle(f, i, j);
  if (way_.method == Shading::Flat) place = ofFace(f.number, f.back);
  if (way_.method == Shading::Gouraud)
    place = way_.byRows && !textured && f.count > 3 ? alongRow(f, i, j, clamps) : gouraud(f, in, clamps);
  if (way_.method == Shading::Phong) place = phong(f, in);
  if (way_.method == Shading::Depth) place.rest.fill(model_.byDepth[face]);
  std::array<double, 3> share = kNoTexel;
  if (textured)
    if (const auto t = texel(f, in)) {
      const Texture& texture = model_.picture().scene().textures[model_.mesh().materials[material].texture];
      const std::size_t k = static_cast<std::size_t>(t->y) * texture.width + t->x;
      for (int c = 0; c < 3; ++c)
        share[c] = (model_.channels == 3 ? texture.channel[c][k] : texture.gray[k]) / 255.0;
    }
  shown.NdotL = place.NdotL, shown.RdotV = place.RdotV;
  shown.I = intensity(place, share);
  if (model_.colors) {
    std::array<double, 3> I{};
    for (int c = 0; c < 3; ++c) I[c] = clamped01(place.rest[c] + place.diffuse[c] * share[c]);
    if (model_.ramps && way_.store < StoreWay::By255)
      onRamp(shown, I, model_.picture().colors().tableOf(material));
    else
      for (int c = 0; c < 3; ++c)
        shown.value[c] = way_.store < StoreWay::By255 ? 255.0 * I[c] : withoutTable(I[c]);
    return shown;
  }
  shown.cell = cellOf(shown.I);
  if (way_.cellsBetween && way_.method == Shading::Gouraud && !textured) {
    double between = 0.0;
    for (int k = 0; k < 3; ++k)
      between += in.onScreen[k] * cellOf(intensity(atCorner(f.number, in.corner[k], f.back), kNoTexel));
    shown.cell = static_cast<int>(std::floor(between + 0.5));
  }
  if (way_.store >= StoreWay::By255) {
    shown.value[0] = withoutTable(shown.I);
    return shown;
  }
  shown.value[0] = stored(shown.cell);
  const int j0 = std::clamp(shown.cell - table_.first(), 1, table_.shades() - 2);
  shown.step = std::max(1.0, 255.0 * (table_.level(j0 + 1) - table_.level(j0 - 1)) / 2);
  return shown;
}

}  // namespace xnewell
