#include <gtest/gtest.h>

#include <cmath>

#include "shading/extremes/extreme_ways.h"
#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

// The eye may be nearer to the scene than the root of the smallest double. A copy in front still has numbers
// for coordinates, and lies nearer by what the way says.
TEST(Extremes, ACopyInFrontHasNumbers) {
  Mesh mesh;
  mesh.groupNames = {"card"};
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.addFace(std::vector<int>{0, 1, 2, 3}, 0);
  const Scene scene = makeScene("card", std::move(mesh), UpAxis::Y);
  PictureSettings settings;
  settings.width = 4, settings.height = 3;
  for (const double away : {1.0, 1e-100, 1e-170, 1e-300}) {
    SCOPED_TRACE(away);
    Camera camera;
    camera.eye = {0, 0, away}, camera.lookAt = {0, 0, 0}, camera.up = {0, 1, 0};
    const Start start{.scene = scene,
                      .settings = settings,
                      .camera = camera,
                      .size = 2,
                      .pixel = 1,
                      .target = {0, 0, 0},
                      .facing = {0, 0, 1}};
    const Way& way = *std::ranges::find(extremeWays(), "a copy in front at", &Way::name);
    const Case copied = way.at(start, 0.25);
    ASSERT_EQ(copied.scene.mesh.points.size(), 8u);
    for (int k = 0; k < 4; ++k) {
      const glm::dvec3 apart = copied.scene.mesh.points[k + 4] - copied.scene.mesh.points[k];
      EXPECT_EQ(apart, (glm::dvec3{0, 0, 0.5}));
    }
  }
}

}  // namespace xnewell::THIS_FILE
