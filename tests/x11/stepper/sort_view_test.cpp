#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shading/scene/units.h"
#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/stepper.h"
#include "x11/stepper/sort_view.h"

namespace xnewell::THIS_FILE {

// The depth-sort stepper: its keys, its pointer and its runs, how it plays and predicts, and the view in a
// window. What it draws: sort_page_test.cpp.

// Arrows step by one, or by ten with Shift, but never beyond the ends, which say so. Home and End go there.
TEST(SortView, ArrowsStep) {
  Stepper s{"cycle"};
  const int steps = s.run().steps();
  ASSERT_GT(steps, 12);
  for (const auto& [name, shift, step] : {std::tuple{NamedKey::Left, false, 0},
                                          {NamedKey::Right, false, 1},
                                          {NamedKey::Right, true, 11},
                                          {NamedKey::Left, false, 10},
                                          {NamedKey::Left, true, 0},
                                          {NamedKey::End, false, steps},
                                          {NamedKey::Right, false, steps},
                                          {NamedKey::Home, false, 0}}) {
    s.press(name, shift);
    EXPECT_EQ(s.step(), step);
    EXPECT_TRUE(s.taken);
  }
  s.press("X");
  EXPECT_FALSE(s.taken);
  EXPECT_EQ(s.notices.size(), 2u) << "one for each end";
}

// With the speed selected, the arrows up and down change it, and left and right still step. Esc selects the
// timeline again, where up is a step forward. The keys for faster and slower stop at the slider's ends; as
// many notches back lead back.
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
  s.press("+++---");
  EXPECT_NEAR(s.bench.view().speed, 8, 1e-9);
  s.press(std::string(100, '+'));
  EXPECT_EQ(s.bench.view().speed, kSpeeds.high);
  s.press(NamedKey::Space);
  s.bench.tick();  // 80 steps at once end at the last one
  EXPECT_EQ(s.step(), s.run().steps());
  s.press(std::string(100, '-'));
  EXPECT_EQ(s.bench.view().speed, kSpeeds.low);
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
      s.bench.hover(at.toggles[k].area.x + 1, at.toggles[k].area.y + 1);
      for (const bool ticks : {true, false}) {
        const IndexImage before = s.draw();
        s.click(at.toggles[k].area);
        EXPECT_EQ(isTicked(k), ticks) << k;
        EXPECT_TRUE(s.bench.late(s.wanted));
        EXPECT_NE(s.draw(), before) << k;
      }
    }
    EXPECT_EQ(s.questions.size(), 1u);  // which polygon?
    for (const LandmarkRow& row : kLandmarks) {
      s.press(NamedKey::Home);
      s.click(at.kinds.options[static_cast<int>(row.id)]);
      EXPECT_EQ(s.bench.view().kind, row.id);
      EXPECT_EQ(s.step(), s.stepsOf(row.id).front());
    }
    ASSERT_TRUE(s.bench.grab(at.speed.track.x, at.speed.track.y));
    EXPECT_NEAR(s.bench.view().speed, kSpeeds.low, 1e-9);
    s.bench.drop();
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
// the loupe, which lies over the picture, has no effect. The loupe can be put away and brought back.
TEST(SortView, ClickingAPolygonGoesToItsNextStep) {
  Stepper s{"teapot"};
  int from = 200;
  do s.goTo(++from), s.draw();
  while (s.bench.places().loupe.empty());
  const SortDrawn drawn = s.bench.places();
  const auto clickFrom = [&](int x, int y) {
    s.goTo(from);
    s.draw();
    s.click(x, y);
  };
  const SortLayout at = s.places();
  int rows = 0;
  for (int k = 0; k < static_cast<int>(drawn.rows.size()); ++k) {
    if (drawn.rows[k] < 0) continue;
    const int number = s.run().fragments().face(drawn.rows[k]).number;
    const auto next = s.run().landmarks().nextWith(s.run().scene(), number, from);
    clickFrom(at.list.x + 30, at.list.y + k * at.line + 5);
    EXPECT_EQ(s.step(), next.value_or(s.run().landmarks().nextWith(s.run().scene(), number, 0).value())) << k;
    EXPECT_EQ(s.bench.view().polygon, number);
    rows += next.has_value();
  }
  EXPECT_GT(rows, 8);
  const std::size_t notices = s.notices.size();
  clickFrom(drawn.loupe.x + drawn.loupe.width / 2, drawn.loupe.y + drawn.loupe.height / 2);
  EXPECT_EQ(s.step(), from);
  EXPECT_EQ(s.notices.size(), notices);
  int hits = 0;
  for (int x = 5; x < at.picture.width; x += 23) {
    if (drawn.loupe.has(at.picture.x + x, at.picture.y + at.picture.height / 2)) continue;
    s.goTo(from);
    const int id = s.run().fragmentAt(x, at.picture.height / 2);
    clickFrom(at.picture.x + x, at.picture.y + at.picture.height / 2);
    ++(id < 0 ? rows : hits);
    if (id < 0) {
      EXPECT_EQ(s.notices.back(), "There is no polygon there.");
    } else {
      EXPECT_EQ(s.bench.view().polygon, s.run().fragments().face(id).number);
    }
  }
  EXPECT_GT(hits, 5);
  s.goTo(from);
  const IndexImage with = s.draw();
  s.press("l");
  EXPECT_NE(s.draw(), with);
  EXPECT_TRUE(s.bench.places().loupe.empty());
  s.press("l");
  EXPECT_EQ(s.draw(), with);
}

