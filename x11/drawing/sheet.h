#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// What a view has found, and why: one sentence or more each.
struct Finding {
  std::string bold, why;
};

/// A page of the window uses less space between its parts if its body is lower than this, in units.
inline constexpr int kCompactBelow = 560;

/// A sheet of paper for a view of numbers: pictures, titles, paragraphs, tables and findings on the grid of
/// the window's drawing. All is in units; a part is placed by its upper left corner, and its function
/// returns the y below it.
class Sheet {
 public:
  static constexpr int kMargin = 16, kGutter = 16;
  static constexpr int kLine = 16;     ///< from line to line of a paragraph
  static constexpr int kRow = 18;      ///< of a table
  static constexpr int kAscent = 11;   ///< from a line's top to its baseline
  static constexpr int kSection = 28;  ///< of a section's line and name
  static constexpr int kTitle = 34;

  /// A unit is `unit` x `unit` pixels of the image.
  Sheet(int width, int height, const CellPlan& plan, int unit = 1);

  [[nodiscard]] const IndexImage& image() const { return image_; }
  /// The rows of tables and the findings, in the order in which they were drawn.
  [[nodiscard]] const std::vector<std::string>& report() const { return words_; }
  [[nodiscard]] const Writing& writing() const { return writing_; }
  [[nodiscard]] Painter painter() { return {image_, unit_, &writing_}; }
  [[nodiscard]] std::uint8_t cell(Cell c) const { return plan_[c]; }

  int title(int x, int y, std::string_view text);
  /// A hairline and a name in capitals.
  int section(int x, int y, int width, std::string_view name);
  int paragraph(int x, int y, int width, std::string_view text, Cell cell);
  /// A label at the left, and values aligned right at `ends`, which are counted from x. Without a label it
  /// goes on with the row before.
  int tableRow(int x, int y, std::string_view label, const std::vector<std::string>& values,
               const std::vector<int>& ends, Cell cell = Cell::Ink, Voice voice = Voice::Bold);
  /// A white box with a bar at its left: the finding in bold, then why.
  int finding(int x, int y, int width, std::string_view bold, std::string_view why);
  /// The height of such a box.
  [[nodiscard]] static int findingHeight(int width, std::string_view bold, std::string_view why);
  [[nodiscard]] static int paragraphHeight(int width, std::string_view text);

 private:
  int lines(int x, int y, int width, std::string_view text, Cell cell, Voice voice);

  IndexImage image_;
  Writing writing_;
  std::vector<std::string> words_;
  CellPlan plan_;
  int unit_;
};

}  // namespace xnewell
