#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

#include "geometry/exact/scale.h"
#include "geometry/view/camera.h"
#include "geometry/view/view.h"
#include "tests/support/extended.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Views

glm::dvec3 mapped(const glm::dmat4& m, glm::dvec3 p) {
  const glm::dvec4 h = m * glm::dvec4{p, 1.0};
  return glm::dvec3{h} / h.w;
}

glm::dmat4 canonicalFromWorld(const ViewSpec& s) { return canonicalFromVrc(s) * vrcFromWorld(s); }

/// VRC axes along the world's axes; window [-1, 3] x [-2, 2], so that its centre is (1, 0).
ViewSpec offCentre(Projection projection, glm::dvec3 prp) {
  return {projection, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, prp, {-1, -2}, {3, 2}, 1, -3};
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

/// ---- Cameras

/// The bounding box of the projected points in the canonical square.
struct Reach {
  glm::dvec2 low{2}, high{-2};
};
Reach reach(const Camera& camera, const std::vector<glm::dvec3>& points) {
  const glm::dmat4 m = canonicalFromVrc(camera.view) * vrcFromWorld(camera.view);
  Reach r;
  for (const glm::dvec3& p : points) {
    const glm::dvec4 h = m * glm::dvec4{p, 1};
    EXPECT_GT(h.w, 0);
    EXPECT_TRUE(h.z / h.w <= 0 && h.z / h.w >= -1) << h.z / h.w;
    r.low = glm::min(r.low, glm::dvec2{h} / h.w);
    r.high = glm::max(r.high, glm::dvec2{h} / h.w);
  }
  return r;
}

std::vector<glm::dvec3> cloud(unsigned seed, double scale, glm::dvec3 centre) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> around{-scale, scale};
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 50; ++i)
    points.push_back(centre + glm::dvec3{around(rng), around(rng) / 3, around(rng) / 2});
  return points;
}

// Without camera options the picture shows the whole scene, centred. The tighter side is filled up to the
// margin of 6 %. This holds for perspective, parallel and oblique views, for small scenes and for scenes far
// away.
TEST(Camera, FramesTheSceneWhole) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const auto points =
        cloud(seed, seed % 2 ? 1.0 : 1e-3, seed % 3 ? glm::dvec3{0} : glm::dvec3{0.9, -0.5, 0.3});
    CameraSettings settings;
    settings.fov = 10 + seed;
    settings.parallel = seed % 4 == 1;
    if (seed % 4 == 2) settings.oblique = Oblique{0.5, 30};
    const Reach r = reach(placeCamera(settings, points, seed % 2 ? UpAxis::Y : UpAxis::Z, 4.0 / 3), points);
    EXPECT_NEAR(r.low.x, -r.high.x, 0.01);
    EXPECT_NEAR(r.low.y, -r.high.y, 0.01);
    EXPECT_NEAR(std::max(r.high.x, r.high.y), 0.94, 1e-9);
    EXPECT_NEAR(std::min(r.low.x, r.low.y), -0.94, 1e-9);
  }
}

// A scene that is one point, or a line that the eye looks along, has a camera too: the middle of the picture
// shows it.
TEST(Camera, FramesASceneWithoutAWidth) {
  const glm::dvec3 along{0.22, 0.52, 1.0};  // as the eye looks at a scene without options
  for (const std::vector<glm::dvec3>& points :
       {std::vector<glm::dvec3>(3, glm::dvec3{0.0}), std::vector<glm::dvec3>(3, glm::dvec3{3, 4, 5}),
        std::vector<glm::dvec3>{along, glm::dvec3{0.0}, 2.0 * along}}) {
    const Reach r = reach(placeCamera({}, points, UpAxis::Y, 4.0 / 3), points);
    for (const glm::dvec2& end : {r.low, r.high}) {
      EXPECT_NEAR(end.x, 0.0, 1e-9);
      EXPECT_NEAR(end.y, 0.0, 1e-9);
    }
  }
}

// Given settings are used as they are: the eye, the look-at point, the up vector, the angle.
TEST(Camera, TakesWhatWasSaid) {
  CameraSettings s;
  s.eye = glm::dvec3{3, 4, 5};
  s.lookAt = glm::dvec3{1, 0, 0};
  s.up = glm::dvec3{0, 0, 1};
  s.fov = 90;
  const auto points = cloud(1, 1, {0, 0, 0});
  const Camera c = placeCamera(s, points, UpAxis::Y, 2.0);
  EXPECT_EQ(c.eye, *s.eye);
  EXPECT_EQ(c.lookAt, *s.lookAt);
  const double D = std::sqrt(4 + 16 + 25.0);
  EXPECT_NEAR(c.view.prp.z, D, 1e-14);
  EXPECT_NEAR(c.view.windowMax.y, D, 1e-13);  // tan 45 = 1
  EXPECT_NEAR(c.view.windowMax.x, 2 * D, 1e-13);
}

