#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/visual/x11_error.h"

namespace xnewell {

/// What kinds of window the server offers (its visuals), and which one we take. Asked once; all that
/// follows works on these plain values.

/// Numbered as in the X protocol. Xlib has the plain words as macros.
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
  bool writable;  ///< its colormaps can hold colours of our own
};
inline constexpr std::array kVisualClasses{
    VisualClassRow{VisualClass::StaticGrayClass, "StaticGray", false},
    VisualClassRow{VisualClass::GrayScaleClass, "GrayScale", true},
    VisualClassRow{VisualClass::StaticColorClass, "StaticColor", false},
    VisualClassRow{VisualClass::PseudoColorClass, "PseudoColor", true},
    VisualClassRow{VisualClass::TrueColorClass, "TrueColor", false},
    VisualClassRow{VisualClass::DirectColorClass, "DirectColor", true},
};

/// The bits of a pixel value that hold red, green and blue; they mean nothing where pixels are cell numbers.
struct ChannelMasks {
  unsigned long red = 0, green = 0, blue = 0;  ///< each one run of at most 16 bits
  bool operator==(const ChannelMasks&) const = default;
};

struct VisualInfo {
  VisualClass kind{};
  int depth = 0;         ///< bits of a pixel value
  unsigned long id = 0;  ///< as `xdpyinfo` shows it
  ChannelMasks masks;
  int bitsPerRgb = 0;  ///< bits of each stored colour that reach the screen
  int cells = 0;       ///< colormap size; where masks are not 0 the levels of the channel that has most
  [[nodiscard]] bool writable() const { return kVisualClasses[static_cast<int>(kind)].writable; }
  /// Do red, green and blue have bits of their own in a pixel value?
  [[nodiscard]] bool hasChannels() const {
    return kind == VisualClass::TrueColorClass || kind == VisualClass::DirectColorClass;
  }
  /// Shows red, green and blue as one gray.
  [[nodiscard]] bool gray() const {
    return kind == VisualClass::StaticGrayClass || kind == VisualClass::GrayScaleClass;
  }
  /// Bits of a pixel that no colour uses: alpha, on some visuals of depth 32.
  [[nodiscard]] unsigned long alphaMask() const {
    return hasChannels() ? ((1ul << depth) - 1) & ~(masks.red | masks.green | masks.blue) : 0;
  }
  /// A pixel value as XQueryColors takes it: X.Org 21.1.16 answers BadValue where bits of alpha are set.
  [[nodiscard]] unsigned long withoutAlpha(unsigned long pixel) const { return pixel & ~alphaMask(); }
  /// Does a colormap of our own hold the picture's 256 cells? With channels through the pixels (i, i, i).
  [[nodiscard]] bool holdsTable() const { return writable() && leastLevels() >= 256; }
  /// Does every 8-bit colour have a pixel value of its own? Not where others store what pixels show.
  [[nodiscard]] bool exact() const { return !writable() && hasChannels() && leastLevels() >= 256; }
  /// Does every 8-bit colour, or on gray visuals its gray, have a pixel value that cannot change?
  [[nodiscard]] bool holdsColors() const {
    return exact() || (kind == VisualClass::StaticGrayClass && cells >= 256);
  }
  /// Of its channels, or where there are none its cells.
  [[nodiscard]] int leastLevels() const;
  [[nodiscard]] std::string name() const;  ///< "PseudoColor 8"
};

struct ServerVisuals {
  std::string display, vendor;
  std::vector<VisualInfo> visuals;  ///< of the default screen, in the server's order
  unsigned long defaultId = 0;
  unsigned long black = 0, white = 0;  ///< pixel values in the default colormap
  std::optional<int> freeCells;        ///< of the default colormap, where that is writable, if counted
  [[nodiscard]] const VisualInfo& defaultVisual() const;
};

/// `--visual CLASS[DEPTH]`: PseudoColor8, truecolor24, TrueColor, or "TrueColor 24" as messages have it.
struct VisualWish {
  VisualClass kind;
  std::optional<int> depth;
};
/// @throws std::invalid_argument naming what may be written.
[[nodiscard]] VisualWish parseVisualWish(std::string_view text);

/// `--colormap`: a map of our own, or cells of the one that all programs share by default.
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

/// The first of these that the server has, and among equals the default visual, else the server's first:
///   PseudoColor of 256 cells, of depth 8 before others
///   TrueColor 24, other TrueColor of 8 bits a channel, such DirectColor
///   coarser TrueColor, the deepest first; TrueColor with alpha (bits in no mask)
///   GrayScale of 256 cells
///   StaticColor, TrueColor and DirectColor of fewer than 15 bits
///   StaticGray of 256 grays, then of fewer; whatever has fewer cells
/// Why: all colours before some, all grays before few colours, and among equals what can be stored, for that
/// is our subject. But DirectColor comes after TrueColor, since on the screens that have both its map makes
/// all other windows flash, and alpha late, since a compositor may make something of it. MapOwner::Shared
/// takes the default visual: the cells of the default map are for no other.
/// @throws X11Error listing what the server has, if what was wished for is not among it.
[[nodiscard]] VisualChoice chooseVisual(const ServerVisuals& server,
                                        const std::optional<VisualWish>& wish = {},
                                        MapOwner owner = MapOwner::Private);

/// The table of `xnewell visuals`: equal visuals in one row with their number, what xnewell would do
/// with each, and the choice with its reason in the last line.
[[nodiscard]] std::string describeVisuals(const ServerVisuals& server,
                                          const std::optional<VisualWish>& wish = {},
                                          MapOwner owner = MapOwner::Private);

/// The pixel value of the map's entry k: where red, green and blue have their own, of the k-th of each.
[[nodiscard]] unsigned long pixelOfCell(const VisualInfo& visual, int k);
/// How many levels a channel with these bits has.
[[nodiscard]] unsigned long levelsOf(unsigned long mask);
/// The pixel value that shows `color` through `masks`: each channel's high bits, the others dropped, so 8-bit
/// channels show value >> 8 as servers do.
[[nodiscard]] unsigned long pixelOf(Rgb16 color, const ChannelMasks& masks);
/// What such a pixel shows: 0 is 0 and all bits set are 65535.
[[nodiscard]] Rgb16 colorOf(unsigned long pixel, const ChannelMasks& masks);

}  // namespace xnewell
