#include "geometry/files/mtl.h"

#include <gtest/gtest.h>

#include "tests/support/reader_fixture.h"

namespace xnewell {

// Every newmtl makes a material. Its Kd is the colour, clamped to [0, 1]. The last Kd counts.
TEST(Mtl, GivesColorsByName) {
  const MaterialColors colors = parseMtl(
      "# colours\r\nKd 9 9 9\nnewmtl red\r\n\tKa 1 1 1\r\n\tKd 1 .25 0\r\n\tmap_Kd red.png\r\n"
      "newmtl  light  gray\nKd 0.5\nnewmtl plain\nillum 2\nnewmtl loud\nKd 2 -1 1e-400\n"
      "newmtl odd\nKd spectral file.rfl 1\nnewmtl twice\nKd 0 0 0\nKd 0 0 1",
      "a.mtl");
  const MaterialColors expected{{"red", {1, 0.25, 0}}, {"light gray", {0.5, 0.5, 0.5}},
                                {"plain", {1, 1, 1}},  {"loud", {1, 0, 0}},
                                {"odd", {1, 1, 1}},    {"twice", {0, 0, 1}}};
  EXPECT_EQ(colors, expected);
  EXPECT_TRUE(parseMtl("", "a.mtl").empty());
}

TEST(Mtl, RefusesColorsThatAreNoNumbers) {
  const auto complaintOf = [](const std::string& text) {
    return complaint([&] { return parseMtl(text, "a.mtl"); });
  };
  EXPECT_EQ(complaintOf("newmtl a\nKd 1 x 0\n"), "a.mtl:2: malformed number 'x'");
  EXPECT_EQ(complaintOf("newmtl a\nKd nan 0 0\n"), "a.mtl:2: number 'nan' is not finite");
  EXPECT_EQ(complaintOf("newmtl a\nKd\n"), "a.mtl:2: Kd needs a colour");
}

}  // namespace xnewell
