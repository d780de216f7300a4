#include "shading/light/equation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "shading/fill/intensities.h"
#include "tests/support/illuminate.h"

namespace xnewell::THIS_FILE {

namespace {

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

}  // namespace

// N.L = 0.8 and R.V = 0.8 by hand: I = 0.9 0.2 + 0.5 [0.8 0.8 + 0.4 0.8^3], at a distance of 2 that halves
// Ip.
TEST(Equation, TermsByHand) {
  const Light light{.kind = LightKind::Point,
                    .Ip = glm::dvec3{0.7},
                    .position = {0, 1.2, 1.6},
                    .attenuation = Attenuation::Inverse};
  const IlluminationTerms terms =
      illuminate(0.2, 1, light, {0.9, 0.8, 0.4, 3}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0}, Form::Textbook);
  EXPECT_NEAR(terms.ambient, 0.18, 1e-15);
  EXPECT_NEAR(terms.fatt, 0.5, 1e-15);
  EXPECT_EQ(terms.spot, 1);
  EXPECT_NEAR(terms.diffuse, 0.5 * 0.8 * 0.8, 1e-15);
  EXPECT_NEAR(terms.specular, 0.5 * 0.4 * 0.512, 1e-15);
  EXPECT_EQ(terms.I, terms.ambient + terms.diffuse + terms.specular);
}

// A light behind the surface leaves the ambient term alone, and so does one at the surface's own place.
TEST(Equation, NothingFromBehind) {
  for (const glm::dvec3 position : {glm::dvec3{0, 0, -1}, {0, 0, 0}, {1, 0, 0}}) {
    const IlluminationTerms terms =
        illuminate(0.2, 1, {.kind = LightKind::Point, .Ip = glm::dvec3{0.7}, .position = position},
                   {1, 1, 1, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0}, Form::Textbook);
    EXPECT_EQ(terms.I, 0.2);
  }
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

}  // namespace xnewell::THIS_FILE
