#include "shading/explain/explain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "depthsort/oracle.h"
#include "shading/explain/pixel_history.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

struct Seen {
  int pixels = 0, clamped = 0, several = 0, notPainted = 0;
  double off = 0;  ///< the largest difference between the definitions and the loop
};

/// The explanation of each pixel ends in the cell that the picture has there.
void expectExplained(const Picture& picture, Seen& seen) {
  const PictureSettings& settings = picture.settings();
  const SeenRows rows = picture.seen(0, settings.height);
  PixelExplainer explain{picture};
  const bool colors = channelsOf(picture.colors().plan()) == Channels::Rgb;
  for (int j = 0; j < settings.height; ++j)
    for (int i = 0; i < settings.width; ++i) {
      const int face = rows.faces[std::size_t(j) * settings.width + i];
      if (face == kNothing) continue;
      const Explanation e = explain(face, i, j);
      ASSERT_TRUE(colors || e.value[0] == picture.image().row(j)[i])
          << "pixel " << i << ", " << j << ": " << e.value[0] << " for " << int{picture.image().row(j)[i]};
      // What the loops have is what the definitions say, as precisely as single precision allows. Gouraud's
      // values end at 255.99 of 256, if there is a table (affine.h). Where cell numbers are interpolated, it
      // is another picture by design.
      if (settings.interpolated == Interpolated::Intensity && e.method != Shading::Environment) {
        const double off = std::abs(e.inLoop - (colors ? std::clamp(e.I[0], 0.0, 1.0) : e.intensity));
        ASSERT_LT(off, 4e-5) << "pixel " << i << ", " << j << ": " << e.inLoop << " for " << e.intensity;
        seen.off = std::max(seen.off, off);
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
      seen.clamped += e.clamped;
    }
}

PictureSettings settingsOf(const Scene& scene, Shading shading) {
  PictureSettings s = scene.settings;
  s.camera = scene.camera;
  s.width = kSanitized ? 32 : 64, s.height = kSanitized ? 24 : 48;
  s.shading = shading;
  return s;
}

}  // namespace

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

}  // namespace xnewell::THIS_FILE
