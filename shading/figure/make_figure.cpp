#include "shading/figure/make_figure.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "depthsort/depth_sort.h"
#include "depthsort/order.h"
#include "shading/figure/edge_strokes.h"
#include "shading/figure/hiding_polygons.h"
#include "shading/figure/mark_strokes.h"
#include "shading/figure/shades.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

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
