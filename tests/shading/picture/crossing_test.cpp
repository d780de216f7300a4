#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/model_view.h"
#include "tests/support/seeds.h"

namespace xnewell {

namespace {

/// Two tori through each other, as in data/scenes/tori.json.
Mesh crossingTori(int around, int across) {
  Mesh mesh = torus(around, across);
  const Mesh second = torus(around, across);
  const int first = static_cast<int>(mesh.points.size());
  for (const glm::dvec3& p : second.points) mesh.points.push_back(p + glm::dvec3{0.9, 0.1, 0.25});
  for (int f = 0; f < second.faceCount(); ++f) {
    std::vector<int> face;
    for (const int corner : second.face(f)) face.push_back(first + corner);
    mesh.addFace(face, 0);
  }
  return mesh;
}

using Outline = std::vector<glm::dvec3>;

Outline outlineOf(const Mesh& mesh, std::span<const int> corners) {
  Outline outline;
  for (const int corner : corners) outline.push_back(mesh.points[corner]);
  return outline;
}

glm::dvec3 normalOf(const Outline& p) {
  return p.size() == 3 ? glm::cross(p[1] - p[0], p[2] - p[0]) : glm::cross(p[2] - p[0], p[3] - p[1]);
}

/// The part of the line at + t along that lies in the convex polygon whose plane holds it.
std::pair<double, double> within(const Outline& p, glm::dvec3 at, glm::dvec3 along) {
  const glm::dvec3 N = normalOf(p);
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const glm::dvec3 inward = glm::cross(N, p[(k + 1) % p.size()] - p[k]);
    const double height = glm::dot(inward, at - p[k]), rise = glm::dot(inward, along);
    if (rise > 0)
      from = std::max(from, -height / rise);
    else if (rise < 0)
      to = std::min(to, -height / rise);
    else if (height < 0)
      return {0, 0};
  }
  return {from, to};
}

/// The length of the part of the line where the planes meet that lies in both polygons, measured in space,
/// without any view.
double commonLength(const Outline& p, const Outline& q) {
  const glm::dvec3 N = normalOf(p), M = normalOf(q), along = glm::cross(N, M);
  const double square = glm::dot(along, along);
  if (square == 0.0) return 0.0;
  const double n = glm::dot(N, p[0]), m = glm::dot(M, q[0]);
  const glm::dvec3 at = (n * glm::cross(M, along) + m * glm::cross(along, N)) / square;
  const auto [p0, p1] = within(p, at, along);
  const auto [q0, q1] = within(q, at, along);
  return (std::min(p1, q1) - std::max(p0, q0)) * std::sqrt(square);
}

/// The same projection, of the whole scene from one side or another.
CameraSettings wholeScene(const CameraSettings& camera, unsigned seed) {
  CameraSettings whole;
  whole.parallel = camera.parallel;
  whole.oblique = camera.oblique;
  whole.vpn = glm::dvec3{std::cos(seed * 2.0), std::sin(seed * 2.0), std::sin(seed)};
  return whole;
}

}  // namespace

// Crossing tori are split as often as pairs of their faces truly cross, within 3 %. A piece may cross again,
// and faces that cross at no sample are not split. The pairs are counted in space, one by one.
TEST(Crossing, ToriSplitOnceAPair) {
  const Seeds seeds{12};
  for (const int across : {24, 36, 48, 64}) {
    SCOPED_TRACE(across);
    PictureCache pictures{makeScene("tori", crossingTori(2 * across, across), UpAxis::Z)};
    const Mesh& mesh = pictures.scene().mesh;
    const ConvexParts& parts = pictures.scene().parts;
    long crossing = 0, undecided = 0;
    std::vector<Outline> outlines;
    std::vector<std::pair<glm::dvec3, glm::dvec3>> boxes;
    for (int k = 0; k < parts.count(); ++k) {
      outlines.push_back(outlineOf(mesh, parts.part(k)));
      glm::dvec3 low = outlines[k][0], high = low;
      for (const glm::dvec3& p : outlines[k]) low = glm::min(low, p), high = glm::max(high, p);
      boxes.push_back({low, high});
    }
    for (int k = 0; k < parts.count() / 2; ++k)
      for (int i = parts.count() / 2; i < parts.count(); ++i) {
        if (glm::any(glm::lessThan(boxes[k].second, boxes[i].first)) ||
            glm::any(glm::lessThan(boxes[i].second, boxes[k].first)))
          continue;
        const double length = commonLength(outlines[k], outlines[i]);
        crossing += length > 0;
        undecided += std::abs(length) < 1e-9;
      }
    ASSERT_GT(crossing, 200);
    ASSERT_EQ(undecided, 0);  // beyond what doubles can tell
    for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
      SCOPED_TRACE(seed);
      PictureSettings s = randomView(pictures.scene(), seed, 1000, 800);
      s.cull = Cull::Keep;
      s.camera = wholeScene(s.camera, seed);
      pictures.make(s);
      ASSERT_EQ(pictures.last().snapped().faces.size(), parts.face.size());
      EXPECT_NEAR(static_cast<double>(pictures.last().sorted().statistics.splits),
                  static_cast<double>(crossing), 0.03 * static_cast<double>(crossing));
    }
  }
}

}  // namespace xnewell
