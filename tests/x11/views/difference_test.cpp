#include "x11/views/difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

PictureSettings small(Shading shading) {
  PictureSettings s;
  s.width = 200;
  s.height = 150;
  s.shading = shading;
  return s;
}

}  // namespace

// Phong's picture differs from its reference only by the rounding to shades: by half a shade, plus a
// hundredth of a shade from the single precision of its kernel.
TEST(Difference, OfPhongFromItselfIsHalfAShade) {
  PictureCache teapot{readScene("teapot", 4)};
  for (const int shades : {240, 60, 7})
    for (const TableKind kind : {TableKind::Linear, TableKind::Brief}) {
      PictureSettings s = small(Shading::Phong);
      s.table.shades = shades;
      s.table.kind = kind;
      const Difference d = comparedWithPhong(teapot.make(s, 8)).difference;
      EXPECT_GT(d.samples, 5000);
      EXPECT_EQ(d.otherFace, 0);
      EXPECT_LE(d.largest, 0.51 / (shades - 1));
      EXPECT_GT(d.largest, 0.4 / (shades - 1));
      EXPECT_EQ(d.above == 0, shades == 240);
    }
  // Half a step of ratio r between the levels of the corrected table.
  PictureSettings s = small(Shading::Phong);
  s.table.kind = TableKind::Corrected;
  const double r = ratioOfShades(s.table.I0, s.table.shades - 1);
  EXPECT_LE(comparedWithPhong(teapot.make(s, 8)).difference.largest, 0.51 * (r - 1));
}

// The numbers are computed from the samples. A sample's number is the distance of its shade from the
// reference.
TEST(Difference, IsThatOfEverySample) {
  PictureCache ball{makeScene("ball", sphere(16, 8), UpAxis::Z)};
  const PictureSettings s = small(Shading::Flat);
  const Compared compared = comparedWithPhong(ball.make(s, 8));
  const Difference& d = compared.difference;
  EXPECT_EQ(d.measure, Measure::Intensity);
  const std::vector<double> flat = ball.last().intensities(ball.last().seen(0, s.height));
  ball.make(small(Shading::Phong));
  const std::vector<double> phong = ball.last().intensities(ball.last().seen(0, s.height));
  double sum = 0, largest = 0;
  int samples = 0, above = 0;
  for (std::size_t k = 0; k < phong.size(); ++k) {
    ASSERT_EQ(std::isnan(d.at[k]), std::isnan(phong[k]));
    if (std::isnan(phong[k])) continue;
    ASSERT_NEAR(d.at[k], std::abs(flat[k] - phong[k]), 0.51 / 239);
    ++samples, sum += d.at[k], above += d.at[k] > 1.0 / 240, largest = std::max<double>(largest, d.at[k]);
  }
  EXPECT_EQ(d.samples, samples);
  EXPECT_EQ(d.above, above);
  EXPECT_GT(above, samples / 2);
  EXPECT_NEAR(d.mean, sum / samples, 1e-6);
  EXPECT_NEAR(d.largest, largest, 1e-6);
  EXPECT_NEAR(d.at[d.largestAt], largest, 1e-6);
  EXPECT_GT(largest, 0.05);
}

// Wrong faces are differences too, because the reference is the oracle's picture, whatever the picture's
// order is. Split faces are not differences.
TEST(Difference, CountsOtherFaces) {
  PictureCache pictures{readScene("penetrate")};
  PictureSettings s = small(Shading::Phong);
  s.camera = inSceneUnits(completed({}, pictures.scene().camera), pictures.scene());
  const Difference exact = comparedWithPhong(pictures.make(s, 8)).difference;
  EXPECT_GT(pictures.last().sorted().statistics.splits, 0);
  EXPECT_EQ(exact.otherFace, 0);
  s.order = Order::Oracle;
  const Difference oracle = comparedWithPhong(pictures.make(s, 8)).difference;
  EXPECT_TRUE(
      std::ranges::equal(exact.at, oracle.at, [](float a, float b) { return a == b || (a != a && b != b); }));
  s.order = Order::Unsorted;
  const Difference unsorted = comparedWithPhong(pictures.make(s, 8)).difference;
  const std::vector<int> shown = pictures.last().seen(0, s.height).faces;
  s.order = Order::Oracle;
  pictures.make(s);
  const std::vector<int> seen = pictures.last().seen(0, s.height).faces;
  int others = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) others += shown[k] != seen[k];
  EXPECT_EQ(unsorted.otherFace, others);
  EXPECT_GT(unsorted.otherFace, 100);
  EXPECT_GT(unsorted.largest, exact.largest);
}