// The textbook's specification is used unchanged. The eye that shading sees is PRP in world coordinates.
TEST(Camera, TextbookSpecification) {
  CameraSettings s;
  s.vrp = glm::dvec3{16, 0, 54};
  s.vpn = glm::dvec3{1, 0, 1};
  s.vup = glm::dvec3{0, 1, 0};
  s.prp = glm::dvec3{0, 25, 20 * std::sqrt(2.0)};
  s.window = glm::dvec4{-20, 20, -5, 35};
  s.front = 1;
  s.back = -30;
  const auto points = cloud(2, 1, {16, 10, 50});
  const Camera c = placeCamera(s, points, UpAxis::Y, 1.0);
  EXPECT_EQ(c.view.front, 1);
  EXPECT_EQ(c.view.back, -30);
  EXPECT_EQ(c.view.windowMin, glm::dvec2(-20, -5));
  EXPECT_NEAR(glm::length(c.eye - glm::dvec3{36, 25, 74}), 0, 1e-12);
}

// A line of one unit along n is drawn `length` long at `angle`, wherever the window is, whether the eye or
// PRP is given or not. A parallel view without either is upright.
TEST(Camera, ObliqueLeansAsItSaysInEveryWindow) {
  const auto points = cloud(5, 1, {0.2, 0.1, 0});
  for (const glm::dvec4& window : {glm::dvec4{0, 8, 0, 6}, {1, 5, -1.5, 1.5}, {-9, -1, 2, 8}, {-4, 4, -3, 3}})
    for (const Oblique& lean : {Oblique{1, 135}, Oblique{0.5, 30}, Oblique{0, 0}})
      for (const int given : {0, 1, 2, 3}) {
        SCOPED_TRACE(std::to_string(window.x) + ' ' + std::to_string(lean.angle) + ' ' +
                     std::to_string(given));
        CameraSettings s;
        s.window = window;
        s.parallel = true;
        if (lean.length > 0 || given != 0) s.oblique = lean;
        if ((given & 1) != 0) s.eye = glm::dvec3{3, 2, 6};
        if ((given & 2) != 0) s.prp = glm::dvec3{3, -2, 7};
        const ViewSpec view = placeCamera(s, points, UpAxis::Y, 4.0 / 3).view;
        const glm::dmat4 M = screenFromCanonical(view, 800, 600) * canonicalFromVrc(view);
        const glm::dvec2 drawn{M * glm::dvec4{0, 0, 1, 0}};
        const double angle = lean.angle * std::acos(-1.0) / 180, unit = 800 / (window.y - window.x);
        EXPECT_NEAR(drawn.x, -unit * lean.length * std::cos(angle), 1e-9);
        EXPECT_NEAR(drawn.y, unit * lean.length * std::sin(angle), 1e-9);
      }
}

// Oblique views do not move the eye. So V, and with it the specular term, is that of the upright view.
TEST(Camera, ObliqueKeepsTheEye) {
  const auto points = cloud(3, 1, {0, 0, 0});
  CameraSettings s;
  s.eye = glm::dvec3{1, 2, 6};
  s.height = 3;
  s.parallel = true;
  const Camera upright = placeCamera(s, points, UpAxis::Y, 1.5);
  s.oblique = Oblique{1.0, 45};
  const Camera oblique = placeCamera(s, points, UpAxis::Y, 1.5);
  EXPECT_EQ(upright.eye, oblique.eye);
  EXPECT_EQ(upright.lookAt, oblique.lookAt);
  EXPECT_NE(upright.view.prp, oblique.view.prp);
}

