#include "shading/explain/scanline_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "depthsort/oracle.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/extended.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

struct Count {
  std::set<std::string_view> methods, scenes;
  int polygons = 0, samples = 0, shown = 0, differing = 0, byRows = 0, textured = 0;
};

/// Picture k takes the k-th row of each list.
Picture pictureOf(unsigned k, Count& count) {
  constexpr std::array kScenes{"teapot", "textured-cube", "pinwheel", "room", "colored-lights"};
  const char* const name = kScenes[k % kScenes.size()];
  PictureCache pictures{readScene(name, 3)};
  PictureSettings s = pictures.scene().settings;
  s.camera = pictures.scene().camera;
  s.width = kSanitized ? 30 : 90, s.height = kSanitized ? 24 : 70;
  s.shading = kShadings[(k + 2 * (k / 5)) % kShadings.size()].id;
  s.polygons = k % 4 < 2 ? Polygons::Triangles : Polygons::Rows;
  s.mapping = k % 3 == 0 ? TextureMapping::Affine : TextureMapping::Perspective;
  s.table.kind = kTables[k % kTables.size()].id;
  s.interpolated = k % 7 == 3 ? Interpolated::Cell : Interpolated::Intensity;
  s.colors = ColorPlan::OneHue;
  count.methods.insert(rowOf(s.shading).name), count.scenes.insert(name);
  return pictures.make(s, 8);
}

/// Its value at the sample by Cramer's rule with 64 bits, from values and places at the corners.
Extended directly(const ScanPart& part, const std::vector<double>& v, int i, int j) {
  const auto x = [&](int k) { return Extended(part.outline[k].x) - (i + 0.5) * 65536; };
  const auto y = [&](int k) { return Extended(part.outline[k].y) - (j + 0.5) * 65536; };
  const auto area = [](Extended ax, Extended ay, Extended bx, Extended by) { return ax * by - bx * ay; };
  const Extended a = area(x(1), y(1), x(2), y(2)), b = area(x(2), y(2), x(0), y(0)),
                 c = area(x(0), y(0), x(1), y(1));
  return (a * v[0] + b * v[1] + c * v[2]) / (a + b + c);
}

}  // namespace

// The run visits each sample of the polygon once, and its last value by steps is the cell that the picture
// has wherever the polygon shows: for every polygon of twenty pictures of all methods.
TEST(ScanlineRun, EndsInTheStoredCells) {
  Count count;
  for (unsigned k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const Picture picture = pictureOf(k, count);
    const PictureSettings& settings = picture.settings();
    const SeenRows seen = picture.seen(0, settings.height);
    std::vector<int> shows(picture.snapped().faces.size(), 0);
    for (const int face : seen.faces)
      if (face != kNothing) ++shows[static_cast<std::size_t>(face)];
    for (int face = 0; face < static_cast<int>(shows.size()); ++face) {
      const ScanlineRun run{picture, face};
      std::set<std::pair<int, int>> visited;
      int shown = 0;
      for (const ScanSample& sample : run.samples()) {
        const int j = run.spanOf(sample).row;
        ASSERT_TRUE(visited.insert({sample.column, j}).second);
        if (seen.faces[std::size_t(j) * settings.width + sample.column] != face) continue;
        ++shown;
        ASSERT_EQ(sample.steppedCell, picture.image().row(j)[sample.column])
            << face << ": " << sample.column << ", " << j;
      }
      ASSERT_EQ(shown, shows[static_cast<std::size_t>(face)]) << face;
      ++count.polygons, count.samples += run.steps(), count.shown += shown,
          count.differing += run.differing();
      count.byRows += run.stepsValues() && run.parts().front().outline.size() > 3;
      count.textured += run.isTextured();
    }
  }
  EXPECT_EQ(count.methods.size(), kShadings.size());
  EXPECT_EQ(count.scenes.size(), 5u);
  if (kSanitized) return;
  EXPECT_GT(count.polygons, 1'000);
  EXPECT_GT(count.shown, 30'000);
  EXPECT_GT(count.byRows, 10);
  EXPECT_GT(count.textured, 5);
  EXPECT_LT(count.differing, count.samples / 500) << "24 bits hardly ever change a cell";
}

// The drift that the run states is that of a second computation with 64 bits. It stays within the bound of
// affine.h, and with fewer bits it grows.
TEST(ScanlineRun, DriftsAsASecondComputation) {
  PictureCache pictures{readScene("teapot", 4)};
  PictureSettings s = pictures.scene().settings;
  s.camera = pictures.scene().camera;
  s.width = 200, s.height = 150, s.shading = Shading::Gouraud;
  const Picture picture = pictures.make(s, 8);
  int samples = 0, differing = 0;
  for (int face = 0; face < static_cast<int>(picture.snapped().faces.size()); face += kSanitized ? 40 : 5) {
    for (const int bits : {8, 16, 24}) {
      const ScanlineRun run{picture, face, bits};
      double largest = 0;
      for (const ScanSample& sample : run.samples()) {
        const int j = run.spanOf(sample).row;
        const auto part = static_cast<std::size_t>(sample.part);
        const SteppedPlane& plane = run.plane(sample.part);
        // By additions, from the sample of the first row and column of the part.
        const ScanSpan& first = run.parts()[part].spans.front();
        std::int64_t steps = plane.at(first.from, first.row);
        for (int row = first.row; row < j; ++row) steps += plane.perRow;
        for (int i = first.from; i < sample.column; ++i) steps += plane.perColumn;
        for (int i = sample.column; i < first.from; ++i) steps -= plane.perColumn;
        const double stepped = static_cast<double>(steps) * std::ldexp(1.0, -bits);
        ASSERT_EQ(stepped, sample.stepped);
        const Extended direct =
            directly(run.parts()[part], run.quantities(sample.part).back().atVertex, sample.column, j);
        ASSERT_NEAR(static_cast<double>(direct), sample.direct, 1e-11);
        largest = std::max(largest, std::abs(static_cast<double>(stepped - direct)));
        ++samples;
      }
      ASSERT_NEAR(run.mostDrift(), largest, 1e-11);
      if (bits == 8) differing += run.differing();
      // The bound of affine.h: half a step a pixel along both sides of the box, and one step.
      double bound = 1;
      for (const ScanPart& part : run.parts()) {
        const auto [left, right] = std::ranges::minmax(part.outline, {}, &glm::ivec3::x);
        const auto [top, bottom] = std::ranges::minmax(part.outline, {}, &glm::ivec3::y);
        bound = std::max(bound, 1 + (0.5 + 0x1p-7) * (right.x - left.x + bottom.y - top.y) / 65536.0);
      }
      ASSERT_LE(run.mostDrift(), bound * std::ldexp(1.0, -bits) + 1e-11);
    }
  }
  EXPECT_GT(samples, kSanitized ? 500 : 5'000);
  EXPECT_GT(differing, kSanitized ? 0 : 20) << "eight bits change cells";
}

}  // namespace xnewell::THIS_FILE