// With several hues, each picture divides the cells in its own way. A picture's cells are read as that
// picture uses them.
TEST(Difference, OfHuesGoesByThePicturesOwnCells) {
  PictureCache hues{readScene("hues")};
  PictureSettings s = small(Shading::Gouraud);
  s.camera = inSceneUnits(completed({}, hues.scene().camera), hues.scene());
  s.colors = ColorPlan::Hues;
  const Compared compared = comparedWithPhong(hues.make(s, 8));
  const IndexImage& image = hues.last().image();
  ASSERT_GT(hues.last().colors().tables().size(), 5u);
  int fewest = 240;
  for (const ColorTable& table : hues.last().colors().tables()) fewest = std::min(fewest, table.shades());
  const std::vector<double> gouraud = hues.last().intensities(hues.last().seen(0, s.height));
  int samples = 0;
  for (std::size_t k = 0; k < gouraud.size(); ++k) {
    if (std::isnan(gouraud[k])) continue;
    ++samples;
    ASSERT_NEAR(hues.last().colors().intensityOf(image.pixels[k]), gouraud[k], 1.0 / fewest);
    ASSERT_NEAR(hues.last().colors().intensityOf(compared.reference.pixels[k]), gouraud[k],
                compared.difference.at[k] + 1.0 / fewest);
  }
  EXPECT_GT(samples, 5000);
  EXPECT_LT(compared.difference.mean, 0.02);
}

// Colours are compared as they look. With more than enough cells for one gray ramp, the eye cannot see
// Phong's own difference, but can see that of flat shading.
TEST(Difference, OfColoursIsHowTheyLook) {
  PictureCache ball{makeScene("ball", sphere(16, 8), UpAxis::Z)};
  PictureSettings s = small(Shading::Phong);
  s.colors = ColorPlan::Chosen;
  Compared compared = comparedWithPhong(ball.make(s, 8));
  EXPECT_EQ(compared.difference.measure, Measure::Color);
  EXPECT_GT(compared.difference.samples, 5000);
  EXPECT_EQ(compared.difference.above, 0);
  int differ = 0;  // a channel has 255 steps, so some samples are rounded to the next colour
  for (std::size_t k = 0; k < compared.reference.pixels.size(); ++k)
    differ += std::abs(compared.reference.pixels[k] - ball.last().image().pixels[k]);
  EXPECT_LT(differ, compared.difference.samples / 4);
  s.colors = ColorPlan::Cube;
  EXPECT_GT(comparedWithPhong(ball.make(s, 8)).difference.mean, 2.0);
  s.shading = Shading::Flat, s.colors = ColorPlan::Chosen;
  compared = comparedWithPhong(ball.make(s, 8));
  EXPECT_GT(compared.difference.above, compared.difference.samples / 4);
  EXPECT_GT(compared.difference.largest, 3.0);
}

// ConvexParts of a divided polygon show its face, not another.
TEST(Difference, DividedPolygonsShowTheirFaces) {
  PictureCache spot{readScene("spotlight")};
  PictureSettings s = small(Shading::Gouraud);
  s.adapt = 0.05;
  const Difference divided = comparedWithPhong(spot.make(s, 8)).difference;
  s.adapt = 0;
  const Difference whole = comparedWithPhong(spot.make(s, 8)).difference;
  EXPECT_GT(divided.samples, 1000);
  EXPECT_EQ(divided.otherFace, 0);
  EXPECT_LT(divided.mean, whole.mean / 2);
}

}  // namespace xnewell
