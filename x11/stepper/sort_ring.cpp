#include <algorithm>
#include <cmath>
#include <numbers>

#include "x11/stepper/sort_pen.h"

namespace xnewell {

namespace {

constexpr int kMost = 9;  ///< a larger ring leaves out its middle

/// A name on the ring, or in place of several how many these are.
struct Node {
  RingLink link;
  std::string name;
  Place at;
  Rect plate;
};

/// Moves a place to the edge of a plate, towards another place.
Place toEdge(const Node& node, double dx, double dy) {
  const double x = std::abs(dx) < 1e-9 ? 1e9 : (node.plate.width / 2.0 + 2) / std::abs(dx),
               y = std::abs(dy) < 1e-9 ? 1e9 : (node.plate.height / 2.0 + 2) / std::abs(dy),
               t = std::min(x, y);
  return {node.at.x + t * dx, node.at.y + t * dy};
}

std::vector<Node> nodesOf(const SortPen& pen, const std::vector<RingLink>& ring, const Rect& area) {
  std::vector<Node> nodes;
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
  for (const Node& node : nodes) widest = std::max(widest, textWidth(node.name));
  const double rx = (area.width - widest - 10) / 2.0, ry = (area.height - 15) / 2.0;
  const double from = nodes.size() == 2 ? std::numbers::pi : -std::numbers::pi / 2;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double angle =
        from + 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(nodes.size());
    Node& node = nodes[k];
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
  std::vector<Node> nodes = nodesOf(pen, ring, area);
  std::vector<RingPlace> places;
  const auto look = [&] { return pen.look(SortPart::Ring, static_cast<int>(places.size())); };
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node &from = nodes[k], &to = nodes[(k + 1) % nodes.size()];
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
  for (const Node& node : nodes) {
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
