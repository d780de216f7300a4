#include "shading/color/few_colors.h"

#include <gtest/gtest.h>

#include <random>

namespace xnewell::THIS_FILE {

namespace {

/// A picture with this number of different colours, in random order.
RgbImage pictureOf(int colors, int width, int height) {
  std::mt19937 rng{static_cast<unsigned>(colors)};
  RgbImage picture{width, height};
  for (int k = 0; k < width * height; ++k) {
    const int c = k < colors ? k : static_cast<int>(rng() % colors);
    std::uint8_t* const rgb = &picture.rgb[3 * k];
    rgb[0] = static_cast<std::uint8_t>(255 - c % 251), rgb[1] = static_cast<std::uint8_t>(7 * c),
    rgb[2] = static_cast<std::uint8_t>(c / 200);
  }
  return picture;
}

}  // namespace

// A picture of up to 256 colours comes back pixel for pixel, in ascending cells. With one colour more there
// are no cells for it.
TEST(FewColors, AreAllKept) {
  for (const int colors : {1, 2, 100, 256}) {
    SCOPED_TRACE(colors);
    const RgbImage picture = pictureOf(colors, 61, 20);
    const std::optional<ColoredImage> cells = inFewColors(picture);
    ASSERT_TRUE(cells);
    for (std::size_t k = 0; k < cells->image.pixels.size(); ++k) {
      const Rgb16 c = cells->palette[cells->image.pixels[k]];
      ASSERT_EQ(c.r, 257 * picture.rgb[3 * k]);
      ASSERT_EQ(c.g, 257 * picture.rgb[3 * k + 1]);
      ASSERT_EQ(c.b, 257 * picture.rgb[3 * k + 2]);
    }
    const auto key = [](const Rgb16& c) { return std::tuple{c.r, c.g, c.b}; };
    for (int c = 1; c < colors; ++c) EXPECT_LT(key(cells->palette[c - 1]), key(cells->palette[c]));
    for (int c = colors; c < 256; ++c) EXPECT_EQ(cells->palette[c], Rgb16{});
  }
  EXPECT_FALSE(inFewColors(pictureOf(257, 61, 20)));
}

}  // namespace xnewell::THIS_FILE
