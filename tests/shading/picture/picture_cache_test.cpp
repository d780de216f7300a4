#include "shading/picture/picture_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <set>

#include "geometry/exact/give_up.h"
#include "shading/scene/units.h"
#include "tests/support/painted_picture.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

// What one picture lends to the next, and that none changes.

namespace {

bool sameBits(const std::vector<FrontBack<double>>& a, const std::vector<FrontBack<double>>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace

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
  int distinct = 0;
  IndexImage last = painted(kept, s);
  for (int trial = 0; trial < 120; ++trial) {
    SCOPED_TRACE(trial);
    switch (rng() % 13) {
      case 0:
        s.table.kind = kTables[rng() % kTables.size()].id;
        break;
      case 1:
        s.table.shades = 2 + static_cast<int>(rng() % 239);
        break;
      case 2:
        s.light.ks = static_cast<double>(rng() % 100) / 100;
        break;
      case 3:
        s.order = kOrders[rng() % kOrders.size()].id;
        break;
      case 4:
        s.cull = rng() % 2 ? Cull::Back : Cull::Keep;
        break;
      case 5:
        s.width = 100 + static_cast<int>(rng() % 100);
        break;
      case 6:
        s.camera = moved(s.camera, kept.last().camera(), kept.last().scene(), 20, 3, 1.05);
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
      case 11:
        s.table.hue = rng() % 2 ? glm::dvec3{1, 0.5, 0} : glm::dvec3{0, 1, 1};
        s.table.bits = rng() % 2 ? 8 : 16;
        break;
      default:
        s.shading = kShadings[rng() % 6].id;
    }
    const IndexImage image = painted(kept, s);
    PictureCache fresh{readScene("teapot", 3)};
    ASSERT_EQ(image, painted(fresh, s));
    distinct += !(image == last);
    last = image;
  }
  EXPECT_GT(distinct, 30);
}

// A new table paints again from the stored intensities: nothing is shaded, projected or sorted.
TEST(Picture, ANewTableOnlyPaintsAgain) {
  PictureCache pictures{readScene("teapot")};
  PictureSettings s = small();
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

}  // namespace xnewell::THIS_FILE
