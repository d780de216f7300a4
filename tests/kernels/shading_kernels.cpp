#include <glm/geometric.hpp>
#include <optional>

#include "geometry/exact/int128.h"
#include "geometry/view/scanline.h"
#include "shading/color/color_table.h"
#include "shading/fill/affine.h"
#include "shading/fill/environment.h"
#include "shading/fill/evaluate_pixels.h"
#include "shading/fill/ramp.h"
#include "shading/fill/reflect.h"
#include "tests/kernels/search.h"

namespace xnewell {

namespace {

template <class Real>
constexpr double kUnit = std::is_same_v<Real, float> ? kSingle : kU;
template <class Real>
Vec<Real> vecOf(const double* v) {
  return {static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2])};
}
/// A unit vector of three numbers; empty if the square of their length is too small or too large.
Numbers unitNumbers(const double* v) {
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  if (!(square > 1e-200 && square < 1e200)) return {};
  return {v[0] / std::sqrt(square), v[1] / std::sqrt(square), v[2] / std::sqrt(square)};
}
/// The input with unit vectors at those places.
Numbers withUnits(In in, std::initializer_list<std::size_t> places) {
  Numbers v = in;
  for (const std::size_t at : places) {
    const Numbers unit = unitNumbers(&v[at]);
    if (unit.empty()) return {};
    std::ranges::copy(unit, &v[at]);
  }
  return v;
}
/// Lights that no face reflects are left out, so the mesh has one material.
Lighting resolved(const SceneLight& scene, const Illumination& user, const glm::dvec3& point,
                  const glm::dvec3& eye) {
  Mesh mesh;
  mesh.points = {point};
  mesh.material = {-1};
  return resolve(mesh, scene, user, Channels::Luminance, eye, {0, 0, 0});
}

// Colour tables. In an input: kind, pick, N, I0, low, high.
Inputs tableInput() {
  return integers(0, 2) + integers(0, 1) + integers(2, kMaxShades) + doubles(1e-300, 0.999) +
         2 * doubles(0, 1);
}
/// A table and its exact levels and thresholds.
struct ExactTable {
  TableSettings settings;
  Big low, high, lowest, highest;

  explicit ExactTable(In in) {
    settings.kind = kTables[static_cast<std::size_t>(in[0])].id;
    settings.pick = kPicks[static_cast<std::size_t>(in[1])].id;
    settings.shades = whole(in[2]);
    settings.I0 = in[3], settings.low = in[4], settings.high = in[5];
    low = big(in[4]), high = big(in[5]);
    lowest = big(std::max(in[3], in[4])), highest = largerOf(lowest, high);
  }
  [[nodiscard]] bool corrected() const { return settings.kind == TableKind::Corrected; }
  [[nodiscard]] Big share(const Big& j) const { return j / (settings.shades - 1); }
  [[nodiscard]] Big level(int j) const {
    if (corrected()) return lowest * pow(Big{highest / lowest}, share(j));
    const Big held = 239 * (low + (high - low) * share(j));
    return (settings.kind == TableKind::Linear ? held + 1 : held) / 255;
  }
  /// Where shade j + 1 begins.
  [[nodiscard]] Big threshold(int j) const {
    const Big middle = Big{j} + Big{0.5};
    if (!corrected()) return low + (high - low) * share(middle);
    if (settings.pick == Pick::Search) return (level(j) + level(j + 1)) / 2;
    return lowest * pow(Big{highest / lowest}, share(middle));
  }
  /// How far I lies outside the intensities that pick the shade, as a share of the bound. Inside, a little
  /// the more the nearer an end is, to lead the search there.
  [[nodiscard]] double missed(const Big& I, int shade) const {
    if (I >= 1) return shade == settings.shades - 1 ? 0.0 : kWrong;
    double worst = 0;
    for (const int side : {-1, 1}) {
      const int j = side < 0 ? shade - 1 : shade;
      if (j < 0 || j + 1 >= settings.shades) continue;
      const Big at = threshold(j), bound = corrected() ? Big{(5 * j + 8) * kU * at} : Big{4 * kU};
      const double beyond = toDouble(side * (I - at) / bound);
      worst = std::max(worst, beyond > 0 ? beyond : 0.01 / (1 - beyond));
    }
    return worst;
  }
};
/// The ends of the range in order, and at least 2^-20 apart: nearer to each other, the thresholds are too
/// near for the intensities to tell.
Numbers preparedTable(In in) {
  Numbers v = in;
  if (v[4] > v[5]) std::swap(v[4], v[5]);
  return v[5] - v[4] < 0x1p-20 ? Numbers{} : v;
}
Numbers preparedShade(In in) { return in[6] < in[2] ? preparedTable(in) : Numbers{}; }

