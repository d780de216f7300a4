#include "geometry/view/scene_planes.h"

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <optional>
#include <stdexcept>

#include "geometry/model/coplanar.h"

namespace xnewell {

void PlaneTable::notMade() { throw std::logic_error{"a plane is read before it is made"}; }

ScenePlanes::ScenePlanes(SnappedScene& scene, const Mesh& mesh, const ConvexParts& parts,
                         const ViewSpec& view, int width, int height)
    : scene_{scene},
      mesh_{mesh},
      parts_{parts},
      size_{width, height},
      doubt_{view, width, height, scene.zShift},
      records_{view, width, height, scene.zShift} {
  std::size_t planes = 0;
  for (const SnappedFace& face : scene.faces) planes = std::max(planes, std::size_t(face.plane) + 1);
  std::vector<std::uint8_t> faces(planes);  // in each plane: 0, 1, or 2 for two or more
  for (const SnappedFace& face : scene.faces) faces[face.plane] += faces[face.plane] < 2;
  for (int f = 0; f < std::ssize(scene.faces); ++f) {
    SnappedFace& face = scene.faces[f];
    if (faces[face.plane] == 1) continue;
    face.throughVertices = false;
    shared_.emplace_back(face.plane, f);
  }
  std::ranges::sort(shared_);
  scene.planes.makeRoom(planes);
}

// The first face of a plane says where its record is needed.
void ScenePlanes::makeRecord(int f) {
  SnappedFace& asked = scene_.faces[f];
  const auto doubt = [&](int g, const ScreenPlane& record) {
    const double u = mesh_.roundingOf(scene_.faces[g].number);
    scene_.planes.setDoubt(g, doubt_.of(record, u), scene_.faces.size());
  };
  if (asked.throughVertices) {
    scene_.planes.set(asked.plane, planeThrough(&scene_.vertices[asked.first], 3));
    return doubt(f, scene_.planes[asked.plane]);
  }
  const std::pair alone{asked.plane, f};
  std::span<const std::pair<int, int>> together =
      std::ranges::equal_range(shared_, asked.plane, {}, &std::pair<int, int>::first);
  if (together.empty()) together = {&alone, 1};
  const SnappedFace& first = scene_.faces[together.front().second];
  const ModelPlane plane = planeOf(mesh_, parts_, first.part);
  const std::optional<ScreenPlane> ofModel = records_.of(plane, placeInPicture(first));
  std::vector<glm::ivec3> points;
  if (!ofModel)
    for (const auto& [_, g] : together)
      for (int k = 0; k < scene_.faces[g].count; ++k)
        points.push_back(scene_.vertices[scene_.faces[g].first + k]);
  const ScreenPlane record =
      ofModel ? *ofModel : planeThrough(points.data(), static_cast<int>(points.size()));
  scene_.planes.set(asked.plane, record);
  asked.throughVertices = !ofModel && together.size() == 1 && asked.count == 3;
  for (const auto& [_, g] : together) {
    const SnappedFace& member = scene_.faces[g];
    doubt(g, record);
    if (const ModelPlane* const own = parts_.own.find(member.part); ofModel && own)
      scene_.planes.setAhead(member.part, records_.ahead(*own, plane, placeInPicture(member)),
                             parts_.count());
  }
}

void ScenePlanes::makeAll() {
  for (const SnappedFace& face : scene_.faces) make(face);
}

glm::ivec2 ScenePlanes::placeInPicture(const SnappedFace& face) const {
  glm::ivec2 low = size_ * kGrid, high{0};
  for (int v = face.first; v < face.first + face.count; ++v) {
    const glm::ivec2 p{scene_.vertices[v]};
    low = glm::min(low, p), high = glm::max(high, p);
  }
  return glm::clamp(low / 2 + high / 2, glm::ivec2{0}, size_ * kGrid);
}

SnappedScene project(const Mesh& mesh, const ConvexParts& parts, const ViewSpec& view, int width, int height,
                     Cull cull) {
  SnappedScene scene = snap(mesh, parts, view, width, height, cull);
  ScenePlanes{scene, mesh, parts, view, width, height}.makeAll();
  return scene;
}

bool mayTouch(const SnappedScene& scene, const SnappedFace& front, const SnappedFace& behind, std::int64_t x,
              std::int64_t y) {
  const double zFront = depthAt(scene.planes[front.plane], x, y),
               zBehind = depthAt(scene.planes[behind.plane], x, y);
  const double doubt = scene.doubtOf(front).at(zFront) + scene.doubtOf(behind).at(zBehind),
               lead = zFront - zBehind;
  const double own =
      lead + scene.planes.ahead(front.part).at(x, y) - scene.planes.ahead(behind.part).at(x, y);
  return own <= doubt || (lead <= doubt && own <= 1.5 * doubt);
}

}  // namespace xnewell
