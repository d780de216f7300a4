#include "shading/explain/pixel_place.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

namespace {

Picture pictureOf(const char* scene, int width, int height, bool parallel) {
  PictureCache pictures{readScene(scene, 4)};
  PictureSettings s = pictures.scene().settings;
  s.camera = pictures.scene().camera;
  if (parallel) {
    s.camera = {};
    s.camera.parallel = true;
  }
  s.width = width, s.height = height;
  return pictures.make(s, 8);
}

}  // namespace

// A place that a pixel shows lies at the middle of this pixel again. In a picture of another shape it lies
// where the same face shows, except at the borders of faces.
TEST(PixelPlace, IsThePlaceThatShows) {
  for (const char* scene : {"teapot", "room"})
    for (const bool parallel : {false, true}) {
      const Picture wide = pictureOf(scene, 120, 50, parallel), high = pictureOf(scene, 90, 110, parallel);
      const auto faces = wide.faceImage(), others = high.faceImage();
      int shown = 0, same = 0;
      for (int j = 0; j < 50; ++j)
        for (int i = 0; i < 120; ++i) {
          const auto place = placeSeen(wide, i, j);
          ASSERT_EQ(place.has_value(), faces[j * 120 + i] != 0);
          if (!place) continue;
          const auto back = placeInPicture(wide, *place);
          ASSERT_TRUE(back);
          ASSERT_NEAR(back->x, i + 0.5, 1e-6);
          ASSERT_NEAR(back->y, j + 0.5, 1e-6);
          const auto there = placeInPicture(high, *place);
          ASSERT_TRUE(there);
          const int x = static_cast<int>(there->x), y = static_cast<int>(there->y);
          if (there->x < 0 || there->y < 0 || x >= 90 || y >= 110) continue;
          ++shown;
          same += others[y * 90 + x] == faces[j * 120 + i];
        }
      EXPECT_GT(shown, 500);
      EXPECT_GT(same, shown * 2 / 3) << scene;
    }
}

}  // namespace xnewell::THIS_FILE
