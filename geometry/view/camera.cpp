#include "geometry/view/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"

namespace xnewell {

namespace {

constexpr double kMargin = 0.06;  // of the picture's half side; left free around a framed scene
constexpr double kNearFraction = 1.0 / 1024;
constexpr double kLeastNear = 0x1p-15;  // of the farthest distance in view; camera.h says why
constexpr double kPlacedTo = 0x1p-44;   // of n at the eye: the n of the plane is rounded to 2^-53 of that

glm::dvec3 defaultDirection(UpAxis axis) {
  return axis == UpAxis::Z ? glm::dvec3{0.22, -1.0, 0.52} : glm::dvec3{0.22, 0.52, 1.0};
}

/// The length of the box's longest side. For a single point any positive length will do.
double sizeOf(const Box& box) {
  if (const double side = box.side(); side > 0.0) return side;
  const double magnitude = box.magnitude();
  return magnitude > 0.0 ? magnitude : 1.0;
}

/// The smallest upright, symmetric view with slopes `tan` that holds all points.
struct Frame {
  glm::dvec2 centre{0};  ///< of the picture, on n = 0
  double distance = 0;   ///< of the eye from n = 0
  double height = 0;     ///< of the parallel view about the same centre
};

/// Fits a view around points. It centres a parallel view on the points' box and a perspective view on their
/// picture. A view that is `aimed` stays centred on the origin.
Frame frame(std::span<const glm::dvec3> vrc, glm::dvec2 tan, bool aimed, bool parallel) {
  constexpr double kLowest = -std::numeric_limits<double>::infinity();
  glm::dvec2 right{kLowest}, left{kLowest}, most{kLowest}, least{-kLowest};
  for (const glm::dvec3& p : vrc) {
    const glm::dvec2 uv{p};
    right = glm::max(right, uv + tan * p.z);
    left = glm::max(left, tan * p.z - uv);
    most = glm::max(most, uv);
    least = glm::min(least, uv);
  }
  // A point is in the picture if |uv - centre| <= tan (distance - n). So in each direction the best centre
  // and its least distance are linear in the two extremes.
  Frame f;
  if (!aimed) f.centre = parallel ? (most + least) / 2.0 : (right - left) / 2.0;
  const glm::dvec2 distance = glm::max(right - f.centre, left + f.centre) / tan;
  f.distance = std::max(distance.x, distance.y);
  const glm::dvec2 half = glm::max(most - f.centre, f.centre - least);
  f.height = 2.0 * std::max(half.y, half.x * tan.y / tan.x);
  // One direction has room to spare: its centre was computed for a nearer eye. A few steps centre it for this
  // one.
  constexpr int kSteps = 4;
  for (int step = 0; step < kSteps && !aimed && !parallel; ++step) {
    glm::dvec2 high{kLowest}, low{-kLowest};
    for (const glm::dvec3& p : vrc) {
      if (!(p.z < f.distance)) continue;  // in the eye, it is seen in no direction
      const glm::dvec2 seen = (glm::dvec2{p} - f.centre) / (f.distance - p.z);
      high = glm::max(high, seen);
      low = glm::min(low, seen);
    }
    if (!(low.x <= high.x)) break;  // a scene without a width
    f.centre += (high + low) * (f.distance / 2.0);
  }
  return f;
}

/// Cuts a convex polygon with a plane through the origin. Keeps the side to which `inwards` points.
void keepSide(std::vector<glm::dvec3>& polygon, const glm::dvec3& inwards) {
  std::vector<glm::dvec3> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double heightA = glm::dot(inwards, a), heightB = glm::dot(inwards, b);
    if (heightA >= 0.0) kept.push_back(a);
    if ((heightA < 0.0) != (heightB < 0.0)) kept.push_back(a + (b - a) * (heightA / (heightA - heightB)));
  }
  polygon.swap(kept);
}

/// How a polygon lies as seen from the origin.
enum class Seen { EdgeOn, Front, Back };

/// The side of a polygon that is seen from the origin. Edge on, it covers nothing.
Seen sideSeen(const std::vector<glm::dvec3>& polygon) {
  constexpr double kRounded = 0x1p-44;
  glm::dvec3 N{0.0};
  double farthest = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    N += glm::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  for (const glm::dvec3& p : polygon) farthest = std::max(farthest, glm::length(p));
  const double height = glm::dot(unit(N), polygon[0]);
  return std::abs(height) <= kRounded * farthest ? Seen::EdgeOn : height < 0.0 ? Seen::Front : Seen::Back;
}

/// Whether a ray from the origin meets a convex polygon that is not seen edge on. A tie counts as met.
bool meets(const glm::dvec3& ray, const std::vector<glm::dvec3>& polygon, Seen seen) {
  const double inwards = seen == Seen::Front ? -1.0 : 1.0;
  glm::dvec3 N{0.0};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3 wedge = glm::cross(polygon[k], polygon[(k + 1) % polygon.size()]);
    if (inwards * glm::dot(ray, wedge) < 0.0) return false;
    N += wedge;
  }
  return inwards * glm::dot(ray, N) > 0.0;
}

