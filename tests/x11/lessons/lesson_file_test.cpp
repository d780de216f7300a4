#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/support/reader_fixture.h"
#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_facts.h"

namespace xnewell::THIS_FILE {

// Lesson files: all of ours can be read, every key does what it says, and each mistake is named with its
// place.

namespace {

Lesson parsed(const std::string& text) {
  return parseLesson(text, "l.json", std::filesystem::path{XNEWELL_DATA_DIR} / "lessons");
}

/// A lesson of one step, with `more` among its keys.
std::string withStep(const std::string& more, const std::string& scene = "sticks") {
  return R"({"title": "t", "steps": [{"heading": "h", "caption": ["c"], "scene": ")" + scene + "\"" +
         (more.empty() ? "" : ", ") + more + "}]}";
}

std::string complaintOf(const std::string& text) {
  return complaint([&] { return parsed(text); });
}

Exhibit exhibitOf(const std::string& more, const std::string& scene = "sticks") {
  return parsed(withStep(more, scene)).steps[0].exhibit;
}

/// Two answers, of which the second is right. `first` is what the first one has besides its text.
std::string question(const std::string& first) {
  return R"("question": {"asks": "q", "answers": [{"text": "a")" + first +
         R"(}, {"text": "b", "holds": true, "says": "so"}]})";
}

}  // namespace

TEST(LessonFile, AllThatAreBuiltInCanBeRead) {
  const std::vector<LessonEntry> entries = builtInLessons();
  ASSERT_GE(entries.size(), 9U);
  int steps = 0, questions = 0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    SCOPED_TRACE(entries[k].name);
    const Lesson lesson = readLesson(entries[k].file);
    EXPECT_EQ(lesson.name, entries[k].name);
    EXPECT_EQ(lesson.number, static_cast<int>(k) + 1);
    EXPECT_FALSE(lesson.shows.empty());
    EXPECT_GE(lesson.steps.size(), 4U);
    EXPECT_LE(lesson.steps.size(), 8U);
    steps += static_cast<int>(lesson.steps.size());
    for (const LessonStep& step : lesson.steps) questions += step.question.has_value();
  }
  EXPECT_GE(steps, 40);
  EXPECT_GE(questions, 15);
}

// The words follow the house style: no exclamation marks and no American spelling.
TEST(LessonFile, WordsAreInTheHouseStyle) {
  const std::regex american{"\\b(color|gray-|center|behavior|brighten up)\\b", std::regex::icase};
  int words = 0;
  const auto check = [&](const std::string& text) {
    EXPECT_EQ(text.find('!'), std::string::npos) << text;
    EXPECT_FALSE(std::regex_search(text, american)) << text;
    ++words;
  };
  for (const LessonEntry& entry : builtInLessons())
    for (const LessonStep& step : readLesson(entry.file).steps) {
      check(step.heading);
      for (const std::string& paragraph : step.caption) check(paragraph);
      if (!step.question) continue;
      check(step.question->asks);
      check(step.question->hint);
      for (const LessonAnswer& answer : step.question->answers) check(answer.text), check(answer.says);
    }
  EXPECT_GT(words, 200);
}

