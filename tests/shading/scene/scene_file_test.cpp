#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "geometry/files/parse_error.h"
#include "geometry/model/solids.h"
#include "shading/color/png.h"
#include "shading/scene/json_text.h"
#include "shading/scene/scene_file.h"
#include "tests/support/reader_fixture.h"
#include "tests/support/scene_text.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The objects of a scene file

glm::dvec3 inFile(const Scene& scene, glm::dvec3 p) {
  for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], scene.exponent);
  return p;
}

// Faces are numbered object by object, corners at one place are one vertex, and names become groups.
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

/// Of a face, in the file's units.
double roundingIn(const std::string& objects, int face = 0, const std::string& more = "") {
  const Scene s = parsed("{" + more + R"("objects": [)" + objects + "]}");
  return std::ldexp(s.mesh.roundingOf(face), s.exponent);
}
const std::string kTwoDecimals = R"("polygons": [[[0.25, 0, 0], [15000.5, 0, 0], [0, 10000, 0]]])";

// Every object has its own rounding, scaled with it: half a unit of the last decimal in the text of its
// polygons. No other text matters. A solid's coordinates are exact.
TEST(SceneFile, RoundingByObject) {
  constexpr double kHalf = 0.5 / 10 / 10;
  EXPECT_EQ(roundingIn("{" + kTwoDecimals + "}"), kHalf);
  EXPECT_EQ(roundingIn(
                R"({"polygons": [[[0.250, 0, 0], [15000, 0, 0], [0, 10000, 0]]], "color": [0.12345, 0, 0]})"),
            kHalf / 10);
  EXPECT_EQ(roundingIn(R"({"solid": "cube", "move": [0.12345, 0, 0]})"), 0);
  // A choice of the same name does not count.
  EXPECT_EQ(roundingIn("{" + kTwoDecimals + "}", 0,
                       R"("shading": {"polygons": "rows", "light": [0.12345, 0, 1]}, )"),
            kHalf);
  const std::string four = R"({"solid": "cube"}, {)" + kTwoDecimals + R"(, "scale": 4}, {)" + kTwoDecimals +
                           R"(, "name": "last"}, {"solid": "cube"})";
  for (const auto& [face, rounding] : {std::pair{5, 0.0}, {6, 4 * kHalf}, {7, kHalf}, {8, 0.0}})
    EXPECT_EQ(roundingIn(four, face), rounding) << face;
}

// An object is scaled, then turned about x, y and z in this order, then moved. Quarter turns are exact.
TEST(SceneFile, TransformsInTheirOrder) {
  const auto first = [](const std::string& object) {
    const Scene s =
        parsed(withObject(R"({"polygons": [[[1, 2, 3], [4, 0, 0], [0, 5, 0]]], )" + object + "}"));
    return inFile(s, s.mesh.points[0]);
  };
  EXPECT_EQ(first(R"("scale": [2, 3, 4])"), glm::dvec3(2, 6, 12));
  EXPECT_EQ(first(R"("rotate": [90, 0, 0])"), glm::dvec3(1, -3, 2));
  EXPECT_EQ(first(R"("rotate": [0, 90, 0])"), glm::dvec3(3, 2, -1));
  EXPECT_EQ(first(R"("rotate": [0, 0, 90])"), glm::dvec3(-2, 1, 3));
  EXPECT_EQ(first(R"("rotate": [90, 0, 90])"), glm::dvec3(3, 1, 2));  // (1, -3, 2), then about z
  EXPECT_EQ(first(R"("scale": [2, 1, 1], "rotate": [0, 0, -90], "move": [0, 10, 100])"),
            glm::dvec3(2, 10 - 2, 103));
  const glm::dvec3 turned = first(R"("rotate": {"axis": [2, 2, 2], "degrees": 120})");  // x to y to z
  EXPECT_LT(glm::length(turned - glm::dvec3(3, 1, 2)), 1e-14);
  EXPECT_EQ(first(R"("rotate": {"axis": [0, 0, 7], "degrees": 90})"), first(R"("rotate": [0, 0, 90])"));
}

// Polygons that are flat in the file stay flat under any turn: none is cut into triangles.
TEST(SceneFile, TurnedPolygonsStayFlat) {
  for (int k = 1; k < 60; ++k) {
    const std::string degrees = std::to_string(k);
    const Scene s = parsed(R"({"objects": [{"solid": "cube", "scale": [3, 0.7, 1], "rotate": [)" + degrees +
                           ", " + std::to_string(7 * k) + R"(, 11.3], "move": [40, 3, 0]}]})");
    EXPECT_EQ(s.parts.count(), 6) << k;
  }
}

