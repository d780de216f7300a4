#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

// A scene that is moved far from the origin, together with its lights and its eye, keeps its picture. All
// coordinates are multiples of 2^-7, so the file of the moved scene has no rounding of its own, and nothing
// but the program can make a difference.

namespace {

using nlohmann::json;

constexpr std::array kDistances{1e3, 1e6, 1e9};
constexpr int kWidth = 160, kHeight = 120;

double dyadic(double v) { return std::round(v * 128.0) / 128.0; }

json list(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// A ball and a floor that passes through the front plane, all with texture coordinates. `light` has its
/// places as if d were 0.
Scene sceneAt(double d, json light) {
  const glm::dvec3 move{d, -d, d};
  json polygons = json::array(), uv = json::array();
  const Mesh ball = sphere(14, 9);
  for (int f = 0; f < ball.faceCount(); ++f) {
    const auto corners = ball.face(f);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      json polygon = json::array(), places = json::array();
      for (const int c : {corners[0], corners[k], corners[k + 1]}) {
        const glm::dvec3 p = ball.points[c];
        polygon.push_back(list(move + glm::dvec3{dyadic(p.x), dyadic(p.y), dyadic(p.z)}));
        places.push_back({dyadic(p.x + p.z), dyadic(p.y)});
      }
      polygons.push_back(polygon);
      uv.push_back(places);
    }
  }
  polygons.push_back({list(move + glm::dvec3{-6, -1, -6}), list(move + glm::dvec3{-6, -1, 6}),
                      list(move + glm::dvec3{6, -1, 6}), list(move + glm::dvec3{6, -1, -6})});
  uv.push_back({{0, 0}, {0, 3}, {3, 3}, {3, 0}});
  for (const char* key : {"at", "look_at"})
    if (light.contains(key))
      for (int axis = 0; axis < 3; ++axis) light[key][axis] = light[key][axis].get<double>() + move[axis];
  light["Ip"] = 0.7;
  const json scene{{"up", "y"},
                   {"camera",
                    {{"eye", list(move + glm::dvec3{3, 2.25, 4})},
                     {"look_at", list(move)},
                     {"fov", 38},
                     {"front", -1},
                     {"back", -12}}},
                   {"ambient", 0.25},
                   {"lights", {light}},
                   {"objects", {{{"polygons", polygons}, {"uv", uv}}}}};
  return parsed(scene.dump());
}

/// A directional light, and a point light and a spot with each attenuation.
std::vector<json> lights() {
  std::vector<json> all{{{"kind", "directional"}, {"towards", {1, 2, 1.5}}}};
  for (const char* kind : {"point", "spot"})
    for (const AttenuationRow& row : kAttenuations) {
      json light{{"kind", kind}, {"at", {0.75, 1.5, 1.0}}, {"attenuation", std::string{row.name}}};
      if (light["kind"] == "spot") light.update({{"look_at", {0.25, 0, 0}}, {"inner", 20}, {"outer", 50}});
      all.push_back(light);
    }
  all.push_back({{"kind", "point"}, {"at", {0.5, -0.9921875, 0.75}}});  // 2^-7 above the floor
  return all;
}

Texture checks() {
  Texture texture{.width = 16, .height = 16, .channel = {}, .gray = {}};
  for (int k = 0; k < 256; ++k) texture.gray.push_back((k / 16 / 4 + k % 16 / 4) % 2 ? 255 : 120);
  texture.channel = {texture.gray, texture.gray, texture.gray};
  return texture;
}

IndexImage pictureOf(Scene scene, Shading method, Form form, bool textured) {
  PictureSettings s = scene.settings;
  s.width = kWidth, s.height = kHeight;
  s.camera = scene.camera;
  s.shading = method;
  s.light.form = form;
  s.light.n = 40;
  if (textured) wear(scene, checks());
  PictureCache pictures{std::move(scene)};
  return pictures.make(s, 0).image();
}

struct Difference {
  int largest = 0, samples = 0;
};
Difference between(const IndexImage& a, const IndexImage& b) {
  Difference d;
  for (std::size_t k = 0; k < a.pixels.size(); ++k) {
    const int off = std::abs(int{a.pixels[k]} - int{b.pixels[k]});
    d.largest = std::max(d.largest, off);
    d.samples += off > 0;
  }
  return d;
}

}  // namespace

TEST(FarPlaces, EveryMethodAndLightKeepsItsPicture) {
  int compared = 0, cases = 0;
  for (const json& light : lights())
    for (const bool textured : {false, true})
      for (const ShadingRow& method : kShadings)
        for (const FormRow& form : kForms) {
          if (!method.lit && (form.id != Form::Textbook || textured)) continue;
          if (method.id == Shading::Environment && (form.id != Form::Textbook || textured)) continue;
          if (kSanitized && cases++ % 5 != 0) continue;
          const IndexImage here = pictureOf(sceneAt(0, light), method.id, form.id, textured);
          ASSERT_GT(kWidth * kHeight - std::ranges::count(here.pixels, 0), kWidth * kHeight / 4);
          for (const double d : kDistances) {
            SCOPED_TRACE(light.dump() + " " + std::string{method.name} + " " + std::string{form.name} +
                         (textured ? " textured, at " : ", at ") + std::to_string(d));
            const IndexImage there = pictureOf(sceneAt(d, light), method.id, form.id, textured);
            const Difference off = between(here, there);
            EXPECT_LE(off.largest, 1);
            EXPECT_LE(off.samples, kWidth * kHeight / 100);
            ++compared;
          }
        }
  EXPECT_GT(compared, kSanitized ? 120 : 600);
}

}  // namespace xnewell::THIS_FILE
