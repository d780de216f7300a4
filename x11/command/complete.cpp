#include "x11/command/commands.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "geometry/files/model_file.h"
#include "x11/lessons/lesson.h"
#include "x11/options/option_rows.h"
#include "x11/options/options.h"

namespace xnewell {

namespace {

namespace fs = std::filesystem;

/// The first clause of a description.
std::string brief(std::string_view does) {
  std::size_t end = does.size();
  for (const std::string_view stop : {"; ", ". ", ": ", " ["}) end = std::min(end, does.find(stop));
  const std::string clause{does.substr(0, end)};
  // "trade: only these short cuts": the clause is only the name of a command.
  const bool command = std::ranges::any_of(
      kCommands, [&](const CommandRow& row) { return clause.substr(0, clause.find(',')) == row.name; });
  return command && end + 2 < does.size() ? clause + ": " + brief(does.substr(end + 2)) : clause;
}

class Proposals {
 public:
  explicit Proposals(std::string typed) : typed_{std::move(typed)} {}

  void add(const std::string& word, std::string_view does = {}) {
    if (word.starts_with(typed_)) text_ += before_ + word + (does.empty() ? "" : '\t' + brief(does)) + '\n';
  }
  void addScenes() {
    for (const BuiltInScene& scene : builtInScenes()) add(scene.name, scene.shows);
    addFiles(kSceneFiles);
  }
  /// Folders, and files whose names end with one of these; without `ends` all.
  void addFiles(std::span<const std::string_view> ends, bool folders = false) {
    const std::string folder = typed_.substr(0, typed_.rfind('/') + 1), start = typed_.substr(folder.size());
    const char* const home = std::getenv("HOME");
    fs::path from = folder.empty() ? "." : folder;
    if (folder.starts_with("~/") && home != nullptr) from = home + folder.substr(1);
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at{from, error}, end; !error && at != end; at.increment(error)) {
      const std::string name = at->path().filename().string();
      std::error_code none;
      if (name.starts_with('.') && !start.starts_with('.')) continue;
      if (at->is_directory(none))
        names.push_back(folder + name + '/');
      else if (!folders && (ends.empty() || std::ranges::find(ends, extensionOf(name)) != ends.end()))
        names.push_back(folder + name);
    }
    std::ranges::sort(names);
    for (const std::string& name : names) add(name);
  }
  void addValues(const OptionRow& row) {
    for (const std::string& word : row.words) add(word);
    if (row.takes == Takes::File || row.takes == Takes::Folder) addFiles({}, row.takes == Takes::Folder);
  }
  /// What is proposed is the value alone, behind `option`, a part of the word.
  void startWith(const std::string& option) { before_ = option, typed_.erase(0, option.size()); }
  [[nodiscard]] const std::string& typed() const { return typed_; }
  [[nodiscard]] std::string text() && { return std::move(text_); }

 private:
  std::string typed_, before_, text_;
};

}  // namespace

std::string proposalsFor(std::vector<std::string> words) {
  if (!words.empty() && words.back() == "=")
    words.back().clear();  // bash makes three words of --order=newell
  std::erase(words, "=");
  if (words.empty()) return "";
  Proposals all{words.back()};
  words.pop_back();
  const std::vector<OptionRow> rows = optionRows();
  const auto rowOf = [&](std::string_view word) {
    const auto row = std::ranges::find_if(
        rows, [&](const OptionRow& r) { return r.name == word || (r.letter == word && !word.empty()); });
    return row == rows.end() || row->takes == Takes::Nothing ? nullptr : &*row;
  };
  std::vector<std::string> places;  // words that are neither options nor their values
  const OptionRow* valued = nullptr;
  for (const std::string& word : words) {
    const OptionRow* const before = std::exchange(valued, nullptr);
    if (before != nullptr) continue;
    if (word.starts_with('-'))
      valued = rowOf(word);
    else
      places.push_back(word);
  }
  const std::size_t equals = all.typed().find('=');
  if (const OptionRow* const row =
          equals == std::string::npos ? nullptr : rowOf(all.typed().substr(0, equals))) {
    all.startWith(all.typed().substr(0, equals + 1));
    all.addValues(*row);
  } else if (valued != nullptr) {
    all.addValues(*valued);
  } else if (all.typed().starts_with('-')) {
    for (const OptionRow& option : rows) {
      if (!option.letter.empty()) all.add(option.letter, option.does);
      all.add(option.name, option.does);
    }
  } else if (places.empty()) {
    for (const CommandRow& command : kCommands) all.add(std::string{command.name}, command.does);
    all.addScenes();
  } else if (const auto* const command = std::ranges::find(kCommands, places[0], &CommandRow::name);
             command != kCommands.end()) {
    const bool first = places.size() == 1;
    if (first && command->usage.find("SCENE") != std::string_view::npos) all.addScenes();
    if (first && command->is(kPages)) {
      for (const LessonEntry& lesson : builtInLessons())
        if (command->id == Command::Lesson) all.add(lesson.name, lesson.shows);
      for (const LectureEntry& lecture : builtInLectures())
        if (command->id == Command::Lecture) all.add(lecture.name, lecture.shows);
      all.addFiles(std::array{std::string_view{".json"}});
    }
    if (places.size() == 2 && !command->takes.empty()) all.addFiles({});
  }
  return std::move(all).text();
}

}  // namespace xnewell
