#include "shading/figure/hiding_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "shading/figure/make_figure.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"

namespace xnewell::THIS_FILE {

constexpr int kWidth = 320, kHeight = 240;

/// The polygons of a figure, hidden ones too.
std::vector<FigurePolygon> polygonsOfScene(const std::string& name) {
  Scene scene = readScene(name);
  PictureSettings settings = scene.settings;
  settings.width = kWidth, settings.height = kHeight, settings.order = Order::Newell;
  const Picture picture = makePicture(std::move(scene), settings, std::uint8_t{0}).withPlanes();
  return polygonsOf(picture.snapped(), figureOrder(picture, Order::Newell), kWidth, kHeight);
}

/// How far a point lies inside of a polygon, in the steps of a figure; negative if it lies outside.
double depthIn(const FigurePolygon& polygon, double x, double y) {
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
    const glm::ivec2 a = polygon.corners[k], b = polygon.corners[(k + 1) % polygon.corners.size()];
    least = std::min(least,
                     ((b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y)) / std::hypot(b.x - a.x, b.y - a.y));
  }
  return least;
}

/// Points of a polygon at random, none nearer to its border than the rounding of corners reaches.
std::vector<glm::dvec2> pointsIn(const FigurePolygon& polygon, std::mt19937& dice) {
  std::vector<glm::dvec2> points;
  std::exponential_distribution<double> share;
  for (int k = 0; k < 40; ++k) {
    glm::dvec2 sum{0.0};
    double all = 0;
    for (const glm::ivec2& v : polygon.corners) {
      const double s = share(dice);
      sum += s * glm::dvec2{v};
      all += s;
    }
    sum = sum / all;
    const bool isOnPage =
        sum.x > 2 && sum.y > 2 && sum.x < kWidth * kFigureSteps - 2 && sum.y < kHeight * kFigureSteps - 2;
    if (isOnPage && depthIn(polygon, sum.x, sum.y) > 3) points.push_back(sum);
  }
  return points;
}

// Each point of a hidden polygon lies in a later one, as a search of all later polygons finds. Nearly all
// polygons whose points all lie in later ones are found to be hidden.
TEST(HidingPolygons, HidesWhatLaterOnesCover) {
  int covered = 0, found = 0;
  for (const char* name : {"teapot", "tori", "crossing-sheets", "shingles", "cubes"}) {
    SCOPED_TRACE(name);
    std::mt19937 dice{43};
    const std::vector<FigurePolygon> all = polygonsOfScene(name);
    const SideTable sides{all};
    HidingPolygons hiding{all, sides, kWidth, kHeight};
    for (int k = 0; k < static_cast<int>(all.size()); ++k) {
      const std::vector<glm::dvec2> points = pointsIn(all[k], dice);
      const auto isCovered = [&](const glm::dvec2& at) {
        return std::any_of(all.begin() + k + 1, all.end(),
                           [&](const FigurePolygon& other) { return depthIn(other, at.x, at.y) > -3; });
      };
      const bool isHidden = hiding.hides(k, 0);
      const bool isAllCovered = std::ranges::all_of(points, isCovered);
      ASSERT_TRUE(isAllCovered || !isHidden) << k;
      if (points.size() < 20 || !isAllCovered) continue;
      ++covered;
      found += isHidden;
    }
  }
  EXPECT_GT(covered, 800);
  EXPECT_GE(found, 0.98 * covered);
}

// A polygon that is hidden with a strip around it is hidden; a strip of the page around it is covered too.
TEST(HidingPolygons, AStripAroundAPolygonIsCovered) {
  int hidden = 0;
  for (const char* name : {"teapot", "tori"}) {
    SCOPED_TRACE(name);
    std::mt19937 dice{44};
    std::uniform_real_distribution<double> beyond{-1.0, 1.0};
    const std::vector<FigurePolygon> all = polygonsOfScene(name);
    const SideTable sides{all};
    HidingPolygons hiding{all, sides, kWidth, kHeight};
    for (int k = 0; k < static_cast<int>(all.size()); ++k) {
      if (!hiding.hides(k, kStrip)) continue;
      ASSERT_TRUE(hiding.hides(k, 0)) << k;
      for (const glm::ivec2& corner : all[k].corners) {
        // Half a strip from a corner is less than a strip from the polygon, and inside of its larger box.
        const double x = corner.x + beyond(dice) * kStrip / 2, y = corner.y + beyond(dice) * kStrip / 2;
        if (depthIn(all[k], x, y) < -0.95 * kStrip || x < 0 || y < 0 || x > kWidth * kFigureSteps ||
            y > kHeight * kFigureSteps)
          continue;
        ASSERT_TRUE(std::any_of(all.begin() + k + 1, all.end(),
                                [&](const FigurePolygon& other) { return depthIn(other, x, y) > -3; }))
            << k << " " << x << " " << y;
        ++hidden;
      }
    }
  }
  EXPECT_GT(hidden, 100);
}

}  // namespace xnewell::THIS_FILE
