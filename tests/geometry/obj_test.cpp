#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/files/obj.h"
#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- OBJ

using testing::ElementsAre;

/// The mesh of a text without libraries.
Mesh meshOf(std::string_view text) { return parseObj(text, "a.obj", "no such folder"); }

/// Three vertices before the text that a test is about, which is then on line 4.
std::string afterThreeVertices(const std::string& text) { return "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + text; }

/// Expects what mesh.h promises of every mesh.
void expectSound(const Mesh& mesh) {
  ASSERT_GT(mesh.faceCount(), 0);
  EXPECT_EQ(mesh.group.size(), mesh.faceCount());
  EXPECT_EQ(mesh.material.size(), mesh.faceCount());
  EXPECT_EQ(mesh.firstCorner.back(), static_cast<int>(mesh.corners.size()));
  for (const glm::dvec3& p : mesh.points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    EXPECT_GE(mesh.face(f).size(), 3u);
    EXPECT_TRUE(mesh.group[f] >= 0 && mesh.group[f] < static_cast<int>(mesh.groupNames.size()));
    EXPECT_TRUE(mesh.material[f] >= -1 && mesh.material[f] < static_cast<int>(mesh.materials.size()));
  }
  for (const int corner : mesh.corners) {
    EXPECT_TRUE(corner >= 0 && corner < static_cast<int>(mesh.points.size()));
  }
  EXPECT_EQ(mesh.uvOfCorner.size(), mesh.uv.empty() ? 0 : mesh.corners.size());
  for (const int uv : mesh.uvOfCorner) EXPECT_TRUE(uv >= -1 && uv < static_cast<int>(mesh.uv.size()));
  EXPECT_EQ(mesh.rounding.size(), mesh.groupNames.size());
  for (const double u : mesh.rounding) EXPECT_TRUE(u >= 0.0 && u <= 0.5);
}

/// A file with every kind of statement that is read or skipped.
constexpr std::string_view kWhole =
    "# a bit of everything\r\n"
    "mtllib none.mtl\n"
    "o box\n"
    "v 0 0.5 -1e-1 1.0\nv +1. 0 0 0.2 0.3 0.4\nv\t1\t1\t0\nv 0 1 .25\n"
    "vt 0.5 1\nvn 0 0 1\nvn -nan(ind) 0 0\n"
    "g front left\nusemtl red paint\ns off\n"
    "f 1 2 3\nf 1/1 2/1 3/1 4/1\nf 1//1 2//2 \\\n 3//1\n"
    "g\nusemtl\n"
    "f -4/-1/-1 -3/1/1 -1/1/1 # back\nl 1 2\np 1\ncurv 0 1 1 2\n"
    "f 1 3 4";

// A worked example: every kind of statement, in every spelling, ends up where mesh.h says.
TEST(Obj, ReadsABitOfEverything) {
  const Mesh mesh = meshOf(kWhole);
  EXPECT_THAT(mesh.points, ElementsAre(glm::dvec3(0, 0.5, -0.1), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0),
                                       glm::dvec3(0, 1, 0.25)));
  EXPECT_THAT(mesh.corners, ElementsAre(0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 0, 1, 3, 0, 2, 3));
  EXPECT_THAT(mesh.firstCorner, ElementsAre(0, 3, 7, 10, 13, 16));
  EXPECT_THAT(mesh.group, ElementsAre(0, 0, 0, 1, 1));
  EXPECT_THAT(mesh.groupNames, ElementsAre("front left", "default"));
  EXPECT_THAT(mesh.material, ElementsAre(0, 0, 0, -1, -1));
  ASSERT_EQ(mesh.materials.size(), 1u);
  EXPECT_EQ(mesh.materials[0].name, "red paint");
  EXPECT_EQ(mesh.materials[0].diffuse, glm::dvec3(1.0)) << "its library is missing";
  EXPECT_THAT(mesh.rounding, ElementsAre(0.5e-2, 0.5e-2));
  EXPECT_THAT(mesh.uv, ElementsAre(glm::dvec2(0.5, 1)));
  EXPECT_THAT(mesh.uvOfCorner, ElementsAre(-1, -1, -1, 0, 0, 0, 0, -1, -1, -1, 0, 0, 0, -1, -1, -1));
  expectSound(mesh);
}

