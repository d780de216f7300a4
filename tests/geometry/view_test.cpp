#include "geometry/view/view.h"
#include "geometry/exact/unit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <random>

namespace xnewell::THIS_FILE {

namespace {

glm::dvec3 mapped(const glm::dmat4& m, glm::dvec3 p) {
  const glm::dvec4 h = m * glm::dvec4{p, 1.0};
  return glm::dvec3{h} / h.w;
}

void expectNear(glm::dvec3 got, glm::dvec3 expected, double bound) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], bound) << "coordinate " << k;
}

glm::dmat4 canonicalFromWorld(const ViewSpec& s) { return canonicalFromVrc(s) * vrcFromWorld(s); }

/// VRC axes along the world's axes; window [-1, 3] x [-2, 2], so that its centre is (1, 0).
ViewSpec offCentre(Projection projection, glm::dvec3 prp) {
  return {projection, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, prp, {-1, -2}, {3, 2}, 1, -3};
}

}  // namespace

// For an eye at (0, 0, 5) above the xy plane with y up, u, v, n are x, y, z. An eye on +x with z up sees +y
// to the right.
TEST(View, VrcAxesByHand) {
  ViewSpec s;
  s.vrp = {1, 2, 3};
  expectNear(mapped(vrcFromWorld(s), {2, 4, 6}), {1, 2, 3}, 0.0);
  s.vpn = {2, 0, 0};
  s.vup = {0, 0, 7};
  expectNear(mapped(vrcFromWorld(s), {1, 3, 3}), {1, 0, 0}, 0.0);
  expectNear(mapped(vrcFromWorld(s), {1, 2, 4}), {0, 1, 0}, 0.0);
  expectNear(mapped(vrcFromWorld(s), {4, 2, 3}), {0, 0, 3}, 0.0);
}

// Orthographic: the window's corners are the volume's corners; the front plane is at 0, the back plane at -1.
TEST(View, OrthographicByHand) {
  const ViewSpec s = offCentre(Projection::Parallel, {1, 0, 4});  // PRP is straight above the window's centre
  const glm::dmat4 m = canonicalFromWorld(s);
  expectNear(mapped(m, {-1, -2, 1}), {-1, -1, 0}, 0.0);
  expectNear(mapped(m, {3, 2, -3}), {1, 1, -1}, 0.0);
  expectNear(mapped(m, {1, 1, -1}), {0, 0.5, -0.5}, 0.0);
}

// Cavalier at 45 degrees: a point one unit behind the view plane appears (cos 45, sin 45) further up and
// right, and one unit in front as much down and left. On the view plane nothing moves. Cabinet: half as much.
TEST(View, CavalierAndCabinetByHand) {
  const double c = std::sqrt(0.5);
  for (const double length : {1.0, 0.5}) {
    ViewSpec s =
        offCentre(Projection::Parallel, glm::dvec3{1, 0, 0} + 4.0 * glm::dvec3{length * c, length * c, 1});
    const glm::dmat4 m = canonicalFromWorld(s);
    const double d = length * c / 2;  // half the window is 2 units wide
    expectNear(mapped(m, {1, 0, 0}), {0, 0, -0.25}, 1e-15);
    expectNear(mapped(m, {1, 0, -1}), {d, d, -0.5}, 1e-15);
    expectNear(mapped(m, {1, 0, 1}), {-d, -d, 0}, 1e-15);
  }
}

// Perspective from (1, 0, 4), with the window at distance 4. A point at distance 2 appears twice as far from
// the axis, at distance 7 (the back plane) 4/7 as far. Between the planes z is linear in 1/distance.
TEST(View, PerspectiveByHand) {
  const glm::dmat4 m = canonicalFromWorld(offCentre(Projection::Perspective, {1, 0, 4}));
  expectNear(mapped(m, {3, 2, 0}), {1, 1, (1.0 / 4 - 1.0 / 3) / (1.0 / 3 - 1.0 / 7)}, 1e-15);
  expectNear(mapped(m, {1.5, 1, 1}), {4.0 / 3 * 0.25, 4.0 / 3 * 0.5, 0}, 1e-15);
  expectNear(mapped(m, {1 + 7.0 / 2, 0, -3}), {1, 0, -1}, 1e-15);
}

// An off-axis window shears. An eye left of the window still maps the window to the square.
TEST(View, OffAxisPerspectiveMapsTheWindowToTheSquare) {
  const glm::dmat4 m = canonicalFromWorld(offCentre(Projection::Perspective, {-1, 1, 4}));
  for (const glm::dvec2 corner :
       {glm::dvec2{-1, -1}, glm::dvec2{1, -1}, glm::dvec2{1, 1}, glm::dvec2{-1, 1}}) {
    const glm::dvec3 got = mapped(m, {1 + 2 * corner.x, 2 * corner.y, 0});
    EXPECT_NEAR(got.x, corner.x, 1e-15);
    EXPECT_NEAR(got.y, corner.y, 1e-15);
  }
}

