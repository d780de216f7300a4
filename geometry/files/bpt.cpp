#include "geometry/files/bpt.h"

#include <charconv>

#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

int toPatchCount(const Words& words, std::string_view word) {
  int count = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, count);
  if (stop != end || error == std::errc::invalid_argument) {
    words.fail("malformed number of patches " + inQuotes(word));
  }
  if (error != std::errc{} || count < 1 || count > kMaxPatches) {
    words.fail("number of patches " + inQuotes(word) + " is not within 1 to " + std::to_string(kMaxPatches));
  }
  return count;
}

/// Reads the rest of a patch. `word` is the first word of its line of degrees.
BezierPatch parsePatch(Words& words, std::string_view word, const std::string& which) {
  const std::string_view second = words.next();
  if (word != "3" || second != "3") {
    words.fail("degrees " + inQuotes(word) + " and " + inQuotes(second) + "; a patch here is bicubic, 3 3");
  }
  words.expectEndOfLine();

  BezierPatch patch;
  for (glm::dvec3& point : patch.p) {
    word = words.firstOfNextLine();
    if (word.empty()) words.fail("the file ends inside " + which);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) word = words.next();
      if (word.empty()) words.fail("a control point needs three coordinates");
      point[axis] = toNumber(words, word);
    }
    words.expectEndOfLine();
  }
  return patch;
}

}  // namespace

std::vector<BezierPatch> parseBpt(std::string_view text, const std::string& name) {
  Words words{text, name};
  const std::string_view first = words.firstOfNextLine();
  if (first.empty()) words.fail(0, "holds no patch");
  const int count = toPatchCount(words, first);
  words.expectEndOfLine();

  std::vector<BezierPatch> patches;
  for (int number = 1; number <= count; ++number) {
    const std::string which = "patch " + std::to_string(number) + " of " + std::to_string(count);
    const std::string_view word = words.firstOfNextLine();
    if (word.empty()) words.fail("the file ends before " + which);
    patches.push_back(parsePatch(words, word, which));
  }
  if (const std::string_view word = words.firstOfNextLine(); !word.empty()) {
    words.fail("unexpected " + inQuotes(word) + " after the last patch");
  }
  return patches;
}

std::vector<BezierPatch> readBpt(const std::filesystem::path& file) {
  return parseBpt(readTextFile(file), file.string());
}

}  // namespace xnewell
