#include "tests/support/near_judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "tests/support/extended.h"

namespace xnewell {

namespace {

using std::abs, std::isfinite;  // and those of two doubles

using Real = Extended;

using Vec = glm::vec<3, Real>;

constexpr double kStep = 1.0 / 65536;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ray {
  Vec from, along;
};

/// The rays of a camera. A point of the ray at (x, y), in pixels, is from + along * d (perspective; d is the
/// distance from the eye along the axis) or from + along * n (parallel; n grows towards the viewer).
class Rays {
 public:
  Rays(const JudgedCamera& camera, int width, int height)
      : width_{width}, height_{height}, perspective_{camera.height == 0}, eye_{Vec{camera.eye}} {
    n_ = glm::normalize(eye_ - Vec{camera.lookAt});
    u_ = glm::normalize(cross(Vec{camera.up}, n_));
    v_ = cross(n_, u_);
    at_ = Vec{camera.lookAt};
    constexpr double kDegree = std::numbers::pi / 180;
    half_ = perspective_ ? std::tan(camera.fov / 2 * kDegree) : camera.height / 2;
    const double angle = camera.angle * kDegree;
    lean_ = Real{camera.length} * (Real{std::cos(angle)} * u_ + Real{std::sin(angle)} * v_) + n_;
    const Real D = dot(eye_ - at_, n_);
    zPerDepth_ = height / 2.0 / half_ * (perspective_ ? D : 1);  // pixels of z for each unit of depth()
  }
  [[nodiscard]] bool perspective() const { return perspective_; }
  [[nodiscard]] Ray at(Real x, Real y) const {
    const Real X = half_ * (2 * x - width_) / height_, Y = half_ * (height_ - 2 * y) / height_;
    const Vec onPlane = X * u_ + Y * v_;
    return perspective_ ? Ray{eye_, onPlane - n_} : Ray{at_ + onPlane, lean_};
  }
  /// What grows towards the viewer, linearly over the screen on a plane: 1 / d or n.
  [[nodiscard]] Real zPerDepth() const { return zPerDepth_; }
  /// Distance from the eye along the axis.
  [[nodiscard]] Real distance(const Vec& p) const { return dot(eye_ - p, n_); }
  /// Place on the screen, in pixels.
  [[nodiscard]] std::array<Real, 2> seen(const Vec& p) const {
    Vec q = p - (perspective_ ? eye_ : at_);
    Real scale = height_ / (2 * half_);
    if (perspective_)
      scale /= distance(p);
    else
      q = q - dot(q, n_) * lean_;
    return {width_ / 2.0 + scale * dot(q, u_), height_ / 2.0 - scale * dot(q, v_)};
  }

 private:
  int width_, height_;
  bool perspective_;
  Vec eye_, at_, n_, u_, v_, lean_;
  Real half_ = 0, zPerDepth_ = 0;
};

/// Clips a polygon to where inside(p) >= 0, a linear function.
template <class Inside>
std::vector<Vec> clipped(const std::vector<Vec>& polygon, const Inside& inside) {
  std::vector<Vec> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const Real ha = inside(a), hb = inside(b);
    if (ha >= 0) kept.push_back(a);
    if ((ha >= 0) != (hb >= 0)) kept.push_back(a + (ha / (ha - hb)) * (b - a));
  }
  return kept;
}

class Judge {
 public:
  Judge(const Mesh& mesh, const std::vector<int>& madeIn, double u, const JudgedCamera& camera, int width,
        int height, const std::vector<std::uint32_t>& shown)
      : mesh_{mesh},
        madeIn_{madeIn},
        rays_{camera, width, height},
        width_{width},
        height_{height},
        shown_{shown} {
    constexpr double kMost = std::numeric_limits<double>::max();
    glm::dvec3 low{kMost}, high{-kMost};
    for (const glm::dvec3& p : mesh.points)
      for (int axis = 0; axis < 3; ++axis)
        low[axis] = std::min(low[axis], p[axis]), high[axis] = std::max(high[axis], p[axis]);
    Real magnitude = 0;
    for (int axis = 0; axis < 3; ++axis) {
      side_ = std::max(side_, Real{high[axis]} - low[axis]);
      magnitude = std::max({magnitude, Real{abs(high[axis])}, Real{abs(low[axis])}});
    }
    u_ = u;
    e_ = 0x1p-46 * side_ + 0x1p-50 * magnitude;
    front_ = frontPlane();
    for (int f = 0; f < mesh.faceCount(); ++f) faces_.push_back(faceOf(f));
    zHalfStep_ = 0.5 * kStep * std::exp2(zShift()) / rays_.zPerDepth();
  }

