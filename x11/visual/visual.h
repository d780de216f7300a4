#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/visual/x11_error.h"

namespace xnewell {

/// What kinds of window the server offers (its visuals), and which one we take. The server is asked once;
/// everything after that works on these plain values.

/// The numbers are those of the X protocol. The names end in Class because Xlib defines the plain words as
/// macros.
enum class VisualClass {
  StaticGrayClass,
  GrayScaleClass,
  StaticColorClass,
  PseudoColorClass,
  TrueColorClass,
  DirectColorClass
};
struct VisualClassRow {
  VisualClass id;
  std::string_view name;
  bool writable;  ///< true if a colormap of this class can hold colours of our own
};
inline constexpr std::array kVisualClasses{
    VisualClassRow{VisualClass::StaticGrayClass, "StaticGray", false},
    VisualClassRow{VisualClass::GrayScaleClass, "GrayScale", true},
    VisualClassRow{VisualClass::StaticColorClass, "StaticColor", false},
    VisualClassRow{VisualClass::PseudoColorClass, "PseudoColor", true},
    VisualClassRow{VisualClass::TrueColorClass, "TrueColor", false},
    VisualClassRow{VisualClass::DirectColorClass, "DirectColor", true},
};

/// The bits of a pixel value that hold red, green and blue. They have no meaning where pixel values are cell
/// numbers.
struct ChannelMasks {
  unsigned long red = 0, green = 0, blue = 0;  ///< each is one run of at most 16 bits
  bool operator==(const ChannelMasks&) const = default;
};

struct VisualInfo {
  VisualClass kind{};
  int depth = 0;         ///< bits per pixel value
  unsigned long id = 0;  ///< the id that `xdpyinfo` prints
  ChannelMasks masks;
  int bitsPerRgb = 0;  ///< bits of each stored colour that reach the screen
  int cells = 0;       ///< colormap entries; for a visual with channels, the levels of the channel that has
                       ///< the most
  [[nodiscard]] bool writable() const { return kVisualClasses[static_cast<int>(kind)].writable; }
  /// True if red, green and blue each have their own bits in a pixel value.
  [[nodiscard]] bool hasChannels() const {
    return kind == VisualClass::TrueColorClass || kind == VisualClass::DirectColorClass;
  }
  /// True if the visual shows red, green and blue as one gray.
  [[nodiscard]] bool gray() const {
    return kind == VisualClass::StaticGrayClass || kind == VisualClass::GrayScaleClass;
  }
  /// The bits of a pixel value that belong to no colour: alpha, on some visuals of depth 32.
  [[nodiscard]] unsigned long alphaMask() const {
    return hasChannels() ? ((1ul << depth) - 1) & ~(masks.red | masks.green | masks.blue) : 0;
  }
  /// A pixel value as XQueryColors accepts it. X.Org 21.1.16 answers BadValue if bits of alpha are set.
  [[nodiscard]] unsigned long withoutAlpha(unsigned long pixel) const { return pixel & ~alphaMask(); }
  /// True if a private colormap holds the picture's 256 cells. With channels, the pixel values are (i, i, i).
  [[nodiscard]] bool holdsTable() const { return writable() && leastLevels() >= 256; }
  /// True if every 8-bit colour has its own pixel value, and no client can change what that value shows.
  [[nodiscard]] bool exact() const { return !writable() && hasChannels() && leastLevels() >= 256; }
  /// True if every 8-bit colour has a fixed pixel value. On a gray visual: if every 8-bit gray has one.
  [[nodiscard]] bool holdsColors() const {
    return exact() || (kind == VisualClass::StaticGrayClass && cells >= 256);
  }
  /// How many of the high bits of a stored red, green or blue the screen shows, the least of the three. 0 if
  /// it shows something else than the stored colour: its gray, or a colour of several cells.
  [[nodiscard]] int shownBits() const;
  /// The least number of levels among the channels; without channels, the number of cells.
  [[nodiscard]] int leastLevels() const;
  [[nodiscard]] std::string name() const;  ///< "PseudoColor 8"
};

struct ServerVisuals {
  std::string display, vendor;
  std::vector<VisualInfo> visuals;  ///< of the default screen, in the server's order
  unsigned long defaultId = 0;
  unsigned long black = 0, white = 0;  ///< pixel values in the default colormap
  std::optional<int> freeCells;        ///< free cells of the default colormap, if it is writable and they
                                       ///< were counted
  [[nodiscard]] const VisualInfo& defaultVisual() const;
};

/// `--visual CLASS[DEPTH]`: PseudoColor8, truecolor24, TrueColor, or "TrueColor 24" as in messages.
struct VisualWish {
  VisualClass kind;
  std::optional<int> depth;
};
/// Upper and lower case are the same. @throws std::invalid_argument with a list of the classes.
[[nodiscard]] VisualWish parseVisualWish(std::string_view text);

/// `--colormap`: a map of our own, or cells of the default map, which all programs share.
enum class MapOwner { Private, Shared };
struct MapOwnerRow {
  MapOwner id;
  std::string_view name;
};
inline constexpr std::array kMapOwners{
    MapOwnerRow{MapOwner::Private, "private"},
    MapOwnerRow{MapOwner::Shared, "shared"},
};

struct VisualChoice {
  VisualInfo visual;
  std::string why;  ///< "a real 8-bit colormap: ..."
};

/// Takes the first of these that the server has. If there are several of a kind, it takes the deepest, then
/// the default visual, then the server's first.
///   PseudoColor of 256 cells, first of depth 8, then of other depths
///   TrueColor 24, other TrueColor with 8 bits per channel, then DirectColor with 8 bits per channel
///   coarser TrueColor of 15 bits or more; TrueColor with alpha (bits in no mask)
///   GrayScale of 256 cells
///   StaticColor of 8 bits or more, then other TrueColor, then other DirectColor
///   StaticGray of 256 grays, then of fewer; then any other visual
/// The reasons: all colours are better than some, and all grays are better than few colours. Among equals, a
/// map that can be written is better, because it is our subject. But DirectColor comes after TrueColor: on
/// screens that have both, its map makes all other windows flash. And alpha comes late, because a compositor
/// may use it. MapOwner::Shared takes the default visual, because the cells of the default map fit no other.
/// @throws X11Error with a list of what the server has, if it lacks the visual that was asked for.
[[nodiscard]] VisualChoice chooseVisual(const ServerVisuals& server,
                                        const std::optional<VisualWish>& wish = {},
                                        MapOwner owner = MapOwner::Private);

/// The table that `xnewell visuals` prints. Equal visuals share a row with their number. Each row says what
/// xnewell would do with the visual. The last line names the choice and its reason.
[[nodiscard]] std::string describeVisuals(const ServerVisuals& server,
                                          const std::optional<VisualWish>& wish = {},
                                          MapOwner owner = MapOwner::Private);

/// The pixel value of the colormap's entry k. With channels, it selects the k-th entry of each.
[[nodiscard]] unsigned long pixelOfCell(const VisualInfo& visual, int k);
/// The number of levels of a channel with these bits.
[[nodiscard]] unsigned long levelsOf(unsigned long mask);
/// The pixel value that shows `color` through `masks`. Each channel keeps its high bits and drops the others,
/// so an 8-bit channel shows value >> 8, as servers do.
[[nodiscard]] unsigned long pixelOf(Rgb16 color, const ChannelMasks& masks);
/// The colour that such a pixel value shows. A channel with no bit set is 0; one with all bits set is 65535.
[[nodiscard]] Rgb16 colorOf(unsigned long pixel, const ChannelMasks& masks);

}  // namespace xnewell
