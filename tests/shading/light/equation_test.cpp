#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "shading/fill/intensities.h"
#include "shading/fill/reflect.h"
#include "shading/light/depth_shading.h"
#include "shading/light/equation.h"
#include "tests/support/illuminate.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The equation

class Random {
 public:
  explicit Random(unsigned seed) : rng_{seed} {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(rng_()) * 0x1p-32);
  }
  int below(int end) { return static_cast<int>(rng_() % static_cast<unsigned>(end)); }
  glm::dvec3 vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  glm::dvec3 color() { return {uniform(0, 1), uniform(0, 1), uniform(0, 1)}; }
  Light light() {
    Light light{
        .kind = kLights[below(3)].id, .Ip = color(), .direction = vector(), .position = 3.0 * vector()};
    light.attenuation = kAttenuations[below(5)].id;
    light.range = uniform(0.5, 6);
    light.c = color();
    light.inner = uniform(1, 60), light.outer = below(4) == 0 ? light.inner : light.inner + uniform(1, 60);
    light.falloff = below(8);
    return light;
  }
  MeshMaterial material() {
    MeshMaterial m{.name = "", .diffuse = color()};
    m.specular = color();
    m.ka = uniform(0, 1), m.kd = uniform(0, 1), m.ks = uniform(0, 1);
    m.n = below(4) == 0 ? below(1'000'001) : below(12);
    return m;
  }

 private:
  std::mt19937 rng_;
};

double cosineOf(double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); }

/// Whether the equation has no jump at that place: a highlight begins at once where N.L = 0, and so does a
/// cone without a soft border.
bool isSmooth(const Light& light, const glm::dvec3& N, const glm::dvec3& L) {
  if (std::abs(glm::dot(N, L)) < 1e-9) return false;
  const double off = -glm::dot(glm::normalize(light.direction), L) - cosineOf(light.outer);
  return light.kind != LightKind::Spot || std::abs(off) > 1e-9;
}

/// How far two computations of the terms may differ, for Ip = kd = ks = 1. u = 2^-53.
///
/// Either has the parts of L, V and H within 6 u of the exact unit vectors, divided by |L + V| for H, so a
/// dot product is within 15 u, and R.V = 2 (N.L)(N.V) - L.V within 80 u. The power multiplies that by n and
/// adds n u for its own roundings. The share of a spot is a quotient of cosines, to the power of its falloff.
/// fatt is within 16 u. Two computations: twice that, 2^8 u n and less.
double boundOf(const Light& light, const Reflection& surface, Form form, const glm::dvec3& L,
               const glm::dvec3& V) {
  const double width = cosineOf(light.inner) - cosineOf(light.outer);
  const double spot = light.kind == LightKind::Spot && width > 1e-9 ? light.falloff / width : 0;
  const double half = form == Form::HalfVector ? glm::length(L + V) : 1;
  return 0x1p-45 * (1 + spot + surface.n / half);
}