double judgeLevel(In in, In out) {
  const ExactTable table{in};
  const int j = whole(in[6]);
  const Big exact = table.level(j);
  return shareOf(out[0], exact, table.corrected() ? (5 * j + 2) * kU * exact : Big{8 * kU});
}

/// The intensity is a float, or a value on kTableRamp in steps.
Numbers preparedCell(In in) {
  Numbers v = preparedTable(in);
  if (v.empty()) return v;
  v[0] = static_cast<double>(TableKind::Corrected);
  v[6] = v[7] == 0 ? static_cast<float>(v[6]) : std::floor((0.5 + 255 * v[6]) * 0x1p24);
  return v;
}
Numbers runCell(In in) {
  const ColorTable table{ExactTable{in}.settings};
  const TableCells cells{table};
  const auto I = static_cast<float>(in[6]);
  const int cell = in[7] == 0 ? cells.cells(Lanes<float, 4>{I, I, I, I})[0]
                              : cells.bySteps()(static_cast<std::uint32_t>(in[6]));
  return {static_cast<double>(cell - table.first())};
}
double judgeCell(In in, In out) {
  const Big I = in[7] == 0 ? big(in[6]) : (big(in[6]) / 0x1p24 - Big{0.5}) / 255;
  return ExactTable{in}.missed(I, whole(out[0]));
}

/// In an input, behind the shade: the hue, and whether it is stored with 16 bits.
Numbers runStored(In in) {
  TableSettings settings = ExactTable{in}.settings;
  settings.hue = {1, in[7], 0}, settings.bits = in[8] == 0 ? 8 : 16;
  return {static_cast<double>(ColorTable{settings}.color(whole(in[6])).g)};
}
double judgeStored(In in, In out) {
  const bool bytes = in[8] == 0;
  const Big exact = ExactTable{in}.level(whole(in[6])) * big(in[7]) * (bytes ? 255 : 65535);
  const Big error = abs(big(bytes ? out[0] / 257 : out[0]) - exact);
  // What is beyond the half step; below it, little, to lead the search to the ties.
  return std::max(0.01 * toDouble(error), toDouble((error - 0.5) / 0x1p-26));
}

// Lights. In an input: kind of attenuation, d, unit, range, c1, c2, c3.
Light attenuated(In in) {
  Light light{.kind = LightKind::Point, .attenuation = kAttenuations[static_cast<std::size_t>(in[0])].id};
  light.range = in[3], light.c = {in[4], in[5], in[6]};
  return light;
}
/// fatt at the distance d.
Big exactAttenuation(const Light& light, const Big& d, double unit) {
  const Big u = d / big(unit);
  switch (light.attenuation) {
    case Attenuation::None:
      break;
    case Attenuation::Inverse:
      return 1 / largerOf(1, u);
    case Attenuation::InverseSquare:
      return 1 / largerOf(1, u * u);
    case Attenuation::Linear:
      return largerOf(0, 1 - d / big(light.range));
    case Attenuation::Textbook:
      return 1 / largerOf(1, big(light.c[0]) + big(light.c[1]) * d + big(light.c[2]) * d * d);
  }
  return 1;
}
double judgeAttenuation(In in, In out) {
  const Light light = attenuated(in);
  const Big exact = exactAttenuation(light, big(in[1]), in[2]);
  const bool linear = light.attenuation == Attenuation::Linear;
  return shareOf(out[0], exact, linear ? Big{0x1p-51} : 0x1p-50 * exact + 0x1p-1022);
}

/// The cones of a spot, exactly.
struct ExactSpot {
  Big inner, outer;
  int falloff;
  explicit ExactSpot(const Light& light)
      : inner{cos(big(light.inner) * degree())},
        outer{cos(big(light.outer) * degree())},
        falloff{light.falloff} {}
  [[nodiscard]] Big share(const Big& cosine) const {
    if (cosine >= inner) return 1;
    return cosine <= outer ? Big{0} : bigPower(Big{(cosine - outer) / (inner - outer)}, falloff);
  }
  /// How far a cosine must be from the exact one for this share. A share below 2^-100 counts as 0: a power
  /// may underflow, or be rounded up from 0.
  [[nodiscard]] Big missed(const Big& cosine, double of) const {
    if (of >= 1) return largerOf(0, (falloff > 0 ? inner : outer) - cosine);
    if (of < 0x1p-100) {
      const bool wide = falloff > 0 && inner > outer;
      return largerOf(0, cosine - outer - (wide ? Big{(inner - outer) * exp(Big{-69} / falloff)} : Big{0}));
    }
    if (falloff == 0) return 2;  // between 0 and 1 is impossible
    return abs(outer + (inner - outer) * exp(log(big(of)) / falloff) - cosine);
  }
};
/// In an input: inner, outer, falloff, axis, L.
Light spotOf(In in) {
  return {.kind = LightKind::Spot,
          .direction = glmOf(&in[3]),
          .inner = in[0],
          .outer = in[1],
          .falloff = whole(in[2])};
}
Numbers preparedSpot(In in) {
  Numbers v = in;
  if (v[0] > v[1]) std::swap(v[0], v[1]);
  return withUnits(v, {3, 6});
}
double judgeSpot(In in, In out) {
  if (!(out[0] >= 0 && out[0] <= 1)) return kWrong;
  const Big cosine = -dot(unitOf(bigVec(&in[3])), bigVec(&in[6]));
  return toDouble(ExactSpot{spotOf(in)}.missed(cosine, out[0]) / 0x1p-48);
}

