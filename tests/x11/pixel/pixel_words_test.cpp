#include "x11/pixel/pixel_words.h"

#include <gtest/gtest.h>

#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

// Where the cells hold colours, each chain ends in the cell that the picture has: the nearest colour, or with
// dithering the colour of this place among the two that share its block.
TEST(PixelWords, ChainsEndInTheCellsOfColors) {
  for (const char* name : {"colored-lights", "textured-cube"}) {
    PictureCache pictures{readScene(name)};
    PictureSettings settings = pictures.scene().settings;
    settings.camera = pictures.scene().camera;
    settings.width = 64, settings.height = 48;
    for (const ColorPlan plan : {ColorPlan::Cube, ColorPlan::Chosen})
      for (const bool dither : {false, true}) {
        SCOPED_TRACE(std::string{name} + (plan == ColorPlan::Cube ? ", cube" : "") +
                     (dither ? ", dithered" : ""));
        settings.colors = plan, settings.dither = dither;
        const Picture picture = pictures.make(settings, 0);
        int shown = 0;
        for (int j = 0; j < settings.height; j += 5)
          for (int i = j % 3; i < settings.width; i += 3) {
            const PixelStory story{picture, i, j};
            shown += story.shown() != nullptr;
            EXPECT_TRUE(story.isExplained()) << i << ',' << j;
          }
        EXPECT_GT(shown, 30);
      }
  }
}

// The upper 8 of 16 bits are the value divided by 256, rounded down.
TEST(PixelWords, AScreenShowsTheHighBits) {
  EXPECT_EQ(shownInWords({52685, 255, 256}, 8), "this screen shows the upper 8 bits: 205, 0, 1");
  EXPECT_EQ(shownInWords({65535, 2047, 2048}, 5), "this screen shows the upper 5 bits: 31, 0, 1");
  EXPECT_EQ(shownInWords({52685, 255, 256}, 16), "this screen shows all 16 bits: 52685, 255, 256");
}

}  // namespace xnewell::THIS_FILE
