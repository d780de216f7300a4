#include "geometry/view/stages.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>
#include <string_view>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/model/divide.h"

namespace xnewell::THIS_FILE {

namespace {

enum class Kind { OnAxis, OffAxis, Parallel, Cavalier, Cabinet, OtherAngles };
constexpr std::array<std::string_view, 6> kKinds{
    "perspective", "off-axis perspective", "parallel", "cavalier", "cabinet", "other angles"};

class RandomViews {
 public:
  explicit RandomViews(unsigned seed) : rng_{seed} {}
  double between(double low, double high) { return std::uniform_real_distribution{low, high}(rng_); }
  glm::dvec3 point(double size = 1.0) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

  ViewSpec view(Kind kind) {
    ViewSpec s;
    s.projection = kind <= Kind::OffAxis ? Projection::Perspective : Projection::Parallel;
    s.vrp = point();
    do s.vpn = point(), s.vup = point();
    while (glm::length(glm::cross(unit(s.vpn), unit(s.vup))) < 0.1);
    const glm::dvec2 centre{between(-0.5, 0.5), between(-0.5, 0.5)};
    const glm::dvec2 half{between(0.3, 2.0), between(0.3, 2.0)};
    s.windowMin = centre - half, s.windowMax = centre + half;
    const double D = between(1.5, 6.0);
    glm::dvec2 lean{0.0};
    if (kind == Kind::OffAxis) lean = {between(-1, 1), between(-1, 1)};
    if (kind >= Kind::Cavalier) {
      const SinCos a = sinCosDegrees(kind == Kind::OtherAngles ? between(0, 360) : 45.0);
      const double length = kind == Kind::Cavalier ? 1.0 : kind == Kind::Cabinet ? 0.5 : between(0.1, 2);
      lean = length * glm::dvec2{a.cos, a.sin};
    }
    s.prp = {centre + lean * D, D};
    s.front = D - between(0.1, 1.0);
    s.back = s.front - between(3.0, 8.0);
    return s;
  }

  Mesh triangles(int count) {
    Mesh mesh;
    mesh.groupNames = {""};
    for (int k = 0; k < count; ++k) {
      const int first = static_cast<int>(mesh.points.size());
      for (int c = 0; c < 3; ++c) mesh.points.push_back(point());
      mesh.addFace(std::array{first, first + 1, first + 2}, 0);
    }
    return mesh;
  }

 private:
  std::mt19937 rng_;
};

void expectNear(const glm::dmat4& got, const glm::dmat4& expected, double bound) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      EXPECT_NEAR(got[column][row], expected[column][row], bound) << "row " << row << ", column " << column;
}

/// Rows, as the textbook writes a matrix.
glm::dmat4 rows(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c, const glm::dvec4& d) {
  return glm::transpose(glm::dmat4{a, b, c, d});
}

/// The textbook's house: VRP behind it, the eye 30 in front of that, the window 18 x 18.
ViewSpec house(Projection projection) {
  return {projection, {0, 0, 54}, {0, 0, 1}, {0, 1, 0}, {8, 6, 30}, {-1, -1}, {17, 17}, 1, -23};
}

}  // namespace

// The picture's vertices are those of the stages, to the last bit, for every projection. snap() applies one
// product where the stages apply one matrix after the other. Both are off by some 2^-40 of a step, so they
// may part only at a tie of the snap; in these views none is so near to one.
TEST(Stages, EndInTheProgramsOwnSnappedVertices) {
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    int compared = 0;
    for (unsigned seed = 0; seed < 1'000; ++seed) {
      SCOPED_TRACE(std::string{kKinds[kind]} + ", seed " + std::to_string(seed));
      RandomViews random{seed};
      const ViewSpec view = random.view(static_cast<Kind>(kind));
      const Mesh mesh = random.triangles(12);
      const SnappedScene scene = snap(mesh, divideFaces(mesh), view, 656, 492, Cull::Keep);
      const ViewStages stages{view, 656, 492};
      const double zScale = std::ldexp(1.0, kGridBits - scene.zShift);
      for (std::size_t k = 0; k < scene.vertices.size(); ++k) {
        if (scene.source[k] < 0) continue;  // clipping made it
        const glm::dvec3& place = mesh.points[mesh.corners[scene.source[k]]];
        ASSERT_EQ(stages.outside(place), 0u);
        ASSERT_EQ(snapToGrid(glm::dvec3{stages.at(ViewStage::Viewport, place)}, zScale), scene.vertices[k]);
        ++compared;
      }
    }
    EXPECT_GT(compared, 20'000) << kKinds[kind];
  }
}

