#include <gtest/gtest.h>

#include <algorithm>

#include "tests/x11/support/ready_workbench.h"
#include "x11/stepper/sort_view.h"

namespace xnewell::THIS_FILE {

// The depth-sort stepper as a view of the window, without a server.

namespace {

struct InDepthSort : ReadyWorkbench {
  explicit InDepthSort(const std::string& scene = "cycle", int width = 1024, int height = 768,
                       const xnewell::Setup& setup = {})
      : ReadyWorkbench{setup, width, height, scene} {
    type("2");
    finish();
  }
  const IndexImage& shown() {
    finish();
    return image();
  }
  [[nodiscard]] SortLayout places() const { return layoutOfSort(layout().body); }
};

int different(const IndexImage& a, const IndexImage& b, const Rect& part) {
  int count = 0;
  for (int j = part.y; j < part.y + part.height; ++j)
    for (int i = part.x; i < part.x + part.width; ++i) count += a.row(j)[i] != b.row(j)[i];
  return count;
}

}  // namespace

// `2` shows the view, and `1` the picture as it was before. Back in the view, the step is the same.
TEST(SortWorkbench, ComesAndGoes) {
  ReadyWorkbench b{{}, 1024, 768, "cycle"};
  const IndexImage picture = b.image();
  const Palette palette = b.palette();
  b.type("2");
  b.finish();
  EXPECT_EQ(b.view(), View::DepthSort);
  EXPECT_NE(b.image(), picture);
  for (int k = 0; k < 7; ++k) b.press({NamedKey::Right});
  b.finish();
  const IndexImage seventh = b.image();
  b.type("1");
  b.finish();
  EXPECT_EQ(different(b.image(), picture, {0, 0, 1024, b.layout().status.y}), 0);
  EXPECT_EQ(b.palette(), palette);
  b.type("2");
  b.finish();
  EXPECT_EQ(b.image(), seventh);
}

// On the way back from the end to the start, each step shows what it showed on the way there, at any size.
// One update is enough for a step.
TEST(SortWorkbench, BackShowsTheSame) {
  for (const auto& [width, height] : {std::pair{800, 600}, {1024, 768}, {1600, 1200}}) {
    InDepthSort b{"nested-cycles", width, height};
    std::vector<IndexImage> forward{b.shown()};
    while (true) {
      const int step = b.stepper().view().step;
      b.press({NamedKey::Right});
      if (b.stepper().view().step == step) break;
      b.update();
      ASSERT_EQ(b.stale(), Workbench::Stale::Nothing);
      forward.push_back(b.image());
    }
    ASSERT_GT(forward.size(), 50u);
    for (std::size_t k = forward.size() - 1; k-- > 0;) {
      b.press({NamedKey::Left});
      ASSERT_EQ(b.shown(), forward[k]) << k;
    }
  }
}

// A change of the colour table or of the shading can be undone in the view too. Later steps are painted with
// the new settings and use nothing of the run before.
TEST(SortWorkbench, UndoPaintsAnew) {
  xnewell::Setup gouraud;
  gouraud.picture.shading = Shading::Gouraud;
  gouraud.picture.table.kind = TableKind::Corrected;
  ReadyWorkbench b{gouraud, 1024, 768, "teapot"};
  b.type("S");
  b.type("H");
  b.type("T");
  b.finish();
  b.type("2");
  b.press({NamedKey::End});
  b.finish();
  const IndexImage changed = b.image();
  b.type("uUuUuuu");  // the hue alone, and back: no picture is painted in between
  b.finish();
  b.press({NamedKey::Left});
  b.press({NamedKey::Right});
  b.finish();
  EXPECT_NE(b.image(), changed);
  ReadyWorkbench fresh{gouraud, 1024, 768, "teapot"};
  fresh.type("2");
  fresh.press({NamedKey::End});
  fresh.finish();
  fresh.press({NamedKey::End});
  fresh.finish();
  EXPECT_EQ(different(b.image(), fresh.image(), fresh.layout().body), 0);
  EXPECT_EQ(b.palette(), fresh.palette());
}

// Step and polygon are typed below the body. Mistakes are told there and can be corrected.
TEST(SortWorkbench, QuestionsAreTyped) {
  InDepthSort b;
  const IndexImage start = b.shown();
  b.type("g");
  b.type("99");
  b.press({NamedKey::Return});
  b.press({NamedKey::Backspace});
  b.press({NamedKey::Return});
  const IndexImage ninth = b.shown();
  EXPECT_NE(ninth, start);
  InDepthSort walked;
  for (int k = 0; k < 9; ++k) walked.press({NamedKey::Right});
  EXPECT_EQ(different(walked.shown(), ninth, walked.layout().body), 0);
  b.type("/");
  b.type("1");
  b.press({NamedKey::Return});
  EXPECT_NE(b.shown(), ninth);
}

// Playing goes on by itself until the end, a drag along the timeline follows the pointer, and tabs respond to
// clicks.
TEST(SortWorkbench, PlaysAndIsDragged) {
  InDepthSort b;
  EXPECT_FALSE(b.moving());
  b.type("++++++++++++");
  b.press({NamedKey::Space});
  ASSERT_TRUE(b.moving());
  int ticks = 0;
  for (; b.moving() && ticks < 1000; ++ticks) b.tick();
  EXPECT_GT(ticks, 0);
  EXPECT_LT(ticks, 1000);
  const IndexImage end = b.shown();
  const Rect line = b.places().timeline;
  ASSERT_TRUE(b.grab(line.x, line.y + 3));
  b.update(true);
  b.dragTo(line.x + line.width, 0);
  b.update(true);
  b.settle();
  EXPECT_EQ(different(b.shown(), end, b.layout().body), 0);
  b.type("1");
  EXPECT_EQ(b.view(), View::Picture);
}

// A scene with a plan of full colours is shown in one hue. For a scene too long to step through, the view
// says so in words that fit. Both can be opened and left like any other scene.
TEST(SortWorkbench, SaysWhatItCannotShow) {
  InDepthSort colors{"colored-lights"};
  const IndexImage start = colors.shown();
  colors.press({NamedKey::End});
  EXPECT_NE(colors.shown(), start);
  colors.type("1");
  colors.finish();
  colors.type("2");
  colors.finish();

  ReadyWorkbench b;
  b.open(readScene("teapot", 30), {});
  b.update();
  b.type("2");
  b.finish();
  EXPECT_EQ(b.view(), View::DepthSort);
  const IndexImage tooLong = b.image();
  b.press({NamedKey::Right});
  b.type("jgy/");
  EXPECT_FALSE(b.isAsking());
  b.finish();
  EXPECT_EQ(different(b.image(), tooLong, b.layout().body), 0) << "there are no steps";
  EXPECT_NE(b.image(), tooLong) << "and a sentence says why";

  // A click sorts the polygons around it. Esc leaves that part.
  const Rect picture = b.bench().picture(b.layout());
  const auto& stepper = dynamic_cast<const SortView&>(b.bench());
  (void)b.grab(picture.x + picture.width / 2, picture.y + picture.height / 2);
  b.finish();
  EXPECT_FALSE(stepper.tooLong());
  const IndexImage begun = b.image();
  b.press({NamedKey::End});
  b.finish();
  EXPECT_NE(different(b.image(), begun, picture), 0);
  b.press({NamedKey::Escape});
  b.finish();
  EXPECT_TRUE(stepper.tooLong());
  EXPECT_EQ(different(b.image(), tooLong, b.layout().body), 0);
  b.close();
  b.finish();
  EXPECT_NE(b.image(), tooLong);
}

// What playing stops at, and the score of the predictions, belong to a scene. The speed is the user's.
TEST(SortWorkbench, AnotherSceneHasNoTicks) {
  ReadyWorkbench b{{}, 1024, 768, "cycle"};
  b.type("2");
  b.finish();
  b.type("b1b3y+");
  b.finish();
  const auto& stepper = dynamic_cast<const SortView&>(b.bench());
  const SortState ticked = stepper.view();
  EXPECT_TRUE(ticked.predict);
  EXPECT_EQ(std::ranges::count(ticked.stops, true), 2);
  b.open(readScene("penetrate"), {});
  b.finish();
  EXPECT_FALSE(stepper.view().predict);
  EXPECT_EQ(std::ranges::count(stepper.view().stops, true), 0);
  EXPECT_EQ(stepper.view().speed, ticked.speed);
}

// D makes the picture larger. The run is sorted again, but the step stays, and nothing is told: the steps of
// `penetrate` have several comparisons of the same two faces.
TEST(SortWorkbench, TheDrawerKeepsTheStep) {
  InDepthSort b{"penetrate", 1920, 1080};
  const int steps = b.stepper().run()->steps();
  ASSERT_GT(steps, 4);
  for (int step = 1; step <= steps; ++step) {
    b.press({NamedKey::Right});
    b.finish();
    ASSERT_EQ(b.stepper().view().step, step);
    const std::string status = b.bench().status();
    for (int k = 0; k < 2; ++k) {
      b.type("D");
      b.finish();
      EXPECT_EQ(b.stepper().view().step, step);
      EXPECT_EQ(b.bench().status(), status);
      for (int x = 0; x < 600; ++x)
        for (int y = b.layout().status.y; y < b.layout().height; ++y)
          ASSERT_NE(b.image().row(y)[x], b.plan()[Cell::Good]) << "news";
    }
  }
}

}  // namespace xnewell::THIS_FILE