// One note names the statements that the program does not use, each once, in the order of the file and with
// no more of them than a line holds.
TEST(Obj, NamesWhatItLeavesOut) {
  EXPECT_THAT(meshOf(kWhole).notes, ElementsAre("a.obj:2: material library 'no such folder/none.mtl' not "
                                                "found; materials defined only there are white",
                                                "a.obj: the program does not use s, l, p, curv"));
  std::string many = afterThreeVertices("f 1 2 3\n");
  for (int i = 0; i < 100'000; ++i) many += "k" + std::to_string(i % 50'000) + "\x1b\n";
  EXPECT_THAT(meshOf(many).notes,
              ElementsAre("a.obj: the program does not use k0\\x1b, k1\\x1b, k2\\x1b, k3\\x1b, k4\\x1b, "
                          "k5\\x1b, k6\\x1b, k7\\x1b, k8\\x1b, k9\\x1b, k10\\x1b, k11\\x1b and others"));
}

// A face may come before its vertices.
TEST(Obj, TakesForwardReferences) {
  const Mesh mesh = meshOf("f 1 2 3\nf 3 4 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  EXPECT_THAT(mesh.corners, ElementsAre(0, 1, 2, 2, 3, 0));
}

// Texture coordinates have one to three numbers. Corners refer to them with the same counting as vertices,
// before or after the face, and not every corner or face needs one. They are not kept if no face uses them.
TEST(Obj, ReadsTextureCoordinates) {
  const std::string three = "vt 0.25 # u\nvt 0.5 -1.5\nvt 1e-1 2 3\n";
  const Mesh mesh = meshOf(afterThreeVertices(
      "f 1 2 3\n" + three + "f 1/1 2/-1/7 3\nf 3//1 2//1 1//1\nf 1/4/ 2/-2 3/+1\nvt 7 8\n"));
  EXPECT_THAT(mesh.uv,
              ElementsAre(glm::dvec2(0.25, 0), glm::dvec2(0.5, -1.5), glm::dvec2(0.1, 2), glm::dvec2(7, 8)));
  EXPECT_THAT(mesh.uvOfCorner, ElementsAre(-1, -1, -1, 0, 2, -1, -1, -1, -1, 3, 1, 0));
  expectSound(mesh);
  const Mesh unused = meshOf(afterThreeVertices(three + "f 1 2 3//1\n"));
  EXPECT_TRUE(unused.uv.empty());
  EXPECT_TRUE(unused.uvOfCorner.empty());
}

// Corners may have normals that come later, of any length. What is no direction counts as none.
TEST(Obj, ReadsNormals) {
  const Mesh mesh = meshOf(afterThreeVertices(
      "f 1 2 3\nf 1//1 2//4 3\nvn 0 0 2\nvn 0 0 0\nvn nan 0 1\nvn -1.#IND 0 1\nf 1//-4 2//2 3//3\n"));
  constexpr glm::dvec3 up{0, 0, 1}, none{0};
  EXPECT_THAT(mesh.normals, ElementsAre(none, none, none, up, none, none, up, none, none));
  EXPECT_THAT(mesh.notes, testing::IsEmpty());
  EXPECT_TRUE(meshOf(afterThreeVertices("vn 0 0 1\nf 1 2 3\n")).normals.empty());
  for (const std::string lost : {"2", "-2"}) {
    const Mesh lacking = meshOf(afterThreeVertices("vn 0 0 1\nf 1//1 2//" + lost + " 3\n"));
    EXPECT_THAT(lacking.normals, ElementsAre(up, none, none));
    EXPECT_THAT(lacking.notes,
                ElementsAre("a.obj: faces have normals that the file lacks: there they are computed"));
  }
}

// A face may have any number of corners. A million take no longer than as many in small faces.
TEST(Obj, TakesAFaceOfAMillionVertices) {
  constexpr int kCount = 1'000'000;
  std::string text = "v 0 0 0\n";
  text += 'f';
  for (int i = 0; i < kCount; ++i) text += i % 1000 ? " 1" : " \\\n1";
  const Mesh mesh = meshOf(text);
  EXPECT_EQ(mesh.faceCount(), 1);
  EXPECT_EQ(mesh.face(0).size(), kCount);
}

// `o` and `g` both begin groups. Groups are numbered in the order in which faces use them. A name that owns
// no face is not listed, and a name that comes again is the same group.
TEST(Obj, GroupsAreNumberedAsFacesUseThem) {
  const Mesh mesh = meshOf(
      afterThreeVertices("f 1 2 3\no Teapot\ng body\nf 1 2 3\ng spout\t tip \nf 1 2 3\ng body\nf 1 2 3\n"
                         "o lid\nf 1 2 3\ng\nf 1 2 3\ng unused\n"));
  EXPECT_THAT(mesh.groupNames, ElementsAre("default", "body", "spout tip", "lid"));
  EXPECT_THAT(mesh.group, ElementsAre(0, 1, 2, 1, 3, 0));
}

// Colours come from the libraries beside the file, wherever the file names them. The first library has
// priority. A library that does not exist, a name that no library knows, and a face without a material give
// white.
TEST(Obj, TakesColorsFromItsLibraries) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("b.mtl", "newmtl red\nKd 0.5 0 0\nnewmtl blue\nKd 0 0 1\n");
  folder.write("my own.mtl", "newmtl my green\nKd 0 1 0\n");
  const std::filesystem::path file = folder.write(
      "a.obj",
      afterThreeVertices("f 1 2 3\nusemtl blue\nf 1 2 3\nmtllib lib\\none.mtl\nmtllib a.mtl C:\\lib\\b.mtl\n"
                         "mtllib a.mtl\nmtllib .\\my own.mtl\nmtllib .\nusemtl red\nf 1 2 3\n"
                         "usemtl unused\nusemtl my  green\nf 1 2 3\nusemtl what\nf 1 2 3\n"
                         "usemtl blue\nf 1 2 3\n"));
  const Mesh mesh = readObj(file);
  EXPECT_THAT(mesh.notes, ElementsAre(file.string() + ":7: material library '" +
                                          (folder.path() / "lib/none.mtl").string() +
                                          "' not found; materials defined only there are white",
                                      file.string() + ": no library has the material 'what': it is white"));
  EXPECT_THAT(mesh.material, ElementsAre(-1, 0, 1, 2, 3, 0));
  ASSERT_EQ(mesh.materials.size(), 4u);
  EXPECT_EQ(mesh.materials[0].name, "blue");
  EXPECT_EQ(mesh.materials[0].diffuse, glm::dvec3(0, 0, 1));
  EXPECT_EQ(mesh.materials[1].diffuse, glm::dvec3(1, 0, 0));
  EXPECT_EQ(mesh.materials[2].name, "my green");
  EXPECT_EQ(mesh.materials[2].diffuse, glm::dvec3(0, 1, 0));
  EXPECT_EQ(mesh.materials[3].name, "what");
  EXPECT_EQ(mesh.materials[3].diffuse, glm::dvec3(1.0));
}

