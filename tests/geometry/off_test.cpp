#include "geometry/files/off.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

Mesh meshOf(std::string_view text) { return parseOff(text, "a.off"); }

/// A triangle and its opposite side's neighbour, with what stands after each point and each face.
std::string twoTriangles(const std::string& first, const std::string& ofPoint, const std::string& ofFace) {
  std::string text = first + "\n4 2 5\n";
  for (const std::string point : {"0 0 0", "1 0 0", "1 1.5 0", "0 1 0"}) text += point + ofPoint + "\n";
  return text + "3 0 1 2" + ofFace + "\n3 0 2 3" + ofFace + "\n";
}

}  // namespace

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
  std::mt19937 rng{7};
  int read = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string text = i <= std::ssize(whole) ? whole.substr(0, i) : mutated(whole, rng);
    const std::string what = complaint([&] {
      const Mesh mesh = meshOf(text);
      for (const int corner : mesh.corners) EXPECT_LT(corner, std::ssize(mesh.points));
      return ++read;
    });
    EXPECT_TRUE(what.empty() || what.starts_with("a.off:")) << what;
  }
  EXPECT_GT(read, 1'000);
}

}  // namespace xnewell::THIS_FILE
