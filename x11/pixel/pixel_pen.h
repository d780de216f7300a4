#pragma once

#include <array>
#include <string>
#include <string_view>

#include "x11/drawing/wording.h"
#include "x11/pixel/pixel_page.h"

namespace xnewell {

/// Writes the explanation from top to bottom.
struct PixelPen : Pen {
  const PixelLayout& at;
  const PixelPage& page;
  int y;
  PixelPlaces places = {};

  [[nodiscard]] static std::string number(double v) { return fixed(v, kPixelDecimals); }
  [[nodiscard]] static char letterOfVertex(int vertex) { return static_cast<char>('A' + vertex % 26); }
  [[nodiscard]] const PixelStory& story() const { return page.story; }
  [[nodiscard]] const Explanation& e() const {
    return story().explained[static_cast<std::size_t>(page.chosen)];
  }
  [[nodiscard]] int x() const { return at.column.x; }
  [[nodiscard]] int right() const { return at.column.x + at.column.width; }
  [[nodiscard]] bool hasRoom(int lines = 1) const {
    return y + (lines - 1) * at.pitch + 3 <= at.column.y + at.column.height;
  }

  /// Writes a line if there is room for it.
  void line(std::string_view text, bool bold = false, int indent = 0) {
    if (hasRoom()) paint.text(x() + indent, y, text, (*this)(Cell::Ink), bold ? Voice::Bold : Voice::Plain);
    y += at.pitch;
  }
  void section(std::string_view name, std::string_view aside) {
    y += at.pitch / 2;
    if (hasRoom()) {
      rule(x(), y - at.pitch + 1, at.column.width);
      caps(x(), y + 1, name);
      softRight(right(), y + 1, aside);
    }
    y += at.pitch + 2;
  }

  /// True if a value would give away the one that the student is asked.
  [[nodiscard]] bool hides(Predicted value) const { return page.asked && *page.asked <= value; }
  [[nodiscard]] std::string numberOf(Predicted value, double v) const {
    return hides(value) ? "?" : number(v);
  }

  void verdict();
  void history();
  void surface();
  void equation();
  void table();
  void facts();
  void bar(const ExplainedEquation& of);
  /// Where a drawing stands, from the line y on, beside lines that take `words` units; empty without room. It
  /// takes what is left above so many lines, up to two fifths of the page.
  [[nodiscard]] Rect beside(int words, int linesBelow) const;
  /// Moves below a drawing.
  void passBy(const Rect& drawn) {
    if (drawn.height > 0) y = std::max(y, drawn.y + drawn.height + 14);
  }
};

}  // namespace xnewell
