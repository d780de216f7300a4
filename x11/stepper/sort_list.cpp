#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

// The side view and the list below it share one z axis, with far at the left.

namespace {

enum class Mark { Painted, P, Q, Marked, Waiting };
struct Row {
  int id;
  Mark mark;
  bool marked = false;  ///< the polygon has a mark, also where the row shows that it is P or Q
};

struct Rows {
  std::vector<Row> shown;
  int more = 0;  ///< more polygons that overlap P in z; without P, more in the list
};

/// What was painted last, and what waits: beside P all that overlaps it in z, or the whole list while the
/// student chooses. As much of it as has room, with P and Q.
Rows rowsOf(const SortPen& pen) {
  const int P = pen.P(), Q = pen.Q();
  const bool own = pen.sorting();
  const Replay& replay = pen.run.replay();
  Rows rows;
  for (int n = std::max(0, replay.painted() - 3); n < replay.painted(); ++n)
    if (const int id = pen.run.paintedId(n); id != P) rows.shown.push_back({id, Mark::Painted});
  while (std::ssize(rows.shown) > std::min(2, pen.at.rows() / 4)) rows.shown.erase(rows.shown.begin());

  if (P >= 0 && !own) rows.shown.push_back({P, Mark::P});

  std::vector<Row> left;
  const Range z = P >= 0 ? pen.run.zExtent(P) : Range{};
  for (const auto& [id, marked] : replay.list(std::numeric_limits<int>::max())) {
    const Mark mark = id == P ? Mark::P : id == Q ? Mark::Q : marked ? Mark::Marked : Mark::Waiting;
    if (id == P && !own)
      rows.shown.back().marked = marked;
    else if (own || P < 0 || mark != Mark::Waiting || pen.run.zExtent(id).overlaps(z))
      left.push_back({id, mark, marked});
  }
  const auto placeOf = [&](Mark mark) {
    return static_cast<int>(std::ranges::find(left, mark, &Row::mark) - left.begin());
  };
  if (Q >= 0 && !own && placeOf(Mark::Q) == std::ssize(left)) left.insert(left.begin(), {Q, Mark::Q});

  const int count = static_cast<int>(left.size()), room = pen.at.rows() - static_cast<int>(rows.shown.size());
  const int p = placeOf(Mark::P), q = placeOf(Mark::Q);
  const int first = std::clamp(own         ? p - room / 3
                               : q < count ? q - room + 1
                                           : 0,
                               0, std::max(0, count - room)),
            last = std::min(count, first + room);
  rows.shown.insert(rows.shown.end(), left.begin() + first, left.begin() + last);
  if (q < first && q < p)
    *(rows.shown.end() - (last - first)) = left[q];
  else if (last <= q && q < count)
    rows.shown.back() = left[q];
  rows.more = count - (last - first);
  return rows;
}

/// Maps a depth to its column.
struct ZAxis {
  Range z;
  int x, width;
  [[nodiscard]] double at(double depth) const { return x + (depth - z.low) / (z.high - z.low) * (width - 1); }
};

Range widened(Range r, double share) {
  const double margin = r.high > r.low ? share * (r.high - r.low) : 1.0;
  return {r.low - margin, r.high + margin};
}

Range united(const Range& a, const Range& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

ZAxis axisOf(const SortPen& pen, const Rows& rows) {
  const Rect& side = pen.at.side;
  Range z;
  if (pen.P() >= 0) {
    z = pen.run.zExtent(pen.P());
    if (pen.Q() >= 0) z = united(z, pen.run.zExtent(pen.Q()));
  } else if (!rows.shown.empty()) {
    z = pen.run.zExtent(rows.shown.front().id);
    for (const Row& row : rows.shown) z = united(z, pen.run.zExtent(row.id));
  }
  return {widened(z, 0.2), side.x, side.width};
}

/// Draws the z-extent of P as a band through side view and list.
void drawBand(SortPen& pen, const ZAxis& axis) {
  if (pen.P() < 0) return;
  const Rect& side = pen.at.side;
  const int bottom = pen.at.list.y + pen.at.list.height;
  const Range z = pen.run.zExtent(pen.P());
  const int from = static_cast<int>(axis.at(z.low)), to = static_cast<int>(axis.at(z.high));
  pen.paint.fillRect({from, pen.at.list.y, to - from + 1, bottom - pen.at.list.y}, pen(Cell::Panel));
  pen.paint.vline(from, side.y, bottom - side.y, pen(Cell::P));
  pen.paint.vline(to, side.y, bottom - side.y, pen(Cell::P));
}

void drawSide(SortPen& pen, const ZAxis& axis, const Rows& rows) {
  const Rect& side = pen.at.side;
  pen.paint.fillRect(side, pen(Cell::White));
  pen.paint.frame(side, pen(Cell::Rule));
  if (pen.P() < 0) return;
  const Explainer& explainer = pen.run.explainer();
  const int P = pen.P(), Q = pen.Q();
  Range x = explainer.xExtent(P), y = explainer.yExtent(P);
  if (Q >= 0) x = united(x, explainer.xExtent(Q)), y = united(y, explainer.yExtent(Q));
  x = widened(x, 0.15);
  const auto place = [&](double depth, double across) {
    return Place{axis.at(depth), side.y + (across - x.low) / (x.high - x.low) * (side.height - 1)};
  };
  const auto figure = [&](int id) {
    Outline corners = outlineOf(pen.run.fragments().region(id));
    for (Place& p : corners) p = place(explainer.depth(id, p), p.x);
    return corners;
  };
  Painter inside = pen.paint.within({side.x + 1, side.y + 1, side.width - 2, side.height - 2});
  for (const Row& row : rows.shown)
    if (row.mark == Mark::Waiting || row.mark == Mark::Marked)
      outline(inside, figure(row.id), pen(row.mark == Mark::Marked ? Cell::Faint : Cell::Rule));

  double middle = (y.low + y.high) / 2;
  if (Q >= 0)
    if (const Outline both = explainer.overlap(P, Q); !both.empty()) middle = middleOf(both).y;
  const auto plane = [&](int id, std::uint8_t cell, const LineStyle& style) {
    segment(inside, place(explainer.depth(id, {x.low, middle}), x.low),
            place(explainer.depth(id, {x.high, middle}), x.high), cell, style);
  };
  plane(P, pen(Cell::P), {});
  if (Q >= 0) plane(Q, pen(Cell::Ink), {1, 5, 4});
  if (Q >= 0) {
    outline(inside, figure(Q), pen(Cell::Ink), {4});
    outline(inside, figure(Q), pen(Cell::Q), {2, 6, 3});
  }
  outline(inside, figure(P), pen(Cell::P), {2});
}

void drawWords(SortPen& pen) {
  const Rect& side = pen.at.side;
  const int x = pen.at.list.x;
  pen.caps(x, side.y + 11, "SIDE VIEW");
  const std::array lines{"x against z;", "lines: the planes", "through the middle", "of the overlap"};
  int y = side.y + (pen.at.compact ? 25 : 30);
  for (const char* const line : lines) {
    if (y > side.y + side.height + 4) break;
    pen.soft(x, y, line);
    y += pen.at.compact ? 13 : 17;
  }
  const int below = side.y + side.height + (pen.at.compact ? 12 : 14);
  // On a paper background, since the band of P passes below.
  const int eye = side.x + side.width - textWidth("near, the eye");
  pen.paint.fillRect({eye - 2, below - 10, textWidth("near, the eye") + 2, 13}, pen(Cell::Paper));
  pen.paint.fillRect({side.x, below - 10, textWidth("far") + 2, 13}, pen(Cell::Paper));
  pen.soft(side.x, below, "far");
  const int right = pen.softRight(side.x + side.width, below, "near, the eye");
  const int z = pen.soft(side.x + 46, below, "z") + 6, tip = right - 22;
  if (tip - 30 > z) {
    pen.paint.hline(z, below - 4, tip - z, pen(Cell::Soft));
    pen.paint.triangle(tip, below - 6, 3, Direction::Right, pen(Cell::Soft));
  }
}

void drawMark(SortPen& pen, const Row& row, int x, int y) {
  const bool badge = row.mark == Mark::P || row.mark == Mark::Q;
  if (row.marked)
    pen.paint.triangle(badge ? x + 15 : x + 5, y - 8, badge ? 3 : 4, Direction::Right, pen(Cell::Ink));
  switch (row.mark) {
    case Mark::Painted:
      return pen.paint.tick(x + 3, y - 8, pen(Cell::Faint));
    case Mark::P:
    case Mark::Q:
      return drawBadge(pen, x, y - 11, row.mark == Mark::P);
    case Mark::Marked:
      return;
    case Mark::Waiting:
      return pen.paint.ring(x + 6, y - 5, 2, pen(Cell::Soft));
  }
}

void drawBar(SortPen& pen, const ZAxis& axis, const Row& row, int y) {
  const Range z = pen.run.zExtent(row.id);
  const double left = pen.at.side.x, right = left + pen.at.side.width;
  const int from = static_cast<int>(std::clamp(axis.at(z.low), left, right - 1));
  const int to = static_cast<int>(std::clamp(axis.at(z.high), left, right - 1));
  const Rect bar{from, y - 8, std::max(1, to - from + 1), 7};
  const Cell cell = row.mark == Mark::P         ? Cell::P
                    : row.mark == Mark::Q       ? Cell::Q
                    : row.mark == Mark::Painted ? Cell::Rule
                                                : Cell::Soft;
  pen.paint.fillRect(bar, pen(cell));
  if (row.mark == Mark::Q) pen.paint.frame(bar, pen(Cell::Ink));
}

void drawRows(SortPen& pen, const ZAxis& axis, const Rows& rows) {
  const Rect& at = pen.at.list;
  int y = at.y + pen.at.line - 4;
  for (int k = 0; k < static_cast<int>(rows.shown.size()); ++k) {
    const Row& row = rows.shown[k];
    const bool pair = row.mark == Mark::P || row.mark == Mark::Q;
    const Rect words{at.x, y - pen.at.line + 4, pen.at.side.x - at.x - 8, pen.at.line};
    if (pair || pen.look(SortPart::Row, k).hovered) pen.paint.fillRect(words, pen(Cell::White));
    drawMark(pen, row, at.x + 2, y);
    const Cell cell = row.mark == Mark::Painted ? Cell::Faint : pair ? Cell::Ink : Cell::Soft;
    const Voice voice = pair ? Voice::Bold : Voice::Plain;
    const std::string number = fitting(pen.run.number(row.id), 54);
    const int end = std::max(at.x + 54, at.x + 20 + textWidth(number));
    pen.paint.textRight(end, y, number, pen(cell), voice);
    pen.paint.text(end + 8, y, fitting(pen.run.part(row.id), words.x + words.width - end - 8), pen(cell));
    drawBar(pen, axis, row, y);
    y += pen.at.line;
  }
  if (rows.more > 0)
    pen.soft(at.x + 18, at.y + at.height + pen.at.line - 4,
             "and " + grouped(rows.more) +
                 (pen.P() >= 0 && !pen.sorting() ? " more that overlap P in z" : " more"));
}

}  // namespace

std::vector<int> drawSidesAndList(SortPen& pen) {
  const Rows rows = rowsOf(pen);
  const ZAxis axis = axisOf(pen, rows);
  drawSide(pen, axis, rows);
  const int heading = pen.at.list.y - (pen.at.compact ? 5 : 9);
  drawBand(pen, axis);
  drawWords(pen);
  pen.caps(pen.at.list.x, heading, "LIST");
  const int mark = pen.at.list.x + 64;
  pen.paint.triangle(mark, heading - 8, 4, Direction::Right, pen(Cell::Soft));
  pen.soft(mark + 10, heading, "marked");
  pen.rule(pen.at.list.x, heading + (pen.at.compact ? 2 : 5), pen.at.list.width);
  drawRows(pen, axis, rows);
  std::vector<int> ids(pen.at.rows(), -1);
  for (std::size_t k = 0; k < rows.shown.size() && k < ids.size(); ++k) ids[k] = rows.shown[k].id;
  return ids;
}

namespace {

constexpr int kMost = 9;  ///< a larger ring leaves out its middle

/// A name on the ring, or in place of several how many these are.
struct RingNode {
  RingLink link;
  std::string name;
  Place at;
  Rect plate;
};

/// Moves a place to the edge of a plate, towards another place.
Place toEdge(const RingNode& node, double dx, double dy) {
  const double x = std::abs(dx) < 1e-9 ? 1e9 : (node.plate.width / 2.0 + 2) / std::abs(dx),
               y = std::abs(dy) < 1e-9 ? 1e9 : (node.plate.height / 2.0 + 2) / std::abs(dy),
               t = std::min(x, y);
  return {node.at.x + t * dx, node.at.y + t * dy};
}

std::vector<RingNode> nodesOf(const SortPen& pen, const std::vector<RingLink>& ring, const Rect& area) {
  std::vector<RingNode> nodes;
  const int count = static_cast<int>(ring.size()), left = count > kMost ? count - kMost + 1 : 0;
  for (int k = 0; k < count; ++k) {
    if (left > 0 && k == kMost / 2) {
      k += left - 1;
      nodes.push_back({{-1, ring[k].by, ring[k].step}, std::to_string(left) + " more", {}, {}});
    } else {
      nodes.push_back({ring[k], pen.run.shortName(ring[k].id), {}, {}});
    }
  }
  int widest = 0;
  for (const RingNode& node : nodes) widest = std::max(widest, textWidth(node.name));
  const double rx = (area.width - widest - 10) / 2.0, ry = (area.height - 15) / 2.0;
  const double from = nodes.size() == 2 ? std::numbers::pi : -std::numbers::pi / 2;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double angle =
        from + 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(nodes.size());
    RingNode& node = nodes[k];
    node.at = {area.x + area.width / 2 + rx * std::cos(angle),
               area.y + area.height / 2 + ry * std::sin(angle)};
    const int width = textWidth(node.name) + 10;
    node.plate = {static_cast<int>(node.at.x) - width / 2, static_cast<int>(node.at.y) - 7, width, 15};
  }
  return nodes;
}

}  // namespace

