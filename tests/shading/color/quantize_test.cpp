#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <vector>

#include "shading/color/color_difference.h"
#include "shading/color/color_plan.h"
#include "shading/color/quantize.h"
#include "tests/support/full_color_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Colours chosen for a picture

/// Pictures with colours for quantize(), and what it makes of them.

int squaredDistance(glm::u8vec3 p, glm::u8vec3 q) {
  int sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += (p[axis] - q[axis]) * (p[axis] - q[axis]);
  return sum;
}

RgbImage pictureOf(const std::vector<glm::u8vec3>& colors, int width) {
  RgbImage image{width, static_cast<int>(colors.size()) / width};
  for (std::size_t k = 0; k < image.rgb.size(); ++k) image.rgb[k] = colors[k / 3][int(k % 3)];
  return image;
}

glm::u8vec3 randomColor(std::mt19937& rng) {
  return {std::uint8_t(rng()), std::uint8_t(rng()), std::uint8_t(rng())};
}

struct Result {
  std::vector<Rgb16> colors;
  IndexImage cells;
  RgbImage image;
};
Result resultOf(const RgbImage& picture, const QuantizeSettings& settings, Shows shows = {}) {
  Result result{{}, IndexImage{picture.width, picture.height, 0}, {}};
  result.colors = quantize(picture, shows, settings, result.cells);
  result.image = shown(result.cells, result.colors, settings.first);
  return result;
}

std::vector<glm::u8vec3> differentColors(std::mt19937& rng, std::size_t count) {
  std::vector<glm::u8vec3> colors;
  while (colors.size() < count)
    if (const glm::u8vec3 c = randomColor(rng); std::find(colors.begin(), colors.end(), c) == colors.end())
      colors.push_back(c);
  return colors;
}

/// A gradient from one colour at the left to another at the right, with a third mixed in downward.
RgbImage gradient(glm::dvec3 left, glm::dvec3 right, glm::dvec3 down, int width, int height) {
  RgbImage image{width, height};
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const double s = i / (width - 1.0), t = j / (height - 1.0);
      const glm::dvec3 c = (1 - t) * ((1 - s) * left + s * right) + t * down;
      for (int axis = 0; axis < 3; ++axis)
        image.pixel(i, j)[axis] = static_cast<std::uint8_t>(std::floor(c[axis] + 0.5));
    }
  return image;
}

// A pixel that shows nothing keeps its cell, and its colour does not count. A pixel that shows something gets
// one of the scene's cells.
TEST(Quantize, LeavesOtherPixelsAlone) {
  std::mt19937 rng{240};
  int left = 0;
  for (const QuantizerRow& row : kQuantizers)
    for (const bool dither : {false, true})
      for (const int first : {10, 11, 16}) {
        const QuantizeSettings settings{.quantizer = row.id, .dither = dither, .first = first};
        FullColorPicture picture = coloredBalls(90, 70);
        IndexImage cells{90, 70, 0};
        for (std::uint8_t& cell : cells.pixels) cell = std::uint8_t(rng() % 10);
        const IndexImage before = cells;
        const std::vector<Rgb16> colors = quantize(picture.rgb, picture.shows, settings, cells);
        for (std::size_t k = 0; k < cells.pixels.size(); ++k) {
          if (picture.shows[k]) {
            ASSERT_GE(cells.pixels[k], first);
            ASSERT_LT(cells.pixels[k], first + int(colors.size()));
          } else {
            ASSERT_EQ(cells.pixels[k], before.pixels[k]);
            ++left;
            for (int axis = 0; axis < 3; ++axis) picture.rgb.rgb[3 * k + axis] = std::uint8_t(rng());
          }
        }
        IndexImage again = before;
        EXPECT_EQ(quantize(picture.rgb, picture.shows, settings, again), colors);
        EXPECT_EQ(again, cells);
      }
  EXPECT_GT(left, 12 * 1000);
}

// A picture that shows nothing chooses no colour, and a picture of one colour chooses that one.
TEST(Quantize, NothingAndOneColour) {
  const FullColorPicture picture = coloredBalls(30, 20);
  IndexImage cells{30, 20, 7};
  EXPECT_TRUE(quantize(picture.rgb, std::vector<std::uint8_t>(600, 0), {}, cells).empty());
  EXPECT_EQ(cells, (IndexImage{30, 20, 7}));
  const RgbImage one = pictureOf(std::vector<glm::u8vec3>(64, {3, 200, 90}), 8);
  for (const bool dither : {false, true})
    for (const int colors : {1, 2}) {
      const Result result = resultOf(one, {.dither = dither, .colors = colors});
      EXPECT_EQ(result.colors, (std::vector<Rgb16>{{3 * 257, 200 * 257, 90 * 257}}));
      EXPECT_EQ(result.image, one);
    }
}