// Four quarter turns lead back to the start, and so do a turn up and down. The eye stops one degree short of
// the poles. Zooming in by two halves the distance.
TEST(Camera, MovesOnASphere) {
  const auto points = cloud(4, 1, {0.2, 0.1, 0});
  CameraSettings s;
  const auto place = [&] { return placeCamera(s, points, UpAxis::Z, 1.5); };
  const Camera start = place();
  const double D = glm::length(start.eye - start.lookAt);
  for (int i = 0; i < 4; ++i) s = moved(s, place(), 90, 0, 1);
  EXPECT_NEAR(glm::length(place().eye - start.eye), 0, 1e-14 * 100);
  s = moved(s, place(), 0, 20, 1);
  s = moved(s, place(), 0, -20, 1);
  EXPECT_NEAR(glm::length(place().eye - start.eye), 0, 1e-14 * 100);
  s = moved(s, place(), 0, 500, 2);
  const glm::dvec3 arm = place().eye - place().lookAt;
  EXPECT_NEAR(glm::length(arm), D / 2, 1e-14 * 100);
  s = moved(s, place(), 0, 80, 1);
  s = moved(s, place(), 0, 80, 1);
  EXPECT_NEAR(std::asin(glm::normalize(place().eye - place().lookAt).z), 89 * 3.14159265358979 / 180, 1e-9);
}

// A view straight down with the default up vector picks another up vector instead of failing.
TEST(Camera, LooksStraightDown) {
  CameraSettings s;
  s.eye = glm::dvec3{0, 0, 9};
  s.lookAt = glm::dvec3{0};
  EXPECT_NO_THROW((void)placeCamera(s, cloud(5, 1, {0, 0, 0}), UpAxis::Z, 1));
  s.up = glm::dvec3{0, 0, 1};
  EXPECT_THROW((void)vrcFromWorld(placeCamera(s, cloud(5, 1, {0, 0, 0}), UpAxis::Z, 1).view), ViewError);
}

/// Triangles, and the parts that they are.
struct Triangles {
  std::vector<glm::dvec3> points;
  ConvexParts parts;

  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    for (const glm::dvec3& p : {a, b, c}) {
      parts.corners.push_back(static_cast<int>(points.size()));
      points.push_back(p);
    }
    parts.firstCorner.push_back(static_cast<int>(parts.corners.size()));
    parts.face.push_back(parts.count());
  }
};

/// The least depth at which a ray from the eye meets a triangle, over rays through n by n places of the
/// window.
double nearestHit(const Camera& camera, const Triangles& scene, int n) {
  using Vec = glm::vec<3, Extended>;
  const ViewSpec& view = camera.view;
  const Vec n0 = glm::normalize(Vec{view.vpn}), u = glm::normalize(glm::cross(Vec{view.vup}, n0)),
            v = glm::cross(n0, u);
  const Vec eye =
      Vec{view.vrp} + u * Extended(view.prp.x) + v * Extended(view.prp.y) + n0 * Extended(view.prp.z);
  Extended nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const glm::dvec2 at =
          view.windowMin + (view.windowMax - view.windowMin) * glm::dvec2{(i + 0.5) / n, (j + 0.5) / n};
      const Vec ray = Vec{view.vrp} + u * Extended(at.x) + v * Extended(at.y) - eye;
      for (int k = 0; k < scene.parts.count(); ++k) {  // Moeller & Trumbore 1997
        const auto corner = [&](int c) { return Vec{scene.points[scene.parts.part(k)[c]]}; };
        const Vec e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), P = glm::cross(ray, e2);
        const Extended det = glm::dot(e1, P);
        if (det == 0) continue;
        const Vec T = eye - corner(0), Q = glm::cross(T, e1);
        const Extended a = glm::dot(T, P) / det, b = glm::dot(ray, Q) / det, t = glm::dot(e2, Q) / det;
        if (a >= 0 && b >= 0 && a + b <= 1 && t > 0) nearest = std::min(nearest, -t * glm::dot(ray, n0));
      }
    }
  return static_cast<double>(nearest);
}

double frontDistance(const Camera& camera) { return camera.view.prp.z - camera.view.front; }

// On a floor of 16 km the front plane goes by what is in view, not by the floor's size. Only what one does
// not look at may be nearer.
TEST(Camera, FrontPlaneGoesByWhatIsInView) {
  Triangles scene;
  scene.add({-8000, -8000, 0}, {8000, -8000, 0}, {8000, 8000, 0});
  scene.add({-8000, -8000, 0}, {8000, 8000, 0}, {-8000, 8000, 0});
  CameraSettings s;
  s.eye = glm::dvec3{0, -6, 3}, s.lookAt = glm::dvec3{0, 0, 1}, s.fov = 40;
  const auto place = [&] { return placeCamera(s, scene.points, UpAxis::Z, 4.0 / 3, scene.parts); };
  const Camera camera = place();
  const double nearest = nearestHit(camera, scene, 200);
  EXPECT_GT(nearest, 2);
  EXPECT_NEAR(frontDistance(camera), nearest / 2, nearest / 100);
  EXPECT_EQ(camera.cutByFront, 0);
  s.lookAt = glm::dvec3{0, 0, 30};  // to the sky: nothing is near
  EXPECT_EQ(frontDistance(place()), 16000.0 / 1024);
  EXPECT_EQ(place().cutByFront, 0);
  s.eye = glm::dvec3{0, -6, 1e-3}, s.lookAt = glm::dvec3{0, 0, 0};  // nearer than the depth can be told
  EXPECT_NEAR(frontDistance(place()), 8006 * 0x1p-15, 1e-3);
  EXPECT_EQ(place().cutByFront, 1);
  s.front = 0.0;  // somebody asked for it
  EXPECT_EQ(place().cutByFront, 0);
}

