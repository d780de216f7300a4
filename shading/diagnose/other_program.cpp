#include "shading/diagnose/other_program.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/exact/scale.h"
#include "geometry/view/screen_plane.h"
#include "shading/fill/row_values.h"

namespace xnewell {

namespace {

constexpr std::array<double, 3> kNoTexel{1, 1, 1};

double clamped01(double v) { return std::clamp(v, 0.0, 1.0); }

/// What the picture has of an intensity.
double toned(SumWay way, double I) {
  if (way == SumWay::Tone) return I / (1.0 + std::max(0.0, I));
  if (way == SumWay::Exponential) return 1.0 - std::exp(-I);
  return way == SumWay::Whole ? std::floor(std::min(1.0, I)) : I;
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
      way_{way.with(model.picture().settings())},
      places_{model.placesOf(way.view)},
      table_{tableOf(way_, model.picture().settings().table)} {}

double OtherProgram::fade(Light light, double d) const {
  if (light.kind == LightKind::Directional) return 1.0;
  light.attenuation = way_.fade.value_or(light.attenuation);
  return attenuation(light, d / model_.unit, 1.0 / model_.unit, !way_.fadesAbove1);
}

void OtherProgram::addLight(LitPlace& sum, const Light& light, const glm::dvec3& P, const glm::dvec3& N,
                            const glm::dvec3& V, const std::array<Reflection, 3>& surface) const {
  const bool far = light.kind == LightKind::Directional;
  glm::dvec3 place = way_.lightSigns * (far ? light.direction : light.position);
  if (way_.swapsLightYz) std::swap(place.y, place.z);
  glm::dvec3 towards = far ? place : place - P;
  double d = glm::length(towards);
  if (!far && way_.light == TowardsLight::Constant) towards = place - model_.centre, d = glm::length(towards);
  if (far && way_.light == TowardsLight::DirectionAsPlace) towards = place - P;
  if (!far && way_.light == TowardsLight::PlaceAsDirection) towards = place;
  if (!far && way_.light == TowardsLight::FarPlace) towards = place, d = glm::length(place);
  if (way_.light == TowardsLight::NotMoved) towards = model_.notMoved(place, far, P);
  const glm::dvec3 L = way_.light == TowardsLight::NotUnit ? towards : unit(towards);
  const double f = fade(light, d) * spotShare(light, unit(place - P));
  for (int c = 0; c < model_.channels; ++c) {
    const LightTerms terms = lightTerms(way_.equation, f, numberOr(way_, NumberOf::Ip, light.Ip[c]),
                                        surface[c], {N, L, V}, *way_.form);
    sum.diffuse[c] += terms.diffuse, sum.rest[c] += terms.specular;
    sum.isLit |= terms.NdotL > 0.0;
    if (std::isnan(sum.NdotL)) sum.NdotL = terms.NdotL, sum.RdotV = terms.cosine;
  }
}

LitPlace OtherProgram::lit(const glm::dvec3& P, const glm::dvec3& N, int material) const {
  std::array<Reflection, 3> surface = model_.surface[material + 1];
  for (Reflection& s : surface) {
    s.ka = numberOr(way_, NumberOf::ka, s.ka), s.ks = numberOr(way_, NumberOf::ks, s.ks);
    s.kd = numberOr(way_, NumberOf::kd, s.kd);
    s.n = static_cast<int>(way_.nTimes * numberOr(way_, NumberOf::n, s.n));
    if (way_.swapsKaKd) std::swap(s.ka, s.kd);
    if (way_.noKa) s.ka = 1.0;
  }
  glm::dvec3 towards = model_.eye - P;
  if (way_.eye == TowardsEye::Constant) towards = model_.eye - model_.lookAt;
  if (way_.eye == TowardsEye::PlaceOfEye) towards = model_.eye;
  if (way_.eye == TowardsEye::FromLookAt) towards = model_.lookAt - P;
  const glm::dvec3 V = way_.eye == TowardsEye::NotUnit ? towards : unit(towards);
  std::array<double, 3> ambient{};
  for (int c = 0; c < model_.channels; ++c)
    ambient[c] = way_.equation.ambient * surface[c].ka * numberOr(way_, NumberOf::Ia, model_.Ia[c]);
  if (way_.ambientFades)
    for (const Light& light : model_.lights) {
      const double f = fade(light, glm::length(light.position - P));
      for (double& one : ambient) one *= f;
    }
  LitPlace sum;
  for (const Light& light : model_.lights) addLight(sum, light, P, N, V, surface);
  for (int c = 0; c < model_.channels; ++c) {
    double &rest = sum.rest[c], &diffuse = sum.diffuse[c];
    if (way_.sum == SumWay::Largest || way_.sum == SumWay::LargerOfLight) {
      rest = std::max(diffuse, rest), diffuse = 0.0;
      if (way_.sum == SumWay::Largest) rest = std::max(0.0, rest - ambient[c]);
    }
    if (!way_.ambientInTheDark || !sum.isLit) rest += ambient[c];
  }
  return sum;
}

/// Flat shading of one of the triangles into which a polygon was cut.
LitPlace OtherProgram::ofTriangle(const SnappedFace& face, const InTriangle& in) const {
  const glm::dvec3 &a = model_.place(in.corner[0]), &b = model_.place(in.corner[1]),
                   &c = model_.place(in.corner[2]);
  glm::dvec3 N = unit(glm::cross(b - a, c - a));
  if (glm::dot(N, model_.faceNormal(face.number, NormalWay::Unit)) < 0.0) N = -N;  // its outline is reversed
  return lit((a + b + c) / 3.0, side(face.back) * N, model_.mesh().material[face.number]);
}

const LitPlace& OtherProgram::ofFace(int face, bool back) {
  const auto [at, isNew] = faces_.try_emplace(2 * static_cast<std::size_t>(face) + back);
  if (isNew)
    at->second =
        lit(model_.centroid(face, way_.centroid),
            side(back) * model_.faceNormal(face, way_.normal, way_.threeFrom), model_.mesh().material[face]);
  return at->second;
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
  const auto [at, isNew] = corners_.try_emplace(2 * static_cast<std::size_t>(corner) + back);
  if (isNew)
    at->second = way_.meansOfFaces
                     ? meanOfFaces(model_.mesh().corners[corner])
                     : lit(model_.place(corner), side(back) * model_.cornerNormals(way_)[corner],
                           model_.mesh().material[face]);
  return at->second;
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
  const int* const corner = &model_.snapped().source[face.first];
  std::vector<glm::ivec3> outline;
  for (int k = 0; k < face.count; ++k)
    outline.emplace_back(glm::round(*places_.onScreen[corner[k]] * double{kGrid}), 0);
  LitPlace sum;
  for (int c = 0; c < model_.channels; ++c) {
    std::vector<double> I;
    for (int k = 0; k < face.count; ++k) {
      const LitPlace& at = atCorner(face.number, corner[k], face.back);
      I.push_back(clamps ? clamped01(at.rest[c] + at.diffuse[c]) : at.rest[c] + at.diffuse[c]);
    }
    sum.rest[c] = RowValues{outline.data(), face.count, std::move(I)}.at(i, j);
  }
  return sum;
}

LitPlace OtherProgram::phong(const SnappedFace& face, const InTriangle& in) {
  const std::vector<glm::dvec3>& normals = model_.cornerNormals(way_);
  const auto& weights = way_.onScreen || way_.longNormals ? in.onScreen : in.inWorld;
  const bool isLong = way_.longNormals || way_.normal == NormalWay::Newell ||
                      way_.normal == NormalWay::CornerProduct || way_.normal == NormalWay::Scaled;
  glm::dvec3 P{0.0}, N{0.0};
  for (int k = 0; k < 3; ++k) {
    P += (way_.onScreen ? in.onScreen : in.inWorld)[k] * model_.place(in.corner[k]);
    N += weights[k] * normals[in.corner[k]];
  }
  return lit(P, side(face.back) * (isLong ? N : unit(N)), model_.mesh().material[face.number]);
}

double OtherProgram::intensity(const LitPlace& place, const std::array<double, 3>& texel) const {
  std::array<double, 3> I{};
  for (int c = 0; c < model_.channels; ++c) I[c] = place.rest[c] + place.diffuse[c] * texel[c];
  for (double& v : I) v = toned(way_.sum, v);
  if (model_.channels == 1) return I[0];
  if (!way_.cellWraps)
    for (double& v : I) v = clamped01(v);
  return 0.30 * I[0] + 0.59 * I[1] + 0.11 * I[2];
}

bool OtherProgram::isWhole(const SnappedFace& f) const {
  const auto source = model_.snapped().source.begin() + f.first;
  return std::all_of(source, source + f.count,
                     [&](int corner) { return corner >= 0 && places_.onScreen[corner]; });
}

bool OtherProgram::canShow(int face) const {
  return way_.method == Shading::Flat || isWhole(model_.snapped().faces[face]);
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
  const Texture* const textured = textureOf(f.number);
  const bool clamps = !way_.clampsLate && !way_.cellWraps && way_.sum < SumWay::Tone && !textured;
  ShownHere shown;
  LitPlace place;
  InTriangle in;
  // What clipping has cut is not known between its corners, and is shown flat.
  const bool whole = isWhole(f);
  const Shading method = whole || way_.method == Shading::Depth ? *way_.method : Shading::Flat;
  if (whole) in = triangle(f, i, j);
  if (method == Shading::Flat)
    place = whole && way_.centroid == CentroidWay::OfTriangle ? ofTriangle(f, in) : ofFace(f.number, f.back);
  if (method == Shading::Gouraud)
    place = way_.byRows && !textured && f.count > 3 ? alongRow(f, i, j, clamps) : gouraud(f, in, clamps);
  if (method == Shading::Phong) place = phong(f, in);
  if (way_.method == Shading::Depth) place.rest.fill(model_.byDepth[face]);
  std::array<double, 3> share = kNoTexel;
  if (textured)
    for (int c = 0; c < 3; ++c)
      share[c] = (model_.channels == 3 ? textured->channel[c] : textured->gray)[texel(*textured, in)] / 255.0;
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

/// From an intensity to a cell and to what is stored there, right or with a mistake.

namespace {

double nearestWhole(double v) { return std::floor(v + 0.5); }

}  // namespace

/// The cell before it is rounded, counted from the first.
double OtherProgram::realCell(double I) const {
  const TableSettings& s = table_.settings();
  const int last = table_.shades() - 1;
  const double lnR = std::log(1.0 / s.I0) / last;
  const double ratios = I > 0.0 ? std::max(0.0, std::log(I / s.I0) / lnR) : 0.0;
  const CellWay way = way_.cell;
  if (way == CellWay::By240) return (last + 1) * I;
  if (way == CellWay::By255) return 255.0 * I;
  if (way == CellWay::Ratio240) return ratios * (last + 1) / last;
  if (way == CellWay::Ratio64) return ratios * 63 / last;
  if (way == CellWay::NaturalLog) return ratios * lnR;
  if (way == CellWay::NoI0) return 0.0;
  if (way == CellWay::NoI0Wraps) return I > 0.0 ? std::log(I) / lnR : 0.0;
  if (way == CellWay::Even || (isEven(s.kind) && way != CellWay::Ratios)) return last * I;
  return s.pick == Pick::Log || way == CellWay::Ratios ? ratios : table_.shade(I);
}

int OtherProgram::cellOf(double I) const {
  const double in = way_.cellWraps ? std::max(0.0, I) : std::clamp(I, 0.0, 1.0);
  const double real = realCell(in);
  double cell = table_.first() + (way_.cell == CellWay::Truncated ? std::floor(real) : nearestWhole(real));
  if (way_.cell == CellWay::OneLess) cell -= 1;
  if (way_.cell == CellWay::OneMore) cell += 1;
  if (way_.cell == CellWay::Upwards) cell = table_.first() + std::ceil(real);
  if (way_.cell == CellWay::FromZero) cell -= table_.first();
  if (way_.cellWraps || way_.cell == CellWay::NoI0Wraps)
    return static_cast<int>(static_cast<long long>(std::clamp(cell, -1e9, 1e9)) & 255);
  return static_cast<int>(std::clamp(cell, 0.0, 255.0));
}

/// What shade j holds before it is rounded, 0 to 1.
double OtherProgram::levelOf(int j) const {
  const TableSettings& s = table_.settings();
  const double perStep = way_.store == StoreWay::Ratio240 ? table_.shades() : 63.0;
  if (way_.store == StoreWay::Ratio240 || way_.store == StoreWay::Ratio64)
    return std::min(1.0, s.I0 * std::pow(1.0 / s.I0, j / perStep));
  if (0 <= j && j < table_.shades()) return table_.level(j);
  if (isEven(s.kind) && table_.shades() == kMaxShades)
    return std::clamp((table_.first() + j - 10) / 255.0, 0.0, 1.0);
  return j < 0 ? 0.0 : 1.0;
}

double OtherProgram::withoutTable(double I) const {
  const double in = std::clamp(I, 0.0, 1.0);
  const double value = way_.store == StoreWay::By256     ? std::min(255.0, 256.0 * in)
                       : way_.store == StoreWay::ByGamma ? 255.0 * std::pow(in, 1.0 / 2.2)
                                                         : 255.0 * in;
  return way_.cell == CellWay::Truncated ? std::floor(value) : nearestWhole(value);
}

double OtherProgram::stored(int cell) const {
  int j = cell - table_.first();
  const auto shown = [](double level) { return std::floor(std::floor(65535.0 * level + 0.5) / 256.0); };
  if (way_.store == StoreWay::Minus11) return std::clamp(cell - 11.0, 0.0, 255.0);
  if (way_.store == StoreWay::EightIn16) return 0.0;
  if (way_.store == StoreWay::Gamma) return shown(std::pow(levelOf(j), 1.0 / 2.2));
  if (way_.store == StoreWay::Gamma8)
    return nearestWhole(255.0 * std::pow(shown(levelOf(j)) / 255.0, 1.0 / 2.2));
  if (way_.store == StoreWay::Backwards) j = table_.shades() - 1 - j;
  const bool in8 = table_.settings().bits == 8 || way_.store == StoreWay::Rounded8;
  return in8 ? nearestWhole(255.0 * levelOf(j)) : shown(levelOf(j));
}

/// Where a sample lies: in which triangle of its face, and on which texel.

/// The corners of the polygon whose triangles count, in order; the first is the apex of the fan. It is the
/// part that the picture has; along the other diagonal it is the model's own face, which has parts if it is
/// bent.
std::vector<int> OtherProgram::fanOf(const SnappedFace& face) const {
  const SnappedScene& scene = model_.snapped();
  const Mesh& mesh = model_.mesh();
  std::vector<int> corners;
  const int first = mesh.firstCorner[face.number], end = mesh.firstCorner[face.number + 1];
  if (way_.otherDiagonal && face.count == 3 && end - first == 4)
    for (int c = first; c < end && places_.onScreen[c]; ++c) corners.push_back(c);
  if (corners.size() != 4) {
    corners.clear();
    for (int k = 0; k < face.count; ++k) corners.push_back(scene.source[face.first + k]);
    std::ranges::rotate(corners, std::ranges::min_element(corners));
  }
  if (way_.otherDiagonal) std::ranges::rotate(corners, corners.begin() + 1);
  return corners;
}

OtherProgram::InTriangle OtherProgram::triangle(const SnappedFace& face, int i, int j) const {
  const std::vector<int> fan = fanOf(face);
  const glm::dvec2 at{i + 0.5, j + 0.5};
  InTriangle best;
  double inside = -1e300;
  for (std::size_t k = 1; k + 1 < fan.size(); ++k) {
    const std::array<int, 3> corner{fan[0], fan[k], fan[k + 1]};
    std::array<glm::dvec2, 3> p{};
    std::array<double, 3> overDepth{};
    for (int e = 0; e < 3; ++e)
      p[e] = *places_.onScreen[corner[e]] - at, overDepth[e] = 1.0 / places_.depth[corner[e]];
    const glm::dvec2 u = p[1] - p[0], v = p[2] - p[0];
    if (u.x * v.y == u.y * v.x) continue;  // it has no area
    const Weights onScreen = weightsOfOrigin(p);
    const double least = std::ranges::min(onScreen);
    if (least <= inside) continue;
    inside = least;
    best = {corner, onScreen, weightsInWorld(onScreen, overDepth)};
  }
  return best;
}

const Texture* OtherProgram::textureOf(int face) const {
  const Mesh& mesh = model_.mesh();
  const int material = mesh.material[face], texture = material < 0 ? -1 : mesh.materials[material].texture;
  return texture < 0 ? nullptr : &model_.picture().scene().textures[texture];
}

std::size_t OtherProgram::texel(const Texture& texture, const InTriangle& in) const {
  const Mesh& mesh = model_.mesh();
  glm::dvec2 uv{0.0};
  for (int k = 0; k < 3; ++k)
    uv += (way_.onScreen ? in.onScreen : in.inWorld)[k] * mesh.uv[mesh.uvOfCorner[in.corner[k]]];
  const double u = uv.x - std::floor(uv.x), v = uv.y - std::floor(uv.y);
  const int column = std::min(static_cast<int>(u * texture.width), texture.width - 1),
            row = std::clamp(static_cast<int>((1.0 - v) * texture.height), 0, texture.height - 1);
  return static_cast<std::size_t>(row) * texture.width + column;
}

int OtherProgram::texelAt(int face, int i, int j) {
  const SnappedFace& f = model_.snapped().faces[face];
  const Texture* const texture = textureOf(f.number);
  if (!texture) return -1;
  const std::size_t k = texel(*texture, triangle(f, i, j));
  return texture->channel[0][k] << 16 | texture->channel[1][k] << 8 | texture->channel[2][k];
}

}  // namespace xnewell