// A picture with no more colours than cells is shown exactly, however often each colour occurs, dithered or
// not. With one colour more it is not. Neighbouring colours count too: those of the cube, and 240 of the 256
// reds, which a histogram of 32 levels would merge.
TEST(Quantize, FewColoursAreExact) {
  std::mt19937 rng{1982};
  for (const std::size_t count : {1, 2, 3, 17, 100, 239, 240, 241}) {
    std::vector<glm::u8vec3> colors = differentColors(rng, count);
    while (colors.size() < 64 * 64) colors.push_back(colors[rng() % (1 + rng() % count)]);
    std::shuffle(colors.begin(), colors.end(), rng);
    const RgbImage picture = pictureOf(colors, 64);
    for (const bool dither : {false, true}) {
      const Result result = resultOf(picture, {.dither = dither});
      EXPECT_EQ(result.colors.size(), std::min<std::size_t>(count, 240));
      EXPECT_EQ(result.image == picture, count <= 240) << count;
    }
  }
  std::vector<glm::u8vec3> reds;
  for (int v = 0; v < 240; ++v) reds.push_back({std::uint8_t(v), 0, 0});
  EXPECT_EQ(resultOf(pictureOf(reds, 16), {}).image, pictureOf(reds, 16));
  const RgbImage cube = pictureOf(cubeColors(), 16);
  for (const bool dither : {false, true})
    EXPECT_EQ(resultOf(cube, {.quantizer = Quantizer::Cube, .dither = dither}).image, cube);
}

// The palette depends only on how often each colour occurs: shuffled, mirrored and doubled pictures choose
// the same one.
TEST(Quantize, TheChoiceForgetsPlaces) {
  std::mt19937 rng{1991};
  for (const int colors : {2, 16, 240}) {
    std::vector<glm::u8vec3> pixels;
    const FullColorPicture balls = coloredBalls(120, 90);
    for (std::size_t k = 0; k < balls.shows.size(); ++k)
      pixels.push_back({balls.rgb.rgb[3 * k], balls.rgb.rgb[3 * k + 1], balls.rgb.rgb[3 * k + 2]});
    const std::vector<glm::u8vec3> chosen = choosePalette(pictureOf(pixels, 120), {}, colors);
    EXPECT_EQ(chosen.size(), std::size_t(colors));
    std::shuffle(pixels.begin(), pixels.end(), rng);
    EXPECT_EQ(choosePalette(pictureOf(pixels, 120), {}, colors), chosen);
    EXPECT_EQ(choosePalette(pictureOf(pixels, 90), {}, colors), chosen);
    const std::vector<glm::u8vec3> once = pixels;
    pixels.insert(pixels.end(), once.begin(), once.end());
    EXPECT_EQ(choosePalette(pictureOf(pixels, 120), {}, colors), chosen);
  }
}

// Each pixel's cell depends only on the pixel: a picture turned by half a turn gives the turned result.
// Dithering repeats every 8 pixels, whatever surrounds them.
TEST(Quantize, PixelsTakeTheirCellsAlong) {
  const FullColorPicture balls = coloredBalls(64, 48);
  RgbImage turned{64, 48};
  for (int j = 0; j < 48; ++j)
    for (int i = 0; i < 64; ++i) std::copy_n(balls.rgb.pixel(i, j), 3, turned.pixel(63 - i, 47 - j));
  for (const QuantizerRow& row : kQuantizers) {
    IndexImage cells = resultOf(balls.rgb, {.quantizer = row.id}).cells;
    std::reverse(cells.pixels.begin(), cells.pixels.end());
    EXPECT_EQ(resultOf(turned, {.quantizer = row.id}).cells, cells);

    // Four copies side by side, 64 and 48 being multiples of 8.
    RgbImage four{128, 96};
    for (int j = 0; j < 96; ++j)
      for (int i = 0; i < 128; ++i) std::copy_n(balls.rgb.pixel(i % 64, j % 48), 3, four.pixel(i, j));
    const QuantizeSettings dithered{.quantizer = row.id, .dither = true};
    const IndexImage one = resultOf(balls.rgb, dithered).cells, copies = resultOf(four, dithered).cells;
    for (int j = 0; j < 96; ++j)
      for (int i = 0; i < 128; ++i) ASSERT_EQ(copies.row(j)[i], one.row(j % 48)[i % 64]);
    EXPECT_NE(one, resultOf(balls.rgb, {.quantizer = row.id}).cells);
  }
}

