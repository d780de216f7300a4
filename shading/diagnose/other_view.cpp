#include "shading/diagnose/other_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace xnewell {

namespace {

using V = ViewSteps;
using glm::dmat4;
using glm::dvec3;

constexpr double kDegree = std::numbers::pi / 180;

dmat4 moved(const dvec3& by) { return glm::translate(dmat4{1.0}, by); }

dvec3 rowOf(const dmat4& m, int k) { return {m[0][k], m[1][k], m[2][k]}; }

/// The product of rotations about x, y and z, the angles in radians.
dmat4 turnedBy(const dvec3& a) {
  return glm::rotate(dmat4{1.0}, a.x, {1, 0, 0}) * glm::rotate(dmat4{1.0}, a.y, {0, 1, 0}) *
         glm::rotate(dmat4{1.0}, a.z, {0, 0, 1});
}
/// These angles of a rotation.
dvec3 anglesOf(const dmat4& R) {
  return {std::atan2(-R[2][1], R[2][2]), std::asin(std::clamp(R[2][0], -1.0, 1.0)),
          std::atan2(-R[1][0], R[0][0])};
}

constexpr ViewMistake row(std::string_view key, std::string_view sentence, void (*change)(V&),
                          bool isAllowed = false) {
  return {key, sentence, change, isAllowed};
}

constexpr std::array kRows{
    row("view-T-after-R", "The scene is turned first and moved then: R comes before T(-eye).",
        [](V& s) { s.view = moved(-s.from) * s.R; }),
    row("view-T-after-R", "The scene is turned first and moved then: R comes before T(-eye).",
        [](V& s) { s.view = moved(-s.prp) * moved(-s.spec.vrp) * s.R; }),
    row("view-S-first", "The scaling S comes first, before R and T.",
        [](V& s) {
          const dmat4 S = s.S;
          s.S = dmat4{1.0};
          s.view = s.vrcFromWorld() * S;
        }),
    row("R-angles-negated", "The angles of the rotation have the other sign.",
        [](V& s) { s.R = turnedBy(-anglesOf(s.R)); }),
    row("R-in-degrees", "The angles of the rotation are degrees where the functions take radians.",
        [](V& s) { s.R = turnedBy(anglesOf(s.R) / kDegree); }),
    row("fov-in-degrees", "The field of view is in degrees where tan takes radians.",
        [](V& s) {
          const double by = std::tan(s.fov / 2 * kDegree) / std::tan(s.fov / 2);
          s.scale(by, by);
        }),
    row("R-transposed", "R is transposed: u, v and n are its columns, not its rows.",
        [](V& s) { s.R = glm::transpose(s.R); }),
    row("view-transposed", "The matrix R T(-eye) is transposed.",
        [](V& s) { s.view = glm::transpose(s.vrcFromWorld()); }),
    row("rows-for-columns", "The whole matrix is transposed: points are rows where it takes columns.",
        [](V& s) { s.all = glm::transpose(s.clipFromWorld()); }),
    row("R-wrong-axis", "The rotations about x and y are about each other's axis.",
        [](V& s) {
          const dvec3 a = anglesOf(s.R);
          s.R = turnedBy({a.y, a.x, a.z});
        }),
    row("w-not-divided", "x and y are not divided by w.", [](V& s) { s.divides = false; }),
    row("w-not-divided", "x and y are not divided by w.",
        [](V& s) {
          s.divides = false;
          s.scale(s.prp.z - s.spec.back, s.prp.z - s.spec.back);
        }),
    row("divided-before-clipping", "Points are divided by w before they are clipped.",
        [](V& s) { s.clips = false; }),
    row("aspect-inverted", "The aspect is height / width, not width / height.",
        [](V& s) { s.scale(s.aspect * s.aspect, 1); }),
    row("aspect-forgotten", "The aspect is left out, so the picture is stretched.",
        [](V& s) { s.scale(s.aspect, 1); }),
    row("fov-not-halved", "The tangent is that of the field of view, not of its half.",
        [](V& s) {
          const double by = std::tan(s.fov / 2 * kDegree) / std::tan(s.fov * kDegree);
          s.scale(by, by);
        }),
    row("fov-horizontal", "The field of view is that of the width, not of the height.",
        [](V& s) { s.scale(s.aspect, s.aspect); }),
    row("v-is-VUP", "v is VUP itself, which is not made orthogonal to n.",
        [](V& s) { s.turn(rowOf(s.R, 0), glm::normalize(s.spec.vup), rowOf(s.R, 2)); }),
    row("VPN-reversed", "VPN points away from the eye.",
        [](V& s) { s.turn(-rowOf(s.R, 0), rowOf(s.R, 1), -rowOf(s.R, 2)); }),
    row("VPN-reversed", "VPN points away from the eye.",
        [](V& s) {
          s.turn(-rowOf(s.R, 0), rowOf(s.R, 1), -rowOf(s.R, 2));
          s.clips = false;
        }),
    row("eye-and-look-at-exchanged", "The eye and the look-at point are in each other's place.",
        [](V& s) {
          s.turn(-rowOf(s.R, 0), rowOf(s.R, 1), -rowOf(s.R, 2));
          s.from = s.lookAt;
        }),
    row("u-left-handed", "u is n x VUP, not VUP x n.",
        [](V& s) { s.turn(-rowOf(s.R, 0), rowOf(s.R, 1), rowOf(s.R, 2)); }),
    row("u-left-handed", "u is n x VUP, not VUP x n.",
        [](V& s) { s.turn(-rowOf(s.R, 0), -rowOf(s.R, 1), rowOf(s.R, 2)); }),
    row("shear-forgotten", "The shear is left out.", [](V& s) { s.SH = dmat4{1.0}; }),
    row("shear-negated", "The shear has the other sign.", [](V& s) { s.SH[2][0] *= -1, s.SH[2][1] *= -1; }),
    row("window-centre-forgotten", "The window's centre is taken for the origin.",
        [](V& s) {
          if (s.isPerspective())
            s.SH[2][0] = -s.prp.x / s.prp.z, s.SH[2][1] = -s.prp.y / s.prp.z;
          else
            s.T[3][0] = s.T[3][1] = 0;
        }),
    row(
        "viewport-half-pixel", "The picture lies half a pixel off.",
        [](V& s) {
          s.off = {0.5, 0.5};
        },
        true),
    row(
        "viewport-half-pixel", "The picture lies half a pixel off.",
        [](V& s) {
          s.off = {-0.5, -0.5};
        },
        true),
    row("viewport-one-short", "The viewport is a pixel less wide and high than the picture.",
        [](V& s) { s.size -= 1.0; }),
    row("viewport-one-short", "The viewport is a pixel less wide and high than the picture.",
        [](V& s) {
          s.size -= 1.0, s.off = {0.5, 0.5};
        }),
    row("flip-y", "The picture is upside down: y of the screen runs down.", [](V& s) { s.scale(1, -1); }),
    row("flip-x", "The picture is its mirror image.", [](V& s) { s.scale(-1, 1); }),
    row("turned-180", "The picture is turned by 180 degrees.", [](V& s) { s.scale(-1, -1); }),
    row("near-plane-negated", "The near plane has the other sign, so all that shows is clipped.",
        [](V& s) { s.showsNothing = true; }),
};

}  // namespace