TEST(LessonFile, EveryKeyOfAnExhibitWorks) {
  EXPECT_EQ(exhibitOf("").stage, Stage::Picture);
  for (const StageRow& row : kStages)
    if (row.id != Stage::SideBySide) {
      EXPECT_EQ(exhibitOf("\"window\": \"" + std::string{row.name} + "\"").stage, row.id);
    }
  EXPECT_EQ(exhibitOf(R"("shading": {"method": "phong", "n": 7})").settings.light.n, 7);
  EXPECT_EQ(exhibitOf(R"("shading": {"order": "zmean", "table": {"shades": 9}})").settings.table.shades, 9);
  EXPECT_EQ(exhibitOf(R"("camera": {"parallel": 4})").settings.camera.height.has_value(), true);
  EXPECT_NE(exhibitOf(R"("camera": {"eye": [1, 2, 9]})").settings.camera, exhibitOf("").settings.camera);
  EXPECT_EQ(exhibitOf(R"("line": "l")").line, "l");
  EXPECT_TRUE(exhibitOf(R"("names": {"A": 0}, "extents": true)").extents);
  EXPECT_TRUE(exhibitOf(R"("wrong": true)").wrongMarked);
  EXPECT_EQ(exhibitOf(R"("divisions": 3)", "teapot").scene->divisions, 3);

  const Exhibit named = exhibitOf(R"("names": {"A": 0, "C": 2}, "listed": [2, 0, 1])");
  ASSERT_EQ(named.names.size(), 2U);
  EXPECT_EQ(named.names[0].face, 1);  // names follow their faces
  EXPECT_EQ(named.names[1].face, 0);
  EXPECT_EQ(named.scene->mesh.groupNames[static_cast<std::size_t>(named.scene->mesh.group[0])], "C");

  const Exhibit sides = exhibitOf(
      R"("window": "side by side", "beside": {"shading": {"method": "gouraud"}, "upper": "u", "lower": "o"})");
  EXPECT_EQ(sides.beside.shading, Shading::Gouraud);
  EXPECT_EQ(sides.settings.shading, Shading::Flat);
  EXPECT_EQ(sides.upperLine + sides.lowerLine, "uo");

  const PaletteEffects effects =
      exhibitOf(
          R"("effects": {"stored": "brief", "hue turn": 90, "gamma": 2, "rotate": 5, "lit": 40, "bend": [100, 7]})")
          .effects;
  EXPECT_EQ(effects, (PaletteEffects{TableKind::Brief, 90, 2, CurvePoint{100, 7}, 5, 40}));

  const EventChoice cut = exhibitOf(R"("event": {"kind": "cut", "number": 2, "says": "split"})").event;
  EXPECT_EQ(cut.kind, Event::Kind::Split);
  EXPECT_EQ(cut.number, 2);
  EXPECT_EQ(cut.says, "split");
  EXPECT_EQ(exhibitOf(R"("event": {"test": "3'"})").event.test, xnewell::Test::QBehindP);

  const std::vector<Claim> claims =
      exhibitOf(R"("claims": {"cuts": 3, "samples": {"at least": 1, "at most": 2}})").claims;
  ASSERT_EQ(claims.size(), 2U);
  EXPECT_EQ(claims[0].is, 3);
  EXPECT_EQ(claims[1].least, 1);
  EXPECT_EQ(claims[1].most, 2);
}

// A step without a scene takes the one before it and changes it. An answer takes its step's scene and changes
// it.
TEST(LessonFile, StepsInherit) {
  const Lesson lesson = parsed(
      R"({"title": "t", "steps": [
        {"heading": "1", "caption": ["c"], "scene": "sticks", "names": {"A": 0}, "shading": {"order": "zsort"},
         "claims": {"cuts": 1}},
        {"heading": "2", "caption": ["c"], "shading": {"method": "phong"},
         "question": {"asks": "q", "answers": [
           {"text": "a", "says": "s", "shown": {"wrong": true}}, {"text": "b", "holds": true, "says": "s"}]}}]})");
  const Exhibit& second = lesson.steps[1].exhibit;
  EXPECT_EQ(second.settings.order, Order::ZSort);
  EXPECT_EQ(second.settings.shading, Shading::Phong);
  EXPECT_EQ(second.names.size(), 1U);
  EXPECT_TRUE(second.claims.empty());
  EXPECT_EQ(second.scene, lesson.steps[0].exhibit.scene);  // it is read once
  const std::vector<LessonAnswer>& answers = lesson.steps[1].question->answers;
  EXPECT_TRUE(answers[0].shown.wrongMarked);
  EXPECT_FALSE(answers[1].shown.wrongMarked);
  EXPECT_EQ(answers[0].shown.settings, second.settings);
}

TEST(LessonFile, EveryControlIsKnown) {
  std::string keys = "hkxf1234567weuUrq?";  // the hint, the keys of spareOf(), and those of all views
  for (const LessonControl& row : lessonControls()) {
    const Lesson lesson = parsed(withStep("\"controls\": [\"" + std::string{row.name} + "\"]"));
    EXPECT_EQ(lesson.steps[0].controls, std::vector{row.id});
    EXPECT_EQ(keys.find(row.id), std::string::npos) << row.name;
    keys += row.id;
  }
}