// The rounding is half a unit of the last decimal of the coordinates with the most decimals. Weights,
// colours, texture coordinates and normals do not count. 0.5 * 10^-d is the nearest double up to d = 22,
// where 10^d is exact.
TEST(Obj, RoundingIsHalfTheLastDecimal) {
  const auto roundingOf = [](const std::string& coordinates) {
    return meshOf(afterThreeVertices("v " + coordinates + "\nvt 0.12345678\nf 1 2 3\n")).roundingOf(0);
  };
  EXPECT_EQ(roundingOf("1 2 3"), 0.5);
  EXPECT_EQ(roundingOf("1e3 2 3"), 0.5);
  EXPECT_EQ(roundingOf("1.5 2.25 -1.250"), 0.5e-3);
  EXPECT_EQ(roundingOf("1.234567 2 3 0.123456789"), 0.5e-6);
  EXPECT_EQ(roundingOf("1.5e-3 0.1 0.12"), 0.5e-4);
  EXPECT_EQ(roundingOf("0 0 1e-22"), 0.5e-22);
  EXPECT_NEAR(roundingOf("0 0 1e-308") / 0.5e-308, 1.0, 309 * 0x1p-53) << "power.h, and one division";
  EXPECT_EQ(roundingOf("0 0 1e-999999999999"), 0.5) << "it is zero, which tells nothing";
}

