#include "shading/explain/term_values.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "depthsort/oracle.h"
#include "shading/explain/explain.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

double sumOfLights(const ExplainedEquation& at, ByChannel ExplainedLight::*term, int c) {
  double sum = 0;
  for (const ExplainedLight& light : at.lights) sum += (light.*term)[c];
  return sum;
}

double numberOf(const ExplainedEquation& at, Term term, int channels) {
  if (term == Term::NdotL) return at.lights.at(0).NdotL;
  if (term == Term::Cosine) return at.lights.at(0).cosine;
  glm::dvec3 v{0};
  for (int c = 0; c < channels; ++c)
    v[c] = term == Term::Ambient
               ? at.ambient[c]
               : sumOfLights(at, term == Term::Diffuse ? &ExplainedLight::diffuse : &ExplainedLight::specular,
                             c);
  return channels == 3 ? luminance(v) : v[0];
}

/// The value at a sample from its explanation: of its equation, or interpolated from those at the vertices.
/// Nothing where clipping made a vertex.
std::optional<double> explained(const Explanation& e, Term term) {
  if (e.method != Shading::Gouraud) return numberOf(e.equations.front(), term, e.channels);
  if (e.vertices.size() != 3) return std::nullopt;
  double sum = 0;
  glm::dvec3 diffuse{0};  // by channel, because the texel has several
  for (const ExplainedVertex& vertex : e.vertices) {
    if (vertex.equation < 0) return std::nullopt;
    const ExplainedEquation& at = e.equations[vertex.equation];
    sum += vertex.onScreen * numberOf(at, term, e.channels);
    for (int c = 0; c < 3; ++c) diffuse[c] += vertex.onScreen * sumOfLights(at, &ExplainedLight::diffuse, c);
  }
  if (!e.texel || term != Term::Diffuse) return sum;
  for (int c = 0; c < 3; ++c) diffuse[c] *= e.texel->share[c];
  return e.channels == 3 ? luminance(diffuse) : diffuse[0];
}

}  // namespace

// At every sample each value is that of the pixel's explanation, for all methods that evaluate the equation,
// with several lights, coloured ones, spots, textures and a mistake. Nothing shows where no face does.
TEST(TermValues, AreThoseOfTheExplanations) {
  int compared = 0, textured = 0;
  std::array<int, kTerms.size()> negative{};
  for (const char* const name :
       someOf({"teapot", "textured-cube", "colored-lights", "spotlight", "room"}, 2)) {
    PictureCache pictures{readScene(name, 3)};
    for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
      for (const Mistake mistake : {Mistake::None, Mistake::FacingUnclamped}) {
        PictureSettings s = pictures.scene().settings;
        s.camera = pictures.scene().camera;
        s.width = 48, s.height = 36;
        s.shading = method, s.light.mistake = mistake;
        s.light.light = {0.9, 0.3, 0.2};
        const Picture picture = pictures.make(s, 8);
        ASSERT_TRUE(hasTerms(s));
        const SeenRows rows = picture.seen(5, s.height);
        PixelExplainer explain{picture};
        for (const TermValueRow& row : kTerms) {
          SCOPED_TRACE(std::string{name} + ' ' + std::string{rowOf(method).name} + ' ' +
                       std::string{row.name});
          const std::vector<double> values = termValues(picture, rows, row.id);
          ASSERT_EQ(values.size(), rows.faces.size());
          for (std::size_t k = 0; k < values.size(); ++k) {
            ASSERT_EQ(std::isnan(values[k]), rows.faces[k] == kNothing);
            if (rows.faces[k] == kNothing) continue;
            const int i = static_cast<int>(k) % s.width, j = 5 + static_cast<int>(k) / s.width;
            const Explanation e = explain(rows.faces[k], i, j);
            const std::optional<double> value = explained(e, row.id);
            if (!value) continue;
            ASSERT_NEAR(values[k], *value, 1e-12) << i << ", " << j;
            ++compared;
            negative[static_cast<std::size_t>(row.id)] += values[k] < 0.0;
            textured += e.texel && method == Shading::Gouraud;
          }
        }
      }
  }
  EXPECT_GT(compared, 20'000);
  EXPECT_GT(textured, 100);
  for (const Term term : {Term::NdotL, Term::Cosine})
    EXPECT_GT(negative[static_cast<std::size_t>(term)], kSanitized ? 50 : 500)
        << "before the equation clamps it";
}

// The three terms add up to what the picture shows. With a small ks nothing is clamped.
TEST(TermValues, AddUpToTheIntensities) {
  PictureCache pictures{readScene("teapot", 4)};
  for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
    PictureSettings s = pictures.scene().settings;
    s.camera = pictures.scene().camera;
    s.width = 64, s.height = 48;
    s.shading = method, s.light.ks = 0.1;
    const Picture picture = pictures.make(s, 8);
    const SeenRows rows = picture.seen(0, s.height);
    const std::vector<double> I = picture.intensities(rows);
    std::array<std::vector<double>, 3> terms;
    for (int t = 0; t < 3; ++t) terms[t] = termValues(picture, rows, kTerms[t].id);
    int compared = 0;
    for (std::size_t k = 0; k < I.size(); ++k) {
      if (rows.faces[k] == kNothing) continue;
      ASSERT_NEAR(terms[0][k] + terms[1][k] + terms[2][k], I[k], 4e-5);
      ++compared;
    }
    EXPECT_GT(compared, 500);
  }
}

TEST(TermValues, NeedAMethodThatEvaluatesTheEquation) {
  PictureSettings s;
  for (const ShadingRow& row : kShadings) {
    s.shading = row.id;
    EXPECT_EQ(hasTerms(s), row.id == Shading::Flat || row.id == Shading::Gouraud || row.id == Shading::Phong);
  }
}

}  // namespace xnewell::THIS_FILE
