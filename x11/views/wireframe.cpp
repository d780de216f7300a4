#include "x11/views/wireframe.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "depthsort/oracle.h"
#include "depthsort/region.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/difference.h"

namespace xnewell {

namespace {

constexpr int kBall = 72;     // diameter of the ball
constexpr int kNeedles = 24;  // units from needle to needle
constexpr double kNeedle = 14.0;

/// To 8 bits, the nearest.
void setColor(std::uint8_t* rgb, const glm::dvec3& N) {
  for (int axis = 0; axis < 3; ++axis)
    rgb[axis] =
        static_cast<std::uint8_t>(std::floor(255.0 * std::clamp((N[axis] + 1.0) / 2.0, 0.0, 1.0) + 0.5));
}

/// Calls use(i, j, N) for the samples of the half of a ball that faces the viewer.
template <class Use>
void forEachOfBall(int diameter, Use&& use) {
  for (int j = 0; j < diameter; ++j)
    for (int i = 0; i < diameter; ++i) {
      const double x = (2.0 * i + 1.0) / diameter - 1.0, y = 1.0 - (2.0 * j + 1.0) / diameter;
      if (x * x + y * y < 1.0) use(i, j, glm::dvec3{x, y, std::sqrt(1.0 - x * x - y * y)});
    }
}

/// The normals of a picture in viewing coordinates.
struct SeenNormals {
  RgbImage colors;                  ///< black where no face shows
  std::vector<std::uint8_t> shows;  ///< of each sample: 1 where a face shows
  std::vector<glm::dvec3> needles;  ///< where needles stand, row by row; 0 where no face shows
};

/// The rows below the picture, `below` of them, stay black and show nothing. A large picture is worked on in
/// bands of rows, because a normal takes eight times as much memory as its colour.
SeenNormals seenNormals(const Picture& picture, int below = 0, int unit = 1) {
  constexpr int kMostSamples = 1 << 21;  // of a band
  const int width = picture.settings().width, height = picture.settings().height;
  const int rows = std::max(1, kMostSamples / width), pitch = kNeedles * unit;
  const glm::dmat3 rotation = vrcRotation(picture.camera().view);
  SeenNormals seen{.colors = {width, height + below},
                   .shows = std::vector<std::uint8_t>(std::size_t(width) * (height + below), 0),
                   .needles = {}};
  for (int row = 0; row < height; row += rows) {
    const std::vector<glm::dvec3> N = picture.normals(picture.seen(row, std::min(row + rows, height)));
    const std::size_t first = std::size_t(row) * width;
    for (std::size_t k = 0; k < N.size(); ++k) {
      const glm::dvec3 n = rotation * N[k];
      const bool shows = n != glm::dvec3{0.0};
      if (shows) seen.shows[first + k] = 1, setColor(&seen.colors.rgb[3 * (first + k)], n);
      const int i = static_cast<int>(k % width), j = row + static_cast<int>(k / width);
      if (i % pitch == pitch / 2 && j % pitch == pitch / 2) seen.needles.push_back(n);
    }
  }
  return seen;
}

/// Draws one needle for each cell of the coarse grid whose middle shows a face; a dot if it points at the
/// viewer.
void drawNeedles(Painter painter, const SeenNormals& seen, const Rect& at, std::uint8_t cell) {
  auto n = seen.needles.begin();
  const double length = kNeedle * painter.unit();
  const int pitch = kNeedles * painter.unit();
  painter = painter.pixels();
  for (int j = pitch / 2; j < at.height; j += pitch)
    for (int i = pitch / 2; i < at.width; i += pitch, ++n) {
      if (*n == glm::dvec3{0.0}) continue;
      const int x = at.x + i, y = at.y + j;
      painter.line(x, y, x + static_cast<int>(std::lround(length * n->x)),
                   y - static_cast<int>(std::lround(length * n->y)), cell);
      painter.disc(x, y, 1, cell);
    }
}

std::string wordsFor(const PictureSettings& settings) {
  const std::string which = rowOf(settings.shading).interpolates
                                ? "The normals are interpolated from the vertices over each face and made "
                                  "unit vectors at every pixel. At the vertices they follow the rule " +
                                      std::string{kNormalRules[static_cast<int>(settings.normals)].name} +
                                      ". "
                                : "Each face has one normal, that of its plane. ";
  return which +
         "Red, green and blue are (N + 1) / 2 of x to the right, y up and z towards the viewer. A needle is "
         "N "
         "from its dot, foreshortened as seen.";
}

struct NormalsPlaces {
  std::string words;
  int textLeft, textWidth;
  Rect picture;
};

NormalsPlaces placesOf(const ViewSettings& settings) {
  const int W = settings.picture.width, H = settings.picture.height;
  NormalsPlaces at{.words = wordsFor(settings.picture),
                   .textLeft = Sheet::kMargin + kBall + Sheet::kGutter,
                   .textWidth = 0,
                   .picture = {}};
  at.textWidth = W - at.textLeft - Sheet::kMargin;
  const int strip = std::max(kBall, Sheet::kRow + Sheet::paragraphHeight(at.textWidth, at.words));
  at.picture = {Sheet::kMargin, Sheet::kMargin, W - 2 * Sheet::kMargin,
                H - strip - 2 * Sheet::kMargin - Sheet::kGutter};
  return at;
}

}  // namespace

RgbImage normalColors(const Picture& picture) { return seenNormals(picture).colors; }

ColoredImage normalsImage(const Picture& picture, const CellPlan& plan, const Palette& palette, int unit) {
  const PictureSettings& settings = picture.settings();
  const SeenNormals seen = seenNormals(picture, 0, unit);
  ColoredImage normals = inOwnColors(seen.colors, seen.shows, true, settings, plan, palette);
  drawNeedles({normals.image, unit}, seen, {0, 0, settings.width, settings.height}, plan[Cell::Black]);
  return normals;
}

PictureSettings pictureForNormals(const ViewSettings& settings) {
  const Rect at = placesOf(settings).picture;
  PictureSettings smaller = settings.picture;
  smaller.width = at.width, smaller.height = at.height;
  return smaller;
}

ColoredImage drawNormals(const Picture& picture, const ViewSettings& settings) {
  const std::string heading = "Normals, " + std::string{rowOf(settings.picture.shading).label} + " shading";
  const NormalsPlaces places = placesOf(settings);
  const Rect& at = places.picture;
  const PictureSettings& smaller = picture.settings();

  // The ball's colours are chosen with the picture's: one image above the other.
  const int rows = at.height + kBall;
  SeenNormals seen = seenNormals(picture, kBall);
  forEachOfBall(kBall, [&](int i, int j, const glm::dvec3& n) {
    setColor(seen.colors.pixel(i, at.height + j), n);
    seen.shows[std::size_t(at.height + j) * at.width + i] = 1;
  });
  ColoredImage own = inOwnColors(seen.colors, seen.shows, true, smaller, settings.cells, settings.unneeded);
  IndexImage& cells = own.image;
  for (int j = at.height; j < rows; ++j)
    std::replace(cells.row(j), cells.row(j) + at.width, settings.cells[Cell::Well],
                 settings.cells[Cell::Paper]);

  Sheet sheet{settings.picture.width, settings.picture.height, settings.cells};
  sheet.painter().place(cells, {0, 0, at.width, at.height}, at.x, at.y);
  drawNeedles(sheet.painter().within(at), seen, at, sheet.cell(Cell::Black));
  sheet.painter().frame(at, sheet.cell(Cell::Ink));
  const int top = at.y + at.height + Sheet::kGutter;
  sheet.painter().place(cells, {0, at.height, kBall, kBall}, Sheet::kMargin, top);
  sheet.painter().text(places.textLeft, top + Sheet::kAscent, heading, sheet.cell(Cell::Ink), Voice::Bold);
  sheet.paragraph(places.textLeft, top + Sheet::kRow, places.textWidth, places.words, Cell::Soft);

  return {sheet.image(), withInterface(own.palette, settings.cells)};
}

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
