#include <gtest/gtest.h>

#include "tests/x11/support/ready_workbench.h"
#include "x11/lessons/lesson_view.h"
#include "x11/sides/sides_page.h"

namespace xnewell::THIS_FILE {

// One scale: letters, lines and controls grow by a whole factor, and pictures keep their own pixels.

namespace {

constexpr int kWidth = 800, kHeight = 600;  // lower, the keys would follow the words, which may differ

/// A window that shows a view at a scale. In units it has the same size at all scales.
struct Scaled : ReadyWorkbench {
  Scaled(int unit, View view, const char* lesson = "five-tests", int wider = 0)
      : ReadyWorkbench{{}, 1, 1, "cycle"} {
    scale(unit);
    resize(unit * kWidth + wider, unit * kHeight + wider);
    if (view == View::Lesson)
      teach(readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/" + lesson + ".json"));
    switchTo(view);
    finish();
  }
};

/// Where samples of pictures are, in units, and what lies exactly under them.
std::vector<Rect> picturesOf(const Workbench& b) {
  const Rect at = b.bench().picture(b.layout()), &body = b.layout().body;
  if (b.view() == View::MachBands) return {{at.x, body.y, at.width, body.height}};
  if (b.view() == View::Viewing)  // its table counts pixels
    return {{at.x - 4, body.y, at.width + 8, body.height}};
  if (b.view() == View::Scanline) return {body};  // a polygon has more pixels, and so another run
  if (b.view() != View::SideBySide) return {at};
  const SidesLayout sides = layoutOfSides(body);
  return {sides.A, sides.B, sides.difference, sides.numbers};  // the numbers have a loupe and times
}

/// Outside of its pictures the window at the scale must look like the one at scale 1, each unit a square of
/// one cell. Only words that count samples differ, since there are more samples.
void expectGrown(const Scaled& one, const Scaled& more, int unit) {
  const std::vector<Rect> pictures = picturesOf(one);
  int ragged = 0, differ = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      if (std::ranges::any_of(pictures, [&](const Rect& r) { return r.has(x, y); })) continue;
      const auto at = [&](int i, int j) { return more.image().row(y * unit + j)[x * unit + i]; };
      for (int k = 0; k < unit * unit; ++k) ragged += at(k % unit, k / unit) != at(0, 0);
      differ += at(0, 0) != one.image().row(y)[x];
    }
  EXPECT_EQ(ragged, 0);
  // Of 480,000: two lines of text are more. Another polygon has another cell in the strip, and other words.
  EXPECT_LT(differ, one.view() == View::Scanline ? 1500 : 600);
}

}  // namespace

TEST(Scale, PagesGrow) {
  for (const ViewRow& row : kWindowViews) {
    SCOPED_TRACE(row.name);
    const Scaled one{1, row.id};
    expectGrown(one, Scaled{2, row.id}, 2);
    if (row.id == View::Picture) expectGrown(one, Scaled{3, row.id}, 3);
  }
  for (const char* lesson : {"sorting-by-z", "colormap-tricks"}) {
    SCOPED_TRACE(lesson);
    expectGrown({1, View::Lesson, lesson}, {2, View::Lesson, lesson}, 2);
  }
}

// No sample is blown up: the window shows the picture that is drawn for all pixels of its place.
TEST(Scale, PicturesKeepTheirPixels) {
  const Scaled b{2, View::Picture};
  const Rect at = b.bench().picture(b.layout()) * 2;
  PictureSettings settings = b.setup().picture;
  settings.width = at.width, settings.height = at.height;
  PictureCache pictures{readScene("cycle", 3)};
  EXPECT_EQ(b.part(at), pictures.make(settings, b.ground()).image());
}

// A click means the sample under the pointer: in the stepper it goes to the polygon there.
TEST(Scale, AClickMeansTheSampleUnderIt) {
  Scaled one{1, View::DepthSort}, two{2, View::DepthSort};
  const Rect at = one.bench().picture(one.layout());
  const int x = at.x + at.width / 2 + 30, y = at.y + at.height / 2;
  const std::string before = one.bench().status();
  one.click(x, y);
  two.click(2 * x, 2 * y);
  EXPECT_NE(one.bench().status(), before);
  EXPECT_EQ(one.bench().status(), two.bench().status());
}

// A window of any size is drawn whole at each scale.
TEST(Scale, AnySize) {
  ReadyWorkbench b{{}, 1, 1, "cycle"};
  for (int unit = 1; unit <= 4; ++unit)
    for (const auto& [w, h] : {std::pair{1, 1}, {7, 3}, {799, 2000}, {1599, 1200}, {4000, 3000}}) {
      SCOPED_TRACE(std::to_string(unit) + ": " + std::to_string(w));
      b.scale(unit);
      b.resize(w, h);
      b.does('?');
      EXPECT_EQ(b.layout().roomy, w > 799 * unit && h > 539 * unit);
      EXPECT_EQ(std::pair(b.image().width, b.image().height), std::pair(w, h));
      for (const Rect& part : b.overPicture()) EXPECT_EQ(intersection(part, {0, 0, w, h}), part);
      b.press('?');
    }
  for (const ViewRow& row : kWindowViews) {
    const Scaled odd{3, row.id, "cycles", 1};
    EXPECT_EQ(odd.image().width, 3 * kWidth + 1);
  }
}

// Z chooses a scale on a screen that is filled. Back in the small window the scale is one that fits.
TEST(Scale, FitsAgainAfterTheFullScreen) {
  bool full = false;
  Workbench b{readScene("cycle", 3), {}, {.fillScreen = [&](std::optional<bool> wish) {
                return std::optional{full = wish.value_or(!full)};
              }}};
  const auto size = [&](int width, int height) {
    b.resize(width, height);
    b.update();
  };
  size(1024, 768);
  b.press(NamedKey::F11);
  size(3840, 2160);
  EXPECT_EQ(b.layout().unit, 4);
  b.press('Z');
  b.press('Z');
  EXPECT_EQ(b.layout().unit, 2);
  b.press(NamedKey::F11);
  size(1024, 768);
  EXPECT_TRUE(b.layout().roomy);
  EXPECT_EQ(b.layout().unit, 1);
}

}  // namespace xnewell::THIS_FILE
