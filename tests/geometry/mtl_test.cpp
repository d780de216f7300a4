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
  EXPECT_EQ(complaintOf("newmtl a\nKs\n"), "a.mtl:2: Ks needs a colour");
  EXPECT_EQ(complaintOf("newmtl a\nNs\n"), "a.mtl:2: Ns needs a number");
  EXPECT_EQ(complaintOf("newmtl a\nNs high\n"), "a.mtl:2: malformed number 'high'");
  EXPECT_EQ(complaintOf("newmtl a\nmap_Kd -s a.png\n"), "a.mtl:2: malformed number 'a.png'");
}

// A colour beyond 1 is cut off, with a note at its line.
TEST(Mtl, NotesColorsBeyondOne) {
  const MtlLibrary library = parseMtl("newmtl a\nKd 80\nKs 0 0 2\n", "a.mtl");
  ASSERT_EQ(library.notes.size(), 1u);
  EXPECT_EQ(library.notes.front(), "a.mtl:2: Kd 80 is read as 1: a colour has numbers from 0 to 1");
}

}  // namespace xnewell::THIS_FILE
