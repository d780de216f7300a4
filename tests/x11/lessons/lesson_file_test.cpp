#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "depthsort/record/explain.h"
#include "geometry/files/text_file.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/reader_fixture.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/lesson_window.h"
#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/lessons/lesson_figure.h"
#include "x11/lessons/lesson_view.h"
#include "x11/window/layout.h"

namespace xnewell::THIS_FILE {

namespace {

Lesson parsed(const std::string& text) {
  return parseLesson(text, "l.json", std::filesystem::path{XNEWELL_DATA_DIR} / "lessons");
}

/// A lesson of one step, with `more` among its keys.
std::string withStep(const std::string& more, const std::string& scene = "sticks") {
  return R"({"title": "t", "steps": [{"heading": "h", "caption": ["c"], "scene": ")" + scene + "\"" +
         (more.empty() ? "" : ", ") + more + "}]}";
}

StepFigure figureOf(const std::string& more, const std::string& scene = "sticks") {
  return parsed(withStep(more, scene)).steps[0].figure;
}

/// A figure drawn as the window draws it at a size.
struct Shown {
  std::optional<Picture> picture, lower;
  StepFigure of;

  Shown(const StepFigure& figure, glm::ivec2 window) : of{figure} {
    const Layout at = layoutOf(window.x, window.y);
    const Rect area{at.body.x, at.body.y, at.body.width - 320 - kMargin,
                    at.body.height - (at.compact ? 2 : 12)};
    const FigureLayout drawn = layoutOfFigure(area, figure, at.compact);
    PictureSettings settings = figure.settings;
    settings.width = drawn.picture.width, settings.height = drawn.picture.height;
    picture = makePicture(*figure.scene, settings, 8);
    if (figure.stage != View::SideBySide) return;
    settings = figure.beside;
    settings.width = drawn.lower.width, settings.height = drawn.lower.height;
    lower = makePicture(*figure.scene, settings, 8);
  }
  [[nodiscard]] ShownFigure facts() {
    return {*picture, picture->image(), lower ? &lower->image() : nullptr, of};
  }
};

/// All figures of all lessons, each with its place.
template <class Visit>
void forEachFigure(Visit&& visit) {
  for (const LessonEntry& entry : builtInLessons()) {
    const Lesson lesson = readLesson(entry.file);
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
      const std::string place = entry.name + ", step " + std::to_string(k + 1);
      visit(place, lesson.steps[k].figure);
      if (const auto& question = lesson.steps[k].question)
        for (const LessonAnswer& answer : question->answers) visit(place + ": " + answer.text, answer.shown);
    }
  }
}

nlohmann::json read(const std::string& file) { return nlohmann::json::parse(readTextFile(file)); }

}  // namespace

// Lesson files: all of ours can be read, every key does what it says, and each mistake is named with its
// place.

// All that are built in can be read. Their words follow the house style: no exclamation marks and no American
// spelling.
TEST(LessonFile, AllThatAreBuiltInCanBeRead) {
  const std::regex american{"\\b(color|gray-|center|behavior|brighten up)\\b", std::regex::icase};
  int number = 0, steps = 0, questions = 0, words = 0;
  const auto check = [&](const std::string& text) {
    EXPECT_EQ(text.find('!'), std::string::npos) << text;
    EXPECT_FALSE(std::regex_search(text, american)) << text;
    ++words;
  };
  for (const LessonEntry& entry : builtInLessons()) {
    SCOPED_TRACE(entry.name);
    const Lesson lesson = readLesson(entry.file);
    EXPECT_EQ(lesson.name, entry.name);
    EXPECT_EQ(lesson.number, ++number);
    EXPECT_FALSE(lesson.shows.empty());
    EXPECT_GE(lesson.steps.size(), 4U);
    EXPECT_LE(lesson.steps.size(), 8U);
    for (const LessonStep& step : lesson.steps) {
      ++steps;
      check(step.heading);
      for (const std::string& paragraph : step.caption) check(paragraph);
      if (!step.question) continue;
      ++questions;
      check(step.question->asks);
      check(step.question->hint);
      for (const LessonAnswer& answer : step.question->answers) check(answer.text), check(answer.says);
    }
  }
  EXPECT_GE(steps, 40);
  EXPECT_GE(questions, 15);
  EXPECT_GT(words, 200);
}

