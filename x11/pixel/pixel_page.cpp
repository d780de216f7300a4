#include "x11/pixel/pixel_page.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "x11/drawing/wording.h"
#include "x11/pixel/pixel_drawings.h"
#include "x11/pixel/pixel_pen.h"

namespace xnewell {

void PixelPen::verdict() {
  const bool wrong = story().verdict() == "wrong face";
  paint.text(x(), at.column.y + 22, story().verdict(), (*this)(wrong ? Cell::Alarm : Cell::Ink),
             Voice::Title);
  const int beside = x() + textWidth(story().verdict(), Voice::Title) + 16;
  const Explanation* const shown = story().shown();
  y = at.column.y + 12;
  if (!shown) {
    ink(beside, y, "No polygon covers this sample.");
    ink(beside, y + 16, "The background is cell " + std::to_string(story().cell()) + ".");
    return;
  }
  const auto times = static_cast<std::int64_t>(story().history.painted.size());
  ink(beside, y,
      times == 1 ? std::string{"One polygon is at this sample."}
                 : "The " + std::string{story().history.shown + 1 == times ? "last" : "nearest"} + " of " +
                       counted(times, "polygon") + " at this sample shows.");
  if (wrong)
    ink(beside, y + 16, "Face " + faceName(story().picture, story().history.nearest) + " is nearer.");
  else
    ink(beside, y + 16,
        std::string{rowOf(shown->method).label} + ": I " +
            (hides(Predicted::I) ? "?" : intensityWords(story(), *shown)) + ", cell " +
            (hides(Predicted::Cell) ? "?" : std::to_string(story().cell())));
}

void PixelPen::history() {
  section("1 history", "z in pixels of the view plane, larger is nearer");
  const PixelHistory& h = story().history;
  double low = 1e300, high = -1e300;
  for (const PaintedHere& one : h.painted) low = std::min(low, one.z), high = std::max(high, one.z);
  for (const int k : shownRows(static_cast<int>(h.painted.size()), page.chosen, at.rows)) {
    if (k < 0) {
      line("...");
      continue;
    }
    const PaintedHere& one = h.painted[static_cast<std::size_t>(k)];
    places.history.emplace_back(Rect{x() - 4, y - 11, at.column.width + 8, at.pitch - 1}, k);
    if (k == page.chosen)
      paint.fillRect({x() - 4, y - 11, at.column.width + 8, at.pitch - 1}, (*this)(Cell::White));
    const Voice voice = k == page.chosen ? Voice::Bold : Voice::Plain;
    const std::string name = std::to_string(k + 1) + "  " + faceName(story().picture, one.fragment.face) +
                             (one.fragment.piece < 0 ? "" : " (a piece)");
    const int lane = x() + at.column.width * 9 / 20, width = at.column.width / 5;
    paint.text(x(), y, std::string_view{name}.substr(0, static_cast<std::size_t>((lane - x()) / 6)),
               (*this)(Cell::Ink), voice);
    paint.hline(lane, y - 4, width, (*this)(Cell::Rule));
    const double share = high > low ? (one.z - low) / (high - low) : 1.0;
    paint.fillRect({lane + static_cast<int>(share * (width - 6)), y - 7, 6, 7}, (*this)(Cell::Soft));
    paint.textRight(lane + width + 56, y, fixed(one.z, 1), (*this)(Cell::Ink), voice);
    paint.textRight(right(), y, fateOf(story(), static_cast<std::size_t>(k)), (*this)(Cell::Soft), voice);
    y += at.pitch;
  }
  if (h.notPainted > 0)
    line("hidden everywhere: " + std::to_string(h.notPainted) + " more at this sample, not painted");
}

void PixelPen::surface() {
  const SnappedFace& face = story().picture.snapped().faces[e().face];
  section("2 surface", std::string{rowOf(e().method).label} + ", " + (face.back ? "back" : "front") +
                           " side" +
                           (e().vertices.size() == 3 ? ": " + std::string{weightsThatCount(e())} : ""));
  const bool normals = e().method != Shading::Gouraud, weights = e().vertices.size() == 3;
  if (e().vertices.empty())
    line(e().method == Shading::Flat ? "one normal and one place: the centroid of the face"
                                     : std::string{rowOf(e().method).evaluates});
  // Heads, if all that follows has room below them: the vertices and a sum or a texel, an equation of one
  // light, the table, and the names of both.
  constexpr int kAfter = 17;
  const bool heads = hasRoom(1 + std::min(4, static_cast<int>(e().vertices.size())) + kAfter);
  if (!e().vertices.empty() && heads) {
    std::string head = "vertex, x, y";
    head.resize(20, ' ');
    if (weights) head += "screen  world   ";
    soft(x(), y, head + (normals ? "      Nx       Ny       Nz" : "  I"));
    y += at.pitch;
  }
  for (std::size_t k = 0; k < e().vertices.size() && k < 4; ++k) {
    const ExplainedVertex& v = e().vertices[k];
    std::string text =
        std::string{letterOfVertex(static_cast<int>(k))} + "  " + fixed(v.at.x, 1) + ", " + fixed(v.at.y, 1);
    text.resize(20, ' ');
    if (weights) text += number(v.onScreen) + "  " + number(v.inWorld) + "  ";
    if (normals) {
      text += componentsOf(v.N) + (heads ? "" : "  N");
    } else {
      for (int c = 0; c < e().channels; ++c) text += "  " + numberOf(Predicted::I, v.I[c]);
      if (!heads) text += "  I";
    }
    line(text);
  }
  if (e().method == Shading::Phong && e().sum != glm::dvec3{0.0}) {
    std::string text = "weighted sum, length " + number(glm::length(e().sum));
    text.resize(36, ' ');
    line(text + componentsOf(e().sum));
  }
  if (e().texel)
    line("texel: u " + number(e().texel->u) + ", v " + number(e().texel->v) + ", leaves " +
         number(e().texel->share[page.channel]) + " of the diffuse term");
  if (e().place)
    line("place in the map: column " + std::to_string(e().place->column) + ", row " +
         std::to_string(e().place->row));
}

void PixelPen::facts() {
  int row = at.neighbourhood.y + 10;
  const int left = at.facts, end = at.column.x - 16;
  const auto fact = [&](std::string_view name, const std::string& value) {
    soft(left, row, name);
    paint.textRight(end, row, value, (*this)(Cell::Ink), Voice::Bold);
    row += at.pitch;
  };
  fact("pixel", std::to_string(story().i) + ", " + std::to_string(story().j));
  if (const Explanation* const shown = story().shown(); shown && at.pitch > 14) {
    const std::string name = faceName(story().picture, shown->face);
    const std::size_t comma = name.find(", ");
    fact("face", name.substr(0, comma));
    if (comma != std::string::npos) fact("part", beginningOf(name.substr(comma + 2), end - left - 36));
  }
  fact("cell", hides(Predicted::Cell) ? "?" : std::to_string(story().cell()));
  if (story().shown()) fact("I", hides(Predicted::I) ? "?" : intensityWords(story(), *story().shown()));
  if (!page.before || page.asked) return;  // it may be the value that is asked
  fact("before: cell", std::to_string(page.before->cell));
  fact("I", page.before->I);
}

PixelLayout layoutOfPixel(const Layout& at) {
  PixelLayout layout;
  const Rect& body = at.body;
  constexpr int kPixels = 2 * kAround + 1;  // along a side of the neighbourhood
  const int left = at.compact ? 250 : std::max(404, body.width * 2 / 5);
  // A high window has more rows, farther apart, and larger pixels.
  const int spare = std::max(0, body.height - 600);
  layout.pitch = at.compact ? 14 : 16 + std::min(4, spare / 60);
  layout.rows = at.compact ? 3 : 5 + std::min(7, spare / 40);
  const int between = (at.compact ? 30 : 40) + (at.compact ? 48 : 70);  // names, and two controls
  const int least = at.compact ? 8 : 14;
  layout.picture = {body.x, body.y, left, std::min(left * 2 / 3, body.height - between - least * kPixels)};
  constexpr int kFacts = 190;
  const int side =
      std::min((body.height - between - layout.picture.height) / kPixels, (left - kFacts) / kPixels);
  const int around = kPixels * (at.compact ? least : std::max(least, side));
  layout.neighbourhood = {body.x, body.y + layout.picture.height + (at.compact ? 26 : 32), around, around};
  layout.facts = layout.neighbourhood.x + around + 16;
  layout.column = {body.x + left + kMargin, body.y, body.width - left - kMargin, body.height};
  layout.controls = layout.neighbourhood.y + around + (at.compact ? 20 : 30);
  return layout;
}

std::vector<int> shownRows(int count, int chosen, int room) {
  std::vector<int> rows;
  if (count <= room) {
    for (int k = 0; k < count; ++k) rows.push_back(k);
    return rows;
  }
  if (chosen < room - 1) {  // the first ones, and a gap
    for (int k = 0; k < room - 1; ++k) rows.push_back(k);
    rows.push_back(-1);
    return rows;
  }
  // The first, a gap, and the rows around the chosen one.
  const int last = std::min(chosen + (room > 3 ? 1 : 0), count - 1);
  rows = {0, -1};
  for (int k = last - (room - 3); k <= last; ++k) rows.push_back(k);
  return rows;
}

PixelPlaces drawPixelPage(Pen& pen, const PixelLayout& at, const PixelPage& page) {
  PixelPen p{pen, at, page, 0};
  const bool ground = page.story.history.painted.empty();
  drawNeighbourhood(p, at.neighbourhood, page.story, ground ? -1 : p.e().face);
  p.facts();
  p.verdict();
  p.y = at.column.y + 46;
  if (ground) return {};
  p.history();
  p.surface();
  p.equation();
  p.table();
  return p.places;
}

}  // namespace xnewell
