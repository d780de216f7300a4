#include "geometry/files/mtl.h"

#include <gtest/gtest.h>

#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

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
  EXPECT_EQ(library.notes, std::vector<std::string>{"a.mtl: the program does not use Ka, illum"});
  EXPECT_TRUE(parseMtl("", "a.mtl").materials.empty());
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
           {"-s 2 a.png", "a.png", "-s"},
           {"-s 2 2 a.png", "a.png", "-s"},
           {"-s 2 2 1 a b.png", "a b.png", "-s"},
           {"-s 2 2 1 7", "7", "-s"},
           {"-blendu on -o 0.5 .5 -t 1 -s 3 a.png", "a.png", "-o"},
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
  const auto complaintOf = [](const std::string& line) {
    return complaint([&] { return parseMtl("newmtl m\n" + line, "a.mtl"); });
  };
  EXPECT_EQ(complaintOf("map_Kd"), "a.mtl:2: map_Kd needs a file");
  EXPECT_EQ(complaintOf("map_Kd -clamp on"), "a.mtl:2: map_Kd needs a file");
  EXPECT_EQ(complaintOf("map_Kd -clamp"), "a.mtl:2: map_Kd: nothing follows -clamp");
  EXPECT_EQ(complaintOf("map_Kd -mm 1"), "a.mtl:2: map_Kd: nothing follows -mm");
}

TEST(Mtl, RefusesColorsThatAreNoNumbers) {
  const auto complaintOf = [](const std::string& text) {
    return complaint([&] { return parseMtl(text, "a.mtl"); });
  };
  EXPECT_EQ(complaintOf("newmtl a\nKd 1 x 0\n"), "a.mtl:2: malformed number 'x'");
  EXPECT_EQ(complaintOf("newmtl a\nKd nan 0 0\n"), "a.mtl:2: number 'nan' is not finite");
  EXPECT_EQ(complaintOf("newmtl a\nKd\n"), "a.mtl:2: Kd needs a colour");
}

}  // namespace xnewell::THIS_FILE
