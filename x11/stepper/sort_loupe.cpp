#include "x11/stepper/sort_pen.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "x11/stepper/sort_picture.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

namespace {

struct Area {
  double x0, y0, x1, y1;
  [[nodiscard]] double width() const { return x1 - x0; }
  [[nodiscard]] double height() const { return y1 - y0; }
  [[nodiscard]] Place middle() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
};

Area boxOf(const Explainer& explainer, int id) {
  const Range x = explainer.xExtent(id), y = explainer.yExtent(id);
  return {x.low, y.low, x.high, y.high};
}

/// What is enlarged, in pixels of the picture: both polygons. But if the smaller one would vanish beside the
/// larger, the smaller one with as much space around it.
Area focusOf(const SortPen& pen) {
  Area focus = boxOf(pen.run.explainer(), pen.P());
  if (pen.Q() >= 0) {
    constexpr double kVanishes = 6;
    const Area q = boxOf(pen.run.explainer(), pen.Q());
    const auto size = [](const Area& b) { return std::max(b.width(), b.height()); };
    const Area& small = size(q) < size(focus) ? q : focus;
    const Area both{std::min(q.x0, focus.x0), std::min(q.y0, focus.y0), std::max(q.x1, focus.x1),
                    std::max(q.y1, focus.y1)};
    focus = size(both) < kVanishes * size(small) ? both
                                                 : Area{small.x0 - size(small), small.y0 - size(small),
                                                        small.x1 + size(small), small.y1 + size(small)};
  }
  const double W = pen.size().x, H = pen.size().y;
  focus = {std::clamp(focus.x0, 0.0, W), std::clamp(focus.y0, 0.0, H), std::clamp(focus.x1, 0.0, W),
           std::clamp(focus.y1, 0.0, H)};
  const double least = 2.0;  // pixels: limits how much a sliver is enlarged
  const double around = std::max({least, 0.08 * focus.width(), 0.08 * focus.height()});
  return {focus.x0 - around, focus.y0 - around, focus.x1 + around, focus.y1 + around};
}

/// The corner of the picture where the loupe hides least of P and Q. If several are equal, the first in a
/// fixed order, so that the loupe seldom jumps from step to step. If it hides a part of them in all corners,
/// a smaller loupe.
Rect cornerFor(const SortPen& pen) {
  const Rect& picture = pen.at.well;
  constexpr int kInset = 10, kBelowWords = 26, kLeast = 150;
  Rect best;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const int percent : {100, 80, 60})
    for (const bool low : {true, false})
      for (const bool right : {true, false}) {
        const int width = std::max(kLeast, picture.width * 38 * percent / 10'000),
                  height = picture.height * 54 * percent / 10'000;
        const Rect r{picture.x + (right ? picture.width - width - kInset : kInset),
                     picture.y + (low ? picture.height - height - kInset : kBelowWords), width, height};
        std::int64_t hidden = 0;
        for (const int id : {pen.P(), pen.Q()})
          if (id >= 0) hidden += pen.samplesIn(r, id);
        if (hidden >= least) continue;
        least = hidden;
        best = r;
      }
  return best;
}

/// Draws the inside of the loupe.
class Loupe {
 public:
  Loupe(SortPen& pen, const Rect& at, const Area& focus)
      : pen_{pen},
        paint_{pen.paint.within({at.x + 1, at.y + 1, at.width - 2, at.height - 2})},
        at_{at},
        focus_{focus},
        scale_{std::min((at.width - 2 * kAroundLabels) / focus.width(),
                        (at.height - 2 * kAbove) / focus.height())} {}

  /// By enough that it shows more than the part of the picture that it hides.
  [[nodiscard]] bool enlarges() const { return scale_ * paint_.unit() >= 1.5 * pen_.scale(); }

  void draw() {
    const int P = pen_.P(), Q = pen_.Q();
    const bool isCut = pen_.cut >= 0 && !pen_.view.asking;
    if (Q >= 0) tint(paint_, at_, figure(Q), Stipple::Quarter, pen_(Cell::Q));
    tint(paint_, at_, figure(P), Stipple::Quarter, pen_(Cell::P));
    const Outline both = Q >= 0 && !pen_.view.asking ? placed(pen_.run.explainer().overlap(P, Q)) : Outline{};
    tint(paint_, at_, both, Stipple::Diagonals, pen_(Cell::Ink));
    if (Q >= 0) {
      outline(paint_, figure(Q), pen_(Cell::Ink), {4});
      outline(paint_, figure(Q), pen_(Cell::Q), {2, 6, 3});
    }
    outline(paint_, figure(P), pen_(Cell::P), {2});
    const bool distances = Q >= 0 && (pen_.aboutPlanes() || (isCut && !pen_.compare));
    if (distances) drawMeeting(isCut ? figure(pen_.cut) : both, isCut);
    if (pen_.told()) drawApart();
    drawCorners(P, Q, Cell::P, distances);
    if (Q >= 0) drawCorners(Q, P, Cell::Q, distances);
    if (isCut) drawPieces();
    for (const Label& l : wanted_) drawLabel(l);
  }

