#include "shading/explain/on_face.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact/unit.h"

namespace xnewell {

OnFace::OnFace(const Surfaces& surfaces, const SnappedFace& face)
    : s_{surfaces}, face_{face}, evaluator_{s_, 0} {
  if (!byRows()) return;
  for (int k = 0; k < face_.count; ++k) vertices_.push_back(face_.first + k);
}

bool OnFace::isTextured() const {
  const Shading method = s_.settings.shading;
  return rowOf(method).lit && method != Shading::Environment && !onlyAmbient() && material() >= 0 &&
         s_.mesh.materials[material()].texture >= 0;
}

bool OnFace::byRows() const {
  return s_.settings.shading == Shading::Gouraud && !isTextured() && s_.settings.polygons == Polygons::Rows &&
         face_.count > 3;
}

void OnFace::moveTo(int i, int j) {
  i_ = i, j_ = j;
  if (byRows()) return;
  const FaceTriangle triangle = triangleAt(s_.snapped, face_, i, j);
  vertices_.assign(triangle.vertex.begin(), triangle.vertex.end());
  onScreen_ = weightsOnScreen(triangle.p, i, j);
  inWorld_ = weightsInWorld(onScreen_, evaluator_.overDepths(triangle));
}

glm::dvec3 OnFace::normalOf(int corner) const {
  if (onlyAmbient()) return glm::dvec3{0.0};
  return s_.side(face_) * s_.shading.points().N[s_.shading.vertices().ofCorner[corner]];
}

OnFace::Centroid OnFace::centroid() const {
  const ShadingPoints& points = s_.shading.points();
  if (points.at.empty()) return {};
  const int point = s_.shading.pointOf(face_);
  return {points.at[point], s_.side(face_) * points.N[point]};
}

glm::dvec3 OnFace::sumOfNormals() const {
  glm::dvec3 sum{0.0};
  for (int k = 0; k < 3; ++k)
    sum += ofNormals()[k] * atVertex(vertices_[k], [&](int corner) { return normalOf(corner); });
  return sum;
}

glm::dvec3 OnFace::normal() const {
  return keepsLengthOfN(s_.settings) ? sumOfNormals() : unit(sumOfNormals());
}

glm::dvec3 OnFace::place() const {
  glm::dvec3 P{0.0};
  for (int k = 0; k < 3; ++k)
    P += inWorld_[k] * atVertex(vertices_[k], [&](int corner) { return placeOf(corner); });
  return P;
}

ExplainedTexel OnFace::texel(int channels) const {
  ExplainedTexel texel;
  glm::dvec2 uv{0.0};
  for (int k = 0; k < 3; ++k)
    uv += inWorld_[k] *
          atVertex(vertices_[k], [&](int corner) { return s_.mesh.uv[s_.mesh.uvOfCorner[corner]]; });
  const Texture& texture = s_.scene.textures[s_.mesh.materials[material()].texture];
  // v runs up the columns, and rows run down. The texture repeats.
  const auto at = [](double share, int size) { return std::min(static_cast<int>(share * size), size - 1); };
  texel.u = uv.x, texel.v = uv.y;
  texel.column = at(uv.x - std::floor(uv.x), texture.width);
  texel.row = at(1.0 - (uv.y - std::floor(uv.y)), texture.height);
  const auto k = static_cast<std::size_t>(texel.row) * texture.width + texel.column;
  for (int c = 0; c < channels; ++c)
    texel.share[c] = (channels == 3 ? texture.channel[c][k] : texture.gray[k]) / 255.0;
  return texel;
}

}  // namespace xnewell
