#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/index_image.h"
#include "shading/color/rgb_image.h"

namespace xnewell {

/// A full-colour picture in the cells of the scene: which colours they hold, and which cell each pixel gets.
/// Integers and + - * / and square root alone, so the same on every machine. Nearness and averages are those
/// of the stored 8-bit values.

enum class Quantizer { Cube, Chosen };
struct QuantizerRow {
  Quantizer id;
  std::string_view name, holds, source;
};
inline constexpr std::array kQuantizers{
    QuantizerRow{Quantizer::Cube, "cube", "6 reds x 8 greens x 5 blues, whatever the picture",
                 "uniform quantization, Heckbert 1982"},
    QuantizerRow{Quantizer::Chosen, "chosen", "the means of boxes cut where the colours vary most",
                 "Wu 1991"},
};

struct QuantizeSettings {
  Quantizer quantizer = Quantizer::Chosen;
  bool dither = false;      ///< ordered: two colours share each 8 x 8 block by the fraction between them
  int colors = kMaxShades;  ///< of Chosen, at most: 1..240. The cube always has 240
  int first = 11;           ///< cell of the first colour
  bool operator==(const QuantizeSettings&) const = default;
};

/// Which pixels show something: one byte each, 0 where nothing is. An empty span: all of them do.
using Shows = std::span<const std::uint8_t>;

/// Every pixel of `cells` that shows something becomes first + k, colour k of the result. The others keep
/// their cell. `cells` is as large as the picture. Nothing to show chooses no colour.
[[nodiscard]] std::vector<Rgb16> quantize(const RgbImage& picture, Shows shows,
                                          const QuantizeSettings& settings, IndexImage& cells);

// Its steps, for whoever keeps a palette from one picture to the next.

/// Colour (8 r + g) 5 + b has level r of 6 red, g of 8 green, b of 5 blue; level k of n is 255 k / (n - 1)
/// rounded. Green has most levels, for the eye sees its steps best, and blue fewest.
[[nodiscard]] std::vector<glm::u8vec3> cubeColors();

/// At most `colors` colours, 1..240: the picture's own where it has no more. Only how often each colour
/// occurs counts, not where. All different, ascending in luminance. @see X. Wu, "Efficient Statistical
/// Computations for Optimal Color Quantization", Graphics Gems II, 1991. Departs: the colours themselves are
/// cut, not a histogram of 32^3, which would leave one hue 32 shades; and the box cut next is the one that
/// gains most by it, not the one of largest variance.
[[nodiscard]] std::vector<glm::u8vec3> choosePalette(const RgbImage& picture, Shows shows, int colors);

/// The nearest level of each channel, half way between two the brighter; dithered, the level above in as many
/// places of an 8 x 8 block as the value has sixty-fourths of the step.
void paintCube(const RgbImage& picture, Shows shows, int first, bool dither, IndexImage& cells);

/// The nearest of `palette` by squared distance, of two equally near the later. Dithered, that colour and one
/// of its sixteen nearest neighbours share each 8 x 8 block in the ratio that brings their mean nearest, a
/// ratio that makes more noise being charged an eighth of its variance. What the palette holds stays itself.
/// Displacing the colours before the search, as suits evenly spaced levels, leaves up to three times the
/// error of the means, for here the neighbours lie in any direction. @see J. Yliluoma, "Arbitrary-palette
/// positional dithering algorithm", 2011, whose first method this is, with fewer pairs and another charge.
void paintNearest(const RgbImage& picture, Shows shows, std::span<const glm::u8vec3> palette, bool dither,
                  int first, IndexImage& cells);

/// Rank 0..63 of pixel (x, y) in ordered dithering. Places of neighbouring ranks lie far apart.
/// @see Bayer 1973; Foley & van Dam 2e §13.1.2
[[nodiscard]] constexpr int bayerRank(int x, int y) {
  constexpr std::array<std::array<int, 2>, 2> kTwo{{{0, 2}, {3, 1}}};
  int rank = 0;
  for (int bit = 0; bit < 3; ++bit) rank = 4 * rank + kTwo[y >> bit & 1][x >> bit & 1];
  return rank;
}

}  // namespace xnewell
