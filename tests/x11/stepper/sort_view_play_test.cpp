#include <gtest/gtest.h>

#include <algorithm>

#include "tests/x11/support/stepper.h"
#include "x11/stepper/sort_view.h"

namespace xnewell::THIS_FILE {

// The stepper: how it plays and where it stops, and how it asks for predictions and keeps the score.

// The stepper plays at its speed. It stops at the end, at ticked kinds of step and at the chosen polygon, and
// nowhere else.
TEST(SortView, PlaysUntilAStop) {
  Stepper s{"nested-cycles"};
  s.press(NamedKey::Space);
  ASSERT_TRUE(s.bench.moving());
  for (int k = 0; k < 25; ++k) s.bench.tick();  // one second
  EXPECT_EQ(s.step(), static_cast<int>(kUsualSpeed));
  s.press(NamedKey::Space);
  EXPECT_FALSE(s.bench.moving());
  const auto playOn = [&] {
    s.press(NamedKey::Space);
    for (int k = 0; k < 100000 && s.bench.moving(); ++k) s.bench.tick();
    ASSERT_FALSE(s.bench.moving());
  };
  for (int k = 0; k < 5; ++k) {
    s.press(NamedKey::Home);
    s.press("b");
    s.press({NamedKey::Letter, static_cast<char>('1' + k)});
    for (const int step : s.stepsOf(static_cast<Landmark>(k))) {
      playOn();
      ASSERT_EQ(s.step(), step) << kToggleNames[k];
    }
    s.click(s.places().toggles[k].area);  // turned off again
  }
  s.press(NamedKey::Home);
  playOn();
  EXPECT_EQ(s.step(), s.run().steps());
  s.press("b6");  // asks for a polygon
  ASSERT_EQ(s.type("2"), "");
  s.press(NamedKey::Home);
  int stops = 0;
  for (int step = 1; step <= s.run().steps(); ++step) {
    if (!s.run().landmarks().has(s.run().scene(), 2, step)) continue;
    playOn();
    ASSERT_EQ(s.step(), step);
    ++stops;
  }
  EXPECT_GT(stops, 5);
  // At the end, playing begins again at the start.
  s.press(NamedKey::End);
  s.press(NamedKey::Space);
  EXPECT_EQ(s.step(), 0);
  s.press(NamedKey::Escape);
  EXPECT_FALSE(s.bench.moving());
}

// The keys for faster and slower stop at the slider's ends. The same number of notches back leads back.
TEST(SortView, SpeedHasEnds) {
  Stepper s{"cycle"};
  s.press("+++---");
  EXPECT_NEAR(s.bench.view().speed, kUsualSpeed, 1e-9);
  for (int k = 0; k < 100; ++k) s.press("+");
  EXPECT_EQ(s.bench.view().speed, kSpeeds.high);
  s.press(NamedKey::Space);
  s.bench.tick();  // 80 steps at once end at the last one
  EXPECT_EQ(s.step(), s.run().steps());
  for (int k = 0; k < 100; ++k) s.press("-");
  EXPECT_EQ(s.bench.view().speed, kSpeeds.low);
}

// Prediction asks at every pair whose extents overlap in x and y. It takes an answer by key or click, and
// keeps the score. The arrow shows the outcome without counting. Afterwards everything looks as it does
// without prediction.
TEST(SortView, PredictsAndKeepsTheScore) {
  Stepper s{"cycle"}, plain{"cycle"};
  s.press("y");
  int asked = 0, right = 0, told = 0;
  for (int step = 1; step <= s.run().steps(); ++step) {
    s.press(NamedKey::Right);
    plain.press(NamedKey::Right);
    ASSERT_EQ(s.step(), step);
    const bool question = s.event().kind == Event::Kind::Compare &&
                          s.event().test != xnewell::Test::XExtents &&
                          s.event().test != xnewell::Test::YExtents;
    ASSERT_EQ(s.bench.view().asking, question) << step;
    EXPECT_EQ(legendOf(s.bench.keys()).front().does, question ? "P first" : "step");
    if (!question) continue;
    EXPECT_NE(s.draw(), plain.draw());
    if (told == 0) {
      s.press(NamedKey::Right);
      ++told;
    } else {
      const int says = asked % 3;
      ++asked;
      right += says == static_cast<int>(s.event().verdict);
      if (says == 1)
        s.click(s.places().answers[1]);
      else
        s.press({NamedKey::Letter, kAnswerKeys[says]});
      EXPECT_EQ(static_cast<int>(*s.bench.view().answer), says);
    }
    ASSERT_EQ(s.step(), step) << "the answer is shown before the next step";
    EXPECT_FALSE(s.bench.view().asking);
    EXPECT_EQ(s.bench.view().score.asked, asked);
    EXPECT_EQ(s.bench.view().score.right, right);
  }
  EXPECT_GT(asked, 3);
  EXPECT_EQ(told, 1);
  s.press("y");
  s.press(NamedKey::Home);
  s.press("a");  // there is no question
  EXPECT_FALSE(s.taken);
}

}  // namespace xnewell::THIS_FILE