 private:
  static constexpr int kAroundLabels = 42, kAbove = 22;  // for numbers
  static constexpr double kRoomForLetter = 30;

  [[nodiscard]] Place place(Place p) const {
    const Place m = focus_.middle();
    return {at_.x + at_.width / 2.0 + (p.x - m.x) * scale_, at_.y + at_.height / 2.0 + (p.y - m.y) * scale_};
  }
  [[nodiscard]] Place back(Place p) const {
    const Place m = focus_.middle();
    return {m.x + (p.x - at_.x - at_.width / 2.0) / scale_, m.y + (p.y - at_.y - at_.height / 2.0) / scale_};
  }
  [[nodiscard]] Outline placed(Outline figure) const {
    for (Place& p : figure) p = place(p);
    return figure;
  }
  [[nodiscard]] Outline figure(int id) const { return placed(outlineOf(pen_.run.fragments().region(id))); }

  /// Draws the line where both planes have the same depth: dashed across the loupe, and thick inside both
  /// polygons, or across the one that is cut.
  void drawMeeting(const Outline& inside, bool isCut) {
    const Explainer& explainer = pen_.run.explainer();
    const auto apart = [&](Place p) {
      const Place at = back(p);
      return explainer.depth(pen_.P(), at) - explainer.depth(pen_.Q(), at);
    };
    const auto zeros = [&](const Outline& figure) {
      std::vector<double> values;
      for (const Place& p : figure) values.push_back(apart(p));
      return zeroLine(figure, values);
    };
    const double x0 = at_.x, y0 = at_.y, x1 = x0 + at_.width, y1 = y0 + at_.height;
    const std::uint8_t cell = pen_(Cell::Alarm);
    if (const auto all = zeros({{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}))
      segment(paint_, all->from, all->to, cell, {1, 4, 3});
    const std::optional<Chord> strong = inside.empty() ? std::nullopt : zeros(inside);
    if (!strong) return;
    segment(paint_, strong->from, strong->to, cell, {3});
    for (const Place& end : {strong->from, strong->to}) disc(end, 4, cell);
    const Place middle{(strong->from.x + strong->to.x) / 2, (strong->from.y + strong->to.y) / 2};
    label(middle, {1, 0.3}, isCut ? "cut" : "meet", Cell::Alarm);
  }

  /// Draws what separates the projections: the ends of the gap between extents, or a separating edge.
  void drawApart() {
    const Event& e = *pen_.compare;
    const Explainer& explainer = pen_.run.explainer();
    const std::uint8_t cell = pen_(Cell::Good);
    const auto gap = [](const Range& a, const Range& b) {
      return a.high <= b.low ? Range{a.high, b.low} : Range{b.high, a.low};
    };
    const double far = 1 << 14;
    if (e.test == Test::XExtents) {
      const Range g = gap(explainer.xExtent(e.P), explainer.xExtent(e.Q));
      for (const double x : {g.low, g.high})
        segment(paint_, place({x, -far}), place({x, far}), cell, {1, 4, 3});
    } else if (e.test == Test::YExtents) {
      const Range g = gap(explainer.yExtent(e.P), explainer.yExtent(e.Q));
      for (const double y : {g.low, g.high})
        segment(paint_, place({-far, y}), place({far, y}), cell, {1, 4, 3});
    } else if (e.test == Test::Projections) {
      if (const std::optional<SeparatingEdge> edge = explainer.separatingEdge(e.P, e.Q)) {
        const Place from{edge->fromX, edge->fromY}, to{edge->toX, edge->toY};
        const double length = std::max(1e-9, std::hypot(to.x - from.x, to.y - from.y));
        const double dx = (to.x - from.x) / length * far, dy = (to.y - from.y) / length * far;
        segment(paint_, place({from.x - dx, from.y - dy}), place({from.x + dx, from.y + dy}), cell,
                {1, 4, 3});
      }
    }
  }

  void drawCorners(int of, int other, Cell cell, bool distances) {
    constexpr int kMostNumbers = 5;
    const Outline corners = figure(of);
    const Place middle = middleOf(corners);
    for (const Place& p : corners) disc(p, 4, pen_(cell));
    if (!distances) return;
    const std::vector<CornerDistance> all = pen_.run.explainer().distances(of, other);
    if (all.size() > kMostNumbers) return;
    for (const CornerDistance& corner : all) {
      const Place p = place(corner.at);
      label(p, {p.x - middle.x, p.y - middle.y}, distanceText(corner, pen_.run.scale()),
            cell == Cell::P ? Cell::P : Cell::Ink);
    }
  }

  void drawPieces() {
    const int behind = pen_.run.fragments().pieceOf(pen_.run.replay().splits() - 1);
    for (int k = 0; k < 2; ++k) {
      const Outline piece = figure(behind + k);
      const Place middle = middleOf(piece);
      if (!isInside(middle) || leastSide(piece) < kRoomForLetter) continue;
      const std::string name = pen_.run.shortName(behind + k);
      paint_.haloed(static_cast<int>(middle.x) - textWidth(name) / 2, static_cast<int>(middle.y) + 4, name,
                    pen_(Cell::Ink), pen_(Cell::White));
    }
  }

  /// The shorter side of the box around the figure.
  static double leastSide(const Outline& figure) {
    const auto [x0, x1] = std::ranges::minmax(figure, {}, &Place::x);
    const auto [y0, y1] = std::ranges::minmax(figure, {}, &Place::y);
    return std::min(x1.x - x0.x, y1.y - y0.y);
  }

  void disc(Place p, int radius, std::uint8_t cell) {
    if (!isInside(p)) return;
    const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
    paint_.disc(x, y, radius, cell);
    dots_.push_back({x - radius, y - radius, 2 * radius + 1, 2 * radius + 1});
  }
  [[nodiscard]] bool isInside(Place p) const {
    return p.x >= at_.x && p.x < at_.x + at_.width && p.y >= at_.y && p.y < at_.y + at_.height;
  }

  struct Label {
    Place p, towards;
    std::string text;
    Cell cell;
  };
  /// Keeps a label to be drawn last, over lines and dots.
  void label(Place p, Place towards, std::string text, Cell cell) {
    if (isInside(p)) wanted_.push_back({p, towards, std::move(text), cell});
  }

  /// Draws a label beside its place, on the side it points to, where there is no other label and, if
  /// possible, no dot.
  void drawLabel(const Label& l) {
    const auto& [p, towards, text, cell] = l;
    const int width = textWidth(text), x = static_cast<int>(p.x), y = static_cast<int>(p.y);
    const bool right = towards.x >= 0, low = towards.y >= 0;
    const auto at = [&](bool toRight, bool below, int more) {
      Rect r{toRight ? x + 7 : x - 7 - width, (below ? y + 3 : y - 15) + more, width, 12};
      r.x = std::clamp(r.x, at_.x + 3, std::max(at_.x + 3, at_.x + at_.width - width - 3));
      r.y = std::clamp(r.y, at_.y + 2, at_.y + at_.height - 14);
      return r;
    };
    const std::array tries{at(right, low, 0),
                           at(right, !low, 0),
                           at(!right, low, 0),
                           at(!right, !low, 0),
                           at(right, low, low ? 12 : -12),
                           at(right, !low, low ? -12 : 12),
                           at(!right, low, low ? 12 : -12)};
    const auto keepsOff = [](const std::vector<Rect>& others, const Rect& r) {
      return std::ranges::all_of(others, [&](const Rect& o) { return intersection(o, r).empty(); });
    };
    const auto* const free = std::ranges::find_if(
        tries, [&](const Rect& r) { return keepsOff(labels_, r) && keepsOff(dots_, r); });
    if (free == tries.end()) return;  // a number on a corner could not be told from its neighbour's
    labels_.push_back(*free);
    paint_.haloed(free->x, free->y + 10, text, pen_(cell), pen_(Cell::White));
  }

  SortPen& pen_;
  Painter paint_;
  Rect at_;
  Area focus_;
  double scale_;  ///< units for each pixel of the picture
  std::vector<Label> wanted_;
  std::vector<Rect> labels_, dots_;
};

}  // namespace

Rect drawLoupe(SortPen& pen) {
  const Rect& area = pen.at.well;
  const Area focus = focusOf(pen);
  const Rect at = cornerFor(pen);
  Loupe loupe{pen, at, focus};
  if (!loupe.enlarges()) return {};
  Painter picture = pen.paint.within(area).pixels();
  const int unit = picture.unit(), out = 2 * unit;
  const Rect all = pen.at.picture * unit, loupeAt = at * unit;
  const auto pixel = [&](double samples) { return static_cast<int>(pen.scale() * samples); };
  const Rect focused{all.x + pixel(focus.x0) - out, all.y + pixel(focus.y0) - out,
                     pixel(focus.width()) + 2 * out + 1, pixel(focus.height()) + 2 * out + 1};
  picture.frame(focused, pen(Cell::WellText));
  const bool right = at.x > area.x + area.width / 2, low = at.y + at.height > area.y + area.height - 20;
  picture.line(focused.x + (right ? focused.width : 0), focused.y + (low ? focused.height - 1 : 0),
               right ? loupeAt.x : loupeAt.x + loupeAt.width - 1,
               low ? loupeAt.y + loupeAt.height - 1 : loupeAt.y, pen(Cell::WellText));
  pen.paint.fillRect(at, pen(Cell::White));
  loupe.draw();
  pen.paint.frame(at, pen(Cell::Ink));
  return at;
}

}  // namespace xnewell
