#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/seeds.h"
#include "tests/x11/support/staged_view.h"
#include "x11/sides/side_by_side_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// A bench on a stage, drawn.
struct Shown {
  StagedView stage;
  SideBySideView bench{stage,
                       [this] {
                         return Subject{stage.pictures.scene(), glm::dvec3{0}, 1.5};
                       },
                       [] { return kMaxShades; }};
  explicit Shown(const char* scene = "teapot", const xnewell::Setup& setup = {}, int width = 1024,
                 int height = 768)
      : stage{scene, 3, width, height, setup} {
    stage.draw(bench);
  }
  void press(std::string_view letters) {
    for (const char c : letters) {
      stage.press(bench, std::string_view{&c, 1});
      EXPECT_TRUE(stage.taken) << c;
    }
    stage.draw(bench);
  }
  void press(NamedKey key) { stage.press(bench, key), stage.draw(bench); }
  [[nodiscard]] SidesLayout at() const { return layoutOfSides(stage.layout.body); }
  [[nodiscard]] IndexImage A() const { return stage.part(at().A); }
  [[nodiscard]] IndexImage B() const { return stage.part(at().B); }
  [[nodiscard]] IndexImage difference() const { return stage.part(at().difference); }
  /// The body without the numbers, which include measured times.
  [[nodiscard]] IndexImage pictures() const {
    const Rect& body = stage.layout.body;
    return stage.part({body.x, body.y, body.width, at().sections.y - body.y});
  }
  [[nodiscard]] xnewell::Setup setupB() const { return bench.beside(stage.now); }
};

Setup ordered(Order order, Shading shading = Shading::Flat) {
  Setup s;
  s.picture.order = order, s.picture.shading = shading;
  return s;
}

int inkIn(const IndexImage& image) {
  return static_cast<int>(std::ranges::count(image.pixels, CellPlan{}[Cell::Ink]));
}

}  // namespace

// Two setups side by side, without a server.

// At first B differs from A in the order alone. If A's order is exact, B's is not; otherwise B's is exact.
TEST(SideBySideView, BeginsWithAnotherOrder) {
  for (const OrderRow& row : someOf(kOrders, 2)) {
    const Shown s{"teapot", ordered(row.id)};
    EXPECT_EQ(s.setupB().picture.order, row.exact ? Order::ZSort : Order::Newell);
    EXPECT_EQ(differencesOf(s.stage.now.picture, s.setupB().picture), std::vector<std::string>{"order"});
    EXPECT_EQ(s.bench.status(), sidesStatus(s.stage.now.picture, s.setupB().picture));
  }
}

// A control's letter changes the setup in focus and leaves the other alone. It changes the window's own setup
// through the host, so that the change can be undone.
TEST(SideBySideView, KeysChangeTheOneInFocus) {
  for (const char key : someOf({'S', 'N', 'O', 'K', 'T', 'L', 'V', 'H'}, 2)) {
    SCOPED_TRACE(key);
    Shown s{"teapot", ordered(Order::Newell, Shading::Gouraud)};
    const xnewell::Setup A = s.stage.now, B = s.setupB();
    s.press({&key, 1});
    EXPECT_EQ(s.stage.now, A);
    EXPECT_NE(s.setupB(), B);
    const xnewell::Setup changed = s.setupB();
    s.press("A"), s.press({&key, 1});
    EXPECT_NE(s.stage.now, A);
    EXPECT_EQ(s.setupB(), changed);
    EXPECT_EQ(s.stage.undone, std::vector{A});
  }
  for (const char key : someOf({'i', 'p', 'a', 'd', 's', 'c'}, 1)) {
    SCOPED_TRACE(key);
    Shown s;
    const xnewell::Setup A = s.stage.now, B = s.setupB();
    s.press({&key, 1});
    EXPECT_EQ(s.setupB(), B);
    s.press(NamedKey::Left);
    EXPECT_TRUE(s.stage.taken);
    EXPECT_EQ(s.stage.now, A);
    EXPECT_NE(s.setupB(), B);
    EXPECT_NE(s.bench.aside().find(" of B, "), std::string::npos);
    s.press(NamedKey::Right);
    EXPECT_EQ(s.setupB(), B);
    s.press("A");
    s.press(NamedKey::Left);
    EXPECT_NE(s.stage.now, A);
    EXPECT_EQ(s.setupB(), B);
    s.press(NamedKey::Escape);
    s.press(NamedKey::Left);
    EXPECT_FALSE(s.stage.taken);  // the arrows belong to no control here
  }
}

