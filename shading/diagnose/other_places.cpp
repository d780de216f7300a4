#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shading/diagnose/other_program.h"

namespace xnewell {

/// Where a sample lies: in which triangle of its face, and on which texel.

/// The corners of the polygon whose triangles count, in order; the first is the apex of the fan. It is the
/// part that the picture has; along the other diagonal it is the model's own face, which has parts if it is
/// bent.
std::vector<int> OtherProgram::fanOf(const SnappedFace& face) const {
  const SnappedScene& scene = model_.snapped();
  const Mesh& mesh = model_.mesh();
  std::vector<int> corners;
  const int first = mesh.firstCorner[face.number], end = mesh.firstCorner[face.number + 1];
  if (way_.otherDiagonal && face.count == 3 && end - first == 4)
    for (int c = first; c < end && model_.onScreen[c]; ++c) corners.push_back(c);
  if (corners.size() != 4) {
    corners.clear();
    for (int k = 0; k < face.count; ++k) corners.push_back(scene.source[face.first + k]);
    std::ranges::rotate(corners, std::ranges::min_element(corners));
  }
  if (way_.otherDiagonal) std::ranges::rotate(corners, corners.begin() + 1);
  return corners;
}

OtherProgram::InTriangle OtherProgram::triangle(const SnappedFace& face, int i, int j) const {
  const std::vector<int> fan = fanOf(face);
  const glm::dvec2 at{i + 0.5, j + 0.5};
  InTriangle best;
  double inside = -1e300;
  for (std::size_t k = 1; k + 1 < fan.size(); ++k) {
    const std::array<int, 3> corner{fan[0], fan[k], fan[k + 1]};
    std::array<double, 3> area{};
    for (int e = 0; e < 3; ++e) {
      const glm::dvec2 a = *model_.onScreen[corner[(e + 1) % 3]] - at,
                       b = *model_.onScreen[corner[(e + 2) % 3]] - at;
      area[e] = a.x * b.y - a.y * b.x;
    }
    const double whole = area[0] + area[1] + area[2];
    if (whole == 0.0) continue;
    for (double& a : area) a /= whole;
    const double least = std::min({area[0], area[1], area[2]});
    if (least <= inside) continue;
    inside = least;
    best.onScreen = area, best.corner = corner;
    double sum = 0.0;
    for (int e = 0; e < 3; ++e) {
      best.inWorld[e] = area[e] / model_.depth(model_.place(corner[e]));
      sum += best.inWorld[e];
    }
    for (double& w : best.inWorld) w /= sum;
  }
  return best;
}

std::optional<glm::ivec2> OtherProgram::texel(const SnappedFace& face, const InTriangle& in) const {
  const Mesh& mesh = model_.mesh();
  const int material = mesh.material[face.number];
  if (material < 0 || mesh.materials[material].texture < 0) return std::nullopt;
  const Texture& texture = model_.picture().scene().textures[mesh.materials[material].texture];
  glm::dvec2 uv{0.0};
  for (int k = 0; k < 3; ++k)
    uv += (way_.onScreen ? in.onScreen : in.inWorld)[k] * mesh.uv[mesh.uvOfCorner[in.corner[k]]];
  const double u = uv.x - std::floor(uv.x), v = uv.y - std::floor(uv.y);
  return glm::ivec2{std::min(static_cast<int>(u * texture.width), texture.width - 1),
                    std::clamp(static_cast<int>((1.0 - v) * texture.height), 0, texture.height - 1)};
}

int OtherProgram::texelAt(int face, int i, int j) {
  const SnappedFace& f = model_.snapped().faces[face];
  const int material = model_.mesh().material[f.number];
  if (material < 0 || model_.mesh().materials[material].texture < 0) return -1;
  const Texture& texture = model_.picture().scene().textures[model_.mesh().materials[material].texture];
  const auto here = texel(f, triangle(f, i, j));
  if (!here) return -1;
  const std::size_t k = static_cast<std::size_t>(here->y) * texture.width + here->x;
  return texture.channel[0][k] << 16 | texture.channel[1][k] << 8 | texture.channel[2][k];
}

}  // namespace xnewell
