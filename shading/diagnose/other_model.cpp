#include "shading/diagnose/other_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/view/screen_plane.h"
#include "shading/light/depth_shading.h"
#include "shading/picture/scene_colors.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

bool isProjected(NormalWay way) { return NormalWay::Warped <= way && way <= NormalWay::WarpedInPixels; }
bool isLong(NormalWay way) { return way == NormalWay::Newell || way == NormalWay::CornerProduct; }

}  // namespace

OtherModel::OtherModel(const Picture& picture) : picture_{picture} {
  const Scene& scene = picture.scene();
  const Camera& camera = picture.camera();
  unit = std::ldexp(1.0, scene.exponent);
  for (const glm::dvec3& p : scene.mesh.points) points_.push_back(unit * p);
  eye = unit * camera.eye, lookAt = unit * camera.lookAt;
  glm::dvec3 low = points_.front(), high = low;
  for (const glm::dvec3& p : points_) low = glm::min(low, p), high = glm::max(high, p);
  centre = (low + high) / 2.0;
  rotation_ = vrcRotation(camera.view);
  const ViewSteps steps{camera, unit, picture.settings().width, picture.settings().height};
  scaling_ = glm::dmat3{steps.S * steps.SH};
  towardsViewer_ = xnewell::unit(camera.view.vpn);
  const glm::dvec3 halves{picture.settings().width / 2.0, picture.settings().height / 2.0, 1};
  const glm::dmat4 warp = canonicalFromVrc(camera.view);
  for (const glm::dvec3& p : scene.mesh.points) {
    const glm::dvec4 q = warp * glm::dvec4{rotation_ * (p - camera.view.vrp), 1.0};
    const glm::dvec3 warped = glm::dvec3{q} / q.w;
    const double deep = glm::dot(unit * p - eye, towardsViewer_);  // larger is nearer
    projected_[0].push_back(warped), projected_[1].emplace_back(warped.x, warped.y, deep);
    projected_[2].push_back(halves * projected_[1].back());
  }
  facesAt_.resize(points_.size());
  for (int f = 0; f < mesh().faceCount(); ++f)
    for (const int point : mesh().face(f)) facesAt_[point].push_back(f);

  const Illumination& user = picture.settings().light;
  lights = lightsOf(scene, user);
  for (Light& light : lights) light.position *= unit;
  const ColorPlan plan = planOf(scene, picture.settings());
  colors = plan != ColorPlan::OneHue, ramps = plan == ColorPlan::Hues;
  channels = isGray(scene) && !colors ? 1 : 3;
  luminance = channels == 3 && !colors;
  const glm::dvec3 ambient = ambientOf(scene.light, user);
  Ia = {ambient.r, ambient.g, ambient.b};
  const auto add = [&](const MeshMaterial& m) {
    surface.push_back({reflectionOf(m, user, 0), reflectionOf(m, user, 1), reflectionOf(m, user, 2)});
  };
  add(MeshMaterial{});
  for (const MeshMaterial& m : scene.mesh.materials) add(m);
  byDepth = depthIntensities(scene.mesh, picture.snapped(), camera.view);
}

const OtherModel::Places& OtherModel::placesOf(const ViewMistake* view) {
  const auto [at, isNew] = places_.try_emplace(view);
  Places& places = at->second;
  if (!isNew) return places;
  const PictureSettings& settings = picture_.settings();
  const std::size_t corners = mesh().corners.size();
  places.onScreen.resize(corners), places.depth.assign(corners, 1.0);
  if (view) {
    const OtherView other{*view, picture_.camera(), unit, settings.width, settings.height};
    for (std::size_t k = 0; k < corners; ++k) {
      const Placed p = other.placed(place(static_cast<int>(k)));
      if (p.shows) places.onScreen[k] = p.at;
      places.depth[k] = p.w;
    }
    return places;
  }
  const SnappedScene& seen = picture_.snapped();
  for (std::size_t k = 0; k < seen.vertices.size(); ++k)
    if (seen.source[k] >= 0)
      places.onScreen[seen.source[k]] = glm::dvec2{seen.vertices[k].x, seen.vertices[k].y} / double{kGrid};
  if (picture_.camera().view.projection == Projection::Perspective)
    for (std::size_t k = 0; k < corners; ++k)
      places.depth[k] = glm::dot(eye - place(static_cast<int>(k)), towardsViewer_);
  return places;
}

glm::dvec3 OtherModel::notMoved(const glm::dvec3& place, bool far, const glm::dvec3& P) const {
  const glm::dvec3 turned = glm::transpose(rotation_) * place;
  return far ? turned : turned - (P - eye);
}