// Turning and zooming apply to both, by their letters and the arrows after them, and by dragging either
// picture. B is drawn with A's camera.
TEST(SideBySideView, TheCameraIsShared) {
  Shown s;
  s.press("s");
  for (const char key : {'t', 'z'}) {
    const CameraSettings camera = s.stage.now.picture.camera;
    s.press({&key, 1});
    s.press(NamedKey::Left);
    EXPECT_NE(s.stage.now.picture.camera, camera);
    EXPECT_EQ(s.setupB().picture.camera, s.stage.now.picture.camera);
  }
  for (const Rect& picture : {s.at().A, s.at().B}) {
    const CameraSettings camera = s.stage.now.picture.camera;
    ASSERT_TRUE(s.bench.grab(picture.x + 9, picture.y + 9));
    EXPECT_EQ(s.stage.now.picture.camera, camera);
    s.bench.dragTo(picture.x + 29, picture.y + 9);
    s.bench.drop();
    EXPECT_NE(s.stage.now.picture.camera, camera);
    s.stage.draw(s.bench);
  }
  s.stage.draw(s.bench);
  const IndexImage before = s.B();
  s.stage.now.picture.camera.fov = 17.0;
  s.stage.draw(s.bench);
  EXPECT_EQ(s.setupB().picture.camera, s.stage.now.picture.camera);
  EXPECT_NE(s.B(), before);
  s.press("P");
  EXPECT_TRUE(s.stage.now.picture.camera.parallel);
  EXPECT_EQ(s.setupB().picture.camera, s.stage.now.picture.camera);
}

// One swap makes the pictures change places; the difference, which is an amount, looks the same. Two swaps
// change nothing.
TEST(SideBySideView, SwapTwiceIsIdentity) {
  Shown s{"teapot", ordered(Order::ZSort)};
  s.press("S");
  const xnewell::Setup A = s.stage.now, B = s.setupB();
  const IndexImage pictures = s.pictures(), left = s.A(), right = s.B(), difference = s.difference();
  EXPECT_NE(left, right);
  s.press("x");
  EXPECT_EQ(s.stage.now, B);
  EXPECT_EQ(s.setupB(), A);
  EXPECT_EQ(s.A(), right);
  EXPECT_EQ(s.B(), left);
  EXPECT_EQ(s.difference(), difference);
  s.press("x");
  EXPECT_EQ(s.stage.now, A);
  EXPECT_EQ(s.setupB(), B);
  EXPECT_EQ(s.pictures(), pictures);
}

// Space shows B in A's place, pixel for pixel, and shows A again the next time. Esc and leaving the view show
// A again too.
TEST(SideBySideView, BlinksInPlace) {
  Shown s{"teapot", ordered(Order::ZSort)};
  const IndexImage left = s.A(), right = s.B(), pictures = s.pictures();
  EXPECT_NE(left, right);
  s.press(NamedKey::Space);
  EXPECT_TRUE(s.stage.taken);
  EXPECT_EQ(s.A(), right);
  EXPECT_EQ(s.B(), right);
  s.press(NamedKey::Space);
  EXPECT_EQ(s.pictures(), pictures);
  s.press(NamedKey::Space);
  s.press(NamedKey::Escape);
  EXPECT_EQ(s.pictures(), pictures);
  s.press(NamedKey::Space);
  s.bench.leave();
  s.stage.draw(s.bench);
  EXPECT_EQ(s.pictures(), pictures);
}

// f goes through the kinds of difference and comes back to the first. n goes through the places, frame by
// frame, and comes back to the first.
TEST(SideBySideView, KindsAndPlacesGoRound) {
  Shown s{"teapot", ordered(Order::ZSort)};
  const IndexImage face = s.difference(), pictures = s.pictures();
  s.press("f");
  EXPECT_NE(s.difference(), face);
  s.press("f");
  EXPECT_NE(s.difference(), face);
  s.press("f");
  EXPECT_EQ(s.difference(), face);
  int places = 0;
  do {
    s.press("n");
    ASSERT_LE(++places, kMostPlaces);
  } while (s.pictures() != pictures);
  EXPECT_GT(places, 1);
  EXPECT_EQ(s.difference(), face);
}

// If A and B are set up alike, the pictures are the same, the difference is empty, and only the finding is
// bold.
TEST(SideBySideView, AlikeIsSaid) {
  Shown s{"teapot", ordered(Order::ZSort)};
  const Rect &caption = s.at().captionA, &difference = s.at().difference;
  EXPECT_GT(inkIn(s.stage.part(caption)), 100);
  s.press("AO");  // Newell, as B
  EXPECT_EQ(s.stage.now, s.setupB());
  EXPECT_EQ(s.A(), s.B());
  EXPECT_EQ(s.bench.status(), sidesStatus(s.stage.now.picture, s.setupB().picture));
  EXPECT_EQ(inkIn(s.stage.part({caption.x + 24, caption.y, caption.width - 24, caption.height})), 0);
  const Rect below{difference.x, difference.y + 24, difference.width, difference.height - 24};
  EXPECT_EQ(std::ranges::count(s.stage.part(below).pixels, CellPlan{}[Cell::Q]), 0);
  const std::size_t notices = s.stage.notices.size();
  s.press("n");
  EXPECT_EQ(s.stage.notices.size(), notices + 1);
}

