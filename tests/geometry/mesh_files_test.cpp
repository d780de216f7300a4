#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "geometry/files/bpt.h"
#include "geometry/files/model_file.h"
#include "geometry/files/off.h"
#include "geometry/files/ply.h"
#include "tests/support/ply_text.h"
#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- OFF

using testing::ElementsAre;
using testing::IsEmpty;

Mesh meshOf(std::string_view text) { return parseOff(text, "a.off"); }

/// A triangle and its opposite side's neighbour, with what stands after each point and each face.
std::string twoTriangles(const std::string& first, const std::string& ofPoint, const std::string& ofFace) {
  std::string text = first + "\n4 2 5\n";
  for (const std::string point : {"0 0 0", "1 0 0", "1 1.5 0", "0 1 0"}) text += point + ofPoint + "\n";
  return text + "3 0 1 2" + ofFace + "\n3 0 2 3" + ofFace + "\n";
}

// A worked example: comments and blank lines anywhere, faces of any number of corners, colours of faces as
// whole numbers and as fractions. Equal colours are one material.
TEST(Off, ReadsABitOfEverything) {
  const Mesh mesh = meshOf(
      "# a roof\r\nOFF # here\r\n\r\n5 4 0\r\n0 0 0\r\n1 0 .25\n1 1 0\n0 1 0 # last\n\n0.5 0.5 1\n"
      "4 3 2 1 0 255 0 51\n3 0 1 4 1.0 0 .2 0.5\n# no colour\n3 1 2 4\n5 0 1 2 3 4 7\n");
  EXPECT_EQ(mesh.points.size(), 5u);
  EXPECT_EQ(mesh.points[1], glm::dvec3(1, 0, 0.25));
  EXPECT_THAT(mesh.corners, ElementsAre(3, 2, 1, 0, 0, 1, 4, 1, 2, 4, 0, 1, 2, 3, 4));
  EXPECT_THAT(mesh.firstCorner, ElementsAre(0, 4, 7, 10, 15));
  EXPECT_THAT(mesh.material, ElementsAre(0, 0, -1, -1));
  ASSERT_EQ(mesh.materials.size(), 1u);
  EXPECT_EQ(mesh.materials[0].diffuse, glm::dvec3(1, 0, 0.2));
  EXPECT_THAT(mesh.rounding, ElementsAre(0.5e-2));
  EXPECT_THAT(mesh.notes, ElementsAre("a.off: the program does not use opacities, indices into a colormap"));
}

// The first word says what follows x y z. Texture coordinates are kept; a note names what is not used.
TEST(Off, ReadsWhatTheFirstWordPromises) {
  const std::string colors = "a.off: the program does not use colours of points";
  for (const auto& [first, ofPoint, note] :
       std::vector<std::array<std::string, 3>>{{"OFF", "", ""},
                                               {"COFF", " 255 0 0", colors},
                                               {"COFF", " 255 0 0 255", colors},
                                               {"COFF", " 7", colors},
                                               {"NOFF", " 0 0 2", ""},
                                               {"CNOFF", " 0 0 1 0.5 0.5 0.5 1", colors},
                                               {"STOFF", " 0.25 0.5", ""},
                                               {"STCNOFF", " 0 0 1 1 1 1 1 0.25 0.5", colors}}) {
    const Mesh mesh = meshOf(twoTriangles(first, ofPoint, ""));
    EXPECT_THAT(mesh.corners, ElementsAre(0, 1, 2, 0, 2, 3)) << first;
    EXPECT_EQ(mesh.notes, note.empty() ? std::vector<std::string>{} : std::vector{note}) << first;
    const std::size_t normals = first.find('N') == first.npos ? 0 : mesh.corners.size();
    EXPECT_EQ(mesh.normals, std::vector<glm::dvec3>(normals, {0, 0, 1})) << first;
    if (first.starts_with("ST")) {
      EXPECT_EQ(mesh.uv.at(3), glm::dvec2(0.25, 0.5));
      EXPECT_EQ(mesh.uvOfCorner, mesh.corners);
    } else {
      EXPECT_THAT(mesh.uv, IsEmpty());
    }
  }
}

