#include "shading/figure/make_figure.h"

#include <algorithm>
#include <utility>

#include "depthsort/every_face.h"
#include "depthsort/order.h"
#include "shading/figure/side_table.h"

namespace xnewell {

namespace {

/// Gives the polygons their colours.
void color(std::vector<FigurePolygon>& polygons, const Picture& picture, const Palette& palette,
           FigureColors colors) {
  for (FigurePolygon& p : polygons) {
    if (colors == FigureColors::Ids) {
      const std::uint32_t id = static_cast<std::uint32_t>(picture.snapped().faces[p.face].number) + 1;
      for (int c = 0; c < 3; ++c) p.color[c] = static_cast<std::uint8_t>(id >> (16 - 8 * c));
    } else {
      const Rgb16& shade = palette[picture.cells()[p.face]];
      p.color = {static_cast<std::uint8_t>(shade.r >> 8), static_cast<std::uint8_t>(shade.g >> 8),
                 static_cast<std::uint8_t>(shade.b >> 8)};
    }
  }
}

/// The polygons without the hidden ones. The pixels at the border of what hides a polygon may show some of
/// it. So a polygon that is hidden by less than a strip stays, if its surface goes on where it is seen.
std::vector<FigurePolygon> shownOf(std::vector<FigurePolygon> all, int width, int height) {
  std::vector<bool> stays = hiddenIn(all, width, height, 0);
  stays.flip();
  const std::vector<bool> deep = hiddenIn(all, width, height, kStrip);
  {
    constexpr int kMostRounds = 8;  // polygons in a row within a strip
    const SideTable sides{all};
    bool more = true;
    for (int round = 0; more && round < kMostRounds; ++round) {
      more = false;
      for (int k = 0; k < static_cast<int>(all.size()); ++k)
        for (int c = 0; c < static_cast<int>(all[k].corners.size()) && !stays[k] && !deep[k]; ++c) {
          const PolygonSide beyond = sides.beyond({k, c});
          if (beyond.polygon >= 0 && stays[beyond.polygon]) stays[k] = more = true;
        }
    }
  }
  std::vector<FigurePolygon> shown;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (stays[k]) shown.push_back(std::move(all[k]));
  return shown;
}

}  // namespace

SortedScene figureOrder(const Picture& picture, Order order) {
  const PictureSettings& s = picture.settings();
  if (order != Order::Newell) {
    SortedScene sorted;
    for (const int face : paintingOrder(picture.snapped(), order)) sorted.fragments.push_back({face});
    return sorted;
  }
  return sortEveryFace(picture.snapped(), s.width, s.height, s.mostPieces);
}

VectorFigure makeFigure(const Picture& picture, const SortedScene& order, const Palette& palette,
                        FigureColors colors, int strip) {
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
  figure.paths = joinedPaths(std::move(shown), levels, strip, width, height);
  for (const FigurePath& path : figure.paths) {
    statistics.loops += std::ssize(path.loops);
    for (const FigureLoop& loop : path.loops) statistics.corners += std::ssize(loop);
  }
  return figure;
}

}  // namespace xnewell