/// A light at a place as the program meets it: resolve(), then incident(). In an input: as attenuated(), then
/// inner, outer, falloff, axis, the light's position, the place. The second number says whether it is a spot.
constexpr std::size_t kSpot = 7, kAxis = 10, kPosition = 13, kPlace = 16;
Inputs incidentInput(const Inputs& size, int steepest) {
  return integers(0, 4) + doubles(0, 2) + doubles(1e-3, 1e3) + doubles(1e-3, 1e6) + 3 * doubles(0, 1e3) +
         2 * doubles(0, 180) + integers(0, steepest) + 3 * doubles(-1, 1) + 6 * size;
}
Light lightOf(In in) {
  Light light = attenuated(in);
  light.kind = in[1] < 1 ? LightKind::Point : LightKind::Spot;
  light.Ip = glm::dvec3{1};
  light.inner = in[kSpot], light.outer = in[kSpot + 1], light.falloff = whole(in[kSpot + 2]);
  light.direction = glmOf(&in[kAxis]), light.position = glmOf(&in[kPosition]);
  return light;
}
Numbers preparedIncident(In in) {
  Numbers v = withUnits(in, {kAxis});
  if (v.empty()) return v;
  if (v[kSpot] > v[kSpot + 1]) std::swap(v[kSpot], v[kSpot + 1]);
  const glm::dvec3 to = glmOf(&v[kPosition]) - glmOf(&v[kPlace]);
  // Nearer, the square of the distance underflows in single precision.
  return glm::dot(to, to) > 0x1p-100 ? v : Numbers{};
}
template <class Real>
Numbers runIncident(In in) {
  const Lighting lighting =
      resolved({.Ia = {}, .lights = {lightOf(in)}, .unit = in[2]}, {}, glmOf(&in[kPlace]), {0, 0, 5});
  if (lighting.sources.empty()) return {0, 0, 0, 0};
  const Incident<Real> arrives = incident(lighting.sources[0], vecOf<Real>(&in[kPlace]));
  return {arrives.L.x, arrives.L.y, arrives.L.z, arrives.f};
}
/// The bounds are 8 u of each part of L, 16 u of fatt (linear: 8 u), and a cosine 32 u off.
template <class Real>
double judgeIncident(In in, In out) {
  constexpr double u = kUnit<Real>;
  const Light light = lightOf(in);
  const BigVec to = bigVec(&in[kPosition]) - bigVec(&in[kPlace]), L = unitOf(to);
  const Big fatt = exactAttenuation(light, lengthOf(to), in[2]), least = u * u;
  if (out[3] == 0 && fatt < 4 * u) return 0;  // resolve() leaves out a light that does not reach the place
  const double worst =
      out[3] != 0 ? shareOf(out.data(), L, absOf(L) * (8 * u) + BigVec{least, least, least}) : 0;
  const Big bound = light.attenuation == Attenuation::Linear ? Big{8 * u} : 16 * u * fatt;
  if (light.kind != LightKind::Spot) return std::max(worst, shareOf(out[3], fatt, bound));
  if (out[3] < 0x1p-100) return worst;  // it counts as dark
  // fatt may be anywhere within its bound, so the share lies in an interval.
  const ExactSpot spot{light};
  const Big cosine = -dot(unitOf(bigVec(&in[kAxis])), L), exact = spot.share(cosine);
  const Big low = big(out[3]) / (fatt + bound),
            high = fatt > bound ? Big{big(out[3]) / (fatt - bound)} : Big{1};
  if (low <= exact && exact <= high) return worst;
  const Big missed = smallerOf(spot.missed(cosine, toDouble(low)), spot.missed(cosine, toDouble(high)));
  return std::max(worst, toDouble(missed / (32 * u)));
}

