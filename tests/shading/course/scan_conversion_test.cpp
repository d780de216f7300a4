#include "shading/course/scan_conversion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/view/project.h"
#include "geometry/view/scanline.h"

namespace xnewell::THIS_FILE {

namespace {

using Outline = std::vector<glm::ivec3>;

/// A convex polygon: the corners of a random box that a random line does not cut off, on a coarse or a fine
/// grid, so that samples on edges occur.
Outline randomOutline(std::mt19937& rng, int extent, int unit) {
  const auto coordinate = [&] { return static_cast<int>(rng() % (extent / unit)) * unit; };
  for (;;) {
    Outline p;
    for (int k = 0; k < 3; ++k) p.push_back({coordinate(), coordinate(), 0});
    const std::int64_t area = doubleArea(p.data(), 3);
    if (area == 0) continue;
    if (area < 0) std::swap(p[0], p[1]);
    // A fourth corner beyond the side from 2 to 0 makes a convex quadrilateral, if all turns are to the left.
    p.push_back({coordinate(), coordinate(), 0});
    const auto turns = [&](int a, int b, int c) {
      const Outline t{p[a], p[b], p[c]};
      return doubleArea(t.data(), 3) > 0;
    };
    if (!turns(1, 2, 3) || !turns(2, 3, 0) || !turns(3, 0, 1)) p.pop_back();
    return p;
  }
}

/// The columns of each row by the definition: the edges and the spans.
std::vector<std::array<int, 3>> byCourse(const Outline& p, int width, int height) {
  std::vector<std::array<int, 3>> rows;
  for (const ScanSpan& span : spansOf(edgesOf(p))) {
    const int from = std::max(0, span.from), to = std::min(width, span.to);
    if (span.row >= 0 && span.row < height && from < to) rows.push_back({span.row, from, to});
  }
  return rows;
}

std::vector<std::array<int, 3>> byFiller(const Outline& p, int width, int height) {
  std::vector<std::array<int, 3>> rows;
  forEachSpan(p.data(), static_cast<int>(p.size()), width, height, [&](int row, int from, int to) {
    rows.push_back({row, from, to});
  });
  return rows;
}

}  // namespace

// The filler owns the samples that the edges, one by one, say: for large and small polygons, for corners on
// samples and far outside the picture.
TEST(ScanConversion, IsWhatTheFillerDoes) {
  std::mt19937 rng{1};
  int corners = 0, samples = 0;
  for (const auto& [pixels, unit] : {std::pair{40, 1}, {12, kGrid / 2}, {8192, 1}, {300, kGrid / 4}})
    for (int k = 0; k < (pixels > 1000 ? 20 : 2000); ++k) {
      Outline p = randomOutline(rng, pixels * kGrid, unit);
      for (glm::ivec3& v : p) v.x -= kGrid * (pixels / 4), v.y -= kGrid * (pixels / 4);
      const auto rows = byFiller(p, pixels / 2, pixels / 2);
      ASSERT_EQ(byCourse(p, pixels / 2, pixels / 2), rows);
      corners += static_cast<int>(p.size());
      for (const auto& [row, from, to] : rows) samples += to - from;
    }
  EXPECT_GT(corners, 3 * 6'000 + 1'000) << "some have four corners";
  EXPECT_GT(samples, 1'000'000);
}

// A triangle of the book, by hand. Its corners are (1, 1), (1, 5) and (5, 1) in pixels. The long side passes
// through no sample; row j has the samples 1 to 4 - j.
TEST(ScanConversion, OfATriangleByHand) {
  const Outline p{{kGrid, kGrid, 0}, {kGrid, 5 * kGrid, 0}, {5 * kGrid, kGrid, 0}};
  ASSERT_GT(doubleArea(p.data(), 3), 0);
  const std::vector<ScanEdge> edges = edgesOf(p);
  ASSERT_EQ(edges.size(), 2u) << "the top side is horizontal";
  EXPECT_TRUE(edges[0].left);
  EXPECT_EQ(edges[0].step(), 0.0);
  EXPECT_EQ(edges[1].step(), -1.0);
  EXPECT_EQ(edges[1].x(1), 4.5);
  const std::vector<ScanSpan> spans = spansOf(edges);
  ASSERT_EQ(spans.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(spans[k].row, k + 1);
    EXPECT_EQ(spans[k].from, 1);
    EXPECT_EQ(spans[k].to, 4 - k) << "the sample on the right side is outside";
  }
}

}  // namespace xnewell::THIS_FILE