// Patches are transformed before they are divided. So their points and their exact normals are those of the
// transformed surface.
TEST(SceneFile, PatchesAreTransformedThemselves) {
  const Scene s = parsed(R"({"up": "z", "objects": [{"solid": "cube"},
    {"file": "teapot.bpt", "scale": [3, 1, 0.5], "rotate": [20, 30, 40], "move": [1, 2, 3], "divisions": 24}]})");
  ASSERT_EQ(s.patches.size(), 1u);
  EXPECT_EQ(s.patches[0].firstCorner, 24);
  EXPECT_EQ(s.patches[0].divisions, 24);
  const std::vector<glm::dvec3> exact = exactNormals(s, NormalRule::Exact);
  ASSERT_EQ(exact.size(), s.mesh.corners.size());
  int compared = 0, apart = 0;
  for (int f = 6; f < s.mesh.faceCount(); ++f) {
    const auto face = s.mesh.face(f);
    const glm::dvec3 a = s.mesh.points[face[0]], b = s.mesh.points[face[1]], c = s.mesh.points[face[2]];
    const glm::dvec3 N = glm::cross(b - a, c - a);
    if (glm::length(N) < 1e-9) continue;
    ++compared;
    apart += glm::dot(glm::normalize(N), exact[s.mesh.firstCorner[f]]) < 0.9;
  }
  EXPECT_GT(compared, 18'000);
  EXPECT_LT(apart, compared / 100);  // except for the small faces at the poles and at the spout's tip
}

// The command line's divisions apply to patches that do not give their own.
TEST(SceneFile, DivisionsOfPatches) {
  const auto faces = [](const std::string& said, int divisions) {
    const Scene s =
        parseSceneFile(withObject(R"({"file": "teapot.bpt")" + said + "}"), "s.json", kData, divisions);
    return s.mesh.faceCount();
  };
  EXPECT_EQ(faces("", 3), 32 * 9);
  EXPECT_EQ(faces(R"(, "divisions": 2)", 3), 32 * 4);
  // The scene's divisions are those of the patches that do not give their own.
  const Scene both =
      parsed(R"({"objects": [{"file": "teapot.bpt", "divisions": 2}, {"file": "teapot.bpt"}]})");
  EXPECT_EQ(both.divisions, kDefaultDivisions);
  EXPECT_EQ(both.patches[0].divisions, 2);
  EXPECT_EQ(both.patches[1].divisions, kDefaultDivisions);
  EXPECT_EQ(titleOf(both), "s.json");
  EXPECT_EQ(parsed(R"({"objects": [{"file": "teapot.bpt", "divisions": 2}]})").divisions, 0);
}

// Texture coordinates belong to their object, whatever comes before and after it. Corners without any have
// none.
TEST(SceneFile, TextureCoordinatesOfEachObject) {
  const Scene s = parsed(R"({"objects": [
    {"polygons": [[[0,0,0],[1,0,0],[0,1,0]]]},
    {"solid": "cube"},
    {"polygons": [[[0,0,1],[1,0,1],[0,1,1]]], "uv": [[[0.25, 0.5], [2, 0.5], [0.25, -3]]]},
    {"polygons": [[[0,0,2],[1,0,2],[0,1,2]]]}]})");
  ASSERT_EQ(s.mesh.uvOfCorner.size(), s.mesh.corners.size());
  const auto uv = [&](int face, int corner) {
    const int k = s.mesh.uvOfCorner[s.mesh.firstCorner[face] + corner];
    return k < 0 ? glm::dvec2{-99} : s.mesh.uv[k];
  };
  EXPECT_EQ(uv(0, 0), glm::dvec2{-99});
  const Mesh alone = cube();
  for (int f = 0; f < 6; ++f)
    for (int c = 0; c < 4; ++c) EXPECT_EQ(uv(1 + f, c), alone.uv[alone.uvOfCorner[4 * f + c]]);
  EXPECT_EQ(uv(7, 0), glm::dvec2(0.25, 0.5));
  EXPECT_EQ(uv(7, 2), glm::dvec2(0.25, -3));
  EXPECT_EQ(uv(8, 0), glm::dvec2{-99});
}

