#include <gtest/gtest.h>

#include "depthsort/record/explain.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/lessons/lesson_figure.h"
#include "x11/window/layout.h"

namespace xnewell::THIS_FILE {

// What lessons say is what the program shows.

namespace {

constexpr std::array kSizes{glm::ivec2{800, 540}, glm::ivec2{800, 600}, glm::ivec2{1024, 768},
                            glm::ivec2{1600, 1200}};

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

}  // namespace

// Each claim of each step and of each answer holds, in windows of several sizes.
TEST(LessonClaims, Hold) {
  int claims = 0;
  forEachFigure([&](const std::string& place, const StepFigure& figure) {
    if (figure.claims.empty()) return;
    for (const glm::ivec2 size : someOf(kSizes, 1)) {
      Shown shown{figure, size};
      ShownFigure facts = shown.facts();
      for (const Claim& claim : figure.claims) {
        const FactRow& fact = allFacts()[static_cast<std::size_t>(claim.fact)];
        EXPECT_TRUE(facts.holds(claim))
            << place << ", at " << size.x << ": " << fact.name << " is " << facts.text(fact);
        ++claims;
      }
    }
  });
  EXPECT_GT(claims, kSanitized ? 66 : 200);
}

// The steps of the depth sort that lessons mention exist and are what the lesson says.
TEST(LessonClaims, EventsAreThere) {
  int events = 0;
  forEachFigure([&](const std::string& place, const StepFigure& figure) {
    if (figure.stage != View::DepthSort) return;
    for (const glm::ivec2 size : someOf(kSizes, 1)) {
      SCOPED_TRACE(place + ", at " + std::to_string(size.x));
      Shown shown{figure, size};
      const Picture picture = shown.picture->withPlanes();
      const SortedScene run = textbookRun(picture);
      const std::optional<int> step = stepOf(run, figure.event);
      ASSERT_TRUE(step);
      const Explainer explainer{picture.scene().mesh, picture.snapped(), run, true};
      const std::string sentence = explainer.sentence(run.events[static_cast<std::size_t>(*step - 1)], 0);
      EXPECT_NE(sentence.find(figure.event.says), std::string::npos) << sentence;
      ++events;
    }
  });
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

// Every fact has words.
TEST(LessonFacts, AllHaveWords) {
  const Lesson lesson = readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/mach-bands.json");
  Shown shown{lesson.steps[2].figure, kSizes[0]};
  ShownFigure facts = shown.facts();
  for (const FactRow& row : allFacts())
    if (row.needs != FactNeeds::Beside) {
      EXPECT_FALSE(facts.text(row).empty());
    }
}

TEST(LessonFacts, SayWhereThereIsNone) {
  const Lesson lesson = readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/mach-bands.json");
  StepFigure figure = lesson.steps[0].figure;
  const Claim claim{.fact = *factNamed("ratio"), .is = {}, .least = 0.0};
  for (const TableKind kind : {TableKind::Linear, TableKind::Corrected}) {
    figure.settings.table.kind = kind;
    Shown shown{figure, kSizes[0]};
    ShownFigure facts = shown.facts();
    EXPECT_EQ(facts.text(allFacts()[static_cast<std::size_t>(claim.fact)]) == "none",
              kind == TableKind::Linear);
    EXPECT_EQ(facts.holds(claim), kind == TableKind::Corrected);
  }
}

TEST(LessonFacts, FillWords) {
  const Lesson lesson = readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/cycles.json");
  Shown shown{lesson.steps[0].figure, kSizes[1]};
  ShownFigure facts = shown.facts();
  EXPECT_EQ(facts.filled("{cuts} cut, {painted} parts of {polygons}"), "1 cut, 4 parts of 3");
  EXPECT_EQ(checkPlaceholders("{cuts} and {wrong samples}"), "");
  EXPECT_EQ(checkPlaceholders("a } b"), "a } without a {");
  EXPECT_EQ(checkPlaceholders("a { b"), "a { without a }");
  EXPECT_TRUE(checkPlaceholders("{cats}").starts_with("there is no fact 'cats'; the facts are polygons, "));
}

}  // namespace xnewell::THIS_FILE
