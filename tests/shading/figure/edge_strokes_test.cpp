#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "shading/extremes/rays.h"
#include "shading/figure/edge_strokes.h"
#include "shading/figure/make_figure.h"
#include "shading/figure/side_table.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"
#include "shading/scene/scene_file.h"
#include "tests/support/reader_fixture.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Strokes along edges

Picture pictureOf(const std::string& name) {
  Scene scene = readScene(name);
  PictureSettings settings = scene.settings;
  settings.width = 320, settings.height = 240;
  settings.shading = Shading::Flat, settings.order = Order::Unsorted, settings.colors = ColorPlan::OneHue;
  return makePicture(std::move(scene), settings, std::uint8_t{0}).withPlanes();
}

// Rays in the world find the same points of edges hidden as intervals on the screen. What is nearer to a
// decision than rounding may move it is left open: the rays around the point say different things.
TEST(EdgeStrokes, HideWhatRaysFindHidden) {
  int seen = 0, hidden = 0;
  for (const char* name : {"tori", "crossing-sheets", "penetrate", "coarse-teapot", "cubes"}) {
    SCOPED_TRACE(name);
    const Picture picture = pictureOf(name);
    const SnappedScene& scene = picture.snapped();
    const Mesh& mesh = picture.scene().mesh;
    const HidingFaces faces{scene, 320, 240};
    const Rays rays{picture.scene(), picture.camera(), picture.settings()};
    const glm::dvec3 eye = picture.camera().eye, axis = picture.camera().view.vpn;
    const auto depth = [&](const glm::dvec3& X) { return glm::dot(axis, eye - X); };
    std::mt19937 rng{43};
    for (int n = 0; n < 3'000; ++n) {
      const SnappedFace& face = scene.faces[rng() % scene.faces.size()];
      const int k = static_cast<int>(rng() % static_cast<unsigned>(face.count));
      const int from = face.first + k, to = face.first + (k + 1 == face.count ? 0 : k + 1);
      if (scene.source[from] < 0 || scene.source[to] < 0) continue;
      const glm::dvec3 A = mesh.points[mesh.corners[scene.source[from]]],
                       B = mesh.points[mesh.corners[scene.source[to]]];
      const double t = static_cast<double>(1 + rng() % 998) / 1000.0;
      const double perA = (1 - t) / depth(A), perB = t / depth(B);
      const double far = glm::distance(eye, A + (B - A) * (perB / (perA + perB)));
      const glm::dvec3 a{scene.vertices[from]}, b{scene.vertices[to]}, at = (a + t * (b - a)) / double{kGrid};
      int hiding = 0;
      bool open = false;
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        const double px = at.x + x * 2e-3, py = at.y + y * 2e-3;
        const auto hit = rays.nearest(px, py);
        const double before = hit ? 1 - glm::distance(eye, rays.point(px, py, hit->t)) / far : 0;
        hiding += before > 2e-4, open |= before > 1e-5 && before <= 2e-4;
      }
      if (open || hiding % 4 != 0) continue;
      bool hides = false;
      for (const auto& [begin, end] : faces.hidden(a, b)) hides |= begin <= t && t <= end;
      EXPECT_EQ(hides, hiding == 4) << "face " << face.number << " corner " << k << " at " << t;
      ++(hides ? hidden : seen);
    }
  }
  EXPECT_GT(seen, 2'000);
  EXPECT_GT(hidden, 2'000);
}

// A cube has nine edges in sight and three behind; the diagonals of no side are edges.
TEST(EdgeStrokes, OfACube) {
  Scene scene =
      parseSceneFile(R"({"objects": [{"solid": "cube"}], "camera": {"eye": [3, 4, 5]}})", "cube", ".");
  const PictureSettings settings = setUpOf(scene, 320, 240);
  const Picture picture = makePicture(std::move(scene), settings, std::uint8_t{0}).withPlanes();
  const HidingFaces faces{picture.snapped(), 320, 240};
  const auto strokes = edgeStrokes(picture.snapped(), faces, ModelEdges::All);
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_TRUE(strokes[0].dashed);
  EXPECT_EQ(strokes[0].lines.size(), 3u);
  EXPECT_EQ(strokes[1].lines.size(), 9u);
  EXPECT_EQ(edgeStrokes(picture.snapped(), faces, ModelEdges::Visible).size(), 1u);
  EXPECT_TRUE(edgeStrokes(picture.snapped(), faces, ModelEdges::None).empty());
}

/// The figure of a square in the plane z = 0, seen from the front, with lines and labels.
VectorFigure figureWith(const std::string& marks, ModelEdges edges) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "marked.json",
      R"({"objects": [{"polygons": [[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]]}], "camera": {"eye": [0, 0, 9]}, )" +
          marks + "}");
  Scene scene = readScene(file);
  scene.marks.edges = edges;
  PictureSettings settings = setUpOf(scene, 320, 240);
  settings.order = Order::Newell;
  return FigureStages{scene, settings, kFigureTolerance}.figure();
}

