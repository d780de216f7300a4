#include "x11/command/read_lecture.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "geometry/files/model_file.h"
#include "geometry/files/text_file.h"
#include "shading/scene/json_text.h"
#include "x11/app/lecture.h"
#include "x11/app/work.h"
#include "x11/command/commands.h"
#include "x11/options/shell_words.h"

namespace xnewell {

namespace {

constexpr std::size_t kLongestTitle = 60;  // letters
constexpr int kMostPages = 200;

/// A file beside the lecture, or else one of the working folder, or a built-in name.
std::string beside(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path file = namedFile(folder, name);
  return std::filesystem::is_regular_file(file) ? file.string() : name;
}

/// The options of a page.
Options optionsOf(const Node& show) {
  std::optional<std::vector<std::string>> words = wordsOf(show.text());
  if (!words) show.fail("a quotation does not end");
  if (!words->empty() && words->front() == "xnewell") words->erase(words->begin());
  if (!words->empty() && (words->front() == "draw" || words->front() == "snapshot")) {  // as `C` prints it
    words->erase(words->begin());
    std::erase(*words, "--whole-window");
    for (const std::string_view name : {"-o", "--size", "--scale"})
      if (const auto at = std::ranges::find(*words, name); at != words->end() && at + 1 != words->end())
        words->erase(at, at + 2);
  }
  std::vector<const char*> arguments{"xnewell", "view"};
  for (const std::string& word : *words) {
    if (word == "--help" || word == "-h" || word == "--version") show.fail("it shows no scene");
    arguments.push_back(word.c_str());
  }
  constexpr std::array<std::string_view, 6> kOfTheWindow{"--size",     "--scale",   "--visual",
                                                         "--colormap", "--nearest", "--accuracy"};
  try {
    std::optional<Options> options = parseOptions(static_cast<int>(arguments.size()), arguments.data());
    if (!options) show.fail("it shows no scene");
    for (const std::string_view option : kOfTheWindow)
      if (options->gave(option)) show.fail(std::string{option} + " is not for a page");
    return *std::move(options);
  } catch (const UsageError& e) {
    show.fail(e.what());
  }
}

Page readPage(const Node& node, const std::filesystem::path& folder) {
  node.expectKeys({"title", "show", "lesson", "notes"});
  if (!node.has("title")) node.fail("title is needed");
  if (node.has("show") && node.has("lesson")) node.fail("show and lesson exclude each other");
  if (!node.has("show") && !node.has("lesson")) node.fail("show or lesson is needed");
  Page page;
  page.title = node.at("title").text();
  if (page.title.empty() || page.title.size() > kLongestTitle)
    node.at("title").fail("1 to " + std::to_string(kLongestTitle) + " characters are needed");
  if (node.has("notes")) page.notes = node.at("notes").text();
  if (node.has("lesson")) page.lesson = lessonNamed(beside(folder, node.at("lesson").text()));
  Options options;
  if (node.has("show")) options = optionsOf(node.at("show"));
  options.scene = beside(folder, options.scene);
  page.place = options.window;
  try {
    page.scene = readyScene(options);
  } catch (const UsageError& e) {
    node.at("show").fail(e.what());
  } catch (const std::system_error& e) {
    node.at("show").fail(e.what());
  }
  page.setup = setupOf(options);
  return page;
}

}  // namespace

std::vector<Page> readLecture(const std::string& name) {
  const std::filesystem::path builtIn = dataFolder() / "lectures" / (name + ".json");
  const std::string file = std::filesystem::is_regular_file(builtIn) ? builtIn.string() : name;
  const JsonText json{readTextFile(file), file};
  const Node root = json.root();
  root.expectKeys({"shows", "pages"});
  if (!root.has("pages")) root.fail("pages is needed");
  const Node pages = root.at("pages");
  if (pages.size() < 1 || pages.size() > kMostPages)
    pages.fail("1 to " + std::to_string(kMostPages) + " pages are needed");
  std::vector<Page> all;
  for (int k = 0; k < pages.size(); ++k)
    all.push_back(readPage(pages.item(k), std::filesystem::path{file}.parent_path()));
  return all;
}

}  // namespace xnewell
