#include "x11/stepper/so_far.h"
#include "shading/picture/picture_cache.h"
#include "x11/stepper/sort_run.h"

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

// The run of a part of a picture ends with what the whole picture shows in that part, for flat and
// interpolated shading. It has no more polygons than the picture.
TEST(SoFar, APartEndsAsTheWhole) {
  std::mt19937 rng{1969};
  for (const char* const scene : {"teapot", "room", "crossing-sheets", "penetrate"})
    for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
      SCOPED_TRACE(scene);
      PictureSettings settings;
      settings.width = 120, settings.height = 90, settings.shading = shading;
      Scene read = readScene(scene, 4);
      settings.camera = completed({}, read.camera);
      const Picture picture = makePicture(std::move(read), settings, 8);
      for (int k = 0; k < 20; ++k) {
        const glm::ivec2 low{rng() % 110, rng() % 80};
        const glm::ivec2 high = glm::min(low + glm::ivec2{1 + rng() % 40, 1 + rng() % 40}, {120, 90});
        const Picture part = picture.onlyWithin(low, high);
        ASSERT_EQ(part.snapped().faces.size(), picture.facesWithin(low, high));
        ASSERT_LE(part.snapped().faces.size(), picture.snapped().faces.size());
        SortRun run{part, 8};
        run.goTo(run.steps());
        for (int y = low.y; y < high.y; ++y)
          for (int x = low.x; x < high.x; ++x)
            ASSERT_EQ(run.soFar().row(y)[x], picture.image().row(y)[x]) << x << ", " << y;
      }
    }
}

}  // namespace xnewell::THIS_FILE
