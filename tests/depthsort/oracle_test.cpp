#include "depthsort/oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "geometry/view/screen_plane.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

using Rational = boost::multiprecision::cpp_rational;

/// A number plus infinitely small parts: value + first e + second e^2.
struct Perturbed {
  Rational value, first, second;
  [[nodiscard]] int sign() const {
    for (const Rational* part : {&value, &first, &second})
      if (*part != 0) return *part > 0 ? 1 : -1;
    return 0;
  }
};

/// The second oracle. It computes depths and edges in rational arithmetic, with the sample at (i + 1/2 + e, j
/// + 1/2 + e^2), straight from the vertices. It shares no line with the first.
struct RationalFace {
  std::vector<std::array<Rational, 3>> v;

  explicit RationalFace(const SnappedScene& scene, const SnappedFace& face) {
    for (int k = 0; k < face.count; ++k) {
      const glm::ivec3& p = scene.vertices[face.first + k];
      v.push_back({Rational{p.x, kGrid}, Rational{p.y, kGrid}, Rational{p.z}});
    }
  }
  [[nodiscard]] bool covers(int i, int j) const {
    for (std::size_t k = 0; k < v.size(); ++k) {
      const auto &a = v[k], &b = v[(k + 1) % v.size()];
      const Rational dx = b[0] - a[0], dy = b[1] - a[1];
      const Perturbed side{dy * (Rational{2 * i + 1, 2} - a[0]) - dx * (Rational{2 * j + 1, 2} - a[1]), dy,
                           -dx};
      if (side.sign() < 0) return false;
    }
    return true;
  }
  /// The depth of a triangle at the sample, from its barycentric coordinates.
  [[nodiscard]] Perturbed depth(int i, int j) const {
    const auto &a = v[0], &b = v[1], &c = v[2];
    const auto area = [](const Rational& ux, const Rational& uy, const Rational& vx,
                         const Rational& vy) -> Rational { return ux * vy - uy * vx; };
    const Rational whole = area(b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]);
    const auto at = [&](const Rational& x, const Rational& y) -> Rational {
      const Rational s = area(x - a[0], y - a[1], c[0] - a[0], c[1] - a[1]) / whole;
      const Rational t = area(b[0] - a[0], b[1] - a[1], x - a[0], y - a[1]) / whole;
      return a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
    };
    const Rational x{2 * i + 1, 2}, y{2 * j + 1, 2}, here = at(x, y);
    return {here, at(x + 1, y) - here, at(x, y + 1) - here};
  }
};

int compare(const Perturbed& p, const Perturbed& q) {
  return Perturbed{p.value - q.value, p.first - q.first, p.second - q.second}.sign();
}

}  // namespace

// The oracle agrees with a second one in rational arithmetic in every sample, ties included.
TEST(Oracle, AgreesWithRationalArithmetic) {
  const Seeds seeds{84};
  constexpr int kSize = 12;
  long long contested = 0, ties = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomTriangles(seed, 12, kSize);
    const std::vector<int> seen = visibleFaces(scene, kSize, kSize);
    std::vector<RationalFace> faces;
    for (const SnappedFace& f : scene.faces) faces.emplace_back(scene, f);
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i) {
        int best = kNothing, covering = 0;
        for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
          if (!faces[f].covers(i, j)) continue;
          ++covering;
          const int sign = best == kNothing ? 1 : compare(faces[f].depth(i, j), faces[best].depth(i, j));
          ties += best != kNothing && faces[f].depth(i, j).value == faces[best].depth(i, j).value;
          if (sign >= 0) best = f;
        }
        contested += covering > 1;
        ASSERT_EQ(seen[j * kSize + i], best) << "sample " << i << ", " << j;
      }
  }
  if (!seeds.all()) return;
  EXPECT_GT(contested, 2500);
  EXPECT_GT(ties, 250);
}

// Two faces with the same three corners in place and depth: the later one is seen everywhere.
TEST(Oracle, OfCopiesTheLaterWins) {
  SnappedScene scene = randomScene(SceneKind::BigTriangles, 0, 1, 16);
  scene.faces.push_back(scene.faces[0]);
  scene.faces[1].number = 1;
  int covered = 0;
  for (const int f : visibleFaces(scene, 16, 16)) {
    EXPECT_NE(f, 0);
    covered += f == 1;
  }
  EXPECT_GT(covered, 0);
}

// nearer() is an order: exchanging its arguments changes its sign, and it is 0 for a plane and itself.
TEST(Oracle, NearerIsAntisymmetric) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    const SnappedScene scene = randomTriangles(seed, 2, 8);
    const ScreenPlane &P = scene.planes[0], &Q = scene.planes[1];
    for (int i = 0; i < 8; ++i) {
      ASSERT_EQ(nearer(P, Q, i, i), -nearer(Q, P, i, i)) << seed;
      ASSERT_EQ(nearer(P, P, i, i), 0);
    }
  }
}

// nearer() separates depths that differ far below a double's last bit. The slopes F(n-1)/F(n) of Fibonacci
// numbers up to 2^60 lie on alternating sides of the golden ratio, at a distance of 1/(F(n) F(n+1)) from each
// other (Cassini).
TEST(Oracle, NearerDecidesBeyondDoubles) {
  std::vector<std::int64_t> F{1, 1};
  while (F.size() < 87) F.push_back(F[F.size() - 1] + F[F.size() - 2]);
  EXPECT_GT(F.back(), std::int64_t{1} << 58);
  for (int n = 40; n + 1 < 87; ++n) {
    const ScreenPlane P{F[n - 1], 0, F[n]}, Q{F[n], 0, F[n + 1]};
    EXPECT_EQ(nearer(P, Q, 0, 0), n % 2 ? 1 : -1) << n;
    EXPECT_EQ(nearer(P, Q, 8191, 0), n % 2 ? 1 : -1) << n;
  }
}

// The plane of a face with many corners goes through three of them that are far apart.
TEST(Oracle, PlaneOfManyCorners) {
  SnappedScene scene;
  scene.vertices = {
      {0, 0, 100}, {0, kGrid, 207}, {0, 9 * kGrid, 1000}, {9 * kGrid, 9 * kGrid, 1900}, {9 * kGrid, 0, 1000}};
  const ScreenPlane p = planeThrough(scene.vertices.data(), 5);
  const auto on = [&](int v) {
    const glm::ivec3& q = scene.vertices[v];
    return Int128{p.A} * q.x + Int128{p.B} * q.y + p.D == Int128{p.C} * q.z;
  };
  EXPECT_GT(p.C, 0);
  EXPECT_TRUE(on(0));
  EXPECT_FALSE(on(1));  // bent by 7 steps near the first corner, too near to decide the plane
  EXPECT_TRUE(on(3));
}

}  // namespace xnewell::THIS_FILE
