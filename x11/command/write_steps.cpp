#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "geometry/files/input_file.h"
#include "geometry/files/model_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "x11/app/workbench.h"
#include "x11/command/commands.h"
#include "x11/homework/reports.h"
#include "x11/lessons/lesson_figure.h"
#include "x11/lessons/lesson_view.h"
#include "x11/options/shell_words.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_view.h"

namespace xnewell {

namespace {

/// ---- The folder of --frames: numbered PNG files in a folder of their own

/// A frame's number has at least four digits, so the file names sort in the order of the run.
std::string fileName(int number, std::string_view word) {
  std::string digits = std::to_string(number);
  return std::string(4 - digits.size(), '0') + digits + "-" + std::string{word} + ".png";
}

/// True for a frame of an earlier run, which would be mistaken for one of this run.
bool isFrame(const std::string& name) {
  return name.size() > 9 &&
         std::all_of(name.begin(), name.begin() + 4, [](unsigned char c) { return std::isdigit(c); }) &&
         name[4] == '-' && name.ends_with(".png");
}

/// Makes the folder if it does not exist. @throws UsageError if it holds frames already; std::system_error
void makeFrameFolder(const std::string& folder) {
  namespace fs = std::filesystem;
  makeFolder(folder);
  std::error_code error;
  fs::directory_iterator files{folder, error};
  if (error) throw std::system_error{error, folder};
  for (const fs::directory_entry& file : files)
    if (const std::string name = file.path().filename().string(); isFrame(name))
      throw UsageError{"--frames: " + inQuotes(folder) + " already holds frames, such as " + name +
                       "; name another folder, or remove them"};
}

/// The name of a frame's file, such as FOLDER/0007-cut.png.
std::string frameFile(const std::string& folder, int number, std::string_view word) {
  return (std::filesystem::path{folder} / fileName(number, word)).string();
}

/// ---- The steps of the depth sort

constexpr int kMostFrames = 9999;

/// The steps of the kind that --every names. @throws UsageError
std::vector<int> stepsToDraw(const Options& options, const SortedScene& sorted) {
  const std::string word{kEvery[static_cast<int>(options.every)].name};
  std::vector<int> steps = stepsOf(sorted, options.every);
  if (steps.empty())
    throw UsageError{options.scene + ": the run has no " + word +
                     ", so there is no frame to write; --every paint has " +
                     std::to_string(sorted.fragments.size())};
  if (steps.size() >= kMostFrames)
    throw UsageError{"--every " + word + ": " + std::to_string(steps.size()) +
                     " frames are too many; the most is 9,998"};
  return steps;
}

}  // namespace

void writeFrames(const Options& options, const Picture& picture, const SortedScene& sorted) {
  const std::vector<int> steps = stepsToDraw(options, sorted);
  makeFrameFolder(options.frames);

  Frames frames{picture, sorted, !options.quick, steps};
  int number = 0;
  const auto write = [&](const IndexImage& frame, std::string_view what) {
    writeFile(frameFile(options.frames, ++number, what), encodePng(frame, frames.palette()));
  };
  for (const int step : steps) write(frames.at(step), wordFor(sorted.events[step - 1].kind));
  write(frames.finished(), "done");
}

void writeStepperFrames(const Options& options, Scene scene, const std::function<void(int, int)>& tell) {
  Workbench bench{std::move(scene), {.picture = options.picture, .fill = options.fill}, {}};
  const glm::ivec2 size = windowSize(options);
  bench.scale(options.scale);
  bench.resize(size.x, size.y);
  bench.switchTo(View::DepthSort);
  const auto draw = [&] {
    while (bench.stale() != Workbench::Stale::Nothing) bench.update();
  };
  draw();
  if (bench.stepper().tooLong())
    throw UsageError{options.scene + ": the run is too long to step through; try fewer --divisions"};
  const SortedScene& sorted = bench.stepper().run()->sorted();
  const std::vector<int> steps = stepsToDraw(options, sorted);
  makeFrameFolder(options.frames);

  // The last step shows every face painted, so it is the last frame, whatever its kind.
  const int end = bench.stepper().run()->steps();
  std::vector<int> shown = steps;
  if (shown.back() != end) shown.push_back(end);
  const int all = static_cast<int>(shown.size());
  for (int number = 1; number <= all; ++number) {
    tell(number, all);
    const int step = shown[static_cast<std::size_t>(number - 1)];
    bench.stepper().goTo(step);
    draw();
    writeFile(frameFile(options.frames, number, step == end ? "done" : wordFor(sorted.events[step - 1].kind)),
              encodePng(bench.image(), bench.palette()));
  }
}

/// ---- The steps of a lesson, as pictures and as a worksheet

Lesson lessonNamed(const std::string& nameOrFile) {
  for (const LessonEntry& entry : builtInLessons())
    if (entry.name == nameOrFile) return readLesson(entry.file);
  const std::filesystem::path file{nameOrFile};
  if (file.extension() == ".json" && isThere(file)) return readLesson(file);
  std::vector<std::string> names;
  for (const LessonEntry& entry : builtInLessons()) names.push_back(entry.name);
  throw UsageError{"there is no lesson " + inQuotes(nameOrFile) + "; " +
                   didYouMean(nameOrFile, names, "`xnewell scenes` lists the lessons")};
}

namespace {

/// Draws the whole window at each step of a lesson, before any question is answered, and visits it. It needs
/// no server. It calls `tell` with the number of each step, from 1, before it draws it. The visitor gets the
/// step's index, from 0, and may press keys.
void visitSteps(const Options& options, Lesson lesson, const std::function<void(int)>& tell,
                const std::function<void(Workbench& bench, int step)>& visit) {
  const int steps = static_cast<int>(lesson.steps.size());
  Workbench bench{readScene("teapot"), Setup{}, {}};
  const glm::ivec2 size = windowSize(options);
  bench.scale(options.scale);
  bench.resize(size.x, size.y);
  bench.teach(std::move(lesson));
  for (int step = 0; step < steps; ++step) {
    tell(step + 1);
    bench.lessons().goTo(step);
    while (bench.stale() != Workbench::Stale::Nothing) bench.update();
    visit(bench, step);
  }
}

constexpr std::string_view kHead = R"(<meta charset="utf-8">
<style>
body { font: 11pt/1.4 serif; max-width: 45em; margin: 2em auto }
img { width: 100%; image-rendering: pixelated }
section { break-inside: avoid; margin-top: 2em }
section + section { break-before: page }
.room { height: 7em; border-bottom: 1px solid; margin-bottom: 1em }
.try { font-size: smaller }
</style>
)";

/// What the page of a step shows beside its words.
std::string pictureOf(const Workbench& bench) {
  constexpr int kAround = 8;  // units: marks reach into the margins
  const Rect drawn = figureAreaOf(bench.layout());
  const Rect from =
      Rect{drawn.x - kAround, drawn.y, drawn.width + 2 * kAround, drawn.height} * bench.layout().unit;
  IndexImage part{from.width, from.height, 0};
  for (int y = 0; y < from.height; ++y)
    std::copy_n(bench.image().row(from.y + y) + from.x, from.width, part.row(y));
  return imageElement(encodePng(part, bench.palette()));
}

}  // namespace