std::vector<RingPlace> drawRing(SortPen& pen, const std::vector<RingLink>& ring) {
  const Rect& all = pen.at.ring;
  const int heading = pen.caps(all.x, all.y + 10, "CYCLE") + 8;
  pen.soft(heading, all.y + 10, "an arrow: is painted before; its step");
  const Rect area{all.x, all.y + 18, all.width, all.height - 20};
  std::vector<RingNode> nodes = nodesOf(pen, ring, area);
  std::vector<RingPlace> places;
  const auto look = [&] { return pen.look(SortPart::Ring, static_cast<int>(places.size())); };
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const RingNode &from = nodes[k], &to = nodes[(k + 1) % nodes.size()];
    const double length = std::max(1.0, std::hypot(to.at.x - from.at.x, to.at.y - from.at.y)),
                 dx = (to.at.x - from.at.x) / length, dy = (to.at.y - from.at.y) / length;
    const double aside = nodes.size() == 2 ? 10 : 0;  // two arrows between the same names
    Place a = toEdge(from, dx, dy), b = toEdge(to, -dx, -dy);
    for (Place* const p : {&a, &b}) p->x += dy * aside, p->y -= dx * aside;
    const bool open = from.link.by == RingLink::By::Open;
    const std::uint8_t cell = pen(open                                 ? Cell::Alarm
                                  : from.link.by == RingLink::By::Test ? Cell::Ink
                                                                       : Cell::Faint);
    segment(pen.paint, a, b, cell, {1, open ? 2 : 1, open ? 4 : 0});
    for (const double side : {-1.0, 1.0})
      if (!open)
        for (const double wide : {2.0, 3.0})
          segment(pen.paint, b, {b.x - 8 * dx + side * wide * dy, b.y - 8 * dy - side * wide * dx}, cell);
    const std::string words = !open ? (nodes.size() > 5 ? "" : "step ") + std::to_string(from.link.step)
                              : pen.event->kind == Event::Kind::Split ? "cut"
                                                                      : "contact";
    const int width = textWidth(words) + 4;
    // On the arrow, or inside the ring if too little of the arrow would be left.
    const double covered = std::min(width / std::max(1e-9, std::abs(dx)), 14 / std::max(1e-9, std::abs(dy)));
    const double inside = std::hypot(b.x - a.x, b.y - a.y) - covered < 20
                              ? std::abs(dy) * (width / 2.0 + 4) + std::abs(dx) * 10
                              : 0;
    const Rect label{static_cast<int>((a.x + b.x) / 2 - inside * dy) - width / 2,
                     static_cast<int>((a.y + b.y) / 2 + inside * dx) - 7, width, 14};
    pen.paint.fillRect(label, pen(!open && look().hovered ? Cell::Focus : Cell::Paper));
    pen.paint.text(label.x + 2, label.y + 11, words, pen(open ? Cell::Alarm : Cell::Soft));
    if (!open) places.push_back({label, -1, from.link.step});
  }
  for (const RingNode& node : nodes) {
    const bool isP = node.link.id == pen.P(), isQ = node.link.id == pen.Q();
    const bool leads = node.link.id >= 0;
    pen.paint.fillRect(node.plate, pen(isP                       ? Cell::P
                                       : isQ                     ? Cell::Q
                                       : leads && look().hovered ? Cell::Focus
                                                                 : Cell::White));
    pen.paint.frame(node.plate, pen(leads ? Cell::Ink : Cell::Faint));
    pen.paint.text(node.plate.x + 5, node.plate.y + 11, node.name,
                   pen(isP   ? Cell::White
                       : isQ ? Cell::Black
                             : Cell::Ink));
    if (leads) places.push_back({node.plate, node.link.id, 0});
  }
  return places;
}

}  // namespace xnewell
