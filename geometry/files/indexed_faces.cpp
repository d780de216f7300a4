#include "geometry/files/indexed_faces.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "geometry/exact/scale.h"
#include "geometry/files/parse_error.h"

namespace xnewell {

void IndexedFaces::add(std::span<const int> corners, const std::optional<glm::dvec3>& color) {
  if (corners.size() < 3) {
    ++small_;
    return;
  }
  int material = -1;
  if (color && materials_.size() <= kMostColors) {
    const glm::dvec3 c = glm::clamp(*color, 0.0, 1.0);
    material = materials_.try_emplace({c.r, c.g, c.b}, static_cast<int>(materials_.size())).first->second;
    if (material == static_cast<int>(mesh.materials.size()))
      mesh.materials.push_back({.name = "", .diffuse = c});
  }
  ofCorners_.clear();
  if (!normals.empty())
    for (const int corner : corners) ofCorners_.push_back(unit(normals[corner]));
  mesh.addFace(corners, 0, material, mesh.uv.empty() ? std::span<const int>{} : corners, ofCorners_);
}

Mesh IndexedFaces::take(const std::string& name, double rounding) {
  const std::string small =
      std::to_string(small_) + (small_ == 1 ? " face has" : " faces have") + " fewer than three corners";
  if (mesh.faceCount() == 0)
    throw ParseError{name, 0, small_ == 0 ? "holds no face" : "holds no face; " + small};
  const auto note = [&](const std::string& what) {
    mesh.notes.emplace_back(ParseError{name, 0, what}.what());
  };
  if (small_ > 0) note(small + (small_ == 1 ? ": it is left out" : ": they are left out"));
  if (materials_.size() > kMostColors) {
    note("the faces have more than " + std::to_string(kMostColors) + " colours: all faces are white");
    mesh.materials.clear();
    std::ranges::fill(mesh.material, -1);
  }
  if (mesh.uvOfCorner.empty()) mesh.uv.clear();
  mesh.groupNames = {"default"};
  mesh.rounding = {rounding};
  return std::move(mesh);
}

}  // namespace xnewell