// A new camera makes another run, and its step most like the one before is shown; nobody who went to the
// start meanwhile is taken away from it. A new light only paints again, at the same step. Keys that are typed
// before the run is recorded wait for it.
TEST(SortView, RecordsAgainWhereTheSortChanged) {
  Stepper s{"cycle"};
  const auto turn = [&] {
    s.wanted.picture.camera =
        moved(s.wanted.picture.camera, s.picture().camera(), s.picture().scene(), 20, 0, 1);
    s.draw();
  };
  s.goTo(18);  // all polygons but one are painted
  const IndexImage before = s.draw();
  s.wanted.picture.light.Ip = 0.1;
  EXPECT_NE(s.draw(), before);
  EXPECT_EQ(s.step(), 18);
  const StepAbout about = s.run().about(s.step());
  const std::size_t told = s.notices.size();
  turn();
  ASSERT_GT(s.step(), 0);
  EXPECT_EQ(s.run().about(s.step()).P, about.P);
  EXPECT_EQ(s.notices.size(), told + 1);
  s.goTo(3);
  s.bench.leave();
  EXPECT_FALSE(s.bench.moving());
  s.draw();
  EXPECT_EQ(s.step(), 3) << "coming back to the same run";
  s.bench.leave();
  s.press(NamedKey::Right);
  EXPECT_TRUE(s.taken);
  EXPECT_EQ(s.step(), 4);
  s.draw();
  s.press(NamedKey::Home);
  turn();
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

// A change of the colour table or of the shading can be undone in the view too. Later steps are painted with
// the new settings and use nothing of the run before.
TEST(SortWorkbench, UndoPaintsAnew) {
  xnewell::Setup gouraud;
  gouraud.picture.shading = Shading::Gouraud;
  gouraud.picture.table.kind = TableKind::Corrected;
  ReadyWorkbench b{gouraud}, fresh{gouraud};
  b.does("SHT");
  for (ReadyWorkbench* const one : {&fresh, &b})
    one->type("2"), one->does(NamedKey::End), one->does(NamedKey::End);
  const IndexImage changed = b.image();
  b.does("uUuUuuu");  // the hue alone, and back: no picture is painted in between
  b.press(NamedKey::Left);
  b.does(NamedKey::Right);
  EXPECT_NE(b.image(), changed);
  EXPECT_EQ(b.part(b.layout().body), fresh.part(b.layout().body));
  EXPECT_EQ(b.palette(), fresh.palette());
}

// For a scene too long to step through, the view says so. A click sorts the polygons around it, and Esc
// leaves that part.
TEST(SortWorkbench, SaysWhatItCannotShow) {
  ReadyWorkbench b;
  b.open(readScene("teapot", 30), {});
  b.update();
  b.does('2');
  const auto body = [&] { return b.part(b.layout().body); };
  const IndexImage tooLong = body(), whole = b.image();
  b.press(NamedKey::Right);
  b.type("jgy/");
  EXPECT_FALSE(b.isAsking());
  b.finish();
  EXPECT_EQ(body(), tooLong) << "there are no steps";
  EXPECT_NE(b.image(), whole) << "and a sentence says why";

  const Rect picture = b.bench().picture(b.layout());
  (void)b.grab(picture.x + picture.width / 2, picture.y + picture.height / 2);
  b.finish();
  EXPECT_FALSE(b.stepper().tooLong());
  const IndexImage begun = b.part(picture);
  b.does(NamedKey::End);
  EXPECT_NE(b.part(picture), begun);
  b.does(NamedKey::Escape);
  EXPECT_TRUE(b.stepper().tooLong());
  EXPECT_EQ(body(), tooLong);
  b.close();
  b.finish();
  EXPECT_NE(body(), tooLong);
}

// What playing stops at, and the score of the predictions, belong to a scene. The speed is the user's.
TEST(SortWorkbench, AnotherSceneHasNoTicks) {
  ReadyWorkbench b{{}, 1024, 768, "cycle"};
  b.does('2');
  b.does("b1b3y+");
  const SortState ticked = b.stepper().view();
  EXPECT_TRUE(ticked.predict);
  EXPECT_EQ(std::ranges::count(ticked.stops, true), 2);
  b.open(readScene("penetrate"), {});
  b.finish();
  EXPECT_FALSE(b.stepper().view().predict);
  EXPECT_EQ(std::ranges::count(b.stepper().view().stops, true), 0);
  EXPECT_EQ(b.stepper().view().speed, ticked.speed);
}

// D makes the picture larger. The run is sorted again, but the step stays, and nothing is told: the steps of
// `penetrate` have several comparisons of the same two faces.
TEST(SortWorkbench, TheDrawerKeepsTheStep) {
  ReadyWorkbench b{{}, 1920, 1080, "penetrate"};
  b.does('2');
  const int steps = b.stepper().run()->steps();
  ASSERT_GT(steps, 4);
  for (int step = 1; step <= steps; ++step) {
    b.does(NamedKey::Right);
    ASSERT_EQ(b.stepper().view().step, step);
    const std::string status = b.bench().status();
    for (int k = 0; k < 2; ++k) {
      b.does('D');
      EXPECT_EQ(b.stepper().view().step, step);
      EXPECT_EQ(b.bench().status(), status);
      EXPECT_EQ(b.panel().told, "");
    }
  }
}

}  // namespace xnewell::THIS_FILE
