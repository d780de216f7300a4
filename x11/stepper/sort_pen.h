#pragma once

#include <string>

#include "x11/stepper/figure.h"
#include "x11/stepper/sort_page.h"

namespace xnewell {

/// What the parts of the stepper's page are drawn with: for its own source files.
struct SortPen {
  IndexImage& image;
  Painter paint;
  const SortLayout& at;
  SortRun& run;
  const SortView& view;
  const CellPlan& plan;
  const Event* event;    ///< of the step, null at the start
  const Event* compare;  ///< the tests that led to it; null where there are none

  [[nodiscard]] std::uint8_t operator()(Cell cell) const { return plan[cell]; }
  [[nodiscard]] int P() const { return event ? event->P : -1; }
  [[nodiscard]] int Q() const { return event ? event->Q : -1; }
  /// Whether the tests' outcome may be told.
  [[nodiscard]] bool told() const { return compare != nullptr && !view.asking; }
  /// Whether they got as far as the planes.
  [[nodiscard]] bool aboutPlanes() const {
    return told() && compare->test != Test::XExtents && compare->test != Test::YExtents;
  }
  int ink(int x, int y, std::string_view text) { return paint.text(x, y, text, plan[Cell::Ink]); }
  int soft(int x, int y, std::string_view text) { return paint.text(x, y, text, plan[Cell::Soft]); }
  int bold(int x, int y, std::string_view text, Cell cell = Cell::Ink) {
    return paint.text(x, y, text, plan[cell], Voice::Bold);
  }
  void caps(int x, int y, std::string_view text) { paint.text(x, y, text, plan[Cell::Soft], Voice::Caps); }
  void rule(int x, int y, int width) { paint.hline(x, y, width, plan[Cell::Rule]); }
  [[nodiscard]] bool hovers(SortPart part, int index) const { return view.hover == SortSpot{part, index}; }
};

/// P or Q in its colour, 13 x 13.
void drawBadge(SortPen& pen, int x, int y, bool isP);
/// As much of the text as has room.
[[nodiscard]] std::string fitting(std::string_view text, int width);

Rect drawSortPicture(SortPen& pen);
void drawTests(SortPen& pen);
void drawFinding(SortPen& pen);
std::vector<int> drawSidesAndList(SortPen& pen);
void drawCounts(SortPen& pen);
void drawTransport(SortPen& pen);
void drawTimeline(SortPen& pen);

}  // namespace xnewell
