#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "depthsort/oracle.h"
#include "shading/explain/explain.h"
#include "shading/explain/pixel_history.h"
#include "shading/explain/term_values.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- A pixel explained

struct Seen {
  int pixels = 0, means = 0;  ///< means of cells at vertices
};

/// A channel from 1 to 255, as the loops have it, as a byte.
int byteOf(int value) { return static_cast<int>(std::lround((value - 1) * 255.0 / 254.0)); }

/// No colour of the scene's cells is nearer to the explained one than that of the stored cell.
void expectNearest(const Picture& picture, const Palette& palette, const Explanation& e, int stored) {
  const auto away = [&](int cell) {
    const Rgb16 color = palette[static_cast<std::size_t>(cell)];
    const std::array has{color.r >> 8, color.g >> 8, color.b >> 8};
    int sum = 0;
    for (int c = 0; c < 3; ++c) sum += (has[c] - byteOf(e.value[c])) * (has[c] - byteOf(e.value[c]));
    return sum;
  };
  const int first = kTables[static_cast<int>(picture.settings().table.kind)].first, here = away(stored);
  for (int cell = first; cell < first + picture.chosenColors(); ++cell) ASSERT_LE(here, away(cell)) << cell;
}

/// The explanation of each pixel ends in the cell that the picture has there; in colours, no cell has a
/// nearer one.
void expectExplained(const Picture& picture, Seen& seen) {
  const PictureSettings& settings = picture.settings();
  const SeenRows rows = picture.seen(0, settings.height);
  PixelExplainer explain{picture};
  const Palette palette = picture.palette(CellPlan{settings.table.kind});
  const bool colors = channelsOf(picture.colors().plan()) == Channels::Rgb;
  for (int j = 0; j < settings.height; ++j)
    for (int i = 0; i < settings.width; ++i) {
      const int face = rows.faces[std::size_t(j) * settings.width + i];
      if (face == kNothing) continue;
      const Explanation e = explain(face, i, j);
      ASSERT_TRUE(colors || e.value[0] == picture.image().row(j)[i])
          << "pixel " << i << ", " << j << ": " << e.value[0] << " for " << int{picture.image().row(j)[i]};
      if (colors) {
        ASSERT_NO_FATAL_FAILURE(expectNearest(picture, palette, e, picture.image().row(j)[i]));
      }
      // What the loops have is what the definitions say, as precisely as single precision allows. Gouraud's
      // values end at 255.99 of 256, if there is a table (affine.h). Where Gouraud shading interpolates cell
      // numbers, the picture is another by design: the mean of the cells at the vertices, by their shares.
      const bool ofCells = settings.interpolated == Interpolated::Cell && e.method == Shading::Gouraud;
      if (ofCells && e.vertices.size() == 3 && e.equations.size() == 3 && !e.texel) {
        const int number = picture.snapped().faces[face].number;
        const ColorTable& table = picture.colors().tableOf(picture.scene().mesh.material[number]);
        double mean = 0;
        for (const ExplainedVertex& v : e.vertices)
          mean += v.onScreen * table.cell(e.luminance ? luminance({v.I[0], v.I[1], v.I[2]}) : v.I[0]);
        if (std::abs(mean - std::floor(mean) - 0.5) > 1e-3) {
          ASSERT_EQ(std::lround(mean), e.value[0]);
          ++seen.means;
        }
      }
      if (!ofCells && e.method != Shading::Environment) {
        const double off = std::abs(e.inLoop - (colors ? std::clamp(e.I[0], 0.0, 1.0) : e.intensity));
        ASSERT_LT(off, 4e-5) << "pixel " << i << ", " << j << ": " << e.inLoop << " for " << e.intensity;
      }
      for (const ExplainedEquation& one : e.equations)
        for (const ExplainedLight& light : one.lights) {
          const glm::dvec3 with = settings.light.form == Form::Textbook ? one.V : one.N;
          ASSERT_NEAR(glm::dot(light.R, with), light.cosine, 1e-12) << "the vector does not have the cosine";
          ASSERT_NEAR(glm::dot(one.N, light.L), light.NdotL, 1e-12);
        }
      bool outside = false;
      for (const ExplainedEquation& one : e.equations)
        for (int c = 0; c < e.channels; ++c) {
          double sum = one.ambient[c];
          for (const ExplainedLight& light : one.lights) sum += light.diffuse[c] + light.specular[c];
          ASSERT_EQ(sum, one.I[c]) << "the terms do not add up";
          outside |= sum < 0.0 || sum > 1.0;
        }
      ASSERT_EQ(e.clamped, outside) << "pixel " << i << ", " << j;
      double onScreen = 0, inWorld = 0;
      for (const ExplainedVertex& v : e.vertices) onScreen += v.onScreen, inWorld += v.inWorld;
      if (e.vertices.size() == 3) {
        ASSERT_NEAR(onScreen, 1.0, 1e-9);
        ASSERT_NEAR(inWorld, 1.0, 1e-9);
      }
      ++seen.pixels;
    }
}

