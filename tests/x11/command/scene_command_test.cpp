#include <gtest/gtest.h>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

/// Settings in a scene file and on the command line. The command line wins, then the scene, then the
/// program's defaults.

namespace {

class SceneCommandTest : public CommandTest {
 protected:
  /// A scene file with a sphere and these settings.
  [[nodiscard]] std::string sphere(const std::string& name, const std::string& said,
                                   const std::string& ofObject = "") const {
    return write(name, R"({"up": "z", )" + said +
                           R"("objects": [{"solid": "sphere", "around": 9, "down": 6)" + ofObject + "}]}");
  }
};

}  // namespace

// A setting in a scene has the same effect as its option, and each option has the same effect over both.
TEST_F(SceneCommandTest, OptionsWinOverTheSceneOverDefaults) {
  const std::string plain = sphere("plain.json", "");
  const std::string asks =
      sphere("asks.json", R"("shading": {"method": "gouraud", "normals": "sum", "crease": 100,
    "polygons": "rows", "form": "half-vector", "order": "zsort", "Ia": 0.05, "Ip": 0.9, "ka": 0.8, "kd": 0.7,
    "ks": 0.6, "n": 5, "light": [-1, -1, 0], "table": {"kind": "corrected", "shades": 40, "i0": 0.1,
    "pick": "search", "hue": [0, 1, 0.5], "bits": 8}}, )");
  const std::vector<Strings> same{
      {"--shade", "gouraud"},    {"--normals", "sum"},     {"--crease", "100"}, {"--polygons", "rows"},
      {"--form", "half-vector"}, {"--order", "zsort"},     {"--ia", "0.05"},    {"--ip", "0.9"},
      {"--ka", "0.8"},           {"--kd", "0.7"},          {"--ks", "0.6"},     {"--n", "5"},
      {"--light", "-1,-1,0"},    {"--table", "corrected"}, {"--shades", "40"},  {"--i0", "0.1"},
      {"--pick", "search"},      {"--hue", "0,1,0.5"},     {"--bits", "8"}};
  const std::vector<Strings> other{
      {"--shade", "phong"},   {"--normals", "distinct"}, {"--crease", "0"},  {"--polygons", "triangles"},
      {"--form", "textbook"}, {"--order", "newell"},     {"--ia", "0.1"},    {"--ip", "0.5"},
      {"--ka", "0.1"},        {"--kd", "0.1"},           {"--ks", "0.1"},    {"--n", "50"},
      {"--light", "-1,1,1"},  {"--table", "brief"},      {"--shades", "10"}, {"--i0", "0.3"},
      {"--pick", "log"},      {"--hue", "1,0,0"},        {"--bits", "16"}};
  Strings all;
  for (const Strings& option : same) all = all + option;
  const std::string as = draw(asks).png;
  EXPECT_EQ(as, draw(plain, all).png);
  EXPECT_NE(as, draw(plain).png);

  const std::size_t tried = kSanitized ? 5 : same.size();
  std::size_t changed = 0;
  for (std::size_t k = 0; k < tried; ++k) {
    Strings rest = other[k];
    for (std::size_t i = 0; i < same.size(); ++i)
      if (i != k) rest = rest + same[i];
    const std::string over = draw(asks, other[k]).png;
    EXPECT_EQ(over, draw(plain, rest).png) << other[k][0];
    changed += over != as;
  }
  EXPECT_GE(changed + 4, tried);  // not every one can be seen: for a sphere alone the order does not matter
}

// An option of light replaces the scene's own light, and an option of surfaces replaces the scene's surfaces.
TEST_F(SceneCommandTest, OwnLightAndSurfacesGiveWay) {
  const std::string plain = sphere("plain.json", "");
  const std::string lit =
      sphere("lit.json", R"("ambient": 0.1, "lights": [{"Ip": 0.6, "towards": [1, 0, 0]}], )");
  EXPECT_NE(draw(lit).png, draw(plain).png);
  const Strings light{"--ia", "0.3", "--ip", "0.4", "--light", "0,0,1"};
  EXPECT_EQ(draw(lit, light).png, draw(plain, light).png);
  EXPECT_EQ(draw(lit, {"--light", "0,0,1"}).png, draw(plain, {"--light", "0,0,1", "--ia", "0.1"}).png);
  EXPECT_EQ(draw(lit, {"--light-at", "0,0,3"}).png, draw(plain, {"--light-at", "0,0,3", "--ia", "0.1"}).png);
  EXPECT_EQ(draw(lit, {"--ia", "0.3"}).png,
            draw(plain, {"--ia", "0.3", "--ip", "0.6", "--light", "1,0,0"}).png);

  // This ambient light leaves less for Ip than the user's default.
  const std::string bright = sphere("bright.json", R"("ambient": 0.5, )");
  EXPECT_EQ(draw(bright).png, draw(plain, {"--ia", "0.5", "--ip", "0.5"}).png);
  EXPECT_EQ(draw(bright, {"--light", "0,0,1"}).png,
            draw(plain, {"--ia", "0.5", "--ip", "0.5", "--light", "0,0,1"}).png);

  const std::string shiny =
      sphere("shiny.json", R"("materials": {"m": {"ka": 0.1, "kd": 0.2, "ks": 0.3, "n": 4}}, )",
             R"(, "material": "m")");
  const Strings surface{"--ka", "0.1", "--kd", "0.2", "--ks", "0.3", "--n", "4"};
  EXPECT_EQ(draw(shiny).png, draw(plain, surface).png);
  for (std::size_t k = 0; k < surface.size(); k += 2) {
    Strings rest = surface;
    rest[k + 1] = "1";
    EXPECT_EQ(draw(shiny, {surface[k], "1"}).png, draw(plain, rest).png) << surface[k];
    EXPECT_NE(draw(shiny, {surface[k], "1"}).png, draw(shiny).png) << surface[k];
  }
}

}  // namespace xnewell::THIS_FILE
