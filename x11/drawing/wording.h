#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// Places labels beside their points in a chart, where they cover neither a mark nor another label. A point
/// for whose label there is no room has none.
class Labels {
 public:
  static constexpr int kGap = 8;  ///< pixels between two labels in a line

  Labels(Painter paint, const CellPlan& plan, const Rect& area) : paint_{paint}, plan_{plan}, area_{area} {}

  /// No label will cover this.
  void avoid(const Rect& mark) { taken_.push_back(mark); }
  /// Takes the first of these places that lies in the area and covers nothing, if there is one.
  std::optional<Rect> take(std::span<const Rect> places);
  /// Draws a label beside the point (x, y), boxed or as it is. Returns its place, if there was room.
  std::optional<Rect> place(int x, int y, const std::string& text, bool boxed);

 private:
  Painter paint_;
  const CellPlan& plan_;
  Rect area_;
  std::vector<Rect> taken_;
};

/// Words and numbers for people.

inline constexpr std::string_view kNothingShows = "Nothing of the scene is in the picture.";

/// Breaks a text in UTF-8 into lines of at most `most` characters, at spaces where it can.
[[nodiscard]] std::vector<std::string> broken(std::string_view text, int most);

/// A number with a fixed number of decimals, so that columns align: 0.0042. -0.0 becomes 0.0.
[[nodiscard]] std::string fixed(double value, int decimals);
/// A number with this many decimals, or with fewer where it would be longer than `most` characters; in powers
/// of ten if even that does not fit, and "-" if it is not finite.
[[nodiscard]] std::string fitted(double value, int decimals, int most);
/// A number with so many significant digits, or fewer if they are enough: 1.25e-300. 17 tell every number.
[[nodiscard]] std::string significant(double value, int digits);
/// Milliseconds: with two decimals, and below 1 with three significant digits: 12.34, 0.0123.
[[nodiscard]] std::string msText(double ms);
/// 12,345.
[[nodiscard]] std::string grouped(std::int64_t value);
/// The size of a picture: `376 x 256`.
[[nodiscard]] std::string sizeText(int width, int height);
/// `1 cut`, `1,234 cuts`, `no cuts`.
[[nodiscard]] std::string counted(std::int64_t n, std::string_view what);

}  // namespace xnewell
