#include "shading/figure/make_figure.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "depthsort/depth_sort.h"
#include "depthsort/order.h"
#include "geometry/view/clip.h"
#include "shading/figure/edge_strokes.h"
#include "shading/figure/figure.h"
#include "shading/figure/shades.h"
#include "shading/figure/side_table.h"
#include "shading/picture/picture.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

/// ---- Edges, lines and labels

/// Puts places of the world into the snapped scene.
class OnScreen {
 public:
  explicit OnScreen(const Picture& picture)
      : view_{picture.surfaces().view},
        rotation_{vrcRotation(view_)},
        screenFromVrc_{screenFromCanonical(view_, picture.settings().width, picture.settings().height) *
                       canonicalFromVrc(view_)},
        planes_{clipPlanes(frontDepth(view_, picture.settings().width), kMaxPicture)},
        scale_{kGrid, kGrid, std::ldexp(double{kGrid}, -picture.snapped().zShift)} {}

  static constexpr std::size_t kBackPlane = 1;
  /// The part of a line in front of the eye and near the page.
  [[nodiscard]] std::optional<std::pair<glm::dvec3, glm::dvec3>> line(const glm::dvec3& A,
                                                                      const glm::dvec3& B) const {
    const glm::dvec4 a = homogeneous(A), b = homogeneous(B);
    double from = 0, to = 1;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      if (k == kBackPlane) continue;  // it lies right behind the faces unless the user gives it
      const ClipPlane& plane = planes_[k];
      const double atA = glm::dot(plane, a), atB = glm::dot(plane, b);
      if (atA < 0 && atB < 0) return {};
      if (atA < 0) from = std::max(from, atA / (atA - atB));
      if (atB < 0) to = std::min(to, atA / (atA - atB));
    }
    if (from > to) return {};
    return std::pair{snapped(a + from * (b - a)), snapped(a + to * (b - a))};
  }

 private:
  [[nodiscard]] glm::dvec4 homogeneous(const glm::dvec3& p) const {
    return screenFromVrc_ * glm::dvec4{rotation_ * (p - view_.vrp), 1.0};
  }
  [[nodiscard]] glm::dvec3 snapped(const glm::dvec4& p) const { return glm::dvec3{p} / p.w * scale_; }

  ViewSpec view_;
  glm::dmat3 rotation_;
  glm::dmat4 screenFromVrc_;
  std::array<ClipPlane, 6> planes_;
  glm::dvec3 scale_;
};

/// Adds the edges, lines and labels of a scene to the figure of its picture: what faces in front do not hide.
/// With ModelEdges::All, hidden edges and lines are dashed. The picture has planes if the scene has any.
void addMarks(const Picture& picture, VectorFigure& figure) {
  const SceneMarks& marks = picture.scene().marks;
  if (marks.empty()) return;
  const OnScreen screen{picture};
  const HidingFaces faces{picture.snapped(), figure.width, figure.height};
  figure.strokes = edgeStrokes(picture.snapped(), faces, marks.edges);
  for (FigureStroke& stroke : figure.strokes) stroke.color = figureColorOf(marks.edgeColor);
  for (const SceneLine& line : marks.lines) {
    FigureStroke seen{
        figureColorOf(line.color), static_cast<int>(std::lround(line.width * kFigureSteps)), false, {}};
    FigureStroke unseen = seen;
    unseen.dashed = true;
    for (std::size_t k = 1; k < line.points.size(); ++k)
      if (const auto part = screen.line(line.points[k - 1], line.points[k]))
        addLine(faces, part->first, part->second, seen, unseen);
    if (marks.edges == ModelEdges::All && !unseen.lines.empty()) figure.strokes.push_back(std::move(unseen));
    if (!seen.lines.empty()) figure.strokes.push_back(std::move(seen));
  }
  for (const SceneLabel& label : marks.labels) {
    const auto at = screen.line(label.at, label.at);
    if (!at || faces.hides(at->first)) continue;
    const glm::dvec3 steps = at->first * (static_cast<double>(kFigureSteps) / kGrid);
    figure.texts.push_back({{static_cast<int>(std::lround(steps.x)), static_cast<int>(std::lround(steps.y))},
                            figureColorOf(label.color),
                            static_cast<int>(std::lround(label.size * kFigureSteps)),
                            label.text});
  }
}

/// Gives the polygons their colours.
void color(std::vector<FigurePolygon>& polygons, const Picture& picture, const Palette& palette,
           FigureColors colors) {
  for (FigurePolygon& p : polygons) {
    if (colors == FigureColors::Ids) {
      const std::uint32_t id = static_cast<std::uint32_t>(picture.snapped().faces[p.face].number) + 1;
      for (int c = 0; c < 3; ++c) p.color[c] = static_cast<std::uint8_t>(id >> (16 - 8 * c));
    } else if (shadesOver(picture, picture.snapped().faces[p.face]) == ShadesOver::Face) {
      p.color = figureColorOf(palette[picture.cells()[p.face]]);
    }
  }
}

/// The polygons without the hidden ones. The pixels at the border of what hides a polygon may show some of
/// it. So a polygon that is hidden by less than a strip stays, if its surface goes on where it is seen.
std::vector<FigurePolygon> shownOf(std::vector<FigurePolygon> all, int width, int height) {
  const SideTable sides{all};
  HidingPolygons later{all, sides, width, height};
  std::vector<bool> stays(all.size());
  std::vector<int> open;  // stay, and may have such neighbours
  for (int k = 0; k < static_cast<int>(all.size()); ++k) {
    stays[k] = !later.hides(k, 0);
    if (stays[k]) open.push_back(k);
  }
  std::vector<bool> isDeep(all.size());
  while (!open.empty()) {
    const int k = open.back();
    open.pop_back();
    for (int c = 0; c < static_cast<int>(all[k].corners.size()); ++c) {
      const int beyond = sides.beyond({k, c}).polygon;
      if (beyond < 0 || stays[beyond] || isDeep[beyond]) continue;
      (later.hides(beyond, kStrip) ? isDeep : stays)[beyond] = true;
      if (stays[beyond]) open.push_back(beyond);
    }
  }
  std::vector<FigurePolygon> shown;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (stays[k]) shown.push_back(std::move(all[k]));
  return shown;
}