// A line through a face shows in front of it. What is behind is dashed if hidden lines are asked for, and the
// two parts meet where the line passes through.
TEST(MarkStrokes, LinesPassThroughFaces) {
  const std::string lines =
      R"("lines": [{"points": [[0.5, 0, 1], [-0.5, 0, -1]], "color": [0, 0, 1], "width": 2}])";
  const VectorFigure figure = figureWith(lines, ModelEdges::None);
  ASSERT_EQ(figure.strokes.size(), 1u);
  const FigureStroke& seen = figure.strokes[0];
  EXPECT_EQ(seen.color, (FigureColor{0, 0, 255}));
  EXPECT_EQ(seen.width, 2 * kFigureSteps);
  ASSERT_EQ(seen.lines.size(), 1u);
  const glm::ivec2 middle{160 * kFigureSteps, 120 * kFigureSteps};
  EXPECT_GT(seen.lines[0].front().x, middle.x);
  EXPECT_LE(std::abs(seen.lines[0].back().x - middle.x), 1);
  EXPECT_LE(std::abs(seen.lines[0].back().y - middle.y), 1);
  const VectorFigure all = figureWith(lines, ModelEdges::All);
  const auto dashed = std::ranges::find_if(all.strokes, [](const FigureStroke& s) { return s.dashed; });
  ASSERT_NE(dashed, all.strokes.end());
  EXPECT_EQ(dashed->lines[0].front(), seen.lines[0].back());
}

// Faces hide labels by the place where they begin; what lies in a face is not hidden by it.
TEST(MarkStrokes, FacesHideLabels) {
  const VectorFigure figure = figureWith(
      R"("labels": [{"text": "front", "at": [0, 0, 1]}, {"text": "on", "at": [0.5, 0, 0], "size": 20},
                    {"text": "behind", "at": [0, 0, -1]}, {"text": "beside", "at": [1.3, 0, -1]}])",
      ModelEdges::None);
  ASSERT_EQ(figure.texts.size(), 3u);
  EXPECT_EQ(figure.texts[0].text, "front");
  EXPECT_EQ(figure.texts[0].at, (glm::ivec2{160, 120} * kFigureSteps));
  EXPECT_EQ(figure.texts[1].size, 20 * kFigureSteps);
  EXPECT_EQ(figure.texts[2].text, "beside");
}

TEST(MarkStrokes, FilesAreChecked) {
  const auto complaintAbout = [](const std::string& marks) {
    const std::string what = complaint([&] { return figureWith(marks, ModelEdges::None); });
    return what.substr(what.empty() ? 0 : what.find(": ") + 2);
  };
  EXPECT_EQ(complaintAbout(R"("labels": [{"text": "W\u00FCrfel 1", "at": [0, 0, 1]
}])"),
            "");
  EXPECT_EQ(complaintAbout(R"("labels": [{"text": "\u4E2D", "at": [0, 0, 1]}])"),
            "labels[0].text: a label needs characters of Latin-1, Greek or mathematics");
  EXPECT_EQ(complaintAbout(R"("lines": [{"points": [[0, 0, 1]]}])"),
            "lines[0].points: a line needs at least 2 points");
  EXPECT_EQ(complaintAbout(R"("lines": [{"points": [[0, 0, 1], [1, 0, 0]], "width": 0}])"),
            "lines[0].width: a number above 0 is needed");
}

/// ---- Polygons that hide

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

}  // namespace

}  // namespace xnewell::THIS_FILE
