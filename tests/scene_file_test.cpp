#include "shading/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "geometry/parse_error.h"

namespace {

const std::filesystem::path kData{XNEWELL_DATA_DIR};

Scene parsed(const std::string& text) { return parseSceneFile(text, "s.json", kData); }

std::string complaint(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "no complaint";
}

std::string withObject(const std::string& object) { return R"({"objects": [)" + object + "]}"; }
const std::string kTriangle = R"({"polygons": [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]})";

}  // namespace

// Faces are numbered object by object, corners at one place are one vertex, names become groups.
TEST(SceneFile, ObjectByObject) {
  const Scene s = parsed(R"({"up": "z", "objects": [
    {"name": "floor", "polygons": [[[0,0,0],[4,0,0],[4,4,0],[0,4,0]], [[0,0,0],[0,4,0],[0,4,3]]]},
    {"name": "pot", "file": "teapot.bpt", "divisions": 2, "scale": 0.5, "move": [2, 2, 0]},
    {"solid": "cube", "color": [0.5, 0.25, 1]}]})");
  EXPECT_EQ(s.up, UpAxis::Z);
  EXPECT_EQ(s.mesh.faceCount(), 2 + 32 * 4 + 6);
  EXPECT_EQ(s.mesh.face(0)[0], s.mesh.face(1)[0]);
  EXPECT_EQ(s.mesh.groupNames[s.mesh.group[1]], "floor");
  EXPECT_EQ(s.mesh.groupNames[s.mesh.group[2]], "pot");
  EXPECT_EQ(s.mesh.groupNames[s.mesh.group[129]], "pot");
  EXPECT_EQ(s.mesh.material[129], -1);
  EXPECT_EQ(s.mesh.materials[s.mesh.material[130]].diffuse, glm::dvec3(0.5, 0.25, 1));
}

// Scale, then move; the scene is normalised by a power of two, so file coordinates come back exactly.
TEST(SceneFile, ScaleThenMove) {
  const Scene s = parsed(withObject(R"({"solid": "cube", "scale": 2, "move": [10, 0, 0]})"));
  double low = 1e9, high = -1e9;
  for (const glm::dvec3& p : s.mesh.points) {
    low = std::min(low, std::ldexp(p.x, s.exponent));
    high = std::max(high, std::ldexp(p.x, s.exponent));
  }
  EXPECT_EQ(low, 8);
  EXPECT_EQ(high, 12);
}

// The rounding of inline polygons is half a unit of the last decimal in their text, and of nothing else.
TEST(SceneFile, RoundingFromTheTextOfPolygons) {
  const auto rounding = [](const std::string& text) {
    const Scene s = parsed(text);
    return std::ldexp(s.mesh.roundingOf(0), s.exponent);
  };
  EXPECT_EQ(rounding(withObject(R"({"polygons": [[[0.25, 0, 0], [1.5, 0, 0], [0, 1, 0]]]})")), 0.5 / 10 / 10);
  EXPECT_EQ(rounding(withObject(
                R"({"polygons": [[[0.250, 0, 0], [1, 0, 0], [0, 1, 0]]], "color": [0.12345, 0, 0]})")),
            0.5 / 10 / 10 / 10);
  EXPECT_EQ(rounding(withObject(R"({"solid": "cube", "move": [0.12345, 0, 0]})")), 0);
}

// Every object keeps the rounding of its own coordinates, scaled with it; a solid's are exact.
TEST(SceneFile, RoundingByObject) {
  const std::string polygons = R"("polygons": [[[0.25, 0, 0], [1.5, 0, 0], [0, 1, 0]]])";
  const Scene s = parsed(R"({"objects": [{"solid": "cube"}, {)" + polygons + R"(, "scale": 4}, {)" +
                         polygons + R"(, "name": "last"}, {"solid": "cube"}]})");
  const auto rounding = [&](int f) { return std::ldexp(s.mesh.roundingOf(f), s.exponent); };
  ASSERT_EQ(s.mesh.faceCount(), 14);
  EXPECT_EQ(rounding(5), 0);
  EXPECT_EQ(rounding(6), 4 * (0.5 / 10 / 10));
  EXPECT_EQ(rounding(7), 0.5 / 10 / 10);
  EXPECT_EQ(rounding(8), 0);
}

