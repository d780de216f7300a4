#include "x11/drawing/sheet.h"

#include <algorithm>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr int kPadding = 8;     // of a finding's box
constexpr int kBar = 3;         // at its left
constexpr int kTextInBox = 13;  // from its left edge

int columnsIn(int width) { return std::max(1, width / kVoices[0].pitch); }
int linesIn(int width, std::string_view text) {
  return static_cast<int>(broken(text, columnsIn(width)).size());
}
/// Bold letters are a pixel wider: a line of them has room for one less.
int boldWidth(int width) { return width - 1; }
int textInBox(int width) { return width - kTextInBox - kPadding; }

}  // namespace

Sheet::Sheet(int width, int height, const CellPlan& plan, int unit)
    : image_{width * unit, height * unit, plan[Cell::Paper]}, plan_{plan}, unit_{unit} {}

int Sheet::title(int x, int y, std::string_view text) {
  painter().text(x, y + 22, text, cell(Cell::Ink), Voice::Title);
  return y + kTitle;
}

int Sheet::section(int x, int y, int width, std::string_view name) {
  painter().hline(x, y, width, cell(Cell::Rule));
  painter().text(x, y + 16, name, cell(Cell::Soft), Voice::Caps);
  return y + kSection;
}

int Sheet::lines(int x, int y, int width, std::string_view text, Cell color, Voice voice) {
  for (const std::string& line : broken(text, columnsIn(width))) {
    painter().text(x, y + kAscent, line, cell(color), voice);
    y += kLine;
  }
  return y;
}

int Sheet::paragraph(int x, int y, int width, std::string_view text, Cell color) {
  return lines(x, y, width, text, color, Voice::Plain);
}

int Sheet::tableRow(int x, int y, std::string_view label, const std::vector<std::string>& values,
                    const std::vector<int>& ends, Cell color, Voice voice) {
  if (!label.empty() || words_.empty()) words_.emplace_back(label);
  for (const std::string& value : values) words_.back() += "   " + value;
  painter().text(x, y + kAscent, label, cell(Cell::Ink));
  for (std::size_t k = 0; k < values.size(); ++k)
    painter().textRight(x + ends[k] - (voice == Voice::Bold), y + kAscent, values[k], cell(color), voice);
  return y + kRow;
}

int Sheet::paragraphHeight(int width, std::string_view text) { return kLine * linesIn(width, text); }

int Sheet::findingHeight(int width, std::string_view bold, std::string_view why) {
  const int room = textInBox(width);
  return kLine * (linesIn(boldWidth(room), bold) + linesIn(room, why)) + 2 * kPadding - 2;
}

int Sheet::finding(int x, int y, int width, std::string_view bold, std::string_view why) {
  words_.emplace_back(bold);
  if (!why.empty()) words_.emplace_back(why);
  const int height = findingHeight(width, bold, why), room = textInBox(width);
  painter().fillRect({x, y, width, height}, cell(Cell::White));
  painter().fillRect({x, y, kBar, height}, cell(Cell::Ink));
  const int below = lines(x + kTextInBox, y + kPadding - 1, boldWidth(room), bold, Cell::Ink, Voice::Bold);
  lines(x + kTextInBox, below, room, why, Cell::Ink, Voice::Plain);
  return y + height;
}

}  // namespace xnewell