// A part that fills the picture hides all that is farther, so the front plane may be as near to it as it
// must. A part whose back is not drawn hides nothing, and two parts that fill the picture together do not
// count.
TEST(Camera, FrontPlaneIsNearerWhereOnePartFillsThePicture) {
  Triangles scene;
  scene.add({-8000, -8000, 0}, {8000, -8000, 0}, {8000, 8000, 0});
  scene.add({-8000, -8000, 0}, {8000, 8000, 0}, {-8000, 8000, 0});
  CameraSettings s;
  s.up = glm::dvec3{0, 1, 0};
  const auto place = [&](double x, double height, Cull cull) {
    s.eye = glm::dvec3{x, 0, height}, s.lookAt = glm::dvec3{x, 0, 0};
    return placeCamera(s, scene.points, UpAxis::Z, 4.0 / 3, scene.parts, cull);
  };
  for (const Cull cull : {Cull::Keep, Cull::Back})
    for (double height = 1.0; height > 16000 * 0x1p-43; height /= 10) {  // not edge on, beyond rounding
      SCOPED_TRACE(height);
      EXPECT_NEAR(frontDistance(place(16, height, cull)), height / 2, height / 1e6);
      EXPECT_EQ(place(16, height, cull).cutByFront, 0);
      // From below, only the back sides show.
      EXPECT_EQ(place(16, -height, Cull::Back).cutByFront, 0);
      EXPECT_EQ(frontDistance(place(16, -height, Cull::Back)), 16000.0 / 1024);
      EXPECT_NEAR(frontDistance(place(16, -height, Cull::Keep)), height / 2, height / 1e6);
      // Above the diagonal neither triangle fills the picture.
      const double least = (height + 16000.0 / 1024) * 0x1p-15;
      EXPECT_EQ(place(0, height, cull).cutByFront, height < least ? 2 : 0);
    }
}

// Random triangles around the eye. The front plane cuts away nothing that a ray meets, or it is said; and it
// is where it was without the rule if nothing in view is nearer.
TEST(Camera, FrontPlaneCutsNothingInSilence) {
  int nearer = 0, usual = 0, cut = 0;
  for (unsigned seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const auto number = [&](double low, double high) {
      return std::uniform_real_distribution<double>{low, high}(rng);
    };
    const auto around = [&](const glm::dvec3& p, double by) {
      return p + glm::dvec3{number(-by, by), number(-by, by), number(-by, by)};
    };
    CameraSettings s;
    s.eye = around({}, 0.5), s.lookAt = around({}, 1), s.fov = number(5, 140);
    if (seed % 4 == 1)
      s.window = glm::dvec4{-0.5, number(-0.4, 1), number(-0.3, 0), number(0.1, 1)}, s.fov.reset();
    Triangles scene;
    for (int k = 0; k < 12; ++k) {
      const double size = std::pow(10.0, number(-6, 0));
      const glm::dvec3 middle = around(*s.eye, k < 6 ? 2 * size : 1);
      scene.add(around(middle, size), around(middle, size), around(middle, size));
    }
    const Camera camera = placeCamera(s, scene.points, UpAxis::Y, 1.5, scene.parts);
    const Camera blind = placeCamera(s, scene.points, UpAxis::Y, 1.5);
    const double nearest = nearestHit(camera, scene, 60), front = frontDistance(camera);
    if (camera.cutByFront == 0) {
      ASSERT_GE(nearest, front);
    }
    ASSERT_LE(front, frontDistance(blind));
    if (nearest < frontDistance(blind) / 2) {
      ASSERT_TRUE(front < frontDistance(blind) || camera.cutByFront > 0);
    }
    nearer += front < frontDistance(blind), usual += front == frontDistance(blind);
    cut += camera.cutByFront > 0;
  }
  EXPECT_GT(nearer, 50);
  EXPECT_GT(usual, 50);
  EXPECT_GT(cut, 20);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