TEST(LessonFile, ComplaintsNameThePlace) {
  EXPECT_EQ(complaintOf("{\n,}"), "l.json:2: not valid JSON here");
  EXPECT_EQ(complaintOf("{}"), "l.json: title is needed");
  EXPECT_EQ(complaintOf(R"({"titel": "t"})"),
            "l.json: unknown key 'titel'; the keys are title, number, shows, steps");
  EXPECT_EQ(complaintOf(R"({"title": "t", "title": "u"})"),
            "l.json:1: the key 'title' appears twice in an object");
  EXPECT_EQ(complaintOf(R"({"title": 3, "steps": []})"), "l.json: title: a string is needed");
  EXPECT_EQ(complaintOf(R"({"title": "t", "steps": []})"), "l.json: steps: 1 to 12 steps are needed");
  EXPECT_EQ(complaintOf(R"({"title": "t", "steps": [{}]})"), "l.json: steps[0]: heading is needed");
  EXPECT_EQ(complaintOf(R"({"title": "t", "steps": [{"heading": "h", "caption": ["c"]}]})"),
            "l.json: steps[0]: a scene is needed");
  EXPECT_EQ(complaintOf(R"({"title": "t", "steps": [{"heading": "h", "caption": []}]})"),
            "l.json: steps[0].caption: a paragraph is needed");
  EXPECT_EQ(complaintOf(
                R"({"title": "t", "steps": [{"heading": "abcdefghijklmnopqrstuvwxyza", "caption": ["c"]}]})"),
            "l.json: steps[0].heading: 1 to 26 characters are needed");
  EXPECT_EQ(complaintOf(withStep("", "nosuch")),
            "l.json: steps[0].scene: 'nosuch' is no built-in scene, and no file beside the lesson");
  EXPECT_TRUE(complaintOf(withStep(R"("colour": 1)"))
                  .starts_with("l.json: steps[0]: unknown key 'colour'; the keys are "));
  EXPECT_EQ(complaintOf(withStep(R"("divisions": 0)")),
            "l.json: steps[0].divisions: a whole number from 1 to 64 is needed");
  EXPECT_EQ(complaintOf(withStep(R"("window": "trade")")),
            "l.json: steps[0].window: 'trade' is not one of picture, depth sort, colours, mach bands, side "
            "by side, scanline, viewing");
  EXPECT_EQ(complaintOf(withStep(R"("window": "side by side")")),
            "l.json: steps[0]: side by side needs beside");
  EXPECT_EQ(complaintOf(withStep(R"("shading": {"order": "zbuffer8"})")),
            "l.json: steps[0].shading.order: 'zbuffer8' is not one of none, zmean, zsort, newell, bsp, "
            "zbuffer16, zbuffer24, zbuffer32, oracle");
  EXPECT_EQ(complaintOf(withStep(R"("camera": {"fov": 200})")),
            "l.json: steps[0].camera.fov: an angle between 0 and 180 degrees is needed");
  EXPECT_EQ(complaintOf(withStep(R"("names": {"A": 3})")),
            "l.json: steps[0].names.A: a whole number from 0 to 2 is needed");
  EXPECT_EQ(complaintOf(withStep(R"("names": {"ABC": 1})")),
            "l.json: steps[0].names.ABC: a name of one or two letters is needed");
  EXPECT_EQ(complaintOf(withStep(R"("extents": true)")),
            "l.json: steps[0]: extents are those of named faces: names are needed");
  EXPECT_EQ(complaintOf(withStep(R"("listed": [0, 1])")),
            "l.json: steps[0].listed: all 3 faces are needed, each once");
  EXPECT_EQ(complaintOf(withStep(R"("listed": [0, 1, 1])")),
            "l.json: steps[0].listed[2]: the face is listed twice");
  EXPECT_EQ(complaintOf(withStep(R"("listed": [0])", "teapot")),
            "l.json: steps[0].listed: is for scenes of plain polygons");
  EXPECT_EQ(complaintOf(withStep(R"("wrong": 1)")), "l.json: steps[0].wrong: true or false is needed");
  EXPECT_EQ(complaintOf(withStep(R"("effects": {"gamma": 0})")),
            "l.json: steps[0].effects.gamma: a number from 0.1 to 10 is needed");
  EXPECT_EQ(complaintOf(withStep(R"("effects": {"lit": 256})")),
            "l.json: steps[0].effects.lit: a whole number from 0 to 255 is needed");
  EXPECT_EQ(complaintOf(withStep(R"("effects": {"bend": [1]})")),
            "l.json: steps[0].effects.bend: a cell and its value are needed");
  EXPECT_EQ(complaintOf(withStep(R"("event": {})")),
            "l.json: steps[0].event: one of kind and test is needed");
  EXPECT_EQ(complaintOf(withStep(R"("event": {"kind": "cut", "number": 0})")),
            "l.json: steps[0].event.number: a whole number from 1 to 1000000 is needed");
  EXPECT_TRUE(
      complaintOf(withStep(R"("claims": {"cats": 1})"))
          .starts_with("l.json: steps[0].claims.cats: there is no such fact; the facts are polygons, "));
  EXPECT_EQ(complaintOf(withStep(R"("claims": {"cuts": {}})")),
            "l.json: steps[0].claims.cuts: one of at least and at most is needed");
  EXPECT_TRUE(
      complaintOf(withStep(R"("controls": ["fill"])"))
          .starts_with("l.json: steps[0].controls[0]: 'fill' is not one of shading, normals, order, "));
  EXPECT_EQ(complaintOf(withStep(R"("controls": ["ks", "ks"])")),
            "l.json: steps[0].controls[1]: the control is listed twice");
  EXPECT_EQ(
      complaintOf(R"({"title": "t", "steps": [{"heading": "h", "caption": ["{cuts"], "scene": "sticks"}]})"),
      "l.json: steps[0].caption[0]: a { without a }");
  EXPECT_EQ(complaintOf(withStep(
                R"("beside": {"shading": {"table": {"kind": "corrected"}}}, "window": "side by side")")),
            "l.json: steps[0].beside.shading: both pictures are in one colour table");
}

TEST(LessonFile, ComplaintsOfQuestions) {
  EXPECT_EQ(complaintOf(withStep(question(R"(, "says": "no", "shown": {})"))), "");
  EXPECT_EQ(complaintOf(withStep(question(R"(, "says": "no")"))),
            "l.json: steps[0].question.answers[0]: shown is needed: a wrong answer must be seen to fail");
  EXPECT_EQ(complaintOf(withStep(question(R"(, "shown": {})"))),
            "l.json: steps[0].question.answers[0]: says is needed");
  EXPECT_EQ(complaintOf(withStep(question(R"(, "says": "no", "shown": {"heading": "x"})"))).substr(0, 62),
            "l.json: steps[0].question.answers[0].shown: unknown key 'headi");
  EXPECT_EQ(complaintOf(withStep(question(R"(, "says": "no", "holds": true)"))),
            "l.json: steps[0].question.answers: exactly one answer must hold");
  EXPECT_EQ(complaintOf(withStep(R"("question": {"asks": "q", "answers": [{"text": "a", "says": "b"}]})")),
            "l.json: steps[0].question.answers: 2 to 4 answers are needed");
  EXPECT_EQ(complaintOf(withStep(R"("question": {"asks": "q"})")),
            "l.json: steps[0].question: answers is needed");
}

// A file with any bytes changed gives a lesson or a complaint, and never anything else.
TEST(LessonFile, AnyTextIsReadOrRefused) {
  std::ifstream file{std::string{XNEWELL_DATA_DIR} + "/lessons/cycles.json"};
  std::stringstream text;
  text << file.rdbuf();
  int refused = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    refused += complaintOf(mutated(text.str(), rng)).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace xnewell::THIS_FILE
