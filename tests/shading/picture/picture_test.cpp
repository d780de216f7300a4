#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <tuple>

#include "depthsort/oracle.h"
#include "geometry/exact/give_up.h"
#include "geometry/model/solids.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/picture.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/units.h"
#include "tests/support/small_picture.h"
#include "tests/support/triangle_soup.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- How often samples are painted, and where the order is wrong

// The face image names the face that is seen: number + 1, 0 where nothing is; pieces of a divided face
// carry its number.
TEST(Picture, FaceImageNamesFaces) {
  PictureCache pictures{parseSceneFile(
      R"({"objects": [{"polygons": [[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
            [[-0.5, -0.5, 1], [0.5, -0.5, 1], [0, 0, 1], [0.5, 0.5, 1], [-0.5, 0.5, 1]]]}],
          "camera": {"eye": [0, 0, 3], "look_at": [0, 0, 0], "parallel": 2.4}})",
      "two", ".")};
  EXPECT_GT(pictures.scene().parts.count(), 2);
  PictureSettings s = small();
  s.camera = pictures.scene().camera;
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

/// ---- What one picture lends to the next

bool sameBits(const std::vector<FrontBack<double>>& a, const std::vector<FrontBack<double>>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

// What is stored with a face or a vertex does not change by a bit with projection, shear, window, size or
// zoom; when the eye moves, only the specular term does.
class StoredShading : public ::testing::TestWithParam<Shading> {};
TEST_P(StoredShading, KnowsNoCamera) {
  PictureCache pictures{readScene("teapot", 4)};
  PictureSettings s = small();
  s.shading = GetParam();
  s.camera.eye = glm::dvec3{0.3, -2, 0.8};
  s.camera.lookAt = glm::dvec3{0, 0, 0.2};
  pictures.make(s);
  const SceneShading stored = pictures.last().shading();
  ASSERT_GT(stored.intensities(0).I.size(), 200u);
  const auto expectSame = [&](const PictureSettings& changed, bool specularToo) {
    PictureCache fresh{readScene("teapot", 4)};
    fresh.make(changed);
    pictures.make(changed);
    const SceneShading &kept = pictures.last().shading(), &made = fresh.last().shading();
    EXPECT_TRUE(sameBits(kept.diffuse(0), made.diffuse(0)) && sameBits(kept.specular(0), made.specular(0)));
    EXPECT_TRUE(sameBits(kept.intensities(0).I, made.intensities(0).I));
    EXPECT_TRUE(sameBits(stored.diffuse(0), made.diffuse(0)));
    EXPECT_EQ(sameBits(stored.specular(0), made.specular(0)), specularToo);
    EXPECT_EQ(sameBits(stored.intensities(0).I, made.intensities(0).I), specularToo);
    // What stays is not even copied.
    EXPECT_EQ(&stored.diffuse(0), &kept.diffuse(0));
    EXPECT_EQ(&stored.specular(0) == &kept.specular(0), specularToo);
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
  PictureCache kept{readScene("teapot", 3)};
  PictureSettings s = small();
  int distinct = 0, refined = 0;
  IndexImage last = painted(kept, s);
  const std::vector<std::function<void()>> changes{
      [&] { s.table.kind = kTables[rng() % kTables.size()].id; },
      [&] { s.table.shades = 2 + static_cast<int>(rng() % 239); },
      [&] {
        s.light.ks = static_cast<double>(rng() % 100) / 100;
        s.light.Ip = rng() % 3 ? 0.7 : 0.0;
      },
      [&] { s.order = kOrders[rng() % kOrders.size()].id; },
      [&] { s.cull = rng() % 2 ? Cull::Back : Cull::Keep; },
      [&] { s.width = 100 + static_cast<int>(rng() % 100); },
      [&] { s.camera = moved(s.camera, kept.last().camera(), kept.last().scene(), 20, 3, 1.05); },
      [&] { s.light.constantV = !s.light.constantV; },
      [&] { s.normals = kNormalRules[rng() % 5].id; },
      [&] { s.light.form = kForms[rng() % 3].id; },
      [&] { s.environment = kEnvironmentForms[rng() % 2].id; },
      [&] {
        s.table.hue = rng() % 2 ? glm::dvec3{1, 0.5, 0} : glm::dvec3{0, 1, 1};
        s.table.bits = rng() % 2 ? 8 : 16;
      },
      [&] {
        s.adapt = std::array{0.0, 0.1, 0.03}[rng() % 3];
      },
      [&] { s.shading = kShadings[rng() % 6].id; },
  };
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    changes[rng() % changes.size()]();
    const IndexImage image = painted(kept, s);
    PictureCache fresh{readScene("teapot", 3)};
    ASSERT_EQ(image, painted(fresh, s));
    const bool lit = s.light.Ip > 0;
    const bool asked = s.adapt > 0 && lit && (s.shading == Shading::Flat || s.shading == Shading::Gouraud);
    ASSERT_EQ(kept.last().shading().refined().has_value(), asked);
    refined += asked && kept.last().shading().refined()->parts.count() > kept.last().scene().parts.count();
    distinct += !(image == last);
    last = image;
  }
  EXPECT_GT(distinct, 30);
  EXPECT_GT(refined, 5);
}

// A new table paints again from the stored intensities: nothing is shaded, refined, projected or sorted.
TEST(Picture, ANewTableOnlyPaintsAgain) {
  PictureCache pictures{readScene("teapot")};
  PictureSettings s = small();
  s.shading = Shading::Gouraud, s.adapt = 0.05;
  pictures.make(s);
  EXPECT_GT(pictures.last().times().transform, 0);
  EXPECT_GT(pictures.last().times().sort, 0);
  s.table.kind = TableKind::Corrected;
  s.table.I0 = 0.1;
  s.table.shades = 12;
  pictures.make(s);
  EXPECT_EQ(pictures.last().times().transform, 0);
  EXPECT_EQ(pictures.last().times().sort, 0);
}

// Other colours in the cells hand the image on, in every plan; another ground paints it again.
TEST(Picture, NewColorsKeepTheImage) {
  for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Hues, ColorPlan::Chosen}) {
    PictureCache pictures{readScene("hues")};
    PictureSettings s = small();
    s.colors = plan;
    const Picture first = pictures.make(s, 8);
    s.table.hue = {0, 1, 0};
    s.table.bits = 8;
    const Picture second = pictures.make(s, 8);
    EXPECT_EQ(&second.image(), &first.image());
    EXPECT_EQ(second.image(), makePicture(readScene("hues"), s, 8).image());
    EXPECT_EQ(second.palette(CellPlan{}), makePicture(readScene("hues"), s, 8).palette(CellPlan{}));
    const Picture third = pictures.make(s, 9);
    EXPECT_NE(third.image(), first.image());
    EXPECT_EQ(third.times().sort, 0);
  }
}

