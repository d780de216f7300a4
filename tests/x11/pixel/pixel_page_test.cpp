#include "x11/pixel/pixel_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "x11/pixel/pixel_view.h"

namespace xnewell::THIS_FILE {

// Where the cells hold colours, each chain ends in the cell that the picture has: the nearest colour, or with
// dithering the colour of this place among the two that share its block.
TEST(PixelPage, ChainsEndInTheCellsOfColors) {
  for (const char* name : {"colored-lights", "textured-cube"}) {
    PictureCache pictures{readScene(name)};
    PictureSettings settings = pictures.scene().settings;
    settings.camera = pictures.scene().camera;
    settings.width = 64, settings.height = 48;
    for (const ColorPlan plan : {ColorPlan::Cube, ColorPlan::Chosen})
      for (const bool dither : {false, true}) {
        SCOPED_TRACE(std::string{name} + (plan == ColorPlan::Cube ? ", cube" : "") +
                     (dither ? ", dithered" : ""));
        settings.colors = plan, settings.dither = dither;
        const Picture picture = pictures.make(settings, 0);
        int shown = 0;
        for (int j = 0; j < settings.height; j += 5)
          for (int i = j % 3; i < settings.width; i += 3) {
            const PixelStory story{picture, i, j};
            shown += story.shown() != nullptr;
            EXPECT_TRUE(story.isExplained()) << i << ',' << j;
          }
        EXPECT_GT(shown, 30);
      }
  }
}

// The upper bits of a stored value are the value divided by a power of two, rounded down.
TEST(PixelPage, AScreenShowsTheHighBits) {
  PictureCache pictures{readScene("two-cards")};
  PictureSettings settings = pictures.scene().settings;
  settings.width = 64, settings.height = 48;
  const auto story = std::make_shared<const PixelStory>(pictures.make(settings, 0), 32, 24);
  ASSERT_TRUE(story->shown());
  Palette palette{};
  const auto said = [&](Rgb16 stored, int bits) {
    palette.fill(stored);
    return page::asText(page::ofPixel(story, {.channel = 0, .palette = &palette, .shownBits = bits}));
  };
  EXPECT_NE(said({52685, 255, 256}, 8).find("this screen shows the upper 8 bits: 205, 0, 1\n"),
            std::string::npos);
  EXPECT_NE(said({65535, 2047, 2048}, 5).find("the upper 5 bits: 31, 0, 1\n"), std::string::npos);
  EXPECT_NE(said({52685, 255, 256}, 16).find("all 16 bits: 52685, 255, 256\n"), std::string::npos);
}

// The written intensity lies in the written interval, by the decimals that are written, and so does the
// JSON's. The interval's ends are where the neighbours among the stored levels are as near. For every table,
// with I0 from 1e-300 to 0.999, and every method: the loops round differently.
TEST(PixelPage, TheIntervalHasTheIntensity) {
  struct Way {
    Shading shading;
    Interpolated interpolated = Interpolated::Intensity;
  };
  PictureCache pictures{readScene("teapot", 4)};
  PictureSettings settings = pictures.scene().settings;
  settings.camera = pictures.scene().camera;
  settings.width = 40, settings.height = 30;
  int checked = 0;
  for (const TableRow& row : kTables)
    for (const double I0 : {1e-300, 1e-9, 1e-6, 1e-4, 0.02, 0.3, 0.999})
      for (const auto& [shades, pick] : {std::pair{240, Pick::Log}, std::pair{64, Pick::Search}})
        for (const Way& way :
             {Way{Shading::Flat}, Way{Shading::Gouraud}, Way{Shading::Gouraud, Interpolated::Cell},
              Way{Shading::Phong}, Way{Shading::Depth}, Way{Shading::Environment}})
          for (const double light : {0.7, 1e-5}) {
            if (isEven(row.id) && I0 != 0.02) continue;
            settings.table = {.kind = row.id, .shades = shades, .I0 = I0, .pick = pick};
            settings.shading = way.shading, settings.interpolated = way.interpolated;
            settings.light.Ia = light / 5, settings.light.Ip = light;
            const Picture picture = pictures.make(settings, 0);
            for (int j = 1; j < 30; j += 4)
              for (int i = 1; i < 40; i += 3) {
                const auto story = std::make_shared<const PixelStory>(picture, i, j);
                if (story->shown() == nullptr) continue;
                const std::string page = page::asText(page::ofPixel(story, {}));
                const std::size_t begin = page.rfind("I ", page.find(" picks shade "));
                ASSERT_NE(begin, std::string::npos);
                const std::string text = page.substr(begin);
                SCOPED_TRACE(text);
                double I = 0, from = 0, to = 0;
                int shade = 0;
                ASSERT_EQ(std::sscanf(text.c_str(), "I %lf picks shade %d", &I, &shade), 2);
                // The first shade has no end below, the last none above.
                const char* const is = text.c_str() + text.find("that shade is for") + 18;
                const bool first = *is == 'I';
                const int read =
                    first ? std::sscanf(is, "I < %lf", &to) : std::sscanf(is, "%lf <= I < %lf", &from, &to);
                ASSERT_EQ(read, first || shade == shades - 1 ? 1 : 2);
                EXPECT_TRUE(from <= I && (I < to || shade == shades - 1));
                const ColorTable& table = picture.table();
                const auto between = [&](int k) -> long double {
                  const long double a = table.intensity(k), b = table.intensity(k + 1);
                  return row.id == TableKind::Corrected && pick == Pick::Log ? std::sqrt(a * b) : (a + b) / 2;
                };
                const long double least = shade > 0 ? between(shade - 1) : 0,
                                  most = shade + 1 < shades ? between(shade) : 1;
                const double inLoop = story->shown()->inLoop;
                EXPECT_TRUE(least * (1 - 0x1p-42L) <= inLoop && inLoop <= most * (1 + 0x1p-42L)) << inLoop;
                ++checked;
              }
          }
  EXPECT_GT(checked, 5'000);
}

// With a constant L, the share of a spot can be computed from the L that is said for the cone alone.
TEST(PixelPage, SaysWhichLTheConeHas) {
  PictureCache pictures{readScene("spotlight")};
  PictureSettings settings = pictures.scene().settings;
  settings.camera = pictures.scene().camera;
  settings.width = 80, settings.height = 60;
  settings.shading = Shading::Phong, settings.light.constantL = true;
  const Picture picture = pictures.make(settings, 0);
  const Light& spot = pictures.scene().light.lights.front();
  const auto cosineOf = [](double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); };
  int edge = 0;
  for (int j = 0; j < settings.height; ++j)
    for (int i = 0; i < settings.width; ++i) {
      const auto story = std::make_shared<const PixelStory>(picture, i, j);
      if (!story->shown()) continue;
      const auto json = nlohmann::json::parse(page::asJson(page::ofPixel(story, {})));
      const auto light = json["equations"][0]["lights"][0];
      double dot = 0, length = 0;
      for (int c = 0; c < 3; ++c)
        dot -= light["L_for_cone"][c].get<double>() * spot.direction[c],
            length += spot.direction[c] * spot.direction[c];
      const double a = dot / std::sqrt(length), inner = cosineOf(spot.inner), outer = cosineOf(spot.outer);
      const double share = a >= inner   ? 1
                           : a <= outer ? 0
                                        : std::pow((a - outer) / (inner - outer), spot.falloff);
      ASSERT_NEAR(light["spot"].get<double>(), share, 1e-9) << i << ',' << j;
      edge += share > 0 && share < 1;
    }
  EXPECT_GT(edge, 20);
}

// What must be there in each window has room, for all methods, textures, colours and lights: the history,
// the formula with its numbers and its sum, and the chain's end. A larger window leaves nothing out that a
// smaller one has.
TEST(PixelPage, SaysWhatMattersInEverySize) {
  for (const char* scene : {"teapot", "colored-lights", "textured-cube", "spotlight", "shingles"})
    for (const Shading method : {Shading::Full, Shading::Depth, Shading::Flat, Shading::Gouraud,
                                 Shading::Phong, Shading::Environment}) {
      PictureCache pictures{readScene(scene, 4)};
      PictureSettings settings = pictures.scene().settings;
      settings.width = 80, settings.height = 60, settings.shading = method;
      if (scene == std::string{"shingles"}) settings.order = Order::ZMean;
      const auto story = std::make_shared<const PixelStory>(pictures.make(settings, 8), 40, 34);
      if (!story->shown()) continue;
      std::size_t last = 99;
      for (const auto& [width, height, unit] :
           {std::tuple{800, 540, 1}, {1600, 1080, 2}, {1024, 768, 1}, {1920, 1080, 1}}) {
        SCOPED_TRACE(std::string{scene} + ' ' + std::string{rowOf(method).name} + ' ' +
                     std::to_string(width) + " / " + std::to_string(unit));
        const Layout at = layoutOf(width, height, unit);
        IndexImage image{width, height, 0};
        const CellPlan plan{TableKind::Linear};
        Pen pen{Painter{image, unit}, plan};
        std::vector<std::string> leftOut;
        const auto pressed =
            page::draw(pen, page::ofPixel(story, {.chosen = story->history.shown, .vertex = 0, .channel = 0}),
                       frameOf(at).column, page::pitchOf(at.body), {}, &leftOut);
        EXPECT_TRUE(
            std::ranges::any_of(pressed, [](const page::Pressed& p) { return p.id == kPressHistory; }));
        for (const std::string& words : leftOut)
          for (const char* must :
               {"I = ", "= 0.", "picks shade", "the chain", "hidden everywhere", "each channel is",
                "interpolated to", "The map holds", "No light is computed"})
            EXPECT_FALSE(words.starts_with(must) || words.find(": I = ") != std::string::npos ||
                         words.find("the chain") != std::string::npos)
                << words;
        EXPECT_LE(leftOut.size(), last);
        last = leftOut.size();
        if (height == 1080 && unit == 1) {
          EXPECT_TRUE(std::ranges::none_of(
              leftOut, [](const std::string& w) { return w == "a sketch" || w == "a table"; }));
        }
      }
    }
}

}  // namespace xnewell::THIS_FILE
