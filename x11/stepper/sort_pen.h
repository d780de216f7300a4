#pragma once

#include <string>

#include "x11/drawing/painter.h"
#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_picture.h"

namespace xnewell {

/// What the parts of the stepper's page are drawn with; only for the source files of that page.
struct SortPen : Pen {
  const SortLayout& at;
  SortRun& run;
  const SortState& view;
  const Event* event;                   ///< the event of the step; null at the start
  const Event* compare;                 ///< the tests that led to it; null if there are none
  int cut;                              ///< the polygon that the step cuts, P or Q; -1 if it cuts none
  std::vector<const FalseStep*> wrong;  ///< of another program, if the page may tell it
  const ControlList* list;

  /// The picture's size, in samples, and how many pixels of the window a sample is shown wide.
  [[nodiscard]] glm::ivec2 size() const {
    const PictureSettings& settings = run.picture().settings();
    return {settings.width, settings.height};
  }
  [[nodiscard]] double scale() const { return 1.0 * at.picture.width * paint.unit() / size().x; }
  /// How many samples of a fragment lie in an area of the window, in units.
  [[nodiscard]] std::int64_t samplesIn(const Rect& units, int id) const;
  [[nodiscard]] int P() const { return event ? event->P : -1; }
  [[nodiscard]] int Q() const { return event ? event->Q : -1; }
  /// True while the student is to say what comes next.
  [[nodiscard]] bool sorting() const { return view.own && view.step == run.steps(); }
  /// How many polygons are not painted yet.
  [[nodiscard]] int left() const;
  /// True if the page may show the outcome of the tests.
  [[nodiscard]] bool told() const { return compare != nullptr && !view.asking; }
  /// True if the tests got as far as the planes.
  [[nodiscard]] bool aboutPlanes() const {
    return told() && compare->test != Test::XExtents && compare->test != Test::YExtents;
  }
  [[nodiscard]] Look look(SortPart part, int index = 0) const {
    return list ? list->look(sortId(part, index)) : Look{};
  }
};

/// A badge of P or Q in its colour, 13 x 13 units.
void drawBadge(SortPen& pen, int x, int y, bool isP);

Rect drawSortPicture(SortPen& pen);
/// Draws P and Q enlarged, in a corner of the picture that is free of them: their corners with the
/// distances that decide, and the line where their planes meet. Returns the area of the loupe, which is empty
/// if it would not enlarge them.
Rect drawLoupe(SortPen& pen);
void drawTests(SortPen& pen);
void drawFinding(SortPen& pen);
std::vector<int> drawSidesAndList(SortPen& pen);
/// Draws the names of a cycle in a ring, with the tests that made it.
std::vector<RingPlace> drawRing(SortPen& pen, const std::vector<RingLink>& ring);
void drawCounts(SortPen& pen);
void drawTransport(SortPen& pen);
void drawTimeline(SortPen& pen);

}  // namespace xnewell