// The palette ascends in luminance and has no colour twice.
TEST(Quantize, ThePaletteAscends) {
  const FullColorPicture balls = coloredBalls(200, 150);
  const std::vector<glm::u8vec3> colors = choosePalette(balls.rgb, balls.shows, 240);
  ASSERT_EQ(colors.size(), 240u);
  const auto luminance = [](glm::u8vec3 c) { return 30 * c.r + 59 * c.g + 11 * c.b; };
  for (std::size_t k = 1; k < colors.size(); ++k) {
    ASSERT_LE(luminance(colors[k - 1]), luminance(colors[k]));
    ASSERT_NE(colors[k - 1], colors[k]);
  }
}

// When two colours stand for a handful, the chosen cut has the least squared error of all cuts across an
// axis.
TEST(Quantize, TwoColoursAreCutBest) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::vector<glm::u8vec3> pixels;
    for (int k = 0; k < 9; ++k) pixels.push_back(randomColor(rng));
    // The error about the means, before they are rounded.
    double least = 1e30;
    std::vector<glm::u8vec3> best;
    bool unique = true;
    for (int axis = 0; axis < 3; ++axis)
      for (const glm::u8vec3& at : pixels) {
        std::array<glm::dvec3, 2> sum{};
        std::array<double, 2> n{};
        for (const glm::u8vec3& c : pixels) sum[c[axis] > at[axis]] += glm::dvec3{c}, ++n[c[axis] > at[axis]];
        if (n[1] == 0) continue;
        double error = 0;
        for (const glm::u8vec3& c : pixels) {
          const glm::dvec3 off = glm::dvec3{c} - sum[c[axis] > at[axis]] / n[c[axis] > at[axis]];
          error += dot(off, off);
        }
        std::vector<glm::u8vec3> means;
        for (int part = 0; part < 2; ++part)
          means.push_back(glm::u8vec3{glm::floor(sum[part] / n[part] + 0.5)});
        const bool same = best == means || (!best.empty() && best[0] == means[1] && best[1] == means[0]);
        if (std::abs(error - least) < 1e-6 && !same) unique = false;
        if (error < least - 1e-6) least = error, best = means, unique = true;
      }
    ASSERT_TRUE(unique);
    EXPECT_THAT(choosePalette(pictureOf(pixels, 3), {}, 2), testing::UnorderedElementsAreArray(best));
  }
}

// The search finds the nearest colour of any palette, and of several nearest ones the last.
TEST(Quantize, NearestIsExact) {
  int ties = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    // Every third palette has few values in each channel, so that many colours are equally near to two of its
    // colours.
    std::vector<glm::u8vec3> palette = differentColors(rng, 1 + rng() % 240);
    if (seed % 3 == 0)
      for (glm::u8vec3& c : palette) c &= std::uint8_t(0xE0);
    NearestColor nearest{palette};
    for (int k = 0; k < 3000; ++k) {
      glm::u8vec3 color = randomColor(rng);
      if (k % 2) color = palette[rng() % palette.size()] ^ std::uint8_t(rng() % 16);
      int last = 0;
      for (int p = 1; p < int(palette.size()); ++p) {
        const int there = squaredDistance(palette[p], color), so = squaredDistance(palette[last], color);
        ties += there == so && palette[p] != palette[last];
        if (there <= so) last = p;
      }
      ASSERT_EQ(nearest(color), last);
    }
  }
  EXPECT_GT(ties, 1000);
}

// On gradients the chosen palette is nearer to the picture than the cube is, by mean CIEDE2000. More colours
// are nearer than fewer.
TEST(Quantize, ChosenBeatsTheCubeOnGradients) {
  for (const RgbImage& picture : {gradient({0, 0, 0}, {255, 0, 0}, {0, 0, 0}, 256, 64),
                                  gradient({0, 0, 0}, {255, 255, 255}, {30, 30, 60}, 256, 64),
                                  gradient({255, 40, 0}, {0, 60, 255}, {10, 200, 30}, 256, 128),
                                  gradient({20, 20, 20}, {120, 90, 60}, {60, 110, 160}, 128, 128)}) {
    const auto mean = [&](const QuantizeSettings& settings) {
      return imageDifference(picture, resultOf(picture, settings).image).mean;
    };
    const double cube = mean({.quantizer = Quantizer::Cube}), chosen = mean({});
    EXPECT_GT(cube, 3);
    EXPECT_LT(chosen, cube / 3);
    EXPECT_LT(chosen, mean({.colors = 32}));
  }
}

