#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/stepper/fragment_tint.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_pen.h"

namespace xnewell {

namespace {

/// Outlines polygons that are not painted yet in thin lines. Returns false if there are none, or too many.
bool outlineWaiting(SortPen& pen, Painter fine, const auto& placed) {
  const int left = static_cast<int>(pen.run.sorted().fragments.size()) - pen.run.replay().painted();
  if (left > kMostWaiting) return false;
  for (const auto& [id, marked] : pen.run.replay().list(kMostWaiting))
    outline(fine, placed(id), pen(marked ? Cell::Faint : Cell::WellLine));
  return left > 0;
}

/// Draws a letter in the middle of a piece that has room for it.
void letter(SortPen& pen, Painter& paint, const Samples& where, std::string_view text, Cell cell) {
  constexpr int kLeast = 300;  // of units
  if (where.count < kLeast * paint.unit() * paint.unit()) return;
  const Rect plate{where.x - 5, where.y - 7, 11, 15};
  paint.fillRect(plate, pen(cell));
  paint.frame(plate, pen(Cell::Black));
  paint.text(plate.x + 3, plate.y + 11, text, pen(Cell::White));
}

void markPair(SortPen& pen, Painter& paint, const auto& placed) {
  const Event& e = *pen.event;
  Painter fine = paint.pixels();
  const auto tinted = [&](int id, Cell cell, std::optional<Stipple> stipple) {
    return tintFragment(paint, pen.at.picture, pen.run.scene(), pen.run.sorted(), id, stipple, pen(cell));
  };
  const bool cutsQ = pen.cut >= 0 && pen.cut == e.Q;
  if (e.Q >= 0 && !cutsQ) {
    tinted(e.Q, Cell::Q, Stipple::Diagonals);
    outline(fine, placed(e.Q), pen(Cell::Black), {4});
    outline(fine, placed(e.Q), pen(Cell::Q), {2, 5, 3});
  }
  if (pen.cut >= 0) {
    const Cell cell = cutsQ ? Cell::Q : Cell::P;
    const int behind = pen.run.fragments().pieceOf(pen.run.replay().splits() - 1);
    const std::array names{"a", "b"};
    for (int k = 0; k < 2; ++k) {
      const Samples where = tinted(behind + k, cell, k == 0 ? Stipple::Eighth : Stipple::Quarter);
      outline(fine, placed(behind + k), pen(Cell::Black), {4});
      outline(fine, placed(behind + k), pen(cell), {2});
      letter(pen, paint, where, names[k], cell);
    }
    if (!cutsQ) return;
  }
  if (e.kind != Event::Kind::Paint) tinted(e.P, Cell::P, Stipple::Quarter);
  outline(fine, placed(e.P), pen(Cell::Black), {4});
  outline(fine, placed(e.P), pen(Cell::P), {2});
}

}  // namespace

Rect drawSortPicture(SortPen& pen) {
  const Rect &at = pen.at.picture, samples = at * pen.paint.unit();
  Painter paint = pen.paint.within(at);
  paint.place(pen.run.soFar(), at.x, at.y);
  const auto placed = [&](int id) {
    Outline figure = outlineOf(pen.run.fragments().region(id));
    for (Place& p : figure) p = {p.x + samples.x, p.y + samples.y};  // pixels
    return figure;
  };
  const bool outlined = outlineWaiting(pen, paint.pixels(), placed);
  Rect loupe;
  if (pen.event) {
    markPair(pen, paint, placed);
    if (pen.view.loupe) loupe = drawLoupe(pen);
  }

  const int painted = pen.run.replay().painted();
  const int all = static_cast<int>(pen.run.sorted().fragments.size());
  const std::string words = painted == all && all > 0 ? "painted: all " + counted(all, "piece")
                            : all == 0
                                ? "nothing to paint"
                                : "painted so far: " + grouped(painted) + " of " + counted(all, "piece") +
                                      (outlined                       ? "; the rest in outline"
                                       : all - painted > kMostWaiting ? "; the rest is too much to outline"
                                                                      : "");
  // A halo hides less of the picture than a plate would.
  for (const int dx : {-1, 0, 1})
    for (const int dy : {-1, 0, 1}) pen.paint.text(at.x + 10 + dx, at.y + 18 + dy, words, pen(Cell::Well));
  pen.paint.text(at.x + 10, at.y + 18, words, pen(Cell::WellText));
  return loupe;
}

}  // namespace xnewell
