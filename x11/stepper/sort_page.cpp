#include "x11/stepper/sort_page.h"

#include "x11/stepper/sort_code.h"
#include "x11/stepper/sort_pen.h"

namespace xnewell {

void drawBadge(SortPen& pen, int x, int y, bool isP) {
  const Rect box{x, y, 13, 13};
  pen.paint.fillRect(box, pen(isP ? Cell::P : Cell::Q));
  if (!isP) pen.paint.frame(box, pen(Cell::Ink));
  pen.bold(x + 3, y + 11, isP ? "P" : "Q", isP ? Cell::White : Cell::Black);
}

namespace {

/// Tells the list where the controls are. The page draws them all itself.
void placeControls(ControlList& list, const SortLayout& at, const SortState& view, const SortDrawn& drawn) {
  const auto place = [&](SortPart part, int index, const Rect& area) {
    list.place(sortId(part, index), {.area = area, .bare = true});
  };
  placeTransport(list, at);
  for (int k = 0; k < kToggleCount; ++k) list.place(sortId(SortPart::Toggle, k), at.toggles[k]);
  for (int k = 0; view.asking && k < static_cast<int>(kAnswers.size()); ++k)
    place(SortPart::Answer, k, at.answers[k]);
  for (int k = 0; view.own && k < static_cast<int>(kActs.size()); ++k) place(SortPart::Act, k, at.acts[k]);
  for (int k = 0; view.own && k < kOwnTests; ++k) place(SortPart::Test, k, at.testRow(k));
  for (int k = 0; k < static_cast<int>(drawn.ring.size()); ++k) place(SortPart::Ring, k, drawn.ring[k].area);
  for (int k = 0; k < static_cast<int>(drawn.rows.size()); ++k)
    if (drawn.rows[k] >= 0)
      place(SortPart::Row, k, {at.list.x, at.list.y + k * at.line, at.list.width, at.line});
}

}  // namespace

SortDrawn drawSortPage(Painter paint, const SortLayout& layout, SortRun& run, const SortState& view,
                       const CellPlan& plan, ControlList* list) {
  run.goTo(view.step);
  SortLayout at = layout;
  std::vector<RingLink> ring;
  if (!view.asking && !at.ring.empty() && (at.shut || !view.code)) ring = run.ring();
  if (!ring.empty() && !at.shut) at.list.height -= at.ring.height;
  std::optional<Event> event = run.asTested();
  const bool sorting = view.own && view.step == run.steps();
  if (sorting && view.own->P >= 0)
    event = Event{.kind = Event::Kind::Take, .P = view.own->P, .Q = view.own->Q};
  else if (sorting)
    event.reset();
  const Event* compare = comparisonAt(run.sorted(), view.step);
  if (event && compare && (compare->P != event->P || compare->Q != event->Q)) compare = nullptr;
  if (sorting) compare = nullptr;
  // Where another program is wrong about a Q that the step does not name, or has not tested, we test it.
  const std::vector<const FalseStep*> wrong =
      view.own || view.asking ? std::vector<const FalseStep*>{} : run.wrong();
  std::optional<Event> ours;
  for (const FalseStep* one : wrong)
    if (event && !ours && one->Q >= 0 && !run.partsOf(one->Q).empty()) {
      if (event->Q < 0) event->Q = run.partsOf(one->Q)[0];
      if (event->Q != event->P) ours = run.compared(event->P, event->Q);
    }
  if (ours && !compare) compare = &*ours;
  const int cut = event && event->kind == Event::Kind::Split ? run.replay().event()->P : -1;
  SortPen pen{
      {paint.within(at.body), plan}, at, run, view, event ? &*event : nullptr, compare, cut, wrong, list};
  pen.paint.fillRect(at.body, plan[Cell::Paper]);
  SortDrawn drawn;
  drawn.loupe = drawSortPicture(pen);
  drawTests(pen);
  drawFinding(pen);
  if (!at.shut && view.code && !view.own) {
    const int top = at.side.y;
    drawPseudocode(pen, {at.list.x, top, at.list.width, at.counts.y - 6 - top}, at.line,
                   "Foley & van Dam 15.5.1", sortCode(run, view));
  } else if (!at.shut) {
    drawn.rows = drawSidesAndList(pen);
  }
  if (!ring.empty()) drawn.ring = drawRing(pen, ring);
  drawCounts(pen);
  pen.rule(at.body.x, at.rule, at.body.width);
  drawTransport(pen);
  drawTimeline(pen);
  if (list) placeControls(*list, at, view, drawn);
  return drawn;
}

}  // namespace xnewell