// Highlights. In an input: N, L, V. In single precision, they are doubles that are floats.
template <class Real>
Numbers preparedVectors(In in) {
  Numbers v = withUnits(in, {0, 3, 6});
  for (double& part : v) part = static_cast<Real>(part);
  return v;
}
/// By the loops, and by one place.
template <class Real, Form form>
Numbers runCosine(In in) {
  const auto N = vecOf<Real>(&in[0]), L = vecOf<Real>(&in[3]), V = vecOf<Real>(&in[6]);
  Numbers out{form == Form::Textbook ? reflectedCosine(dot(N, L), dot(N, V), dot(L, V))
                                     : dot(N, unitOf(L + V))};
  if (std::is_same_v<Real, double>)
    out.push_back(specularCosine(form, glmOf(&in[0]), glmOf(&in[3]), glmOf(&in[6])));
  return out;
}
template <class Real, Form form>
double judgeCosine(In in, In out) {
  const BigVec N = bigVec(&in[0]), L = bigVec(&in[3]), V = bigVec(&in[6]), H = L + V;
  const bool textbook = form == Form::Textbook;
  // Where L + V is shorter, its square may underflow.
  if (!textbook && lengthOf(H) < (std::is_same_v<Real, float> ? 0x1p-50 : 0x1p-500)) return 0;
  const Big exact = textbook ? Big{2 * dot(N, L) * dot(N, V) - dot(L, V)} : dot(N, unitOf(H));
  double worst = 0;
  for (const double cosine : out)
    worst = std::max(worst, shareOf(cosine, exact, (textbook ? 32 : 16) * kUnit<Real>));
  return worst;
}

/// The rotated environment map of one light at one place of the map.
constexpr std::size_t kL = 5;
Numbers preparedMap(In in) {
  const double x = in[0] - 127.5, y = in[1] - 127.5;
  return x * x + y * y <= 127 * 127 ? withUnits(in, {kL}) : Numbers{};
}
Numbers runMap(In in) {
  const Illumination user{
      .Ia = 0, .Ip = 1, .kd = in[4], .ks = 1 - in[4], .n = whole(in[3]), .light = glmOf(&in[kL])};
  const Lighting lighting = resolved({}, user, {0, 0, 0}, {0, 0, 5});
  const Environment map = makeEnvironment(EnvironmentForm::Rotated, lighting, lighting.materials[0], 0,
                                          glm::dmat3{1.0}, {0, 0, 0});
  return {(in[2] > 0 ? map.front : map.away)[static_cast<std::size_t>(256 * in[1] + in[0])]};
}
double judgeMap(In in, In out) {
  const Big x = (big(in[0]) - 127.5) / 127, y = (big(in[1]) - 127.5) / 127;
  const int n = whole(in[3]);
  const Big z = in[2] > 0 ? Big{sqrt(1 - x * x - y * y)} : Big{0};
  const Big exact = z > 0 ? Big{big(in[4]) * z + big(1 - in[4]) * bigPower(z, n)} : Big{0};
  return shareOf(out[0], exact, Big{0x1p-24 + n * 0x1p-43});
}

