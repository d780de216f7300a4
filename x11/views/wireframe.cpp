#include "x11/views/wireframe.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "depthsort/region.h"
#include "x11/drawing/line_pixels.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// Between two places of the screen grid; at `from` the one that is less.
struct Edge {
  glm::ivec3 from, to;
  int face;  ///< index into SnappedScene::faces
  [[nodiscard]] auto place() const { return std::tuple{from.x, from.y, from.z, to.x, to.y, to.z}; }
};

Edge edgeOf(glm::ivec3 a, glm::ivec3 b, int face) {
  if (std::tuple{b.x, b.y, b.z} < std::tuple{a.x, a.y, a.z}) std::swap(a, b);
  return {a, b, face};
}

/// The edges of all outlines. Polygons that share an edge snap its ends to the same integers.
std::vector<Edge> outlines(const SnappedScene& scene) {
  std::vector<Edge> edges;
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    const SnappedFace& face = scene.faces[f];
    for (int k = 0; k < face.count; ++k)
      edges.push_back(edgeOf(scene.vertices[face.first + k],
                             scene.vertices[face.first + (k + 1) % face.count], static_cast<int>(f)));
  }
  return edges;
}

glm::ivec3 onGrid(const Corner& corner) {
  return {static_cast<int>(std::lround(corner.x)), static_cast<int>(std::lround(corner.y)), 0};
}

void clipTo(const PixelArea& area, const Regions& regions, Region& region) {
  for (const Line& side : {Regions::upright(area.left * kGrid, 1), Regions::upright(area.right * kGrid, -1),
                           Regions::level(area.top * kGrid, 1), Regions::level(area.bottom * kGrid, -1)})
    if (!region.empty()) regions.clip(region, side);
}

/// The sides of painted pieces that cuts have made, once for each piece.
std::vector<Edge> cutSides(const SnappedScene& scene, const SortedScene& sorted) {
  const Regions regions{scene};
  std::vector<Edge> edges;
  Region region;
  for (const Fragment& fragment : sorted.fragments) {
    if (fragment.piece < 0) continue;
    const Piece& piece = sorted.pieces[fragment.piece];
    regions.outline(scene.faces[piece.face], region);
    for (int k = piece.firstCut; k < piece.firstCut + piece.cuts && !region.empty(); ++k)
      regions.clip(region, regions.cut(sorted.cuts[k].over, sorted.cuts[k].under));
    if (sorted.statistics.areas > 0) clipTo(piece.area, regions, region);
    for (std::size_t k = 0; k < region.size(); ++k)
      if (region[k].line.kind == Line::Kind::Cut)
        edges.push_back(edgeOf(onGrid(region[(k + region.size() - 1) % region.size()].corner),
                               onGrid(region[k].corner), piece.face));
  }
  return edges;
}

/// Draws lines where they are visible, or where they are hidden.
class Wires {
 public:
  Wires(IndexImage& image, const Picture& picture)
      : image_{image}, seen_{picture.seen(0, picture.settings().height)} {}

  /// Draws the pixels of a line where one of the edges [begin, end) is visible, or where none is. All these
  /// edges lie in the same place.
  template <class Edges>
  void draw(const Edges& begin, const Edges& end, bool showing, bool dashed, std::uint8_t cell) {
    const auto pixel = [](int v) { return v >> kGridBits; };
    const int x0 = pixel(begin->from.x), y0 = pixel(begin->from.y), x1 = pixel(begin->to.x),
              y1 = pixel(begin->to.y);
    const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
    forEachPixelOfLine({0, 0, image_.width, image_.height}, x0, y0, x1, y1, [&](int, int x, int y) {
      if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
      if (dashed && (steep ? y : x) % kDashPeriod >= kDash) return;
      if (std::any_of(begin, end, [&](const Edge& e) { return showsAt(e.face, x, y); }) == showing)
        image_.row(y)[x] = cell;
    });
  }

 private:
  [[nodiscard]] bool showsAt(int face, int x, int y) const {
    for (int j = std::max(0, y - 1); j <= std::min(image_.height - 1, y + 1); ++j)
      for (int i = std::max(0, x - 1); i <= std::min(image_.width - 1, x + 1); ++i)
        if (seen_.faces[std::size_t(j) * image_.width + i] == face) return true;
    return false;
  }

  IndexImage& image_;
  SeenRows seen_;
};

/// Calls use(begin, end) for all edges that lie in the same place, and returns the number of such places.
template <class Use>
int forEachPlace(std::vector<Edge>& edges, Use&& use) {
  std::ranges::sort(edges, {}, &Edge::place);
  int places = 0;
  for (auto begin = edges.cbegin(); begin != edges.cend(); ++places) {
    const auto end =
        std::find_if(begin, edges.cend(), [&](const Edge& e) { return e.place() != begin->place(); });
    use(begin, end);
    begin = end;
  }
  return places;
}

