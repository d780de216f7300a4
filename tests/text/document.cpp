#include "tests/text/document.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace xnewell {

namespace {

std::string onOneLine(const std::string& text) { return std::regex_replace(text, std::regex{R"(\s+)"}, " "); }

/// The words with each {} replaced by the next of these.
std::string filled(std::string_view words, const std::vector<std::string>& by) {
  std::string text;
  std::size_t k = 0;
  for (std::size_t at; (at = words.find("{}")) != std::string_view::npos; words.remove_prefix(at + 2))
    text += std::string{words.substr(0, at)} + by.at(k++);
  EXPECT_EQ(k, by.size()) << "a number without a {}";
  return text + std::string{words};
}

}  // namespace

std::string documentOf(const std::string& path) {
  std::ifstream in{std::filesystem::path{XNEWELL_DATA_DIR}.parent_path() / path};
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>{in}, {}};
}

std::vector<std::string> linesOf(const std::string& document, std::string_view heading) {
  std::vector<std::string> lines;
  bool below = false;
  std::istringstream in{document};
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) below = line == heading;
    if (below && line != heading) lines.push_back(line);
  }
  EXPECT_FALSE(lines.empty()) << heading;
  return lines;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  if (!line.starts_with('|')) return cells;
  std::istringstream in{line.substr(1)};
  for (std::string cell; std::getline(in, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

testing::AssertionResult says(const std::string& path, std::string_view words,
                              const std::vector<std::string>& numbers) {
  const std::string text = onOneLine(documentOf(path)), right = filled(words, numbers);
  std::string pattern = std::regex_replace(std::string{words}, std::regex{R"([.*+?^$|()\[\]\\])"}, R"(\$&)");
  pattern = std::regex_replace(pattern, std::regex{R"(\{\})"}, "[-0-9.,]*[0-9]");
  const std::regex wanted{pattern};
  int found = 0;
  for (std::sregex_iterator at{text.begin(), text.end(), wanted}, end; at != end; ++at, ++found)
    if (at->str() != right)
      return testing::AssertionFailure() << path << " says\n  " << at->str() << "\nbut it is\n  " << right;
  if (found == 1) return testing::AssertionSuccess();
  return testing::AssertionFailure() << path << " has these words " << found << " times, not once:\n  "
                                     << right;
}

std::string number(long long value) {
  std::string text = std::to_string(value);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(at, ",");
  return text;
}

std::string number(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

}  // namespace xnewell
