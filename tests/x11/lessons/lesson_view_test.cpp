#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/seeds.h"
#include "tests/x11/support/lesson_window.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/painter.h"
#include "x11/lessons/lesson_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// All of the window but the column of words.
IndexImage drawn(const LessonWindow& window) {
  const Rect& body = window.layout.body;
  return partOf(window.image, {body.x, body.y, body.width - kLessonColumn - kMargin, body.height});
}

void click(LessonWindow& window, const Rect& at) {
  (void)window.bench.grab(at.x + at.width / 2, at.y + at.height / 2);
  window.bench.drop();
}

/// The place of a control of the step.
const ControlPlace& placeOf(const LessonWindow& window, char key) { return *window.bench.list().find({key}); }

/// Rows of the list, in its order.
std::vector<Rect> rowsOfList(const LessonWindow& window) {
  std::vector<Rect> rows;
  for (const auto& [id, place] : window.bench.list().places()) rows.push_back(place.area);
  return rows;
}

/// One-line texts that are wider than their room in the column.
std::vector<std::string> tooWide(LessonWindow& window) {
  std::vector<std::string> found;
  const auto need = [&](bool fits, const std::string& text) {
    if (!fits) found.push_back(text);
  };
  const std::string& heading = window.bench.page().heading;
  need(textWidth(heading, Voice::Title) <= kLessonColumn, heading);
  for (const Control& control : window.bench.controls()) {
    const ControlPlace* const at = window.bench.list().find(control.id());
    if (!at || at->bare) continue;
    const int value = at->x + at->style.value, right = at->x + at->style.width;
    need(at->x + at->style.label + textWidth(control.label) <= value - 4, control.label);
    need(textWidth(control.words) <= right - value - 18, control.words);
    if (control.kind == Control::Kind::Slider) {
      const std::string text = textOf(control.range, control.value);
      need(at->track.x + at->track.width + 7 + textWidth(text) <= right, text);
    }
    const auto wordsEnd = [](const Rect& frame) { return frame.x + frame.width - 7; };
    for (std::size_t k = 0; k < at->options.size(); ++k) {
      const Rect& frame = at->options[k];
      need(wordsEnd(frame) <= right, control.options[k]);
      if (k > 0 && frame.y == at->options[k - 1].y)
        need(frame.x + 6 - wordsEnd(at->options[k - 1]) >= 6, control.options[k]);
    }
  }
  return found;
}

/// The control of the step with this key; null if there is none.
const Control* withKey(const Controls& controls, char key) {
  const auto found = std::ranges::find(controls, ControlId{key}, &Control::id);
  return found == controls.end() ? nullptr : &*found;
}

}  // namespace

// Lessons in the window: keys and pointer, the steps' controls, what is hidden until an answer is given, and
// the room for words.