// An object has the material that it names. A material is kept once, however many objects name it. The user
// chooses what a material does not give.
TEST(SceneFile, Materials) {
  const Scene s = parsed(R"({"materials": {
      "unused": {"color": [0, 0, 1]},
      "brass": {"color255": [255, 0, 51], "specular": [1, 0.5, 0], "ka": 0.25, "kd": 0.5, "ks": 1, "n": 80},
      "chalk": {"ks": 0}},
    "objects": [{"solid": "cube", "material": "brass"}, {"solid": "cube"}, {"solid": "cube", "material": "brass"},
                {"solid": "cube", "material": "chalk"}]})");
  ASSERT_EQ(s.mesh.materials.size(), 2u);
  const MeshMaterial& brass = s.mesh.materials[s.mesh.material[0]];
  EXPECT_EQ(brass.name, "brass");
  EXPECT_EQ(brass.diffuse, glm::dvec3(1, 0, 0.2));
  EXPECT_EQ(brass.specular, glm::dvec3(1, 0.5, 0));
  EXPECT_EQ(brass.ka, 0.25);
  EXPECT_EQ(brass.kd, 0.5);
  EXPECT_EQ(brass.ks, 1);
  EXPECT_EQ(brass.n, 80);
  EXPECT_EQ(s.mesh.material[6], -1);
  EXPECT_EQ(s.mesh.material[12], s.mesh.material[0]);
  const MeshMaterial& chalk = s.mesh.materials[s.mesh.material[18]];
  EXPECT_EQ(chalk.ks, 0);
  EXPECT_FALSE(chalk.ka || chalk.kd || chalk.n);
}

// Textures lie in the folder of the scene file, and each is read once. An object without texture coordinates
// cannot have one.
TEST(SceneFile, TexturesOfMaterials) {
  const TemporaryFolder folder;
  RgbImage image{2, 1};
  image.rgb = {10, 20, 30, 40, 50, 60};
  writePng(folder.file("t.png"), image);
  const auto read = [&](const std::string& objects) {
    return parseSceneFile(
        R"({"materials": {"a": {"texture": "t.png"}, "b": {"texture": "t.png", "ks": 0}, "c": {},
      "gone": {"texture": "no.png"}}, "objects": [)" +
            objects + "]}",
        "s.json", folder.file(""));
  };
  const Scene s = read(R"({"solid": "cube", "material": "c"}, {"solid": "cube", "material": "b"},
                          {"solid": "torus", "material": "a"})");
  ASSERT_EQ(s.textures.size(), 1u);
  EXPECT_EQ(s.textures[0].width, 2);
  EXPECT_EQ(s.textures[0].channel[2][1], 60);
  EXPECT_EQ(s.mesh.materials[s.mesh.material[0]].texture, -1);
  EXPECT_EQ(s.mesh.materials[s.mesh.material[6]].texture, 0);
  EXPECT_EQ(s.mesh.materials[s.mesh.material[12]].texture, 0);
  EXPECT_THROW((void)read(kTriangle.substr(0, kTriangle.size() - 1) + R"(, "material": "a"})"), ParseError);
  EXPECT_EQ(complaint([&] { return read(R"({"solid": "cube", "material": "gone"})"); }),
            "s.json: materials.gone.texture: 'no.png': No such file or directory");
}

// A turn combines the roundings of three axes, and adds the rounding of doubles.
TEST(SceneFile, RoundingOfTurnedObjects) {
  // Doubles at 15,000 are rounded, too.
  EXPECT_NEAR(roundingIn("{" + kTwoDecimals + R"(, "scale": [1, 2, 4], "rotate": [1, 2, 3]})"),
              4 * std::sqrt(3.0) * 0.005, 1e-10);
  const double ofDoubles = roundingIn(R"({"solid": "cube", "rotate": [1, 2, 3]})");
  EXPECT_GT(ofDoubles, 0x1p-52);
  EXPECT_LT(ofDoubles, 0x1p-48);
}