// A picture stays what it is, whatever is made after it: by its own cache, by one that began with it, by one
// that failed. A cache that failed goes on from its last picture.
TEST(Picture, NeverChanges) {
  PictureCache pictures{readScene("teapot", 3)};
  PictureSettings s = small();
  s.shading = Shading::Gouraud;
  s.order = Order::ZSort;
  const Picture picture = pictures.make(s, 8);
  const IndexImage image = picture.image();
  const std::vector<std::uint32_t> faces = picture.faceImage();
  const std::vector<double> I = picture.intensities(picture.seen(90, 91));
  const auto expectSame = [&] {
    EXPECT_EQ(picture.settings(), s);
    EXPECT_EQ(picture.image(), image);
    EXPECT_EQ(picture.paint(8).image, image);
    EXPECT_EQ(picture.faceImage(), faces);
    const std::vector<double> now = picture.intensities(picture.seen(90, 91));
    EXPECT_EQ(std::memcmp(now.data(), I.data(), I.size() * sizeof I[0]), 0);
    EXPECT_TRUE(picture.snapped().planes.empty());
  };
  EXPECT_FALSE(picture.withPlanes().snapped().planes.empty());
  expectSame();
  PictureCache second{picture};
  PictureSettings other = s;
  other.shading = Shading::Phong;
  other.order = Order::Newell;
  const Picture exact = second.make(other, 8);
  EXPECT_EQ(exact.times().transform, 0);  // lent
  EXPECT_EQ(&exact.scene(), &picture.scene());
  EXPECT_NE(exact.image(), image);
  expectSame();
  other.camera = moved(s.camera, picture.camera(), picture.scene(), 30, 10, 1.1);
  other.width = 100;
  (void)pictures.make(other, 8);
  expectSame();
  const IndexImage last = pictures.last().image();
  PictureSettings wrong = other;
  wrong.camera.eye = wrong.camera.lookAt = glm::dvec3{1, 1, 1};
  EXPECT_THROW((void)pictures.make(wrong, 8), ViewError);
  EXPECT_EQ(pictures.last().image(), last);
  EXPECT_EQ(pictures.make(other, 8).image(), last);
  expectSame();
}

// A stage that takes long can be given up at many places: the depth sort, the building of a tree, adaptive
// subdivision. The cache then goes on from its last picture.
TEST(Picture, CanBeGivenUp) {
  const Scene scene = readScene("teapot", 8);
  const auto asked = [&](const PictureSettings& settings) {
    int times = 0;
    const MayGiveUp counts{[&] { return ++times < 0; }};
    (void)makePicture(scene, settings, 8);
    return times;
  };
  PictureSettings quick = small();
  quick.order = Order::ZSort;
  const int stages = asked(quick);
  EXPECT_GT(stages, 3);
  PictureCache pictures{scene};
  const IndexImage image = pictures.make(quick, 8).image();
  for (const auto& [order, adapt] :
       {std::pair{Order::Newell, 0.0}, {Order::Bsp, 0.0}, {Order::ZSort, 0.001}}) {
    PictureSettings slow = quick;
    slow.order = order, slow.adapt = adapt;
    const int all = asked(slow);
    EXPECT_GT(all, stages + 5) << rowOf(order).name << ' ' << adapt;
    int left = all / 2;
    const MayGiveUp outer{[&] { return --left < 0; }};
    const MayGiveUp inner{[] { return false; }};
    EXPECT_THROW((void)pictures.make(slow, 8), GivenUp);
    EXPECT_EQ(pictures.last().image(), image);
  }
  EXPECT_EQ(pictures.make(quick, 8).image(), image);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