/// The column of an environment map for a component of a normal.
Numbers runLookUp(In in) {
  static const std::vector<std::uint8_t> columns = [] {
    std::vector<std::uint8_t> cells(65'536);
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = static_cast<std::uint8_t>(k % 256);
    return cells;
  }();
  const EnvironmentMap map{{valueSteps(128.0 + 127.0 * in[0]), 0, 0}, {128u << 24, 0, 0}, columns.data()};
  std::array<std::uint8_t, 9> cells{};
  map.span(cells.data(), 0, 0, 9);
  return {static_cast<double>(cells[0]), static_cast<double>(cells[8])};
}
double judgeLookUp(In in, In out) {
  if (out[0] != out[1]) return kWrong;
  const Big place = 128 + 127 * big(in[0]);
  return toDouble(largerOf(0, largerOf(big(out[0]) - place, place - big(out[0]) - 1)) / 0x1p-24);
}

/// Phong's sum at a pixel with far lights, where N, L and V are the same at all pixels: the shortest way
/// through FarLightsRow. In an input: n, N, L, V.
Numbers runPhong(In in) {
  using Real = Lanes<float, 8>;
  const Illumination user{.Ia = 0.25,
                          .Ip = 0.75,
                          .ka = 0.5,
                          .kd = 0.5,
                          .ks = 0.5,
                          .n = whole(in[0]),
                          .light = glmOf(&in[4]),
                          .constantV = true};
  const Lighting lighting = resolved({}, user, {0, 0, 0}, glmOf(&in[7]));
  PhongTriangle t;
  t.lighting = &lighting, t.material = &lighting.materials[0];
  for (int axis = 0; axis < 3; ++axis) t.N[axis] = {in[1 + axis], 0, 0};
  const TexelRow<Real> texels{t, 0};
  double sum = 0;
  withRow<Real>(t, 0, [&](auto row) {
    const Real along{};
    row.evaluate(&along, 1, texels);
    sum = row.sum(0)[0];
  });
  return {sum};
}
double judgePhong(In in, In out) {
  const BigVec N = unitOf(bigVec(&in[1])), L = unitOf(bigVec(&in[4])), V = unitOf(bigVec(&in[7]));
  const int n = whole(in[0]);
  const Big NdotL = dot(N, L), RdotV = 2 * NdotL * dot(N, V) - dot(L, V);
  if (abs(NdotL) < 0x1p-20) return 0.0;  // the highlight begins at once where N.L = 0
  Big exact = 0.125;
  if (NdotL > 0) exact += 0.375 * NdotL + 0.375 * bigPower(largerOf(0, RdotV), n);
  return shareOf(out[0], exact, Big{(8 + 32 * n) * kSingle + 0x1p-40});
}

// Triangles on the screen. In an input: the corners' x and y, then where in it: two shares of its edges.
// Prepared: the triangle, turned counter-clockwise, then the pixel whose centre is in it; the rest of the
// input.
constexpr double kGridReach = 0x1p29;
constexpr std::size_t kPlaceIn = 6, kPixel = 6, kOthers = 8;
Inputs triangleInput() { return 6 * integers(-kGridReach, kGridReach) + 2 * doubles(0, 1); }
std::array<glm::ivec3, 3> triangleOf(In in) {
  std::array<glm::ivec3, 3> p;
  for (int k = 0; k < 3; ++k) p[k] = {whole(in[2 * k]), whole(in[2 * k + 1]), 0};
  return p;
}
Numbers preparedTriangle(In in) {
  Numbers v = in;
  const std::int64_t area = doubleArea(triangleOf(v).data(), 3);
  if (area == 0) return {};
  if (area < 0) std::swap(v[2], v[4]), std::swap(v[3], v[5]);
  double a = in[kPlaceIn], b = in[kPlaceIn + 1];
  if (a + b > 1) a = 1 - a, b = 1 - b;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = v[axis], at = from + a * (v[2 + axis] - from) + b * (v[4 + axis] - from);
    v[kPixel + axis] = std::clamp(std::floor(at / kGrid), 0.0, kMaxPicture - 1.0);
  }
  const Int128 x = Int128{whole(v[kPixel])} * kGrid + kGrid / 2,
               y = Int128{whole(v[kPixel + 1])} * kGrid + kGrid / 2;
  const std::array<glm::ivec3, 3> p = triangleOf(v);
  for (int k = 0; k < 3; ++k) {
    const glm::ivec3 &from = p[k], &to = p[(k + 1) % 3];
    if ((to.y - from.y) * (x - from.x) - (to.x - from.x) * (y - from.y) < 0) return {};
  }
  return v;
}
/// The mean of three corners' values, by their exact weights at the centre of the pixel.
Big meanAt(In in, std::size_t values) {
  const Big x = big(in[kPixel]) * kGrid + kGrid / 2, y = big(in[kPixel + 1]) * kGrid + kGrid / 2;
  Big sum = 0, weights = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = 2 * ((k + 1) % 3), b = 2 * ((k + 2) % 3);
    const Big w = (big(in[b]) - x) * (big(in[a + 1]) - y) - (big(in[a]) - x) * (big(in[b + 1]) - y);
    weights += w, sum += w * big(in[values + k]);
  }
  return sum / weights;
}
/// Of the corners' values: the sizes of the slopes' terms, in pixels, and what else their bounds need.
struct Slopes {
  Big gx, gy, steepest;  ///< with the terms' sizes added; the larger of the slopes
  Big area, areaTerms, longest, w, h;
  Slopes(In in, std::size_t values) {
    const Big x1 = (big(in[2]) - big(in[0])) / kGrid, y1 = (big(in[3]) - big(in[1])) / kGrid;
    const Big x2 = (big(in[4]) - big(in[0])) / kGrid, y2 = (big(in[5]) - big(in[1])) / kGrid;
    const Big d1 = big(in[values + 1]) - big(in[values]), d2 = big(in[values + 2]) - big(in[values]);
    area = abs(x1 * y2 - x2 * y1), areaTerms = abs(x1 * y2) + abs(x2 * y1);
    longest = largerOf(largerOf(abs(x1), abs(y1)), largerOf(abs(x2), abs(y2)));
    gx = (abs(d1 * y2) + abs(d2 * y1)) / area, gy = (abs(d2 * x1) + abs(d1 * x2)) / area;
    steepest = largerOf(abs(d1 * y2 - d2 * y1), abs(d2 * x1 - d1 * x2)) / area;
    const auto [left, right] = std::minmax({in[0], in[2], in[4]});
    const auto [top, bottom] = std::minmax({in[1], in[3], in[5]});
    w = big(right - left) / kGrid, h = big(bottom - top) / kGrid;
  }
};