/// What becomes of a normal in other coordinates.
glm::dvec3 OtherModel::mapped(NormalWay way, const glm::dvec3& N) const {
  const glm::dmat3 back = glm::transpose(rotation_);
  switch (way) {
    case NormalWay::InViewing:
      return rotation_ * N;
    case NormalWay::NotTurned:
      return back * N;
    case NormalWay::ByMatrix:
      return xnewell::unit(back * (scaling_ * (rotation_ * N)));
    case NormalWay::Scaled:
      return back * (glm::inverse(glm::transpose(scaling_)) * (rotation_ * N));
    default:
      return N;
  }
}

bool OtherModel::isBack(int face) const {
  const glm::dvec3 N = faceNormal(face, NormalWay::Newell);
  const bool parallel = picture_.camera().view.projection == Projection::Parallel;
  return glm::dot(N, parallel ? towardsViewer_ : eye - points_[mesh().face(face)[0]]) < 0.0;
}

glm::dvec3 OtherModel::centroid(int face, CentroidWay way) const {
  const auto corners = mesh().face(face);
  if (way == CentroidWay::FirstCorner) return points_[corners[0]];
  if (way == CentroidWay::OfArea) return xnewell::centroid(points_, corners);
  glm::dvec3 sum{0.0};
  for (const int point : corners) sum += points_[point];
  return sum / static_cast<double>(corners.size());
}

const std::vector<glm::dvec3>& OtherModel::pointsFor(NormalWay way) const {
  return isProjected(way) ? projected_[static_cast<int>(way) - static_cast<int>(NormalWay::Warped)] : points_;
}

glm::dvec3 OtherModel::faceNormal(int face, NormalWay way, int from) const {
  const auto corners = mesh().face(face);
  const std::vector<glm::dvec3>& points = pointsFor(way);
  const auto corner = [&](int k) { return points[corners[static_cast<std::size_t>(k) % corners.size()]]; };
  if (way == NormalWay::CornerProduct || way == NormalWay::ThreeCorners) {
    const glm::dvec3 product = glm::cross(corner(from + 1) - corner(from), corner(from + 2) - corner(from));
    return way == NormalWay::CornerProduct ? product : xnewell::unit(product);
  }
  const glm::dvec3 sum = newellVector(points, corners);
  return way == NormalWay::Newell ? sum : mapped(way, xnewell::unit(sum));
}

std::vector<glm::dvec3> OtherModel::makeCornerNormals(const Approach& way) const {
  const bool own = isLong(way.normal) || isProjected(way.normal);
  const VertexWay vertex = way.vertex;
  const NormalWay base = own ? way.normal : NormalWay::Unit;
  std::vector<glm::dvec3> ofCorner(mesh().corners.size(), glm::dvec3{0.0});
  if (!own && vertex == VertexWay::AsAsked) {
    PictureSettings settings = picture_.settings();
    settings.normals = way.rule.value_or(settings.normals);
    const Vertices made = smoothVertices(picture_.scene(), settings);
    for (std::size_t k = 0; k < ofCorner.size(); ++k) ofCorner[k] = made.vertices[made.ofCorner[k]].N;
  } else {
    std::vector<glm::dvec3> sums(points_.size(), glm::dvec3{0.0});
    std::vector<double> counts(points_.size(), 0.0);
    for (int f = 0; f < mesh().faceCount(); ++f) {
      const glm::dvec3 N = faceNormal(f, base);
      const auto corners = mesh().face(f);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        counts[corners[k]] += 1.0;
        if (vertex == VertexWay::TrianglesTwice) continue;
        if (vertex == VertexWay::LastFace)
          sums[corners[k]] = N;
        else
          sums[corners[k]] += N;
      }
      if (vertex == VertexWay::TrianglesTwice)
        for (std::size_t k = 1; k + 1 < corners.size(); ++k)
          for (const int point : {corners[0], corners[k], corners[k + 1]})
            sums[point] += xnewell::unit(
                newellVector(pointsFor(base), std::array{corners[0], corners[k], corners[k + 1]}));
    }
    for (std::size_t p = 0; p < sums.size(); ++p) {
      if (vertex == VertexWay::MeanNotUnit)
        sums[p] /= std::max(1.0, counts[p]);
      else if (vertex != VertexWay::SumNotUnit && !isLong(base))
        sums[p] = xnewell::unit(sums[p]);
    }
    for (int f = 0; f < mesh().faceCount(); ++f)
      for (int c = mesh().firstCorner[f]; c < mesh().firstCorner[f + 1]; ++c)
        ofCorner[c] = vertex == VertexWay::OwnFace ? faceNormal(f, base) : sums[mesh().corners[c]];
  }
  for (glm::dvec3& N : ofCorner) N = mapped(way.normal, N);
  return ofCorner;
}

const std::vector<glm::dvec3>& OtherModel::cornerNormals(const Approach& way) {
  const auto [at, isNew] = cornerNormals_.try_emplace({way.rule, way.vertex, way.normal});
  if (isNew) at->second = makeCornerNormals(way);
  return at->second;
}

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