/// What is near in a view.
struct NearParts {
  std::vector<double> depths;  ///< where the parts inside the pyramid of the view begin, from the eye
  /// What is farther cannot be seen: one part fills the picture.
  double hidden = std::numeric_limits<double>::infinity();
};

/// The parts in view that begin nearer than `bound`. Depths are distances from the eye along the line of
/// sight.
NearParts nearParts(double bound, const ViewSpec& view, std::span<const glm::dvec3> points,
                    const ConvexParts& parts, Cull cull) {
  const glm::dmat3 rotation = vrcRotation(view);
  const glm::dvec3 prp = view.prp;
  const glm::dvec2 low = view.windowMin - glm::dvec2{prp}, high = view.windowMax - glm::dvec2{prp};
  const std::array<glm::dvec3, 4> sides{
      {{prp.z, 0.0, low.x}, {-prp.z, 0.0, -high.x}, {0.0, prp.z, low.y}, {0.0, -prp.z, -high.y}}};
  const std::array<glm::dvec3, 4> corners{
      {{low.x, low.y, -prp.z}, {low.x, high.y, -prp.z}, {high.x, low.y, -prp.z}, {high.x, high.y, -prp.z}}};
  const auto depth = [](const glm::dvec3& p) { return -p.z; };
  std::vector<glm::dvec3> fromEye;
  for (const glm::dvec3& p : points) fromEye.push_back(rotation * (p - view.vrp) - prp);
  NearParts near;
  std::vector<glm::dvec3> polygon;
  for (int k = 0; k < parts.count(); ++k) {
    polygon.clear();
    for (const int corner : parts.part(k)) polygon.push_back(fromEye[corner]);
    const auto [least, most] = std::ranges::minmax(polygon, {}, depth);
    if (depth(least) >= bound || depth(most) <= 0.0) continue;
    const Seen seen = sideSeen(polygon);
    if (seen == Seen::EdgeOn || (seen == Seen::Back && cull == Cull::Back)) continue;
    const bool fills =
        std::ranges::all_of(corners, [&](const glm::dvec3& ray) { return meets(ray, polygon, seen); });
    for (const glm::dvec3& side : sides) keepSide(polygon, side);
    if (polygon.empty()) continue;
    const auto [first, last] = std::ranges::minmax(polygon, {}, depth);
    const double begins = std::max(0.0, depth(first));
    if (begins < bound) near.depths.push_back(begins);
    if (fills) near.hidden = std::min(near.hidden, depth(last));
  }
  return near;
}

}  // namespace

glm::dvec3 upVector(UpAxis axis) { return axis == UpAxis::Z ? glm::dvec3{0, 0, 1} : glm::dvec3{0, 1, 0}; }

