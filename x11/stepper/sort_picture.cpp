#include "x11/stepper/sort_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "depthsort/fragment_spans.h"
#include "x11/drawing/wording.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_pen.h"

namespace xnewell {

Fragment fragmentOf(const SnappedScene& scene, const SortedScene& sorted, int id) {
  const int faces = static_cast<int>(scene.faces.size());
  return id < faces ? Fragment{id} : Fragment{sorted.pieces[id - faces].face, id - faces};
}

Samples tintFragment(Painter paint, const Rect& at, glm::ivec2 size, const SnappedScene& scene,
                     const SortedScene& sorted, int id, std::optional<Stipple> tint, std::uint8_t cell) {
  const Rect all = at * paint.unit();
  const double scale = 1.0 * all.width / size.x;
  Painter fine = paint.pixels();
  const auto pixel = [&](std::int64_t sample) {
    return static_cast<int>(scale * static_cast<double>(sample));
  };
  std::int64_t x = 0, y = 0, samples = 0;
  forEachSpan(scene, sorted, fragmentOf(scene, sorted, id), size.x, size.y, [&](int row, int from, int to) {
    samples += to - from, y += std::int64_t{row} * (to - from),
        x += std::int64_t{from + to} * (to - from) / 2;
    if (tint)
      fine.stipple({all.x + pixel(from), all.y + pixel(row), pixel(to) - pixel(from),
                    std::max(1, pixel(row + 1) - pixel(row))},
                   *tint, cell);
  });
  if (samples == 0) return {};
  const int unit = paint.unit();
  return {static_cast<std::int64_t>(scale * scale * static_cast<double>(samples)),
          at.x + pixel(x / samples) / unit, at.y + pixel(y / samples) / unit};
}

std::int64_t samplesWithin(const SnappedScene& scene, const SortedScene& sorted, int id, const Rect& area) {
  std::int64_t samples = 0;
  forEachSpan(scene, sorted, fragmentOf(scene, sorted, id), area.x + area.width, area.y + area.height,
              [&](int row, int from, int to) {
                if (row >= area.y) samples += std::max(0, to - std::max(from, area.x));
              });
  return samples;
}

bool owns(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment, int column,
          int row) {
  bool found = false;
  const SnappedFace& face = scene.faces[fragment.face];
  forEachSpan(&scene.vertices[face.first], face.count, row, column + 1, row + 1,
              [&](int j, int from, int to) {
                Columns columns{from, to};
                if (fragment.piece >= 0)
                  columns = PieceWalk{scene, sorted, sorted.pieces[fragment.piece]}.within(j, columns);
                found |= columns.from <= column && column < columns.to;
              });
  return found;
}

namespace {

// The coordinates of Painter end at 2^24; dashes need lengths below half the range of int.
constexpr double kFarthestDrawn = 1 << 20;

/// Cuts a segment to the part near the image; false if there is none. Liang and Barsky 1984.
bool nearImage(Place& from, Place& to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  double enters = 0.0, leaves = 1.0;
  const auto clip = [&](double slope, double room) {  // slope * t <= room
    if (slope == 0.0) return room >= 0.0;
    const double t = room / slope;
    (slope < 0.0 ? enters : leaves) = slope < 0.0 ? std::max(enters, t) : std::min(leaves, t);
    return enters <= leaves;
  };
  if (!clip(-dx, from.x + kFarthestDrawn) || !clip(dx, kFarthestDrawn - from.x) ||
      !clip(-dy, from.y + kFarthestDrawn) || !clip(dy, kFarthestDrawn - from.y))
    return false;
  const Place start = from;
  if (enters > 0.0) from = {start.x + enters * dx, start.y + enters * dy};
  if (leaves < 1.0) to = {start.x + leaves * dx, start.y + leaves * dy};
  return true;
}

int pixel(double v) { return static_cast<int>(std::floor(v)); }

}  // namespace

Outline outlineOf(const Region& region) {
  Outline figure;
  for (const Side& side : region) figure.push_back({side.corner.x / kGrid, side.corner.y / kGrid});
  return figure;
}

Place middleOf(const Outline& figure) {
  Place middle;
  for (const Place& p : figure) {
    middle.x += p.x / static_cast<double>(figure.size());
    middle.y += p.y / static_cast<double>(figure.size());
  }
  return middle;
}

void segment(Painter& painter, Place from, Place to, std::uint8_t cell, const LineStyle& style) {
  if (!nearImage(from, to)) return;
  painter.line(pixel(from.x), pixel(from.y), pixel(to.x), pixel(to.y), cell, style);
}

void outline(Painter& painter, const Outline& figure, std::uint8_t cell, const LineStyle& style) {
  if (figure.empty()) return;
  Place from = figure.back();
  for (const Place& to : figure) {
    segment(painter, from, to, cell, style);
    from = to;
  }
}

void tint(Painter& painter, const Rect& area, const Outline& figure, Stipple stipple, std::uint8_t cell) {
  for (int j = area.y; j < area.y + area.height; ++j) {
    const double y = j + 0.5;
    double left = kFarthestDrawn, right = -kFarthestDrawn;
    for (std::size_t k = 0; k < figure.size(); ++k) {
      const Place &a = figure[k], &b = figure[k + 1 == figure.size() ? 0 : k + 1];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      left = std::min(left, x), right = std::max(right, x);
    }
    const int from = std::max(area.x, static_cast<int>(std::ceil(std::max(left, -kFarthestDrawn) - 0.5)));
    const int to =
        std::min(area.x + area.width, static_cast<int>(std::ceil(std::min(right, kFarthestDrawn) - 0.5)));
    painter.stipple({from, j, to - from, 1}, stipple, cell);
  }
}

std::optional<Chord> zeroLine(const Outline& figure, const std::vector<double>& values) {
  assert(figure.size() == values.size());
  std::vector<Place> ends;
  for (std::size_t k = 0; k < figure.size() && ends.size() < 2; ++k) {
    const std::size_t next = k + 1 == figure.size() ? 0 : k + 1;
    const double a = values[k], b = values[next];
    if ((a < 0.0) == (b < 0.0)) continue;
    const double t = a / (a - b);
    ends.push_back(
        {figure[k].x + t * (figure[next].x - figure[k].x), figure[k].y + t * (figure[next].y - figure[k].y)});
  }
  if (ends.size() < 2) return std::nullopt;
  return Chord{ends[0], ends[1]};
}

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
