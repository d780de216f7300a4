#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color_table.h"
#include "x11/x11_error.h"

struct _XDisplay;  // NOLINT(bugprone-reserved-identifier): Xlib's Display, without Xlib's macros

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

/// The bits of a pixel value that hold red, green and blue; all 0 where pixels are cell numbers.
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
  int cells = 0;       ///< colormap size; a channel's levels where masks are not 0
  [[nodiscard]] bool writable() const { return kVisualClasses[static_cast<int>(kind)].writable; }
  /// Bits of a pixel that no colour uses: alpha, on some visuals of depth 32. TrueColor only.
  [[nodiscard]] unsigned long alphaMask() const {
    return ((1ul << depth) - 1) & ~(masks.red | masks.green | masks.blue);
  }
  [[nodiscard]] std::string name() const;  ///< "PseudoColor 8"
};

struct ServerVisuals {
  std::string display, vendor;
  std::vector<VisualInfo> visuals;  ///< of the default screen, in the server's order
  unsigned long defaultId = 0;
  unsigned long black = 0, white = 0;  ///< pixel values in the default colormap
  std::optional<int> freeCells;        ///< of the default colormap, where that is writable
  [[nodiscard]] const VisualInfo& defaultVisual() const;
};

/// Free cells are counted by allocating them and giving them back; other programs that ask for a cell
/// in that moment (a few round trips) do not get one.
[[nodiscard]] ServerVisuals readVisuals(::_XDisplay* display);

/// `--visual CLASS[DEPTH]`: PseudoColor8, truecolor24, TrueColor.
struct VisualWish {
  VisualClass kind;
  std::optional<int> depth;
};
/// @throws std::invalid_argument naming what may be written.
[[nodiscard]] VisualWish parseVisualWish(std::string_view text);

struct VisualChoice {
  VisualInfo visual;
  std::string why;  ///< "a real 8-bit colormap: ..."
};
/// The first row that the server has: PseudoColor of depth 8, whose colormap is the picture's table;
/// TrueColor of depth 24, where the table is emulated; any other TrueColor, deepest first but with alpha
/// (bits in no mask) last. Among equals the default visual, else the server's first.
/// @throws X11Error listing what the server has, if that is nothing we use or not what was wished for.
[[nodiscard]] VisualChoice chooseVisual(const ServerVisuals& server,
                                        const std::optional<VisualWish>& wish = {});

/// The table of `xnewell visuals`: equal visuals in one row with their number, what xnewell would do
/// with each, and the choice with its reason in the last line.
[[nodiscard]] std::string describeVisuals(const ServerVisuals& server,
                                          const std::optional<VisualWish>& wish = {});

/// The pixel value that shows `color` through `masks`: each channel's high bits, the others dropped, so 8-bit
/// channels show value >> 8 as servers do.
[[nodiscard]] unsigned long pixelOf(Rgb16 color, const ChannelMasks& masks);
/// What such a pixel shows: 0 is 0 and all bits set are 65535.
[[nodiscard]] Rgb16 colorOf(unsigned long pixel, const ChannelMasks& masks);