// The matrices agree with GLM's lookAt, perspective and ortho. GLM's z runs from -1 (near) to 1 (far), ours
// from 0 to -1: z_ours = -(z_glm + 1) / 2.
TEST(View, AgreesWithGlm) {
  std::mt19937 rng{1972};
  std::uniform_real_distribution<double> around{-1, 1};
  const auto point = [&] { return glm::dvec3{around(rng), around(rng), around(rng)}; };
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const glm::dvec3 eye = 5.0 * point() + glm::dvec3{0, 0, 6}, at = point(), up{0.1, 1, 0.2};
    const double D = glm::length(eye - at), half = D * std::tan(0.3), aspect = 1.5, near = D / 10,
                 far = 3 * D;
    ViewSpec s{Projection::Perspective, at,       eye - at, up, {0, 0, D}, {-half * aspect, -half},
               {half * aspect, half},   D - near, D - far};
    const glm::dmat4 eyeFromWorld = glm::lookAt(eye, at, up);
    const glm::dmat4 persp = glm::perspective(0.6, aspect, near, far) * eyeFromWorld;
    const glm::dmat4 ortho = glm::ortho(-half * aspect, half * aspect, -half, half, near, far) * eyeFromWorld;
    for (int k = 0; k < 20; ++k) {
      const glm::dvec3 p = at + 0.5 * point();
      for (const bool parallel : {false, true}) {
        s.projection = parallel ? Projection::Parallel : Projection::Perspective;
        glm::dvec3 expected = mapped(parallel ? ortho : persp, p);
        expected.z = -(expected.z + 1) / 2;
        expectNear(mapped(canonicalFromWorld(s), p), expected, 1e-12);
      }
    }
  }
}

// The warp keeps planes: for every projection four points of a plane stay in one plane, relative to the size
// of the tetrahedron's edges.
TEST(View, PlanesStayPlanes) {
  std::mt19937 rng{1975};
  std::uniform_real_distribution<double> around{-1, 1};
  const auto point = [&] { return glm::dvec3{around(rng), around(rng), around(rng)}; };
  for (int trial = 0; trial < 1000; ++trial) {
    SCOPED_TRACE(trial);
    const Projection projection = trial % 2 ? Projection::Perspective : Projection::Parallel;
    const ViewSpec s = offCentre(projection, {around(rng), around(rng), 4});
    const glm::dmat4 m = screenFromCanonical(s, 800, 800) * canonicalFromWorld(s);
    const glm::dvec3 a = point(), b = point(), c = point();
    const glm::dvec3 d = a + around(rng) * (b - a) + around(rng) * (c - a);
    const glm::dvec3 A = mapped(m, a), AB = mapped(m, b) - A, AC = mapped(m, c) - A, AD = mapped(m, d) - A;
    const double volume = glm::dot(glm::cross(AB, AC), AD);
    EXPECT_LE(std::abs(volume), 1e-12 * 800 * 800 * 800);
    // A point off the plane stays off it, so the check can fail.
    const glm::dvec3 off = mapped(m, d + 0.1 * glm::normalize(glm::cross(b - a, c - a))) - A;
    if (glm::length(glm::cross(b - a, c - a)) > 0.3) {
      EXPECT_GT(std::abs(glm::dot(glm::cross(AB, AC), off)), 1e-12 * 800 * 800 * 800);
    }
  }
}

// On the view plane a step towards the viewer counts as many pixels as a step to the right.
TEST(View, ScreenDepthIsIsotropicOnTheViewPlane) {
  for (const Projection projection : {Projection::Parallel, Projection::Perspective}) {
    const ViewSpec s = offCentre(projection, {1, 0, 4});
    const glm::dmat4 m = screenFromCanonical(s, 800, 800) * canonicalFromWorld(s);
    const double h = 1e-6;
    const glm::dvec3 here = mapped(m, {1, 0, 0});
    const double right = (mapped(m, {1 + h, 0, 0}) - here).x, nearer = (mapped(m, {1, 0, h}) - here).z;
    EXPECT_NEAR(right / h, 200.0, 1e-4);
    EXPECT_NEAR(nearer / h, 200.0, 1e-3);  // second derivative 2 * 200 / 4, times h / 2, plus rounding
    EXPECT_NEAR(mapped(m, {1, 0, 1}).z, frontDepth(s, 800), 1e-9);
    EXPECT_NEAR(mapped(m, {1, 0, -3}).z, 0.0, 1e-9);
  }
}

// A camera that cannot see is an error.
TEST(View, RefusesWhatCannotSee) {
  const ViewSpec good = offCentre(Projection::Perspective, {1, 0, 4});
  const auto refuses = [&](auto&& change) {
    ViewSpec s = good;
    change(s);
    EXPECT_THROW((void)canonicalFromWorld(s), ViewError);
  };
  EXPECT_NO_THROW((void)canonicalFromWorld(good));
  refuses([](ViewSpec& s) { s.vpn = {0, 0, 0}; });
  refuses([](ViewSpec& s) { s.vup = {0, 0, 2}; });
  refuses([](ViewSpec& s) { s.windowMax.x = -1; });
  refuses([](ViewSpec& s) { s.prp.z = 0; });
  refuses([](ViewSpec& s) { s.back = 1; });
  refuses([](ViewSpec& s) { s.front = 4; });
}

// unit() returns a vector of length 1 for everything from denormals to the largest doubles.
TEST(View, UnitVectorsAtTheExtremes) {
  for (const double scale : {5e-324, 1e-310, 1e-300, 1.0, 1e300}) {
    const glm::dvec3 u = unit(glm::dvec3{1, 1, 0} * scale);
    EXPECT_NEAR(u.x, std::sqrt(0.5), 1e-15) << scale;
    EXPECT_EQ(u.x, u.y);
  }
  EXPECT_EQ(unit({0, 0, 0}), glm::dvec3(0));
}

// Scaling by a power of two, from 2^-1000 to 2^1000, changes no bit of a unit vector: scaled and unscaled
// arithmetic agree.
TEST(View, UnitVectorsAreTheSameAtEveryScale) {
  std::mt19937 rng{1972};
  const auto coordinate = [&] { return std::uniform_real_distribution{-1.0, 1.0}(rng); };
  for (int k = -1000; k <= 1000; ++k) {
    const glm::dvec3 v{coordinate(), coordinate(), coordinate()};
    const glm::dvec3 scaled{std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
    ASSERT_EQ(unit(scaled), unit(v)) << k;
  }
}

}  // namespace xnewell::THIS_FILE
