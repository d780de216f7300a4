#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "geometry/files/parse_error.h"
#include "shading/scene/scene_file.h"
#include "tests/support/scene_text.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

// Lights, choices and cameras in a scene file. Its objects: scene_file_test.cpp.

// Lights of each kind are read, with lengths in the scene's units: a triangle of size 1 is kept at half its
// size.
TEST(SceneFile, Lights) {
  const Scene s = parsed(withTriangle(R"("up": "z", "ambient": [0.1, 0.2, 0.3], "lights": [
    {"Ip": 0.25, "towards": [0, 0, 5]},
    {"kind": "point", "color": [0.1, 0, 0.2], "at": [1, 2, 3], "attenuation": "linear", "range": 8},
    {"kind": "spot", "Ip": 0, "at": [0, 0, 4], "shines": [0, 1, -1], "inner": 5, "outer": 30, "falloff": 3,
     "attenuation": "textbook", "c": [1, 2, 4]},
    {"kind": "spot", "Ip": 0, "at": [0, 0, 4], "look_at": [1, 0, 0], "attenuation": "inverse-square"}])"));
  ASSERT_EQ(s.exponent, 1);
  EXPECT_EQ(s.light.Ia, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(s.light.unit, 0.5);
  ASSERT_EQ(s.light.lights.size(), 4u);
  const std::vector<Light>& l = s.light.lights;
  EXPECT_EQ(l[0].kind, LightKind::Directional);
  EXPECT_EQ(l[0].Ip, glm::dvec3{0.25});
  EXPECT_EQ(l[0].direction, glm::dvec3(0, 0, 5));
  EXPECT_EQ(l[1].kind, LightKind::Point);
  EXPECT_EQ(l[1].Ip, glm::dvec3(0.1, 0, 0.2));
  EXPECT_EQ(l[1].position, glm::dvec3(0.5, 1, 1.5));
  EXPECT_EQ(l[1].attenuation, Attenuation::Linear);
  EXPECT_EQ(l[1].range, 4);
  EXPECT_EQ(l[2].kind, LightKind::Spot);
  EXPECT_EQ(l[2].direction, glm::dvec3(0, 1, -1));
  EXPECT_EQ(l[2].inner, 5);
  EXPECT_EQ(l[2].outer, 30);
  EXPECT_EQ(l[2].falloff, 3);
  EXPECT_EQ(l[2].c, glm::dvec3(1, 4, 16));  // so that c2 d and c3 d^2 stay the same
  EXPECT_EQ(l[3].direction, glm::dvec3(0.5, 0, -2));
  EXPECT_EQ(l[3].attenuation, Attenuation::InverseSquare);
}

// Lights have defaults: a light comes from the upper left, a spot looks at the scene's centre, and
// intensities are shared.
TEST(SceneFile, LightsThatSayLittle) {
  const Scene one = parsed(withTriangle(R"("up": "z", "lights": [{}])"));
  EXPECT_EQ(one.light.lights.at(0), (Light{.Ip = glm::dvec3{0.7}, .direction = defaultLight(UpAxis::Z)}));
  EXPECT_FALSE(one.light.Ia.has_value());
  EXPECT_EQ(one.settings.light.Ia, 0.2);

  const Scene shared = parsed(withTriangle(R"("ambient": 0.25, "lights": [{}, {"Ip": [0.5, 0, 0]}, {}])"));
  EXPECT_EQ(shared.light.lights.at(0).Ip, glm::dvec3{0.125});
  EXPECT_EQ(shared.light.lights.at(2).Ip, glm::dvec3{0.125});

  const Scene spot = parsed(withTriangle(R"("lights": [{"kind": "spot", "at": [0.5, 0.5, 4], "outer": 9,
    "attenuation": "textbook"}, {"kind": "spot", "at": [0.5, 0.5, 4], "inner": 40, "attenuation": "linear"}])"));
  const Light& light = spot.light.lights.at(0);
  EXPECT_EQ(light.direction, glm::dvec3(0, 0, -2));
  EXPECT_EQ(light.inner, 9);
  EXPECT_EQ(light.c, glm::dvec3(1, 0, 0.25));  // 1/2 at the centre
  EXPECT_EQ(spot.light.lights.at(1).outer, 40);
  EXPECT_EQ(spot.light.lights.at(1).range, 4);  // 1/2 at the centre

  // The user's light can have at most what the scene's own light leaves.
  EXPECT_NEAR(parsed(withTriangle(R"("ambient": [0.2, 0.6, 0])")).settings.light.Ip, 0.4, 1e-15);
  EXPECT_NEAR(parsed(withTriangle(R"("lights": [{"Ip": 0.95}])")).settings.light.Ia, 0.05, 1e-15);
}