// Normals of a file stay perpendicular to the surface when its object is scaled and turned, and they are on
// the front of their face. A scene that has some begins with them.
TEST(SceneFile, TakesNormalsOfModelsAlong) {
  const TemporaryFolder folder;
  (void)folder.write("a.obj",
                     "v 0 0 0\nv 1 0 1\nv 1 1 1\nv 0 1 0\nvn -1 0 1\nvn 1 0 -1\nvn 0 0 1\n"
                     "f 1//1 2//3 3//1 4//1\nf 1//2 2//2 3\n");
  const std::string objects = R"("objects": [{"polygons": [[[9, 0, 0], [9, 1, 0], [9, 0, 1]]]},
      {"file": "a.obj", "scale": [2, 1, 1], "rotate": [0, 0, 90], "move": [5, 5, 5]}])";
  const auto read = [&](const std::string& more) {
    return readScene(folder.write("s.json", "{" + objects + more + "}"));
  };
  const Scene scene = read("");
  EXPECT_EQ(scene.settings.normals, NormalRule::File);
  EXPECT_EQ(read(R"(, "shading": {"method": "gouraud", "normals": "sum"})").settings.normals,
            NormalRule::Sum);
  ASSERT_EQ(scene.mesh.normals.size(), 10u);
  const glm::dvec3 slope{0, -1 / std::sqrt(5.0), 2 / std::sqrt(5.0)}, none{0.0};
  const std::vector<glm::dvec3> expected{none,  none,  none,  slope, {0, 0, 1},
                                         slope, slope, slope, slope, none};
  for (int c = 0; c < 10; ++c) EXPECT_LT(glm::distance(scene.mesh.normals[c], expected[c]), 1e-15) << c;
}

// Faces that people rarely mean are noted: those that cross themselves, with an area or without, and bent
// ones.
TEST(SceneFile, NotesCrossingAndBentFaces) {
  const auto notes = [](const std::string& face) {
    const TemporaryFolder folder;
    return readScene(folder.write("odd.json", withObject(R"({"polygons": [)" + face + "]}"))).mesh.notes;
  };
  const auto says = [&](const std::string& face, const char* what) {
    const std::vector<std::string> all = notes(face);
    return all.size() == 1 && all.front().find(what) != std::string::npos;
  };
  EXPECT_TRUE(says("[[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]", "face 0 crosses itself"));
  EXPECT_TRUE(says("[[0, 0, 0], [2, 0, 2], [2, 0, 0], [0, 0, 1]]", "face 0 crosses itself"));
  EXPECT_TRUE(says("[[0, 0, 0], [1, 0, 0], [1, 1, 0.1], [0, 1, 0]]", "face 0 is bent"));
  EXPECT_TRUE(notes("[[0, 0, 0], [3, -2, 0], [1, 0, 0], [3, 2, 0]]").empty());
  EXPECT_TRUE(notes("[[0, 0, 0], [1, 0, 0], [0, 1, 0]]").empty());
}

// A scene file cut short at any byte is refused, and does no other harm.
TEST(SceneFile, TruncatedAnywhere) {
  const std::string whole =
      R"({"up": "z", "camera": {"eye": [3, 2, 1]}, "ambient": 0.1, "lights": [{"Ip": 0.5}],
    "shading": {"method": "flat", "table": {"shades": 9}}, "materials": {"m": {"ks": 1}}, "objects": [)" +
      kTriangle + R"(, {"solid": "cube", "material": "m", "rotate": [1, 2, 3]}]})";
  EXPECT_EQ(complaint(whole), "no complaint");
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THROW((void)parsed(whole.substr(0, n)), ParseError) << n;
}

/// ---- Its lights, choices and cameras

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
  EXPECT_EQ(l[0], (Light{.Ip = glm::dvec3{0.25}, .direction = {0, 0, 5}}));
  EXPECT_EQ(l[1].kind, LightKind::Point);
  EXPECT_EQ(l[1].Ip, glm::dvec3(0.1, 0, 0.2));
  EXPECT_EQ(l[1].position, glm::dvec3(0.5, 1, 1.5));
  EXPECT_EQ(l[1].attenuation, Attenuation::Linear);
  EXPECT_EQ(l[1].range, 4);
  EXPECT_EQ(l[2].kind, LightKind::Spot);
  EXPECT_EQ(l[2].direction, glm::dvec3(0, 1, -1));
  EXPECT_EQ(std::tuple(l[2].inner, l[2].outer, l[2].falloff), std::tuple(5, 30, 3));
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

// A scene that chooses nothing has the defaults. Ia and Ip push each other.
TEST(SceneFile, Choices) {
  const auto asked = [](const std::string& shading) {
    return parsed(withTriangle(R"("up": "z", "shading": )" + shading)).settings;
  };
  PictureSettings none;
  none.light.light = defaultLight(UpAxis::Z);
  EXPECT_EQ(asked("{}"), none);
  EXPECT_EQ(asked(R"({"Ia": 0.9})").light.Ip, 0.1);
  EXPECT_EQ(asked(R"({"Ip": 1})").light.Ia, 0);
}

