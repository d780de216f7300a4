#include "x11/lessons/lesson_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/seeds.h"
#include "tests/x11/support/lesson_window.h"
#include "x11/app/workbench.h"
#include "x11/drawing/painter.h"

namespace xnewell {

// Lessons in the window: keys and pointer, what is hidden until an answer is given, and the room for words.

namespace {

constexpr std::array kSizes{glm::ivec2{800, 600}, glm::ivec2{1024, 768}, glm::ivec2{1600, 1200}};

/// A window in which the lesson has begun.
void begin(LessonWindow& window, const std::string& name) {
  window.bench.enter();
  window.bench.start(readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/" + name + ".json"));
  window.draw();
}

template <class Visit>
void forEachLesson(Visit&& visit) {
  for (const LessonEntry& entry : builtInLessons()) {
    SCOPED_TRACE(entry.name);
    visit(entry.name);
  }
}

IndexImage part(const IndexImage& image, const Rect& r) {
  IndexImage copy{r.width, r.height, 0};
  for (int j = 0; j < r.height; ++j) std::copy_n(image.row(r.y + j) + r.x, r.width, copy.row(j));
  return copy;
}

/// All of the window but the column of words.
IndexImage sight(const LessonWindow& window) {
  const Rect& body = window.layout.body;
  return part(window.image, {body.x, body.y, body.width - kLessonColumn - kMargin, body.height});
}

void click(LessonWindow& window, const Rect& at) {
  (void)window.bench.grab(at.x + at.width / 2, at.y + at.height / 2);
  window.bench.drop();
}

/// Visits every state of every step: as it appears first, with a hint, and with each answer given.
template <class Visit>
void forEachState(LessonWindow& window, Visit&& visit) {
  for (int step = 0; step < static_cast<int>(window.bench.lesson()->steps.size()); ++step) {
    window.bench.goTo(step);
    const std::string place = "step " + std::to_string(step + 1);
    window.draw();
    visit(place);
    const auto& question = window.bench.lesson()->steps[static_cast<std::size_t>(step)].question;
    if (!question) continue;
    window.press('h');
    window.draw();
    visit(place + ", hint");
    for (std::size_t k = 0; k < question->answers.size(); ++k) {
      window.press(static_cast<char>('a' + k));
      window.press(NamedKey::Return);
      window.draw();
      visit(place + ", answer " + std::to_string(k));
    }
  }
}

}  // namespace

// Each step of each lesson looks the same on the way forth and on the way back.
TEST(LessonBench, GoesForthAndBack) {
  int steps = 0;
  forEachLesson([&](const std::string& name) {
    LessonWindow window;
    begin(window, name);
    const int last = static_cast<int>(window.bench.lesson()->steps.size()) - 1;
    std::vector<IndexImage> seen{window.image};
    std::vector<Palette> colors{window.palette};
    for (int step = 1; step <= last; ++step) {
      EXPECT_TRUE(window.press(NamedKey::PageDown));
      EXPECT_EQ(window.bench.step(), step);
      seen.push_back(window.draw());
      colors.push_back(window.palette);
      EXPECT_NE(seen.back(), seen[seen.size() - 2]);
    }
    for (int step = last - 1; step >= 0; --step) {
      EXPECT_TRUE(window.press(NamedKey::PageUp));
      EXPECT_EQ(window.draw(), seen[static_cast<std::size_t>(step)]);
      EXPECT_EQ(window.palette, colors[static_cast<std::size_t>(step)]);
      ++steps;
    }
    window.press(NamedKey::PageUp);
    EXPECT_EQ(window.bench.step(), 0);
    EXPECT_FALSE(window.notice.empty());
  });
  EXPECT_GE(steps, 30);
}

// Until an answer is given, the picture does not change and no words of an answer show. Choosing another
// answer asks again, just as at first.
TEST(LessonBench, HidesTheOutcomeUntilAnAnswerIsGiven) {
  int answers = 0, changed = 0;
  forEachLesson([&](const std::string& name) {
    LessonWindow window;
    begin(window, name);
    for (int step = 0; step < static_cast<int>(window.bench.lesson()->steps.size()); ++step) {
      const LessonStep& asked = window.bench.lesson()->steps[static_cast<std::size_t>(step)];
      if (!asked.question) continue;
      window.bench.goTo(step);
      window.draw();
      const IndexImage before = sight(window);
      for (std::size_t k = 0; k < asked.question->answers.size(); ++k) {
        SCOPED_TRACE(asked.question->answers[k].text);
        window.press(static_cast<char>('a' + k));
        window.draw();
        EXPECT_EQ(sight(window), before);
        EXPECT_EQ(window.bench.page().question->says, "");
        EXPECT_EQ(window.setup().picture, asked.exhibit.settings);
        window.press(NamedKey::Return);
        window.draw();
        EXPECT_FALSE(window.bench.page().question->says.empty());
        EXPECT_EQ(window.setup().picture, asked.question->answers[k].shown.settings);
        changed += sight(window) != before;
        ++answers;
      }
    }
  });
  EXPECT_GE(answers, 50);
  EXPECT_GE(changed, answers * 9 / 10);
}

// A step that was answered looks as it was left when it is visited again.
TEST(LessonBench, AnswersAreRememberedByStep) {
  LessonWindow window;
  begin(window, "cycles");
  window.bench.goTo(2);
  window.press('b');
  window.press(NamedKey::Return);
  const IndexImage given = window.draw();
  window.press(NamedKey::PageDown);
  window.draw();
  window.press(NamedKey::PageUp);
  EXPECT_EQ(window.draw(), given);
}

TEST(LessonBench, ReturnAsksForAnAnswerAndThenGoesOn) {
  LessonWindow window;
  begin(window, "cycles");
  window.bench.goTo(2);
  window.press(NamedKey::Return);
  EXPECT_FALSE(window.notice.empty());
  EXPECT_EQ(window.bench.step(), 2);
  window.press('d');
  window.press(NamedKey::Return);
  EXPECT_EQ(window.bench.step(), 2);
  window.press(NamedKey::Return);
  EXPECT_EQ(window.bench.step(), 3);
  window.bench.goTo(2);
  window.press(NamedKey::PageDown);  // without an answer
  EXPECT_EQ(window.bench.step(), 3);
}

// Only the letters of the step's controls, of its answers and of the lesson itself have an effect. Each
// control of a step has one.
TEST(LessonBench, OnlyTheStepsControlsAct) {
  constexpr std::string_view kWindows = "uUr?q134567";  // keys of all views
  int idle = 0, acted = 0;
  forEachLesson([&](const std::string& name) {
    LessonWindow window;
    begin(window, name);
    for (int step = 0; step < static_cast<int>(window.bench.lesson()->steps.size()); ++step) {
      const LessonStep& now = window.bench.lesson()->steps[static_cast<std::size_t>(step)];
      for (char letter = '!'; letter <= '~'; ++letter) {
        if (kWindows.find(letter) != std::string_view::npos || letter == 'l' || letter == '2') continue;
        const auto* const row = std::ranges::find(kLessonControls, letter, &LessonControlRow::key);
        const bool offered =
            row != kLessonControls.end() && std::ranges::find(now.controls, row->id) != now.controls.end();
        if (now.question && (letter == 'h' || (letter >= 'a' && letter <= 'd'))) continue;
        SCOPED_TRACE(std::to_string(step) + letter);
        window.bench.goTo(step);
        if (!offered) {
          const xnewell::Setup before = window.setup();
          EXPECT_TRUE(window.press(letter));  // the key does not reach the window either
          EXPECT_EQ(window.setup(), before);
          EXPECT_EQ(window.bench.step(), step);
          ++idle;
          continue;
        }
        const IndexImage before = window.draw();
        const Palette colors = window.palette;
        EXPECT_TRUE(window.press(letter));
        if (takesArrows(row->id)) {
          window.press(NamedKey::Right);
          if (row->id == LessonControl::Shades) window.press(NamedKey::Left), window.press(NamedKey::Left);
        }
        if (window.bench.moving()) window.bench.tick();
        EXPECT_TRUE(window.draw() != before || window.palette != colors);
        ++acted;
      }
    }
  });
  EXPECT_GT(idle, 2000);
  EXPECT_GE(acted, 40);
}

// Leaving a lesson brings back the window's own scene and setup.
TEST(LessonBench, LeavingClosesWhatItOpened) {
  LessonWindow window;
  begin(window, "specular");
  window.press(NamedKey::Right);
  EXPECT_GE(window.opened, 1);
  EXPECT_TRUE(window.press(NamedKey::Escape));
  EXPECT_EQ(window.closed, 1);
  EXPECT_EQ(window.view, WindowView::Picture);
  EXPECT_EQ(window.setup(), window.own);
  window.bench.enter();  // at the step that was left
  EXPECT_EQ(window.bench.lesson()->name, "specular");
  EXPECT_EQ(window.pictures->scene().name.find("lesson 3 of "), 0U);
}

TEST(LessonBench, TheListOpensLessons) {
  LessonWindow window;
  window.bench.enter();
  EXPECT_TRUE(window.bench.showsList());
  window.draw();
  const std::vector<LessonEntry> entries = builtInLessons();
  ASSERT_EQ(window.bench.rows().size(), entries.size());
  window.press(NamedKey::Down);
  window.press(NamedKey::Down);
  window.press(NamedKey::Up);
  const IndexImage second = window.draw();
  window.press(NamedKey::Return);
  EXPECT_EQ(window.bench.lesson()->name, entries[1].name);
  EXPECT_FALSE(window.bench.showsList());
  window.draw();
  window.press('l');
  EXPECT_TRUE(window.bench.showsList());
  window.press(NamedKey::Escape);
  EXPECT_FALSE(window.bench.showsList());
  window.press('l');
  window.draw();
  click(window, window.bench.rows().back());
  EXPECT_EQ(window.bench.lesson()->name, entries.back().name);
  window.bench.goTo(static_cast<int>(window.bench.lesson()->steps.size()) - 1);
  window.press(NamedKey::PageDown);
  EXPECT_TRUE(window.bench.showsList());  // after the last step of the last lesson
  window.bench.start(readLesson(entries[0].file));
  window.bench.goTo(static_cast<int>(window.bench.lesson()->steps.size()) - 1);
  window.press(NamedKey::PageDown);
  EXPECT_EQ(window.bench.lesson()->name, entries[1].name);
  EXPECT_EQ(window.bench.step(), 0);
}

// The pointer does what keys do.
TEST(LessonBench, ThePointerDoesTheSame) {
  LessonWindow keys, pointer;
  begin(keys, "cycles");
  begin(pointer, "cycles");
  const auto same = [&] { EXPECT_EQ(pointer.draw(), keys.draw()); };
  for (int step = 0; step < 2; ++step) {
    keys.press(NamedKey::PageDown);
    click(pointer, pointer.bench.layout().next);
    same();
  }
  keys.press('b');
  click(pointer, pointer.bench.layout().answers[1]);
  same();
  keys.press(NamedKey::Return);
  click(pointer, pointer.bench.layout().answer);
  same();
  keys.press('N');
  Rect names = pointer.bench.layout().controls[0];
  names.width = 2 * 90;
  click(pointer, names);
  same();
  keys.press(NamedKey::PageUp);
  click(pointer, pointer.bench.layout().back);
  same();

  LessonWindow sliders;
  begin(sliders, "specular");
  const Rect ks = sliders.bench.layout().controls[0];
  EXPECT_TRUE(sliders.bench.grab(ks.x + 84, ks.y + 8));
  EXPECT_EQ(sliders.setup().picture.light.ks, 0.0);
  sliders.bench.dragTo(ks.x + 84 + 84, ks.y + 40);
  EXPECT_EQ(sliders.setup().picture.light.ks, 0.5);
  sliders.bench.dragTo(2000, 0);
  EXPECT_EQ(sliders.setup().picture.light.ks, 1.0);
  sliders.bench.drop();

  LessonWindow turned;
  begin(turned, "cycles");
  const CameraSettings before = turned.setup().picture.camera;
  EXPECT_TRUE(turned.bench.grab(200, 200));
  turned.bench.dragTo(240, 210);
  EXPECT_NE(turned.setup().picture.camera, before);
  turned.bench.drop();
  turned.bench.goTo(1);  // this step does not offer turning
  turned.draw();
  EXPECT_FALSE(turned.bench.grab(200, 200));
}

// No text leaves its place, in any state of any step, in the smallest window or in larger ones.
TEST(LessonBench, AllTextsHaveRoom) {
  int states = 0, sizes = 0;
  for (const glm::ivec2 size : kSizes) {
    if (kSanitized && size != kSizes[0]) continue;
    ++sizes;
    forEachLesson([&](const std::string& name) {
      LessonWindow window{size};
      begin(window, name);
      forEachState(window, [&](const std::string& place) {
        SCOPED_TRACE(place + " at " + std::to_string(size.x));
        const LessonLayout& at = window.bench.layout();
        EXPECT_LE(at.end, at.back.y - 4);
        EXPECT_LE(at.back.y + at.back.height, window.layout.body.y + window.layout.body.height);
        const int right = at.column.x + at.column.width;
        for (const auto* lines : {&at.words, &at.asks, &at.after})
          for (const auto& line : *lines) EXPECT_LE(line.x + textWidth(line.text), right) << line.text;
        for (const auto& lines : at.answerLines)
          for (const std::string& line : lines) EXPECT_LE(at.column.x + 64 + textWidth(line), right) << line;
        EXPECT_THAT(tooWide(window.bench.page()), testing::IsEmpty());
        EXPECT_LE(textWidth(window.bench.status() + "   " + window.bench.aside()), size.x * 2 / 3);
        ++states;
      });
    });
  }
  EXPECT_GT(states, 100 * sizes);
}

// Every line of the list ends within the window.
TEST(LessonBench, TheListHasRoom) {
  for (const glm::ivec2 size : kSizes) {
    LessonWindow window{size};
    window.bench.enter();
    window.draw();
    const Rect& body = window.layout.body;
    EXPECT_LE(window.bench.rows().back().y + window.bench.rows().back().height, body.y + body.height);
    for (const LessonEntry& entry : builtInLessons())
      EXPECT_LE(48 + textWidth(entry.shows), body.width) << entry.shows;
  }
}

// In the workbench, key 7 shows the list, a lesson brings its scene, and Esc brings back the window's own.
TEST(LessonBench, InTheWindow) {
  Workbench window{readScene("teapot", 3), {}, {}};
  window.resize(1024, 768);
  const auto settle = [&] {
    for (int k = 0; k < 4 && window.stale() != Workbench::Stale::Nothing; ++k) window.update();
    ASSERT_EQ(window.stale(), Workbench::Stale::Nothing);
  };
  window.press({NamedKey::Letter, 'S'});
  window.press({NamedKey::Letter, 'S'});
  settle();
  const xnewell::Setup own = window.setup();
  const IndexImage before = window.image();
  window.press({NamedKey::Letter, '7'});
  settle();
  EXPECT_EQ(window.view(), WindowView::Lesson);
  window.press({NamedKey::Return});
  settle();
  EXPECT_NE(window.setup(), own);
  std::set<std::vector<std::uint8_t>> seen;
  for (int step = 0; step < 4; ++step) {
    seen.insert(window.image().pixels);
    window.press({NamedKey::PageDown});
    settle();
  }
  EXPECT_EQ(seen.size(), 4U);
  window.press({NamedKey::Letter, 'e'});  // the shades, in this step
  window.press({NamedKey::Left});
  EXPECT_EQ(window.setup().picture.table.shades, 240);  // step 5 offers no control
  const std::string ofLesson = window.picture().scene().name;
  window.press({NamedKey::Letter, '2'});
  settle();
  EXPECT_EQ(window.view(), WindowView::DepthSort);
  EXPECT_EQ(window.picture().scene().name, ofLesson);
  window.press({NamedKey::Escape});
  settle();
  EXPECT_EQ(window.view(), WindowView::Lesson);
  window.press({NamedKey::Escape});
  settle();
  EXPECT_EQ(window.view(), WindowView::Picture);
  EXPECT_EQ(window.setup(), own);
  EXPECT_EQ(window.picture().scene().name, "teapot");
  // All of the window but the times in the status line.
  for (int j = 0; j < window.layout().status.y; ++j)
    ASSERT_TRUE(std::equal(before.row(j), before.row(j) + before.width, window.image().row(j))) << j;
}

}  // namespace xnewell