/// A legend: an example of each kind of line, and what it means.
void drawEdgeLegend(Sheet& sheet, int x, int y) {
  struct EdgeRow {
    Cell cell;
    bool dashed;
    std::string_view name;
  };
  Painter painter = sheet.painter();
  for (const EdgeRow& row : {EdgeRow{Cell::WellText, false, "shows"},
                             EdgeRow{Cell::WellLine, false, "hidden"}, EdgeRow{Cell::White, true, "cut"}}) {
    painter.fillRect({x, y, 36, 13}, sheet.cell(Cell::Well));
    painter.line(x + 3, y + 6, x + 32, y + 6, sheet.cell(row.cell),
                 {.on = kDash, .off = row.dashed ? kDashPeriod - kDash : 0});
    x = painter.text(x + 42, y + Sheet::kAscent - 1, row.name, sheet.cell(Cell::Soft)) + 14;
  }
}

}  // namespace

Finding findingOf(const Wireframe& wires, const Picture& picture) {
  if (wires.polygons == 0) return {"Nothing shows.", ""};
  switch (picture.settings().order) {
    case Order::Oracle:
      return {"Nothing is cut.", "The oracle decides at each sample and does not order polygons."};
    case Order::ZBuffer16:
    case Order::ZBuffer24:
    case Order::ZBuffer32:
      return {"Nothing is cut.", "A z-buffer compares depths at each sample and does not order polygons."};
    case Order::Newell:
    case Order::Bsp:
      break;
    default:
      return {"Nothing is cut.",
              "A sort by one z for each polygon never cuts, even if whole polygons have no right order."};
  }
  if (picture.settings().order == Order::Bsp) {
    if (wires.cuts == 0) return {"Nothing had to be cut.", "No plane of the tree passes through a polygon."};
    return {
        "The BSP tree cut " + (wires.cuts == 1 ? "once" : counted(wires.cuts, "time")) + ".",
        "The plane of a node divides all polygons of its subtree, also those that do not overlap the node "
        "on the screen. Dashed lines show the cuts."};
  }
  if (wires.cuts == 0) return {"Nothing had to be cut.", "Here whole polygons have an exact order."};
  return {"The depth sort cut " + (wires.cuts == 1 ? "once" : counted(wires.cuts, "time")) + ".",
          "Polygons pass through each other or overlap in a cycle, so that no order of whole polygons is "
          "right. Dashed lines show the cuts."};
}

Wireframe wireframeOf(const Picture& picture, const CellPlan& plan) {
  const SnappedScene& scene = picture.snapped();
  Wireframe wires{.image = {picture.settings().width, picture.settings().height, plan[Cell::Well]},
                  .polygons = static_cast<int>(scene.faces.size()),
                  .back = static_cast<int>(std::ranges::count(scene.faces, true, &SnappedFace::back)),
                  .cuts = static_cast<int>(picture.sorted().statistics.splits)};
  Wires draws{wires.image, picture};
  std::vector<Edge> edges = outlines(scene), cuts = cutSides(scene, picture.sorted());
  wires.edges = forEachPlace(
      edges, [&](auto begin, auto end) { draws.draw(begin, end, false, false, plan[Cell::WellLine]); });
  forEachPlace(cuts, [&](auto begin, auto end) { draws.draw(begin, end, false, true, plan[Cell::Soft]); });
  forEachPlace(edges,
               [&](auto begin, auto end) { draws.draw(begin, end, true, false, plan[Cell::WellText]); });
  forEachPlace(cuts, [&](auto begin, auto end) { draws.draw(begin, end, true, true, plan[Cell::White]); });
  return wires;
}

Lens wireframeLens(const Picture& picture, const CellPlan& plan, const Palette& palette) {
  const Wireframe wires = wireframeOf(picture, plan);
  return {.shown = {wires.image, palette},
          .finding = findingOf(wires, picture),
          .section = "edges",
          .rows = {{"polygons", grouped(wires.polygons)},
                   {"seen from behind", grouped(wires.back)},
                   {"edges, each counted once", grouped(wires.edges)},
                   {"cuts", grouped(wires.cuts)},
                   {"polygons and pieces painted",
                    grouped(static_cast<std::int64_t>(picture.sorted().fragments.size()))}},
          .onSheet = [](PictureSheet& page, int y) { drawEdgeLegend(page.sheet, page.left, y); }};
}

}  // namespace xnewell