  Judgement judgement() {
    Judgement j;
    const std::size_t count = std::size_t(width_) * height_;
    depth_.assign(count, 0), explained_.assign(count, 0);
    for (std::size_t k = 0; k < count; ++k)
      if (shown_[k] != 0) {
        ++j.samples;
        const Face& face = faces_[shown_[k] - 1];
        const Real x = static_cast<int>(k) % width_ + 0.5, y = static_cast<int>(k) / width_ + 0.5;
        depth_[k] = depthAt(face, x, y);
        explained_[k] = explainedAt(face, x, y, depth_[k]);
        j.outline += !covers(face, x, y, -1, 0);
      }
    std::vector<char> tooFar(count), lost(count), hole(count), doubtful(count);
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      const Face& face = faces_[f];
      for (int row = face.y0; row < face.y1; ++row)
        for (int column = face.x0; column < face.x1; ++column) {
          const std::size_t k = std::size_t(row) * width_ + column;
          const int S = static_cast<int>(shown_[k]) - 1;
          const Real x = column + 0.5, y = row + 0.5;
          if (S == f || !covers(face, x, y, 0, 0)) continue;
          if (S < 0) {
            hole[k] |= covers(face, x, y, 1, 0);
            continue;
          }
          const Real depth = depthAt(face, x, y), ahead = depth - depth_[k];
          const Real explained = explainedAt(face, x, y, depth) + explained_[k];
          doubtful[k] |= abs(ahead) <= explained;
          const bool sure = (ahead > 0 || f > S) && covers(face, x, y, 1, 0);
          if (sure && ahead > 0) j.worst = std::max(j.worst, static_cast<double>(ahead / explained));
          tooFar[k] |= sure && ahead > 1.5 * explained;
          const bool together = madeIn_[f] >= 0 && madeIn_[f] == madeIn_[S];
          lost[k] |= together && f > S && sure && covers(face, x, y, 1, 3 * std::sqrt(3.0) * u_);
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
      j.farther += tooFar[k];
      j.lost += lost[k];
      j.outline += hole[k];
      j.doubtful += doubtful[k];
    }
    return j;
  }

 private:
  struct Face {
    std::vector<Vec> corners;
    Vec N;                               ///< unit; the corners run counter-clockwise about it
    Real d = 0, r = 0;                   ///< N.p = d; the rounding of d
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< the pixels that it may cover
  };

  Face faceOf(int f) const {
    Face face;
    for (const int c : mesh_.face(f)) face.corners.push_back(Vec{mesh_.points[c]});
    Vec sum{0}, mean{0};
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const Vec &a = face.corners[k], &b = face.corners[(k + 1) % face.corners.size()];
      sum = sum + cross(a - face.corners[0], b - face.corners[0]);
      mean = mean + a;
    }
    face.N = glm::normalize(sum);
    face.d = dot(face.N, (1 / Real{static_cast<double>(face.corners.size())}) * mean);
    face.r = u_ * (abs(face.N.x) + abs(face.N.y) + abs(face.N.z)) + e_;

