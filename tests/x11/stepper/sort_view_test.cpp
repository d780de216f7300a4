#include "x11/stepper/sort_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shading/scene/units.h"
#include "tests/x11/support/stepper.h"

namespace xnewell::THIS_FILE {

// The depth-sort stepper: its keys, its pointer and its runs. Playing and predicting:
// sort_view_play_test.cpp. What it draws: sort_page_test.cpp.

// Arrows step by one, or by ten with Shift, but never beyond the ends. Home and End go to the ends.
TEST(SortView, ArrowsStep) {
  Stepper s{"cycle"};
  const int steps = s.run().steps();
  ASSERT_GT(steps, 12);
  EXPECT_EQ(s.step(), 0);
  s.press(NamedKey::Left);
  EXPECT_EQ(s.step(), 0);
  s.press(NamedKey::Right);
  EXPECT_EQ(s.step(), 1);
  s.press(NamedKey::Right, true);
  EXPECT_EQ(s.step(), 11);
  s.press(NamedKey::Left);
  EXPECT_EQ(s.step(), 10);
  s.press(NamedKey::Left, true);
  EXPECT_EQ(s.step(), 0);
  s.press(NamedKey::End);
  EXPECT_EQ(s.step(), steps);
  s.press(NamedKey::Right);
  EXPECT_EQ(s.step(), steps);
  s.press(NamedKey::Home);
  EXPECT_EQ(s.step(), 0);
  EXPECT_TRUE(s.taken);
  s.press("X");
  EXPECT_FALSE(s.taken);
  EXPECT_EQ(s.notices.size(), 2u) << "one for each end";
}

// With the speed selected, the arrows up and down change it, and left and right still step. Esc selects the
// timeline again, where up is a step forward.
TEST(SortView, TheSelectedControlHasTheArrows) {
  Stepper s{"cycle"};
  s.bench.enter();
  s.press(NamedKey::Up);
  EXPECT_EQ(s.step(), 1);
  const IndexImage timeline = s.draw();
  s.press(NamedKey::Tab);
  EXPECT_NE(s.draw(), timeline) << "it is marked";
  s.press(NamedKey::Up);
  EXPECT_NEAR(s.bench.view().speed, kUsualSpeed * std::sqrt(2.0), 0.01);
  s.press(NamedKey::Down);
  EXPECT_NEAR(s.bench.view().speed, kUsualSpeed, 1e-9);
  s.press(NamedKey::Right);
  EXPECT_EQ(s.step(), 2);
  s.press("=");
  EXPECT_NE(s.type("0.1").find("from 0.50 to 2000.00"), std::string::npos);
  EXPECT_EQ(s.type("8"), "");
  EXPECT_EQ(s.bench.view().speed, 8);
  s.press(NamedKey::Escape);
  s.press(NamedKey::Down);
  EXPECT_EQ(s.step(), 1);
  EXPECT_EQ(s.bench.view().speed, 8);
}

// After `b` the digits tick boxes, for one key. Any other key does what it always does, and Esc nothing.
TEST(SortView, DigitsTickBoxesForOneKey) {
  Stepper s{"cycle"};
  const auto ticked = [&] { return std::ranges::count(s.bench.view().stops, true); };
  s.press("2");
  EXPECT_FALSE(s.taken) << "it is another view";
  s.press("b");
  const IndexImage numbered = s.draw();
  s.press("2");
  EXPECT_TRUE(s.bench.view().stops[1]);
  EXPECT_NE(s.draw(), numbered);
  s.press("3");
  EXPECT_FALSE(s.taken);
  for (const Key& key : {Key{NamedKey::Escape}, Key{'b'}, Key{NamedKey::Right}}) {
    s.press("b");
    s.press(key);
    EXPECT_TRUE(s.taken);
    EXPECT_FALSE(s.bench.view().numbered);
  }
  EXPECT_EQ(s.step(), 1);
  EXPECT_EQ(ticked(), 1);
}

// `j` visits every step of the chosen kind once and no other, and `J` visits the same steps backward. `K`
// chooses every kind in turn. If there are no more steps, a sentence says so and the step stays.
TEST(SortView, JumpsToStepsOfTheKind) {
  Stepper s{"nested-cycles"};
  int visited = 0;
  for (const LandmarkRow& row : kLandmarks) {
    ASSERT_EQ(s.bench.view().kind, row.id);
    const std::vector<int> all = s.stepsOf(row.id);
    for (const int step : all) {
      s.press("j");
      ASSERT_EQ(s.step(), step) << row.name;
      ASSERT_EQ(landmarkOf(s.event()), row.id);
      ++visited;
    }
    const std::size_t notices = s.notices.size();
    s.press("j");
    EXPECT_EQ(s.step(), all.back());
    EXPECT_EQ(s.notices.size(), notices + 1);
    for (std::size_t k = all.size() - 1; k-- > 0;) {
      s.press("J");
      ASSERT_EQ(s.step(), all[k]) << row.name;
    }
    s.press(NamedKey::Home);
    s.press("K");
  }
  EXPECT_EQ(s.bench.view().kind, kLandmarks.front().id);
  EXPECT_GT(visited, 50);
}

// A step's number can be typed. A number outside the run is refused, and the message gives the range.
TEST(SortView, GoesToATypedStep) {
  Stepper s{"cycle"};
  s.press("g");
  ASSERT_EQ(s.questions.size(), 1u);
  EXPECT_EQ(s.type("7"), "");
  EXPECT_EQ(s.step(), 7);
  for (const char* wrong : {"", "1e3", "-1", "20", "99999999999999999999", "3.5"}) {
    EXPECT_NE(s.type(wrong).find("from 0 to 19"), std::string::npos) << wrong;
    EXPECT_EQ(s.step(), 7);
  }
  EXPECT_EQ(s.type("19"), "");
  EXPECT_EQ(s.step(), 19);
}

// `/` and a face's number visit all the steps that have a part of the face as P or Q, and only these.
TEST(SortView, GoesAlongTheStepsOfAPolygon) {
  Stepper s{"cycle"};
  const auto has = [&](int step) { return s.run().landmarks().has(s.run().scene(), 1, step); };
  int visited = 0;
  for (int step = 1; step <= s.run().steps(); ++step) {
    const auto& e = s.run().sorted().events[step - 1];
    const bool parts =
        s.run().fragments().face(e.P).number == 1 || (e.Q >= 0 && s.run().fragments().face(e.Q).number == 1);
    ASSERT_EQ(has(step), parts);
    if (!parts) continue;
    s.press("/");
    if (visited) {
      EXPECT_EQ(s.questions.back().text, "1");
    }
    ASSERT_EQ(s.type("1"), "");
    ASSERT_EQ(s.step(), step);
    ++visited;
  }
  EXPECT_GT(visited, 3);
  EXPECT_LT(visited, s.run().steps());
  EXPECT_NE(s.type("77"), "");
  EXPECT_EQ(s.type("1"), "");  // there is no later one: this is told, not refused
  EXPECT_NE(s.notices.back().find("No later step"), std::string::npos);
}

// Each button does what its key does.
TEST(SortView, ButtonsAreKeys) {
  const std::array<Key, kTransport> keys{
      Key{NamedKey::Home}, {NamedKey::Left, 0, true},  {NamedKey::Left}, {NamedKey::Space},
      {NamedKey::Right},   {NamedKey::Right, 0, true}, {NamedKey::End}};
  for (int k = 0; k < kTransport; ++k) {
    Stepper clicked{"nested-cycles"}, typed{"nested-cycles"};
    clicked.goTo(40), typed.goTo(40);
    clicked.click(clicked.places().transport[k]);
    typed.press(keys[k]);
    EXPECT_EQ(clicked.bench.view(), typed.bench.view()) << k;
    const bool play = k == kPlay;
    EXPECT_EQ(clicked.bench.moving(), play);
    EXPECT_EQ(clicked.step() != 40, !play) << k;
  }
}

// Boxes, kinds and the slider respond to clicks, and the drawing shows the effect at once.
TEST(SortView, EveryRectangleDoesItsThing) {
  for (const auto& [width, height] : {std::pair{1024, 768}, {800, 600}, {1600, 1200}}) {
    Stepper s{"nested-cycles", 3, width, height};
    const SortLayout at = s.places();
    const auto isTicked = [&](int k) {
      const SortState& view = s.bench.view();
      return k == kPredict ? view.predict : k == kOwn ? view.own.has_value() : view.stops[k];
    };
    for (int k = 0; k < kToggleCount; ++k) {
      const Rect& box = at.toggles[k].area;
      s.bench.hover(box.x + 1, box.y + 1);
      const IndexImage before = s.draw();
      s.click(at.toggles[k].area);
      EXPECT_TRUE(isTicked(k)) << k;
      EXPECT_TRUE(s.bench.late(s.wanted));
      EXPECT_NE(s.draw(), before) << k;
      s.click(at.toggles[k].area);
      EXPECT_FALSE(isTicked(k)) << k;
    }
    EXPECT_EQ(s.questions.size(), 1u);  // which polygon?
    for (const LandmarkRow& row : kLandmarks) {
      s.press(NamedKey::Home);
      s.click(at.kinds.options[static_cast<int>(row.id)]);
      EXPECT_EQ(s.bench.view().kind, row.id);
      EXPECT_EQ(s.step(), s.stepsOf(row.id).front());
    }
    const Rect& track = at.speed.track;
    ASSERT_TRUE(s.bench.grab(track.x, track.y));
    EXPECT_NEAR(s.bench.view().speed, kSpeeds.low, 1e-9);
    s.bench.dragTo(track.x + 10 * track.width, 0);
    EXPECT_NEAR(s.bench.view().speed, kSpeeds.high, 1e-6);
    EXPECT_TRUE(s.bench.list().dragging());
    const IndexImage held = s.draw();
    s.bench.drop();
    EXPECT_FALSE(s.bench.list().dragging());
    EXPECT_NE(s.draw(), held);
    EXPECT_FALSE(s.bench.grab(at.body.x + at.body.width - 2, at.rule));
  }
}

// A click on the timeline goes to the step whose mark is there. Dragging goes along it; beyond its ends it
// goes to the ends of the run.
TEST(SortView, TheTimelineIsTheRun) {
  Stepper s{"cycle"};
  const Rect line = s.places().timeline;
  const int steps = s.run().steps();
  for (int step = 0; step <= steps; ++step) {
    s.click(columnOf(line, step, steps), line.y + 5);
    EXPECT_EQ(s.step(), step);
  }
  ASSERT_TRUE(s.bench.grab(line.x + line.width / 2, line.y));
  EXPECT_NEAR(s.step(), steps / 2.0, 1.0);
  s.bench.dragTo(-500, 9999);
  EXPECT_EQ(s.step(), 0);
  s.bench.dragTo(line.x + line.width + 500, -500);
  EXPECT_EQ(s.step(), steps);
  s.bench.drop();
  s.bench.dragTo(line.x, line.y);
  EXPECT_EQ(s.step(), steps);
}

// A click on a polygon, in the picture or in the list, goes to the next step with that polygon. A click on
// the loupe, which lies over the picture, has no effect.
TEST(SortView, ClickingAPolygonGoesToItsNextStep) {
  Stepper s{"teapot"};
  int from = 200;
  do s.goTo(++from), s.draw();
  while (s.bench.places().loupe.empty());
  const SortDrawn drawn = s.bench.places();
  int rows = 0;
  for (int k = 0; k < static_cast<int>(drawn.rows.size()); ++k) {
    if (drawn.rows[k] < 0) continue;
    s.goTo(from);
    s.draw();
    ASSERT_EQ(s.bench.places().rows, drawn.rows);
    const int number = s.run().fragments().face(drawn.rows[k]).number;
    const auto next = s.run().landmarks().nextWith(s.run().scene(), number, from);
    const SortLayout at = s.places();
    s.click(at.list.x + 30, at.list.y + k * at.line + 5);
    const auto first = s.run().landmarks().nextWith(s.run().scene(), number, 0);
    ASSERT_TRUE(first);
    EXPECT_EQ(s.step(), next.value_or(*first)) << k;
    EXPECT_EQ(s.bench.view().polygon, number);
    rows += next.has_value();
  }
  EXPECT_GT(rows, 8);

  s.goTo(from);
  s.draw();
  ASSERT_FALSE(drawn.loupe.empty());
  const std::size_t notices = s.notices.size();
  s.click(drawn.loupe);
  EXPECT_EQ(s.step(), from);
  EXPECT_EQ(s.notices.size(), notices);
  const Rect area = s.places().picture;
  s.press(NamedKey::End);
  s.draw();
  int hits = 0;
  for (int x = 5; x < area.width; x += 23) {
    s.goTo(from);
    s.draw();
    const int id = s.run().fragmentAt(x, area.height / 2);
    if (s.bench.places().loupe.has(area.x + x, area.y + area.height / 2)) continue;
    s.click(area.x + x, area.y + area.height / 2);
    if (id < 0) {
      EXPECT_EQ(s.notices.back(), "There is no polygon there.");
      continue;
    }
    EXPECT_EQ(s.bench.view().polygon, s.run().fragments().face(id).number);
    ++hits;
  }
  EXPECT_GT(hits, 5);
}

// The stepper always shows Newell's run, whatever the picture's order is. A scene with a plan of full colours
// is painted in one hue, because such colours are chosen from the finished picture.
TEST(SortView, AlwaysShowsNewellsRun) {
  Stepper newell{"cycle"};
  for (const OrderRow& row : kOrders) {
    Stepper s{"cycle"};
    s.wanted.picture.order = row.id;
    s.draw();
    newell.goTo(9), s.goTo(9);
    EXPECT_EQ(s.draw(), newell.draw()) << row.label;
  }
  Stepper colors{"colored-lights"};
  EXPECT_EQ(colors.draws, 2);
  ASSERT_NE(colors.bench.run(), nullptr);
  EXPECT_GT(colors.run().steps(), 0);
}

// A new camera makes another run, and its step most like the one before is shown. A new light only paints
// again, at the same step.
TEST(SortView, RecordsAgainWhereTheSortChanged) {
  Stepper s{"cycle"};
  s.goTo(18);  // all polygons but one are painted
  const IndexImage before = s.draw();
  s.wanted.picture.light.Ip = 0.1;
  EXPECT_NE(s.draw(), before);
  EXPECT_EQ(s.step(), 18);
  const StepAbout about = s.run().about(s.step());
  const std::size_t told = s.notices.size();
  s.wanted.picture.camera =
      moved(s.wanted.picture.camera, s.picture().camera(), s.picture().scene(), 20, 0, 1);
  s.draw();
  ASSERT_GT(s.step(), 0);
  EXPECT_EQ(s.run().about(s.step()).P, about.P);
  EXPECT_EQ(s.notices.size(), told + 1);
  s.goTo(3);
  s.bench.leave();
  EXPECT_FALSE(s.bench.moving());
  s.draw();
  EXPECT_EQ(s.step(), 3) << "coming back to the same run";
  // Keys that are typed before the run is recorded wait for it: the view is drawn first.
  s.bench.leave();
  s.press(NamedKey::Right);
  EXPECT_TRUE(s.taken);
  EXPECT_EQ(s.step(), 4);
  s.press("X");
  EXPECT_FALSE(s.taken);
  // Nobody who went to the start meanwhile is taken away from it.
  s.draw();
  s.press(NamedKey::Home);
  s.wanted.picture.camera =
      moved(s.wanted.picture.camera, s.picture().camera(), s.picture().scene(), 20, 0, 1);
  s.draw();
  EXPECT_EQ(s.step(), 0);
}

// The step of another run most like a given one has the same kind, P and Q; or else the same P and Q; or else
// the same P.
TEST(SortView, StepsOfAnotherRunAreAlike) {
  Stepper s{"nested-cycles"};
  const SortRun& run = s.run();
  int exact = 0;
  for (int step = 1; step <= run.steps(); ++step) {
    StepAbout about = run.about(step);
    const auto found = run.stepAbout(about);
    ASSERT_TRUE(found);
    EXPECT_LE(*found, step);
    EXPECT_EQ(run.about(*found).kind, about.kind);
    EXPECT_EQ(run.about(*found).Q, about.Q);
    exact += *found == step;
    about.Q = 9999;
    ASSERT_TRUE(run.stepAbout(about));
    EXPECT_EQ(run.about(*run.stepAbout(about)).P, about.P);
    about.P = 9999;
    EXPECT_FALSE(run.stepAbout(about));
  }
  EXPECT_GT(exact, 20);
}

// The loupe can be put away and brought back.
TEST(SortView, TheLoupeCanBePutAway) {
  Stepper s{"teapot"};
  IndexImage with;
  do s.press(NamedKey::Right), with = s.draw();
  while (s.bench.places().loupe.empty());
  s.press("l");
  EXPECT_NE(s.draw(), with);
  EXPECT_TRUE(s.bench.places().loupe.empty());
  s.press("l");
  EXPECT_EQ(s.draw(), with);
}

}  // namespace xnewell::THIS_FILE
