#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include "depthsort/oracle.h"
#include "shading/explain/explain.h"
#include "shading/explain/pixel_history.h"
#include "shading/explain/rounded_terms.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kPictures = 50;
constexpr double kLoop = 4e-5;  // the loops have single precision, and Gouraud's end at 255.99 of 256

/// What the fifty pictures have had, by name.
struct Had {
  std::set<std::string_view> scenes, methods, orders, plans, forms, tables, mistakes, fills;
  int pixels = 0, split = 0, textured = 0, severalLights = 0, several = 0, atBorder = 0;
  double remainder = 0;  ///< the most that a written term is off, in units of its last decimal
};

/// Picture k takes the k-th row of each list. The steps share no factor, so all pairs of rows come up.
PictureSettings settingsOf(const Scene& scene, unsigned k, Had& had) {
  PictureSettings s = scene.settings;
  s.camera = scene.camera;
  s.width = kSanitized ? 20 : 40, s.height = kSanitized ? 15 : 30;
  const ShadingRow& method = kShadings[(k + k / 6) % kShadings.size()];
  const OrderRow& order = kOrders[(2 * k + k / 9) % kOrders.size()];
  const ColorPlanRow& plan = kColorPlans[(k + k / 10) % kColorPlans.size()];
  const FormRow& form = kForms[(k + k / 3) % kForms.size()];
  const TableRow& table = kTables[(k / 2) % kTables.size()];
  const MistakeRow& mistake = kMistakes[k % 2 == 0 ? 0 : (k / 2) % kMistakes.size()];
  s.shading = method.id, s.order = order.id, s.colors = plan.id, s.light.form = form.id;
  s.table.kind = table.id, s.light.mistake = mistake.id;
  s.polygons = k % 4 < 2 ? Polygons::Triangles : Polygons::Rows;
  s.light.constantL = k % 5 == 1, s.light.constantV = k % 7 == 2, s.light.twoSided = k % 11 != 3;
  s.mapping = k % 3 == 0 ? TextureMapping::Affine : TextureMapping::Perspective;
  s.dither = false;                                      // then a pixel has the nearest colour
  s.inPixels = !method.interpolates && !order.bySample;  // as for an X server
  had.methods.insert(method.name), had.orders.insert(order.name), had.plans.insert(plan.name);
  had.forms.insert(form.name), had.tables.insert(table.name);
  if (!rowOf(s.shading).lit || s.shading == Shading::Environment) s.light.mistake = Mistake::None;
  had.mistakes.insert(rowOf(s.light.mistake).name);
  had.fills.insert(s.inPixels ? "in pixels" : s.polygons == Polygons::Rows ? "rows" : "triangles");
  return s;
}

/// The written terms of each equation add up as written, and none is off by a unit of its last decimal.
void expectTermsAddUp(const Explanation& e, Had& had) {
  constexpr int kDecimals = 4;
  constexpr double kUnits = 1e4;
  for (const ExplainedEquation& one : e.equations)
    for (int c = 0; c < e.channels; ++c) {
      std::vector<double> terms{one.ambient[c]};
      for (const ExplainedLight& light : one.lights)
        terms.insert(terms.end(), {light.diffuse[c], light.specular[c]});
      const std::vector<double> written = roundedTerms(terms, kDecimals);
      std::int64_t sum = 0;
      for (std::size_t t = 0; t < terms.size(); ++t) {
        sum += std::llround(written[t] * kUnits);
        had.remainder = std::max(had.remainder, std::abs(written[t] - terms[t]) * kUnits);
      }
      ASSERT_LE(std::abs(static_cast<double>(sum) - one.I[c] * kUnits), 0.5 + 1e-6);
    }
  ASSERT_LT(had.remainder, 1.0);
}

/// The cell that the intensity of the definitions picks is the stored one, or the intensity is at its border.
void expectPicked(const Picture& picture, const Explanation& e, int stored, Had& had) {
  const int number = picture.snapped().faces[e.face].number;
  const ColorTable& table = picture.colors().tableOf(picture.scene().mesh.material[number]);
  if (table.cell(e.intensity) == stored) return;
  const ColorTable::Picked picked = table.picked(stored - table.first());
  ++had.atBorder;
  ASSERT_GT(e.intensity, picked.from - kLoop);
  ASSERT_LT(e.intensity, picked.to + kLoop);
}

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