// Ia plus the sum of Ip may be 1 in each channel, added as decimals, but not more.
TEST(SceneFile, IntensitiesSumToOne) {
  EXPECT_GT(0.05 + 0.55 + 0.3 + 0.1, 1.0);  // in doubles
  EXPECT_EQ(complaint(withTriangle(R"("ambient": 0.05, "lights": [{"Ip": 0.55}, {"Ip": 0.3}, {"Ip": 0.1}])")),
            "no complaint");
  EXPECT_EQ(
      complaint(withTriangle(R"("ambient": 0.1, "lights": [{"Ip": [0, 0.9, 0]}, {"Ip": [0.9, 0, 0.9]}])")),
      "no complaint");
  EXPECT_EQ(complaint(withTriangle(R"("ambient": [0, 0.1, 0], "lights": [{"Ip": 0.95}])")),
            "s.json: Ia + the sum of Ip is 1.05 in green; it must not exceed 1");
  EXPECT_EQ(complaint(R"({"ambient": 0.9, "shading": {"Ip": 0.9}, "objects": [{"solid": "cube"}]})"),
            "s.json: shading.Ip: Ia + the sum of Ip is 1.8 in red; it must not exceed 1");
  EXPECT_EQ(complaint(R"({"lights": [{"Ip": 0.8}], "shading": {"Ia": 0.3}, "objects": [{"solid": "cube"}]})"),
            "s.json: shading.Ia: Ia + the sum of Ip is 1.1 in red; it must not exceed 1");
}

// A scene can ask for every choice by the name that the command line uses.
TEST(SceneFile, Choices) {
  const auto asked = [](const std::string& shading) {
    return parsed(withTriangle(R"("up": "z", "shading": )" + shading)).settings;
  };
  PictureSettings none;
  none.light.light = defaultLight(UpAxis::Z);
  EXPECT_EQ(asked("{}"), none);
  const auto quoted = [](std::string_view name) { return "\"" + std::string{name} + "\"}"; };
  for (const auto& row : kShadings) EXPECT_EQ(asked(R"({"method": )" + quoted(row.name)).shading, row.id);
  for (const auto& row : kNormalRules) EXPECT_EQ(asked(R"({"normals": )" + quoted(row.name)).normals, row.id);
  for (const auto& row : kPolygons) EXPECT_EQ(asked(R"({"polygons": )" + quoted(row.name)).polygons, row.id);
  for (const auto& row : kForms) EXPECT_EQ(asked(R"({"form": )" + quoted(row.name)).light.form, row.id);
  for (const auto& row : kEnvironmentForms)
    EXPECT_EQ(asked(R"({"environment": )" + quoted(row.name)).environment, row.id);
  for (const auto& row : kTextureMappings)
    EXPECT_EQ(asked(R"({"mapping": )" + quoted(row.name)).mapping, row.id);
  for (const auto& row : kOrders) EXPECT_EQ(asked(R"({"order": )" + quoted(row.name)).order, row.id);
  for (const auto& row : kColorPlans) EXPECT_EQ(asked(R"({"colors": )" + quoted(row.name)).colors, row.id);
  for (const auto& row : kTables)
    EXPECT_EQ(asked(R"({"table": {"kind": )" + quoted(row.name) + "}").table.kind, row.id);
  for (const auto& row : kPicks)
    EXPECT_EQ(asked(R"({"table": {"pick": )" + quoted(row.name) + "}").table.pick, row.id);

  const PictureSettings s =
      asked(R"({"crease": 30, "dither": true, "Ia": 0.1, "Ip": 0.8, "ka": 0.3, "kd": 0.4,
    "ks": 0.5, "n": 7, "light": [1, 2, 3], "table": {"shades": 64, "i0": 0.05, "hue": [0.5, 1, 0], "bits": 8}})");
  PictureSettings expected;
  expected.crease = 30;
  expected.dither = true;
  expected.light = {.Ia = 0.1, .Ip = 0.8, .ka = 0.3, .kd = 0.4, .ks = 0.5, .n = 7, .light = {1, 2, 3}};
  expected.table.shades = 64;
  expected.table.I0 = 0.05;
  expected.table.hue = {0.5, 1, 0};
  expected.table.bits = 8;
  EXPECT_EQ(s, expected);
  EXPECT_EQ(asked(R"({"Ia": 0.9})").light.Ip, 0.1);  // Ia and Ip push each other
  EXPECT_EQ(asked(R"({"Ip": 1})").light.Ia, 0);
}

