#include "depthsort/depth_sort.h"

#include <gtest/gtest.h>

#include "depthsort/oracle.h"
#include "shading/fragment_spans.h"
#include "tests/random_scenes.h"

namespace {

/// Index of the face painted last at each sample, fragments in their order.
std::vector<int> painted(const SnappedScene& scene, const SortedScene& sorted, int width, int height) {
  std::vector<int> faces(std::size_t(width) * height, kNothing);
  for (const Fragment& fragment : sorted.fragments)
    forEachSpan(scene, sorted, fragment, width, height, [&](int row, int from, int to) {
      std::fill(faces.begin() + row * width + from, faces.begin() + row * width + to, fragment.face);
    });
  return faces;
}

}  // namespace

// Painting in the order of the depth sort shows what the oracle sees, in every sample of scenes of every
// kind.
TEST(DepthSort, PaintsWhatTheOracleSees) {
  constexpr int kSize = 40;
  SortStatistics sum;
  int covered = 0;
  for (unsigned seed = 0; seed < 1400; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 2 + seed % 17, kSize);
    const std::vector<int> seen = visibleFaces(scene, kSize, kSize);
    for (const bool textbook : {false, true}) {
      const SortedScene sorted = depthSort(scene, {kSize, kSize, textbook});
      const std::vector<int> shown = painted(scene, sorted, kSize, kSize);
      for (int k = 0; k < kSize * kSize; ++k) {
        covered += seen[k] != kNothing;
        ASSERT_EQ(shown[k], seen[k]) << "sample " << k % kSize << ", " << k / kSize
                                     << (textbook ? " textbook" : "");
      }
      const SortStatistics& s = sorted.statistics;
      for (int t = 0; t < kTests; ++t) sum.settled[t] += s.settled[t];
      sum.moves += s.moves, sum.cycles += s.cycles, sum.impossible += s.impossible, sum.splits += s.splits;
      sum.voids += s.voids, sum.contacts += s.contacts;
      sum.deepest = std::max(sum.deepest, s.deepest);
    }
  }
  for (int t = 0; t < kTests; ++t) std::cout << kTestRows[t].name << ' ' << sum.settled[t] << '\n';
  std::cout << sum.moves << ' ' << sum.cycles << ' ' << sum.impossible << ' ' << sum.splits << ' '
            << sum.voids << ' ' << sum.contacts << ' ' << sum.deepest << ' ' << covered << '\n';
}