void expectReplayed(const Picture& picture, Had& had) {
  const PictureSettings& settings = picture.settings();
  const SeenRows rows = picture.seen(0, settings.height);
  const bool colors = channelsOf(picture.colors().plan()) == Channels::Rgb;
  const Palette palette = picture.palette(CellPlan{settings.table.kind});
  PixelExplainer explain{picture};
  for (int j = 0; j < settings.height; ++j)
    for (int i = 0; i < settings.width; ++i) {
      const int face = rows.faces[std::size_t(j) * settings.width + i];
      if (face == kNothing) continue;
      SCOPED_TRACE("pixel " + std::to_string(i) + ", " + std::to_string(j));
      if ((i + j) % 7 == 0) {
        const PixelHistory history = historyOf(picture, i, j);
        ASSERT_GE(history.shown, 0);
        ASSERT_EQ(history.painted[history.shown].fragment.face, face);
        had.several += history.painted.size() > 1;
      }
      const Explanation e = explain(face, i, j);
      const int stored = picture.image().row(j)[i];
      if (colors) {
        ASSERT_NO_FATAL_FAILURE(expectNearest(picture, palette, e, stored));
      } else {
        ASSERT_EQ(e.value[0], stored);
        ASSERT_NO_FATAL_FAILURE(expectPicked(picture, e, stored, had));
      }
      ASSERT_NO_FATAL_FAILURE(expectTermsAddUp(e, had));
      ++had.pixels;
      had.textured += e.texel.has_value();
      had.severalLights += !e.equations.empty() && e.equations.front().lights.size() > 1;
    }
}

}  // namespace

// Fifty pictures of every method, order, plan of colours, form, table, mistake and way to fill, with several
// lights, textures, decals and polygons that are split. At every pixel the definitions lead to the cell that
// the picture has, and the written terms add up.
TEST(FiftyPictures, AreReplayedAtEveryPixel) {
  constexpr std::array kScenes{"teapot",   "hues",   "colored-lights",  "spotlight", "textured-cube",
                               "pinwheel", "decals", "crossing-sheets", "room",      "saturated"};
  Had had;
  for (unsigned k = 0; k < kPictures; ++k) {
    const char* const name = kScenes[k % kScenes.size()];
    PictureCache pictures{readScene(name, 3)};
    const PictureSettings settings = settingsOf(pictures.scene(), k, had);
    SCOPED_TRACE("picture " + std::to_string(k) + ", " + name + ", " +
                 std::string{rowOf(settings.shading).name} + ", " + std::string{rowOf(settings.order).name} +
                 ", mistake " + std::string{rowOf(settings.light.mistake).name});
    const Picture picture = pictures.make(settings, 8);
    had.scenes.insert(name);
    had.split += picture.sorted().statistics.splits > 0;
    ASSERT_NO_FATAL_FAILURE(expectReplayed(picture, had));
  }
  EXPECT_EQ(had.scenes.size(), kScenes.size());
  EXPECT_EQ(had.methods.size(), kShadings.size());
  EXPECT_EQ(had.orders.size(), kOrders.size());
  EXPECT_EQ(had.plans.size(), kColorPlans.size());
  EXPECT_EQ(had.forms.size(), kForms.size());
  EXPECT_EQ(had.tables.size(), kTables.size());
  EXPECT_EQ(had.fills.size(), 3u);
  EXPECT_GT(had.mistakes.size(), 10u);
  EXPECT_GT(had.split, 3);
  EXPECT_GT(had.pixels, kSanitized ? 2'000 : 20'000);
  EXPECT_GT(had.textured, 100);
  EXPECT_GT(had.severalLights, kSanitized ? 100 : 500);
  EXPECT_GT(had.several, 100);
  EXPECT_LT(had.atBorder, had.pixels / 100) << "the loops differ only at borders";
  EXPECT_GT(had.remainder, 0.5) << "rounded one by one, the terms would not add up";
  RecordProperty("pixels", had.pixels);
  RecordProperty("largest remainder, in thousandths of the last decimal",
                 static_cast<int>(std::lround(1000 * had.remainder)));
}

}  // namespace xnewell::THIS_FILE