// Numbers by hand for the textbook's house in perspective: VRP (0, 0, 54), VPN z, PRP (8, 6, 30), window
// -1..17, F 1, B -23. The direction of projection runs from (8, 6, 30) to the window's middle (8, 8, 0): it
// rises by 2 on 30, so the shear adds z/15 to y. The volume's back is 53 from the eye and its half height
// there is 9 53/30, so S has 30/(9 53), 30/(9 53) and 1/53. zmax = -29/53.
TEST(Stages, TheTextbooksHouseInPerspective) {
  const ViewStages stages{house(Projection::Perspective), 900, 900};
  expectNear(stages.matrix(ViewStage::Vrc), rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -54}, {0, 0, 0, 1}),
             0.0);
  expectNear(stages.matrix(ViewStage::Sheared),
             rows({1, 0, 0, -8}, {0, 1, 1 / 15.0, -6 - 2}, {0, 0, 1, -30}, {0, 0, 0, 1}), 1e-14);
  expectNear(
      stages.matrix(ViewStage::Warped),
      rows({10 / 159.0, 0, 0, 0}, {0, 10 / 159.0, 0, 0}, {0, 0, 1 / 24.0, 29 / 24.0}, {0, 0, -1 / 53.0, 0}),
      1e-15);
  // A corner of the house's front wall, (16, 0, 54): 30 in front of the eye and 8 right of the middle of the
  // window, which is 9 to each side. So x is 8/9, and y is -8/9.
  const glm::dvec3 corner{16, 0, 54};
  EXPECT_EQ(stages.at(ViewStage::Vrc, corner), (glm::dvec4{16, 0, 0, 1}));
  EXPECT_EQ(stages.at(ViewStage::Sheared, corner), (glm::dvec4{8, -8, -30, 1}));
  const glm::dvec4 warped = stages.at(ViewStage::Warped, corner);
  EXPECT_NEAR(warped.w, 30 / 53.0, 1e-15);
  EXPECT_NEAR(warped.x / warped.w, 8 / 9.0, 1e-15);
  EXPECT_NEAR(warped.y / warped.w, -8 / 9.0, 1e-15);
  // At 900 pixels for 18 units the corner is 17 units from the left, and 17 from the top.
  const glm::dvec4 pixels = stages.at(ViewStage::Viewport, corner);
  EXPECT_NEAR(pixels.x, 850, 1e-12);
  EXPECT_NEAR(pixels.y, 850, 1e-12);
  EXPECT_EQ(pixels.w, 1.0);
}

// The same house in a parallel view: the same direction of projection, but the eye stays where it is. T
// brings the middle of the window, (8, 8), at the front plane to the origin; S has 2/18, 2/18 and 1/24.
TEST(Stages, TheTextbooksHouseInParallel) {
  const ViewStages stages{house(Projection::Parallel), 900, 900};
  EXPECT_EQ(stages.letters(ViewStage::Sheared), "SH");
  expectNear(stages.matrix(ViewStage::Sheared),
             rows({1, 0, 0, 0}, {0, 1, 1 / 15.0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}), 1e-15);
  expectNear(
      stages.matrix(ViewStage::Warped),
      rows({1 / 9.0, 0, 0, -8 / 9.0}, {0, 1 / 9.0, 0, -8 / 9.0}, {0, 0, 1 / 24.0, -1 / 24.0}, {0, 0, 0, 1}),
      1e-15);
  expectNear(stages.matrix(ViewStage::Viewport),
             rows({450, 0, 0, 450}, {0, -450, 0, 450}, {0, 0, 1200, 1200}, {0, 0, 0, 1}), 1e-12);
}