/// In the rest of an input: the three values.
Numbers runAffine(In in) {
  const AffineValue value =
      AffineOver{triangleOf(in).data()}({in[kOthers], in[kOthers + 1], in[kOthers + 2]});
  return {static_cast<double>(value.at(whole(in[kPixel]), whole(in[kPixel + 1])))};
}
double judgeAffine(In in, In out) {
  const Slopes s{in, kOthers};
  if (s.steepest > 0x1p20 * (1 - 1e-6)) return 0.0;  // there it is the mean everywhere
  // Modulo 2^32 the value may be taken on either side.
  const Big error = big(out[0]) - meanAt(in, kOthers) * 0x1p24;
  const Big around = error > 0x1p31 ? Big{error - 0x1p32} : error < -0x1p31 ? Big{error + 0x1p32} : error;
  return toDouble(abs(around) / ((0.5 + 0x1p-7) * (s.w + s.h) + 1));
}

/// The first sample at an edge, in a row far below its start. In an input: the ends, the row. Prepared: from
/// the upper end, and the first row.
Numbers preparedEdge(In in) {
  Numbers v = in;
  if (v[1] > v[3]) std::swap(v[0], v[2]), std::swap(v[1], v[3]);
  const int first = std::max(0, sampleFrom(whole(v[1]))),
            end = std::min(kMaxPicture, sampleFrom(whole(v[3])));
  if (first >= end) return {};
  v[4] = first + std::fmod(v[4], end - first);
  return v + Numbers{static_cast<double>(first)};
}
Numbers runEdge(In in) {
  EdgeWalk edge{{whole(in[0]), whole(in[1]), 0}, {whole(in[2]), whole(in[3]), 0}, whole(in[5])};
  for (int row = whole(in[5]); row < whole(in[4]); ++row) edge.nextRow();
  return {static_cast<double>(edge.column())};
}
double judgeEdge(In in, In out) {
  const auto integer = [](double v) { return Int128{static_cast<std::int64_t>(v)}; };
  const Int128 dx = integer(in[2]) - integer(in[0]), dy = integer(in[3]) - integer(in[1]);
  const Int128 yc = integer(in[4]) * kGrid + kGrid / 2;
  // The crossing, in grid steps from the centre of column 0, is n / dy.
  const Int128 n = (integer(in[0]) - kGrid / 2) * dy + (yc - integer(in[1])) * dx, divisor = dy * kGrid;
  const Int128 column = n / divisor + (n % divisor > 0);
  if (integer(out[0]) != column) return kWrong;
  // Hard are the crossings at a sample, and those just right of one. The rounding of the step grows from row
  // to row.
  const Int128 beyond = n - (column - 1) * divisor, apart = std::min(beyond, divisor - beyond);
  const double rows = (in[4] - in[5] + 1) / kMaxPicture;
  return 0.9 * rows / (1 + static_cast<double>(apart) / static_cast<double>(divisor) * 0x1p30);
}

/// Values of three corners over their depths, divided by 1 / w at a pixel. In the rest of an input: three
/// values, three of 1 / w, for a texture whether it repeats. Prepared, behind them: three values over w.
constexpr std::size_t kQ = kOthers + 3, kOverW = kOthers + 6;
Inputs dividedInput(double least, double most) {
  return triangleInput() + 3 * doubles(least, most) + 3 * doubles(0x1p-20, 1);
}
Numbers preparedDivision(In in) {
  Numbers v = preparedTriangle(in);
  for (std::size_t k = 0; k < 3 && !v.empty(); ++k)
    v.insert(v.begin() + kOverW + static_cast<std::ptrdiff_t>(k), v[kOthers + k] * v[kQ + k]);
  return v;
}
PixelPlane planeAt(const PixelPlanes& planes, const double* v) { return planes({v[0], v[1], v[2]}); }

/// The bound of the quotient, as in pixel_row.h, where 1 / w is known to a tenth. Empty for a sliver.
template <class Real>
std::optional<Big> quotientOff(In in, const Big& value, const Big& q) {
  constexpr double u = kUnit<Real>;
  const auto off = [&](std::size_t values) {
    const Slopes s{in, values};
    const Big terms = abs(big(in[values])) + s.gx * (s.w + 1) + s.gy * (s.h + 1);
    return Big{8 * u * terms + 32 * kU * terms * s.areaTerms / s.area};
  };
  const Slopes s{in, kQ};
  const Big a = off(kOverW), b = off(kQ);
  if (s.area * 0x1p12 < s.longest * (1 + 1e-9) || b * 10 > q) return std::nullopt;
  return Big{(a + abs(value) * b) / (q - b) + 3 * u * abs(value) + 0x1p-110};
}
template <class Real>
constexpr int kLanes = std::is_same_v<Real, float> ? 8 : 4;

