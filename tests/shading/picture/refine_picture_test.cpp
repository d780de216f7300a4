#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "shading/laboratory/exactness.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/refine.h"
#include "shading/scene/units.h"
#include "tests/support/lit_floor.h"
#include "tests/support/lit_solids.h"
#include "tests/support/painted_picture.h"
#include "tests/support/triangle_soup.h"

namespace xnewell::THIS_FILE {

// What refined polygons show in a picture.

// Refined polygons have no crack and no overlap on the screen: every sample is covered exactly as often as in
// the undivided scene, and in pairs by closed solids. This holds for random triangles too, which have
// borders.
TEST(RefinePicture, CoversEachSampleAsBefore) {
  long long samples = 0, more = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    PictureSettings s;
    s.width = 240, s.height = 180;
    s.shading = kMethods[seed / 5 % 2];
    const bool soup = seed % 7 == 6;
    PictureCache pictures{litAtRandom(soup ? triangleSoup(20, 0.5, seed) : solid(seed), s.light, seed)};
    s.camera.parallel = seed % 3 == 0;
    pictures.make(s);
    s.camera = moved(s.camera, pictures.last().camera(), pictures.last().scene(), 17.0 * seed,
                     7.0 * seed - 100, 1.3);
    pictures.make(s);
    const std::vector<int> before = timesPainted(pictures.last().snapped(), s.width, s.height);
    const int polygons = pictures.last().snapped().polygons;
    s.adapt = 0.05;
    pictures.make(s);
    ASSERT_EQ(timesPainted(pictures.last().snapped(), s.width, s.height), before);
    for (const int n : before) {
      if (!soup) {
        ASSERT_EQ(n % 2, 0);
      }
      samples += n > 0;
    }
    more += pictures.last().snapped().polygons - polygons;
  }
  EXPECT_GT(samples, 300'000);
  EXPECT_GT(more, 5'000);
}

// The refined picture comes near to shading at every pixel. Nowhere on the floor is a cell farther off than
// the tolerance and its own rounding, except where a rim passes between samples. Undivided, many are. This
// holds with a texture too.
TEST(RefinePicture, PaintsWhatPixelsShow) {
  constexpr double kTolerance = 0.05;
  for (const Shading method : kMethods)
    for (const bool textured : {false, true}) {
      SCOPED_TRACE(textured);
      Scene scene = underSpot(floorOf(8));
      if (textured) {
        Texture stripes;
        stripes.width = 32, stripes.height = 1;
        for (int k = 0; k < 32; ++k) stripes.gray.push_back(k % 2 ? 255 : 100);
        stripes.channel = {stripes.gray, stripes.gray, stripes.gray};
        wear(scene, stripes);
      }
      PictureSettings s = fromAbove(Shading::Phong);
      s.table.kind = TableKind::Linear;
      PictureCache pictures{scene};
      const IndexImage exact = painted(pictures, s);
      const auto farOff = [&](double adapt) {
        s.shading = method;
        s.adapt = adapt;
        const IndexImage image = painted(pictures, s);
        int count = 0;
        for (std::size_t k = 0; k < image.pixels.size(); ++k)
          count += std::abs(image.pixels[k] - exact.pixels[k]) > 240 * kTolerance + 1;
        return count;
      };
      EXPECT_GT(farOff(0.0), 5'000);
      EXPECT_LT(farOff(kTolerance), 50);
    }
}

// Refining does not change which face is seen where. The depth sort stays exact: it paints what the oracle
// sees in every pixel.
TEST(RefinePicture, KeepsFacesAndOrder) {
  int divided = 0, samples = 0;
  for (const char* const name : {"penetrate", "cycle", "decals", "room"})
    for (const Shading method : kMethods) {
      SCOPED_TRACE(name);
      Scene scene = readScene(name);
      const Mesh& mesh = scene.mesh;
      glm::dvec3 centre{0};
      for (const glm::dvec3& p : mesh.points) centre += p / double(mesh.points.size());
      PictureSettings s;
      s.width = 320, s.height = 240;
      s.shading = method;
      PictureCache plain{scene};
      plain.make(s);
      const glm::dvec3 eye = plain.last().camera().eye;
      scene.light.lights = {{.kind = LightKind::Spot,
                             .Ip = glm::dvec3{0.7},
                             .direction = centre - eye,
                             .position = eye,
                             .inner = 3,
                             .outer = 6}};
      PictureCache pictures{scene};
      pictures.make(s);
      const std::vector<std::uint32_t> ids = pictures.last().faceImage();
      const int polygons = pictures.last().snapped().polygons;
      s.adapt = 0.05;
      const IndexImage image = painted(pictures, s);
      EXPECT_EQ(pictures.last().faceImage(), ids);
      EXPECT_EQ(exactnessOf(pictures.last()).wrong, 0);
      samples += exactnessOf(pictures.last()).samples;
      divided += pictures.last().snapped().polygons > polygons;
      s.order = Order::Oracle;
      EXPECT_EQ(painted(pictures, s), image);
    }
  EXPECT_EQ(divided, 8);
  EXPECT_GT(samples, 100'000);
}

// Cached results do not show: after any change the picture equals one made from the start. Refining costs
// nothing where it divides nothing: without a tolerance there are no refined polygons, and after a new table
// none are made again.
TEST(RefinePicture, IsMadeAgainWhenItMust) {
  std::mt19937 rng{1984};
  PictureSettings s = withHighlight(fromAbove(Shading::Gouraud));
  s.width = s.height = 100;
  PictureCache kept{underSpot(floorOf(3))};
  int divided = 0;
  for (int trial = 0; trial < 150; ++trial) {
    SCOPED_TRACE(trial);
    switch (rng() % 7) {
      case 0:
        s.adapt = std::array{0.0, 0.1, 0.03}[rng() % 3];
        break;
      case 1:
        s.shading = kShadings[rng() % 6].id;
        break;
      case 2:
        s.light.kd = static_cast<double>(rng() % 100) / 100;
        break;
      case 3:
        s.camera = moved(s.camera, kept.last().camera(), kept.last().scene(), 20, 3, 1.02);
        break;
      case 4:
        s.light.ks = rng() % 2 ? 0.5 : 0.0;
        break;
      case 5:
        s.normals = kNormalRules[rng() % 5].id;
        break;
      default:
        s.order = kOrders[rng() % 4].id;
    }
    const IndexImage image = painted(kept, s);
    PictureCache fresh{underSpot(floorOf(3))};
    ASSERT_EQ(image, painted(fresh, s));
    const bool asked = s.adapt > 0 && (s.shading == Shading::Flat || s.shading == Shading::Gouraud);
    ASSERT_EQ(kept.last().shading().refined().has_value(), asked);
    if (asked) {
      ASSERT_EQ(kept.last().snapped().polygons, kept.last().shading().refined()->parts.count());
      divided += kept.last().snapped().polygons > 9;
    }
  }
  EXPECT_GT(divided, 20);
  s.shading = Shading::Gouraud;
  s.adapt = 0.05;
  kept.make(s);
  s.table.kind = TableKind::Brief;
  kept.make(s);
  EXPECT_EQ(kept.last().times().transform, 0);
}

}  // namespace xnewell::THIS_FILE
