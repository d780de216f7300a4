#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "depthsort/oracle.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/staged_view.h"
#include "x11/sides/side_by_side_view.h"
#include "x11/sides/sides.h"
#include "x11/sides/sides_page.h"

namespace xnewell::THIS_FILE {

namespace {

/// A picture, painted.
struct Made {
  Picture picture;
  Palette palette;
  Made(const Scene& scene, const PictureSettings& settings)
      : picture{makePicture(scene, settings, CellPlan{}[Cell::Well])},
        palette{picture.palette(CellPlan{settings.table.kind})} {}
  [[nodiscard]] ColoredPicture painted() const { return {picture, palette}; }
  [[nodiscard]] Difference errors() const {
    return comparedWithReference(picture, GroundTruth{picture}).difference;
  }
};

PictureSettings viewOf(const Scene& scene, Shading shading = Shading::Flat, Order order = Order::Newell) {
  PictureSettings s;
  s.width = 220, s.height = 150;
  s.shading = shading;
  s.order = order;
  s.camera = completed({}, scene.camera);
  return s;
}

Rgb16 onScreen(Rgb16 c) {
  return {static_cast<std::uint16_t>(c.r >> 8), static_cast<std::uint16_t>(c.g >> 8),
          static_cast<std::uint16_t>(c.b >> 8)};
}

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

// Two pictures made alike differ nowhere, whatever their cells hold and whatever is measured.
TEST(Sides, AlikeDifferNowhere) {
  for (const auto& [name, plan] : someOf({std::pair{"hues", ColorPlan::Needed},
                                          {"teapot", ColorPlan::Needed},
                                          {"tori", ColorPlan::Chosen},
                                          {"spotlight", ColorPlan::Needed}},
                                         1)) {
    SCOPED_TRACE(name);
    const Scene scene = readScene(name, 3);
    PictureSettings s = viewOf(scene, Shading::Gouraud, Order::ZSort);
    s.colors = plan;
    Made A{scene, s}, B{scene, s};
    const Difference ofA = A.errors(), ofB = B.errors();
    for (const UnlikeRow& row : kUnlikes) {
      if (row.id == Unlike::Intensity && !hasIntensities(A.picture, B.picture)) continue;
      const Difference u = unlikeness(row.id, A.painted(), B.painted());
      EXPECT_GT(u.errors.count, 2000);
      EXPECT_EQ(u.above, 0);
      EXPECT_EQ(u.errors.largest, 0.0);
      EXPECT_TRUE(placesOf(u, 30, 40).empty());
      EXPECT_EQ(findingOf(A.picture, B.picture, ofA, ofB, u, {}).bold, "A and B have the same settings.");
    }
    EXPECT_TRUE(differencesOf(s, s).empty());
    EXPECT_FALSE(onePalette(A.painted(), B.painted(), CellPlan{}, A.palette).shared);
  }
}

// A sample has another face if another face of the model shows there. Samples that differ from the oracle's
// picture are counted as wrong, except where faces lie too close to tell.
TEST(Sides, CountsOtherFaces) {
  const Scene scene = readScene("penetrate");
  Made A{scene, viewOf(scene, Shading::Flat, Order::ZSort)},
      B{scene, viewOf(scene, Shading::Flat, Order::Oracle)};
  const std::vector<std::uint32_t> a = A.picture.faceImage(), b = B.picture.faceImage();
  std::int64_t others = 0, samples = 0;
  for (std::size_t k = 0; k < a.size(); ++k) others += a[k] != b[k], samples += a[k] != 0 || b[k] != 0;
  const Difference u = unlikeness(Unlike::Face, A.painted(), B.painted());
  EXPECT_EQ(u.above, others);
  EXPECT_EQ(u.errors.count, samples);
  EXPECT_GT(u.above, 500);
  EXPECT_LE(A.errors().wrongFaces, others);
  EXPECT_GT(A.errors().wrongFaces, others * 99 / 100);
  EXPECT_EQ(B.errors().wrongFaces, 0);
  // At a sample that differs in no face, the wrong piece of the right face may show.
  for (const int divisions : {2, 3, 5, 8}) {
    const Scene pot = readScene("teapot", divisions);
    Made z{pot, viewOf(pot, Shading::Flat, Order::ZSort)},
        oracle{pot, viewOf(pot, Shading::Flat, Order::Oracle)};
    EXPECT_LE(z.errors().wrongFaces, unlikeness(Unlike::Face, z.painted(), oracle.painted()).above);
  }
  Made C{scene, viewOf(scene)};
  EXPECT_EQ(unlikeness(Unlike::Face, B.painted(), C.painted()).above, 0);
}

// Differences of intensity are those of the surfaces to within one shade, and the numbers are computed from
// them.
TEST(Sides, IntensitiesAreThoseOfTheSurfaces) {
  const Scene scene = readScene("teapot", 3);
  Made A{scene, viewOf(scene, Shading::Flat)}, B{scene, viewOf(scene, Shading::Gouraud)};
  const Difference u = unlikeness(Unlike::Intensity, A.painted(), B.painted());
  const std::vector<double> a = A.picture.intensities(A.picture.seen(0, 150)),
                            b = B.picture.intensities(B.picture.seen(0, 150));
  double largest = 0;
  std::int64_t samples = 0, differ = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(std::isnan(a[k]), std::isnan(u.at[k]));
    if (std::isnan(a[k])) continue;
    ASSERT_NEAR(u.at[k], std::abs(a[k] - b[k]), 1.02 / 239);
    ++samples, differ += u.at[k] > 1.0 / 240;
    largest = std::max(largest, double{u.at[k]});
  }
  EXPECT_EQ(u.errors.count, samples);
  EXPECT_EQ(u.above, differ);
  EXPECT_GT(differ, samples / 2);
  EXPECT_DOUBLE_EQ(u.errors.largest, largest);
}

// The first place has more differing samples than any other frame of its size. Each of the others has no more
// of the rest than the one before. If only a few samples differ, each lies in some place.
TEST(Sides, PlacesAreTheDensest) {
  Difference u{ErrorMap{.width = 100, .at = std::vector<float>(100 * 60, 0.0f)}};
  const auto spot = [&](int x, int y, int width, int height) {
    for (int j = y; j < y + height; ++j)
      for (int i = x; i < x + width; ++i) u.at[100 * j + i] = 1, ++u.above;
  };
  spot(10, 10, 6, 5), spot(70, 40, 4, 4), spot(95, 2, 2, 3);
  std::vector<DifferingPlace> places = placesOf(u, 12, 15);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].samples, 30);
  EXPECT_EQ(places[1].samples, 16);
  EXPECT_EQ(places[2].samples, 6);
  EXPECT_EQ(places[0].frame, (Rect{7, 5, 12, 15}));   // the spot is in its middle
  EXPECT_EQ(places[2].frame, (Rect{88, 0, 12, 15}));  // the frame stays inside the picture
  for (int k = 0; k < 12; ++k) spot(8 * k, 55, 2, 2);
  places = placesOf(u, 4, 4);
  EXPECT_EQ(places.size(), std::size_t{kMostPlaces});
  EXPECT_TRUE(std::ranges::is_sorted(places, std::greater{}, &DifferingPlace::samples));
  EXPECT_FALSE(placesOf(u, 500, 500).empty());
}

