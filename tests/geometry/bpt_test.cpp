#include "geometry/files/bpt.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

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

/// One patch whose point i is (i, 0, -i). The text has 18 lines, with the points on lines 3 to 18.
std::string onePatch() {
  std::string text = "1\n3 3\n";
  for (int i = 0; i < 16; ++i) text += std::to_string(i) + " 0 -" + std::to_string(i) + "\n";
  return text;
}

/// onePatch() with line `number` replaced.
std::string withLine(int number, const std::string& line) {
  std::string text = onePatch();
  std::size_t begin = 0;
  for (int i = 1; i < number; ++i) begin = text.find('\n', begin) + 1;
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

std::string complaintOf(const std::string& text) {
  return complaint([&] { return parseBpt(text, "teapot.bpt"); });
}

}  // namespace

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

// Comments, blank lines, blanks, CR LF and a missing end of the last line change nothing.
TEST(Bpt, IgnoresCommentsAndBlanks) {
  std::string text = "# the teapot\r\n\r\n  1 # patches\r\n\t3\t3 #degrees\r\n";
  for (int i = 0; i < 16; ++i) {
    const std::string number = std::to_string(i);
    text += " " + number + "\t+0. -" + number + "e0 # p\r\n\n";
  }
  text += "# end";
  EXPECT_EQ(parseBpt(text, "teapot.bpt").at(0).p, parseBpt(onePatch(), "teapot.bpt").at(0).p);
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

// An incomplete patch is reported by its number, at the last line of the file.
TEST(Bpt, NamesThePatchThatIsIncomplete) {
  std::mt19937 rng{24};
  const std::string whole = toText(randomPatches(32, rng));
  const auto lines = [&](int count) {
    std::size_t end = 0;
    for (int i = 0; i < count; ++i) end = whole.find('\n', end) + 1;
    return whole.substr(0, end);
  };
  EXPECT_EQ(complaintOf(lines(1 + 23 * 17 + 10)), "teapot.bpt:402: the file ends inside patch 24 of 32");
  EXPECT_EQ(complaintOf(lines(1 + 23 * 17)), "teapot.bpt:392: the file ends before patch 24 of 32");
  EXPECT_EQ(complaintOf(lines(1 + 32 * 17)), "");
}

TEST(Bpt, RefusesWhatIsNotACubicPatch) {
  EXPECT_EQ(complaintOf(withLine(2, "3 2")),
            "teapot.bpt:2: degrees '3' and '2'; a patch here is bicubic, 3 3");
  EXPECT_EQ(complaintOf(withLine(2, "2 3")),
            "teapot.bpt:2: degrees '2' and '3'; a patch here is bicubic, 3 3");
  EXPECT_EQ(complaintOf(withLine(2, "3")), "teapot.bpt:2: degrees '3' and ''; a patch here is bicubic, 3 3");
  EXPECT_EQ(complaintOf(withLine(2, "3 3 3")), "teapot.bpt:2: unexpected '3'");
}

TEST(Bpt, RefusesMalformedPointsAndRubbish) {
  EXPECT_EQ(complaintOf(withLine(7, "1 2")), "teapot.bpt:7: a control point needs three coordinates");
  EXPECT_EQ(complaintOf(withLine(7, "1")), "teapot.bpt:7: a control point needs three coordinates");
  EXPECT_EQ(complaintOf(withLine(7, "1 2 3 4")), "teapot.bpt:7: unexpected '4'");
  EXPECT_EQ(complaintOf(withLine(18, "1 2 z")), "teapot.bpt:18: malformed number 'z'");
  EXPECT_EQ(complaintOf(withLine(3, "nan 2 3")), "teapot.bpt:3: number 'nan' is not finite");
  EXPECT_EQ(complaintOf(withLine(3, "1 -inf 3")), "teapot.bpt:3: number '-inf' is not finite");
  EXPECT_EQ(complaintOf(withLine(3, "1 2 1e999")), "teapot.bpt:3: number '1e999' is too large");
  EXPECT_EQ(complaintOf(onePatch() + "\n# more\n3 3\n"),
            "teapot.bpt:21: unexpected '3' after the last patch");
}

TEST(Bpt, SaysWhatTheSystemSays) {
  EXPECT_EQ(complaint([] { return readBpt("none/teapot.bpt"); }),
            "none/teapot.bpt: No such file or directory");
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
  std::mt19937 patches{7};
  const std::string whole = toText(randomPatches(2, patches));
  int readable = 0;
  for (unsigned seed = 0; seed < 5'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const std::string text = mutated(whole, rng);
    if (!complaintOf(text).empty()) continue;
    ++readable;
    for (const BezierPatch& patch : parseBpt(text, "teapot.bpt")) {
      for (const glm::dvec3& p : patch.p) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
  }
  EXPECT_GT(readable, 500);
  EXPECT_LT(readable, 4'500);
}

}  // namespace xnewell::THIS_FILE
