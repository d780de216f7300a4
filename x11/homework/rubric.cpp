#include "x11/homework/rubric.h"

#include <algorithm>
#include <charconv>

#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

constexpr std::size_t kMostRubricBytes = 1 << 16;
constexpr int kMostPoints = 1000;

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool isSame(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::vector<Stage> readRubric(const std::string& file) {
  const std::string text = readTextFile(file, kMostRubricBytes);
  Words words{text, file};
  std::vector<Stage> stages;
  for (std::string_view name; !(name = words.firstOfNextLine()).empty();) {
    Stage stage{.name = std::string{name}, .line = words.line()};
    if (name.find_first_of("./\\") != name.npos)
      words.fail(inQuotes(name) + ": a stage is the name of its file without the ending, such as flat");
    const std::string_view points = words.next();
    if (points.empty()) words.fail("a stage and its points are needed, such as `flat 3`");
    const auto [end, error] = std::from_chars(points.begin(), points.end(), stage.points);
    if (error != std::errc{} || end != points.end() || stage.points < 1 || stage.points > kMostPoints)
      words.fail(inQuotes(points) + ": points are a whole number from 1 to " + std::to_string(kMostPoints));
    for (std::string_view word; !(word = words.next()).empty();) stage.words.emplace_back(word);
    if (std::ranges::any_of(stages, [&](const Stage& other) { return isSame(other.name, name); }))
      words.fail("stage " + inQuotes(name) + " comes twice");
    stages.push_back(std::move(stage));
  }
  if (stages.empty()) words.fail("no line names a stage");
  return stages;
}

bool isOf(const Stage& stage, std::string_view file) {
  return stage.name.empty() || isSame(stage.name, file.substr(0, file.rfind('.')));
}

}  // namespace xnewell
