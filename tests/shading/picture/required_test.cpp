#include "shading/picture/required.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "shading/fill/intensities.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "shading/trade/measure.h"

namespace xnewell::THIS_FILE {

namespace {

/// A ball and a card of two materials, one of them unused, and a light.
std::string scene(const std::string& light, const std::string& used = "") {
  return R"({"up": "z", "ambient": 0.1, "lights": [)" + light + R"(],
    "materials": {"unused": {"ks": 0.5}, "used": {)" +
         used + R"(}},
    "objects": [{"solid": "sphere", "material": "used"}]})";
}

constexpr std::string_view kSun = R"({"Ip": 0.8, "towards": [0, -1, 1]})";

std::map<std::string_view, Required> requiredOf(const std::string& text, PictureSettings s = {}) {
  s.width = 40, s.height = 30;
  if (s.shading == Shading::Flat) s.shading = Shading::Gouraud;
  std::map<std::string_view, Required> byName;
  for (Required& r : requiredBy(makePicture(parseSceneFile(text, "scene", XNEWELL_DATA_DIR), s))) {
    EXPECT_FALSE(r.why.empty()) << r.name;
    byName.emplace(r.name, std::move(r));
  }
  return byName;
}

bool needs(const std::map<std::string_view, Required>& required, std::string_view name) {
  return std::get<bool>(required.at(name).what);
}
std::int64_t count(const std::map<std::string_view, Required>& required, std::string_view name) {
  return std::get<std::int64_t>(required.at(name).what);
}

}  // namespace

// A highlight is needed if a surface that shows one is lit. A material that no face has does not count, and
// neither does the user's ks if all surfaces have their own.
TEST(Required, HighlightsOfSurfacesInUse) {
  PictureSettings user;
  user.light.ks = 0.4;
  const std::string sun{kSun};
  auto required = requiredOf(scene(sun, R"("ks": 0.3)"), user);
  EXPECT_TRUE(needs(required, "specular") && needs(required, "eye") && needs(required, "places"));
  EXPECT_EQ(required.at("specular").why,
            "a surface has ks above 0, and a light of its colour reaches the scene");
  required = requiredOf(scene(sun, R"("ks": 0)"), user);
  EXPECT_FALSE(needs(required, "specular") || needs(required, "eye") || needs(required, "places"));
  EXPECT_EQ(required.at("specular").why, "no surface has ks above 0");
  EXPECT_EQ(required.at("eye").why, "nothing has a highlight");
  EXPECT_EQ(count(required, "lights"), 1);
  // A highlight without a colour that the light has is none.
  required = requiredOf(scene(R"({"color": [0.5, 0, 0]})", R"("ks": 0.5, "specular": [0, 1, 1])"), user);
  EXPECT_FALSE(needs(required, "specular"));
  EXPECT_EQ(required.at("specular").why,
            "a surface has ks above 0, but no light of its colour reaches the scene");
}

// With n = 0 a highlight is as bright from everywhere. So it asks neither for the eye nor, under a light far
// away, for places; and another eye changes no intensity.
TEST(Required, NoEyeWhereNIsZero) {
  const std::string sun{kSun};
  for (const int n : {0, 1}) {
    const std::string text = scene(sun, R"("ks": 0.3, "n": )" + std::to_string(n));
    const auto required = requiredOf(text);
    EXPECT_TRUE(needs(required, "specular"));
    EXPECT_EQ(needs(required, "eye"), n > 0);
    EXPECT_EQ(needs(required, "places"), n > 0);
    const Scene ball = parseSceneFile(text, "scene", XNEWELL_DATA_DIR);
    const auto intensities = [&](const glm::dvec3& eye) {
      const Lighting lighting = resolve(ball.mesh, ball.light, {}, Channels::Luminance, eye, {0, 0, 0});
      Terms specular;
      specularIntensities(specular, facePoints(ball.mesh), lighting, 0);
      std::vector<double> front;
      for (const FrontBack<double>& I : specular) front.push_back(I.front);
      return front;
    };
    EXPECT_EQ(intensities({0, -4, 1}) == intensities({3, 2, 5}), n == 0);
  }
  EXPECT_EQ(requiredOf(scene(sun, R"("ks": 0.3, "n": 0)")).at("eye").why,
            "n is 0: a highlight is the same from everywhere");
}