PictureSettings settingsOf(const Scene& scene, Shading shading) {
  PictureSettings s = setUpOf(scene, kSanitized ? 32 : 64, kSanitized ? 24 : 48);
  s.shading = shading;
  return s;
}

class ExplainedScene : public testing::TestWithParam<const char*> {};

// All methods on scenes with patches, hues, coloured lights, spots, textures and polygons that cut each
// other.
TEST_P(ExplainedScene, EndsInThePicturesCells) {
  PictureCache pictures{readScene(GetParam(), 4)};
  Seen seen;
  for (const ShadingRow& method : kShadings) {
    SCOPED_TRACE(std::string{method.name});
    PictureSettings settings = settingsOf(pictures.scene(), method.id);
    ASSERT_NO_FATAL_FAILURE(expectExplained(pictures.make(settings, 8), seen));
    settings.table.kind = TableKind::Corrected;
    settings.light.constantL = settings.light.constantV = true;
    settings.light.form = Form::HalfVector;
    settings.order = Order::ZBuffer16;
    settings.polygons = Polygons::Rows;
    ASSERT_NO_FATAL_FAILURE(expectExplained(pictures.make(settings, 8), seen));
    settings.light.form = Form::Tutorial;
    settings.light.twoSided = false;
    settings.order = Order::Bsp;
    settings.interpolated = Interpolated::Cell;
    settings.mapping = TextureMapping::Affine;
    settings.unnormalized = true;
    settings.colors = ColorPlan::OneHue;
    ASSERT_NO_FATAL_FAILURE(expectExplained(pictures.make(settings, 8), seen));
  }
  EXPECT_GT(seen.pixels, kSanitized ? 500 : 2'000);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExplainedScene,
                         testing::Values("teapot", "hues", "colored-lights", "spotlight", "textured-cube",
                                         "crossing-sheets", "saturated", "bright-corner", "room", "tori"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// The same with each mistake in the equation, for the methods that evaluate it, forms with and without V, and
// light from behind, which shows a highlight where N.L < 0. Every mistake changes a picture.
TEST(ExplainedMistakes, EndInThePicturesCells) {
  std::set<std::string_view> unseen;
  for (const MistakeRow& row : kMistakes) unseen.insert(row.name);
  Seen seen;
  struct Case {
    const char* scene;
    Shading method;
    bool behind = false;
  };
  for (const auto& [name, method, behind] :
       {Case{"teapot", Shading::Flat}, Case{"teapot", Shading::Gouraud}, Case{"teapot", Shading::Phong},
        Case{"teapot", Shading::Phong, true}, Case{"colored-lights", Shading::Phong},
        Case{"textured-cube", Shading::Flat}, Case{"textured-cube", Shading::Gouraud},
        Case{"spotlight", Shading::Phong}}) {
    PictureCache pictures{readScene(name, 3)};
    PictureSettings settings = settingsOf(pictures.scene(), method);
    settings.width = 40, settings.height = 30;
    settings.light.form = method == Shading::Gouraud ? Form::HalfVector : Form::Textbook;
    if (behind) settings.light.light = {0.3, 1.0, 0.1}, settings.light.n = 2;
    const Picture right = pictures.make(settings, 8);
    for (const MistakeRow& row : kMistakes) {
      SCOPED_TRACE(std::string{name} + ' ' + std::string{row.name});
      settings.light.mistake = row.id;
      const Picture wrong = pictures.make(settings, 8);
      ASSERT_NO_FATAL_FAILURE(expectExplained(wrong, seen));
      if (right.image() != wrong.image()) unseen.erase(row.name);
    }
  }
  EXPECT_GT(seen.pixels, 10'000);
  EXPECT_EQ(unseen, std::set<std::string_view>{"none"});
}

// The same where cell numbers are interpolated over triangles: each pixel has the mean of the cells at the
// vertices, weighted by their shares and rounded.
TEST(ExplainedCells, AreMeansOfTheCellsAtVertices) {
  Seen seen;
  for (const char* const name : {"teapot", "crossing-sheets"})
    for (const TableKind kind : {TableKind::Linear, TableKind::Corrected}) {
      PictureCache pictures{readScene(name, 4)};
      PictureSettings settings = settingsOf(pictures.scene(), Shading::Gouraud);
      settings.table.kind = kind, settings.interpolated = Interpolated::Cell;
      ASSERT_NO_FATAL_FAILURE(expectExplained(pictures.make(settings, 8), seen));
    }
  EXPECT_GT(seen.means, kSanitized ? 500 : 2'000);
}

// The last polygon of a history shows, as in the picture, and the verdict is that of the judge of pictures.
TEST(PixelHistory, EndsWithWhatShows) {
  for (const char* name : {"teapot", "penetrate", "cycle", "decals"})
    for (const Order order : {Order::Newell, Order::ZMean, Order::Bsp, Order::ZBuffer16, Order::Oracle}) {
      SCOPED_TRACE(std::string{name} + ' ' + std::string{rowOf(order).name});
      PictureCache pictures{readScene(name, 3)};
      PictureSettings settings = settingsOf(pictures.scene(), Shading::Flat);
      settings.order = order;
      const Picture picture = pictures.make(settings, 8);
      const SeenRows rows = picture.seen(0, settings.height);
      const std::vector<SampleCheck> checks = checkedSamples(picture);
      const std::vector<int> times = picture.timesPainted();
      const std::vector<int> nearest =
          visibleFaces(picture.withPlanes().snapped(), settings.width, settings.height);
      int several = 0;
      for (int j = 0; j < settings.height; ++j)
        for (int i = 0; i < settings.width; ++i) {
          const std::size_t k = std::size_t(j) * settings.width + i;
          const PixelHistory history = historyOf(picture, i, j);
          ASSERT_EQ(history.check, checks[k]);
          ASSERT_EQ(history.nearest, nearest[k]);
          const int shown = history.shown < 0 ? kNothing : history.painted[history.shown].fragment.face;
          ASSERT_EQ(shown, rows.faces[k]);
          if (!rowOf(order).bySample) {
            ASSERT_EQ(static_cast<int>(history.painted.size()), times[k]);
          }
          several += history.painted.size() > 1;
        }
      EXPECT_GT(several, 0);
    }
}

/// ---- Rounded terms

// What is written adds up, and no term is off by a whole unit of its last decimal.
TEST(RoundedTerms, AddUp) {
  std::mt19937 rng{1};
  int different = 0;
  for (int k = 0; k < 20'000; ++k) {
    std::vector<double> terms(1 + rng() % 7);
    for (double& term : terms) term = static_cast<double>(rng()) * 0x1p-32;
    const int decimals = static_cast<int>(rng() % 6);
    const double unit = std::pow(10.0, -decimals);
    const std::vector<double> rounded = roundedTerms(terms, decimals);
    const double exact = std::accumulate(terms.begin(), terms.end(), 0.0);
    const double sum = std::accumulate(rounded.begin(), rounded.end(), 0.0);
    ASSERT_LE(std::abs(sum - exact), 0.5 * unit + 1e-12);
    for (std::size_t t = 0; t < terms.size(); ++t) {
      ASSERT_LT(std::abs(rounded[t] - terms[t]), unit);
      ASSERT_NEAR(rounded[t] / unit, std::round(rounded[t] / unit), 1e-6);
      different += std::abs(rounded[t] - terms[t]) > 0.5 * unit * (1 + 1e-9);
    }
  }
  EXPECT_GT(different, 1'000) << "rounded one by one, they would not add up";
}

/// ---- Values of terms

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
        PictureSettings s = setUpOf(pictures.scene(), 48, 36);
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
    PictureSettings s = setUpOf(pictures.scene(), 64, 48);
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

}  // namespace

}  // namespace xnewell::THIS_FILE
