#include "x11/homework/hand_ins.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/scene/json_text.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRubricBytes = 1 << 16;
constexpr int kMostPoints = 1000;

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool isSame(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

/// True if a file is handed in by its name: a picture of any kind, also of those that cannot be read, an
/// order, or answers; also a folder or a link to nothing of such a name. A text that explains the folder is
/// not.
bool isHandedIn(std::string name) {
  std::ranges::transform(name, name.begin(), lower);
  constexpr std::array<std::string_view, 14> kEnds{".jsonl", ".json", ".png",  ".ppm",  ".pgm",
                                                   ".pnm",   ".xwd",  ".jpg",  ".jpeg", ".gif",
                                                   ".bmp",   ".tif",  ".tiff", ".webp"};
  return std::ranges::any_of(kEnds, [&](std::string_view end) { return name.ends_with(end); });
}

/// The parts of a name that Moodle gives: NAME_NUMBER_assignsubmission_KIND_REST. Without them it is all
/// rest.
struct MoodleName {
  std::string student = {}, number = {}, rest;

  explicit MoodleName(const std::string& name) : rest{name} {
    constexpr std::string_view kMark = "_assignsubmission_";
    const std::size_t mark = name.find(kMark), kind = mark == name.npos ? mark : mark + kMark.size();
    const std::size_t end = kind == name.npos ? kind : name.find('_', kind);
    if (end == name.npos || mark == 0) return;
    const std::size_t digits = name.find_last_not_of("0123456789", mark - 1);
    if (digits == name.npos || digits == 0 || digits == mark - 1 || name[digits] != '_') return;
    student = name.substr(0, digits), number = name.substr(digits + 1, mark - digits - 1);
    rest = name.substr(end + 1);
  }
};

class Finder {
 public:
  explicit Finder(std::string folder) : folder_{std::move(folder)} {}

  HandIns found() {
    std::error_code error;
    for (const fs::directory_entry& entry : entriesOf("", error)) {
      const std::string name = entry.path().filename().string();
      const MoodleName given{name};
      numbers_[given.student].insert(given.number);
      const bool isFolder = goesInto(entry, name);
      HandIn one{.path = name,
                 .student = given.student.empty() && isFolder ? name : given.student,
                 .place = isFolder                ? name + '/'
                          : given.student.empty() ? ""
                                                  : name.substr(0, name.size() - given.rest.size())};
      const std::size_t before = all_.files.size();
      if (isFolder)
        walk(one);
      else
        add(entry, one, given.rest);
      if (isFolder && all_.files.size() == before) all_.files.push_back(one);
      for (std::size_t k = before; k < all_.files.size(); ++k) number_.push_back(given.number);
    }
    if (error) throw std::system_error{error.value(), std::generic_category(), folder_};
    tellApart();
    return std::move(all_);
  }

 private:
  /// Sorted by their names.
  std::vector<fs::directory_entry> entriesOf(const std::string& below, std::error_code& error) const {
    std::vector<fs::directory_entry> all;
    for (fs::directory_iterator at{fs::path{folder_} / below, error}, end; !error && at != end;
         at.increment(error))
      all.push_back(*at);
    std::ranges::sort(all, {}, [](const auto& entry) { return entry.path().string(); });
    return all;
  }
  [[nodiscard]] static bool isHidden(const std::string& name) {
    return name.starts_with('.') || name == "__MACOSX";
  }
  [[nodiscard]] static bool goesInto(const fs::directory_entry& entry, const std::string& name) {
    std::error_code error;
    return !isHidden(name) && !isHandedIn(name) && !entry.is_symlink(error) && entry.is_directory(error);
  }
  void add(const fs::directory_entry& entry, HandIn one, const std::string& name) {
    std::error_code error;
    if (isHidden(name) || isHidden(entry.path().filename().string()))
      all_.passed["hidden file"].push_back(one.path);
    else if (one.name = name; isHandedIn(name))
      all_.files.push_back(std::move(one));
    else
      all_.passed[entry.is_symlink(error) && entry.is_directory(error) ? "linked folder" : "other file"]
          .push_back(one.path);
  }
  void walk(const HandIn& in) {
    std::error_code error;
    for (const fs::directory_entry& entry : entriesOf(in.path, error)) {
      const std::string name = entry.path().filename().string();
      HandIn one = in;
      one.path += '/' + name;
      if (goesInto(entry, name))
        walk(one);
      else
        add(entry, std::move(one), name);
    }
    if (error) all_.passed["unreadable folder"].push_back(in.path);
  }
  /// Two students of one name have their numbers behind it.
  void tellApart() {
    for (std::size_t k = 0; k < all_.files.size(); ++k)
      if (HandIn& one = all_.files[k]; !number_[k].empty() && numbers_[one.student].size() > 1)
        one.student += " (" + number_[k] + ')';
    std::ranges::stable_sort(all_.files, {}, &HandIn::student);
  }

  std::string folder_;
  HandIns all_;
  std::vector<std::string> number_;                       ///< of the student, for each file
  std::map<std::string, std::set<std::string>> numbers_;  ///< by the student's name
};

}  // namespace

