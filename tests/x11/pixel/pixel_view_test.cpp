#include "x11/pixel/pixel_view.h"

#include <gtest/gtest.h>

#include "shading/explain/pixel_history.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/lessons/lesson.h"

namespace xnewell::THIS_FILE {

namespace {

/// A window at view 8.
struct PixelWindow : ReadyWorkbench {
  explicit PixelWindow(const char* scene = "teapot", int width = 1024, int height = 768)
      : ReadyWorkbench{{}, width, height, scene} {
    does('8');
  }
  [[nodiscard]] std::string status() const { return bench().status(); }
  /// The cell of the picture's pixel that the status line names.
  [[nodiscard]] int cellThere() const {
    int i = 0, j = 0;
    EXPECT_EQ(std::sscanf(status().c_str(), "pixel %d, %d", &i, &j), 2) << status();
    const Rect at = bench().frame(layout());
    PictureSettings settings = setup().picture;
    settings.width = at.width, settings.height = at.height;
    PictureCache pictures{readScene("teapot", 3)};
    return pictures.make(settings, ground()).image().row(j)[i];
  }
};

}  // namespace

// A click on the picture of view 1 explains the pixel under the pointer; a drag turns the scene instead. A
// hand may tremble.
TEST(PixelView, AClickExplains) {
  ReadyWorkbench b;
  const Rect at = b.layout().picture;
  const int x = at.x + at.width / 2 + 60, y = at.y + at.height / 2;
  const std::uint32_t face =
      b.picture().faceImage()[static_cast<std::size_t>(y - at.y) * at.width + (x - at.x)] - 1;
  ASSERT_TRUE(b.grab(x, y));
  b.dragTo(x + 1, y - 1);
  b.settle();
  b.finish();
  EXPECT_EQ(b.view(), View::Pixel);
  EXPECT_NE(b.bench().status().find(": face " + std::to_string(face)), std::string::npos)
      << b.bench().status();
  EXPECT_EQ(b.setup(), b.defaults()) << "nothing was turned";

  b.press('1');
  b.finish();
  ASSERT_TRUE(b.grab(x, y));
  b.dragTo(x + 40, y);
  b.settle();
  b.finish();
  EXPECT_EQ(b.view(), View::Picture);
  EXPECT_NE(b.setup(), b.defaults());
}

// The arrows move by one pixel, with Shift by ten; g goes to a pixel by its numbers, and says what it allows.
TEST(PixelView, KeysChooseThePixel) {
  PixelWindow b;
  b.press('g');
  for (const char c : std::string{"100,60"}) b.press(c);
  b.does(NamedKey::Return);
  EXPECT_TRUE(b.status().starts_with("pixel 100, 60 of ")) << b.status();
  b.does(NamedKey::Right);
  b.does({NamedKey::Down, 0, true});
  EXPECT_TRUE(b.status().starts_with("pixel 101, 70 of ")) << b.status();
  EXPECT_EQ(b.bench().inspected(), b.cellThere());
  b.press('g');
  for (const char c : std::string{"9999,1"}) b.press(c);
  b.press(NamedKey::Return);
  EXPECT_TRUE(b.isAsking());
  b.does(NamedKey::Escape);
  // At the picture's border the pixel stays.
  for (int k = 0; k < 60; ++k) b.press({NamedKey::Up, 0, true});
  b.finish();
  EXPECT_TRUE(b.status().starts_with("pixel 101, 0 of ")) << b.status();
}

// A click in this view's picture chooses the pixel there.
TEST(PixelView, TheMouseChoosesThePixel) {
  PixelWindow b;
  const Rect at = b.bench().picture(b.layout());
  ASSERT_TRUE(b.grab(at.x + 30, at.y + 40));
  b.settle();
  b.finish();
  const Rect all = b.bench().frame(b.layout());  // shown smaller
  const int i = 61 * all.width / (2 * at.width), j = 81 * all.height / (2 * at.height);
  EXPECT_TRUE(b.status().starts_with("pixel " + std::to_string(i) + ", " + std::to_string(j) + " of "))
      << b.status();
}

// A changed setting keeps the pixel. In any method the cell that is explained is the one that the window
// shows.
TEST(PixelView, ASettingKeepsThePixel) {
  PixelWindow b;
  const std::string pixel = b.status().substr(0, b.status().find(" of "));
  for (const Shading method :
       {Shading::Gouraud, Shading::Phong, Shading::Environment, Shading::Full, Shading::Depth}) {
    b.change('S', [&](xnewell::Setup& s) { s.picture.shading = method; });
    b.finish();
    EXPECT_TRUE(b.status().starts_with(pixel)) << b.status();
    EXPECT_EQ(b.bench().inspected(), b.cellThere()) << rowOf(method).name;
  }
  b.type("s");
  b.does(NamedKey::Right);  // the arrows are those of ks now
  EXPECT_TRUE(b.status().starts_with(pixel)) << b.status();
  b.does(NamedKey::Escape);
  b.does(NamedKey::Right);
  EXPECT_FALSE(b.status().starts_with(pixel)) << b.status();
}

// A hue changes only colours, not indices. The page states the colour that the cell holds, so it is drawn
// again.
TEST(PixelView, AHueIsStated) {
  PixelWindow b;
  const IndexImage before = b.image();
  b.does('H');
  EXPECT_NE(b.image(), before);
  const IndexImage blue = b.image();
  b.press('1');
  b.finish();
  b.does('8');
  EXPECT_EQ(b.image(), blue) << "as if it were drawn for the first time";
}

// h goes back through the polygons that were painted at the pixel, and from the first to the last: also in a
// lecture, whose pages PgUp and PgDn turn.
TEST(PixelView, HGoesThroughTheHistory) {
  PixelWindow b;
  b.type("O");  // a sort by z paints all that is behind, too
  b.finish();
  const auto explained = [&] { return b.bench().report(); };
  const PixelHistory history =
      historyOf(b.picture(), b.picture().settings().width / 2, b.picture().settings().height / 2);
  ASSERT_GT(history.painted.size(), 1u);
  const std::vector<std::string> last = explained();
  b.does('h');
  EXPECT_NE(explained(), last);
  for (std::size_t k = 1; k < history.painted.size(); ++k) b.does('h');
  EXPECT_EQ(explained(), last);
}

// A question for a number of the page ends when the page has another pixel, and when the pixel is moved. The
// pixel is one of the teapot at the first size and one of the background at the second.
TEST(PixelView, AQuestionEndsWithItsPage) {
  const PixelWindow first, second{"teapot", 800, 600};
  const glm::ivec2 size{first.picture().settings().width, first.picture().settings().height};
  const int width = second.picture().settings().width, height = second.picture().settings().height;
  const auto faces = first.picture().faceImage(), then = second.picture().faceImage();
  glm::ivec2 edge{0};
  for (int k = 0; k < size.x * size.y; ++k) {
    const glm::ivec2 p{k % size.x, k / size.x};
    const int i = static_cast<int>((p.x + 0.5) / size.x * width),
              j = static_cast<int>((p.y + 0.5) / size.y * height);
    if (faces[k] != 0 && then[j * width + i] == 0) edge = p;
  }
  for (const bool drags : {false, true}) {
    PixelWindow b;
    b.press('g');
    b.type(std::to_string(edge.x) + ',' + std::to_string(edge.y));
    b.does(NamedKey::Return);
    b.does('y');
    ASSERT_TRUE(b.isAsking());
    EXPECT_FALSE(b.bench().inspected()) << "hidden";
    if (drags) {
      const Rect at = b.bench().picture(b.layout());
      ASSERT_TRUE(b.grab(at.x + 5, at.y + 5));
      b.press('y');
      b.dragTo(at.x + 6, at.y + 5);
      b.settle();
    } else {
      b.resize(800, 600);
    }
    b.finish();
    EXPECT_FALSE(b.isAsking());
    if (!b.bench().inspected()) b.does(NamedKey::Escape);  // it shows what is hidden still
    EXPECT_TRUE(b.bench().inspected());
  }
}

// In a lesson 8 explains a pixel of the lesson's scene, and 7 goes back.
TEST(PixelView, ExplainsInALesson) {
  ReadyWorkbench b;
  b.teach(readLesson(XNEWELL_DATA_DIR "/lessons/equation-by-hand.json"));
  b.finish();
  b.press('8');
  b.finish();
  EXPECT_EQ(b.view(), View::Pixel);
  EXPECT_EQ(b.scene().divisions, 3) << "the lesson's teapot";
  EXPECT_EQ(b.setup().picture.light.n, 5);
  EXPECT_TRUE(b.bench().status().starts_with("pixel ")) << b.bench().status();
  b.press('7');
  b.finish();
  EXPECT_EQ(b.view(), View::Lesson);
}

// The pixel is that of the step that the keys go to, however quickly they are pressed.
TEST(PixelView, ExplainsAStepThatIsNotDrawnYet) {
  std::vector<std::string> said;
  for (const bool waits : {true, false}) {
    ReadyWorkbench b;
    b.teach(readLesson(XNEWELL_DATA_DIR "/lessons/cycles.json"));
    for (const Key& key : {Key{NamedKey::PageDown}, Key{NamedKey::PageDown}, Key{'8'}}) {
      if (waits) b.finish();
      b.press(key);
    }
    EXPECT_EQ(b.view(), View::Pixel);
    b.finish();
    said.push_back(b.bench().status());
  }
  EXPECT_EQ(said.front(), said.back());
}

}  // namespace xnewell::THIS_FILE
