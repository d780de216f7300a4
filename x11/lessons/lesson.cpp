#include "x11/lessons/lesson.h"

#include <algorithm>
#include <array>

#include "geometry/files/data_folder.h"
#include "geometry/files/text_file.h"
#include "shading/scene/json_text.h"
#include "shading/scene/settings.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/lessons/read_exhibit.h"

namespace xnewell {

namespace {

/// The controls that are no settings of the picture, or that lessons call by another name. The server's
/// filler is not for lessons.
constexpr std::array kOwnControls{
    LessonControl{'l', "light", "light", "turn the light with the arrows"},
    LessonControl{'t', "turn", "turn", "turn the scene with the arrows", "arrows, or drag the picture"},
    LessonControl{'z', "zoom", "zoom", "come nearer or go away with the arrows", "arrows up and down"},
    LessonControl{'P', "projection", "project"},
    LessonControl{'J', "nearest", "nearest"},
    LessonControl{'L', "L constant", "L const.", "", "the light is far away"},
    LessonControl{'V', "V constant", "V const.", "", "the viewer is far away"},
    LessonControl{'M', "names", "names", "", "name the polygons"},
    LessonControl{'W', "wrong", "wrong", "", "mark them in the picture"},
    LessonControl{'v', "event", "step", "go through the run with the arrows"},
    LessonControl{'m', "rotate", "rotate", "", "move the ramp through its cells"},
    LessonControl{'g', "gamma", "gamma"},
};

constexpr std::size_t kLongestHeading = 26;  // letters of Voice::Title in a column of 320 pixels

/// Reads words with placeholders.
std::string readWords(const Node& node) {
  std::string words = node.text();
  if (const std::string wrong = checkPlaceholders(words); !wrong.empty()) node.fail(wrong);
  return words;
}

void need(const Node& node, std::initializer_list<const char*> keys) {
  for (const char* const key : keys)
    if (!node.has(key)) node.fail(std::string{key} + " is needed");
}

LessonAnswer readAnswer(const Node& node, const Exhibit& exhibit, SceneShelf& shelf) {
  node.expectKeys({"text", "holds", "says", "shown"});
  need(node, {"text", "says"});
  LessonAnswer answer;
  answer.text = node.at("text").text();
  answer.says = readWords(node.at("says"));
  answer.holds = node.has("holds") && node.at("holds").truth();
  if (!answer.holds && !node.has("shown")) node.fail("shown is needed: a wrong answer must be seen to fail");
  answer.shown = exhibit;
  answer.shown.claims.clear();
  if (node.has("shown")) {
    expectExhibitKeys(node.at("shown"));
    answer.shown = readExhibit(node.at("shown"), &exhibit, shelf);
  }
  return answer;
}

LessonQuestion readQuestion(const Node& node, const Exhibit& exhibit, SceneShelf& shelf) {
  node.expectKeys({"asks", "hint", "answers"});
  need(node, {"asks", "answers"});
  LessonQuestion question{.asks = node.at("asks").text(), .hint = {}, .answers = {}};
  if (node.has("hint")) question.hint = node.at("hint").text();
  const Node answers = node.at("answers");
  if (answers.size() < 2 || answers.size() > kMostAnswers) answers.fail("2 to 4 answers are needed");
  for (int k = 0; k < answers.size(); ++k)
    question.answers.push_back(readAnswer(answers.item(k), exhibit, shelf));
  if (std::ranges::count(question.answers, true, &LessonAnswer::holds) != 1)
    answers.fail("exactly one answer must hold");
  return question;
}

LessonStep readStep(const Node& node, const Exhibit* before, SceneShelf& shelf) {
  expectExhibitKeys(node, {"heading", "caption", "controls", "question"});
  need(node, {"heading", "caption"});
  LessonStep step;
  step.heading = node.at("heading").text();
  if (step.heading.empty() || step.heading.size() > kLongestHeading)
    node.at("heading").fail("1 to 26 characters are needed");
  const Node caption = node.at("caption");
  if (caption.size() == 0) caption.fail("a paragraph is needed");
  for (int k = 0; k < caption.size(); ++k) step.caption.push_back(readWords(caption.item(k)));
  step.exhibit = readExhibit(node, before, shelf);
  if (node.has("controls")) {
    const Node controls = node.at("controls");
    for (int k = 0; k < controls.size(); ++k) {
      step.controls.push_back(controls.item(k).choice(lessonControls()));
      if (std::ranges::count(step.controls, step.controls.back()) > 1)
        controls.item(k).fail("the control is listed twice");
    }
  }
  if (node.has("question")) step.question = readQuestion(node.at("question"), step.exhibit, shelf);
  return step;
}

LessonEntry readEntry(const Node& root) {
  need(root, {"title"});
  LessonEntry entry;
  entry.title = root.at("title").text();
  if (root.has("shows")) entry.shows = root.at("shows").text();
  if (root.has("number")) entry.number = root.at("number").whole(1, 99);
  return entry;
}

}  // namespace

const std::vector<LessonControl>& lessonControls() {
  static const std::vector<LessonControl> rows = [] {
    std::vector<LessonControl> all;
    for (const Setting& setting : settingRows())
      if (setting.control != 0 && setting.key != "fill" &&
          std::ranges::find(kOwnControls, setting.control, &LessonControl::id) == kOwnControls.end())
        all.push_back({setting.control, setting.label, setting.label});
    all.insert(all.end(), kOwnControls.begin(), kOwnControls.end());
    return all;
  }();
  return rows;
}

Lesson parseLesson(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
  const JsonText json{text, name};
  const Node root = json.root();
  root.expectKeys({"title", "number", "shows", "steps"});
  need(root, {"title", "steps"});
  const LessonEntry entry = readEntry(root);
  Lesson lesson{.name = std::filesystem::path{name}.stem().string(),
                .title = entry.title,
                .shows = entry.shows,
                .number = entry.number,
                .steps = {}};
  const Node steps = root.at("steps");
  if (steps.size() < 1 || steps.size() > kMostSteps) steps.fail("1 to 12 steps are needed");
  SceneShelf shelf{folder};
  for (int k = 0; k < steps.size(); ++k)
    lesson.steps.push_back(readStep(steps.item(k), k > 0 ? &lesson.steps.back().exhibit : nullptr, shelf));
  return lesson;
}

Lesson readLesson(const std::filesystem::path& file) {
  Lesson lesson = parseLesson(readTextFile(file), file.string(), file.parent_path());
  lesson.source = file.parent_path() == dataFolder() / "lessons" ? lesson.name : file.string();
  return lesson;
}

std::vector<LessonEntry> builtInLessons() {
  std::vector<LessonEntry> lessons;
  for (const auto& found : std::filesystem::directory_iterator{dataFolder() / "lessons"}) {
    if (found.path().extension() != ".json") continue;
    const std::string name = found.path().string();
    LessonEntry entry =
        readEntry(JsonText{readTextFile(found.path()), name, {"title", "number", "shows"}}.root());
    entry.name = found.path().stem().string();
    entry.file = found.path();
    lessons.push_back(std::move(entry));
  }
  std::ranges::sort(lessons, {}, [](const LessonEntry& e) { return std::pair{e.number, e.name}; });
  return lessons;
}

std::vector<LectureEntry> builtInLectures() {
  std::vector<LectureEntry> lectures;
  for (const auto& found : std::filesystem::directory_iterator{dataFolder() / "lectures"}) {
    if (found.path().extension() != ".json") continue;
    const JsonText json{readTextFile(found.path()), found.path().string(), {"shows"}};
    const Node root = json.root();
    lectures.push_back({found.path().stem().string(), root.has("shows") ? root.at("shows").text() : ""});
  }
  std::ranges::sort(lectures, {}, &LectureEntry::name);
  return lectures;
}

}  // namespace xnewell