std::span<const ViewMistake> viewMistakes() { return kRows; }

ViewSteps::ViewSteps(const Camera& camera, double unit, int width, int height)
    : spec{camera.view},
      eye{unit * camera.eye},
      lookAt{unit * camera.lookAt},
      prp{unit * spec.prp},
      size{width, height},
      aspect{static_cast<double>(width) / height} {
  spec.vrp *= unit, spec.prp *= unit, spec.windowMin *= unit, spec.windowMax *= unit;
  spec.front *= unit, spec.back *= unit;
  const ViewMatrices m = viewMatrices(spec);
  M = m.M, S = m.S, T = m.T, SH = m.SH, R = m.R;
  const dvec3 n = rowOf(R, 2), u = rowOf(R, 0), v = rowOf(R, 1);
  from = isPerspective() ? spec.vrp + prp.x * u + prp.y * v + prp.z * n : spec.vrp;
  fov = 2 * std::atan((spec.windowMax.y - spec.windowMin.y) / 2 / spec.prp.z) / kDegree;
}

dmat4 ViewSteps::vrcFromWorld() const { return view.value_or(R * moved(-from)); }
dmat4 ViewSteps::clipFromWorld() const { return all.value_or(clipFromVrc() * vrcFromWorld()); }

void ViewSteps::turn(const dvec3& u, const dvec3& v, const dvec3& n) {
  const std::array<dvec3, 3> rows{u, v, n};
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) R[c][k] = rows[k][c];
}

OtherView::OtherView(const ViewMistake& mistake, const Camera& camera, double unit, int width, int height)
    : steps_{camera, unit, width, height}, width_{width}, height_{height} {
  if (mistake.change) mistake.change(steps_);
  clip_ = steps_.clipFromWorld();
}

Placed OtherView::onScreen(const glm::dvec4& p) const {
  const double w = steps_.divides ? p.w : 1.0;
  if (w == 0.0) return {};
  const dvec3 q = dvec3{p} / w;
  return {{steps_.off.x + (q.x + 1) / 2 * steps_.size.x, steps_.off.y + (1 - q.y) / 2 * steps_.size.y, q.z},
          p.w,
          !steps_.clips || !steps_.divides || p.w > 0.0};
}

void OtherView::paint(std::vector<int>& shown, std::vector<double>& nearest, int number,
                      const std::vector<dvec3>& polygon) const {
  constexpr double kNear = 1e-3;  // of the distance of the back plane
  std::vector<glm::dvec4> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec4 a = clip_ * glm::dvec4{polygon[k], 1.0},
                     b = clip_ * glm::dvec4{polygon[(k + 1) % polygon.size()], 1.0};
    const bool clips = steps_.clips && steps_.divides;
    if (!clips || a.w >= kNear) kept.push_back(a);
    if (clips && (a.w >= kNear) != (b.w >= kNear)) kept.push_back(a + (kNear - a.w) / (b.w - a.w) * (b - a));
  }
  std::vector<dvec3> at;
  for (const glm::dvec4& p : kept) at.push_back(onScreen(p).at);
  for (std::size_t k = 1; k + 1 < at.size(); ++k) {
    const dvec3 &a = at[0], &b = at[k], &c = at[k + 1];
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0.0 || !std::isfinite(area)) continue;
    const auto first = [](double v, double least) {
      return static_cast<int>(std::ceil(std::clamp(v, least, 1e5) - 0.5));
    };
    const auto rows = std::minmax({a.y, b.y, c.y}), columns = std::minmax({a.x, b.x, c.x});
    for (int j = first(rows.first, 0.0); j < std::min(height_, first(rows.second, 0.0)); ++j)
      for (int i = first(columns.first, 0.0); i < std::min(width_, first(columns.second, 0.0)); ++i) {
        const double x = i + 0.5, y = j + 0.5;
        const double B = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area,
                     C = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
        if (B < 0.0 || C < 0.0 || B + C > 1.0) continue;
        const double z = a.z + B * (b.z - a.z) + C * (c.z - a.z);
        const std::size_t here = static_cast<std::size_t>(j) * width_ + i;
        if (z < nearest[here]) continue;
        nearest[here] = z, shown[here] = number;
      }
  }
}

}  // namespace xnewell
