#include "x11/stepper/sort_page.h"

#include "x11/stepper/sort_pen.h"

namespace xnewell {

void drawBadge(SortPen& pen, int x, int y, bool isP) {
  const Rect box{x, y, 13, 13};
  pen.paint.fillRect(box, pen(isP ? Cell::P : Cell::Q));
  if (!isP) pen.paint.frame(box, pen(Cell::Ink));
  pen.bold(x + 3, y + 11, isP ? "P" : "Q", isP ? Cell::White : Cell::Black);
}

SortDrawn drawSortPage(IndexImage& image, const SortLayout& at, SortRun& run, const SortView& view,
                       const CellPlan& plan) {
  run.goTo(view.step);
  // Of two polygons that pass through each other the smaller is cut and is then called P. If the tests were
  // made with the names the other way round, their rows would mislead.
  const Event *const event = run.replay().event(), *compare = comparisonAt(run.sorted(), view.step);
  if (event && compare && (compare->P != event->P || compare->Q != event->Q)) compare = nullptr;
  SortPen pen{{Painter{image}.within(at.body), plan}, image, at, run, view, event, compare};
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
