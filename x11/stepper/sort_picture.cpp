#include <algorithm>
#include <array>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/stepper/fragment_tint.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_pen.h"

namespace xnewell {

namespace {

/// Marks the samples that painting too early has spoilt.
void markSpoilt(SortPen& pen, Painter fine, const Rect& samples, const std::vector<SampleRow>& rows) {
  const auto pixel = [&](int sample) { return static_cast<int>(pen.scale() * sample); };
  for (const SampleRow& row : rows) {
    const Rect marked{samples.x + pixel(row.from), samples.y + pixel(row.row),
                      std::max(1, pixel(row.to) - pixel(row.from)),
                      std::max(1, pixel(row.row + 1) - pixel(row.row))};
    fine.fillRect(marked, pen(Cell::Alarm));
    fine.stipple(marked, Stipple::Quarter, pen(Cell::White));
  }
}

/// What is false in a step of another program: the samples where it shows, the outlines that it tells, and
/// lightly those that would have been right.
void markFalse(SortPen& pen, Painter fine, const Rect& samples, const auto& placed) {
  for (const FalseStep* wrong : pen.wrong) {
    const bool isEarly = wrong->kind == Falsehood::TooEarly, isLate = wrong->kind == Falsehood::NotFirst;
    if ((isEarly || isLate) && pen.Q() >= 0)
      markSpoilt(pen, fine, samples,
                 (isEarly ? pen.run.hidden(pen.P(), pen.Q()) : pen.run.hidden(pen.Q(), pen.P())).rows);
    for (const int polygon : wrong->right)
      for (const int id : pen.run.partsOf(polygon)) {
        tintFragment(pen.paint, pen.at.picture, pen.size(), pen.run.scene(), pen.run.sorted(), id,
                     Stipple::Eighth, pen(Cell::Good));
        outline(fine, placed(id), pen(Cell::Good), {2, 3, 3});
      }
    const PictureSettings& size = pen.run.theirs()->picture.settings();
    for (const std::vector<glm::dvec2>& told : wrong->told) {
      Outline figure;
      for (const glm::dvec2& at : told)
        figure.push_back(
            {samples.x + at.x * samples.width / size.width, samples.y + at.y * samples.height / size.height});
      outline(fine, figure, pen(Cell::Alarm), {2});
    }
  }
}

/// Writes the names of polygons, painted or not, where the finished picture shows enough of them. So no name
/// is on another polygon.
void drawNames(SortPen& pen, Painter& paint, const std::array<Rect, 2>& taken) {
  constexpr int kAround = 2, kHigh = 10;
  std::vector<int> ids = pen.run.waiting();
  for (int n = 0; n < pen.run.replay().painted(); ++n) ids.push_back(pen.run.paintedId(n));
  const double samples = paint.unit() / pen.scale();
  for (const int id : ids) {
    const std::string name = pen.run.shortName(id);
    const glm::dvec2 room{textWidth(name) + 2 * kAround, kHigh + 2 * kAround};
    const auto corner = pen.run.roomFor(id, glm::ivec2{glm::ceil(samples * room)});
    if (!corner) continue;
    const Rect& at = pen.at.picture;
    const Rect place{at.x + static_cast<int>(corner->x / samples) + kAround,
                     at.y + static_cast<int>(corner->y / samples) + kAround, textWidth(name), kHigh};
    if (std::ranges::any_of(taken, [&](const Rect& r) { return !intersection(r, place).empty(); })) continue;
    paint.haloed(place.x, place.y + 9, name, pen(Cell::WellText), pen(Cell::Well));
  }
}

void markPair(SortPen& pen, Painter& paint, const auto& placed) {
  const Event& e = *pen.event;
  Painter fine = paint.pixels();
  const auto tinted = [&](int id, Cell cell, std::optional<Stipple> stipple) {
    return tintFragment(paint, pen.at.picture, pen.size(), pen.run.scene(), pen.run.sorted(), id, stipple,
                        pen(cell));
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
    for (int k = 0; k < 2; ++k) {
      tinted(behind + k, cell, k == 0 ? Stipple::Eighth : Stipple::Quarter);
      outline(fine, placed(behind + k), pen(Cell::Black), {4});
      outline(fine, placed(behind + k), pen(cell), {2});
    }
    if (!cutsQ) return;
  }
  if (e.kind != Event::Kind::Paint) tinted(e.P, Cell::P, Stipple::Quarter);
  outline(fine, placed(e.P), pen(Cell::Black), {4});
  outline(fine, placed(e.P), pen(Cell::P), {2});
}

/// Writes words at the top of the picture, or at its foot if they would hide a part of P or Q and the foot is
/// free. Returns their place.
Rect drawWords(SortPen& pen, const std::string& words, const Rect& loupe) {
  constexpr int kInset = 10, kHeight = 14;
  const Rect& at = pen.at.well;
  const auto placeOf = [&](int y) { return Rect{at.x + kInset, at.y + y, textWidth(words), kHeight}; };
  const auto hides = [&](const Rect& place) {
    const bool onLoupe = place.x < loupe.x + loupe.width && loupe.x < place.x + place.width &&
                         place.y < loupe.y + loupe.height && loupe.y < place.y + place.height;
    return onLoupe || std::ranges::any_of(std::array{pen.P(), pen.Q()},
                                          [&](int id) { return id >= 0 && pen.samplesIn(place, id) > 0; });
  };
  const Rect top = placeOf(7), foot = placeOf(at.height - kHeight - 6);
  const Rect place = hides(top) && !hides(foot) ? foot : top;
  pen.paint.haloed(place.x, place.y + 11, words, pen(Cell::WellText), pen(Cell::Well));
  return place;
}

}  // namespace

int SortPen::left() const {
  if (!view.own && !view.theirs)
    return static_cast<int>(run.sorted().fragments.size()) - run.replay().painted();
  return static_cast<int>(run.waiting().size());
}

std::int64_t SortPen::samplesIn(const Rect& units, int id) const {
  const double perUnit = paint.unit() / scale();
  const auto sample = [&](int along, int most) {
    return std::clamp(static_cast<int>(perUnit * along), 0, most);
  };
  const int x = sample(units.x - at.picture.x, size().x), y = sample(units.y - at.picture.y, size().y);
  return samplesWithin(run.scene(), run.sorted(), id,
                       {x, y, sample(units.x + units.width - at.picture.x, size().x) - x,
                        sample(units.y + units.height - at.picture.y, size().y) - y});
}

Rect drawSortPicture(SortPen& pen) {
  const Rect &at = pen.at.picture, samples = at * pen.paint.unit();
  const double scale = pen.scale();
  Painter paint = pen.paint.within(at);
  pen.paint.fillRect(pen.at.well, pen(Cell::Well));
  paint.fit(pen.run.soFar(), at);
  const auto placed = [&](int id) {
    Outline figure = outlineOf(pen.run.fragments().region(id));
    for (Place& p : figure) p = {scale * p.x + samples.x, scale * p.y + samples.y};  // pixels
    return figure;
  };
  const bool outlined = pen.left() > 0 && pen.left() <= kMostWaiting;
  if (outlined) outlineWaiting(paint.pixels(), pen.run.replay(), pen.plan, placed);
  if (pen.view.own) markSpoilt(pen, paint.pixels(), samples, pen.view.own->spoilt);
  Rect loupe;
  if (pen.event) {
    markPair(pen, paint, placed);
    markFalse(pen, paint.pixels(), samples, placed);
    if (pen.view.loupe) loupe = drawLoupe(pen);
  }

  const int painted = pen.run.replay().painted();
  const int all = painted + pen.left();
  const std::string words = painted == all && all > 0 ? "painted: all " + counted(all, "piece")
                            : all == 0
                                ? "nothing to paint"
                                : "painted so far: " + grouped(painted) + " of " + counted(all, "piece") +
                                      (outlined                       ? "; the rest in outline"
                                       : all - painted > kMostWaiting ? "; the rest is too much to outline"
                                                                      : "");
  drawNames(pen, paint, {loupe, drawWords(pen, words, loupe)});
  return loupe;
}

}  // namespace xnewell
