#include "shading/extremes/rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace xnewell {

namespace {

using std::abs;  // and that of two doubles

/// What arithmetic of the rays may be off, as a share of a distance: far more than its rounding.
constexpr double kArithmetic = 0x1p-54;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Rays::Rays(const Scene& scene, const Camera& camera, const PictureSettings& settings)
    : scene_{scene},
      vrp_{camera.view.vrp},
      perspective_{camera.view.projection == Projection::Perspective},
      low_{camera.view.windowMin},
      high_{camera.view.windowMax},
      front_{settings.camera.front ? camera.view.front : kInfinity},
      back_{settings.camera.back ? camera.view.back : -kInfinity},
      width_{settings.width},
      height_{settings.height},
      cull_{settings.cull} {
  const ViewSpec& view = camera.view;
  n_ = glm::normalize(Vec{view.vpn});
  u_ = glm::normalize(glm::cross(Vec{view.vup}, n_));
  v_ = glm::cross(n_, u_);
  prp_ = vrp_ + Vec{view.prp}.x * u_ + Vec{view.prp}.y * v_ + Vec{view.prp}.z * n_;
  const ConvexParts& parts = scene.parts;
  parts_.reserve(parts.count());
  for (int k = 0; k < parts.count(); ++k) {
    const std::span<const int> corners = parts.part(k);
    const Vec first{scene.mesh.points[corners[0]]};
    Vec twiceArea{0};
    for (std::size_t c = 2; c < corners.size(); ++c)
      twiceArea += glm::cross(Vec{scene.mesh.points[corners[c - 1]]} - first,
                              Vec{scene.mesh.points[corners[c]]} - first);
    const TwoDoubles length = glm::length(twiceArea);
    if (!(length > 0)) continue;
    Part part{.face = parts.face[k], .part = k, .N = twiceArea / length, .play = 0};
    const Vec N = glm::abs(part.N);
    part.play = scene.mesh.roundingOf(part.face) * (N.x + N.y + N.z);
    bound(part);
    parts_.push_back(part);
  }
}

/// The box of the projected corners, or the whole picture if a corner is not in front of the eye.
void Rays::bound(Part& part) const {
  part.x1 = width_, part.y1 = height_;
  TwoDoubles x0 = width_, x1 = 0, y0 = height_, y1 = 0;
  const Vec centre =
      vrp_ + TwoDoubles{0.5} * (low_.x + high_.x) * u_ + TwoDoubles{0.5} * (low_.y + high_.y) * v_;
  const Vec along = centre - prp_;  // of a parallel view
  for (const int c : scene_.parts.part(part.part)) {
    const Vec p = Vec{scene_.mesh.points[c]} - vrp_, e = prp_ - vrp_;
    const TwoDoubles depth = glm::dot(e, n_), n = glm::dot(p, n_);
    Vec on;
    if (perspective_) {
      if (depth - n <= 1e-9 * depth) return;
      on = e + (p - e) * (depth / (depth - n));
    } else {
      on = p - along * (n / glm::dot(along, n_));
    }
    const TwoDoubles x = (glm::dot(on, u_) - low_.x) / (high_.x - low_.x) * width_;
    const TwoDoubles y = (high_.y - glm::dot(on, v_)) / (high_.y - low_.y) * height_;
    x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
  part.x0 = x0 - 1, part.x1 = x1 + 1, part.y0 = y0 - 1, part.y1 = y1 + 1;
}

Rays::Ray Rays::ray(TwoDoubles x, TwoDoubles y) const {
  const TwoDoubles u = low_.x + (high_.x - low_.x) * x / width_,
                   v = high_.y - (high_.y - low_.y) * y / height_;
  const Vec on = vrp_ + u * u_ + v * v_;
  if (perspective_) return {prp_, glm::normalize(on - prp_)};
  const Vec centre =
      vrp_ + TwoDoubles{0.5} * (low_.x + high_.x) * u_ + TwoDoubles{0.5} * (low_.y + high_.y) * v_;
  const Vec along = centre - prp_;
  return {on - along, glm::normalize(along)};
}

std::optional<Rays::Hit> Rays::meet(const Part& part, const Ray& ray) const {
  const std::span<const int> corners = scene_.parts.part(part.part);
  const TwoDoubles slope = glm::dot(part.N, ray.along);
  if (slope == 0 || (cull_ == Cull::Back && slope > 0)) return {};
  bool left = false, right = false;
  Vec a = Vec{scene_.mesh.points[corners.back()]} - ray.from;
  for (const int c : corners) {
    const Vec b = Vec{scene_.mesh.points[c]} - ray.from;
    const TwoDoubles side = glm::dot(ray.along, glm::cross(a, b));
    left |= side > 0, right |= side < 0;
    if (left && right) return {};
    a = b;
  }
  const TwoDoubles t = glm::dot(part.N, Vec{scene_.mesh.points[corners[0]]} - ray.from) / slope;
  const TwoDoubles n = glm::dot(ray.from + t * ray.along - vrp_, n_);
  if (n > front_ || n < back_ || (perspective_ && t <= 0)) return {};
  return Hit{part.face, t, part.play / abs(slope)};
}

std::optional<Rays::Hit> Rays::nearestOf(std::span<const Part> parts, TwoDoubles x, TwoDoubles y) const {
  const Ray along = ray(x, y);
  std::optional<Hit> nearest;
  for (const Part& part : parts) {
    if (x < part.x0 || x > part.x1 || y < part.y0 || y > part.y1) continue;
    const std::optional<Hit> hit = meet(part, along);
    if (hit && (!nearest || hit->t < nearest->t)) nearest = hit;
  }
  return nearest;
}

std::optional<Rays::Hit> Rays::hit(int face, TwoDoubles x, TwoDoubles y) const {
  return nearestOf(std::ranges::equal_range(parts_, face, {}, &Part::face), x, y);
}

TwoDoubles Rays::z(const Hit& hit, TwoDoubles x, TwoDoubles y) const {
  const TwoDoubles pixel = (high_.x - low_.x) / width_, D = glm::dot(prp_ - vrp_, n_);
  const TwoDoubles depth = hit.t * abs(glm::dot(ray(x, y).along, n_));
  return (perspective_ ? D * D / depth : -depth) / pixel;
}

glm::dvec3 Rays::point(TwoDoubles x, TwoDoubles y, TwoDoubles t) const {
  const Ray along = ray(x, y);
  return along.from + t * along.along;
}

namespace {

/// The middle and the corners of a square of this half side.
std::array<std::array<TwoDoubles, 2>, 5> around(TwoDoubles s) {
  return {{{0, 0}, {s, s}, {-s, s}, {s, -s}, {-s, -s}}};
}

/// True if face `shown` may look as near as face `nearest` at (x, y), because the corners of each were moved
/// by half a step of the grid.
bool isDoubtful(const Rays& rays, int shown, int nearest, TwoDoubles x, TwoDoubles y, TwoDoubles zStep) {
  TwoDoubles mine = -kInfinity, its = kInfinity;
  for (const auto& [dx, dy] : around(0.5 / kGrid)) {
    if (const auto hit = rays.hit(shown, x + dx, y + dy)) mine = std::max(mine, rays.z(*hit, x + dx, y + dy));
    if (const auto hit = rays.hit(nearest, x + dx, y + dy)) its = std::min(its, rays.z(*hit, x + dx, y + dy));
  }
  return mine >= its - zStep;
}

}  // namespace

ByGroundTruth byGroundTruth(const Picture& picture) {
  const int width = picture.settings().width, height = picture.settings().height;
  const Rays rays{picture.scene(), picture.camera(), picture.settings()};
  const std::vector<std::uint32_t> shown = picture.faceImage();
  const double zStep = std::ldexp(1.0 / kGrid, picture.snapped().zShift);
  ByGroundTruth judged;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const int face = static_cast<int>(shown[std::size_t(j) * width + i]) - 1;  // -1 where none shows
      const std::optional<Rays::Hit> first = rays.nearest(i + 0.5, j + 0.5);
      judged.samples += face >= 0 || first;
      if (face == (first ? first->face : -1)) continue;
      double behind = 1;
      for (const auto& [dx, dy] : around(2.0 / kGrid)) {
        const std::optional<Rays::Hit> near = rays.nearest(i + 0.5 + dx, j + 0.5 + dy);
        if (face < 0 || !near) {
          if (face < 0 && !near) behind = 0;
          continue;
        }
        const std::optional<Rays::Hit> mine = rays.hit(face, i + 0.5 + dx, j + 0.5 + dy);
        if (!mine) continue;
        const TwoDoubles apart = mine->t - near->t;
        const bool one = apart <= mine->play + near->play + kArithmetic * abs(near->t);
        behind = std::min(behind, one ? 0.0 : static_cast<double>(apart / abs(near->t)));
      }
      if (behind > 0 && face >= 0 && first && isDoubtful(rays, face, first->face, i + 0.5, j + 0.5, zStep)) {
        ++judged.doubtful;
        continue;
      }
      judged.wrong += behind > 0;
      judged.missing += behind > 0 && face < 0;
      judged.behind = std::max(judged.behind, behind);
    }
  return judged;
}

}  // namespace xnewell