template <class Real>
Numbers runDivision(In in) {
  using Row = Lanes<Real, kLanes<Real>>;
  const PixelPlanes planes{triangleOf(in)};
  const double down = in[kPixel + 1] - planes.j0();
  const Row along = splat<Row>(in[kPixel] - planes.i0());
  const RowOf<Row> a{planeAt(planes, &in[kOverW]), down}, q{planeAt(planes, &in[kQ]), down};
  const Row value = a.at(along) * (splat<Row>(1.0) / q.at(along));
  return {static_cast<double>(value[0])};
}
template <class Real>
double judgeDivision(In in, In out) {
  const Big q = meanAt(in, kQ), exact = meanAt(in, kOverW) / q;
  const std::optional<Big> bound = quotientOff<Real>(in, exact, q);
  return bound ? shareOf(out[0], exact, *bound) : 0.0;
}

/// The texel that a pixel shows, in a texture of 16 x 16 whose texels all differ.
constexpr int kSide = 16;
template <class Real>
Numbers runTexel(In in) {
  static const Texture texture = [] {
    Texture t{.width = kSide, .height = kSide, .channel = {}, .gray = {}};
    for (int k = 0; k < kSide * kSide; ++k) t.gray.push_back(static_cast<std::uint8_t>(k));
    return t;
  }();
  // v of the texture is 1 - u, so that both are searched at once.
  using Row = Lanes<Real, kLanes<Real>>;
  const PixelPlanes planes{triangleOf(in)};
  TermsTriangle t;
  t.i0 = planes.i0(), t.j0 = planes.j0();
  t.texture = &texture, t.texels = texture.gray.data();
  t.q = planeAt(planes, &in[kQ]), t.u = planeAt(planes, &in[kOverW]), t.v = t.u;
  t.repeats = in.back() > 0;
  TexelRow<Row> row{t, in[kPixel + 1] - t.j0};
  const Row along = splat<Row>(in[kPixel] - t.i0);
  row.locate(&along, 1);
  const double texel = std::round(255 * static_cast<double>(row.share(0)[0]));
  return {std::fmod(texel, kSide), std::floor(texel / kSide)};
}
template <class Real>
double judgeTexel(In in, In out) {
  const Big q = meanAt(in, kQ), s = meanAt(in, kOverW) / q;
  const std::optional<Big> off = quotientOff<Real>(in, s, q);
  if (!off || *off * 4 > 1) return 0.0;
  // How far the place lies outside the texel, around the ends if it repeats.
  const bool repeats = in.back() > 0;
  const auto beyond = [&](const Big& place, double texel) {
    const Big end =
        repeats ? Big{place - kSide * floor(place / kSide)} : smallerOf(largerOf(place, 0), kSide);
    const Big outside = largerOf(0, largerOf(big(texel) - end, end - big(texel) - 1));
    return repeats ? smallerOf(outside, abs(kSide - 1 - abs(end - big(texel) - Big{0.5}) + Big{0.5}))
                   : outside;
  };
  return toDouble(largerOf(beyond(s * kSide, out[0]), beyond((1 - s) * kSide, out[1])) /
                  ((*off + 3 * kUnit<Real>)*kSide));
}

}  // namespace

