#include "geometry/files/ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "geometry/files/model_file.h"
#include "tests/support/ply_text.h"
#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

Mesh meshOf(std::string_view text) { return parsePly(text, "a.ply"); }

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

}  // namespace

// The three forms of one model are one mesh. Whole numbers and floats keep their bits.
TEST(Ply, ReadsTheThreeFormsAlike) {
  for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian})
    for (const char* const lineEnd : {"\n", "\r\n", "\r"}) {
      SCOPED_TRACE(static_cast<int>(form));
      const Mesh mesh = meshOf(kPair.as(form, lineEnd));
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
        const Mesh mesh = meshOf(ply.as(form));
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
    const Mesh mesh = meshOf(ply.as(form));
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
    EXPECT_THAT(meshOf(ply.as(form)).corners, ElementsAre(0, 1, 2, 2, 1, 3, 4, 1, 0));
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
    EXPECT_THAT(meshOf(ply.as(form)).normals,
                ElementsAre(glm::dvec3{0.0}, glm::dvec3{0, 0, 1}, glm::dvec3{0, 1, 0}));
}

// A file cut off at any byte, or with a few wrong bytes, is either read or reported as wrong, with its name.
// It takes no more memory than the file has bytes for, whatever the header promises.
TEST(Ply, SurvivesWrongBytes) {
  std::mt19937 rng{7};
  for (const PlyForm form : {PlyForm::Text, PlyForm::LittleEndian, PlyForm::BigEndian}) {
    const std::string whole = kPair.as(form);
    int read = 0;
    for (int i = 0; i < 10'000; ++i) {
      const std::string text = i < std::ssize(whole) ? whole.substr(0, i) : mutated(whole, rng);
      const std::string what = complaint([&] {
        const Mesh mesh = meshOf(text);
        for (const int corner : mesh.corners) EXPECT_LT(corner, std::ssize(mesh.points));
        for (const glm::dvec3& p : mesh.points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
        return i < std::ssize(whole) ? 0 : ++read;
      });
      EXPECT_TRUE(what.empty() || what.starts_with("a.ply:")) << what;
    }
    EXPECT_GT(read, 200);
  }
}

// One table says which files are models.
TEST(ModelFile, GoesByTheExtension) {
  EXPECT_EQ(modelFile("a/b.PLY"), &kModelFiles[1]);
  EXPECT_EQ(modelFile("ply"), nullptr);
  EXPECT_EQ(modelFile("a.ply/b"), nullptr);
  EXPECT_EQ(modelExtensions(), ".obj, .ply, .off, .bpt");
}

}  // namespace xnewell::THIS_FILE
