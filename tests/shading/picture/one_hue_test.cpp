#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"

namespace xnewell::THIS_FILE {

namespace {

/// A red and a cyan light on coloured surfaces: a ball, a card with a texture of four colours, and patches.
constexpr std::string_view kColored = R"({
  "up": "z", "camera": {"eye": [1, -9, 6], "look_at": [0, 0, 0.4], "fov": 34},
  "ambient": [0.1, 0.2, 0.05],
  "lights": [{"color": [0.6, 0, 0.1], "towards": [-1, -1, 1]},
             {"kind": "point", "color": [0, 0.75, 0.6], "at": [3, -3, 4]}],
  "materials": {"green": {"color": [0.1, 1, 0.3], "specular": [1, 0.8, 0.5], "kd": 1, "ks": 1, "n": 1},
                "checks": {"texture": "CHECKS"}},
  "objects": [
    {"solid": "sphere", "move": [-1.6, 0.2, 0.5], "material": "green"},
    {"solid": "cube", "move": [0, -1.8, 0.3], "scale": 0.7, "material": "checks"},
    {"file": "teapot.bpt", "divisions": 3, "scale": 0.5, "move": [1.5, 1, 0], "color": [0.9, 0.3, 0.6]}
  ]})";

Scene colored() {
  std::string text{kColored};
  text.replace(text.find("CHECKS"), 6, "textures/checks.png");
  Scene scene = parseSceneFile(text, "colored", XNEWELL_DATA_DIR);
  // The built-in texture is gray. This one has colours.
  Texture& texture = scene.textures.front();
  for (std::size_t k = 0; k < texture.gray.size(); ++k)
    for (int c = 0; c < 3; ++c)
      texture.channel[c][k] = static_cast<std::uint8_t>(texture.gray[k] / (1 + (k / 8 + c) % 3));
  texture.colored = true;
  return scene;
}

PictureSettings settingsOf(const Scene& scene, Shading shading) {
  PictureSettings s;
  s.width = 120, s.height = 90;
  s.shading = shading;
  s.light.kd = 1;
  // Rotated maps have axes for each channel in colours, and the same axes for a luminance. On a coarse mesh
  // the error of a look-up depends on the axes.
  s.environment = EnvironmentForm::Published;
  s.camera = completed({}, scene.camera);
  return s;
}

}  // namespace

// A picture of one hue shows the luminance of what a picture in colours has, at every sample and with every
// method. It is the luminance of the sum, not the product of the luminances of light and surface.
TEST(OneHue, IsTheLuminanceOfTheColors) {
  PictureCache pictures{colored()};
  for (const ShadingRow& method : kShadings) {
    if (!method.lit) continue;
    SCOPED_TRACE(method.name);
    PictureSettings s = settingsOf(pictures.scene(), method.id);
    s.colors = ColorPlan::Chosen;
    const Picture full = pictures.make(s, 8);
    const SeenRows seen = full.seen(0, s.height);
    const std::vector<double> r = full.intensities(seen, 0), g = full.intensities(seen, 1),
                              b = full.intensities(seen, 2);
    s.colors = ColorPlan::OneHue;
    const Picture one = pictures.make(s, 8);
    const std::vector<double> I = one.intensities(seen);
    const Ramp ramp = one.colors().ramps().front();
    int samples = 0, clamped = 0, otherCells = 0;
    for (std::size_t k = 0; k < I.size(); ++k) {
      if (seen.faces[k] == kNothing) continue;
      ++samples;
      ASSERT_NEAR(I[k], 0.30 * r[k] + 0.59 * g[k] + 0.11 * b[k],
                  method.id == Shading::Environment ? 1e-6 : 1e-12);
      clamped += std::max({r[k], g[k], b[k]}) >= 1.0;
      const int apart = one.image().pixels[k] - ramp.cell(I[k]);
      ASSERT_LE(std::abs(apart), 1);
      otherCells += apart != 0;  // where the filler's precision decides
    }
    EXPECT_GT(samples, 1500);
    EXPECT_GT(clamped, 0);
    EXPECT_LT(otherCells, samples / 100);
    EXPECT_GT(full.saturated(), 0);
    EXPECT_EQ(one.saturated() > 0,
              method.id != Shading::Environment);  // its map holds what is clamped already
  }
}

// Red light leaves a green surface black. The product of the luminances would be 0.3 x 0.59.
TEST(OneHue, OfRedLightOnGreenIsBlack) {
  PictureCache pictures{parseSceneFile(
      R"({"ambient": 0, "lights": [{"color": [1, 0, 0], "towards": [0, 0, 1]}],
          "materials": {"green": {"color": [0, 1, 0], "ks": 0}},
          "objects": [{"material": "green", "polygons": [[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]]}]})",
      "green", XNEWELL_DATA_DIR)};
  for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Environment}) {
    PictureSettings s = settingsOf(pictures.scene(), shading);
    s.colors = ColorPlan::OneHue;
    const Picture picture = pictures.make(s, 8);
    for (const double I : picture.intensities(picture.seen(0, s.height)))
      ASSERT_TRUE(std::isnan(I) || I == 0.0) << I;
  }
}

}  // namespace xnewell::THIS_FILE
