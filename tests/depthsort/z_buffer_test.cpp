#include "depthsort/z_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "geometry/view/camera.h"
#include "tests/bench/triangulated.h"
#include "tests/support/exact_region.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

using Integer = boost::multiprecision::cpp_int;

/// A view whose z runs over all the steps that a snapped scene may have: zF is 2^30 steps.
ViewSpec viewOf(int size) {
  ViewSpec view;
  view.projection = Projection::Parallel;
  view.windowMin = glm::dvec2{-size / 2.0}, view.windowMax = glm::dvec2{size / 2.0};
  view.front = 1 << 13, view.back = -(1 << 13);
  return view;
}

/// What the doubles may be off by, in z steps: 2^-48 of the depths, extended to the whole of the box.
Rational roundingOf(const RationalFace& face) {
  const auto& [a, b, c] = face.v;
  const auto extent = [&](int axis) -> Rational {
    return std::max({a[axis], b[axis], c[axis]}) - std::min({a[axis], b[axis], c[axis]});
  };
  const auto area = RationalFace::area;
  const Rational whole = abs(area(b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]));
  const Rational right = abs(area(b[2] - a[2], b[1] - a[1], c[2] - a[2], c[1] - a[1])) / whole;
  const Rational down = abs(area(b[0] - a[0], b[2] - a[2], c[0] - a[0], c[2] - a[2])) / whole;
  const Rational depths = right * extent(0) + down * extent(1) + std::max({a[2], b[2], c[2]});
  return depths / pow(Integer{2}, 48);
}

Integer floorOf(const Rational& r) {
  const Integer n = numerator(r), d = denominator(r);
  return n >= 0 ? Integer{n / d} : Integer{-((-n + d - 1) / d)};
}

Rational quantum(int bits) { return Rational{Integer{1} << 30, (Integer{1} << bits) - 1}; }

/// The judge's level of a depth in steps.
Integer levelOf(const Rational& z, int bits) {
  const Integer last = (Integer{1} << bits) - 1;
  const Integer level = floorOf(Rational{z / quantum(bits)} + Rational{1, 2});
  return std::clamp(level, Integer{0}, last);
}

}  // namespace