// The product so far, times the product from there on, is the whole; and a vertex goes through both.
TEST(Stages, MultiplyToTheScreen) {
  RandomViews random{7};
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const ViewStages stages{random.view(static_cast<Kind>(trial % 6)), 656, 492};
    const glm::dmat4& whole = stages.soFar(ViewStage::Snapped);
    const glm::dvec3 place = random.point();
    for (const ViewStageRow& row : kViewStages) {
      const glm::dmat4 product = stages.toScreen(row.id) * stages.soFar(row.id);
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_NEAR(product[c][r], whole[c][r], 1e-10);
      if (row.id >= ViewStage::Viewport) continue;
      const glm::dvec4 homogeneous = stages.toScreen(row.id) * stages.at(row.id, place);
      const glm::dvec4 pixels = stages.at(ViewStage::Viewport, place);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(homogeneous[k] / homogeneous.w, pixels[k], 1e-7) << row.name;
    }
  }
}

// A plane's normal at a stage is that of the plane through where three of its points go, on the same side.
// The points are far from the place, so the whole plane goes there and not only its neighbourhood.
TEST(Stages, NormalsAreThoseOfTheCarriedPlane) {
  RandomViews random{13};
  int compared = 0;
  for (int trial = 0; trial < 600; ++trial) {
    SCOPED_TRACE(trial);
    const ViewStages stages{random.view(static_cast<Kind>(trial % 6)), 656, 492};
    const std::array<glm::dvec3, 3> p{random.point(), random.point(), random.point()};
    const glm::dvec3 N = unit(glm::cross(p[1] - p[0], p[2] - p[0]));
    if (glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) < 0.1) continue;
    const glm::dvec3 above = p[0] + 0.05 * N;
    if ((stages.outside(p[0]) | stages.outside(p[1]) | stages.outside(p[2]) | stages.outside(above)) & 3u)
      continue;
    for (const ViewStageRow& row : kViewStages) {
      const auto at = [&](const glm::dvec3& place) {
        const glm::dvec4 h = stages.at(row.id, place);
        return glm::dvec3{h} / h.w;
      };
      const glm::dvec3 there = carriedNormal(stages.derivative(row.id, p[0]), N);
      EXPECT_NEAR(glm::length(there), 1.0, 1e-14);
      EXPECT_NEAR(glm::dot(there, unit(at(p[1]) - at(p[0]))), 0.0, 1e-9) << row.name;
      EXPECT_NEAR(glm::dot(there, unit(at(p[2]) - at(p[0]))), 0.0, 1e-9) << row.name;
      EXPECT_GT(glm::dot(there, at(above) - at(p[0])), 0.0) << row.name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1'000);
}

// A turn and a move keep angles; a shear, a warp and a scaling that is not the same in all directions do not.
TEST(Stages, OnlyTurnsAndMovesKeepAngles) {
  RandomViews random{17};
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const Kind kind = static_cast<Kind>(trial % 6);
    ViewSpec view = random.view(kind);
    if (kind == Kind::OnAxis || kind == Kind::Parallel)  // the book's division would round the shear
      view.prp = {(view.windowMin + view.windowMax) / 2.0, view.prp.z};
    const ViewStages stages{view, 656, 492};
    const glm::dvec3 place = view.vrp;
    const auto keeps = [&](ViewStage stage) { return keepsAngles(stages.derivative(stage, place)); };
    EXPECT_TRUE(keeps(ViewStage::World));
    EXPECT_TRUE(keeps(ViewStage::Vrc));
    EXPECT_EQ(keeps(ViewStage::Sheared), kind == Kind::OnAxis || kind == Kind::Parallel);
    EXPECT_FALSE(keeps(ViewStage::Warped));
  }
}

}  // namespace xnewell::THIS_FILE
