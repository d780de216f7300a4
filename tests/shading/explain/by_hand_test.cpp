#include <gtest/gtest.h>

#include <cmath>

#include "shading/color/color_table.h"
#include "shading/explain/explain.h"
#include "shading/explain/pixel_history.h"
#include "shading/light/mistake.h"
#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

// Values computed by hand from the papers that the program follows. The numbers below are theirs, or follow
// from theirs in a line of arithmetic that stands beside them.
//   assignment: "Implementing shading", the handout for the teapot: Ia, Ip, ka, kd, color(I), I0 and r.
//   notes: lecture notes on the lighting equation: I = A kA + L kD cos(theta) + L kS [(2N(N.L) - L).V]^p.
//   tutorial: the demo coders' tutorial: c = ambient + cos x diffuse + (cos x)^n specular.

namespace {

/// A square that faces the viewer, from z = 0. N and V are (0, 0, 1) in its middle.
Picture squareLitFrom(const glm::dvec3& L, const Illumination& light, TableKind table) {
  Mesh mesh;
  mesh.groupNames = {""};
  std::vector<int> face;
  for (const glm::dvec2 d : {glm::dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    face.push_back(static_cast<int>(mesh.points.size()));
    mesh.points.push_back({d, 0});
  }
  mesh.addFace(face, 0);
  PictureSettings s;
  s.width = s.height = 40;
  s.shading = Shading::Flat;
  s.camera.eye = glm::dvec3{0, 0, 20};
  s.camera.lookAt = glm::dvec3{0, 0, 0};
  s.camera.parallel = true;
  s.camera.height = 4.0;
  s.light = light;
  s.light.light = L;
  s.table.kind = table;
  return makePicture(makeScene("square", mesh, UpAxis::Y), s, 8);
}

struct Chain {
  double I;
  int cell, stored;
};
Chain chainOf(const glm::dvec3& L, const Illumination& light, TableKind table = TableKind::Linear) {
  const Picture picture = squareLitFrom(L, light, table);
  const int face = picture.seen(20, 21).faces[20];
  const Explanation e = PixelExplainer{picture}(face, 20, 20);
  return {e.intensity, e.value[0], picture.image().row(20)[20]};
}

}  // namespace

// assignment: "set Ia = .5 and Ip = .5. Or possibly Ia = .2 and Ip = .8", "choose Ka and Kd to be near 1.
// Perhaps .9", "color(I) = round(11 + 239*I)". A polygon that faces the light has N.L = 1, so without a
// highlight I = 0.9 (Ia + Ip) = 0.9 in both, and color = round(11 + 215.1) = 226. At 60 degrees N.L = 0.5.
TEST(ByHand, TheAssignmentsSquare) {
  const glm::dvec3 facing{0, 0, 1}, slanted{std::sqrt(3.0), 0, 1};
  Illumination half{.Ia = 0.5, .Ip = 0.5, .ka = 0.9, .kd = 0.9, .ks = 0.0};
  Illumination fifth{.Ia = 0.2, .Ip = 0.8, .ka = 0.9, .kd = 0.9, .ks = 0.0};
  for (const Illumination& light : {half, fifth}) {
    const Chain chain = chainOf(facing, light);
    EXPECT_NEAR(chain.I, 0.9, 1e-12);
    EXPECT_EQ(chain.cell, 226);
    EXPECT_EQ(chain.stored, 226);
  }
  const Chain even = chainOf(slanted, half);  // 0.45 + 0.5 0.9 0.5 = 0.675; 11 + 161.325
  EXPECT_NEAR(even.I, 0.675, 1e-12);
  EXPECT_EQ(even.stored, 172);
  const Chain pointed = chainOf(slanted, fifth);  // 0.18 + 0.8 0.9 0.5 = 0.54; 11 + 129.06
  EXPECT_NEAR(pointed.I, 0.54, 1e-12);
  EXPECT_EQ(pointed.stored, 140);
}

// assignment: "the cases Ia = 1 or Ip = 1 should look very different". Ia = 1: 0.9 from any side. Ip = 1: 0.9
// N.L, and 0 from behind.
TEST(ByHand, OnlyAmbientAndOnlyPoint) {
  const glm::dvec3 facing{0, 0, 1}, slanted{std::sqrt(3.0), 0, 1}, behind{0, 0, -1};
  const Illumination ambient{.Ia = 1.0, .Ip = 0.0, .ka = 0.9, .kd = 0.9, .ks = 0.0};
  const Illumination point{.Ia = 0.0, .Ip = 1.0, .ka = 0.9, .kd = 0.9, .ks = 0.0};
  for (const glm::dvec3& L : {facing, slanted, behind}) EXPECT_NEAR(chainOf(L, ambient).I, 0.9, 1e-12);
  EXPECT_NEAR(chainOf(facing, point).I, 0.9, 1e-12);
  EXPECT_NEAR(chainOf(slanted, point).I, 0.45, 1e-12);  // 11 + 107.55 rounds to 119
  EXPECT_EQ(chainOf(slanted, point).stored, 119);
  EXPECT_EQ(chainOf(behind, point).I, 0.0);
  EXPECT_EQ(chainOf(behind, point).stored, 11);
}

// assignment: "I0 = .02", "r = (1./.02)**(1./239.)", "j = round(log (I/I0))", "setting color 11+i". For I =
// 0.54, log 27 / log r = 3.2958 / 0.016368 = 201.35, so cell 11 + 201; for I = 0.9 it is 232.56, cell 244.
TEST(ByHand, TheCorrectedTable) {
  const glm::dvec3 facing{0, 0, 1}, slanted{std::sqrt(3.0), 0, 1};
  const Illumination fifth{.Ia = 0.2, .Ip = 0.8, .ka = 0.9, .kd = 0.9, .ks = 0.0};
  EXPECT_EQ(chainOf(slanted, fifth, TableKind::Corrected).stored, 212);
  EXPECT_EQ(chainOf(facing, fifth, TableKind::Corrected).stored, 244);
}

// notes: R = 2P - L with P = N (N.L), "if it is negative, change it to 0". N = (0, 0, 1), L = (0.6, 0, 0.8):
// N.L = 0.8, P = (0, 0, 0.8), R = (-0.6, 0, 0.8). V = (0, 0, 1): cos(phi) = 0.8. With A = 51 of 255, L = 204
// of 255, kA = kD = 0.9, kS = 0.4, p = 2: 45.9 + 146.88 + 52.224 = 245.004 of 255.
TEST(ByHand, TheNotesReflection) {
  const EquationVectors at{{0, 0, 1}, {0.6, 0, 0.8}, {0, 0, 1}};
  const LightTerms terms =
      lightTerms(Mistake::None, 1.0, 204.0 / 255.0, {0.9, 0.9, 0.4, 2}, at, Form::Textbook);
  EXPECT_NEAR(terms.NdotL, 0.8, 1e-15);
  EXPECT_NEAR(terms.R.x, -0.6, 1e-15);
  EXPECT_NEAR(terms.R.z, 0.8, 1e-15);
  EXPECT_NEAR(terms.cosine, 0.8, 1e-15);
  EXPECT_NEAR(terms.diffuse, 146.88 / 255.0, 1e-15);
  EXPECT_NEAR(terms.specular, 52.224 / 255.0, 1e-15);
  const Illumination light{.Ia = 0.2, .Ip = 0.8, .ka = 0.9, .kd = 0.9, .ks = 0.4, .n = 2};
  EXPECT_NEAR(chainOf({0.6, 0, 0.8}, light).I, 245.004 / 255.0, 1e-12);
  // The eye on the other side of N: R.V = -0.6 0.8 + 0.8 0.6 = 0, and beyond that it is changed to 0.
  const EquationVectors away{{0, 0, 1}, {0.6, 0, 0.8}, {1, 0, 0}};
  const LightTerms none = lightTerms(Mistake::None, 1.0, 0.8, {0.9, 0.9, 0.4, 2}, away, Form::Textbook);
  EXPECT_NEAR(none.cosine, -0.6, 1e-15);
  EXPECT_EQ(none.specular, 0.0);
}

// tutorial: "when the angle is over 90 degrees ... the color getting the value ambient". At 60 degrees with n
// = 3: 0.1 + 0.5 0.6 + 0.125 0.3 = 0.4375.
TEST(ByHand, TheTutorialsColor) {
  const Illumination light{
      .Ia = 0.25, .Ip = 0.75, .ka = 0.4, .kd = 0.8, .ks = 0.4, .n = 3, .form = Form::Tutorial};
  EXPECT_NEAR(chainOf({std::sqrt(3.0), 0, 1}, light).I, 0.4375, 1e-12);
  EXPECT_NEAR(chainOf({std::sqrt(3.0), 0, -1}, light).I, 0.1, 1e-12);
}

}  // namespace xnewell::THIS_FILE