// At each sample the face is the last one with the largest level, in rational arithmetic. Where the doubles
// could round to another level, the face may be any that is within a quantum, and the rounding, of the
// nearest; so everywhere the error is at most that.
TEST(ZBuffer, KeepsTheLastFaceOfTheLargestLevel) {
  const Seeds seeds{120};
  constexpr int kSize = 12;
  const ViewSpec view = viewOf(kSize);
  std::array<int, 3> fought{};
  int certain = 0, contested = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    const SnappedScene scene = randomTriangles(seed, 12, kSize);
    std::vector<RationalFace> faces;
    for (const SnappedFace& f : scene.faces) faces.emplace_back(scene, f);
    const std::vector<int> visible = visibleFaces(scene, kSize, kSize);
    for (int which = 0; which < 3; ++which) {
      const int bits = 16 + 8 * which;
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << bits << " bits");
      const ZBuffer buffer = zBuffer(scene, view, bits, kSize, kSize);
      std::int64_t tests = 0;
      for (int j = 0; j < kSize; ++j)
        for (int i = 0; i < kSize; ++i) {
          int best = kNothing, covering = 0;
          Integer largest;
          Rational nearest;
          bool clear = true;
          for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
            if (!faces[f].covers(i, j)) continue;
            const Rational z = faces[f].z(i, j), off = roundingOf(faces[f]);
            const Integer level = levelOf(z, bits);
            clear &= levelOf(z - off, bits) == level && levelOf(z + off, bits) == level;
            if (covering == 0 || z > nearest) nearest = z;
            if (covering++ == 0 || level >= largest) best = f, largest = level;
          }
          tests += covering;
          contested += covering > 1;
          const int shown = buffer.faces[j * kSize + i];
          ASSERT_EQ(shown == kNothing, covering == 0);
          if (covering == 0) continue;
          if (clear) {
            ASSERT_EQ(shown, best) << "sample " << i << ", " << j;
            ++certain;
          }
          const Rational behind = nearest - faces[shown].z(i, j);
          Rational most = quantum(bits) + roundingOf(faces[shown]);
          for (const RationalFace& f : faces)
            if (f.covers(i, j))
              most = std::max<Rational>(most, quantum(bits) + roundingOf(f) + roundingOf(faces[shown]));
          ASSERT_LE(behind, most) << "sample " << i << ", " << j;
          fought[which] += behind > 0;
          // Where all others are farther by more than that, the oracle and the buffer agree.
          bool alone = true;
          for (int f = 0; f < static_cast<int>(faces.size()); ++f)
            alone &=
                f == visible[j * kSize + i] || !faces[f].covers(i, j) || nearest - faces[f].z(i, j) > most;
          if (alone) {
            ASSERT_EQ(shown, visible[j * kSize + i]);
          }
        }
      EXPECT_EQ(buffer.tests, tests);
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(contested, 5'000);
  EXPECT_GT(certain, 10'000);
  // Fewer bits fight more.
  EXPECT_GT(fought[0], 50);
  EXPECT_GT(fought[0], fought[1]);
  EXPECT_GT(fought[1], fought[2]);
}

// Of copies of a face the last is seen. A face on the back plane covers the ground, and one on the front
// plane has the last level of every size: nothing overflows.
TEST(ZBuffer, TiesAndEnds) {
  constexpr int kSize = 8;
  const auto sheet = [](int z) {
    return std::vector<glm::ivec3>{{0, 0, z}, {0, kSize * kGrid, z}, {kSize * kGrid, 0, z}};
  };
  for (const int bits : {16, 24, 32}) {
    SCOPED_TRACE(bits);
    for (const int z : {0, 1, 1 << 29, (1 << 30) - 1, 1 << 30}) {
      SnappedScene scene;
      for (int k = 0; k < 3; ++k) ASSERT_TRUE(addFace(scene, sheet(z)));
      for (const int shown : zBuffer(scene, viewOf(kSize), bits, kSize, kSize).faces)
        EXPECT_TRUE(shown == 2 || shown == kNothing);
      ASSERT_TRUE(addFace(scene, sheet(1 << 30)));
      if (z < (1 << 29) + 1) {
        ASSERT_TRUE(addFace(scene, sheet(z)));
      }
      const ZBuffer buffer = zBuffer(scene, viewOf(kSize), bits, kSize, kSize);
      EXPECT_EQ(std::ranges::count(buffer.faces, 3), kSize * (kSize - 1) / 2);
      EXPECT_EQ(buffer.bytes, kSize * kSize * (bits == 16 ? 2 : 4));
    }
    EXPECT_EQ(zBuffer({}, viewOf(kSize), bits, kSize, kSize).faces,
              std::vector<int>(kSize * kSize, kNothing));
  }
}

// 64,800 triangles in perspective, with the planes of the program and its front plane: the same face as the
// oracle's in 32 bits at nearly every sample, and in 16 bits at fewer. Every run gives the same bits.
TEST(ZBuffer, ManyTriangles) {
  constexpr int kWidth = 800, kHeight = 600;
  const int side = kSanitized ? 40 : 180;
  const Mesh mesh = triangulated(torus(side, side));
  const Camera camera = placeCamera({}, mesh.points, UpAxis::Z, double{kWidth} / kHeight);
  const SnappedScene scene = project(mesh, divideFaces(mesh), camera.view, kWidth, kHeight, Cull::Keep);
  const std::vector<int> visible = visibleFaces(scene, kWidth, kHeight);
  std::array<std::ptrdiff_t, 3> wrong{};
  for (int which = 0; which < 3; ++which) {
    const ZBuffer buffer = zBuffer(scene, camera.view, 16 + 8 * which, kWidth, kHeight);
    for (std::size_t k = 0; k < visible.size(); ++k) {
      ASSERT_EQ(buffer.faces[k] == kNothing, visible[k] == kNothing);
      wrong[which] += buffer.faces[k] != visible[k];
    }
    EXPECT_EQ(buffer.faces, zBuffer(scene, camera.view, 16 + 8 * which, kWidth, kHeight).faces);
    EXPECT_GT(buffer.tests, std::ssize(visible) / 4);
  }
  EXPECT_GE(wrong[0], wrong[1]);
  EXPECT_GE(wrong[1], wrong[2]);
  EXPECT_LE(wrong[2], 1);
}

}  // namespace xnewell::THIS_FILE
