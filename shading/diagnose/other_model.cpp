#include "shading/diagnose/other_model.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "geometry/exact/plane.h"
#include "geometry/exact/unit.h"
#include "geometry/view/screen_grid.h"
#include "shading/diagnose/other_view.h"
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
  const glm::dvec3 ambient = scene.light.Ia.value_or(glm::dvec3{user.Ia});
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

}  // namespace xnewell