/// Parts of one rank and colour as a path. Where they lie side by side, the nonzero rule makes one area of
/// them.
std::vector<FigurePath> pathsOf(const ShadeParts& parts) {
  std::vector<int> order(parts.polygons.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int k) { return std::pair{parts.levels[k], parts.polygons[k].color}; };
  std::ranges::stable_sort(order, {}, key);
  std::vector<FigurePath> paths;
  for (const int k : order) {
    if (paths.empty() || std::pair{paths.back().level, paths.back().color} != key(k))
      paths.push_back({parts.polygons[k].color, {}, parts.levels[k]});
    paths.back().loops.push_back(parts.polygons[k].corners);
  }
  return paths;
}

}  // namespace

SortedScene figureOrder(const Picture& picture, Order order) {
  const PictureSettings& s = picture.settings();
  if (order != Order::Newell) {
    SortedScene sorted;
    for (const int face : paintingOrder(picture.snapped(), order)) sorted.fragments.push_back({face});
    return sorted;
  }
  // A figure needs some of what is hidden, beside what shows. But where many polygons cross, nearly all
  // pieces are hidden: a spiral of n corners has about n^3.
  constexpr std::int64_t kKeepHidden = 4096;
  try {
    return depthSort(picture.snapped(), {.width = s.width,
                                         .height = s.height,
                                         .samples = false,
                                         .areas = false,
                                         .keepHidden = kKeepHidden,
                                         .mostPieces = s.mostPieces});
  } catch (const TooManyPieces&) {  // its advice, the oracle, makes no figure
    throw TooManyPieces{"the figure needs more than " + std::to_string(s.mostPieces) +
                        " pieces, for the polygons cross too often; --max-fragments allows more, and --order "
                        "zsort needs none but may be wrong"};
  }
}

VectorFigure makeFigure(const Picture& picture, const SortedScene& order, const Palette& palette,
                        FigureColors colors, const ShadeSplit& split, int strip) {
  const int width = picture.settings().width, height = picture.settings().height;
  VectorFigure figure;
  figure.width = width, figure.height = height;
  FigureStatistics& statistics = figure.statistics;
  std::vector<FigurePolygon> all = polygonsOf(picture.snapped(), order, width, height);
  statistics.fragments = std::ssize(order.fragments);
  statistics.outside = statistics.fragments - std::ssize(all);
  std::vector<FigurePolygon> shown = shownOf(std::move(all), width, height);
  statistics.hidden = statistics.fragments - statistics.outside - std::ssize(shown);
  color(shown, picture, palette, colors);
  const std::vector<int> levels = levelsOf(shown, width, height);
  statistics.levels = levels.empty() ? 0 : *std::ranges::max_element(levels) + 1;
  ShadeParts parts;
  if (colors == FigureColors::Shades)
    parts = shadePartsOf(shown, levels, picture, palette, split.samples, split.tolerance, split.smooth);
  statistics.off = parts.off;
  figure.paths = joinedPaths(std::move(shown), levels, strip, width, height);
  std::vector<FigurePath> shades = pathsOf(parts);
  for (FigurePath& path : shades) path.level /= kRanks;
  std::ranges::move(shades, std::back_inserter(figure.paths));
  for (auto& [level, triangles] : parts.smooth) figure.paths.push_back({{}, {}, level, std::move(triangles)});
  std::ranges::stable_sort(figure.paths, {}, &FigurePath::level);
  for (const FigurePath& path : figure.paths) {
    statistics.loops += std::ssize(path.loops) + std::ssize(path.triangles);
    statistics.corners += 3 * std::ssize(path.triangles);
    for (const FigureLoop& loop : path.loops) statistics.corners += std::ssize(loop);
  }
  return figure;
}

namespace {

/// Samples need the order; what has none is painted unsorted, as the figure sorts by itself.
Picture pictureFor(const Scene& scene, PictureSettings settings) {
  const Order order = std::exchange(settings.order, Order::Unsorted);
  const std::uint8_t ground = CellPlan{settings.table.kind}[Cell::Well];
  Picture picture = makePicture(scene, settings, ground).withPlanes();
  if (!needsSamples(picture)) return picture;
  settings.order = order;
  return makePicture(scene, settings, ground).withPlanes();
}

}  // namespace

FigureStages::FigureStages(const Scene& scene, const PictureSettings& settings, int tolerance, bool smooth)
    : picture{pictureFor(scene, settings)},
      samples{needsSamples(picture)},
      order{figureOrder(picture, settings.order)},
      palette{picture.palette(CellPlan{settings.table.kind})},
      split{tolerance, samples ? shownSamples(picture, palette) : ShownSamples{}, smooth} {}

VectorFigure marksOf(const Picture& picture) {
  VectorFigure made;
  made.width = picture.settings().width, made.height = picture.settings().height;
  if (!picture.scene().marks.empty()) addMarks(picture.withPlanes(), made);
  return made;
}

VectorFigure FigureStages::figure(FigureColors colors) const {
  VectorFigure made = makeFigure(picture, order, palette, colors, split);
  if (colors != FigureColors::Ids) addMarks(picture, made);
  return made;
}

}  // namespace xnewell