    Real x0 = width_, y0 = height_, x1 = 0, y1 = 0;
    for (const Vec& p : inFront(face.corners)) {
      const auto [x, y] = rays_.seen(p);
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
    const auto pixel = [](Real at, int most) {
      return static_cast<int>(std::clamp(std::floor(static_cast<double>(at)), 0.0, double(most)));
    };
    face.x0 = pixel(x0 - 1, width_), face.x1 = pixel(x1 + 2, width_);
    face.y0 = pixel(y0 - 1, height_), face.y1 = pixel(y1 + 2, height_);
    return face;
  }
  /// The distance of the front plane that camera.h promises: half way to the scene or side / 1024; where
  /// something in view is nearer, half way to that, but no nearer than 2^-15 of the way to the back plane, or
  /// to the farthest point in view of a face that fills the picture and begins nearer than side / 1024 or
  /// half way to the scene. In a picture that is right, it cuts away nothing else in view.
  [[nodiscard]] Real frontPlane() const {
    if (!rays_.perspective()) return 0;
    Real first = kInfinity, last = -kInfinity, inView = kInfinity;
    for (const glm::dvec3& p : mesh_.points)
      first = std::min(first, rays_.distance(Vec{p})), last = std::max(last, rays_.distance(Vec{p}));
    const Real gap = side_ / 1024, usual = std::max(gap, (first - gap) / 2);
    Real seenTo = last + gap;
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      std::vector<Vec> polygon;
      for (const int c : mesh_.face(f)) polygon.push_back(Vec{mesh_.points[c]});
      polygon = clipped(polygon, [&](const Vec& p) { return rays_.distance(p) - side_ * 0x1p-40; });
      polygon = within(polygon, 0, width_, 0, height_);
      Real begins = kInfinity, ends = 0, area = 0;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec& p = polygon[k];
        begins = std::min(begins, rays_.distance(p)), ends = std::max(ends, rays_.distance(p));
        const auto a = rays_.seen(p), b = rays_.seen(polygon[(k + 1) % polygon.size()]);
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
      }
      inView = std::min(inView, begins);
      if (begins < usual && abs(area) > (1 - 1e-9) * width_ * height_) seenTo = std::min(seenTo, ends);
    }
    return std::min(usual, std::max(inView / 2, std::min(usual, seenTo * 0x1p-15)));
  }
  /// Clips a polygon in front of the eye to a rectangle of the screen, in pixels.
  [[nodiscard]] std::vector<Vec> within(std::vector<Vec> polygon, Real left, Real right, Real top,
                                        Real bottom) const {
    const std::array<std::pair<int, Real>, 2> low{{{0, left}, {1, top}}}, high{{{0, right}, {1, bottom}}};
    // times the distance, so that it is linear
    for (const auto& [axis, limit] : low)
      polygon = clipped(polygon, [&, axis = axis, limit = limit](const Vec& p) {
        return rays_.distance(p) * (rays_.seen(p)[axis] - limit);
      });
    for (const auto& [axis, limit] : high)
      polygon = clipped(polygon, [&, axis = axis, limit = limit](const Vec& p) {
        return rays_.distance(p) * (limit - rays_.seen(p)[axis]);
      });
    return polygon;
  }
  [[nodiscard]] std::vector<Vec> inFront(const std::vector<Vec>& corners) const {
    if (!rays_.perspective()) return corners;
    return clipped(corners, [&](const Vec& p) { return rays_.distance(p) - 0.99 * front_; });
  }

  /// The power of two of a z step: the least for which 2^30 steps reach the nearest point. Points beyond 8192
  /// pixels from the origin of the screen are cut away before.
  [[nodiscard]] int zShift() const {
    Real nearest = 0, farthest = kInfinity;
    for (const Face& face : faces_) {
      std::vector<Vec> polygon = face.corners;
      if (rays_.perspective()) {
        polygon = clipped(polygon, [&](const Vec& p) { return rays_.distance(p) - front_; });
        polygon = within(polygon, -8192, 8192, -8192, 8192);
      }
      for (const Vec& p : polygon) {
        const Real depth = rays_.perspective() ? 1 / rays_.distance(p) : -rays_.distance(p);
        nearest = std::max(nearest, depth);
        farthest = std::min(farthest, depth);
      }
    }
    int shift = 0;
    while (rays_.perspective() && (nearest - farthest) * rays_.zPerDepth() / kStep > std::exp2(30.0 + shift))
      ++shift;
    return shift;
  }

  /// 1 / d or n where the ray meets the face's plane.
  [[nodiscard]] Real depthAt(const Face& face, Real x, Real y) const {
    const Ray ray = rays_.at(x, y);
    const Real slope = dot(face.N, ray.along), height = face.d - dot(face.N, ray.from);
    return rays_.perspective() ? slope / height : height / slope;
  }
  /// How much of a difference from `depth` rounding explains: of the plane, and of the grid in x, y and z.
  [[nodiscard]] Real explainedAt(const Face& face, Real x, Real y, Real depth) const {
    const Ray ray = rays_.at(x, y);
    const Real slope = dot(face.N, ray.along), height = face.d - dot(face.N, ray.from);
    const Real away = std::max(abs(height) - face.r, Real{0});  // at 0, everything is explained
    const Real plane = rays_.perspective() ? abs(depth) * face.r / away : face.r / abs(slope);
    const Real grid =
        abs(depthAt(face, x + kStep / 2, y) - depth) + abs(depthAt(face, x, y + kStep / 2) - depth);
    return plane + grid + zHalfStep_;
  }
  /// True if the face covers the sample: even if the sample moves by `steps` of the grid any way, and by
  /// `reach` within the plane. Negative steps: if it does after some such move.
  [[nodiscard]] bool covers(const Face& face, Real x, Real y, int steps, Real reach) const {
    if (steps == 0) return inside(face, x, y, face.corners.size(), reach);
    const Real s = abs(steps) * kStep;
    const std::array<std::array<Real, 2>, 4> places{
        {{x - s, y - s}, {x + s, y - s}, {x - s, y + s}, {x + s, y + s}}};
    if (steps > 0) {
      for (const auto& [px, py] : places)
        if (!inside(face, px, py, face.corners.size(), reach)) return false;
      return true;
    }
    for (std::size_t k = 0; k < face.corners.size(); ++k) {  // each edge by itself
      bool some = inside(face, x, y, k, 0);
      for (const auto& [px, py] : places) some = some || inside(face, px, py, k, 0);
      if (!some) return false;
    }
    return true;
  }
  /// True if the ray at (x, y) meets the plane on the inner side of the edge, or of all edges, by `reach`.
  [[nodiscard]] bool inside(const Face& face, Real x, Real y, std::size_t edge, Real reach) const {
    const Ray ray = rays_.at(x, y);
    const Real slope = dot(face.N, ray.along), t = (face.d - dot(face.N, ray.from)) / slope;
    if (!isfinite(t) || (rays_.perspective() && t < front_ * 0.999)) return false;
    if (rays_.perspective() && reach >= 0 && edge == face.corners.size() && t < front_ * 1.001) return false;
    const Vec p = ray.from + t * ray.along;
    const auto within = [&](std::size_t k) {
      // A corner may be off the plane, so the ray is asked on which side of the edge itself it passes.
      const Vec &a = face.corners[k], &b = face.corners[(k + 1) % face.corners.size()];
      const Real turn = dot(ray.along, cross(a - ray.from, b - ray.from));
      if ((slope < 0 ? -turn : turn) < 0) return false;
      return reach == 0 || dot(cross(b - a, p - a), face.N) >= reach * length(b - a);
    };
    if (edge < face.corners.size()) return within(edge);
    for (std::size_t k = 0; k < face.corners.size(); ++k)
      if (!within(k)) return false;
    return true;
  }

  const Mesh& mesh_;
  const std::vector<int>& madeIn_;
  Rays rays_;
  int width_, height_;
  const std::vector<std::uint32_t>& shown_;
  Real u_ = 0, e_ = 0, side_ = 0, front_ = 0, zHalfStep_ = 0;
  std::vector<Face> faces_;
  std::vector<Real> depth_, explained_;
};

}  // namespace

Judgement judged(const Mesh& mesh, const std::vector<int>& madeIn, double u, const JudgedCamera& camera,
                 int width, int height, const std::vector<std::uint32_t>& shown) {
  return Judge{mesh, madeIn, u, camera, width, height, shown}.judgement();
}

}  // namespace xnewell