Camera placeCamera(const CameraSettings& s, std::span<const glm::dvec3> points, UpAxis axis, double aspect,
                   const ConvexParts& parts, Cull cull) {
  const double fov = s.fov.value_or(kDefaultFov);
  if (!(fov > 0.0 && fov < 180.0)) throw ViewError{"the field of view must lie between 0 and 180 degrees"};
  Box box;
  for (const glm::dvec3& p : points) box.add(p);
  if (points.empty()) box.add(glm::dvec3{0.0});
  const double side = sizeOf(box);

  // The axes: as given, otherwise a pleasant direction.
  Camera camera;
  ViewSpec& view = camera.view;
  const bool parallel = s.parallel || s.oblique;
  view.projection = parallel ? Projection::Parallel : Projection::Perspective;
  const bool aimed = s.vrp || s.lookAt;
  view.vrp = s.vrp ? *s.vrp : s.lookAt.value_or(box.centre());
  view.vpn = s.vpn ? *s.vpn : s.eye ? *s.eye - view.vrp : defaultDirection(axis);
  view.vup = s.vup ? *s.vup : s.up.value_or(upVector(axis));
  if (!s.vup && !s.up && glm::cross(unit(view.vup), unit(view.vpn)) == glm::dvec3{0.0})
    view.vup = upVector(axis == UpAxis::Z ? UpAxis::Y : UpAxis::Z);  // the view is straight down or up

  // The scene in VRC. An oblique view shears it before it is framed.
  const glm::dmat3 rotation = vrcRotation(view);
  glm::dvec2 lean{0.0};
  if (s.oblique) {
    const SinCos a = sinCosDegrees(s.oblique->angle);
    lean = s.oblique->length * glm::dvec2{a.cos, a.sin};
  }
  const bool free = !aimed && !s.eye && !s.prp && !s.window;
  // false if everything is given
  const bool fits = free || !s.eye || s.prp || (parallel && !s.window && !s.height);
  std::vector<glm::dvec3> vrc;
  if (fits) vrc.reserve(points.size());
  Box vrcBox;
  for (const glm::dvec3& p : points) {
    const glm::dvec3 q = rotation * (p - view.vrp);
    vrcBox.add(q);
    if (fits) vrc.push_back(q - glm::dvec3{lean * q.z, 0.0});
  }
  if (points.empty()) vrcBox.add(glm::dvec3{0.0});

  // The distance and the window: as given, otherwise so that the scene fills the picture.
  const double tanV = tanDegrees(fov / 2.0);
  const Frame fit =
      fits ? frame(vrc, (1.0 - kMargin) * tanV * glm::dvec2{aspect, 1.0}, !free, parallel) : Frame{};
  if (free) {
    view.vrp += glm::transpose(rotation) * glm::dvec3{fit.centre, 0.0};
    vrcBox.low -= glm::dvec3{fit.centre, 0.0};
    vrcBox.high -= glm::dvec3{fit.centre, 0.0};
  }
  const double away = fit.distance == 0.0 ? side : fit.distance;  // a point is seen from anywhere
  const double D = s.prp   ? s.prp->z
                   : s.eye ? (rotation * (*s.eye - view.vrp)).z
                           : std::max(away, vrcBox.high.z + side * kNearFraction * 2);
  if (s.window) {
    view.windowMin = {s.window->x, s.window->z};
    view.windowMax = {s.window->y, s.window->w};
  } else {
    const double halfHeight = parallel ? s.height.value_or(fit.height / (1.0 - kMargin)) / 2.0 : D * tanV;
    const glm::dvec2 half =
        halfHeight > 0.0 ? halfHeight * glm::dvec2{aspect, 1.0} : side * glm::dvec2{aspect, 1.0};
    view.windowMin = -half;
    view.windowMax = half;
  }
  // The projectors run from PRP to the window's middle. Where the user says how they lean, or neither PRP nor
  // the eye, PRP is where they lean so.
  view.prp = s.prp.value_or(glm::dvec3{0, 0, D});
  if (s.oblique || (parallel && !s.prp && !s.eye))
    view.prp = {(view.windowMin + view.windowMax) / 2.0 + lean * D, D};

  // The clipping planes: as given, otherwise around the scene, with the front plane in front of the eye.
  const double gap = side * kNearFraction;
  const double sceneFront = vrcBox.high.z + gap, sceneBack = vrcBox.low.z - gap;
  if (s.front || parallel) {
    view.front = s.front.value_or(sceneFront);
  } else {
    double near = std::max(gap, (view.prp.z - sceneFront) / 2.0);
    if (view.prp.z - vrcBox.high.z < near) {  // something may be nearer; it matters if it is in view
      const NearParts inView = nearParts(near, view, points, parts, cull);
      const double farthest = std::min(view.prp.z - s.back.value_or(sceneBack), inView.hidden);
      const double least = std::min(near, std::max(farthest * kLeastNear, view.prp.z * kPlacedTo));
      for (const double depth : inView.depths) near = std::min(near, std::max(least, depth / 2.0));
      camera.cutByFront =
          static_cast<int>(std::ranges::count_if(inView.depths, [&](double d) { return d < near; }));
    }
    view.front = view.prp.z - near;
  }
  view.back = s.back ? *s.back : std::min(sceneBack, view.front - gap);

  const glm::dvec3 eyeInVrc = s.prp ? view.prp : glm::dvec3{0, 0, D};
  camera.eye = s.eye && !s.prp ? *s.eye : view.vrp + glm::transpose(rotation) * eyeInVrc;
  camera.lookAt = view.vrp;
  camera.up = view.vup;
  return camera;
}

CameraSettings moved(const CameraSettings& s, const Camera& camera, double azimuth, double elevation,
                     double zoom) {
  const glm::dvec3 up = unit(camera.up), arm = camera.eye - camera.lookAt;
  const double length = std::sqrt(glm::dot(arm, arm));
  // Turn about the up vector, then towards it, along the circle through the eye and the pole.
  const SinCos a = sinCosDegrees(azimuth);
  const glm::dvec3 turned =
      arm * a.cos + glm::cross(up, arm) * a.sin + up * glm::dot(up, arm) * (1.0 - a.cos);
  const glm::dvec3 flat = unit(turned - up * glm::dot(up, turned));
  const SinCos e = sinCosDegrees(elevation), limit = sinCosDegrees(89.0);
  const double sinNow = glm::dot(up, unit(turned)), cosNow = glm::dot(flat, unit(turned));
  const double sinNext = std::clamp(sinNow * e.cos + cosNow * e.sin, -limit.sin, limit.sin);
  const bool past = cosNow * e.cos - sinNow * e.sin < limit.cos;
  const double s1 = past ? (sinNow > 0.0 ? limit.sin : -limit.sin) : sinNext;
  const double c1 = std::sqrt(std::max(0.0, 1.0 - s1 * s1));

  CameraSettings next = s;
  next.vrp = next.vpn = next.vup = next.prp = std::nullopt;
  next.window = std::nullopt;
  next.front = next.back = std::nullopt;
  const bool parallel = camera.view.projection == Projection::Parallel;
  next.parallel = parallel;
  next.lookAt = camera.lookAt;
  next.up = camera.up;
  next.eye = camera.lookAt + (flat * c1 + up * s1) * (parallel ? length : length / zoom);
  next.height = std::nullopt;
  if (parallel) next.height = (camera.view.windowMax.y - camera.view.windowMin.y) / zoom;
  return next;
}

}  // namespace xnewell
