#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/x11/support/lesson_window.h"

namespace xnewell::THIS_FILE {

// The controls of a lesson's steps and their keys.

namespace {

/// The control of the step with this key; null if there is none.
const Control* withKey(const Controls& controls, char key) {
  const auto found = std::ranges::find(controls, ControlId{key}, &Control::id);
  return found == controls.end() ? nullptr : &*found;
}

}  // namespace

// Only the letters of the step's controls, of its answers and of the lesson itself have an effect. Each
// control of a step has one.
TEST(LessonKeys, OnlyTheStepsControlsAct) {
  constexpr std::string_view kLessons = "2780we=";
  int idle = 0, acted = 0;
  forEachLesson([&](const std::string& name) {
    LessonWindow window;
    begin(window, name);
    for (int step = 0; step < static_cast<int>(window.bench.lesson()->steps.size()); ++step) {
      window.bench.goTo(step);
      const LessonStep& now = window.bench.lesson()->steps[static_cast<std::size_t>(step)];
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
  forEachLesson([&](const std::string& name) {
    LessonWindow window;
    begin(window, name);
    forEachState(window, [&](const std::string& place) {
      SCOPED_TRACE(place);
      std::set<std::string> taken;
      const KeyTable table = window.bench.keys();
      for (const KeyRow& row : table) {
        EXPECT_FALSE(row.does.empty());
        for (const Key& key : row.keys) EXPECT_TRUE(taken.insert(nameOf(key)).second) << nameOf(key);
      }
      const std::size_t others = window.bench.ownKeys().size();
      for (const Control& control : window.bench.controls())
        if (control.kind != Control::Kind::Button) {
          const KeyRow* const row = rowOf(table, control.key);
          ASSERT_TRUE(row);
          EXPECT_GE(row - table.data(), static_cast<std::ptrdiff_t>(others)) << control.key;
        }
      ++states;
    });
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

// The first control that the arrows change is selected when a step begins; Tab goes through all of them.
TEST(LessonKeys, TheFirstControlIsSelected) {
  LessonWindow window;
  begin(window, "specular");  // ks, n and light
  for (const char key : {'s', 'n', 'l', 's'}) {
    EXPECT_EQ(window.bench.list().focus(), ControlId{key});
    window.press(NamedKey::Tab);
  }
  window.bench.goTo(1);  // it offers nothing
  EXPECT_EQ(window.bench.list().focus(), std::nullopt);
  EXPECT_FALSE(window.press(NamedKey::Left));
}

// The step of the depth sort's run is changed like a number: by arrows, to its ends, and by typing.
TEST(LessonKeys, GoesThroughARun) {
  LessonWindow window;
  begin(window, "cycles");
  window.bench.goTo(1);
  const auto event = [&] {
    window.draw();
    return withKey(window.bench.controls(), 'v')->words;
  };
  const std::string at = event(), all = at.substr(at.find(" of "));
  window.press(NamedKey::Home);
  EXPECT_EQ(event(), "1" + all);
  window.press(NamedKey::Left);
  EXPECT_EQ(event(), "1" + all);
  window.press({NamedKey::Right, 0, true});
  EXPECT_EQ(event(), "11" + all);
  window.press(NamedKey::Down);
  EXPECT_EQ(event(), "10" + all);
  window.press(NamedKey::End);
  EXPECT_EQ(event(), all.substr(4) + all);
  window.press('=');
  ASSERT_TRUE(window.question);
  EXPECT_NE(window.question->take("0"), "");
  EXPECT_EQ(window.question->take("3"), "");
  EXPECT_EQ(event(), "3" + all);
}

// The page follows changes that were made elsewhere, as undo makes them.
TEST(LessonKeys, FollowsTheSetup) {
  LessonWindow window;
  begin(window, "colormap-tricks");
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