// If a constant colour is dithered with any palette, a block holds the nearest colour and at most one more.
// The nearest has at least half the block. The block's mean is no farther from the colour than the nearest
// is, nor than the mean of any other share of the two.
TEST(Quantize, ADitheredPaletteComesNearerInTheMean) {
  int nearer = 0, plain = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const std::vector<glm::u8vec3> palette = differentColors(rng, 1 + rng() % 40);
    const glm::u8vec3 color = seed % 10 ? randomColor(rng) : palette[rng() % palette.size()];
    const RgbImage block = pictureOf(std::vector<glm::u8vec3>(64, color), 8);
    IndexImage cells{8, 8, 255};
    paintNearest(block, {}, palette, true, 0, cells);
    const int nearest = NearestColor{palette}(color);
    const std::set<int> used(cells.pixels.begin(), cells.pixels.end());
    EXPECT_LE(used.size(), 2u);
    EXPECT_GE(std::count(cells.pixels.begin(), cells.pixels.end(), nearest), 32);
    glm::ivec3 sum{-64 * glm::ivec3{color}};
    for (const std::uint8_t cell : cells.pixels) sum += glm::ivec3{palette[cell]};
    const int meanOff = sum.x * sum.x + sum.y * sum.y + sum.z * sum.z;
    const int nearestOff = 64 * 64 * squaredDistance(palette[nearest], color);
    if (used.size() == 2) {
      EXPECT_LT(meanOff, nearestOff);
      const int other = *used.begin() == nearest ? *used.rbegin() : *used.begin();
      const auto step = glm::ivec3{palette[other]} - glm::ivec3{palette[nearest]};
      EXPECT_LE(2 * std::abs(step.x * sum.x + step.y * sum.y + step.z * sum.z),
                squaredDistance(palette[other], palette[nearest]));
      ++nearer;
    } else {
      EXPECT_EQ(meanOff, nearestOff);
      plain += nearestOff == 0;
    }
  }
  EXPECT_GT(nearer, 500);
  EXPECT_GE(plain, 200);
}

// Every cell is used for a picture of all 2^24 colours, each once. Halving the box that gains most makes 128
// boxes of 64 x 64 x 32 and then divides those. So no colour is farther from its cell than the corner of such
// a box is from its mean.
TEST(Quantize, AllColours) {
  RgbImage picture{4096, 4096};
  for (std::size_t k = 0; k < picture.rgb.size() / 3; ++k) {
    picture.rgb[3 * k] = std::uint8_t(k >> 16);
    picture.rgb[3 * k + 1] = std::uint8_t(k >> 8);
    picture.rgb[3 * k + 2] = std::uint8_t(k);
  }
  const Result result = resultOf(picture, {});
  EXPECT_EQ(result.colors.size(), 240u);
  std::array<int, 256> used{};
  int furthest = 0;
  for (std::size_t k = 0; k < result.cells.pixels.size(); ++k) {
    ++used[result.cells.pixels[k]];
    const std::uint8_t *const p = &picture.rgb[3 * k], *const q = &result.image.rgb[3 * k];
    furthest = std::max(furthest, squaredDistance({p[0], p[1], p[2]}, {q[0], q[1], q[2]}));
  }
  for (int cell = 0; cell < 256; ++cell) EXPECT_EQ(used[cell] > 0, cell >= 11 && cell < 251);
  EXPECT_LE(furthest, 32 * 32 + 32 * 32 + 16 * 16);
}

/// ---- The fixed cube of 240 colours, plain and dithered

constexpr std::array<int, 3> kLevels{6, 8, 5};

/// Level k of n, as the header has it.
int levelOf(int k, int n) { return (2 * 255 * k + n - 1) / (2 * (n - 1)); }

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

/// ---- Few colours

// A picture of up to 256 colours comes back pixel for pixel, in ascending cells. With one colour more there
// are no cells for it.
TEST(FewColors, AreAllKept) {
  for (const std::size_t count : {1, 2, 100, 256, 257}) {
    SCOPED_TRACE(count);
    std::mt19937 rng{static_cast<unsigned>(count)};
    std::vector<glm::u8vec3> colors = differentColors(rng, count);
    while (colors.size() < 61 * 20) colors.push_back(colors[rng() % count]);
    const RgbImage picture = pictureOf(colors, 61);
    const std::optional<ColoredImage> cells = inFewColors(picture);
    ASSERT_EQ(cells.has_value(), count <= 256);
    if (!cells) continue;
    EXPECT_EQ(shown(cells->image, cells->palette, 0), picture);
    const auto key = [](const Rgb16& c) { return std::tuple{c.r, c.g, c.b}; };
    for (std::size_t c = 1; c < count; ++c) EXPECT_LT(key(cells->palette[c - 1]), key(cells->palette[c]));
    for (std::size_t c = count; c < 256; ++c) EXPECT_EQ(cells->palette[c], Rgb16{});
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
