#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>

#include "shading/color/quantize.h"
#include "tests/support/quantized.h"

namespace xnewell::THIS_FILE {

// The fixed cube of 240 colours, plain and dithered. Colours chosen for a picture: quantize_test.cpp.

namespace {

constexpr std::array<int, 3> kLevels{6, 8, 5};

/// Level k of n, as the header has it.
int levelOf(int k, int n) { return (2 * 255 * k + n - 1) / (2 * (n - 1)); }

}  // namespace

// The ranks are 0..63, each once, and the first rows are as printed.
TEST(Quantize, BayerRanks) {
  std::set<int> ranks;
  for (int place = 0; place < 64; ++place) ranks.insert(bayerRank(place % 8, place / 8));
  EXPECT_EQ(ranks.size(), 64u);
  EXPECT_EQ(*ranks.begin(), 0);
  EXPECT_EQ(*ranks.rbegin(), 63);
  const int rows[2][8] = {{0, 32, 8, 40, 2, 34, 10, 42}, {48, 16, 56, 24, 50, 18, 58, 26}};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(bayerRank(i, j), rows[j][i]);
      EXPECT_EQ(bayerRank(i + 8, j + 16), rows[j][i]);
    }
}

// The 240 colours of the cube are different, and its ends are the ends of every channel.
TEST(Quantize, TheCubeHas240Colours) {
  const std::vector<glm::u8vec3> cube = cubeColors();
  ASSERT_EQ(cube.size(), 240u);
  EXPECT_EQ(cube.front(), glm::u8vec3(0, 0, 0));
  EXPECT_EQ(cube.back(), glm::u8vec3(255, 255, 255));
  for (std::size_t k = 0; k < cube.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) ASSERT_NE(cube[k], cube[l]);
}

// Every value of every channel goes to the nearest level, at most half a step away, and none of the 240
// colours is nearer than the chosen one.
TEST(Quantize, TheCubeTakesTheNearestLevel) {
  std::mt19937 rng{13};
  std::vector<glm::u8vec3> colors;
  for (int v = 0; v < 256; ++v) {
    const auto value = [](int w) { return static_cast<std::uint8_t>(w); };
    colors.push_back({value(v), value(255 - v), value(v * 7)});
    colors.push_back({value(v * 5), value(v), value(255 - v)});
  }
  for (int k = 0; k < 1024; ++k) colors.push_back(randomColor(rng));
  const Result result = resultOf(pictureOf(colors, 64), {.quantizer = Quantizer::Cube});
  const std::vector<glm::u8vec3> cube = cubeColors();
  for (std::size_t k = 0; k < colors.size(); ++k) {
    const glm::u8vec3 taken = cube[result.cells.pixels[k] - 11];
    for (int axis = 0; axis < 3; ++axis) {
      const int largestStep = (255 + kLevels[axis] - 2) / (kLevels[axis] - 1);
      ASSERT_LE(2 * std::abs(taken[axis] - colors[k][axis]), largestStep);
    }
    int least = 1 << 20;
    for (const glm::u8vec3 c : cube) least = std::min(least, squaredDistance(c, colors[k]));
    ASSERT_EQ(squaredDistance(taken, colors[k]), least);
  }
}

// If a constant colour is dithered with the cube, the average of each channel over any 8 x 8 block is within
// 1/128 of the step in which it lies. The test counts exactly, for all values.
TEST(Quantize, ADitheredCubeKeepsTheAverage) {
  int between = 0;
  for (int v = 0; v < 256; ++v) {
    const std::array<int, 3> value{v, 255 - v, v * 3 % 256};
    RgbImage picture{21, 19};
    for (std::size_t k = 0; k < picture.rgb.size(); ++k) picture.rgb[k] = std::uint8_t(value[k % 3]);
    const Result result = resultOf(picture, {.quantizer = Quantizer::Cube, .dither = true});
    for (const auto& [left, top] : {std::pair{0, 0}, std::pair{5, 3}, std::pair{13, 11}})
      for (int axis = 0; axis < 3; ++axis) {
        int sum = 0;
        for (int place = 0; place < 64; ++place)
          sum += result.image.pixel(left + place % 8, top + place / 8)[axis];
        int k = 0;
        while (k + 2 < kLevels[axis] && levelOf(k + 1, kLevels[axis]) <= value[axis]) ++k;
        const int step = levelOf(k + 1, kLevels[axis]) - levelOf(k, kLevels[axis]);
        ASSERT_LE(2 * std::abs(sum - 64 * value[axis]), step) << v << ' ' << axis;
        between += sum % 64 != 0;
      }
  }
  EXPECT_GT(between, 1000);
}

// Colours of the cube stay as they are, with and without dithering.
TEST(Quantize, TheCubesOwnColoursStay) {
  const RgbImage picture = pictureOf(cubeColors(), 16);
  for (const bool dither : {false, true})
    EXPECT_EQ(resultOf(picture, {.quantizer = Quantizer::Cube, .dither = dither}).image, picture);
}

}  // namespace xnewell::THIS_FILE