// Files with the counts behind OFF are common, and so are such without a blank between them.
TEST(Off, TakesCountsOnTheFirstLine) {
  for (const std::string first : {"OFF\n3 1 0", "OFF 3 1 0", "OFF3 1", "OFF 3 1"})
    EXPECT_EQ(meshOf(first + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").faceCount(), 1) << first;
}

// Faces of one or two corners are points and edges in some files. They are left out, with one note.
TEST(Off, LeavesOutPointsAndEdges) {
  const Mesh mesh = meshOf("OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 2\n0\n");
  EXPECT_EQ(mesh.faceCount(), 1);
  EXPECT_THAT(mesh.notes, ElementsAre("a.off: 3 faces have fewer than three corners: they are left out"));
}

// Up to 256 colours of faces are materials. A file with more is shown in white, and a note says so.
TEST(Off, KeepsTheColorsOfParts) {
  for (const int colors : {256, 257}) {
    std::string text = "OFF\n3 300 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (int f = 0; f < 300; ++f)
      text += "3 0 1 2 " + std::to_string(f % colors % 256) + " 0 " + std::to_string(f % colors / 256) + "\n";
    const Mesh mesh = meshOf(text);
    EXPECT_EQ(mesh.materials.size(), colors == 256 ? 256u : 0u);
    EXPECT_EQ(mesh.material[299], colors == 256 ? 43 : -1);
    EXPECT_EQ(mesh.notes.size(), colors == 256 ? 0u : 1u);
  }
}

// A file cut off at any byte, or with a few wrong bytes, is either read or reported as wrong, with its name.
TEST(Off, SurvivesWrongBytes) {
  const std::string whole = twoTriangles("STCOFF", " 1 0 0 1 0.25 0.5", " 0.5 0.5 0.5");
  const auto read = [](const std::string& text) {
    const Mesh mesh = meshOf(text);
    for (const int corner : mesh.corners) EXPECT_LT(corner, std::ssize(mesh.points));
  };
  EXPECT_GT(survivors(whole, 20'000, "a.off", read), 1'000);
}

/// ---- PLY

Mesh plyOf(std::string_view text) { return parsePly(text, "a.ply"); }

/// A square and a triangle, with a colour for each face and each vertex.
const PlyText kPair{.declared =
                        "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                        "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\n"
                        "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                    .values = {{'f', 0}, {'f', 0}, {'f', -1.5}, {'B', 9}, {'f', 1},   {'f', 0}, {'f', 0},
                               {'B', 9}, {'f', 1}, {'f', 1},    {'f', 0}, {'B', 9},   {'f', 0}, {'f', 1},
                               {'f', 0}, {'B', 9}, {'f', 3},    {'f', 4}, {'f', 0},   {'B', 9}, {'B', 4},
                               {'i', 0}, {'i', 1}, {'i', 2},    {'i', 3}, {'B', 255}, {'B', 0}, {'B', 51},
                               {'B', 3}, {'i', 4}, {'i', 0},    {'i', 2}, {'B', 255}, {'B', 0}, {'B', 51}},
                    .perLine = {4, 4, 4, 4, 4, 8, 7}};

// The three forms of one model are one mesh. Whole numbers and floats keep their bits.
TEST(Ply, ReadsTheThreeFormsAlike) {
  for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian})
    for (const char* const lineEnd : {"\n", "\r\n", "\r"}) {
      SCOPED_TRACE(static_cast<int>(form));
      const Mesh mesh = plyOf(kPair.as(form, lineEnd));
      EXPECT_THAT(mesh.points, ElementsAre(glm::dvec3(0, 0, -1.5), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0),
                                           glm::dvec3(0, 1, 0), glm::dvec3(3, 4, 0)));
      EXPECT_THAT(mesh.corners, ElementsAre(0, 1, 2, 3, 4, 0, 2));
      EXPECT_THAT(mesh.material, ElementsAre(0, 0));
      ASSERT_EQ(mesh.materials.size(), 1u);
      EXPECT_EQ(mesh.materials[0].diffuse, glm::dvec3(1, 0, 0.2));
      EXPECT_THAT(mesh.groupNames, ElementsAre("default"));
      EXPECT_THAT(mesh.notes, ElementsAre("a.ply: the program does not use vertex.red"));
      // 4 < 8 = 2^3, so half a unit of single precision is 2^(3 - 25); the text has one decimal.
      EXPECT_THAT(mesh.rounding, ElementsAre(form == PlyForm::Text ? 0.05 : 0x1p-22));
    }
}

