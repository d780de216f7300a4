#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/images.h"

namespace xnewell {

/// The pixels [x, x + width) x [y, y + height), y downward; empty where a side is not positive.
struct Rect {
  int x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  /// True if pixel (i, j) is one of them. Precondition: its sides end within int.
  [[nodiscard]] bool has(int i, int j) const { return i >= x && i < x + width && j >= y && j < y + height; }
  bool operator==(const Rect&) const = default;
};

/// The rectangle with all its sides `factor` times as far from the origin, such as units in pixels.
[[nodiscard]] constexpr Rect operator*(const Rect& r, int factor) {
  return {r.x * factor, r.y * factor, r.width * factor, r.height * factor};
}

/// The pixels that two rectangles share. Precondition: their sides end within int.
[[nodiscard]] constexpr Rect intersection(const Rect& a, const Rect& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

/// The pixels of a line, both ends included. Each step along the longer axis gets the nearest pixel; half way
/// between two, the one with the larger coordinate. So the pixels are the same from either end.
/// @see Foley & van Dam 2e §3.2

/// Calls use(k, x, y) for each pixel of the line, the k-th of it, that lies within `area` along the longer
/// axis. Along the other axis it may lie outside. Coordinates stay within +-2^24. Bresenham 1965, begun where
/// the line enters the area. After k of n steps the other coordinate is floor(k d / n + 1/2) = floor((2 k d +
/// n) / 2n) from its start: `whole`, and `rest` of 2n.
template <class Use>
void forEachPixelOfLine(const Rect& area, int x0, int y0, int x1, int y1, Use&& use) {
  const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
  const int from = steep ? y0 : x0, to = steep ? y1 : x1, across = steep ? x0 : y0;
  const int forward = to < from ? -1 : 1;
  const int areaFrom = steep ? area.y : area.x, areaEnd = areaFrom + (steep ? area.height : area.width);
  const std::int64_t n = std::abs(to - from), d = steep ? x1 - x0 : y1 - y0;

  const int enters = forward > 0 ? areaFrom - from : from - (areaEnd - 1);
  const int leaves = forward > 0 ? areaEnd - 1 - from : from - areaFrom;
  const int first = std::max(0, enters), last = std::min(static_cast<int>(n), leaves);
  const std::int64_t whole2n = std::max<std::int64_t>(1, 2 * n), numerator = 2 * first * d + n;
  std::int64_t rest = ((numerator % whole2n) + whole2n) % whole2n, whole = (numerator - rest) / whole2n;
  for (int k = first; k <= last; ++k) {
    const int along = from + forward * k, beside = across + static_cast<int>(whole);
    steep ? use(k, beside, along) : use(k, along, beside);
    rest += 2 * d;
    if (rest >= whole2n) {
      rest -= whole2n;
      ++whole;
    } else if (rest < 0) {
      rest += whole2n;
      --whole;
    }
  }
}

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

/// Draws the window's texts, keys and rules with the cells of a plan. A view that needs more adds it to a
/// struct derived from this one.
struct Pen {
  Painter paint;
  const CellPlan& plan;

  [[nodiscard]] std::uint8_t operator()(Cell cell) const { return plan[cell]; }
  [[nodiscard]] KeyCapCells keyCells() const {
    return {plan[Cell::Panel], plan[Cell::Rule], plan[Cell::Faint], plan[Cell::Soft]};
  }
  int key(int x, int y, std::string_view name) { return paint.keyCap(x, y, name, keyCells()); }
  int arrow(int x, int y, Direction d) { return paint.keyCap(x, y, d, keyCells()); }
  int soft(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Soft]); }
  int ink(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Ink]); }
  int bold(int x, int y, std::string_view s, Cell cell = Cell::Ink) {
    return paint.text(x, y, s, plan[cell], Voice::Bold);
  }
  int softRight(int x, int y, std::string_view s) { return paint.textRight(x, y, s, plan[Cell::Soft]); }
  void boldRight(int x, int y, std::string_view s) { paint.textRight(x, y, s, plan[Cell::Ink], Voice::Bold); }
  int caps(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Soft], Voice::Caps); }
  void rule(int x, int y, int width) { paint.hline(x, y, width, plan[Cell::Rule]); }
};

/// A white box with a bar of a colour at its left: the finding in bold, then why, in as many lines of this
/// height as fit.
void drawFindingBox(Pen& pen, const Rect& at, int line, std::string_view bold, std::string_view why,
                    Cell bar);

/// Marks the row that has the keyboard: a background that reaches `beyond` pixels past its end, and an ink
/// bar before it.
void drawFocus(Pen& pen, const Rect& row, int beyond = 2);

}  // namespace xnewell
