#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// How a colour is shown where cells cannot be written: by the nearest colour that the server has, or by a
/// mixture of several whose mean it is. Nearness is the squared distance of the 8-bit values; of two equally
/// near colours the later one counts (as in quantize.h). The search uses integers only.

/// A pixel value and the colour that it shows.
struct OfferedColor {
  unsigned long pixel;
  glm::ivec3 color;  ///< 8-bit values
};

/// The bits of one channel in a pixel value, and the level that they show.
struct OfferedLevel {
  unsigned long bits;
  int value;  ///< 0..255
};

/// The pixel values of an 8 x 8 block, row by row. The block repeats from the picture's upper left corner.
using Tile = std::array<unsigned long, 64>;
[[nodiscard]] constexpr int placeInTile(int x, int y) { return (y & 7) * 8 + (x & 7); }

class OfferedColors {
 public:
  /// Any list of at least one colour, in any order.
  explicit OfferedColors(std::vector<OfferedColor> list) : list_{std::move(list)} {}
  /// Every combination of a red, a green and a blue level. Each channel has at least one level, in any order.
  /// The bits of `opaque` are set in every pixel value.
  OfferedColors(const std::array<std::vector<OfferedLevel>, 3>& levels, unsigned long opaque);
  /// Every combination of the channels' bits. `shown` gives the colour that a pixel value shows.
  OfferedColors(const ChannelMasks& masks, unsigned long opaque,
                const std::function<Rgb16(unsigned long pixel)>& shown);

  [[nodiscard]] std::size_t size() const;
  /// The nearest colour to `target`, whose values may lie outside 0..255.
  [[nodiscard]] OfferedColor nearest(const glm::ivec3& target) const;
  /// The candidates near `target`, for a caller that measures distance in another way: the whole list; or
  /// with channels, every combination of the nearest level and two levels on either side of it.
  [[nodiscard]] std::vector<OfferedColor> around(const glm::ivec3& target) const;

  /// Ordered dithering with any set of colours. The tile holds 64 colours. Each is the nearest to the wanted
  /// colour plus the error that is still owed. The brighter ones stand where bayerRank() is low.
  /// The error owed at the end is 64 times the error of the mean. If the levels of a channel (or the grays of
  /// a list) are at most s apart, and the wanted colour lies between the least and the greatest, this error
  /// never exceeds s / 2: the mean is right within s / 128. If no mixture gives the colour, the mean tends to
  /// the nearest mean that a mixture can give.
  /// @see T. Knoll, "Pattern dithering", US patent 6606166, expired; Adler et al., "The mathematics of
  /// halftoning", 2003
  [[nodiscard]] Tile mixture(const glm::ivec3& wanted) const;
  /// The distance between a colour and what stands for it, in 8-bit values. Without `mixed` that is the
  /// nearest colour. With `mixed` it is the mixture, seen as one spot: the error of its mean, plus an eighth
  /// of the root mean square of its grain, which is the standard error of the mean of 64 places drawn at
  /// random.
  [[nodiscard]] double miss(const glm::ivec3& wanted, bool mixed) const;

 private:
  using Parts = std::array<OfferedColor, 64>;
  [[nodiscard]] Parts partsOf(const glm::ivec3& wanted) const;
  /// The levels of one channel, with the nearest level for each 8-bit value.
  struct Channel {
    explicit Channel(const std::vector<OfferedLevel>& offered);
    /// The values, in 0..255, that stand for the level nearest to `v` and for up to two levels on either
    /// side: one value for each level.
    [[nodiscard]] std::vector<int> around(int v) const;
    std::array<int, 256> shows{};
    std::array<unsigned long, 256> bits{};
    std::size_t levels;
  };
  std::vector<OfferedColor> list_;
  std::vector<Channel> channels_;  ///< red, green, blue; empty if there is a list
  unsigned long opaque_ = 0;
};

/// How each index of a picture is shown: by one pixel value, or by a tile of several.
class PixelTable {
 public:
  PixelTable() = default;
  explicit PixelTable(const std::array<unsigned long, 256>& pixels) : pixels_{pixels} {}

  void set(int index, unsigned long pixel);
  /// Shows the index by `tile`. `pixel` is used where only one pixel value is possible.
  void set(int index, unsigned long pixel, const Tile& tile);

  /// One pixel value for each index.
  [[nodiscard]] const std::array<unsigned long, 256>& pixels() const { return pixels_; }
  /// True if some index is shown by several pixel values.
  [[nodiscard]] bool dithers() const { return !places_.empty(); }
  /// The pixel value of each index at one place of the tile. Precondition: dithers().
  [[nodiscard]] const std::array<unsigned long, 256>& at(int place) const { return places_[place]; }
  [[nodiscard]] Tile tile(int index) const;
  [[nodiscard]] bool solid(int index) const;
  bool operator==(const PixelTable&) const = default;

 private:
  std::array<unsigned long, 256> pixels_{};
  std::vector<std::array<unsigned long, 256>> places_;  ///< 64 tables, one for each place; none while every
                                                        ///< index has one pixel value
};

/// The 8-bit values that a server shows for a stored colour.
[[nodiscard]] inline glm::ivec3 eightBits(Rgb16 c) { return {c.r >> 8, c.g >> 8, c.b >> 8}; }

/// Chooses which of the server's colours stand for the sixteen interface colours where these cannot be
/// stored.
///
/// No interface colour is mixed, because text must be legible. Nearness is CIEDE2000: by 8-bit values, a dark
/// gray would become navy where blue has few levels. A colour that is drawn on another, or that follows
/// another in a legend of differences, stays darker or lighter than the other as long as the server's colours
/// allow it. If no colour is near enough, words become black, or white on the dark well.

using ToolColors = std::array<OfferedColor, kCells>;

/// `wanted` holds the 8-bit values of the interface colours; `has` holds the choices that are already
/// settled.
[[nodiscard]] ToolColors chooseToolColors(const OfferedColors& offered,
                                          const std::array<glm::ivec3, kCells>& wanted,
                                          const std::array<std::optional<OfferedColor>, kCells>& has = {});

}  // namespace xnewell