// If two tables hold different colours, both pictures are shown in one palette. If there are at most 240
// colours, every sample has exactly the colour that its own table stores, as 8 bits show it.
TEST(Sides, OnePaletteShowsBoth) {
  const Scene scene = readScene("teapot", 3);
  PictureSettings a = viewOf(scene), b = a;
  b.table.kind = TableKind::Corrected;
  for (const TableKind kind : {TableKind::Linear, TableKind::Brief}) {
    a.table.kind = kind;
    Made A{scene, a}, B{scene, b};
    const CellPlan plan{kind};
    const OnePalette one = onePalette(A.painted(), B.painted(), plan, A.picture.palette(plan));
    EXPECT_TRUE(one.shared);
    EXPECT_TRUE(one.exact);
    EXPECT_EQ(withInterface(one.palette, plan), one.palette);
    int samples = 0, others = 0;
    for (const auto& [made, image] : {std::pair{&A, &one.A}, {&B, &one.B}}) {
      const SeenRows seen = made->picture.seen(0, 150);
      for (std::size_t k = 0; k < image->pixels.size(); ++k) {
        if (seen.faces[k] == kNothing) {
          ASSERT_EQ(image->pixels[k], plan[Cell::Well]);
          continue;
        }
        ++samples;
        ASSERT_EQ(onScreen(one.palette[image->pixels[k]]),
                  onScreen(made->palette[made->picture.image().pixels[k]]));
        others += onScreen(A.palette[A.picture.image().pixels[k]]) !=
                  onScreen(B.palette[B.picture.image().pixels[k]]);
      }
    }
    EXPECT_GT(samples, 10'000);
    EXPECT_GT(others, samples / 2);
  }
  // With more colours the samples have the nearest ones, and the result says so.
  const Scene hues = readScene("hues");
  Made A{hues, viewOf(hues, Shading::Flat)}, B{hues, viewOf(hues, Shading::Phong)};
  const OnePalette one = onePalette(A.painted(), B.painted(), CellPlan{}, A.palette);
  EXPECT_TRUE(one.shared);
  EXPECT_EQ(one.colors, 240);
  EXPECT_FALSE(one.exact);
}

// The page's parts lie inside the body and do not overlap. The three pictures have one scale.
TEST(SidesLayout, HasRoomForAll) {
  for (const Rect body : {Rect{16, 43, 768, 449},
                          {16, 48, 992, 612},
                          {16, 48, 1568, 1044},
                          {16, 43, 2968, 549},
                          {16, 43, 768, 1500}}) {
    SCOPED_TRACE(testing::Message() << body.width << " x " << body.height);
    const SidesLayout at = layoutOfSides(body);
    const std::array parts{at.captionA, at.captionB, at.A, at.B, at.difference, at.numbers};
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_EQ(intersection(parts[k], body), parts[k]) << k;
      EXPECT_FALSE(parts[k].empty()) << k;
      for (std::size_t l = 0; l < k; ++l) EXPECT_TRUE(intersection(parts[k], parts[l]).empty()) << k << l;
    }
    EXPECT_EQ(at.A.width, at.B.width);
    EXPECT_EQ(at.A.height, at.B.height);
    EXPECT_EQ(at.difference.width, at.A.width);
    EXPECT_GE(at.A.height, 160);
    EXPECT_LE(at.difference.height, at.A.height);
    EXPECT_GE(at.difference.height, 160);
    EXPECT_LT(at.frameHeight, at.A.height);
  }
}