std::vector<Kernel> shadingKernels() {
  const Inputs part = doubles(-1, 1), share = doubles(0, 1), shade = integers(0, kMaxShades - 1);
  const std::string division = "pixel_row.h: that of both planes, 3 u of it",
                    texel = "texel_row.h: the division's bound, and 3 roundings of the width";
  return {
      {"ratio of shades", "color_table.h: 2^-51 of it", doubles(1e-300, 1) + integers(1, kMaxShades - 1),
       nullptr, [](In in) { return Numbers{ratioOfShades(in[0], whole(in[1]))}; },
       [](In in, In out) {
         const Big exact = pow(Big{1 / big(in[0])}, Big{1 / Big{in[1]}});
         return shareOf(out[0], exact, 0x1p-51 * exact);
       }},
      {"colour table: level of a shade", "color_table.h: (5 j + 2) 2^-53 of it; linear: 2^-50",
       tableInput() + shade, preparedShade,
       [](In in) { return Numbers{ColorTable{ExactTable{in}.settings}.level(whole(in[6]))}; }, judgeLevel, 2,
       0.5},
      {"colour table: shade of an intensity",
       "color_table.h: threshold j: (5 j + 8) 2^-53 of it; linear: 2^-51", tableInput() + share,
       preparedTable, [](In in) { return Numbers{double(ColorTable{ExactTable{in}.settings}.shade(in[6]))}; },
       [](In in, In out) { return ExactTable{in}.missed(big(in[6]), whole(out[0])); }, 2, 0.5},
      {"colour table: cell of a float or of steps", "ramp.h: as the shade of a double",
       tableInput() + share + integers(0, 1), preparedCell, runCell, judgeCell, 2, 0.2},
      {"colour that a shade stores", "color_table.h: 2^-26 beyond half of its last step",
       tableInput() + shade + share + integers(0, 1), preparedShade, runStored, judgeStored, 2, 0.5},
      {"value on a ramp, single precision", "ramp.h: 2^-15", share + integers(2, kMaxShades), nullptr,
       [](In in) {
         const Ramp ramp{.first = 256 - whole(in[1]), .shades = whole(in[1])};
         return Numbers{ValueOnRamp<float>{ramp}(static_cast<float>(in[0]))};
       },
       [](In in, In out) { return shareOf(out[0], 256 - in[1] + 0.5 + (in[1] - 1) * big(in[0]), 0x1p-15); }},
      {"attenuation", "equation.h: 2^-50 of it, and 2^-1022; linear: 2^-51",
       integers(0, 4) + doubles(0, 1e300) + 2 * doubles(1e-300, 1e300) + 3 * doubles(0, 1e300), nullptr,
       [](In in) { return Numbers{attenuation(attenuated(in), in[1], in[2])}; }, judgeAttenuation},
      {"share of a spot", "equation.h: that of a cosine within 2^-48",
       2 * doubles(0, 180) + integers(0, 1'000'000) + 6 * part, preparedSpot,
       [](In in) { return Numbers{spotShare(spotOf(in), glmOf(&in[6]))}; }, judgeSpot, 2, 0.3},
      {"light that arrives", "reflect.h: L 2^-50, fatt 2^-49 of it; a cosine 2^-48 off",
       incidentInput(doubles(-0x1p40, 0x1p40), 1'000'000), preparedIncident, runIncident<double>,
       judgeIncident<double>, 2, 0.3},
      {"light that arrives, single precision", "reflect.h: L 2^-21, fatt 2^-20 of it; a cosine 2^-19 off",
       incidentInput(floats(-1024, 1024), 1024), preparedIncident, runIncident<float>, judgeIncident<float>,
       2, 0.3},
      {"R.V", "reflect.h, equation.h: 2^-48", 9 * part, preparedVectors<double>,
       runCosine<double, Form::Textbook>, judgeCosine<double, Form::Textbook>},
      {"R.V, single precision", "reflect.h: 2^-19", 9 * part, preparedVectors<float>,
       runCosine<float, Form::Textbook>, judgeCosine<float, Form::Textbook>},
      {"N.H", "reflect.h, equation.h: 2^-49 where |L + V| > 2^-500", 9 * part, preparedVectors<double>,
       runCosine<double, Form::HalfVector>, judgeCosine<double, Form::HalfVector>},
      {"N.H, single precision", "reflect.h: 2^-20 where |L + V| > 2^-50", 9 * part, preparedVectors<float>,
       runCosine<float, Form::HalfVector>, judgeCosine<float, Form::HalfVector>},
      {"Phong's sum, single precision", "evaluated.h: (8 + 32 n) 2^-24, and 2^-40, n <= 1,024",
       integers(1, 1024) + 9 * part,
       [](In in) {
         return withUnits(in, {1, 4, 7});
       },
       runPhong, judgePhong},
      {"environment map, rotated", "environment.h: 2^-24 + n 2^-43, where |x, y| <= 1",
       2 * integers(0, 255) + integers(0, 1) + integers(0, 1'000'000) + share + 3 * part, preparedMap, runMap,
       judgeMap, 2, 0.01},
      {"environment look-up", "environment_map.h: 2^-24 of a column", part, nullptr, runLookUp, judgeLookUp},
      {"affine increments", "affine.h: (1/2 + 2^-7) (w + h) + 1 steps of 2^-24",
       triangleInput() + 3 * doubles(kLeastValue, kLargestValue), preparedTriangle, runAffine, judgeAffine},
      {"walk along an edge", "scanline.h: exact",
       4 * integers(-kGridReach, kGridReach) + integers(0, kMaxPicture - 1), preparedEdge, runEdge, judgeEdge,
       1},
      {"perspective division", division, dividedInput(-1024, 1024), preparedDivision, runDivision<double>,
       judgeDivision<double>},
      {"perspective division, single precision", division, dividedInput(-1024, 1024), preparedDivision,
       runDivision<float>, judgeDivision<float>},
      {"texture place", texel, dividedInput(0, 1) + integers(0, 1), preparedDivision, runTexel<double>,
       judgeTexel<double>},
      {"texture place, single precision", texel, dividedInput(0, 1) + integers(0, 1), preparedDivision,
       runTexel<float>, judgeTexel<float>},
  };
}

}  // namespace xnewell
