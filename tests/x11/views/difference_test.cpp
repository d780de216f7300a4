#include "x11/views/difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

namespace {

PictureSettings small(Shading shading) {
  PictureSettings s;
  s.width = 200;
  s.height = 150;
  s.shading = shading;
  return s;
}

Compared compared(const Picture& picture) { return comparedWithReference(picture, GroundTruth{picture}); }

/// A ball of flat faces, which the scene knows to be a sphere.
Scene ball(int around, int down) {
  Scene scene = makeScene("ball", sphere(around, down), UpAxis::Z);
  scene.rounds.push_back({.faces = scene.mesh.faceCount(), .columns = around});
  return scene;
}

}  // namespace

// On flat surfaces, Phong's method has the true normals. Its picture differs from the reference only by the
// rounding to shades: by half a shade, plus a hundredth of a shade from the single precision of its kernel.
TEST(Difference, OfPhongOnFlatSurfacesIsHalfAShade) {
  PictureCache squares{readScene("highlight", 4)};
  const CameraSettings camera = completed({}, squares.scene().camera);
  for (const int shades : {240, 60, 7})
    for (const TableKind kind : {TableKind::Linear, TableKind::Brief}) {
      PictureSettings s = small(Shading::Phong);
      s.table.shades = shades;
      s.table.kind = kind;
      s.camera = camera;
      const Difference d = compared(squares.make(s, 8)).difference;
      EXPECT_GT(d.errors.count, 5000);
      EXPECT_EQ(d.wrongFaces, 0);
      EXPECT_LE(d.errors.largest, 0.51 / (shades - 1));
      EXPECT_GT(d.errors.largest, 0.4 / (shades - 1));
      EXPECT_EQ(d.above == 0, shades == 240);
    }
  // Half a step of ratio r between the levels of the corrected table.
  PictureSettings s = small(Shading::Phong);
  s.table.kind = TableKind::Corrected;
  s.camera = camera;
  const double r = ratioOfShades(s.table.I0, s.table.shades - 1);
  EXPECT_LE(compared(squares.make(s, 8)).difference.errors.largest, 0.51 * (r - 1));
}

// The numbers are computed from the samples. A sample's number is the distance of its shade from the
// reference.
TEST(Difference, IsThatOfEverySample) {
  PictureCache balls{ball(16, 8)};
  const PictureSettings s = small(Shading::Flat);
  const Compared result = compared(balls.make(s, 8));
  const Difference& d = result.difference;
  EXPECT_EQ(d.kind, Unlike::Intensity);
  const std::vector<double> flat = balls.last().intensities(balls.last().seen(0, s.height));
  const GroundTruth truth{balls.last()};
  const Reference& reference = truth.reference();
  double sum = 0, largest = 0;
  int samples = 0, above = 0, beyond = 0;
  for (std::size_t k = 0; k < flat.size(); ++k) {
    const bool isShown = !std::isnan(flat[k]), isDue = reference.faces()[k] != kNothing;
    ASSERT_EQ(std::isnan(d.at[k]), !isShown && !isDue);
    if (!isShown && !isDue) continue;
    ASSERT_NEAR(d.at[k], std::abs((isShown ? flat[k] : 0.0) - reference.I(k).r), 0.51 / 239);
    beyond += !isShown;
    ++samples, sum += d.at[k], above += d.at[k] > 1.0 / 240, largest = std::max<double>(largest, d.at[k]);
  }
  EXPECT_EQ(d.errors.count, samples);
  EXPECT_EQ(d.above, above);
  EXPECT_GT(above, samples / 2);
  EXPECT_GT(beyond, 20);  // the sphere is larger than its polygons
  EXPECT_NEAR(d.errors.mean, sum / samples, 1e-6);
  EXPECT_NEAR(d.errors.largest, largest, 1e-6);
  EXPECT_NEAR(d.at[d.largestAt], largest, 1e-6);
  EXPECT_GT(largest, 0.05);
}

// Wrong faces are differences too, because the reference is the oracle's picture, whatever the picture's
// order is. Split faces are not differences.
TEST(Difference, CountsOtherFaces) {
  PictureCache pictures{readScene("penetrate")};
  PictureSettings s = small(Shading::Phong);
  s.camera = completed({}, pictures.scene().camera);
  const Difference exact = compared(pictures.make(s, 8)).difference;
  EXPECT_GT(pictures.last().sorted().statistics.splits, 0);
  EXPECT_EQ(exact.wrongFaces, 0);
  s.order = Order::Oracle;
  const Difference oracle = compared(pictures.make(s, 8)).difference;
  EXPECT_TRUE(
      std::ranges::equal(exact.at, oracle.at, [](float a, float b) { return a == b || (a != a && b != b); }));
  s.order = Order::Unsorted;
  const Difference unsorted = compared(pictures.make(s, 8)).difference;
  const std::vector<int> shown = pictures.last().seen(0, s.height).faces;
  s.order = Order::Oracle;
  pictures.make(s);
  const std::vector<int> seen = pictures.last().seen(0, s.height).faces;
  int others = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) others += shown[k] != seen[k];
  EXPECT_LE(unsorted.wrongFaces, others);  // some faces are too close to tell
  EXPECT_GT(unsorted.wrongFaces, others * 99 / 100);
  EXPECT_GT(unsorted.wrongFaces, 100);
  EXPECT_GT(unsorted.errors.largest, exact.errors.largest);
}