// Each step of each lesson looks the same on the way forth and on the way back.
TEST(LessonView, GoesForthAndBack) {
  int steps = 0;
  forEachLesson([&](LessonWindow& window) {
    const int last = static_cast<int>(window.steps().size()) - 1;
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
      EXPECT_EQ(window.draw(), seen[step]);
      EXPECT_EQ(window.palette, colors[step]);
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
TEST(LessonView, HidesTheOutcomeUntilAnAnswerIsGiven) {
  int answers = 0, changed = 0;
  forEachLesson([&](LessonWindow& window) {
    for (int step = 0; step < static_cast<int>(window.steps().size()); ++step) {
      const LessonStep& asked = window.steps()[step];
      if (!asked.question) continue;
      window.goTo(step);
      const IndexImage before = drawn(window);
      for (std::size_t k = 0; k < asked.question->answers.size(); ++k) {
        SCOPED_TRACE(asked.question->answers[k].text);
        window.press(static_cast<char>('a' + k));
        window.draw();
        EXPECT_EQ(drawn(window), before);
        EXPECT_EQ(window.bench.page().question->says, "");
        EXPECT_EQ(window.setup().picture, asked.figure.settings);
        window.press(NamedKey::Return);
        window.draw();
        EXPECT_FALSE(window.bench.page().question->says.empty());
        EXPECT_EQ(window.setup().picture, asked.question->answers[k].shown.settings);
        changed += drawn(window) != before;
        ++answers;
      }
    }
  });
  EXPECT_GE(answers, 50);
  EXPECT_GE(changed, answers * 9 / 10);
}

// The angles at a stage stand beside a question about its light, but their outcome, in red, does not.
TEST(LessonView, AnglesDoNotTellTheOutcome) {
  int told = 0, asked = 0;
  LessonWindow window{"shading-before-shearing"};
  const auto alarms = [&] {
    return std::ranges::count(drawn(window).pixels, CellPlan{window.setup().picture.table.kind}[Cell::Alarm]);
  };
  for (int step = 0; step < static_cast<int>(window.steps().size()); ++step) {
    const LessonStep& now = window.steps()[step];
    if (!now.question || now.figure.shadedIn != ViewStage::World) continue;
    window.goTo(step);
    EXPECT_EQ(alarms(), 0) << step;
    ++asked;
    window.answer('a');
    told += alarms() > 0;
  }
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(told, 2);  // a turn keeps the light
}

// Esc brings back the picture that the window had before the lesson.
TEST(LessonView, EscBringsThePictureBack) {
  ReadyWorkbench window;
  const IndexImage before = window.aboveStatus();
  window.does('7');
  window.does(NamedKey::Return);
  EXPECT_NE(window.aboveStatus(), before);
  window.does(NamedKey::Escape);
  EXPECT_EQ(window.aboveStatus(), before);
}

// A step that was answered looks as it was left when it is visited again.
TEST(LessonView, AnAnswerStays) {
  LessonWindow window{"cycles"};
  window.goTo(2);
  window.answer('d');
  const IndexImage given = window.image;
  window.press(NamedKey::Return);
  EXPECT_EQ(window.bench.step(), 3);
  window.draw();
  window.press(NamedKey::PageUp);
  EXPECT_EQ(window.draw(), given);
}

TEST(LessonView, TheListOpensLessons) {
  LessonWindow window;
  window.bench.enter();
  window.draw();
  const std::vector<LessonEntry> entries = builtInLessons();
  ASSERT_EQ(rowsOfList(window).size(), entries.size());
  EXPECT_FALSE(window.press('S'));
  for (const NamedKey key : {NamedKey::Down, NamedKey::Home, NamedKey::Down, NamedKey::Down, NamedKey::Up})
    window.press(key);
  window.press(NamedKey::Return);
  EXPECT_EQ(window.bench.lesson()->name, entries[1].name);
  EXPECT_FALSE(window.bench.showsList());
  window.draw();
  for (const auto& [key, shows] : {std::pair{Key{'7'}, true},
                                   {Key{NamedKey::Escape}, false},
                                   {Key{'7'}, true},
                                   {Key{'7'}, false},
                                   {Key{'7'}, true}}) {
    window.press(key);
    EXPECT_EQ(window.bench.showsList(), shows);
  }
  window.draw();
  click(window, rowsOfList(window).back());
  EXPECT_EQ(window.bench.lesson()->name, entries.back().name);
  // After the last step the list says that the lesson is done, and offers the next, if there is one.
  for (const std::size_t k : {entries.size() - 1, std::size_t{0}}) {
    window.bench.start(readLesson(entries[k].file));
    window.bench.goTo(static_cast<int>(window.steps().size()) - 1);
    window.press(NamedKey::PageDown);
    EXPECT_TRUE(window.bench.showsList());
  }
  window.press(NamedKey::Return);
  EXPECT_EQ(window.bench.lesson()->name, entries[1].name);
  EXPECT_EQ(window.bench.step(), 0);
}

// The pointer does what keys do.
TEST(LessonView, ThePointerDoesTheSame) {
  LessonWindow keys{"cycles"}, pointer{"cycles"};
  const auto same = [&](const Key& key, const Rect& at) {
    keys.press(key);
    click(pointer, at);
    for (LessonWindow* window : {&keys, &pointer}) window->bench.hover(0, 0);
    EXPECT_EQ(pointer.draw(), keys.draw());
  };
  for (int step = 0; step < 2; ++step) same(NamedKey::PageDown, pointer.bench.layout().next);
  same('b', pointer.bench.layout().answers[1]);
  same(NamedKey::Return, pointer.bench.layout().answer);
  same('M', placeOf(pointer, 'M').box);
  same(NamedKey::PageUp, pointer.bench.layout().back);

  LessonWindow turned{"cycles"};
  const CameraSettings before = turned.setup().picture.camera;
  EXPECT_TRUE(turned.bench.grab(200, 200));
  turned.bench.dragTo(240, 210);
  EXPECT_NE(turned.setup().picture.camera, before);
  turned.bench.drop();
  turned.bench.goTo(1);  // this step does not offer turning
  turned.draw();
  EXPECT_FALSE(turned.bench.grab(200, 200));
}

// No text leaves its place, in any state of any step, and every line of the list ends within the window: in
// the smallest one and in larger ones.
TEST(LessonView, AllTextsHaveRoom) {
  int states = 0, sizes = 0;
  for (const glm::ivec2 size : someOf(kSizes, 1)) {
    SCOPED_TRACE(size.x);
    ++sizes;
    const auto expectRoom = [&](LessonWindow& window) {
      const LessonLayout& at = window.bench.layout();
      EXPECT_LE(at.end, at.back.y - 4);
      EXPECT_LE(at.back.y + at.back.height, window.layout.body.y + window.layout.body.height);
      const int right = at.column.x + at.column.width;
      for (const auto* lines : {&at.words, &at.asks, &at.after})
        for (const auto& line : *lines) EXPECT_LE(line.x + textWidth(line.text), right) << line.text;
      for (const auto& lines : at.answerLines)
        for (const std::string& line : lines) EXPECT_LE(at.column.x + 64 + textWidth(line), right) << line;
      EXPECT_THAT(tooWide(window), testing::IsEmpty());
      EXPECT_LE(textWidth(window.bench.status() + "   " + window.bench.aside()), size.x * 2 / 3);
      ++states;
    };
    forEachState(expectRoom, size);
    LessonWindow window{size};
    window.bench.enter();
    window.draw();
    const Rect &body = window.layout.body, last = rowsOfList(window).back();
    EXPECT_LE(last.y + last.height, body.y + body.height);
    for (const LessonEntry& entry : builtInLessons())
      EXPECT_LE(48 + textWidth(entry.shows), body.width) << entry.shows;
  }
  EXPECT_GT(states, 100 * sizes);
}

// Only the letters of the step's controls, of its answers and of the lesson itself have an effect. Each
// control of a step has one.
TEST(LessonKeys, OnlyTheStepsControlsAct) {
  constexpr std::string_view kLessons = "2780we=";
  int idle = 0, acted = 0;
  forEachLesson([&](LessonWindow& window) {
    for (int step = 0; step < static_cast<int>(window.steps().size()); ++step) {
      window.bench.goTo(step);
      const LessonStep& now = window.steps()[step];
      std::string offered;
      window.draw();
      for (char letter = '!'; letter <= '~'; ++letter) {
        if (kLessons.find(letter) != std::string_view::npos) continue;
        if (now.question && (letter == 'h' || (letter >= 'a' && letter <= 'd'))) continue;
        if (withKey(window.bench.controls(), letter)) {
          offered += letter;
          continue;
        }
        SCOPED_TRACE(std::to_string(step) + letter);
        EXPECT_FALSE(window.press(letter));
        EXPECT_FALSE(window.bench.late(window.setup()));
        EXPECT_EQ(window.bench.step(), step);
        ++idle;
      }
      for (const char letter : offered) {
        SCOPED_TRACE(std::to_string(step) + letter);
        window.bench.goTo(step);
        const IndexImage before = window.draw();
        const Palette colors = window.palette;
        const bool takesArrows = withKey(window.bench.controls(), letter)->takesArrows();
        EXPECT_TRUE(window.press(letter));
        if (takesArrows) {
          window.press(NamedKey::Right);
          if (letter == 'c') window.press(NamedKey::Left), window.press(NamedKey::Left);
        }
        if (window.bench.moving()) window.bench.tick();
        EXPECT_TRUE(window.draw() != before || window.palette != colors);
        ++acted;
      }
      const std::vector<char> keys = now.controls;  // goTo() may replace the step
      for (const char key : keys) EXPECT_TRUE(withKey(window.bench.controls(), key)) << key;
    }
  });
  EXPECT_GT(idle, 2000);
  EXPECT_GE(acted, 40);
}

// In every state of every step no key stands twice in the table, each has words, and each control has a key
// of its own.
TEST(LessonKeys, KeysAreUniqueAndExplained) {
  int states = 0;
  forEachState([&](LessonWindow& window) {
    std::set<std::string> taken;
    const KeyTable table = window.bench.keys();
    for (const KeyRow& row : table) {
      EXPECT_FALSE(row.does.empty());
      for (const Key& key : row.keys) EXPECT_TRUE(taken.insert(nameOf(key)).second) << nameOf(key);
    }
    const auto others = static_cast<std::ptrdiff_t>(window.bench.ownKeys().size());
    for (const Control& control : window.bench.controls())
      if (control.kind != Control::Kind::Button) {
        const KeyRow* const row = rowOf(table, control.key);
        ASSERT_TRUE(row);
        EXPECT_GE(row - table.data(), others) << control.key;
      }
    ++states;
  });
  EXPECT_GT(states, 100);
}

// A lesson has the same letters as the views. Where a letter chooses an answer, the control has another one.
TEST(LessonKeys, AnswersKeepTheirLetters) {
  const auto keysWith = [](int answers) {
    std::string list;
    for (int k = 0; k < answers; ++k)
      list += std::string{k > 0 ? ", " : ""} + R"({"text": "t", "says": "s", "shown": {}, "holds": )" +
              (k == 0 ? "true" : "false") + "}";
    LessonWindow window;
    window.bench.enter();
    window.bench.start(parseLesson(
        R"({"title": "t", "steps": [{"heading": "h", "caption": ["c"], "scene": "sticks",
            "controls": ["ka", "kd", "shades", "light"])" +
            (answers > 0 ? R"(, "question": {"asks": "q", "answers": [)" + list + "]}" : "") + "}]}",
        "l.json", std::filesystem::path{XNEWELL_DATA_DIR} / "lessons"));
    window.draw();
    std::string keys;
    for (const Control& control : window.bench.controls())
      if (control.kind != Control::Kind::Button) {
        keys += control.key;
        EXPECT_TRUE(window.press(control.key));
        EXPECT_EQ(window.bench.list().focus(), control.id());
        EXPECT_FALSE(window.bench.page().question && window.bench.page().question->chosen);
      }
    return keys;
  };
  EXPECT_EQ(keysWith(0), "adcl");
  EXPECT_EQ(keysWith(2), "kdcl");
  EXPECT_EQ(keysWith(3), "kdxl");
  EXPECT_EQ(keysWith(4), "kfxl");
}

// The page follows changes that were made elsewhere, as undo makes them.
TEST(LessonKeys, FollowsTheSetup) {
  LessonWindow window{"colormap-tricks"};
  const IndexImage before = window.draw();
  const xnewell::Setup first = window.setup();
  window.press('H');
  window.draw();
  EXPECT_FALSE(window.bench.late(window.setup()));
  window.change('u', [&](xnewell::Setup& s) { s = first; });
  EXPECT_TRUE(window.bench.late(window.setup()));
  EXPECT_EQ(window.draw(), before);
}

}  // namespace xnewell::THIS_FILE
