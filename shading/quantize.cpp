#include "shading/quantize.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shading/nearest_color.h"

namespace {

constexpr int kBlock = 8;  ///< pixels each way that dithering repeats after

/// Calls paint(x, y, color, cell) for every pixel that shows something.
template <class Paint>
void eachPixel(const RgbImage& picture, Shows shows, IndexImage& cells, Paint&& paint) {
  assert(cells.width == picture.width && cells.height == picture.height);
  assert(shows.empty() || shows.size() == cells.pixels.size());
  std::size_t k = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x, ++k) {
      const std::uint8_t* rgb = &picture.rgb[3 * k];
      if (shows.empty() || shows[k]) paint(x, y, glm::u8vec3{rgb[0], rgb[1], rgb[2]}, cells.pixels[k]);
    }
}

/// One channel of the cube.
class Channel {
 public:
  explicit Channel(int levels) : levels_{levels} {
    for (int v = 0; v < 256; ++v) {
      int k = levels - 2;
      while (k > 0 && level(k) > v) --k;
      const int above = v - level(k), step = level(k + 1) - level(k);
      below_[v] = static_cast<std::uint8_t>(k);
      fraction_[v] = static_cast<std::uint8_t>((128 * above + step) / (2 * step));
      nearest_[v] = static_cast<std::uint8_t>(2 * above >= step ? k + 1 : k);
    }
  }
  [[nodiscard]] std::uint8_t level(int k) const {
    return static_cast<std::uint8_t>((2 * 255 * k + levels_ - 1) / (2 * (levels_ - 1)));
  }
  [[nodiscard]] int nearest(int v) const { return nearest_[v]; }
  [[nodiscard]] int dithered(int v, int rank) const { return below_[v] + (rank < fraction_[v]); }

 private:
  int levels_;
  std::array<std::uint8_t, 256> below_, nearest_;
  std::array<std::uint8_t, 256> fraction_;  ///< 0..64 of the step from the level below, to the nearest
};

struct Cube {
  static constexpr int kReds = 6, kGreens = 8, kBlues = 5;
  static_assert(kReds * kGreens * kBlues == kMaxShades);
  Channel red{kReds}, green{kGreens}, blue{kBlues};
  static int number(int r, int g, int b) { return (r * kGreens + g) * kBlues + b; }
};

}  // namespace

std::vector<glm::u8vec3> cubeColors() {
  const Cube cube;
  std::vector<glm::u8vec3> colors;
  for (int r = 0; r < Cube::kReds; ++r)
    for (int g = 0; g < Cube::kGreens; ++g)
      for (int b = 0; b < Cube::kBlues; ++b)
        colors.push_back({cube.red.level(r), cube.green.level(g), cube.blue.level(b)});
  return colors;
}

void paintCube(const RgbImage& picture, Shows shows, int first, bool dither, IndexImage& cells) {
  const Cube cube;
  if (dither)
    eachPixel(picture, shows, cells, [&](int x, int y, glm::u8vec3 v, std::uint8_t& cell) {
      const int rank = bayerRank(x, y);
      cell = static_cast<std::uint8_t>(first + Cube::number(cube.red.dithered(v.r, rank),
                                                            cube.green.dithered(v.g, rank),
                                                            cube.blue.dithered(v.b, rank)));
    });
  else
    eachPixel(picture, shows, cells, [&](int, int, glm::u8vec3 v, std::uint8_t& cell) {
      cell = static_cast<std::uint8_t>(
          first + Cube::number(cube.red.nearest(v.r), cube.green.nearest(v.g), cube.blue.nearest(v.b)));
    });
}

void paintNearest(const RgbImage& picture, Shows shows, std::span<const glm::u8vec3> palette, double spread,
                  int first, IndexImage& cells) {
  NearestColor nearest{palette};
  std::array<int, kBlock * kBlock> displacement;  // of each place; they sum to about 0
  for (int place = 0; place < kBlock * kBlock; ++place) {
    const int rank = bayerRank(place % kBlock, place / kBlock);
    displacement[place] = static_cast<int>(std::floor(spread * (2 * rank - 63) / 128 + 0.5));
  }
  eachPixel(picture, shows, cells, [&](int x, int y, glm::u8vec3 v, std::uint8_t& cell) {
    const int by = displacement[y % kBlock * kBlock + x % kBlock];
    const auto moved = [&](int value) { return static_cast<std::uint8_t>(std::clamp(value + by, 0, 255)); };
    cell = static_cast<std::uint8_t>(first + nearest({moved(v.r), moved(v.g), moved(v.b)}));
  });
}

std::vector<Rgb16> quantize(const RgbImage& picture, Shows shows, const QuantizeSettings& settings,
                            IndexImage& cells) {
  std::vector<glm::u8vec3> colors;
  if (settings.quantizer == Quantizer::Cube) {
    colors = cubeColors();
    paintCube(picture, shows, settings.first, settings.dither, cells);
  } else {
    ChosenPalette chosen = choosePalette(picture, shows, settings.colors);
    colors = std::move(chosen.colors);
    paintNearest(picture, shows, colors, settings.dither ? chosen.spread : 0, settings.first, cells);
  }
  std::vector<Rgb16> stored;
  const auto wide = [](std::uint8_t v) { return static_cast<std::uint16_t>(257 * v); };
  for (const glm::u8vec3 color : colors) stored.push_back({wide(color.r), wide(color.g), wide(color.b)});
  return stored;
}
