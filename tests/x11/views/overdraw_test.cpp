#include "x11/views/overdraw.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "depthsort/fragment_spans.h"
#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/model_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// Squares of side 2 in planes of constant z, seen along z, ten pixels to the unit.
Scene squares(const std::vector<glm::dvec3>& centres) {
  Mesh mesh;
  mesh.groupNames = {""};
  for (const glm::dvec3& c : centres) {
    std::vector<int> face;
    for (const glm::dvec2 d : {glm::dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      face.push_back(static_cast<int>(mesh.points.size()));
      mesh.points.push_back(c + glm::dvec3{d, 0});
    }
    mesh.addFace(face, 0);
  }
  return makeScene("squares", mesh, UpAxis::Y);
}

PictureSettings fromAbove(Order order) {
  PictureSettings s;
  s.width = s.height = 100;
  s.order = order;
  s.camera.eye = glm::dvec3{0, 0, 20};
  s.camera.lookAt = glm::dvec3{0, 0, 0};
  s.camera.parallel = true;
  s.camera.height = 10.0;
  return s;
}

}  // namespace

// A worked example: three squares of 20 x 20 pixels, each covering a quarter of the one before. Each has 400
// samples. The first two share 100 samples, the last two share 100, and no sample is in all three.
TEST(Overdraw, OfOverlappingSquaresIsCounted) {
  PictureCache pictures{squares({{-1, -1, 0}, {0, 0, 1}, {1, 1, 2}})};
  pictures.make(fromAbove(Order::ZSort));
  const Overdraw o = overdrawOf(pictures.last());
  EXPECT_EQ(o.painted, 1200);
  EXPECT_EQ(o.samples, 1000);
  EXPECT_EQ(o.once, 800);
  EXPECT_EQ(o.most, 2);
  EXPECT_DOUBLE_EQ(o.mean(), 1.2);
  // The first two overlap in x, y in [-1, 0]: pixels 40 to 49 across, 50 to 59 down.
  for (int j = 0; j < 100; ++j)
    for (int i = 0; i < 100; ++i) {
      const bool first = i >= 30 && i < 50 && j >= 50 && j < 70,
                 second = i >= 40 && i < 60 && j >= 40 && j < 60,
                 third = i >= 50 && i < 70 && j >= 30 && j < 50;
      ASSERT_EQ(o.times[100 * j + i], first + second + third) << i << ", " << j;
    }
  EXPECT_EQ(o.mostAt, 100u * 40 + 50);
}

// The sum over the samples is the length of all spans, in every order. The samples that show something are
// those of the oracle, which paints each sample once.
TEST(Overdraw, AddsUpToTheSpans) {
  int cut = 0, more = 0;
  for (const char* const name : {"teapot", "penetrate", "cycle", "hues"}) {
    PictureCache pictures{readScene(name, 3)};
    PictureSettings s;
    s.width = 230, s.height = 170;
    s.camera = completed({}, pictures.scene().camera);
    s.order = Order::Oracle;
    pictures.make(s);
    const Overdraw oracle = overdrawOf(pictures.last());
    EXPECT_EQ(oracle.most, 1);
    EXPECT_EQ(oracle.once, oracle.samples);
    EXPECT_EQ(oracle.painted, oracle.samples);
    for (const Order order : {Order::Unsorted, Order::ZMean, Order::ZSort, Order::Newell, Order::Bsp}) {
      s.order = order;
      pictures.make(s);
      const Overdraw o = overdrawOf(pictures.last());
      std::int64_t spans = 0;
      for (const Fragment& fragment : pictures.last().sorted().fragments)
        forEachSpan(pictures.last().snapped(), pictures.last().sorted(), fragment, s.width, s.height,
                    [&](int, int from, int to) { spans += to - from; });
      EXPECT_EQ(o.painted, spans);
      EXPECT_EQ(o.samples, oracle.samples);
      EXPECT_EQ(o.times.size(), std::size_t{230} * 170);
      EXPECT_EQ(o.times[o.mostAt], o.most);
      cut += pictures.last().sorted().statistics.splits > 0;
      more += o.most > 2;
    }
  }
  EXPECT_GE(cut, 2);
  EXPECT_GE(more, 4);
}

// Each sample of the map has the cell of the step that its count falls in, or the ground if nothing was
// painted there.
TEST(Overdraw, MapStepsByTheCount) {
  Overdraw o{.width = 12, .times = {0, 1, 2, 3, 4, 5, 8, 9, 100, 0, 1, 7}};
  const CellPlan plan;
  const IndexImage map = overdrawImage(o, plan);
  ASSERT_EQ(map.height, 1);
  constexpr std::array kExpected{Cell::Well,     Cell::WellLine, Cell::Soft,     Cell::Faint,
                                 Cell::WellText, Cell::White,    Cell::White,    Cell::Q,
                                 Cell::Q,        Cell::Well,     Cell::WellLine, Cell::White};
  for (std::size_t k = 0; k < kExpected.size(); ++k) EXPECT_EQ(map.pixels[k], plan[kExpected[k]]) << k;
}

// The finding gives the counted numbers. If nothing was counted, it says that.
TEST(Overdraw, FindingIsOfTheNumbers) {
  PictureCache pictures{squares({{-1, -1, 0}, {0, 0, 1}, {1, 1, 2}})};
  pictures.make(fromAbove(Order::ZSort));
  Finding finding = findingOf(overdrawOf(pictures.last()), pictures.last());
  EXPECT_EQ(finding.bold, "A sample is painted 1.20 times on average, 2 at most.");
  EXPECT_EQ(finding.why.substr(0, 43), "16.7 % of all painted samples are painted o");
  pictures.make(fromAbove(Order::Oracle));
  finding = findingOf(overdrawOf(pictures.last()), pictures.last());
  EXPECT_EQ(finding.bold, "Every sample is painted once.");
  pictures.make(fromAbove(Order::ZBuffer24));
  finding = findingOf(overdrawOf(pictures.last()), pictures.last());
  EXPECT_EQ(finding.bold, "Every sample is painted once.");
  EXPECT_EQ(
      finding.why,
      "The z-buffer found the face that each sample shows by 1,200 tests of a depth, one for each sample "
      "of each face.");
  PictureSettings away = fromAbove(Order::Newell);
  away.camera.eye = glm::dvec3{90, 0, 20};
  away.camera.lookAt = glm::dvec3{90, 0, 0};
  pictures.make(away);
  EXPECT_EQ(findingOf(overdrawOf(pictures.last()), pictures.last()).bold, "Nothing shows.");
}

}  // namespace xnewell::THIS_FILE