// A large scene keeps no terms that nothing asks for. Its light is computed part by part, and is the same.
TEST(Required, ALargeSceneIsLitInParts) {
  const std::string torus = R"({"lights": [)" + std::string{kSun} +
                            R"(], "objects": [{"solid": "torus", "around": 500, "across": 300}]})";
  PictureSettings s;
  s.width = 8, s.height = 6, s.shading = Shading::Flat, s.light.ks = 0.9;
  const Picture picture = makePicture(parseSceneFile(torus, "scene", XNEWELL_DATA_DIR), s);
  const SceneShading& shading = picture.shading();
  EXPECT_TRUE(shading.diffuse(0).empty() && shading.specular(0).empty());
  Terms diffuse, specular;
  Intensities whole;
  diffuseIntensities(diffuse, shading.points(), shading.lighting(), 0);
  specularIntensities(specular, shading.points(), shading.lighting(), 0);
  addTerms(whole, diffuse, specular, shading.points(), shading.lighting(), 0);
  const Intensities& parts = shading.intensities(0);
  ASSERT_EQ(parts.I.size(), 150'000u);
  EXPECT_EQ(parts.clamped, whole.clamped);
  EXPECT_GT(whole.clamped, 0);
  for (std::size_t k = 0; k < whole.I.size(); ++k)
    ASSERT_TRUE(parts.I[k].front == whole.I[k].front && parts.I[k].back == whole.I[k].back) << k;
}

// Where a spot shines away, the reason is the spot, not the surface.
TEST(Required, SaysThatNoLightReachesAShinySurface) {
  const auto required = requiredOf(
      scene(R"({"kind": "spot", "Ip": 0.8, "at": [0, 0, 4], "shines": [0, 0, 1], "inner": 5, "outer": 10})",
            R"("ks": 0.4)"));
  EXPECT_FALSE(needs(required, "specular"));
  EXPECT_EQ(required.at("specular").why,
            "a surface has ks above 0, but no light of its colour reaches the scene");
}

// A light that no surface reflects is not needed.
TEST(Required, LightsThatAreReflected) {
  const std::string sun{kSun};
  auto required = requiredOf(scene(sun, R"("kd": 0, "ks": 0)"));
  EXPECT_EQ(count(required, "lights"), 0);
  EXPECT_FALSE(needs(required, "places"));
  required = requiredOf(scene(sun, R"("kd": 0, "ks": 0.1)"));
  EXPECT_EQ(count(required, "lights"), 1);
  required = requiredOf(
      scene(R"({"color": [0.5, 0, 0]}, {"color": [0, 0, 0.4]})", R"("color": [0, 0, 1], "ks": 0)"));
  EXPECT_EQ(count(required, "lights"), 1);  // red on blue
  EXPECT_NE(required.at("lights").why.find("1 of 2 does not count"), std::string::npos)
      << required.at("lights").why;
}

// A spot that shines away is not needed, and it makes no difference to the picture. One whose cone only
// touches the scene is needed.
TEST(Required, SpotsThatReachTheScene) {
  const auto spot = [](const std::string& shines, int outer) {
    return R"({"kind": "spot", "Ip": 0.8, "at": [0, 0, 4], "shines": )" + shines +
           R"(, "inner": 5, "outer": )" + std::to_string(outer) + "}";
  };
  EXPECT_EQ(count(requiredOf(scene(spot("[0, 0, -1]", 10))), "lights"), 1);
  EXPECT_EQ(count(requiredOf(scene(spot("[0, 0, 1]", 10))), "lights"), 0);
  EXPECT_FALSE(needs(requiredOf(scene(spot("[0, 0, 1]", 10))), "spots"));
  EXPECT_EQ(count(requiredOf(scene(spot("[0, 0, 1]", 180))), "lights"), 1);
  EXPECT_EQ(count(requiredOf(scene(spot("[1, 0, 0]", 60))), "lights"), 0);
  EXPECT_EQ(count(requiredOf(scene(spot("[1, 0, 0]", 80))), "lights"),
            1);  // the ball's edge is 14.5 degrees off
  // A spot that is left out lights no vertex: turned by a degree at a time, its light is either counted or
  // dark.
  int out = 0, in = 0;
  for (int degrees = 0; degrees < 180; degrees += 5) {
    const double a = degrees * 3.14159265358979 / 180;
    const std::string text =
        scene(spot("[" + std::to_string(std::sin(a)) + ", 0, " + std::to_string(-std::cos(a)) + "]", 20));
    const bool counted = count(requiredOf(text), "lights") == 1;
    ++(counted ? in : out);
    const Scene ball = parseSceneFile(text, "scene", XNEWELL_DATA_DIR);
    const Light& light = ball.light.lights.front();
    for (const glm::dvec3& p : ball.mesh.points) {
      const double along = glm::dot(glm::normalize(light.direction), glm::normalize(p - light.position));
      ASSERT_TRUE(counted || along <= std::cos(20 * 3.14159265358979 / 180)) << degrees;
    }
  }
  EXPECT_GT(out, 20);
  EXPECT_GT(in, 5);
}

// If nothing reflects a light, no normal is computed, at faces or at vertices.
TEST(Required, NormalsOnlyForLights) {
  const std::string sun{kSun};
  for (const Shading method : {Shading::Gouraud, Shading::Phong, Shading::Environment}) {
    PictureSettings s;
    s.shading = method;
    EXPECT_GT(count(requiredOf(scene(sun, R"("kd": 0.1, "ks": 0)"), s), "vertex_normals"), 0);
    const auto required = requiredOf(scene(sun, R"("kd": 0, "ks": 0)"), s);
    // A map is looked up by a normal, whatever it holds.
    EXPECT_EQ(count(required, "vertex_normals") > 0, method == Shading::Environment);
    EXPECT_EQ(count(required, "face_normals"), 0);
  }
  PictureSettings s;
  s.width = 40, s.height = 30;
  const auto faceNormals = [&](const char* kd) {
    const std::string text = scene(sun, std::string{R"("ks": 0, "kd": )"} + kd);
    const std::vector<Required> all =
        requiredBy(makePicture(parseSceneFile(text, "scene", XNEWELL_DATA_DIR), s));
    return std::get<std::int64_t>(std::ranges::find(all, "face_normals", &Required::name)->what);
  };
  EXPECT_EQ(faceNormals("0.1"), 24 * 12);
  EXPECT_EQ(faceNormals("0"), 0);
}

// What an item costs is measured by a picture that does not require it, or by the step alone. Each item has
// one of these, and no picture without an item requires it.
TEST(Required, EachItemCanBeTakenAway) {
  const std::string text = R"({"up": "z", "ambient": [0.1, 0.05, 0], "lights": [
      {"kind": "spot", "color": [0.5, 0.2, 0], "at": [0, 0, 4], "shines": [0, 0, -1], "inner": 5, "outer": 40,
       "attenuation": "inverse"}, {"color": [0, 0.2, 0.2], "towards": [0, -1, 1]}],
    "materials": {"shiny": {"ks": 0.5, "color": [1, 0.5, 0.5]}, "checks": {"texture": "textures/checks.png"}},
    "objects": [{"solid": "sphere", "material": "shiny"},
      {"polygons": [[[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]]], "uv": [[[0, 0], [1, 0], [1, 1], [0, 1]]],
       "material": "checks"}]})";
  const Scene all = parseSceneFile(text, "scene", XNEWELL_DATA_DIR);
  const auto itemOf = [](const Scene& scene, const PictureSettings& s, std::string_view name) {
    const std::vector<Required> items = requiredBy(makePicture(scene, s));
    EXPECT_EQ(items.size(), itemRows().size());
    const auto item = std::ranges::find(items, name, &Required::name);
    return std::visit([](auto what) { return static_cast<std::int64_t>(what); }, item->what);
  };
  for (const ItemRow& row : itemRows()) {
    SCOPED_TRACE(row.name);
    ASSERT_NE(row.without == nullptr, row.alone == nullptr);
    Scene scene = all;
    PictureSettings s;
    s.width = 40, s.height = 30;
    s.shading = row.name == "face_normals" ? Shading::Flat : Shading::Phong;
    const bool ramps = row.name == "ramps";  // only white light has ramps of several hues
    if (ramps) {
      s.colors = ColorPlan::Hues;
      for (Light& light : scene.light.lights) light.Ip = glm::dvec3{0.4};
      scene.light.Ia = glm::dvec3{0.1};
    }
    const std::int64_t least = row.name == "channels" || ramps ? 1 : 0;
    EXPECT_TRUE(row.name == "cuts_of_concave_faces" || itemOf(scene, s, row.name) > least);
    if (row.alone != nullptr) {
      row.alone(makePicture(scene, s))();
      continue;
    }
    row.without(scene, s);
    EXPECT_EQ(itemOf(scene, s, row.name), least);
  }
}

// Each item says why, also for methods without light.
TEST(Required, SaysWhy) {
  PictureSettings s;
  s.shading = Shading::Depth;
  const auto required = requiredOf(scene(std::string{kSun}), s);
  EXPECT_FALSE(needs(required, "illumination"));
  EXPECT_EQ(required.at("specular").why, "depth shading uses no light");
}

}  // namespace xnewell::THIS_FILE
