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
  double ambient;
  FrontBack<double> diffuse, I;
};

LitFace lit(const Illumination& user, const Mesh& mesh = square()) {
  const Lighting lighting = resolve(mesh, {}, user, Channels::Luminance, {0.5, 0.5, 9}, {0.5, 0.5, 0});
  const ShadingPoints points = facePoints(mesh);
  Terms diffuse, specular;
  Intensities intensities;
  diffuseIntensities(diffuse, points, lighting, 0);
  specularIntensities(specular, points, lighting, 0);
  addTerms(intensities, diffuse, specular, points, lighting, 0);
  return {lighting.materials[mesh.material[0] + 1].ambient[0], diffuse[0], intensities.I[0]};
}

// A light along the face lights neither side: not even a highlight shows there.
TEST(Illumination, GrazingLightLightsNothing) {
  for (const bool twoSided : {false, true}) {
    const LitFace grazing = lit({.ks = 0.4, .n = 2, .light = {0, 1, 0}, .twoSided = twoSided});
    EXPECT_EQ(grazing.I.front, grazing.ambient);
    EXPECT_EQ(grazing.I.back, grazing.ambient);
  }
}

// A point light at (0.5, 0.5, 6) shines straight down on the centroid. With constant L it shines from its
// direction as seen from the scene's centre.
TEST(Illumination, ConstantL) {
  Mesh m = square();
  m.points.push_back({0.5, 0.5, 4});  // the scene's centre is (0.5, 0.5, 2); its faces stay
  m.points.push_back({1.5, 0.5, 4});  // and now (0.75, 0.5, 2)
  Illumination light{.Ip = 1, .kd = 1, .ks = 0, .lightPosition = glm::dvec3{0.5, 0.5, 6}};
  EXPECT_EQ(lit(light, m).diffuse.front, 1.0);
  light.constantL = true;
  EXPECT_NEAR(lit(light, m).diffuse.front, 4 / std::sqrt(16 + 0.0625), 1e-15);
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

}  // namespace

}  // namespace xnewell::THIS_FILE
