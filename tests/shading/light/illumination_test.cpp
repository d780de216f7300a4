#include "shading/fill/intensities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "shading/fill/reflect.h"

namespace xnewell::THIS_FILE {

namespace {

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

}  // namespace

// A worked example: N = (0,0,1), L = (0, 0.6, 0.8): N.L = 0.8, R = (0, -0.6, 0.8). The eye in direction R
// sees R.V = 1: I = 0.9 0.2 + 0.7 (0.8 0.8 + 0.4) = 0.908. Straight above, R.V = 0.8 and the term is 0.7 0.4
// 0.8^3.
TEST(Illumination, EquationByHand) {
  const LitFace f = lit(kBook, glm::dvec3{0.5, 0.5, 0} + 10.0 * glm::dvec3{0, -0.6, 0.8});
  EXPECT_EQ(f.N, glm::dvec3(0, 0, 1));
  EXPECT_EQ(f.at, glm::dvec3(0.5, 0.5, 0));
  EXPECT_NEAR(f.ambient, 0.18, 1e-15);
  EXPECT_NEAR(f.diffuse.front, 0.7 * 0.8 * 0.8, 1e-15);
  EXPECT_NEAR(f.specular.front, 0.7 * 0.4, 1e-14);
  EXPECT_NEAR(f.I.front, 0.908, 1e-14);
  EXPECT_EQ(f.I.back, f.ambient);  // no light reaches the back
  EXPECT_NEAR(lit(kBook, {0.5, 0.5, 9}).specular.front, 0.7 * 0.4 * 0.512, 1e-14);
}

// With Ia = 1 alone, direction has no effect. With Ip = 1 alone, the back is black.
TEST(Illumination, TheTwoTellingExtremes) {
  const Illumination ambient{.Ia = 1, .Ip = 0, .ka = 0.9};
  EXPECT_EQ(lit(ambient, {0, 0, 5}).I.front, 0.9);
  EXPECT_EQ(lit(ambient, {0, 0, 5}).I.back, 0.9);
  const Illumination point{.Ia = 0, .Ip = 1, .kd = 0.9, .ks = 0, .light = {0, 0, 1}};
  EXPECT_EQ(lit(point, {0, 0, 5}).I.front, 0.9);
  EXPECT_EQ(lit(point, {0, 0, 5}).I.back, 0.0);
}

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

// The ends of the exponent's range: x^0 = 1, and n = 1,000,000 leaves only the mirror direction.
TEST(Illumination, ExponentsAtTheirEnds) {
  Illumination light = kBook;
  light.n = 0;
  EXPECT_NEAR(lit(light, {0.5, 0.5, 9}).specular.front, 0.28, 1e-15);
  light.n = 1'000'000;
  EXPECT_EQ(lit(light, {0.5, 0.5, 9}).specular.front, 0.0);
  light.light = {0, 0, 1};
  EXPECT_EQ(lit(light, {0.5, 0.5, 9}).specular.front, 0.7 * 0.4);
}

// An intensity above 1 is clamped, and the result says so.
TEST(Illumination, ClampsAndCounts) {
  Illumination light = kBook;
  light.light = {0, 0, 1};
  light.kd = light.ks = 1;
  const LitFace f = lit(light, {0.5, 0.5, 9});
  EXPECT_EQ(f.I.front, 1.0);
  EXPECT_TRUE(f.clamped);
  EXPECT_FALSE(lit(kBook, {0.5, 0.5, 9}).clamped);
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

// MTL colours become luminances on the ramp: green counts 0.59.
TEST(Illumination, MaterialsAsLuminance) {
  Mesh m = square();
  m.materials.push_back({"grass", {0, 1, 0}});
  m.material[0] = 0;
  const Illumination light{.Ia = 0.5, .Ip = 0.5, .ka = 1, .kd = 1, .ks = 0, .light = {0, 0, 1}};
  EXPECT_NEAR(lit(light, {0, 0, 5}, m).I.front, 0.59, 1e-15);
}

// The intensity is a number in [0, 1] for every light, material and eye.
TEST(Illumination, StaysInRange) {
  std::mt19937 rng{13};
  std::uniform_real_distribution<double> zeroToOne{0, 1}, exponent{-300, 300};
  for (int trial = 0; trial < 20'000; ++trial) {
    SCOPED_TRACE(trial);
    const auto wild = [&] { return (zeroToOne(rng) - 0.5) * std::pow(10.0, exponent(rng)); };
    Illumination light;
    light.Ia = zeroToOne(rng);
    light.Ip = 1 - light.Ia;
    light.ka = zeroToOne(rng), light.kd = zeroToOne(rng), light.ks = zeroToOne(rng);
    light.n = static_cast<int>(rng() % 1'000'001);
    light.light = {wild(), wild(), wild()};
    if (trial % 2) light.lightPosition = glm::dvec3{wild(), wild(), wild()};
    light.twoSided = trial % 3 != 0;
    const glm::dvec3 eye = trial % 5 ? glm::dvec3{wild(), wild(), wild()} : glm::dvec3{0.5, 0.5, 0};
    const LitFace f = lit(light, eye);
    for (const double I : {f.I.front, f.I.back}) ASSERT_TRUE(I >= 0 && I <= 1) << I;
    for (const FrontBack<double>& term : {f.diffuse, f.specular})
      ASSERT_TRUE(term.front >= 0 && term.back >= 0);
  }
}

namespace {

/// Diffuse light of a source at `height` above the square's centroid. With Ip = kd = 1 only f and s are left.
double diffuseBelow(double height, Light light, double unit = 1) {
  light.Ip = glm::dvec3{1};
  light.position = {0.5, 0.5, height};
  return lit({.kd = 1, .ks = 0}, {0, 0, 5}, square(), {0.5, 0.5, 0},
             {.Ia = {}, .lights = {light}, .unit = unit})
      .diffuse.front;
}

}  // namespace

// The attenuations agree with values worked by hand at d = 1/2, 2 and 10. As d -> 0 they are never above 1
// and never infinite.
TEST(Illumination, Attenuation) {
  const auto at = [](double d, Attenuation attenuation) {
    return diffuseBelow(d, {.kind = LightKind::Point,
                            .Ip = glm::dvec3{0.7},
                            .attenuation = attenuation,
                            .range = 4,
                            .c = {0.5, 0.25, 0.125}});
  };
  EXPECT_EQ(at(10, Attenuation::None), 1.0);
  EXPECT_EQ(at(0.5, Attenuation::Inverse), 1.0);
  EXPECT_EQ(at(2, Attenuation::Inverse), 0.5);
  EXPECT_EQ(at(10, Attenuation::InverseSquare), 0.01);
  EXPECT_EQ(at(1, Attenuation::Linear), 0.75);
  EXPECT_EQ(at(4, Attenuation::Linear), 0.0);
  EXPECT_EQ(at(10, Attenuation::Linear), 0.0);
  EXPECT_EQ(at(0.5, Attenuation::Textbook), 1.0);  // 0.5 + 0.125 + 0.03125 < 1
  EXPECT_EQ(at(2, Attenuation::Textbook), 1 / 1.5);
  for (const AttenuationRow& row : kAttenuations) {
    EXPECT_EQ(at(0, row.id), 0.0) << row.name;  // the light lies in the face: N.L is not above 0
    EXPECT_NEAR(at(1e-30, row.id), 1.0, 1e-15) << row.name;
    EXPECT_EQ(at(1e-200, row.id), 0.0) << row.name;  // as far as doubles can tell
  }
  // The file's unit sets what 1 is: 1/d in a scene whose unit is 1/8.
  EXPECT_EQ(
      diffuseBelow(
          0.5, {.kind = LightKind::Point, .Ip = glm::dvec3{0.7}, .attenuation = Attenuation::Inverse}, 0.125),
      0.25);
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

// Each channel is computed by itself, and several lights add up. The test has a red and a green light on a
// surface of half the blue.
TEST(Illumination, Channels) {
  Mesh m = square();
  m.materials.push_back({.name = "teal", .diffuse = {0.5, 1, 0.5}, .ka = 1, .kd = 1, .ks = 0});
  m.material[0] = 0;
  const SceneLight scene{.Ia = glm::dvec3{0.1, 0.1, 0.2},
                         .lights = {{.Ip = {0.8, 0, 0}}, {.Ip = {0, 0.3, 0}, .direction = {0, 3, 4}}}};
  const Lighting lighting = resolve(m, scene, {}, Channels::Rgb, {0, 0, 5}, {0, 0, 0});
  const ShadingPoints points = facePoints(m);
  const std::array expected{0.1 * 0.5 + 0.8 * 0.5, 0.1 + 0.3 * 0.8, 0.2 * 0.5};
  for (int c = 0; c < 3; ++c) {
    Terms diffuse;
    Intensities intensities;
    diffuseIntensities(diffuse, points, lighting, c);
    addTerms(intensities, diffuse, Terms(diffuse.size(), {0.0, 0.0}), points, lighting, c);
    EXPECT_NEAR(intensities.I[0].front, expected[c], 1e-15) << c;
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

}  // namespace xnewell::THIS_FILE