// Every type of number, by either name, is read with its sign in both byte orders.
TEST(Ply, ReadsEveryType) {
  struct Case {
    const char *name, *other;
    char type;
    double value, rounding;
  };
  for (const Case& c : {Case{"char", "int8", 'b', -100, 0.5}, Case{"uchar", "uint8", 'B', 200, 0.5},
                        Case{"short", "int16", 's', -30'000, 0.5}, Case{"ushort", "uint16", 'S', 60'000, 0.5},
                        Case{"int", "int32", 'i', -2e9, 0.5}, Case{"uint", "uint32", 'I', 4e9, 0.5},
                        Case{"float", "float32", 'f', -0x1.8p-100, 0x1p-124},
                        Case{"double", "float64", 'd', -0x1.23456789p-300, 0}})
    for (const std::string type : {c.name, c.other})
      for (const PlyForm form : {PlyForm::LittleEndian, PlyForm::BigEndian}) {
        PlyText ply{.declared = "element face 1\nproperty list int uint vertex_index\nelement vertex 3\n",
                    .values = {{'i', 3}, {'I', 0}, {'I', 1}, {'I', 2}},
                    .perLine = {}};
        for (const char axis : {'x', 'y', 'z'}) ply.declared += "property " + type + ' ' + axis + '\n';
        for (int i = 0; i < 9; ++i) ply.values.push_back({c.type, i == 4 ? c.value : 0.0});
        const Mesh mesh = plyOf(ply.as(form));
        EXPECT_EQ(mesh.points.at(1), glm::dvec3(0, c.value, 0)) << type;
        EXPECT_EQ(mesh.rounding.at(0), c.rounding) << type;
      }
}

// What is not used is passed over, lists too, and named once; a number that is not used need not be finite.
TEST(Ply, PassesOverTheRest) {
  const PlyText ply{
      .declared =
          "comment made by hand \\\nobj_info none\nelement edge 1\nproperty list uchar short ends\n"
          "element vertex 3\nproperty float nx\nproperty float x\nproperty float s\n"
          "property float y\nproperty float t\nproperty float z\n"
          "property list uchar float more\nelement face 2\n"
          "property list uchar uchar vertex_indices\nproperty int flags\n",
      .values = {{'B', 2}, {'s', 5}, {'s', 6}, {'f', NAN}, {'f', 0}, {'f', 0.25}, {'f', 0},
                 {'f', 0}, {'f', 0}, {'B', 0}, {'f', 1},   {'f', 1}, {'f', 0.5},  {'f', 0},
                 {'f', 0}, {'f', 0}, {'B', 1}, {'f', 8},   {'f', 1}, {'f', 0},    {'f', 0},
                 {'f', 1}, {'f', 1}, {'f', 0}, {'B', 0},   {'B', 2}, {'B', 0},    {'B', 1},
                 {'i', 3}, {'B', 3}, {'B', 0}, {'B', 1},   {'B', 2}, {'i', 3}},
      .perLine = {3, 7, 8, 7, 4, 5}};
  for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian}) {
    const Mesh mesh = plyOf(ply.as(form));
    EXPECT_THAT(mesh.corners, ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.uv, ElementsAre(glm::dvec2(0.25, 0), glm::dvec2(0.5, 0), glm::dvec2(0, 1)));
    EXPECT_EQ(mesh.uvOfCorner, mesh.corners);
    EXPECT_THAT(mesh.notes,
                ElementsAre("a.ply: 1 face has fewer than three corners: it is left out",
                            "a.ply: the program does not use edge, vertex.nx, vertex.more, face.flags"));
  }
}

// Each vertex of a strip makes a triangle with the two before it; those of one strip turn the same way. -1
// ends a strip, and two equal corners make no triangle.
TEST(Ply, ReadsStripsOfTriangles) {
  PlyText ply{.declared =
                  "element vertex 5\nproperty int x\nproperty int y\nproperty int z\n"
                  "element tristrips 1\nproperty list int int vertex_indices\n",
              .values = {},
              .perLine = {3, 3, 3, 3, 3, 11}};
  for (int i = 0; i < 15; ++i) ply.values.push_back({'i', double(i % 4)});
  for (const int v : {10, 0, 1, 2, 3, 3, 4, -1, 4, 1, 0}) ply.values.push_back({'i', double(v)});
  for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian})
    EXPECT_THAT(plyOf(ply.as(form)).corners, ElementsAre(0, 1, 2, 2, 1, 3, 4, 1, 0));
}

// Normals of vertices become those of the corners.
TEST(Ply, ReadsNormals) {
  PlyText ply{.declared = "element vertex 3\n", .values = {}, .perLine = {6, 6, 6, 4}};
  for (const char* const name : {"x", "y", "z", "nx", "ny", "nz"})
    ply.declared += "property float " + std::string{name} + '\n';
  ply.declared += "element face 1\nproperty list uchar int vertex_indices\n";
  for (const double v : {0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 3, 0, 0, 1, 0, 0, 0, 0})
    ply.values.push_back({'f', v});
  ply.values[17].value = NAN;
  ply.values.insert(ply.values.end(), {{'B', 3}, {'i', 2}, {'i', 0}, {'i', 1}});
  for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian})
    EXPECT_THAT(plyOf(ply.as(form)).normals,
                ElementsAre(glm::dvec3{0.0}, glm::dvec3{0, 0, 1}, glm::dvec3{0, 1, 0}));
}

