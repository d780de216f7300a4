#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

#include "geometry/exact/plane.h"
#include "geometry/files/obj.h"
#include "geometry/model/edges.h"
#include "geometry/model/solids.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Solids

/// Expects that every edge is run along once in each direction. Then the surface is closed and its faces
/// agree on a side.
void expectClosed(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

/// The volume by the divergence theorem. It is positive if the faces look outward.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
    sum += glm::dot(newellVector(mesh.points, mesh.face(f)), centroid(mesh.points, mesh.face(f)));
  return sum / 6.0;
}

// The solids are closed and look outward, with the known volumes: 8; 4/3 pi and 2 pi^2 r^2 less the deficit
// of the inscribed polygons, which is below (2 pi / n)^2 / 4 for each circle.
TEST(Solids, AreClosedAndFaceOutward) {
  const double pi = 3.141592653589793, deficit = (2 * pi / 60) * (2 * pi / 60) / 2;
  expectClosed(cube());
  EXPECT_EQ(volume(cube()), 8.0);
  const Mesh ball = sphere(60, 60), ring = torus(60, 60);
  EXPECT_EQ(ball.faceCount(), 3600);
  EXPECT_EQ(ring.faceCount(), 3600);
  expectClosed(ball);
  expectClosed(ring);
  expectClosed(sphere(3, 2));
  expectClosed(torus(3, 3));
  EXPECT_NEAR(volume(ball), 4 * pi / 3, 4 * pi / 3 * deficit);
  EXPECT_NEAR(volume(ring), 2 * pi * pi * 0.16, 2 * pi * pi * 0.16 * deficit);
}

// Texture coordinates lie in the unit square. From outside, every face shows its part of the texture
// unmirrored: its texture coordinates run counter-clockwise too. All faces together show the whole texture;
// on the cube each face does.
TEST(Solids, TextureIsSeenFromOutside) {
  const auto areas = [](const Mesh& mesh) {
    std::vector<double> result;
    EXPECT_EQ(mesh.uvOfCorner.size(), mesh.corners.size());
    for (int f = 0; f < mesh.faceCount(); ++f) {
      double area = 0.0;
      const int first = mesh.firstCorner[f], n = static_cast<int>(mesh.face(f).size());
      for (int i = 0; i < n; ++i) {
        const glm::dvec2 a = mesh.uv[mesh.uvOfCorner[first + i]],
                         b = mesh.uv[mesh.uvOfCorner[first + (i + 1) % n]];
        EXPECT_TRUE(0.0 <= a.x && a.x <= 1.0 && 0.0 <= a.y && a.y <= 1.0);
        area += (a.x * b.y - a.y * b.x) / 2.0;
      }
      result.push_back(area);
    }
    return result;
  };
  for (const double area : areas(cube())) EXPECT_EQ(area, 1.0);
  for (const double area : areas(torus(12, 8))) EXPECT_NEAR(area, 1.0 / 96, 0x1p-50);
  const Mesh ball = sphere(12, 8);
  const std::vector<double> ofBall = areas(ball);
  for (int f = 0; f < 96; ++f) EXPECT_NEAR(ofBall[f], (f < 12 || f >= 84 ? 0.5 : 1.0) / 96, 0x1p-50);

  // At the seam the last faces end at u = 1, and the first begin at u = 0. North is up.
  for (std::size_t c = 0; c < ball.corners.size(); ++c) {
    const glm::dvec3 p = ball.points[ball.corners[c]];
    const glm::dvec2 uv = ball.uv[ball.uvOfCorner[c]];
    EXPECT_NEAR(p.z, -std::cos(3.141592653589793 * uv.y), 1e-15);
    if (std::abs(p.z) < 1.0) {
      EXPECT_NEAR(p.x, std::sin(3.141592653589793 * uv.y) * std::cos(6.283185307179586 * uv.x), 1e-15);
    }
  }
  for (int c = 0; c < 3 * 12; c += 3) {
    const auto u = [&](int corner) { return ball.uv[ball.uvOfCorner[corner]].x; };
    EXPECT_NEAR(u(c), (u(c + 1) + u(c + 2)) / 2.0, 1e-15) << "at the pole, the middle of its triangle";
  }
  // The sides of the cube show the texture upright.
  const Mesh box = cube();
  for (int c = 0; c < 16; ++c)
    EXPECT_EQ(box.uv[box.uvOfCorner[c]].y, (box.points[box.corners[c]].z + 1.0) / 2.0);
}

/// ---- Edges

EdgeCounts edgesOf(const std::string& faces) {
  return countEdges(
      parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 -0\nv 3 0 0\n" + faces, "a.obj", "."));
}
void expectEdges(const EdgeCounts& counts, int open, int turned, int crowded) {
  EXPECT_EQ(counts.open, open);
  EXPECT_EQ(counts.turned, turned);
  EXPECT_EQ(counts.crowded, crowded);
}

// A tetrahedron is closed. Without a face it is open, with one face turned its neighbours disagree, and with
// one face twice three edges are crowded. A vertex that is written twice is one place.
TEST(Edges, AreCountedByWhatMeetsThere) {
  const std::string low = "f 1 3 2\n", front = "f 1 2 4\n", left = "f 1 4 3\n", slope = "f 2 3 4\n";
  expectEdges(edgesOf(low + front + left + slope), 0, 0, 0);
  expectEdges(edgesOf(low + front + left + "f 5 3 4\n"), 0, 0, 0);
  expectEdges(edgesOf(low + front + left), 3, 0, 0);
  expectEdges(edgesOf(low + front + left + "f 4 3 2\n"), 0, 3, 0);
  expectEdges(edgesOf(low + front + left + slope + slope), 0, 0, 3);
  expectEdges(edgesOf("f 1 1 1\n"), 0, 0, 0);
  expectEdges(edgesOf("f 1 2 5 3\n"), 3, 0, 0);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
