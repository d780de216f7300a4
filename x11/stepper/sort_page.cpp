#include "x11/stepper/sort_page.h"

#include <algorithm>

#include "x11/drawing/font.h"
#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"

namespace xnewell {

std::string fitting(std::string_view text, int width) {
  const int letters = std::max(0, width / kGlyphWidth);
  std::string shown = latin1(text);
  if (static_cast<int>(shown.size()) <= letters) return std::string{text};
  const std::vector<std::string> lines = broken(text, std::max(1, letters - 2));
  return lines.empty() ? "" : lines.front() + "..";
}

void drawBadge(SortPen& pen, int x, int y, bool isP) {
  const Rect box{x, y, 13, 13};
  pen.paint.fillRect(box, pen(isP ? Cell::P : Cell::Q));
  if (!isP) pen.paint.frame(box, pen(Cell::Ink));
  pen.bold(x + 3, y + 11, isP ? "P" : "Q", isP ? Cell::White : Cell::Black);
}

SortDrawn drawSortPage(IndexImage& image, const SortLayout& at, SortRun& run, const SortView& view,
                       const CellPlan& plan) {
  run.goTo(view.step);
  // Where the smaller of two that pass through each other is cut, it takes the other's name: the rows of the
  // table were about them the other way round.
  const Event *const event = run.replay().event(), *compare = comparisonAt(run.sorted(), view.step);
  if (event && compare && (compare->P != event->P || compare->Q != event->Q)) compare = nullptr;
  SortPen pen{image, Painter{image}.within(at.body), at, run, view, plan, event, compare};
  pen.paint.fillRect(at.body, plan[Cell::Paper]);
  SortDrawn drawn;
  drawn.loupe = drawSortPicture(pen);
  drawTests(pen);
  drawFinding(pen);
  drawn.rows = drawSidesAndList(pen);
  drawCounts(pen);
  pen.rule(at.body.x, at.rule, at.body.width);
  drawTransport(pen);
  drawTimeline(pen);
  return drawn;
}

}  // namespace xnewell