// A camera of each kind.
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

// What the user says replaces the scene's camera where it says something.
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
  CameraSettings book;
  book.vrp = glm::dvec3{0};
  EXPECT_FALSE(completed(book, scene).eye);
}

// Every complaint names the place and what is allowed there.
TEST(SceneFile, ComplaintsNameThePlace) {
  EXPECT_EQ(complaint("{\n\"objects\": [\n1,,\n]}"), "s.json:3: not JSON here");
  EXPECT_EQ(complaint(""), "s.json:1: not JSON here");
  EXPECT_EQ(complaint("[]"), "s.json: an object { } is needed");
  EXPECT_EQ(complaint("{}"), "s.json: holds no face");
  EXPECT_EQ(complaint(R"({"light": []})"),
            "s.json: unknown key 'light'; there are shows, up, camera, ambient, lights, shading, materials, "
            "objects");
  EXPECT_EQ(complaint(R"({"up": "x"})"), "s.json: up: \"y\" or \"z\" is needed");
  EXPECT_EQ(complaint(R"({"objects": {}})"), "s.json: objects: a list [ ] is needed");
  EXPECT_EQ(complaint(withObject("{}")), "s.json: objects[0]: one of file, polygons and solid is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cone"})")),
            "s.json: objects[0].solid: cube, sphere or torus is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "torus", "around": 2})")),
            "s.json: objects[0].around: a whole number from 3 to 4096 is needed");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[0,0,0],[1,0,0]]]})")),
            "s.json: objects[0].polygons[0]: a polygon needs at least 3 corners");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[0,0,0],[1,0,0],[1,1]]]})")),
            "s.json: objects[0].polygons[0][2]: a list of 3 numbers is needed");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[0,0,"a"],[1,0,0],[1,1,0]]]})")),
            "s.json: objects[0].polygons[0][0][2]: a number is needed");
  EXPECT_EQ(complaint(withObject(R"({"file": "x.txt"})")),
            "s.json: objects[0].file: an .obj or .bpt file is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cube", "scale": 0})")),
            "s.json: objects[0].scale: a number above 0 is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cube", "scale": 1e308, "move": [1e308, 0, 0]})")),
            "s.json: objects[0]: the object is scaled out of range");
  EXPECT_EQ(complaint(R"({"camera": {"fov": 180}, "objects": [)" + kTriangle + "]}"),
            "s.json: camera.fov: an angle between 0 and 180 degrees is needed");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[1e999,0,0],[1,0,0],[1,1,0]]]})")),
            "s.json: a number is too large");
  EXPECT_NE(complaint(withObject(R"({"file": "nosuch.obj"})")).find("No such file"), std::string::npos);
}

// Cutting a scene file short at any byte is refused, never more.
TEST(SceneFile, TruncatedAnywhere) {
  const std::string whole = R"({"up": "z", "camera": {"eye": [3, 2, 1]}, "objects": [)" + kTriangle + "]}";
  EXPECT_EQ(complaint(whole), "no complaint");
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THROW((void)parsed(whole.substr(0, n)), ParseError) << n;
}

// Every built-in scene says what it shows, has faces and can be read.
TEST(SceneFile, BuiltInScenes) {
  const std::vector<BuiltInScene> scenes = builtInScenes();
  EXPECT_GE(scenes.size(), 15u);
  for (const BuiltInScene& s : scenes) {
    SCOPED_TRACE(s.name);
    EXPECT_TRUE(isBuiltIn(s.name));
    EXPECT_GT(s.shows.size(), 10u);
    EXPECT_GT(readScene(s.name).pieces.count(), 1);
  }
  EXPECT_FALSE(isBuiltIn("../scenes/room"));
  EXPECT_FALSE(isBuiltIn("room.json"));
}
