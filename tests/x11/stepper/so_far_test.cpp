#include "x11/stepper/so_far.h"
#include "shading/picture/picture_cache.h"

#include <gtest/gtest.h>

#include <random>

namespace xnewell::THIS_FILE {

// The picture so far is the one that painting from the start makes, in whatever order steps are visited and
// however many copies are kept. The last one is the finished picture.
TEST(SoFar, DoesNotDependOnTheWayThere) {
  PictureSettings settings;
  settings.width = 120, settings.height = 90;
  const Picture picture = makePicture(readScene("teapot", 3), settings);
  const SortedScene& sorted = picture.sorted();
  const int all = static_cast<int>(sorted.fragments.size());
  ASSERT_GT(all, 300);
  std::vector<IndexImage> expected{{120, 90, 8}};
  SurfacePainter painter = picture.painter();
  for (const Fragment& fragment : sorted.fragments) {
    expected.push_back(expected.back());
    painter.paint(expected.back(), sorted, fragment);
  }
  ASSERT_EQ(expected.back(), picture.paint(8).image);

  constexpr std::size_t kOne = 120 * 90;
  for (const std::size_t bytes : {std::size_t{0}, kOne - 1, kOne, 7 * kOne, 1000 * kOne}) {
    SoFar soFar{picture, sorted, 8, bytes};
    std::mt19937 rng{1972};
    for (int k = 0; k < 300; ++k) {
      const int painted = k == 100 ? all : static_cast<int>(rng() % (all + 1));
      ASSERT_EQ(soFar.at(painted), expected[painted]) << bytes << ' ' << painted;
    }
  }
}

}  // namespace xnewell::THIS_FILE