TEST(LessonFile, EveryKeyOfAFigureWorks) {
  EXPECT_EQ(figureOf("").stage, View::Picture);
  for (const StageRow& row : stageRows())
    if (row.id != View::SideBySide) {
      EXPECT_EQ(figureOf("\"window\": \"" + std::string{row.name} + "\"").stage, row.id);
    }
  EXPECT_EQ(figureOf(R"("shading": {"method": "phong", "n": 7})").settings.light.n, 7);
  EXPECT_EQ(figureOf(R"("shading": {"order": "zmean", "table": {"shades": 9}})").settings.table.shades, 9);
  EXPECT_EQ(figureOf(R"("camera": {"parallel": 4})").settings.camera.height.has_value(), true);
  EXPECT_NE(figureOf(R"("camera": {"eye": [1, 2, 9]})").settings.camera, figureOf("").settings.camera);
  EXPECT_EQ(figureOf(R"("line": "l")").line, "l");
  EXPECT_TRUE(figureOf(R"("names": {"A": 0}, "extents": true)").extents);
  EXPECT_TRUE(figureOf(R"("wrong": true)").wrongMarked);
  EXPECT_EQ(figureOf(R"("divisions": 3)", "teapot").scene->divisions, 3);

  const StepFigure named = figureOf(R"("names": {"A": 0, "C": 2}, "listed": [2, 0, 1])");
  ASSERT_EQ(named.names.size(), 2U);
  EXPECT_EQ(named.names[0].face, 1);  // names follow their faces
  EXPECT_EQ(named.names[1].face, 0);
  EXPECT_EQ(named.scene->mesh.groupNames[named.scene->mesh.group[0]], "C");

  const StepFigure sides = figureOf(
      R"("window": "side by side", "beside": {"shading": {"method": "gouraud"}, "upper": "u", "lower": "o"})");
  EXPECT_EQ(sides.beside.shading, Shading::Gouraud);
  EXPECT_EQ(sides.settings.shading, Shading::Flat);
  EXPECT_EQ(sides.upperLine + sides.lowerLine, "uo");

  const PaletteEffects effects =
      figureOf(
          R"("effects": {"stored": "brief", "hue turn": 90, "gamma": 2, "rotate": 5, "lit": 40, "bend": [100, 7]})")
          .effects;
  EXPECT_EQ(effects, (PaletteEffects{TableKind::Brief, 90, 2, CurvePoint{100, 7}, 5, 40}));

  const EventChoice cut = figureOf(R"("event": {"kind": "cut", "number": 2, "says": "split"})").event;
  EXPECT_EQ(cut.kind, Event::Kind::Split);
  EXPECT_EQ(cut.number, 2);
  EXPECT_EQ(cut.says, "split");
  EXPECT_EQ(figureOf(R"("event": {"test": "3'"})").event.test, xnewell::Test::QBehindP);

  const std::vector<Claim> claims =
      figureOf(R"("claims": {"cuts": 3, "samples": {"at least": 1, "at most": 2}})").claims;
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
  const StepFigure& second = lesson.steps[1].figure;
  EXPECT_EQ(second.settings.order, Order::ZSort);
  EXPECT_EQ(second.settings.shading, Shading::Phong);
  EXPECT_EQ(second.names.size(), 1U);
  EXPECT_TRUE(second.claims.empty());
  EXPECT_EQ(second.scene, lesson.steps[0].figure.scene);  // it is read once
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

// A file with any bytes changed gives a lesson or a complaint, and never anything else.
TEST(LessonFile, AnyTextIsReadOrRefused) {
  const std::string text = readTextFile(XNEWELL_DATA_DIR "/lessons/cycles.json");
  int refused = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    refused += !complaint([&] { return parsed(mutated(text, rng)); }).empty();
  }
  EXPECT_GT(refused, 100);
}

// What lessons say is what the program shows.

// Each claim of each step and of each answer holds, in windows of several sizes, and the steps of the depth
// sort that lessons mention exist and are what the lesson says.
TEST(LessonClaims, Hold) {
  int claims = 0, events = 0;
  forEachFigure([&](const std::string& place, const StepFigure& figure) {
    if (figure.claims.empty() && figure.stage != View::DepthSort) return;
    for (const glm::ivec2 size : someOf(kSizes, 1)) {
      SCOPED_TRACE(place + ", at " + std::to_string(size.x));
      Shown shown{figure, size};
      ShownFigure facts = shown.facts();
      for (const Claim& claim : figure.claims) {
        const FactRow& fact = allFacts()[claim.fact];
        EXPECT_TRUE(facts.holds(claim)) << fact.name << " is " << facts.text(fact);
        ++claims;
      }
      if (figure.stage != View::DepthSort) continue;
      const Picture picture = shown.picture->withPlanes();
      const SortedScene run = textbookRun(picture);
      const std::optional<int> step = stepOf(run, figure.event);
      ASSERT_TRUE(step);
      const Explainer explainer{picture.scene().mesh, picture.snapped(), run, true};
      const std::string sentence = explainer.sentence(run.events[*step - 1], 0);
      EXPECT_NE(sentence.find(figure.event.says), std::string::npos) << sentence;
      ++events;
    }
  });
  EXPECT_GT(claims, kSanitized ? 66 : 200);
  EXPECT_GT(events, kSanitized ? 10 : 30);
}

// A false claim fails. The test changes the last decimal of each claim that names a number.
TEST(LessonClaims, FailWhereTheyAreChanged) {
  int changed = 0;
  forEachFigure([&](const std::string& place, const StepFigure& figure) {
    if (figure.claims.empty()) return;
    Shown shown{figure, kSizes[1]};
    ShownFigure facts = shown.facts();
    for (Claim claim : figure.claims) {
      const FactRow& fact = allFacts()[static_cast<std::size_t>(claim.fact)];
      const double value = facts.value(fact), unit = std::pow(10.0, -fact.decimals);
      if (claim.is) *claim.is += unit;
      if (claim.least) claim.least = value + unit;
      if (claim.most) claim.most = value - unit;
      EXPECT_FALSE(facts.holds(claim)) << place;
      ++changed;
    }
  });
  EXPECT_GT(changed, 70);
}

// Every fact has words, also where there is no number, which no claim can be about. They stand in captions.
TEST(LessonFacts, HaveWords) {
  const Lesson lesson = readLesson(XNEWELL_DATA_DIR "/lessons/mach-bands.json");
  StepFigure figure = lesson.steps[0].figure;
  const Claim claim{.fact = *factNamed("ratio"), .is = {}, .least = 0.0};
  for (const TableKind kind : {TableKind::Linear, TableKind::Corrected}) {
    figure.settings.table.kind = kind;
    Shown shown{figure, kSizes[0]};
    ShownFigure facts = shown.facts();
    for (const FactRow& row : allFacts())
      EXPECT_TRUE(row.needs == FactNeeds::Beside || !facts.text(row).empty()) << row.name;
    EXPECT_EQ(facts.text(allFacts()[claim.fact]) == "none", kind == TableKind::Linear);
    EXPECT_EQ(facts.holds(claim), kind == TableKind::Corrected);
  }
  Shown cycles{readLesson(XNEWELL_DATA_DIR "/lessons/cycles.json").steps[0].figure, kSizes[1]};
  EXPECT_EQ(cycles.facts().filled("{cuts} cut, {painted} parts of {polygons}"), "1 cut, 4 parts of 3");
}

// Each answer of a student is in the file at once, in its order in time. A right answer is confirmed. What an
// earlier session has kept stays, and counts in the score.
TEST(KeptAnswers, AreWhatTheStudentGave) {
  const TemporaryFolder folder;
  const std::string file = folder.file("answers.json");
  {
    LessonWindow window{"cycles"};
    window.bench.keepAnswers(file);
    window.goTo(2);
    EXPECT_FALSE(std::filesystem::exists(file));
    const auto answers = [&](char answer, const std::string& says) {
      window.answer(answer);
      EXPECT_NE(window.bench.layout().after.front().text.find(says), std::string::npos);
      return window.bench.page().question->right;
    };
    EXPECT_FALSE(answers('b', "B was painted"));
    EXPECT_EQ(read(file),
              nlohmann::json::parse(
                  R"({"answers": [{"lesson": "cycles", "step": 3, "tries": ["b"], "right": "d"}]})"));
    EXPECT_TRUE(answers('d', "Right. "));
    EXPECT_EQ(read(file)["answers"][0]["tries"], (nlohmann::json{"b", "d"}));
  }
  KeptAnswers later;
  later.keepIn(file);
  EXPECT_EQ(later.score("cycles"), "0 of 1 right at the first try");
  EXPECT_EQ(later.score("five-tests"), "");
  const Lesson lesson = readLesson(XNEWELL_DATA_DIR "/lessons/cycles.json");
  later.add(lesson, 5, 2);
  EXPECT_EQ(later.score("cycles"), "1 of 2 right at the first try");
  const nlohmann::json both = read(file);
  EXPECT_EQ(both["answers"].size(), 2u);
  EXPECT_EQ(both["answers"][1],
            nlohmann::json::parse(R"({"lesson": "cycles", "step": 6, "tries": ["c"], "right": "c"})"));
}

// Without a file of their own, answers are kept where programs keep their state. Nothing is made there before
// the first answer, and two windows keep both their answers.
TEST(KeptAnswers, HaveAUsualPlace) {
  const TemporaryFolder folder;
  const auto placeWith = [](const char* state, const char* home) {
    state ? setenv("XDG_STATE_HOME", state, 1) : unsetenv("XDG_STATE_HOME");
    home ? setenv("HOME", home, 1) : unsetenv("HOME");
    return KeptAnswers::usualFile();
  };
  const char* const home = std::getenv("HOME");
  const std::string before = home ? home : "", file = placeWith(folder.file("s").c_str(), "/h");
  EXPECT_EQ(file, folder.file("s") + "/xnewell/answers.json");
  EXPECT_EQ(placeWith("relative", "/h"), "/h/.local/state/xnewell/answers.json");
  EXPECT_EQ(placeWith(nullptr, nullptr), "");
  static_cast<void>(placeWith(nullptr, home ? before.c_str() : nullptr));

  const Lesson lesson = readLesson(XNEWELL_DATA_DIR "/lessons/cycles.json");
  KeptAnswers one, other;
  one.keepIn(file), other.keepIn(file);
  EXPECT_FALSE(std::filesystem::exists(folder.file("s")));
  one.add(lesson, 2, 3);
  other.add(lesson, 5, 1);
  EXPECT_EQ(other.score("cycles"), "1 of 2 right at the first try");
  EXPECT_EQ(read(file)["answers"].size(), 2u);
}

}  // namespace xnewell::THIS_FILE