// Two setups side by side, without a server.

// Dragging either picture turns both.
TEST(SideBySideView, TheCameraIsShared) {
  Shown s;
  const auto camera = [&] { return s.stage.now.picture.camera; };
  for (const Rect& picture : {s.at().A, s.at().B}) {
    const CameraSettings before = camera();
    const IndexImage drawn = s.B();
    ASSERT_TRUE(s.bench.grab(picture.x + 9, picture.y + 9));
    EXPECT_EQ(camera(), before);
    s.bench.dragTo(picture.x + 29, picture.y + 9);
    s.bench.drop();
    EXPECT_NE(camera(), before);
    s.stage.draw(s.bench);
    EXPECT_EQ(s.setupB().picture.camera, camera());
    EXPECT_NE(s.B(), drawn);
  }
}

// One swap makes the pictures change places; the difference, which is an amount, looks the same. Space shows
// B in A's place. A second swap or Space, Esc and leaving the view show A again, pixel for pixel.
TEST(SideBySideView, SwapsAndBlinksInPlace) {
  Shown s{"teapot", ordered(Order::ZSort)};
  s.press("S");
  const IndexImage pictures = s.pictures(), left = s.A(), right = s.B(), difference = s.difference();
  EXPECT_NE(left, right);
  s.press("x");
  EXPECT_EQ(s.A(), right);
  EXPECT_EQ(s.B(), left);
  EXPECT_EQ(s.difference(), difference);
  s.press("x");
  EXPECT_EQ(s.pictures(), pictures);
  const std::function<void()> kBack[]{[&] { s.press(NamedKey::Space); }, [&] { s.press(NamedKey::Escape); },
                                      [&] { s.bench.leave(), s.stage.draw(s.bench); }};
  for (const auto& back : kBack) {
    s.press(NamedKey::Space);
    EXPECT_EQ(s.A(), right);
    EXPECT_EQ(s.B(), right);
    back();
    EXPECT_EQ(s.pictures(), pictures);
  }
}

// f goes through the kinds of difference and comes back to the first. n goes through the places, frame by
// frame, and comes back to the first.
TEST(SideBySideView, KindsAndPlacesGoRound) {
  Shown s{"teapot", ordered(Order::ZSort)};
  const IndexImage face = s.difference(), pictures = s.pictures();
  for (const bool same : {false, false, true}) {
    s.press("f");
    EXPECT_EQ(s.difference() == face, same);
  }
  int places = 0;
  do {
    s.press("n");
    ASSERT_LE(++places, kMostPlaces);
  } while (s.pictures() != pictures);
  EXPECT_GT(places, 1);
  EXPECT_EQ(s.difference(), face);
}

// When A becomes as B is, its picture is B's, no mark stays, and the captions have no words but their
// letters.
TEST(SideBySideView, AlikeIsDrawnAlike) {
  Shown s{"teapot", ordered(Order::ZSort)};
  const Rect caption = s.at().captionA, at = s.at().difference;
  for (const bool alike : {false, true}) {
    const IndexImage marked = s.stage.part({at.x, at.y + 24, at.width, at.height - 24});
    EXPECT_EQ(s.A() == s.B(), alike);
    EXPECT_EQ(std::ranges::count(marked.pixels, CellPlan{}[Cell::Q]) == 0, alike);
    EXPECT_EQ(inkIn(s.stage.part({caption.x + 24, caption.y, caption.width - 24, caption.height})) == 0,
              alike);
    s.press("AO");  // Newell, as B
  }
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
