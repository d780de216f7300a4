#include "shading/diagnose/other_model.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "geometry/view/screen_grid.h"
#include "shading/diagnose/other_view.h"
#include "shading/light/depth_shading.h"
#include "shading/picture/scene_colors.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

glm::dvec3 unitOr0(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3{0.0};
}

bool isProjected(NormalWay way) {
  return way == NormalWay::Warped || way == NormalWay::WarpedDeep || way == NormalWay::WarpedInPixels;
}
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
  towardsViewer_ = unitOr0(camera.view.vpn);
  pixelsHigh_ = picture.settings().height / 2.0;
  const glm::dmat4 warp = canonicalFromVrc(camera.view);
  for (const glm::dvec3& p : scene.mesh.points) {
    const glm::dvec4 q = warp * glm::dvec4{rotation_ * (p - camera.view.vrp), 1.0};
    warped_.emplace_back(glm::dvec3{q} / q.w);
    deep_.push_back(glm::dot(unit * p - eye, towardsViewer_));
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
      return unitOr0(back * (scaling_ * (rotation_ * N)));
    case NormalWay::Scaled:
      return back * (glm::inverse(glm::transpose(scaling_)) * (rotation_ * N));
    case NormalWay::Inward:
      return -N;
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
  const glm::dvec3& first = points_[corners[0]];
  if (way == CentroidWay::FirstCorner) return first;
  glm::dvec3 sum{0.0};
  double weight = 0.0;
  if (way == CentroidWay::OfArea) {
    const glm::dvec3 N = faceNormal(face, NormalWay::Newell);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const glm::dvec3 a = points_[corners[k]] - first, b = points_[corners[k + 1]] - first;
      const double area = glm::dot(glm::cross(a, b), N);
      sum += area * (a + b) / 3.0, weight += area;
    }
    if (weight > 0.0) return first + sum / weight;
    sum = glm::dvec3{0.0};
  }
  for (const int point : corners) sum += points_[point] - first;
  return first + sum / static_cast<double>(corners.size());
}

/// The cross product of two sides of a triangle of points, where the way has it.
glm::dvec3 OtherModel::product(int a, int b, int c, NormalWay way) const {
  if (!isProjected(way)) return glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
  glm::dvec3 p = warped_[b] - warped_[a], q = warped_[c] - warped_[a];
  if (way != NormalWay::Warped)  // z is the distance along the viewing direction
    p.z = deep_[b] - deep_[a], q.z = deep_[c] - deep_[a];
  if (way == NormalWay::WarpedInPixels) {
    const double wide = pixelsHigh_ * picture_.settings().width / picture_.settings().height;
    p = {p.x * wide, p.y * pixelsHigh_, p.z}, q = {q.x * wide, q.y * pixelsHigh_, q.z};
  }
  return glm::cross(p, q);
}

glm::dvec3 OtherModel::faceNormal(int face, NormalWay way, int from) const {
  const auto corners = mesh().face(face);
  if (way == NormalWay::CornerProduct) return product(corners[0], corners[1], corners[2], way);
  const auto corner = [&](int k) { return corners[static_cast<std::size_t>(k) % corners.size()]; };
  if (way == NormalWay::ThreeCorners)
    return unitOr0(product(corner(from), corner(from + 1), corner(from + 2), way));
  glm::dvec3 sum{0.0};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += product(corners[0], corners[k], corners[k + 1], way);
  if (way == NormalWay::Newell) return sum;
  return mapped(way, unitOr0(sum));
}

std::vector<glm::dvec3> OtherModel::makeCornerNormals(VertexWay vertex, NormalWay normal) const {
  const bool own = isLong(normal) || isProjected(normal);
  const NormalWay base = own ? normal : NormalWay::Unit;
  std::vector<glm::dvec3> ofCorner(mesh().corners.size(), glm::dvec3{0.0});
  PictureSettings settings = picture_.settings();
  bool byRule = !own;
  switch (vertex) {
    case VertexWay::AsAsked:
      break;
    case VertexWay::Distinct:
      settings.normals = NormalRule::Distinct;
      break;
    case VertexWay::Area:
      settings.normals = NormalRule::Area;
      break;
    case VertexWay::Angle:
      settings.normals = NormalRule::Angle;
      break;
    case VertexWay::Patch:
      settings.normals = NormalRule::File;
      break;
    default:
      byRule = false;
  }
  if (byRule) {
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
            sums[point] += unitOr0(product(corners[0], corners[k], corners[k + 1], base));
    }
    for (std::size_t p = 0; p < sums.size(); ++p) {
      if (vertex == VertexWay::MeanNotUnit)
        sums[p] /= std::max(1.0, counts[p]);
      else if (vertex != VertexWay::SumNotUnit && !isLong(base))
        sums[p] = unitOr0(sums[p]);
    }
    for (int f = 0; f < mesh().faceCount(); ++f)
      for (int c = mesh().firstCorner[f]; c < mesh().firstCorner[f + 1]; ++c)
        ofCorner[c] = vertex == VertexWay::OwnFace ? faceNormal(f, base) : sums[mesh().corners[c]];
  }
  for (glm::dvec3& N : ofCorner) N = mapped(normal, N);
  return ofCorner;
}

const std::vector<glm::dvec3>& OtherModel::cornerNormals(VertexWay vertex, NormalWay normal) {
  const auto [at, isNew] = cornerNormals_.try_emplace({vertex, normal});
  if (isNew) at->second = makeCornerNormals(vertex, normal);
  return at->second;
}

}  // namespace xnewell