// While something is dragged, the pictures follow at once and the numbers are faint. When the drag is over,
// the numbers follow, and all looks as if it had been drawn at once.
TEST(SideBySideView, NumbersFollowWhenADragIsOver) {
  Shown s{"teapot", ordered(Order::ZSort)};
  const IndexImage before = s.B();
  s.stage.now.picture.camera.fov = 17.0;
  s.stage.draw(s.bench, true);
  EXPECT_NE(s.B(), before);
  EXPECT_EQ(s.bench.aside(), "numbers follow");
  const auto finding = [&] {
    return std::ranges::count(s.stage.part(s.at().numbers).pixels, CellPlan{}[Cell::White]);
  };
  EXPECT_EQ(finding(), 0);
  const std::int64_t faint = std::ranges::count(s.stage.part(s.at().numbers).pixels, CellPlan{}[Cell::Faint]);
  EXPECT_GT(faint, 400);
  s.stage.draw(s.bench);  // what is ready comes first
  EXPECT_EQ(s.bench.aside(), "numbers follow");
  EXPECT_TRUE(s.bench.late(s.stage.now));
  s.stage.draw(s.bench);
  EXPECT_EQ(s.bench.aside(), "the numbers are of these pictures");
  EXPECT_GT(finding(), 1000);
  Shown fresh{"teapot", s.stage.now};
  EXPECT_EQ(s.pictures(), fresh.pictures());
  EXPECT_EQ(s.difference(), fresh.difference());
}

// Extreme cases are drawn and told: nothing to see, a scene with its own lights, colours without intensities,
// a plan of colours that is impossible.
TEST(SideBySideView, ExtremesAreDrawn) {
  xnewell::Setup away;
  away.picture.camera.eye = glm::dvec3{500, 0, 0}, away.picture.camera.lookAt = glm::dvec3{900, 0, 0};
  Shown nothing{"teapot", away};
  EXPECT_EQ(nothing.A(), nothing.B());
  nothing.press("fnxOSTu");

  Shown lights{"spotlight"};
  lights.press("OSTfn");
  EXPECT_NE(lights.A(), lights.B());

  xnewell::Setup colors;
  colors.picture.colors = ColorPlan::Chosen;
  Shown tori{"tori", colors};
  tori.press("f");
  EXPECT_EQ(tori.stage.notices.size(), 1u);  // there are no intensities, so colours are compared at once
  tori.press("S");
  EXPECT_NE(tori.A(), tori.B());
  tori.press("f");

  xnewell::Setup hues;
  hues.picture.colors = ColorPlan::Hues;
  Shown few{"hues", hues};
  few.press("c");
  const std::size_t notices = few.stage.notices.size();
  few.stage.press(few.bench, "c");
  for (int k = 0; k < 24; ++k) few.stage.taken = few.bench.press({NamedKey::Left, 0, true});
  few.stage.draw(few.bench);  // two shades for seven hues
  EXPECT_GT(few.stage.notices.size(), notices);
  EXPECT_GT(few.setupB().picture.table.shades, 13);
}

// At sizes from 800 x 540 up, everything is drawn inside the body, and nothing of the old image is left
// there.
TEST(SideBySideView, EverySizeIsWhole) {
  for (const auto& [width, height] :
       {std::pair{800, 540}, {800, 600}, {801, 767}, {1024, 768}, {1600, 1200}, {3000, 700}}) {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    Shown s{"teapot", ordered(Order::ZSort), width, height};
    std::ranges::fill(s.stage.image.pixels, 123);
    s.stage.draw(s.bench);
    const std::int64_t all = std::ranges::count(s.stage.image.pixels, 123),
                       left = std::ranges::count(s.stage.part(s.stage.layout.body).pixels, 123);
    const Rect& body = s.stage.layout.body;
    EXPECT_GE(all - left + 2 * 19,
              width * height - body.width * body.height);  // the bar that marks the focus
    EXPECT_LT(left, width * height / 50);                  // cell 123 is also a shade of the pictures
    EXPECT_GT(inkIn(s.stage.part(s.at().numbers)), 1500);
    EXPECT_GT(inkIn(s.stage.part(s.at().captionA)), 80);
  }
}

// The pairs that teach something come one after the other, and each pair differs in one setting. A pair also
// sets what it rests on: faces in a right order, unless the pair is about the order, and light.
TEST(SideBySideView, PairsDifferInOneThing) {
  Shown s{"teapot", ordered(Order::Newell, Shading::Phong)},
      unlit{"teapot", ordered(Order::Unsorted, Shading::Full)};
  for (const PairRow& row : kPairs) {
    SCOPED_TRACE(row.name);
    s.press("g"), unlit.press("g");
    EXPECT_EQ(differencesOf(s.stage.now.picture, s.setupB().picture).size(), 1u);
    EXPECT_NE(s.A(), s.B());
    EXPECT_GT(std::ranges::count(s.difference().pixels, CellPlan{}[Cell::Q]) +
                  std::ranges::count(s.difference().pixels, CellPlan{}[Cell::Faint]),
              50);
    const PictureSettings &A = unlit.stage.now.picture, B = unlit.setupB().picture;
    EXPECT_TRUE(rowOf(B.order).exact);
    EXPECT_TRUE(rowOf(A.order).exact || A.order != B.order);
    EXPECT_TRUE(rowOf(A.shading).lit && rowOf(B.shading).lit);
  }
}

}  // namespace xnewell::THIS_FILE