// The planes and the window that a file says beside its eye are those of the view.
TEST(SceneFile, PlanesAndWindowBesideAnEyeCount) {
  const Scene scene = parsed(R"({"camera": {"eye": [1, 2, 5], "look_at": [0, 0, 0], "window": [-2, 2, -1, 1],
                                            "front": 0.5, "back": -3}, "objects": [)" +
                             kTriangle + "]}");
  const ViewSpec view = placeCamera(completed({}, scene.camera), scene.mesh.points, scene.up, 2.0).view;
  EXPECT_EQ(view.windowMin, glm::dvec2(-2, -1));
  EXPECT_EQ(view.windowMax, glm::dvec2(2, 1));
  EXPECT_EQ(view.front, 0.5);
  EXPECT_EQ(view.back, -3);
}

// The user's settings replace those of the scene's camera, each by itself. But a part has two names in the
// two notations. Given by one name, it takes the place of the other, as a parallel view takes that of an
// angle.
TEST(SceneFile, SaidCamerasComeFirst) {
  using Point = std::optional<glm::dvec3> CameraSettings::*;
  const glm::dvec3 p{1, 2, 3}, q{3, 2, 9};
  CameraSettings eye, book;
  eye.eye = eye.lookAt = eye.up = p;
  eye.fov = 40;
  book.vrp = book.vpn = book.vup = book.prp = p;
  book.window = glm::dvec4{-1, 1, -1, 1};
  book.front = 1.0;
  const auto expectInPlaceOf = [](const CameraSettings& scene, const auto& given, auto member,
                                  const auto&... gone) {
    CameraSettings user, expected = scene;
    user.*member = expected.*member = given;
    ((expected.*gone).reset(), ...);
    EXPECT_EQ(completed(user, scene), expected);
  };
  for (const CameraSettings& scene : {eye, book}) {
    EXPECT_EQ(completed({}, scene), scene);
    expectInPlaceOf(scene, 0.75, &CameraSettings::front);
    expectInPlaceOf(scene, -7.0, &CameraSettings::back);
  }
  for (const Point member : {&CameraSettings::eye, &CameraSettings::lookAt, &CameraSettings::up})
    expectInPlaceOf(eye, q, member);
  expectInPlaceOf(book, glm::dvec4{-2, 1, -1, 1}, &CameraSettings::window);
  expectInPlaceOf(eye, true, &CameraSettings::parallel, &CameraSettings::fov);
  for (const Point member : {&CameraSettings::vpn, &CameraSettings::prp})
    expectInPlaceOf(eye, q, member, &CameraSettings::eye);
  expectInPlaceOf(eye, q, &CameraSettings::vrp, &CameraSettings::lookAt);
  expectInPlaceOf(eye, q, &CameraSettings::vup, &CameraSettings::up);
  expectInPlaceOf(eye, *book.window, &CameraSettings::window, &CameraSettings::fov);
  expectInPlaceOf(book, q, &CameraSettings::eye, &CameraSettings::vpn, &CameraSettings::prp);
  expectInPlaceOf(book, q, &CameraSettings::lookAt, &CameraSettings::vrp);
  expectInPlaceOf(book, q, &CameraSettings::up, &CameraSettings::vup);
  expectInPlaceOf(book, 20.0, &CameraSettings::fov, &CameraSettings::window);
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
  EXPECT_FALSE(isBuiltIn("../scenes/room") || isBuiltIn("room.json"));
}

/// ---- JSON

// A list of scenes reads one sentence of each file. What stands below in another object does not count, and
// what stands behind is not read.
TEST(JsonText, ReadsSomeKeysAlone) {
  const JsonText one{
      R"({"other": {"shows": "deep"}, "list": [1, {"shows": 2}], "shows": "a card", "then": nonsense)",
      "a.json",
      {"shows"}};
  EXPECT_EQ(one.root().keys(), std::vector<std::string>{"shows"});
  EXPECT_EQ(one.root().at("shows").text(), "a card");

  const JsonText two{
      R"({"title": "t", "steps": [{"title": "s"}], "number": 3})", "a.json", {"number", "title"}};
  EXPECT_EQ(two.root().at("title").text(), "t");
  EXPECT_EQ(two.root().at("number").whole(1, 9), 3);
  EXPECT_EQ(two.root().keys().size(), 2u);

  EXPECT_FALSE((JsonText{R"({"number": 3})", "a.json", {"shows"}}.root().has("shows")));
  EXPECT_THROW((JsonText{R"({"number": 3, nonsense)", "a.json", {"shows"}}), ParseError);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
