#include "shading/color/quantize.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <tuple>
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

namespace {

struct CountedColor {
  glm::u8vec3 color;
  std::uint32_t count;  ///< pixels, at most 2^26
};

/// A number of pixels (at most 2^26) and the sum of each of their channels (below 2^34).
struct Sum {
  std::int64_t n = 0, r = 0, g = 0, b = 0;
  Sum& operator+=(const Sum& o) {
    n += o.n, r += o.r, g += o.g, b += o.b;
    return *this;
  }
  friend Sum operator-(const Sum& p, const Sum& q) { return {p.n - q.n, p.r - q.r, p.g - q.g, p.b - q.b}; }
};

Sum sumOf(const CountedColor& c) {
  const std::int64_t n = c.count;
  return {n, n * c.color.r, n * c.color.g, n * c.color.b};
}

glm::u8vec3 mean(const Sum& s) {
  const auto rounded = [&](std::int64_t v) { return static_cast<std::uint8_t>((2 * v + s.n) / (2 * s.n)); };
  return {rounded(s.r), rounded(s.g), rounded(s.b)};
}

/// Lists every distinct colour, in ascending order of red, then green, then blue, with the number of pixels
/// that show it.
std::vector<CountedColor> countColors(const RgbImage& picture, Shows shows) {
  struct Run {
    std::uint32_t key, pixels;
  };
  std::vector<Run> runs, sorted;
  for (std::size_t k = 0; 3 * k < picture.rgb.size(); ++k) {
    if (!shows.empty() && !shows[k]) continue;
    const std::uint8_t* rgb = &picture.rgb[3 * k];
    const std::uint32_t key = std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | rgb[2];
    if (runs.empty() || runs.back().key != key) runs.push_back({key, 0});
    ++runs.back().pixels;
  }
  // A radix sort in two passes: first the lower twelve bits of the key, then the upper twelve.
  constexpr int kBits = 12;
  sorted.resize(runs.size());
  for (const int shift : {0, kBits}) {
    const auto digit = [&](const Run& run) { return run.key >> shift & ((1 << kBits) - 1); };
    std::vector<std::size_t> start((1 << kBits) + 1);
    for (const Run& run : runs) ++start[digit(run) + 1];
    for (int d = 0; d < 1 << kBits; ++d) start[d + 1] += start[d];
    for (const Run& run : runs) sorted[start[digit(run)]++] = run;
    runs.swap(sorted);
  }
  std::vector<CountedColor> colors;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::uint32_t key = runs[k].key;
    if (k == 0 || runs[k - 1].key != key)
      colors.push_back({{std::uint8_t(key >> 16), std::uint8_t(key >> 8), std::uint8_t(key)}, 0});
    colors.back().count += runs[k].pixels;
  }
  return colors;
}

/// A plane that divides a box in two: on one side the colours whose channel `axis` is at most `last`, on the
/// other the rest.
struct Cut {
  double gain = 0;  ///< the drop in the sum of squared distances from the means; 0 if there is only one
                    ///< colour
  int axis = 0, last = 0;
};

/// Dividing a box with sum p + q into p and q lowers its squared error by
/// mean p - mean q|^2 n_p n_q / (n_p + n_q) = |n_q p - n_p q|^2 / (n_p n_q (n_p + n_q)).
/// The differences are exact integers below 2^61. The rest is rounded, in the same way on every machine.
double gainOf(const Sum& p, const Sum& q) {
  const auto difference = [&](std::int64_t inP, std::int64_t inQ) {
    return static_cast<double>(q.n * inP - p.n * inQ);
  };
  const double r = difference(p.r, q.r), g = difference(p.g, q.g), b = difference(p.b, q.b);
  const double m = static_cast<double>(p.n), n = static_cast<double>(q.n);
  return (r * r + g * g + b * b) / (m * n * (m + n));
}

/// The cut with the largest gain. If several are equal: the first axis, then the lowest value.
Cut bestCut(std::span<const CountedColor> box) {
  std::array<std::array<Sum, 256>, 3> slices{};
  Sum whole;
  for (const CountedColor& c : box) {
    const Sum sum = sumOf(c);
    whole += sum;
    for (int axis = 0; axis < 3; ++axis) slices[axis][c.color[axis]] += sum;
  }
  Cut best;
  for (int axis = 0; axis < 3; ++axis) {
    Sum below;
    for (int v = 0; v < 256; ++v) {
      if (slices[axis][v].n == 0) continue;
      below += slices[axis][v];
      if (below.n == whole.n) break;
      if (const double gain = gainOf(below, whole - below); gain > best.gain) best = {gain, axis, v};
    }
  }
  return best;
}

/// The gray that X servers show for this colour on gray visuals, times 100.
int luminance100(glm::u8vec3 c) { return 30 * c.r + 59 * c.g + 11 * c.b; }

}  // namespace

std::vector<glm::u8vec3> choosePalette(const RgbImage& picture, Shows shows, int colors) {
  assert(colors >= 1 && colors <= kMaxShades);
  std::vector<CountedColor> counted = countColors(picture, shows);
  if (counted.empty()) return {};

  // Each step cuts the box that gains most by its cut; if several gain the same, the first of them.
  struct Box {
    std::span<CountedColor> colors;
    Cut cut;
  };
  std::vector<Box> boxes{{counted, bestCut(counted)}};
  while (static_cast<int>(boxes.size()) < colors) {
    const auto most = std::max_element(boxes.begin(), boxes.end(),
                                       [](const Box& p, const Box& q) { return p.cut.gain < q.cut.gain; });
    if (most->cut.gain == 0) break;
    const Box box = *most;
    const auto first = box.colors.begin(), end = box.colors.end();
    const auto upper = std::partition(
        first, end, [&](const CountedColor& c) { return c.color[box.cut.axis] <= box.cut.last; });
    const std::span<CountedColor> parts[] = {{first, upper}, {upper, end}};
    *most = {parts[0], bestCut(parts[0])};
    boxes.push_back({parts[1], bestCut(parts[1])});
  }

  // The boxes do not overlap, so no two of their rounded means are equal.
  std::vector<glm::u8vec3> palette;
  for (const Box& box : boxes) {
    Sum sum;
    for (const CountedColor& c : box.colors) sum += sumOf(c);
    palette.push_back(mean(sum));
  }
  const auto place = [](glm::u8vec3 c) { return std::tuple{luminance100(c), c.r, c.g, c.b}; };
  std::sort(palette.begin(), palette.end(),
            [&](glm::u8vec3 p, glm::u8vec3 q) { return place(p) < place(q); });
  return palette;
}

}  // namespace xnewell