// The loops that take several places at once give what the equation gives, for all kinds of lights,
// attenuations, forms and materials, on both sides of a surface, in each channel.
TEST(Equation, LoopsOverManyPlacesGiveTheSame) {
  int compared = 0, highlights = 0, dimmed = 0, inCones = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random{seed};
    const Form form = kForms[random.below(3)].id;
    const Illumination user{
        .form = form, .constantV = random.below(3) == 0, .twoSided = random.below(3) != 0};
    SceneLight scene{.Ia = random.color(), .lights = {}, .unit = random.uniform(0.2, 3)};
    for (int k = random.below(3); k >= 0; --k) scene.lights.push_back(random.light());
    Mesh mesh;
    for (int k = random.below(3); k >= 0; --k) mesh.materials.push_back(random.material());
    ShadingPoints points;
    for (int k = 0; k < 60; ++k) {
      mesh.points.push_back(random.vector());
      points.at.push_back(mesh.points.back());
      points.N.push_back(glm::normalize(random.vector()));
      points.material.push_back(random.below(static_cast<int>(mesh.materials.size())));
    }
    mesh.material = points.material;  // only lights that a face reflects are kept
    const glm::dvec3 eye = 4.0 * random.vector(), lookAt = random.vector();
    const Lighting lighting = resolve(mesh, scene, user, Channels::Rgb, eye, lookAt);
    for (int c = 0; c < 3; ++c) {
      Terms diffuseTerms, specularTerms;
      Intensities intensities;
      diffuseIntensities(diffuseTerms, points, lighting, c);
      specularIntensities(specularTerms, points, lighting, c);
      addTerms(intensities, diffuseTerms, specularTerms, points, lighting, c);
      for (std::size_t k = 0; k < points.at.size(); ++k)
        for (const bool back : {false, true}) {
          const MeshMaterial& m = mesh.materials[points.material[k]];
          const Reflection surface{*m.ka * m.diffuse[c], *m.kd * m.diffuse[c], *m.ks * m.specular[c], *m.n};
          const glm::dvec3 N = (back && user.twoSided ? -1.0 : 1.0) * points.N[k], P = points.at[k];
          const glm::dvec3 V = glm::normalize(eye - (user.constantV ? lookAt : P));
          double ambient = 0, diffuse = 0, specular = 0, bound = 0;
          bool smooth = true;
          for (const Light& light : scene.lights) {
            const IlluminationTerms terms =
                illuminate((*scene.Ia)[c], light.Ip[c], light, surface, N, V, P, form, scene.unit);
            ambient = terms.ambient, diffuse += terms.diffuse, specular += terms.specular;
            dimmed += terms.fatt<0.9, inCones += terms.spot> 0 && terms.spot < 1;
            const bool far = light.kind == LightKind::Directional;
            const glm::dvec3 L = glm::normalize(far ? light.direction : light.position - P);
            smooth &= isSmooth(light, N, L);
            bound += boundOf(light, surface, form, L, V);
          }
          if (!smooth) continue;
          // What the loops leave out: highlights below 2^-40 of a light.
          const double faint = 0x1p-40 * static_cast<double>(scene.lights.size());
          ASSERT_NEAR(diffuseTerms[k].seen(back), diffuse, bound) << k;
          ASSERT_NEAR(specularTerms[k].seen(back), specular, bound + faint) << k;
          ASSERT_NEAR(intensities.I[k].seen(back), std::min(1.0, ambient + diffuse + specular),
                      2 * bound + faint)
              << k;
          ++compared, highlights += specular > 0.01;
        }
    }
  }
  EXPECT_GT(compared, 100'000);
  EXPECT_GT(highlights, 5'000);
  EXPECT_GT(dimmed, 10'000);
  EXPECT_GT(inCones, 1'000);
}

/// ---- Depth shading

using Real = boost::multiprecision::cpp_bin_float_50;
using Vector = std::array<Real, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unitOf(const Vector& a) {
  const Real length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return {a[0] / length, a[1] / length, a[2] / length};
}
double sumOf(const glm::dvec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

/// Faces of 3 to 9 corners in one plane across the view, rounded to doubles, at any place and of any size;
/// the last one may be moved away from the eye.
struct Across {
  Mesh mesh;
  SnappedScene snapped;
  ViewSpec view;
  double bound = 0.0;  ///< what the header lets rounding explain

  explicit Across(unsigned seed) : rng_{seed} {
    view.vpn = {any(1.0), any(1.0), any(1.0)};
    view.vup = {any(1.0), any(1.0), any(1.0)};
    view.vrp = std::exp2(any(12.0)) * glm::dvec3{any(1.0), any(1.0), any(1.0)};
    N_ = unitOf({view.vpn.x, view.vpn.y, view.vpn.z});
    u_ = unitOf(cross(N_, {view.vup.x, view.vup.y, view.vup.z}));
    v_ = cross(N_, u_);
    size_ = std::exp2(any(12.0));
    for (unsigned f = 0; f < 2 + seed % 20; ++f) add(0.0);
  }
  void add(double behind) {
    const int n = 3 + static_cast<int>(rng_() % 7);
    std::vector<int> corners;
    for (int k = 0; k < n; ++k) {
      const Real a = any(size_), b = any(size_);
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<double>(Real{view.vrp[axis]} + a * u_[axis] + b * v_[axis] - behind * N_[axis]);
      corners.push_back(static_cast<int>(mesh.points.size()));
      mesh.points.push_back(p);
      bound = std::max(bound, 2.0 * (n + 9) * 0x1p-53 * (sumOf(p) + sumOf(view.vrp)));
    }
    snapped.faces.push_back({.number = mesh.faceCount()});
    mesh.addFace(corners, 0);
  }
  [[nodiscard]] std::vector<double> intensities() const { return depthIntensities(mesh, snapped, view); }
  /// The distance between the nearest and the farthest mean, as the program's z of the corners have it.
  [[nodiscard]] double apart() const {
    std::vector<double> means;
    for (const SnappedFace& face : snapped.faces) {
      double sum = 0.0;
      const DepthTerms terms = depthTerms(mesh, view, {.near = 0.0, .length = 1.0}, face.number);
      for (const double z : terms.z) sum += z;
      means.push_back(sum / static_cast<double>(terms.z.size()));
    }
    const auto [least, most] = std::ranges::minmax_element(means);
    return *most - *least;
  }

 private:
  double any(double most) { return std::uniform_real_distribution<double>{-most, most}(rng_); }

  std::mt19937 rng_;
  double size_;
  Vector N_, u_, v_;
};

// Faces in a plane across the view have one depth, whatever rounding makes of their corners: all have the
// intensity 1. Random errors mostly cancel: the largest share of the bound is 0.02.
TEST(DepthShading, OneDepthWhateverTheDirection) {
  double most = 0.0;
  const Seeds seeds{2'000};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const Across across{seed};
    const double share = across.apart() / across.bound;
    ASSERT_LE(share, 1.0);
    most = std::max(most, share);
    EXPECT_EQ(depthRange(across.mesh, across.snapped, across.view).length, 0.0);
    for (const double I : across.intensities()) ASSERT_EQ(I, 1.0);
  }
  if (seeds.all()) {
    EXPECT_GT(most, 0.01);
  }
}

// A face that lies farther away by three times the bound is told apart: it has 0, and the others have
// nearly 1.
TEST(DepthShading, DepthsBeyondRoundingDiffer) {
  const Seeds seeds{2'000};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    Across across{seed};
    across.add(3.0 * across.bound);
    const std::vector<double> I = across.intensities();
    EXPECT_EQ(I.back(), 0.0);
    EXPECT_EQ(std::ranges::max(I), 1.0);
    for (std::size_t f = 0; f + 1 < I.size(); ++f) EXPECT_GT(I[f], 0.5);
  }
}

/// ---- Mistakes

struct Values {
  double diffuse, specular;
};

/// What each mistake computes, written out by hand from its name, for the textbook's form. N, L and V are
/// unit vectors; kd = 0.9, ks = 0.4, f = 0.5, Ip = 0.7.
Values byHand(Mistake mistake, const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V, int n) {
  const double kd = 0.9, ks = 0.4, fIp = 0.35;
  const double NL = N.x * L.x + N.y * L.y + N.z * L.z;
  const double NV = N.x * V.x + N.y * V.y + N.z * V.z;
  const double LV = L.x * V.x + L.y * V.y + L.z * V.z;
  const double RV = 2 * NL * NV - LV;
  const auto pos = [](double v) { return v > 0 ? v : 0; };
  const double lit = NL > 0 ? 1 : 0, d = fIp * kd * pos(NL), s = lit * fIp * ks * std::pow(pos(RV), n);
  switch (mistake) {
    case Mistake::None:
    case Mistake::NotUnitN:  // that is for whoever makes N
    case Mistake::NoAmbient:
    case Mistake::TwiceAmbient:
      return {d, s};
    case Mistake::FacingUnclamped:
      return {fIp * kd * NL, s};
    case Mistake::FacingAbsolute:
      return {fIp * kd * std::abs(NL), s};
    case Mistake::FacingByAngle:
      return {fIp * kd * pos(1 - std::acos(NL) / std::acos(0.0)), s};
    case Mistake::ReflectedUnclamped:
      return {d, lit * fIp * ks * std::pow(RV, n)};
    case Mistake::ReflectedAbsolute:
      return {d, lit * fIp * ks * std::pow(std::abs(RV), n)};
    case Mistake::HighlightBehind:
      return {d, fIp * ks * std::pow(pos(RV), n)};
    case Mistake::InwardN:  // R stays
      return {fIp * kd * pos(-NL), NL < 0 ? fIp * ks * std::pow(pos(RV), n) : 0};
    case Mistake::ReversedL:
      return {fIp * kd * pos(-NL), NL < 0 ? fIp * ks * std::pow(pos(-RV), n) : 0};
    case Mistake::ReversedV:
    case Mistake::ReversedR:  // the same by algebra
      return {d, lit * fIp * ks * std::pow(pos(-RV), n)};
    case Mistake::RWithout2:
      return {d, lit * fIp * ks * std::pow(pos(NL * NV - LV), n)};
    case Mistake::PowerOfSum: {
      const double sum = kd * pos(NL) + ks * pos(RV);
      const double both = fIp * std::pow(sum, n), share = sum > 0 ? ks * pos(RV) / sum : 0;
      return {both * (1 - share), lit * both * share};
    }
    case Mistake::NoPower:
      return {d, lit * fIp * ks * pos(RV)};
    case Mistake::KsInPower:
      return {d, lit * fIp * std::pow(ks * pos(RV), n)};
    case Mistake::HighlightTimesFacing:
      return {d, s * pos(NL)};
    case Mistake::SwappedKs:
      return {d * ks / kd, s * kd / ks};
    case Mistake::NoIp:
      return {d / 0.7, s / 0.7};
    case Mistake::IpNotOnHighlight:
      return {d, s / 0.7};
    case Mistake::NoDiffuse:
      return {0, s};
    case Mistake::NoSpecular:
      return {d, 0};
  }
  return {NAN, NAN};
}

glm::dvec3 anyDirection(std::mt19937& random) {
  std::uniform_real_distribution<double> number{-1.0, 1.0};
  return glm::normalize(glm::dvec3{number(random), number(random), number(random)});
}

// Each row computes what its name says, in front of the light and behind it, for even and odd n. On some
// place each of them differs from the course's equation, or it is one that changes no term of a light.
TEST(Mistake, ComputesWhatItsNameSays) {
  const Reflection surface[2] = {{0.5, 0.9, 0.4, 3}, {0.5, 0.9, 0.4, 6}};
  for (const MistakeRow& row : kMistakes) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(&row, &rowOf(row.id));
    double differs = 0;
    for (unsigned seed = 0; seed < 2'000; ++seed) {
      std::mt19937 random{seed};
      const EquationVectors at{anyDirection(random), anyDirection(random), anyDirection(random)};
      const Reflection& one = surface[seed % 2];
      const LightTerms terms = lightTerms(row.id, 0.5, 0.7, one, at, Form::Textbook);
      const Values hand = byHand(row.id, at.N, at.L, at.V, one.n);
      ASSERT_NEAR(terms.diffuse, hand.diffuse, 1e-12) << seed;
      ASSERT_NEAR(terms.specular, hand.specular, 1e-12) << seed;
      const IlluminationTerms course = termsOf(0.0, 0.7, 0.5, 1.0, one, glm::dot(at.N, at.L),
                                               specularCosine(Form::Textbook, at.N, at.L, at.V));
      differs = std::max(
          {differs, std::abs(terms.diffuse - course.diffuse), std::abs(terms.specular - course.specular)});
      if (row.id != Mistake::None) continue;
      ASSERT_EQ(terms.diffuse, course.diffuse);
      ASSERT_EQ(terms.specular, course.specular);
    }
    const bool elsewhere = row.id == Mistake::None || row.longN || row.ambient != 1.0;
    EXPECT_EQ(differs > 0.01, !elsewhere);
  }
}

// Names are those of options: unique, without blanks. Each row has words for every place that shows them.
TEST(Mistake, HasNamesAndWords) {
  std::set<std::string_view> names;
  for (const MistakeRow& row : kMistakes) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(row.name.find(' '), std::string_view::npos) << row.name;
    EXPECT_FALSE(row.label.empty() || row.words.empty()) << row.name;
    EXPECT_TRUE(row.is.ends_with('.')) << row.name;
  }
}

/// ---- Lights and materials

/// A unit square in z = 0, counter-clockwise from +z, its centroid (0.5, 0.5, 0).
Mesh square() {
  Mesh m;
  m.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const int corners[] = {0, 1, 2, 3};
  m.addFace(corners, 0);
  return m;
}

/// The result of flat shading for the first face, in one channel.
struct LitFace {
  glm::dvec3 N, at;
  double ambient;
  FrontBack<double> diffuse, specular, I;
  bool clamped;
};

LitFace lit(const Illumination& user, glm::dvec3 eye, const Mesh& mesh = square(),
            glm::dvec3 lookAt = {0.5, 0.5, 0}, const SceneLight& scene = {}) {
  const Lighting lighting = resolve(mesh, scene, user, Channels::Luminance, eye, lookAt);
  const ShadingPoints points = facePoints(mesh);
  Terms diffuse, specular;
  Intensities intensities;
  diffuseIntensities(diffuse, points, lighting, 0);
  specularIntensities(specular, points, lighting, 0);
  addTerms(intensities, diffuse, specular, points, lighting, 0);
  return {points.N[0],
          points.at[0],
          lighting.materials[mesh.material[0] + 1].ambient[0],
          diffuse[0],
          specular[0],
          intensities.I[0],
          intensities.clamped > 0};
}

const Illumination kBook{.Ia = 0.2, .Ip = 0.7, .ka = 0.9, .kd = 0.8, .ks = 0.4, .n = 3, .light = {0, 3, 4}};

// A light behind a face lights its back. If surfaces are one-sided, both sides get only the ambient term. R.V
// is clamped before the power, so that an even n does not make a highlight of a negative value. A grazing
// light lights nothing.
TEST(Illumination, LightBehindAndEvenPowers) {
  Illumination light = kBook;
  light.light = {0, 3, -4};
  light.n = 2;
  const LitFace f = lit(light, {0.5, 0.5, -9});
  EXPECT_EQ(f.I.front, f.ambient);
  EXPECT_NEAR(f.I.back, f.ambient + 0.7 * (0.8 * 0.8 + 0.4 * 0.64), 1e-14);
  EXPECT_EQ(lit(light, {0.5, 0.5, 9}).specular.back, 0.0);  // R.V = -0.8
  light.twoSided = false;
  const LitFace one = lit(light, {0.5, 0.5, -9});
  EXPECT_EQ(one.I.front, one.ambient);
  EXPECT_EQ(one.I.back, one.ambient);
  light.light = {0, 1, 0};
  const LitFace grazing = lit(light, {0.5, 0.5, 9});
  EXPECT_EQ(grazing.I.front, grazing.ambient);
}

// A point light at (0.5, 0.5, 2) shines straight down on the centroid. With constant L it shines from its
// direction as seen from the scene's centre. A constant V points along the line between the eye and the
// look-at point.
TEST(Illumination, ConstantLAndV) {
  Mesh m = square();
  m.points.push_back({0.5, 0.5, 4});  // the scene's centre is (0.5, 0.5, 2); its faces stay
  m.points.push_back({1.5, 0.5, 4});  // and now (0.75, 0.5, 2)
  Illumination light{.Ip = 1, .kd = 1, .ks = 0, .lightPosition = glm::dvec3{0.5, 0.5, 6}};
  EXPECT_EQ(lit(light, {0, 0, 5}, m).diffuse.front, 1.0);
  light.constantL = true;
  EXPECT_NEAR(lit(light, {0, 0, 5}, m).diffuse.front, 4 / std::sqrt(16 + 0.0625), 1e-15);

  Illumination v{.Ia = 0, .Ip = 1, .kd = 0, .ks = 1, .n = 1, .light = {0, 0, 1}};
  EXPECT_NEAR(lit(v, {4.5, 0.5, 3}).specular.front, 0.6, 1e-15);
  v.constantV = true;
  EXPECT_NEAR(lit(v, {4.5, 0.5, 3}, square(), {4.5, 0.5, 0}).specular.front, 1.0, 1e-15);
}

/// Diffuse light of a source at `height` above the square's centroid. With Ip = kd = 1 only f and s are left.
double diffuseBelow(double height, Light light, double unit = 1) {
  light.Ip = glm::dvec3{1};
  light.position = {0.5, 0.5, height};
  return lit({.kd = 1, .ks = 0}, {0, 0, 5}, square(), {0.5, 0.5, 0},
             {.Ia = {}, .lights = {light}, .unit = unit})
      .diffuse.front;
}

// Between its cones, a spot's share is (cos a - cos 20) / (cos 15 - cos 20) to the power of the falloff. The
// spot is straight above and shines past the centroid by a = 0, 15, 17.5, 20 and 25 degrees; its cones are at
// 15 and 20.
TEST(Illumination, Spot) {
  const auto at = [](double degrees, int falloff, double outer = 20) {
    const double a = degrees * std::acos(-1.0) / 180;
    return diffuseBelow(3, {.kind = LightKind::Spot,
                            .Ip = glm::dvec3{0.7},
                            .direction = {std::sin(a), 0, -std::cos(a)},
                            .inner = 15,
                            .outer = outer,
                            .falloff = falloff});
  };
  const auto cosine = [](double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); };
  const double between = (cosine(17.5) - cosine(20)) / (cosine(15) - cosine(20));
  EXPECT_EQ(at(0, 1), 1.0);
  EXPECT_EQ(at(14.999, 1), 1.0);
  EXPECT_NEAR(at(17.5, 1), between, 1e-13);
  EXPECT_NEAR(at(17.5, 3), between * between * between, 1e-13);
  EXPECT_EQ(at(20.001, 1), 0.0);
  EXPECT_EQ(at(25, 1), 0.0);
  EXPECT_EQ(at(14.999, 1, 15), 1.0);  // equal cones are a step
  EXPECT_EQ(at(15.001, 1, 15), 0.0);
}

// The three forms of the specular term have the values worked by hand. L and V lie in one plane with N, 30
// degrees to the left and 50 to the right: R.V = cos 20, N.H = cos 10, N.L = cos 30.
TEST(Illumination, Forms) {
  const auto cosine = [](double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); };
  const auto specular = [&](Form form, int n) {
    const double a = std::acos(-1.0) / 180;
    return lit({.Ip = 1, .ks = 1, .n = n, .light = {-std::sin(30 * a), 0, std::cos(30 * a)}, .form = form},
               glm::dvec3{0.5, 0.5, 0} + 2.0 * glm::dvec3{std::sin(50 * a), 0, std::cos(50 * a)})
        .specular.front;
  };
  for (const int n : {1, 2, 7}) {
    EXPECT_NEAR(specular(Form::Textbook, n), std::pow(cosine(20), n), 1e-14);
    EXPECT_NEAR(specular(Form::HalfVector, n), std::pow(cosine(10), n), 1e-14);
    EXPECT_NEAR(specular(Form::Tutorial, n), std::pow(cosine(30), n), 1e-14);
  }
}