void writeLesson(const Options& options, Lesson lesson, const std::function<void(int)>& tell) {
  makeFrameFolder(options.frames);
  visitSteps(options, std::move(lesson), tell, [&](const Workbench& bench, int step) {
    writeFile(frameFile(options.frames, step + 1, "step"), encodePng(bench.image(), bench.palette()));
  });
}

void writeWorksheet(const Options& options, Lesson lesson, const std::function<void(int)>& tell) {
  const std::string head = "<!DOCTYPE html>\n<html lang=\"en\">\n" + element("title", lesson.title) +
                           std::string{kHead} + element("h1", lesson.title);
  std::string sheet = head + "<p>Name:</p>\n";
  std::string solutions = "<section>\n" + element("h2", "Solutions") + "<ol>\n";
  const std::vector<LessonStep> steps = lesson.steps;
  const std::string source = lesson.source;
  visitSteps(options, std::move(lesson), tell, [&](Workbench& bench, int k) {
    const LessonPage asked = bench.lessons().page();
    sheet += "<section>\n" + element("h2", std::to_string(k + 1) + ". " + asked.heading) + pictureOf(bench);
    for (const std::string& paragraph : asked.caption) sheet += element("p", paragraph);
    const LessonStep& step = steps[static_cast<std::size_t>(k)];
    if (!step.controls.empty())
      sheet += "<p class=\"try\">To try it on a screen: <code>" +
               inHtml("xnewell lesson " + quoted(source) + " --step " + std::to_string(k + 1)) +
               "</code></p>\n";
    std::string solution = asked.heading + ": no question.";
    if (const auto& question = step.question) {
      sheet += element("p", question->asks) + "<ol type=\"a\">\n";
      for (const LessonAnswer& answer : question->answers) sheet += element("li", answer.text);
      sheet += "</ol>\n" + element("p", "Why?") + "<div class=\"room\"></div>\n";
      const auto right = std::ranges::find(question->answers, true, &LessonAnswer::holds);
      const char letter = static_cast<char>('a' + (right - question->answers.begin()));
      bench.press({NamedKey::Letter, letter});
      bench.press({NamedKey::Return});
      while (bench.stale() != Workbench::Stale::Nothing) bench.update();
      solution = std::string{letter} + ": " + right->text + ". " + bench.lessons().page().question->says;
    }
    sheet += "</section>\n";
    solutions += element("li", solution);
  });
  solutions += "</ol>\n</section>\n";
  const bool apart = !options.solutions.empty();
  sheet += (apart ? "" : solutions) + "</html>\n", solutions = head + solutions + "</html>\n";
  std::vector<OutputFile> files{{options.worksheet, sheet}};
  if (apart) files.push_back({options.solutions, solutions});
  writeFiles(files);
}