// Cameras of each kind are read.
TEST(SceneFile, Cameras) {
  const auto camera = [](const std::string& text) {
    return parsed(R"({"camera": )" + text + R"(, "objects": [)" + kTriangle + "]}").camera;
  };
  const CameraSettings look =
      camera(R"({"eye": [1, 2, 3], "look_at": [0, 0, 1], "up": [0, 1, 0], "fov": 40})");
  EXPECT_EQ(look.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(look.lookAt, glm::dvec3(0, 0, 1));
  EXPECT_EQ(look.fov, 40);
  const CameraSettings oblique = camera(R"({"parallel": 5, "oblique": {"kind": "cabinet", "angle": 30}})");
  EXPECT_TRUE(oblique.parallel);
  EXPECT_EQ(oblique.height, 5);
  EXPECT_EQ(oblique.oblique, (Oblique{0.5, 30}));
  const CameraSettings book = camera(
      R"({"vrp": [0,0,0], "vpn": [0,0,1], "vup": [0,1,0], "prp": [0,0,9], "window": [-1,1,-2,2], "front": 1, "back": -9})");
  EXPECT_EQ(book.window, glm::dvec4(-1, 1, -2, 2));
  EXPECT_EQ(book.back, -9);
}

// The user's settings replace those of the scene's camera, each by itself.
TEST(SceneFile, SaidCamerasComeFirst) {
  CameraSettings scene, said;
  scene.eye = glm::dvec3{1, 2, 3};
  scene.lookAt = glm::dvec3{0};
  scene.fov = 50;
  EXPECT_EQ(completed(said, scene), scene);
  said.parallel = true;
  said.height = 2;
  EXPECT_EQ(completed(said, scene).eye, scene.eye);
  EXPECT_TRUE(completed(said, scene).parallel);
  EXPECT_FALSE(completed(said, scene).fov);
  said.eye = glm::dvec3{7, 7, 7};
  EXPECT_EQ(completed(said, scene).eye, said.eye);
  EXPECT_EQ(completed(said, scene).lookAt, scene.lookAt);
}

// What the file says beside its eye counts: the planes and the window are those of the file. Nothing is lost
// if the user gives one of them, too.
TEST(SceneFile, PlanesAndWindowBesideAnEyeCount) {
  const Scene scene = parsed(R"({"camera": {"eye": [1, 2, 5], "look_at": [0, 0, 0], "window": [-2, 2, -1, 1],
                                            "front": 0.5, "back": -3}, "objects": [)" +
                             kTriangle + "]}");
  EXPECT_EQ(completed({}, scene.camera), scene.camera);
  CameraSettings said = completed({}, scene.camera);
  const auto placed = [&](const CameraSettings& camera) {
    return placeCamera(camera, scene.mesh.points, scene.up, 2.0);
  };
  const ViewSpec view = placed(said).view;
  EXPECT_EQ(view.windowMin, glm::dvec2(-2, -1));
  EXPECT_EQ(view.windowMax, glm::dvec2(2, 1));
  EXPECT_EQ(view.front, 0.5);
  EXPECT_EQ(view.back, -3);
  for (const auto part : {&CameraSettings::front, &CameraSettings::back}) {
    CameraSettings user;
    user.*part = part == &CameraSettings::front ? 0.75 : -7.0;
    CameraSettings expected = scene.camera;
    expected.*part = user.*part;
    EXPECT_EQ(completed(user, scene.camera), expected);
    EXPECT_EQ(placed(completed(user, scene.camera)).eye, glm::dvec3(1, 2, 5));
  }
  CameraSettings user, expected = scene.camera;
  user.window = expected.window = glm::dvec4{-1, 1, -1, 1};
  EXPECT_EQ(completed(user, scene.camera), expected);
}

