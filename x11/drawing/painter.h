#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/index_image.h"
#include "x11/drawing/rect.h"

namespace xnewell {

/// Lines, areas, letters and small marks, drawn into the index image. Every view of the tool is drawn
/// with these, with and without a server. Colours are cells of the palette; what they mean is the caller's.
/// Coordinates and sizes are in units, x to the right, y downward; a unit is a square of 1, 4, 9 or 16
/// pixels, the same for all that is drawn. They stay within +-2^24, and what falls outside the image is not
/// drawn.

/// The styles of text. The width of a text is a multiple of the pitch.
enum class Voice { Plain, Bold, Caps, Title };
struct VoiceRow {
  Voice id;
  int pitch;  ///< from letter to letter
  int scale;
  bool bold, capitals;
  std::string_view looks;
};
inline constexpr std::array kVoices{
    VoiceRow{Voice::Plain, 6, 1, false, false, "as the font is"},
    VoiceRow{Voice::Bold, 6, 1, true, false, "drawn twice, 1 px apart"},
    VoiceRow{Voice::Caps, 8, 1, false, true, "capitals, 8 px a letter"},
    VoiceRow{Voice::Title, 12, 2, true, false, "doubled by Scale2x, bold"},
};
/// The width of a text in UTF-8, from the left edge of its first letter to where the next letter would start.
[[nodiscard]] int textWidth(std::string_view utf8, Voice voice = Voice::Plain);

/// A tint: which of an area's pixels are painted. The dots keep to one grid of the whole image, so the tints
/// of areas that touch join without a seam.
enum class Stipple { Quarter, Eighth, Diagonals };
struct StippleRow {
  Stipple id;
  int ofSixtyFour;  ///< pixels painted in any 8 x 8 of the image, exactly
  std::string_view looks;
};
inline constexpr std::array kStipples{
    StippleRow{Stipple::Quarter, 16, "25 %, every other row shifted"},
    StippleRow{Stipple::Eighth, 8, "12 %, dots on every other row"},
    StippleRow{Stipple::Diagonals, 8, "diagonals, 8 px apart"},
};
/// True if the tint paints this pixel of the image. x, y >= 0.
[[nodiscard]] bool stippled(Stipple stipple, int x, int y);

/// As much of a text in UTF-8 as fits, with dots at the end if it is not all.
[[nodiscard]] std::string beginningOf(std::string text, int width, Voice voice = Voice::Plain);

struct LineStyle {
  int thickness = 1;    ///< units across the line's longer axis, >= 1
  int on = 1, off = 0;  ///< dashes along the longer axis, from the first point; on >= 1
};

enum class Direction { Left, Right, Up, Down };

struct KeyCapCells {
  std::uint8_t face, edge, shadow, letter;
};
inline constexpr int kKeyCap = 15;          ///< height, and least width
inline constexpr int kKeyCapBaseline = 11;  ///< of its letter, below its top

/// What was written into an image, for the pointer: words, and the names on key caps.
struct Written {
  Rect place;  ///< in units
  std::string words;
  int pitch = 0;  ///< from letter to letter; 0: a key cap
};
using Writing = std::vector<Written>;

/// Draws into an image that outlives it. Small and copyable.
class Painter {
 public:
  /// A unit is `unit` x `unit` pixels. Any image can be drawn into, so it converts to its painter. What is
  /// written is added to `writing`, which outlives it, unless that is null.
  Painter(IndexImage& image, int unit = 1, Writing* writing = nullptr)
      : image_{&image}, unit_{unit}, step_{unit}, clip_{0, 0, image.width, image.height}, writing_{writing} {}
  /// How many pixels a unit is wide.
  [[nodiscard]] int unit() const { return unit_; }
  /// A painter of the same image whose coordinates are pixels: for areas, lines, frames, discs, rings and
  /// tints that mark single samples of a picture. Lines and rings stay as thick as units are, and so do the
  /// radii of discs and rings and the dots of tints.
  [[nodiscard]] Painter pixels() const;
  /// A painter of the same image that draws nothing outside `area`.
  [[nodiscard]] Painter within(const Rect& area) const;

  /// The cell at the upper left corner of a unit of the image.
  [[nodiscard]] std::uint8_t cellAt(int x, int y) const { return image_->row(y * step_)[x * step_]; }
  void point(int x, int y, std::uint8_t cell) { fillRect({x, y, 1, 1}, cell); }
  void fillRect(const Rect& area, std::uint8_t cell);
  void hline(int x, int y, int width, std::uint8_t cell) { fillRect({x, y, width, thick()}, cell); }
  void vline(int x, int y, int height, std::uint8_t cell) { fillRect({x, y, thick(), height}, cell); }
  /// The outermost units of the area.
  void frame(const Rect& area, std::uint8_t cell);
  void stipple(const Rect& area, Stipple stipple, std::uint8_t cell);
  /// A part of a picture, pixel by pixel, its upper left corner at (x, y). `part` is in the picture's pixels.
  void place(const IndexImage& picture, const Rect& part, int x, int y);
  /// All of a picture.
  void place(const IndexImage& picture, int x, int y) {
    place(picture, {0, 0, picture.width, picture.height}, x, y);
  }
  /// All of a picture, in an area of its proportions: each pixel there has the nearest of its samples.
  void fit(const IndexImage& picture, const Rect& area);
  /// Adds what is written elsewhere, and placed so far to the right and down.
  void note(const Writing& writing, int dx = 0, int dy = 0);
  /// Draws both ends too. Each step along the longer axis gets the nearest unit; half way between two, the
  /// one with the larger coordinate. So the units are the same from either end.
  void line(int x0, int y0, int x1, int y1, std::uint8_t cell, const LineStyle& style = {});
  /// The units whose centres are nearer to the centre of unit (x, y) than radius + 1/2.
  void disc(int x, int y, int radius, std::uint8_t cell);
  /// The disc without the disc of radius - 1.
  void ring(int x, int y, int radius, std::uint8_t cell);

  /// Draws UTF-8 from x to the right. The baseline is the first row below letters that have no descender.
  /// Returns where the next letter would start.
  int text(int x, int baseline, std::string_view utf8, std::uint8_t cell, Voice voice = Voice::Plain);
  /// Draws a text that ends where x = right. Returns where it starts.
  int textRight(int right, int baseline, std::string_view utf8, std::uint8_t cell,
                Voice voice = Voice::Plain);

  /// Draws a text with a rim, which hides less of a picture than a plate would.
  void haloed(int x, int baseline, std::string_view utf8, std::uint8_t cell, std::uint8_t rim);

  /// Marks, placed by their upper left corner. A tick is 7 x 7, a cross 8 x 7; a triangle is `depth` from
  /// base to tip and 2 depth - 1 along its base.
  void tick(int x, int y, std::uint8_t cell);
  void cross(int x, int y, std::uint8_t cell);
  void triangle(int x, int y, int depth, Direction to, std::uint8_t cell);

  /// A key cap with a name or an arrow, 15 units high and as wide as the name needs. Returns its width.
  int keyCap(int x, int y, std::string_view name, const KeyCapCells& cells);
  int keyCap(int x, int y, Direction arrow, const KeyCapCells& cells);

 private:
  void keyBlank(const Rect& area, const KeyCapCells& cells);
  /// The thickness of a rule.
  [[nodiscard]] int thick() const { return unit_ / step_; }

  IndexImage* image_;
  int unit_;
  int step_;   ///< pixels from one coordinate to the next
  Rect clip_;  ///< pixels, inside the image
  Writing* writing_;
};

}  // namespace xnewell
