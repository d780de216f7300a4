#include "shading/picture/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <tuple>

#include "depthsort/oracle.h"
#include "geometry/exact/int128.h"
#include "geometry/model/solids.h"
#include "geometry/view/scanline.h"
#include "shading/laboratory/exactness.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "tests/support/painted_picture.h"
#include "tests/support/small_picture.h"
#include "tests/support/triangle_soup.h"

namespace xnewell::THIS_FILE {

// How often samples are painted, and where the order is wrong. Cells: picture_cells_test.cpp. What one
// picture lends to the next: picture_cache_test.cpp.

namespace {

/// How many faces cover each sample, each edge asked by itself: the sign of its function at the pixel's
/// centre, if 0 of its x coefficient, if 0 of its y coefficient.
std::vector<int> timesCovered(const SnappedScene& scene, int width, int height) {
  std::vector<int> times(std::size_t(width) * height, 0);
  for (const SnappedFace& f : scene.faces) {
    const glm::ivec3* p = &scene.vertices[f.first];
    int x0 = p[0].x, x1 = x0, y0 = p[0].y, y1 = y0;
    for (int v = 1; v < f.count; ++v) {
      x0 = std::min(x0, p[v].x), x1 = std::max(x1, p[v].x);
      y0 = std::min(y0, p[v].y), y1 = std::max(y1, p[v].y);
    }
    for (int j = std::max(0, y0 / kGrid - 1); j < std::min(height, y1 / kGrid + 2); ++j)
      for (int i = std::max(0, x0 / kGrid - 1); i < std::min(width, x1 / kGrid + 2); ++i) {
        bool inside = true;
        for (int v = 0; v < f.count && inside; ++v) {
          const glm::ivec3 &a = p[v], &b = p[(v + 1) % f.count];
          const Int128 A = std::int64_t{b.y} - a.y, B = std::int64_t{a.x} - b.x;
          const Int128 value = A * (std::int64_t{i} * kGrid + kGrid / 2 - a.x) +
                               B * (std::int64_t{j} * kGrid + kGrid / 2 - a.y);
          inside = value > 0 || (value == 0 && (A > 0 || (A == 0 && B > 0)));
        }
        times[std::size_t(j) * width + i] += inside;
      }
  }
  return times;
}

}  // namespace

// Every sample is painted exactly as often as faces cover it: the teapot from several sides and through
// the eye, and random triangles that cross the picture's borders.
TEST(Picture, PaintsEachSampleAsOftenAsFacesCoverIt) {
  long long samples = 0;
  const auto check = [&](PictureCache& pictures, const PictureSettings& s) {
    pictures.make(s);
    const std::vector<int> covered = timesCovered(pictures.last().snapped(), s.width, s.height);
    ASSERT_EQ(timesPainted(pictures.last().snapped(), s.width, s.height), covered);
    samples += std::ranges::count_if(covered, [](int n) { return n > 0; });
  };
  PictureCache teapot{readScene("teapot", 4)};
  for (int view = 0; view < 8; ++view) {
    SCOPED_TRACE(view);
    PictureSettings s = small();
    s.camera.parallel = view % 2 == 0;
    if (view == 3) s.camera.oblique = Oblique{};
    teapot.make(s);
    s.camera = moved(s.camera, teapot.last().camera(), teapot.last().scene(), 50.0 * view, 20.0 * view - 70,
                     view == 7 ? 6.0 : 1.0);
    check(teapot, s);
  }
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    PictureCache soup{makeScene("soup", triangleSoup(300, 0.5, seed), UpAxis::Y)};
    PictureSettings s = small();
    s.camera.eye = glm::dvec3{0.1, 0.2, 0.3 + 0.1 * seed};
    s.camera.lookAt = glm::dvec3{0, 0, -1};
    check(soup, s);
  }
  EXPECT_GT(samples, 200'000);
}

// A closed surface has neither gap nor overlap: with its back faces kept, a sphere paints each sample
// twice or not at all, a torus an even number of times.
TEST(Picture, ClosedSurfacesPaintInPairs) {
  int twice = 0, four = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    PictureCache pictures{makeScene("solid", seed % 2 ? sphere(23, 11) : torus(29, 13), UpAxis::Z)};
    PictureSettings s = small();
    s.camera.parallel = seed % 3 == 0;
    pictures.make(s);
    s.camera = moved(s.camera, pictures.last().camera(), pictures.last().scene(), 17.0 * seed,
                     7.0 * seed - 100, 1.3);
    pictures.make(s);
    for (const int n : timesPainted(pictures.last().snapped(), s.width, s.height)) {
      ASSERT_EQ(n % 2, 0);
      if (seed % 2) {
        ASSERT_LE(n, 2);
      }
      twice += n == 2;
      four += n == 4;
    }
  }
  EXPECT_GT(twice, 100'000);
  EXPECT_GT(four, 10'000);
}

// The face image names the face that is seen: number + 1, 0 where nothing is; pieces of a divided face
// carry its number.
TEST(Picture, FaceImageNamesFaces) {
  Mesh m;
  m.points = {{-1, -1, 0},    {1, -1, 0}, {1, 1, 0},     {-1, 1, 0},    {-0.5, -0.5, 1},
              {0.5, -0.5, 1}, {0, 0, 1},  {0.5, 0.5, 1}, {-0.5, 0.5, 1}};
  const int floor[] = {0, 1, 2, 3}, concave[] = {4, 5, 6, 7, 8};
  m.addFace(floor, 0);
  m.addFace(concave, 0);
  PictureCache pictures{makeScene("two", m, UpAxis::Y)};
  EXPECT_GT(pictures.scene().parts.count(), 2);
  PictureSettings s = small();
  s.camera.parallel = true;
  s.camera.eye = glm::dvec3{0, 0, 3};
  s.camera.lookAt = glm::dvec3{0};
  s.camera.height = 2.4;
  pictures.make(s);
  const std::vector<std::uint32_t> ids = pictures.last().faceImage();
  const auto at = [&](double x, double y) {  // of the file's coordinates
    return ids[std::size_t(90 - y / 2.4 * 180) * 240 + std::size_t(120 + x / 2.4 * 180)];
  };
  EXPECT_EQ(at(-0.25, 0), 2u);
  EXPECT_EQ(at(0.3, 0), 1u);  // seen through the notch
  EXPECT_EQ(at(0.1, 0.3), 2u);
  EXPECT_EQ(at(0.8, 0.8), 1u);
  EXPECT_EQ(at(1.1, 0), 0u);
}

// The painter is right where no order can be wrong: a convex solid without its back faces, in every
// order. The oracle is right everywhere, and knows where sorting the teapot by z is not.
TEST(Picture, OracleKnowsWhereTheOrderIsWrong) {
  PictureCache ball{makeScene("ball", sphere(20, 10), UpAxis::Z)};
  PictureCache teapot{readScene("teapot", 4)};
  for (const OrderRow& row : kOrders) {
    SCOPED_TRACE(row.name);
    PictureSettings s = small();
    s.order = row.id;
    teapot.make(s);
    const Exactness e = exactnessOf(teapot.last());
    EXPECT_GT(e.samples, 10'000);
    // The surfaces of this teapot are further apart than a quantum of 16 bits, at samples of this size.
    EXPECT_EQ(e.wrong == 0, row.exact || row.bits > 0);
    s.cull = Cull::Back;
    ball.make(s);
    EXPECT_EQ(exactnessOf(ball.last()).wrong, 0);
  }
}

// A picture is counted in bands of rows. Bands of all heights count the same as the verdicts on all samples,
// and see the same faces, also if the last band is shorter.
TEST(Picture, BandsCountTheSameAsTheWhole) {
  PictureCache teapot{readScene("teapot", 3)};
  PictureSettings s = small();
  s.order = Order::ZMean, s.width = 1'021, s.height = 700;  // 128 rows in a band, 60 in the last
  teapot.make(s);
  const std::vector<SampleCheck> verdicts = checkedSamples(teapot.last());
  const Exactness bands = exactnessOf(teapot.last()), whole = exactnessOf(verdicts);
  EXPECT_GT(whole.wrong, 1'000);
  EXPECT_EQ(bands.samples, whole.samples);
  EXPECT_EQ(bands.wrong, whole.wrong);
  EXPECT_EQ(bands.doubtful, whole.doubtful);
  const Picture complete = teapot.last().withPlanes();
  const std::vector<int> all = visibleFaces(complete.snapped(), s.width, s.height);
  VisibleFaces oracle{complete.snapped()};
  for (const auto& [first, end] : {std::pair{0, 1}, std::pair{131, 297}, std::pair{640, 700}}) {
    const std::vector<int> rows = oracle.rows(first, end, s.width);
    ASSERT_EQ(rows.size(), std::size_t(end - first) * s.width);
    EXPECT_TRUE(std::ranges::equal(rows, std::span{all}.subspan(std::size_t(first) * s.width, rows.size())))
        << first;
  }
}

// Posters in the plane of a slanted wall are in one plane, so that their order is the scene's. Had each a
// plane of its own, the snap would part them, but a picture that shows them in the scene's order is called
// right. Without the rounding's allowance it is not.
TEST(Picture, CoplanarFacesAreNotCalledWrong) {
  Scene scene = readScene("decals");
  EXPECT_EQ(std::ranges::max(scene.parts.plane), 0);
  std::iota(scene.parts.plane.begin(), scene.parts.plane.end(), 0);
  scene.parts.planes = {}, scene.parts.own = {}, scene.parts.frame.reset();
  PictureCache decals{std::move(scene)};
  PictureSettings s = small();
  s.order = Order::Unsorted;
  int doubtful = 0;
  for (int view = 0; view < 12; ++view) {
    SCOPED_TRACE(view);
    decals.make(s);
    EXPECT_EQ(exactnessOf(decals.last()).wrong, 0);
    const std::vector<std::uint32_t> listed = decals.last().faceImage();
    s.order = Order::Oracle;
    decals.make(s);
    const std::vector<std::uint32_t> seen = decals.last().faceImage();
    for (std::size_t k = 0; k < seen.size(); ++k) doubtful += seen[k] != listed[k];
    s.order = Order::Unsorted;
    s.camera = moved(s.camera, decals.last().camera(), decals.last().scene(), 29, view % 2 ? 11 : -9, 1.02);
  }
  EXPECT_GT(doubtful, 1000);
}

// What is seen is known without the hidden faces, whatever the order is: the same faces at every sample.
TEST(Picture, KnowsWhatIsSeenWithoutHiddenFaces) {
  const Scene scene = readScene("teapot", 6);
  for (const OrderRow& order : kOrders) {
    SCOPED_TRACE(order.name);
    PictureSettings s = small();
    s.order = order.id;
    const Picture all = makePicture(scene, s, 8), shown = all.onlyShown();
    EXPECT_EQ(shown.faceImage(), all.faceImage());
    EXPECT_EQ(shown.image(), all.image());
    EXPECT_EQ(shown.palette(CellPlan{}), all.palette(CellPlan{}));
    const SnappedScene &few = shown.snapped(), &many = all.snapped();
    const std::vector<int> seenFew = shown.seen(0, s.height).faces, seen = all.seen(0, s.height).faces;
    std::set<int> different;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      ASSERT_EQ(seenFew[k] == kNothing, seen[k] == kNothing);
      if (seen[k] == kNothing) continue;
      different.insert(seen[k]);
      const SnappedFace &a = few.faces[seenFew[k]], &b = many.faces[seen[k]];
      ASSERT_EQ(std::tuple(a.number, a.part, a.back, a.count), std::tuple(b.number, b.part, b.back, b.count));
      for (int v = 0; v < a.count; ++v) {
        ASSERT_EQ(few.vertices[a.first + v], many.vertices[b.first + v]);
        ASSERT_EQ(few.source[a.first + v], many.source[b.first + v]);
      }
    }
    EXPECT_EQ(few.faces.size(), different.size());
    EXPECT_LT(few.faces.size(), many.faces.size() * 3 / 4);
  }
}

}  // namespace xnewell::THIS_FILE
