#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// What stands for a colour where cells cannot be stored: the nearest that the server has, or several of them
/// side by side whose mean it is. Nearest is meant by the squared distance of the 8-bit values, of two
/// equally near the later (as nearest_color.h). What is shown is found with integers alone.

/// A pixel value and what it shows.
struct OfferedColor {
  unsigned long pixel;
  glm::ivec3 color;  ///< 8-bit values
};

/// The bits of a pixel value that are one channel's, and what they show.
struct OfferedLevel {
  unsigned long bits;
  int value;  ///< of 255
};

/// Pixel values for an 8 x 8 block, row by row, repeated from the picture's upper left corner.
using Tile = std::array<unsigned long, 64>;
[[nodiscard]] constexpr int placeInTile(int x, int y) { return (y & 7) * 8 + (x & 7); }

class OfferedColors {
 public:
  /// Some colours, in any order; at least one.
  explicit OfferedColors(std::vector<OfferedColor> list) : list_{std::move(list)} {}
  /// Each of a red, a green and a blue level; some of each, in any order. `opaque` is set in every pixel.
  OfferedColors(const std::array<std::vector<OfferedLevel>, 3>& levels, unsigned long opaque);
  /// All that the channels' bits can say. `shown` tells what a pixel value shows.
  OfferedColors(const ChannelMasks& masks, unsigned long opaque,
                const std::function<Rgb16(unsigned long pixel)>& shown);

  [[nodiscard]] std::size_t size() const;
  /// To `target`, whose values may lie outside 0..255.
  [[nodiscard]] OfferedColor nearest(const glm::ivec3& target) const;
  /// What there is to choose from where another distance counts: the whole list; of each channel the nearest
  /// level and two on either side.
  [[nodiscard]] std::vector<OfferedColor> around(const glm::ivec3& target) const;

  /// Sixty-four times the colour nearest to the wanted one plus what is still owed of it, the brighter ones
  /// where bayerRank() is low: ordered dithering with any colours. What is owed at the end is the error of
  /// the mean, times 64. Where the levels of a channel, or the grays of a list, are at most s apart, and the
  /// wanted one lies between the least and the greatest, it never exceeds s / 2: the mean is right within s /
  /// 128. Where no mixture gives the colour, the mean tends to the nearest that one can give. @see T. Knoll,
  /// "Pattern dithering", US patent 6606166, expired; Adler et al., "The mathematics of halftoning", 2003
  [[nodiscard]] Tile mixture(const glm::ivec3& wanted) const;
  /// How far a colour is from what stands for it, in 8-bit values: the nearest, or the mixture seen as one
  /// spot. Of that the error of the mean counts, and of the grain an eighth of its root mean square, as the
  /// mean of 64 places drawn at random has.
  [[nodiscard]] double miss(const glm::ivec3& wanted, bool mixed) const;

 private:
  using Parts = std::array<OfferedColor, 64>;
  [[nodiscard]] Parts partsOf(const glm::ivec3& wanted) const;
  /// One channel's bits, and the nearest of its levels to each 8-bit value.
  struct Channel {
    explicit Channel(const std::vector<OfferedLevel>& offered);
    /// Values of 0..255 that the levels around `v` are nearest to, one for each.
    [[nodiscard]] std::vector<int> around(int v) const;
    std::array<int, 256> shows{};
    std::array<unsigned long, 256> bits{};
    std::size_t levels;
  };
  std::vector<OfferedColor> list_;
  std::vector<Channel> channels_;  ///< red, green, blue; empty where there is a list
  unsigned long opaque_ = 0;
};

/// How each index of a picture is shown: by one pixel value, or by a tile of several.
class PixelTable {
 public:
  PixelTable() = default;
  explicit PixelTable(const std::array<unsigned long, 256>& pixels) : pixels_{pixels} {}

  void set(int index, unsigned long pixel);
  /// `pixel` stands for it where there can be only one.
  void set(int index, unsigned long pixel, const Tile& tile);

  /// One pixel value each.
  [[nodiscard]] const std::array<unsigned long, 256>& pixels() const { return pixels_; }
  /// Is any index shown by several?
  [[nodiscard]] bool dithers() const { return !places_.empty(); }
  /// The pixel values at a place of the tile; only where it dithers.
  [[nodiscard]] const std::array<unsigned long, 256>& at(int place) const { return places_[place]; }
  [[nodiscard]] Tile tile(int index) const;
  [[nodiscard]] bool solid(int index) const;
  bool operator==(const PixelTable&) const = default;

 private:
  std::array<unsigned long, 256> pixels_{};
  std::vector<std::array<unsigned long, 256>> places_;  ///< 64, or none while every index has one pixel value
};

/// The values that servers show of a stored colour.
[[nodiscard]] inline glm::ivec3 eightBits(Rgb16 c) { return {c.r >> 8, c.g >> 8, c.b >> 8}; }

}  // namespace xnewell