HandIns handInsOf(const std::string& folder) { return Finder{folder}.found(); }

std::string sentenceOf(const PassedOver& passed) {
  constexpr std::size_t kMostNamed = 4;
  std::string all;
  for (const auto& [what, files] : passed) {
    all += (all.empty() ? "passed over: " : ", ") + counted(std::ssize(files), what) + " (";
    for (std::size_t k = 0; k < std::min(files.size(), kMostNamed); ++k)
      all += (k > 0 ? ", " : "") + visible(files[k]);
    all += files.size() > kMostNamed ? ", ...)" : ")";
  }
  return all;
}

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

namespace {

constexpr std::size_t kMostAnswerBytes = 1 << 20;

std::string answerLetter(int answer) { return {static_cast<char>('a' + answer)}; }

int readAnswerLetter(const Node& node) {
  const std::string letter = node.text();
  if (letter.size() != 1 || letter[0] < 'a' || letter[0] >= 'a' + kMostAnswers)
    node.fail("a letter from a to d is needed");
  return letter[0] - 'a';
}

}  // namespace

std::vector<AnsweredQuestion> readAnswers(const std::string& file) {
  const JsonText json{readTextFile(file, kMostAnswerBytes), file};
  const Node root = json.root();
  root.expectKeys({"answers"});
  if (!root.has("answers")) root.fail("answers is needed");
  const Node answers = root.at("answers");
  std::vector<AnsweredQuestion> all;
  for (int k = 0; k < answers.size(); ++k) {
    const Node node = answers.item(k);
    node.expectKeys({"lesson", "step", "tries", "right"});
    for (const char* const key : {"lesson", "step", "tries", "right"})
      if (!node.has(key)) node.fail(std::string{key} + " is needed");
    AnsweredQuestion one{.lesson = {}, .tries = {}, .right = readAnswerLetter(node.at("right"))};
    const Node tries = node.at("tries");
    if (tries.size() == 0) tries.fail("an answer is needed");
    for (int i = 0; i < tries.size(); ++i) one.tries.push_back(readAnswerLetter(tries.item(i)));
    one.lesson = node.at("lesson").text();
    one.step = node.at("step").whole(1, kMostSteps);
    all.push_back(std::move(one));
  }
  return all;
}

std::string answersText(const std::vector<AnsweredQuestion>& answers) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const AnsweredQuestion& one : answers) {
    nlohmann::ordered_json tries = nlohmann::ordered_json::array();
    for (const int k : one.tries) tries.push_back(answerLetter(k));
    all.push_back(
        {{"lesson", one.lesson}, {"step", one.step}, {"tries", tries}, {"right", answerLetter(one.right)}});
  }
  return nlohmann::ordered_json{{"answers", all}}.dump(2) + '\n';
}

}  // namespace xnewell
