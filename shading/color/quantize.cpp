#include "shading/color/quantize.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

namespace xnewell {

namespace {

/// Calls paint(x, y, color, cell) for every pixel that shows part of the scene.
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

/// The levels of one channel of the cube.
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
  std::array<std::uint8_t, 256> fraction_;  ///< the part of the step above the lower level, rounded to 64ths:
                                            ///< 0..64
};

struct Cube {
  static constexpr int kReds = 6, kGreens = 8, kBlues = 5;
  static_assert(kReds * kGreens * kBlues == kMaxShades);
  Channel red{kReds}, green{kGreens}, blue{kBlues};
  static int number(int r, int g, int b) { return (r * kGreens + g) * kBlues + b; }
};

/// Two colours of a palette, and the number of the 64 places in a block that get the second one.
struct Mixture {
  std::uint8_t color, other;
  std::uint8_t share;  ///< 0..32
  /// The colour that comes later in the palette takes the lower ranks. So a gradient crosses the half-way
  /// mixture without a visible seam.
  [[nodiscard]] int at(int rank) const {
    return (other > color ? rank < share : rank >= 64 - share) ? other : color;
  }
};

/// Chooses the two colours to mix for a colour that the palette does not hold.
class Mixer {
 public:
  explicit Mixer(std::span<const glm::u8vec3> palette) : palette_{palette} {
    const int count = static_cast<int>(palette.size());
    std::vector<Neighbor> others;
    for (int k = 0; k < count; ++k) {
      others.clear();
      for (int l = 0; l < count; ++l) {
        const glm::ivec3 to = glm::ivec3{palette[l]} - glm::ivec3{palette[k]};
        if (to != glm::ivec3{0}) others.push_back({to, dot(to, to), static_cast<std::uint8_t>(l)});
      }
      const auto end = others.begin() + std::min<std::ptrdiff_t>(kNeighbors, std::ssize(others));
      std::partial_sort(others.begin(), end, others.end(), [](const Neighbor& p, const Neighbor& q) {
        return std::pair{p.square, p.number} < std::pair{q.square, q.number};
      });
      neighbors_.emplace_back(others.begin(), end);
    }
  }

  /// The mixture for colour v, whose nearest palette colour is `color`. If two neighbours gain the same, the
  /// nearer one is mixed in.
  [[nodiscard]] Mixture operator()(glm::u8vec3 v, std::uint8_t color) const {
    const glm::ivec3 off = glm::ivec3{v} - glm::ivec3{palette_[color]};
    Mixture best{color, color, 0};
    std::int64_t most = 0;
    if (off != glm::ivec3{0})
      for (const Neighbor& neighbor : neighbors_[color]) {
        const int along = dot(off, neighbor.to);
        // The share that brings the mean nearest to v. It is at most a half, because `color` is nearer to v
        // than the neighbour is.
        const int f = along <= 0 ? 0 : (128 * along + neighbor.square) / (2 * neighbor.square);
        // The drop in the squared error of the mean, minus the charge for noise; both times 8 * 64^2.
        const std::int64_t gain =
            std::int64_t{1024} * f * along - std::int64_t{f} * (8 * f + (64 - f)) * neighbor.square;
        if (gain > most) most = gain, best = {color, neighbor.number, static_cast<std::uint8_t>(f)};
      }
    return best;
  }

 private:
  static constexpr int kNeighbors = 16;
  struct Neighbor {
    glm::ivec3 to;
    int square;  ///< |to|^2
    std::uint8_t number;
  };
  static int dot(glm::ivec3 p, glm::ivec3 q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

  std::span<const glm::u8vec3> palette_;
  std::vector<std::vector<Neighbor>> neighbors_;  ///< for each colour, its neighbours; the nearest is first
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

void paintNearest(const RgbImage& picture, Shows shows, std::span<const glm::u8vec3> palette, bool dither,
                  int first, IndexImage& cells) {
  if (palette.empty()) return;
  NearestColor nearest{palette};
  std::optional<Mixer> mixer;
  if (dither) mixer.emplace(palette);
  const auto mixtureOf = [&](glm::u8vec3 v) {
    const auto color = static_cast<std::uint8_t>(nearest(v));
    return mixer ? (*mixer)(v, color) : Mixture{color, color, 0};
  };
  // Neighbouring rows repeat the same colours, so this cache answers for three of four pixels of a shaded
  // picture.
  struct Known {
    glm::u8vec3 v;
    Mixture mixture;
  };
  constexpr int kBits = 13;
  std::vector<Known> known(1 << kBits, Known{{0, 0, 0}, mixtureOf({0, 0, 0})});
  eachPixel(picture, shows, cells, [&](int x, int y, glm::u8vec3 v, std::uint8_t& cell) {
    const std::uint32_t key = std::uint32_t{v.r} << 16 | std::uint32_t{v.g} << 8 | v.b;
    Known& at = known[key * 2654435761u >> (32 - kBits)];  // the multiplier is 2^32 divided by the golden
                                                           // ratio
    if (at.v != v) at = {v, mixtureOf(v)};
    cell = static_cast<std::uint8_t>(first + at.mixture.at(bayerRank(x, y)));
  });
}

std::vector<Rgb16> quantize(const RgbImage& picture, Shows shows, const QuantizeSettings& settings,
                            IndexImage& cells) {
  std::vector<glm::u8vec3> colors;
  if (settings.quantizer == Quantizer::Cube) {
    colors = cubeColors();
    paintCube(picture, shows, settings.first, settings.dither, cells);
  } else {
    colors = choosePalette(picture, shows, settings.colors);
    paintNearest(picture, shows, colors, settings.dither, settings.first, cells);
  }
  std::vector<Rgb16> stored;
  const auto wide = [](std::uint8_t v) { return static_cast<std::uint16_t>(257 * v); };
  for (const glm::u8vec3 color : colors) stored.push_back({wide(color.r), wide(color.g), wide(color.b)});
  return stored;
}

// A palette colour can be left out of a block's list if its least distance to the block is greater than the
// greatest distance of another colour: the other is then nearer everywhere in the block.
int NearestColor::candidates(glm::u8vec3 color) {
  assert(!palette_.empty() && palette_.size() <= 255);
  constexpr int kSide = 1 << kBits;
  std::array<int, 255> nearest;  // squared distance from each palette colour to the block
  int bound = 1 << 20;           // the least of the greatest distances
  for (std::size_t k = 0; k < palette_.size(); ++k) {
    int least = 0, greatest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int low = color[axis] & ~(kSide - 1), value = palette_[k][axis];
      const int below = low - value, above = value - (low + kSide - 1);
      const int outside = std::max({below, above, 0}), across = std::max(-below, -above);
      least += outside * outside;
      greatest += across * across;
    }
    nearest[k] = least;
    bound = std::min(bound, greatest);
  }
  const int list = static_cast<int>(candidates_.size());
  candidates_.push_back(0);
  for (std::size_t k = 0; k < palette_.size(); ++k)
    if (nearest[k] <= bound) candidates_.push_back(static_cast<std::uint8_t>(k));
  candidates_[list] = static_cast<std::uint8_t>(candidates_.size() - list - 1);
  return list;
}

}  // namespace xnewell