// A file cut off at any byte, or with a few wrong bytes, is either read or reported as wrong, with its name.
// It takes no more memory than the file has bytes for, whatever the header promises.
TEST(Ply, SurvivesWrongBytes) {
  const auto read = [](const std::string& text) {
    const Mesh mesh = plyOf(text);
    for (const int corner : mesh.corners) EXPECT_LT(corner, std::ssize(mesh.points));
    for (const glm::dvec3& p : mesh.points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  };
  for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian})
    EXPECT_GT(survivors(kPair.as(form), 10'000, "a.ply", read), 200);
}

// One table says which files are models.
TEST(ModelFile, GoesByTheExtension) {
  EXPECT_EQ(modelFile("a/b.PLY"), &kModelFiles[1]);
  EXPECT_EQ(modelFile("ply"), nullptr);
  EXPECT_EQ(modelFile("a.ply/b"), nullptr);
  EXPECT_EQ(modelExtensions(), ".obj, .ply, .off, .bpt");
}

/// ---- BPT

/// Patches of random doubles, and their text, in which every number identifies its double.
std::vector<BezierPatch> randomPatches(int count, std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform{-4.0, 4.0};
  std::vector<BezierPatch> patches(count);
  for (BezierPatch& patch : patches) {
    for (glm::dvec3& p : patch.p) p = {uniform(rng), uniform(rng), uniform(rng) * 1e-9};
  }
  return patches;
}

std::string toText(const std::vector<BezierPatch>& patches) {
  std::string text = std::to_string(patches.size()) + "\n";
  for (const BezierPatch& patch : patches) {
    text += "3 3\n";
    for (const glm::dvec3& p : patch.p) {
      char line[100];
      std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
      text += line;
    }
  }
  return text;
}

std::string complaintOf(const std::string& text) {
  return complaint([&] { return parseBpt(text, "teapot.bpt"); });
}

// Numbers written with 17 digits are read bit for bit. The points come row by row, in file order.
TEST(Bpt, ReturnsTheDoublesThatWereWritten) {
  std::mt19937 rng{1975};
  const std::vector<BezierPatch> written = randomPatches(32, rng);
  const std::vector<BezierPatch> read = parseBpt(toText(written), "teapot.bpt");
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i].p, written[i].p) << i;
  const TemporaryFolder folder;
  EXPECT_EQ(readBpt(folder.write("teapot.bpt", toText(written))).back().p, written.back().p);
}

// The file must hold exactly the number of patches that it states. A large number alone allocates no memory.
TEST(Bpt, RefusesNumbersOfPatchesItCannotTrust) {
  EXPECT_EQ(complaintOf(""), "teapot.bpt: holds no patch");
  EXPECT_EQ(complaintOf("# nothing\n\n"), "teapot.bpt: holds no patch");
  EXPECT_EQ(complaintOf("#\nx\n"), "teapot.bpt:2: malformed number of patches 'x'");
  EXPECT_EQ(complaintOf("1.5\n"), "teapot.bpt:1: malformed number of patches '1.5'");
  for (const std::string count : {"0", "-1", "1000001", "4000000000", "99999999999999999999"}) {
    EXPECT_EQ(complaintOf(count + "\n3 3\n"),
              "teapot.bpt:1: number of patches '" + count + "' is not within 1 to 1000000");
  }
  EXPECT_EQ(complaintOf("1000000\n"), "teapot.bpt:1: the file ends before patch 1 of 1000000");
  EXPECT_EQ(complaintOf("1 2\n"), "teapot.bpt:1: unexpected '2'");
}

// A file cut off at any byte is an error, unless the cut only shortens the last number.
TEST(Bpt, NoticesEveryTruncation) {
  std::mt19937 rng{1972};
  const std::string whole = toText(randomPatches(2, rng));
  const std::size_t lastNumber = whole.find_last_of(' ') + 1;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const std::string what = complaintOf(whole.substr(0, size));
    EXPECT_TRUE(size > lastNumber || what.starts_with("teapot.bpt:")) << size;
  }
  EXPECT_EQ(complaintOf(whole), "");
}

// A file with a few wrong bytes is either read or reported as wrong. What is read is finite.
TEST(Bpt, SurvivesMutation) {
  std::mt19937 rng{7};
  const auto read = [](const std::string& text) {
    for (const BezierPatch& patch : parseBpt(text, "teapot.bpt"))
      for (const glm::dvec3& p : patch.p) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  };
  const int readable = survivors(toText(randomPatches(2, rng)), 7'000, "teapot.bpt", read);
  EXPECT_GT(readable, 500);
  EXPECT_LT(readable, 6'500);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
