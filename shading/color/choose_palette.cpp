#include <algorithm>
#include <cassert>
#include <tuple>

#include "shading/color/quantize.h"

namespace xnewell {

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
