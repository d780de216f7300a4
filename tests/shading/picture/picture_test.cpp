#include "shading/picture/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <set>

#include "geometry/exact/int128.h"
#include "geometry/model/solids.h"
#include "shading/fill/scanline.h"
#include "tests/support/painted_picture.h"
#include "tests/support/small_picture.h"

namespace xnewell {

// How often samples are painted, what is kept from picture to picture, and where the order is wrong. The
// cells: picture_cells_test.cpp.

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

bool sameBits(const std::vector<FrontBack<double>>& a, const std::vector<FrontBack<double>>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace

// Every sample is painted exactly as often as faces cover it: the teapot from several sides and through
// the eye, and random triangles that cross the picture's borders.
TEST(Picture, PaintsEachSampleAsOftenAsFacesCoverIt) {
  long long samples = 0;
  const auto check = [&](Picture& picture, const PictureSettings& s) {
    picture.make(s);
    const std::vector<int> covered = timesCovered(picture.snapped(), s.width, s.height);
    ASSERT_EQ(timesPainted(picture.snapped(), s.width, s.height), covered);
    samples += std::ranges::count_if(covered, [](int n) { return n > 0; });
  };
  Picture teapot{readScene("teapot", 4)};
  for (int view = 0; view < 8; ++view) {
    SCOPED_TRACE(view);
    PictureSettings s = small();
    s.camera.parallel = view % 2 == 0;
    if (view == 3) s.camera.oblique = Oblique{};
    teapot.make(s);
    s.camera = moved(s.camera, teapot.camera(), 50.0 * view, 20.0 * view - 70, view == 7 ? 6.0 : 1.0);
    check(teapot, s);
  }
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Picture soup{makeScene("soup", triangleSoup(300, 0.5, seed), UpAxis::Y)};
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
    Picture picture{makeScene("solid", seed % 2 ? sphere(23, 11) : torus(29, 13), UpAxis::Z)};
    PictureSettings s = small();
    s.camera.parallel = seed % 3 == 0;
    picture.make(s);
    s.camera = moved(s.camera, picture.camera(), 17.0 * seed, 7.0 * seed - 100, 1.3);
    picture.make(s);
    for (const int n : timesPainted(picture.snapped(), s.width, s.height)) {
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

// What is stored with a face or a vertex does not change by a bit with projection, shear, window, size or
// zoom; when the eye moves, only the specular term does.
class StoredShading : public ::testing::TestWithParam<Shading> {};
TEST_P(StoredShading, KnowsNoCamera) {
  Picture picture{readScene("teapot", 4)};
  PictureSettings s = small();
  s.shading = GetParam();
  s.camera.eye = glm::dvec3{0.3, -2, 0.8};
  s.camera.lookAt = glm::dvec3{0, 0, 0.2};
  picture.make(s);
  const Intensities stored = picture.shading().intensities(0);
  ASSERT_GT(stored.I.size(), 200u);
  const auto expectSame = [&](const PictureSettings& changed, bool specularToo) {
    Picture fresh{readScene("teapot", 4)};
    fresh.make(changed);
    picture.make(changed);
    const Intensities &kept = picture.shading().intensities(0), &made = fresh.shading().intensities(0);
    EXPECT_TRUE(sameBits(kept.diffuse, made.diffuse) && sameBits(kept.specular, made.specular));
    EXPECT_TRUE(sameBits(kept.I, made.I));
    EXPECT_TRUE(sameBits(stored.diffuse, made.diffuse));
    EXPECT_EQ(sameBits(stored.specular, made.specular), specularToo);
    EXPECT_EQ(sameBits(stored.I, made.I), specularToo);
  };
  const auto with = [&](auto&& change) {
    PictureSettings c = s;
    change(c);
    return c;
  };
  expectSame(with([](auto& c) { c.camera.parallel = true; }), true);
  expectSame(with([](auto& c) { c.camera.oblique = Oblique{0.5, 30}; }), true);
  expectSame(with([](auto& c) { c.camera.window = glm::dvec4{-0.3, 0.1, -0.2, 0.5}; }), true);
  expectSame(with([](auto& c) { c.camera.fov = 77; }), true);
  expectSame(with([](auto& c) { c.camera.up = glm::dvec3{0.5, 0, 1}; }), true);
  expectSame(with([](auto& c) { c.width = 77, c.height = 400; }), true);
  expectSame(with([](auto& c) { c.cull = Cull::Back; }), true);
  expectSame(with([](auto& c) { c.camera.eye = glm::dvec3{0.4, -2, 0.8}; }), false);
}
INSTANTIATE_TEST_SUITE_P(Methods, StoredShading, ::testing::Values(Shading::Flat, Shading::Gouraud));

// Keeping results is invisible: after any change of settings the picture is the one made afresh.
TEST(Picture, KeptStagesPaintWhatFreshOnesPaint) {
  std::mt19937 rng{1975};
  Picture kept{readScene("teapot", 3)};
  PictureSettings s = small();
  int distinct = 0;
  IndexImage last;
  for (int trial = 0; trial < 120; ++trial) {
    SCOPED_TRACE(trial);
    switch (rng() % 12) {
      case 0:
        s.table.kind = kTables[rng() % 3].id;
        break;
      case 1:
        s.table.shades = 2 + static_cast<int>(rng() % 239);
        break;
      case 2:
        s.light.ks = static_cast<double>(rng() % 100) / 100;
        break;
      case 3:
        s.order = kOrders[rng() % 4].id;
        break;
      case 4:
        s.cull = rng() % 2 ? Cull::Back : Cull::Keep;
        break;
      case 5:
        s.width = 100 + static_cast<int>(rng() % 100);
        break;
      case 6:
        s.camera = moved(s.camera, kept.camera(), 20, 3, 1.05);
        break;
      case 7:
        s.light.constantV = !s.light.constantV;
        break;
      case 8:
        s.normals = kNormalRules[rng() % 5].id;
        break;
      case 9:
        s.light.form = kForms[rng() % 3].id;
        break;
      case 10:
        s.environment = kEnvironmentForms[rng() % 2].id;
        break;
      default:
        s.shading = kShadings[rng() % 6].id;
    }
    const IndexImage image = painted(kept, s);
    Picture fresh{readScene("teapot", 3)};
    ASSERT_EQ(image, painted(fresh, s));
    distinct += !(image == last);
    last = image;
  }
  EXPECT_GT(distinct, 30);
}

// A new table paints again from the stored intensities: nothing is shaded, projected or sorted.
TEST(Picture, ANewTableOnlyPaintsAgain) {
  Picture picture{readScene("teapot")};
  PictureSettings s = small();
  picture.make(s);
  EXPECT_GT(picture.times().transform, 0);
  EXPECT_GT(picture.times().sort, 0);
  s.table.kind = TableKind::Corrected;
  s.table.I0 = 0.1;
  s.table.shades = 12;
  picture.make(s);
  EXPECT_EQ(picture.times().transform, 0);
  EXPECT_EQ(picture.times().sort, 0);
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
  Picture picture{makeScene("two", m, UpAxis::Y)};
  EXPECT_GT(picture.scene().parts.count(), 2);
  PictureSettings s = small();
  s.camera.parallel = true;
  s.camera.eye = glm::dvec3{0, 0, 3};
  s.camera.lookAt = glm::dvec3{0};
  s.camera.height = 1.2;  // scene units: coordinates were halved
  picture.make(s);
  const std::vector<std::uint32_t> ids = picture.faceImage();
  const auto at = [&](double x, double y) {  // of the file's coordinates
    return ids[std::size_t(90 - y / 2 / 1.2 * 180) * 240 + std::size_t(120 + x / 2 / 1.2 * 180)];
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
  Picture ball{makeScene("ball", sphere(20, 10), UpAxis::Z)};
  Picture teapot{readScene("teapot", 4)};
  for (const OrderRow& row : kOrders) {
    SCOPED_TRACE(row.name);
    PictureSettings s = small();
    s.order = row.id;
    teapot.make(s);
    const Picture::Exactness e = teapot.exactness();
    EXPECT_GT(e.samples, 10'000);
    EXPECT_EQ(e.wrong == 0, row.id == Order::Oracle || row.id == Order::Newell);
    s.cull = Cull::Back;
    ball.make(s);
    EXPECT_EQ(ball.exactness().wrong, 0);
  }
}

// Posters in the plane of a slanted wall are in one plane, so that their order is the scene's. Had each a
// plane of its own, the snap would part them, but a picture that shows them in the scene's order is called
// right. Without the rounding's allowance it is not.
TEST(Picture, CoplanarFacesAreNotCalledWrong) {
  Scene scene = readScene("decals");
  EXPECT_EQ(std::ranges::max(scene.parts.plane), 0);
  std::iota(scene.parts.plane.begin(), scene.parts.plane.end(), 0);
  Picture decals{std::move(scene)};
  PictureSettings s = small();
  s.order = Order::Unsorted;
  int doubtful = 0;
  for (int view = 0; view < 12; ++view) {
    SCOPED_TRACE(view);
    decals.make(s);
    EXPECT_EQ(decals.exactness().wrong, 0);
    const std::vector<std::uint32_t> listed = decals.faceImage();
    s.order = Order::Oracle;
    decals.make(s);
    const std::vector<std::uint32_t> seen = decals.faceImage();
    for (std::size_t k = 0; k < seen.size(); ++k) doubtful += seen[k] != listed[k];
    s.order = Order::Unsorted;
    s.camera = moved(s.camera, decals.camera(), 29, view % 2 ? 11 : -9, 1.02);
  }
  EXPECT_GT(doubtful, 1000);
}

}  // namespace xnewell