// A part has two names in the two notations. Given by one name, it takes the place of the other.
TEST(SceneFile, OnePartOfACameraHasTwoNames) {
  const glm::dvec3 p{1, 2, 3}, q{3, 2, 9};
  CameraSettings eye, book;
  eye.eye = eye.lookAt = eye.up = p;
  eye.fov = 40;
  book.vrp = book.vpn = book.vup = book.prp = p;
  book.window = glm::dvec4{-1, 1, -1, 1};
  book.front = 1.0;
  const auto with = [&](const CameraSettings& scene, auto CameraSettings::*member, const auto& value) {
    CameraSettings user;
    user.*member = value;
    return completed(user, scene);
  };
  for (const auto member : {&CameraSettings::vpn, &CameraSettings::prp}) {
    CameraSettings expected = eye;
    expected.eye.reset();
    expected.*member = q;
    EXPECT_EQ(with(eye, member, q), expected);
  }
  CameraSettings expected = eye;
  expected.lookAt.reset(), expected.vrp = q;
  EXPECT_EQ(with(eye, &CameraSettings::vrp, q), expected);
  expected = eye;
  expected.up.reset(), expected.vup = q;
  EXPECT_EQ(with(eye, &CameraSettings::vup, q), expected);
  expected = eye;
  expected.fov.reset(), expected.window = book.window;
  EXPECT_EQ(with(eye, &CameraSettings::window, *book.window), expected);

  expected = book;
  expected.vpn.reset(), expected.prp.reset(), expected.eye = q;
  EXPECT_EQ(with(book, &CameraSettings::eye, q), expected);
  expected = book;
  expected.vrp.reset(), expected.lookAt = q;
  EXPECT_EQ(with(book, &CameraSettings::lookAt, q), expected);
  expected = book;
  expected.vup.reset(), expected.up = q;
  EXPECT_EQ(with(book, &CameraSettings::up, q), expected);
  expected = book;
  expected.window.reset(), expected.fov = 20;
  EXPECT_EQ(with(book, &CameraSettings::fov, 20.0), expected);
}

// Every built-in scene can be read, has faces and says what it shows.
TEST(SceneFile, BuiltInScenes) {
  const std::vector<BuiltInScene> scenes = builtInScenes();
  EXPECT_GE(scenes.size(), 15u);
  for (const BuiltInScene& s : scenes) {
    SCOPED_TRACE(s.name);
    EXPECT_TRUE(isBuiltIn(s.name));
    EXPECT_GT(s.shows.size(), 10u);
    EXPECT_GT(readScene(s.name).parts.count(), 1);
  }
  EXPECT_FALSE(isBuiltIn("../scenes/room"));
  EXPECT_FALSE(isBuiltIn("room.json"));
}

}  // namespace xnewell::THIS_FILE