namespace {

namespace fs = std::filesystem;

/// The line of page.html that says how the page begins.
constexpr std::string_view kBegin = R"(const begin = {"address": "", "files": {}};)";

/// Where `cmake --install` puts the page, or build.sh.
std::string emptyPage() {
  const fs::path data = fs::canonical(dataFolder());
  for (const fs::path& file : {data / "xnewell.html", data.parent_path() / "build/browser/xnewell.html"})
    if (fs::exists(file)) return readTextFile(file);
  throw std::runtime_error{"the page for browsers is missing; x11/browser/build.sh makes it"};
}

bool isIn(const fs::path& folder, const fs::path& file) {
  return std::ranges::mismatch(folder, file).in1 == folder.end();
}

/// The smallest folder that has them all.
fs::path folderOf(const std::set<fs::path>& files) {
  if (files.empty()) return {};
  fs::path folder = files.begin()->parent_path();
  while (!std::ranges::all_of(files, [&](const fs::path& file) { return isIn(folder, file); }))
    folder = folder.parent_path();
  return folder;
}

}  // namespace

std::string pageThatBeginsWith(const Options& options, const std::set<std::string>& read, std::string page) {
  const fs::path data = fs::canonical(dataFolder());
  std::set<fs::path> files;
  for (const std::string& file : read)
    if (!isIn(data, file)) files.insert(file);
  const fs::path folder = folderOf(files), own = placeOf(options.scene);
  std::string command = "xnewell " + std::string{rowOf(options.command).name} + ' ' +
                        quoted(files.contains(own) ? own.lexically_relative(folder).string() : options.scene);
  for (std::size_t k = 0; k < options.given.size(); ++k)
    if (const std::string& option = options.given[k]; option.starts_with("--") && option != "--page")
      command += ' ' + option + '=' + quoted(options.values[k]);
  nlohmann::ordered_json begin{{"address", addressOf(command)}, {"files", nlohmann::ordered_json::object()}};
  for (const fs::path& file : files)
    begin["files"][file.lexically_relative(folder).string()] = base64(readTextFile(file));
  std::string text = begin.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) text.replace(at, 1, "\\u003c");
  const std::size_t at = page.find(kBegin);
  if (at == page.npos) throw std::runtime_error{"the page for browsers is of another version"};
  return page.replace(at, kBegin.size(), "const begin = " + text + ';');
}

void writePage(const Options& options) {
  const std::set<std::string> read = inputs();  // without the page
  writeFile(options.page, pageThatBeginsWith(options, read, emptyPage()));
}

}  // namespace xnewell