// The last corner in every spelling; what else a corner may not be is in stories/malformed.txt.
TEST(Obj, TakesCornersInEverySpelling) {
  const std::string seven = "vt 0\nvt 0\nvt 0\nvt 0\nvt 0\nvt 0\nvt 0\n";
  for (const std::string word : {"3", "+3", "-1", "3/", "3//", "3/7", "3//-7", "3/+7/7"})
    EXPECT_EQ(meshOf(afterThreeVertices(seven + "f 1 2 " + word)).corners.back(), 2) << word;
}

// A file cut off at any byte, or with a few wrong bytes, is either read or reported as wrong. What is read is
// sound.
TEST(Obj, SurvivesWrongBytes) {
  const int readable = survivors(std::string{kWhole}, 5'000, "a.obj",
                                 [](const std::string& text) { expectSound(meshOf(text)); });
  EXPECT_GT(readable, 500);
  EXPECT_LT(readable, 4'500);
}

// A material of a library brings the colour of its highlight and its exponent. -s and -o of its map move the
// texture on its own faces alone, though another material shares their texture coordinates.
TEST(Obj, TakesHighlightsAndScalesOfMaps) {
  const TemporaryFolder folder;
  folder.write("a.mtl",
               "newmtl dull\nKs 0 0 0\nmap_Kd t.png\n"
               "newmtl shiny\nKs 1 0.5 0\nNs 30.4\nmap_Kd -s 2 4 -o 0.25 t.png\n");
  const Mesh mesh = readObj(folder.write(
      "a.obj", afterThreeVertices("usemtl dull\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nusemtl shiny\n"
                                  "f 1/1 2/2 3/3\nf 3 2/2 1/3\nusemtl none\nf 1/1 2/2 3/3\nmtllib a.mtl\n")));
  ASSERT_EQ(mesh.materials.size(), 3u);
  EXPECT_EQ(mesh.materials[0].specular, glm::dvec3(0));
  EXPECT_EQ(mesh.materials[0].n, std::nullopt);
  EXPECT_EQ(mesh.materials[1].specular, glm::dvec3(1, 0.5, 0));
  EXPECT_EQ(mesh.materials[1].n, 30);
  EXPECT_EQ(mesh.materials[2].specular, glm::dvec3(1));
  std::vector<glm::dvec2> uv;
  for (const int c : mesh.uvOfCorner) uv.push_back(c < 0 ? glm::dvec2(-1) : mesh.uv[c]);
  const glm::dvec2 none{-1};
  EXPECT_THAT(uv, ElementsAre(glm::dvec2{0, 0}, glm::dvec2{1, 0}, glm::dvec2{1, 1}, glm::dvec2{0.25, 0},
                              glm::dvec2{2.25, 0}, glm::dvec2{2.25, 4}, none, glm::dvec2{2.25, 0},
                              glm::dvec2{2.25, 4}, glm::dvec2{0, 0}, glm::dvec2{1, 0}, glm::dvec2{1, 1}));
}

/// ---- MTL

// Every newmtl makes a material. Its Kd is the colour, clamped to [0, 1]. The last Kd counts, and the last
// map_Kd.
TEST(Mtl, GivesColorsByName) {
  const MtlLibrary library = parseMtl(
      "# colours\r\nKd 9 9 9\nnewmtl red\r\n\tKa 1 1 1\r\n\tKd 1 .25 0\r\n\tmap_Kd red.png\r\n"
      "newmtl  light  gray\nKd 0.5\nnewmtl plain\nillum 2\nnewmtl loud\nKd 2 -1 1e-400\n"
      "newmtl odd\nKd spectral file.rfl 1\nnewmtl twice\nmap_Kd a\nKd 0 0 0\nKd 0 0 1\nmap_Kd my own.png",
      "a.mtl");
  const std::map<std::string, MtlMaterial, std::less<>> expected{
      {"red", {{1, 0.25, 0}, "red.png", 6}}, {"light gray", {{0.5, 0.5, 0.5}, "", 0}},
      {"plain", {{1, 1, 1}, "", 0}},         {"loud", {{1, 0, 0}, "", 0}},
      {"odd", {{1, 1, 1}, "", 0}},           {"twice", {{0, 0, 1}, "my own.png", 19}}};
  EXPECT_EQ(library.materials, expected);
  EXPECT_EQ(library.notes,
            (std::vector<std::string>{"a.mtl:12: Kd 2 is read as 1: a colour has numbers from 0 to 1",
                                      "a.mtl: the program does not use Ka"}));
  EXPECT_TRUE(parseMtl("", "a.mtl").materials.empty());
}

// Ks and Ns have a place in the equation, and so has a model without a highlight. What leaves the picture as
// it is, is not named.
TEST(Mtl, GivesTheHighlight) {
  const auto read = [](const std::string& lines) { return parseMtl("newmtl m\n" + lines, "a.mtl"); };
  const auto materialOf = [&](const std::string& lines) { return read(lines).materials.at("m"); };
  EXPECT_EQ(materialOf("Kd 1 1 1\n").Ks, std::nullopt);
  EXPECT_EQ(materialOf("Kd 1 1 1\n").Ns, std::nullopt);
  EXPECT_EQ(materialOf("Ks 0.5 2 0\nNs 96.078\nillum 2").Ks, glm::dvec3(0.5, 1, 0));
  EXPECT_EQ(materialOf("Ns 96.078").Ns, 96);
  EXPECT_EQ(materialOf("Ns 1e9").Ns, 1'000'000);
  EXPECT_EQ(materialOf("Ns -1").Ns, 0);
  for (const std::string model : {"0", "1"})
    EXPECT_EQ(materialOf("illum " + model + "\nKs 1 1 1").Ks, glm::dvec3(0)) << model;
  EXPECT_EQ(materialOf("illum 1\nKs 1 1 1\nillum 2").Ks, glm::dvec3(1));
  EXPECT_EQ(materialOf("illum 1\nnewmtl m\nKs 1 1 1").Ks, glm::dvec3(1));
  EXPECT_EQ(read("d 1\nTr 0.0\nKe 0 0 0\nillum 2").notes, std::vector<std::string>{});
  EXPECT_EQ(read("d 0.5\nTr 1\nKe 0 1 0\nillum 4\nNi 1").notes,
            std::vector<std::string>{"a.mtl: the program does not use d, Tr, Ke, illum, Ni"});
}

// -s and -o of map_Kd have one to three numbers; the third is for textures in space.
TEST(Mtl, GivesTheScaleOfAMap) {
  const auto materialOf = [](const std::string& map) {
    return parseMtl("newmtl m\nmap_Kd " + map, "a.mtl").materials.at("m");
  };
  EXPECT_EQ(materialOf("-s 2 3 4 -o 0.5 a.png").scale, glm::dvec2(2, 3));
  EXPECT_EQ(materialOf("-s 2 3 4 -o 0.5 a.png").offset, glm::dvec2(0.5, 0));
  EXPECT_EQ(materialOf("-s -1 a.png").scale, glm::dvec2(-1, 1));
  EXPECT_EQ(materialOf("-s 2 a.png\nmap_Kd a.png").scale, glm::dvec2(1, 1));
}

// The file follows the options, which the manual gives one, two, or up to three words. One note tells of the
// first that would change the picture.
TEST(Mtl, ReadsTheOptionsOfAMap) {
  struct Case {
    std::string line, file, ignored;
  };
  for (const Case& c : std::vector<Case>{
           {"a.png", "a.png", ""},
           {"-blendu on -blendv off -bm 1 -boost 2 -texres 512 -cc off -clamp off a.png", "a.png", ""},
           {"-s 2 a.png", "a.png", ""},
           {"-s 2 2 a.png", "a.png", ""},
           {"-s 2 2 1 a b.png", "a b.png", ""},
           {"-s 2 2 1 7", "7", ""},
           {"-blendu on -o 0.5 .5 -t 1 -s 3 a.png", "a.png", "-t"},
           {"-mm 0.1 0.9 a.png", "a.png", "-mm"},
           {"-clamp on a.png", "a.png", "-clamp"},
           {"-cc on a.png", "a.png", "-cc"},
           {"-imfchan r a.png", "a.png", "-imfchan"},
           {"-own.png", "-own.png", ""},
           {"-2.png", "-2.png", ""}}) {
    const MtlLibrary library = parseMtl("newmtl m\nmap_Kd " + c.line, "a.mtl");
    EXPECT_EQ(library.materials.at("m").map, c.file) << c.line;
    const std::vector<std::string> note{"a.mtl:2: map_Kd is read without " + c.ignored};
    EXPECT_EQ(library.notes, c.ignored.empty() ? std::vector<std::string>{} : note) << c.line;
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