// With several hues, each picture divides the cells in its own way. A picture's cells are read as that
// picture uses them.
TEST(Difference, OfHuesGoesByThePicturesOwnCells) {
  PictureCache hues{readScene("hues")};
  PictureSettings s = small(Shading::Gouraud);
  s.camera = completed({}, hues.scene().camera);
  s.colors = ColorPlan::Hues;
  const Compared result = compared(hues.make(s, 8));
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
    ASSERT_NEAR(hues.last().colors().intensityOf(result.reference.pixels[k]), gouraud[k],
                result.difference.at[k] + 1.0 / fewest);
  }
  EXPECT_GT(samples, 5000);
  EXPECT_LT(result.difference.errors.mean, 0.02);
}

// What the picture leaves out on purpose is found, too. With L and V constant, a lamp lights a floor evenly.
// The reference keeps the places, however the picture was made; a model setting such as the form of the
// equation belongs to both.
TEST(Difference, FindsWhatIsConstant) {
  PictureCache pictures{readScene("lamp")};
  PictureSettings s = pictures.scene().settings;
  s.width = 200, s.height = 150;
  s.light.ks = 0.4;
  s.camera = completed({}, pictures.scene().camera);
  for (const FormRow& form : kForms) {
    SCOPED_TRACE(form.name);
    s.light.form = form.id;
    s.light.constantL = s.light.constantV = false;
    const Compared exact = compared(pictures.make(s, 8));
    // The lamp lies in the plane of the pillars' tops. There N.L is 0, and rounding decides about a
    // highlight.
    EXPECT_LT(exact.difference.above, exact.difference.errors.count / 500);
    s.light.constantL = s.light.constantV = true;
    const Compared constant = compared(pictures.make(s, 8));
    EXPECT_EQ(constant.reference.pixels, exact.reference.pixels);
    EXPECT_GT(constant.difference.errors.mean, 0.1);
    EXPECT_GT(constant.difference.errors.largest, 0.4);
  }
}

// Colours are compared as they look. With more than enough cells for one gray ramp, the eye cannot see
// Phong's own difference, but can see that of flat shading.
TEST(Difference, OfColoursIsHowTheyLook) {
  PictureCache balls{ball(256, 128)};  // as fine as the reference, so the outline is no difference
  PictureSettings s = small(Shading::Phong);
  s.colors = ColorPlan::Chosen;
  Compared result = compared(balls.make(s, 8));
  EXPECT_EQ(result.difference.kind, Unlike::Color);
  EXPECT_GT(result.difference.errors.count, 5000);
  EXPECT_EQ(result.difference.above, 0);
  int differ = 0;  // a channel has 255 steps, so some samples are rounded to the next colour
  for (std::size_t k = 0; k < result.reference.pixels.size(); ++k)
    differ += std::abs(result.reference.pixels[k] - balls.last().image().pixels[k]);
  EXPECT_LT(differ, result.difference.errors.count / 4);
  s.colors = ColorPlan::Cube;
  EXPECT_GT(compared(balls.make(s, 8)).difference.errors.mean, 2.0);
  s.shading = Shading::Flat, s.colors = ColorPlan::Chosen;
  balls = PictureCache{ball(64, 32)};
  result = compared(balls.make(s, 8));
  EXPECT_GT(result.difference.above, result.difference.errors.count / 4);
  EXPECT_GT(result.difference.errors.largest, 3.0);
}

// ConvexParts of a divided polygon show its face, not another.
TEST(Difference, DividedPolygonsShowTheirFaces) {
  PictureCache spot{readScene("spotlight")};
  PictureSettings s = small(Shading::Gouraud);
  s.adapt = 0.05;
  const Difference divided = compared(spot.make(s, 8)).difference;
  s.adapt = 0;
  const Difference whole = compared(spot.make(s, 8)).difference;
  EXPECT_GT(divided.errors.count, 1000);
  EXPECT_EQ(divided.wrongFaces, 0);
  EXPECT_LT(divided.errors.mean, whole.errors.mean / 2);
}

}  // namespace xnewell::THIS_FILE
