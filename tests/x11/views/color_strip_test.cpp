#include "x11/views/color_strip.h"
#include "shading/picture/picture_cache.h"

#include <gtest/gtest.h>

namespace xnewell::THIS_FILE {

// The strip's rule for the cells is true for every hue, and the strip says when the colours were changed.
TEST(ColorStrip, SaysWhatTheCellsHold) {
  for (const glm::dvec3 hue : {glm::dvec3{1, 0, 0}, glm::dvec3{1, 0.7, 0.2}}) {
    PictureCache pictures{readScene("teapot", 3)};
    PictureSettings s;
    s.width = 80, s.height = 60;
    s.table.hue = hue;
    pictures.make(s);
    EXPECT_EQ(wordsOf(pictures.last()).rule, "linear: cell i holds (i - 10)/255 of the hue");
    const Palette palette = pictures.last().palette(CellPlan{});
    for (int i = 11; i <= 250; ++i) {
      const glm::dvec3 said = (i - 10) / 255.0 * 65535.0 * hue;
      EXPECT_NEAR(palette[i].r, said.r, 1.0);
      EXPECT_NEAR(palette[i].g, said.g, 1.0);
      EXPECT_NEAR(palette[i].b, said.b, 1.0);
    }
    EXPECT_EQ(wordsOf(pictures.last(), {.rotate = 60}).rule, "linear, changed");
    EXPECT_EQ(wordsOf(pictures.last(), {.gamma = 1.8}).rule, "linear, changed");
    EXPECT_EQ(wordsOf(pictures.last(), {.stored = TableKind::Corrected}).rule,
              "indices of linear, colours of corrected");
    EXPECT_EQ(wordsOf(pictures.last(), {.lit = 40}).rule, wordsOf(pictures.last()).rule);
  }
}

}  // namespace xnewell::THIS_FILE