// A light without intensity, or one that falls to nothing before it reaches the scene, is left out.
TEST(Illumination, LightsThatCannotReachCostNothing) {
  const Light far{.kind = LightKind::Point,
                  .Ip = glm::dvec3{0.7},
                  .position = {0, 0, 9},
                  .attenuation = Attenuation::Linear,
                  .range = 8.9};
  Light near = far;
  near.range = 9.1;
  const auto sources = [](const Light& light) {
    return resolve(square(), {.Ia = {}, .lights = {light}}, {}, Channels::Rgb, {0, 0, 5}, {0, 0, 0})
        .sources.size();
  };
  EXPECT_EQ(sources(far), 0u);
  EXPECT_EQ(sources(near), 1u);
  near.Ip = glm::dvec3{0};
  EXPECT_EQ(sources(near), 0u);
}

// Points evaluated several at a time, with the processor's own instructions, have the same bits as points
// evaluated one at a time by code for any processor.
TEST(Illumination, SideBySideAsAlone) {
  std::mt19937 rng{2};
  const auto uniform = [&] { return 2.0 * (static_cast<double>(rng()) * 0x1p-32) - 1.0; };
  for (const FormRow& form : kForms) {
    ShadingPoints points;
    for (int k = 0; k < 1001; ++k) {
      points.at.emplace_back(uniform(), uniform(), uniform());
      points.N.push_back(glm::normalize(glm::dvec3{uniform(), uniform(), uniform()}));
      points.material.push_back(k / 10 % 3 - 1);  // runs of a length that no number of lanes divides
    }
    Mesh m = square();
    m.materials = {{.name = "dull", .ks = 0.3, .n = 7}, {.name = "shiny", .ks = 0.9, .n = 200}};
    const SceneLight scene{
        .Ia = {},
        .lights = {
            {.kind = LightKind::Spot, .Ip = glm::dvec3{0.7}, .direction = {0, 0, -1}, .position = {0, 0, 3}},
            {.kind = LightKind::Point,
             .Ip = glm::dvec3{0.7},
             .position = {2, 1, 0},
             .attenuation = Attenuation::InverseSquare}}};
    const Lighting lighting =
        resolve(m, scene, {.form = form.id}, Channels::Luminance, {1, -3, 2}, {0, 0, 0});
    Terms diffuseTerms, specularTerms;
    diffuseIntensities(diffuseTerms, points, lighting, 0);
    specularIntensities(specularTerms, points, lighting, 0);
    const auto vec = [](const glm::dvec3& v) { return Vec<double>{v.x, v.y, v.z}; };
    int lit = 0;
    for (std::size_t k = 0; k < points.at.size(); ++k) {
      const Material& material = lighting.materials[points.material[k] + 1];
      const Vec<double> at = vec(points.at[k]), N = vec(points.N[k]);
      FrontBack<double> diffuse{0, 0}, specular{0, 0};
      for (const Lighting::Source& light : lighting.sources) {
        const Incident<double> in = incident(light, at);
        const FrontBack<double> d = diffuseTerm(in, N, true);
        const FrontBack<double> s = specularTerm(in, N, towardsEye(lighting, at), material, lighting);
        const double kd = light.Ip[0] * material.kd[0], ks = light.Ip[0] * material.ks[0];
        diffuse = {diffuse.front + kd * d.front, diffuse.back + kd * d.back};
        specular = {specular.front + ks * s.front, specular.back + ks * s.back};
      }
      ASSERT_EQ(diffuse.front, diffuseTerms[k].front) << k;
      ASSERT_EQ(diffuse.back, diffuseTerms[k].back) << k;
      ASSERT_EQ(specular.front, specularTerms[k].front) << k;
      ASSERT_EQ(specular.back, specularTerms[k].back) << k;
      lit += specular.front > 0 || specular.back > 0;
    }
    EXPECT_GT(lit, 100);
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
