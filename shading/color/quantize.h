#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/images.h"

namespace xnewell {

/// Finds the palette colour nearest to a given colour, exactly, by the squared distance of the 8-bit values.
/// If two are equally near, the later one counts. The 256^3 colours are divided into blocks of 8^3. When a
/// colour of a block is first asked for, we list the palette colours that are nearest to some colour of the
/// block; only those are compared.
class NearestColor {
 public:
  /// The palette has 1..255 colours and must outlive this object.
  explicit NearestColor(std::span<const glm::u8vec3> palette)
      : palette_{palette}, list_(kBlocks * kBlocks * kBlocks, -1) {}

  [[nodiscard]] int operator()(glm::u8vec3 color) {
    int& list = list_[((color.r >> kBits) * kBlocks + (color.g >> kBits)) * kBlocks + (color.b >> kBits)];
    if (list < 0) list = candidates(color);
    const std::uint8_t* at = &candidates_[list];
    int best = 0, least = 1 << 20;
    for (int count = *at++; count > 0; --count, ++at) {
      const int distance = squaredDistance(palette_[*at], color);
      if (distance <= least) least = distance, best = *at;
    }
    return best;
  }

 private:
  static constexpr int kBits = 3, kBlocks = 256 >> kBits;

  static int squaredDistance(glm::u8vec3 p, glm::u8vec3 q) {
    const int r = p.r - q.r, g = p.g - q.g, b = p.b - q.b;
    return r * r + g * g + b * b;
  }
  /// Appends the list of the block that holds `color`: first the number of candidates, then their palette
  /// indices in ascending order. Returns the place where the list begins.
  int candidates(glm::u8vec3 color);

  std::span<const glm::u8vec3> palette_;
  std::vector<int> list_;                 ///< where each block's list begins; -1 if it was not made yet
  std::vector<std::uint8_t> candidates_;  ///< the lists
};

/// Shows a full-colour picture with the scene's cells: chooses the colours of the cells, and a cell for each
/// pixel. The computation uses only integers and the operations + - * / of doubles, so it gives the same
/// result on every machine. Distances and averages are those of the stored 8-bit values.

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
  bool dither = false;      ///< ordered dithering: two colours share each 8 x 8 block in the ratio that the
                            ///< wanted colour needs
  int colors = kMaxShades;  ///< the most that Chosen may use: 1..240; Cube always uses 240
  int first = 11;           ///< cell of the first colour
  bool operator==(const QuantizeSettings&) const = default;
};

/// Marks the pixels that show part of the scene: one byte per pixel, 0 for a pixel that does not. If the span
/// is empty, every pixel does.
using Shows = std::span<const std::uint8_t>;

/// Quantizes the picture. Each pixel of `cells` that shows part of the scene is set to first + k, where k is
/// the number of its colour in the result. The other pixels keep their cells. `cells` must be as large as the
/// picture. If no pixel shows part of the scene, Chosen returns no colours; Cube always returns its 240.
[[nodiscard]] std::vector<Rgb16> quantize(const RgbImage& picture, Shows shows,
                                          const QuantizeSettings& settings, IndexImage& cells);

/// The byte of a full-colour channel for a value 1..255 of kChannelRamp: they are spread over 0..255.
[[nodiscard]] constexpr std::uint8_t channelByte(int value) {
  return static_cast<std::uint8_t>((255 * (value - 1) + 127) / 254);
}

// The steps of quantize(), for callers that keep one palette for several pictures.

/// The 240 colours of the cube. Colour (8 r + g) 5 + b has level r of 6 in red, g of 8 in green and b of 5 in
/// blue. Level k of n is 255 k / (n - 1), rounded. The eye sees steps of green best and steps of blue least,
/// so green has the most levels and blue the fewest.
[[nodiscard]] std::vector<glm::u8vec3> cubeColors();

/// Chooses at most `colors` colours, 1..240. A picture with no more colours than that keeps its own. Only the
/// number of pixels of each colour matters, not their places. The result is in ascending order of luminance
/// and holds no colour twice. @see X. Wu, "Efficient Statistical Computations for Optimal Color
/// Quantization", Graphics Gems II, 1991.
/// We depart from the paper in two ways. We cut the set of colours itself, not a histogram of 32^3 bins,
/// which would leave only 32 shades of one hue. And we cut next the box that gains most by its cut,
/// not the box with the largest variance.
[[nodiscard]] std::vector<glm::u8vec3> choosePalette(const RgbImage& picture, Shows shows, int colors);

/// Gives each pixel the nearest level of each channel; half way between two levels, the brighter. With
/// dithering, the level above is used in n of the 64 places of an 8 x 8 block, where n/64 is the rounded
/// fraction of the step.
void paintCube(const RgbImage& picture, Shows shows, int first, bool dither, IndexImage& cells);

/// Gives each pixel the nearest colour of `palette` by squared distance; if two are equally near, the later
/// one. With dithering, that colour and one of its sixteen nearest neighbours share each 8 x 8 block. For
/// each neighbour, the ratio brings the mean as near to the wanted colour as it can. The neighbour is
/// chosen to minimize the squared error of the mean plus an eighth of the mixture's variance (its noise). A
/// colour that the palette holds stays solid.
/// Ordered dithering of evenly spaced levels displaces a colour before the search. Here the neighbours lie in
/// any direction, and displacement would leave up to three times the error of the means.
/// @see J. Yliluoma, "Arbitrary-palette positional dithering algorithm", 2011. This is his first method, with
/// fewer pairs and another charge for noise.
void paintNearest(const RgbImage& picture, Shows shows, std::span<const glm::u8vec3> palette, bool dither,
                  int first, IndexImage& cells);

/// The rank 0..63 of pixel (x, y) in ordered dithering. Places with neighbouring ranks lie far apart.
/// @see Bayer 1973; Foley & van Dam 2e §13.1.2
[[nodiscard]] constexpr int bayerRank(int x, int y) {
  constexpr std::array<std::array<int, 2>, 2> kTwo{{{0, 2}, {3, 1}}};
  int rank = 0;
  for (int bit = 0; bit < 3; ++bit) rank = 4 * rank + kTwo[y >> bit & 1][x >> bit & 1];
  return rank;
}

}  // namespace xnewell
