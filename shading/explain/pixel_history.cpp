#include "shading/explain/pixel_history.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "geometry/exact/scale.h"

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

namespace {

/// What owns the sample of pixel (i, j).
class OwnersHere {
 public:
  OwnersHere(const Picture& picture, int i, int j)
      : picture_{picture}, scene_{picture.snapped()}, i_{i}, j_{j} {}

  /// The columns of row j that a face owns.
  [[nodiscard]] Columns columnsOf(int face) const {
    const SnappedFace& f = scene_.faces[face];
    Columns columns{0, 0};
    forEachSpan(&scene_.vertices[f.first], f.count, j_, picture_.settings().width, j_ + 1,
                [&](int, int from, int to) {
                  columns = {from, to};
                });
    return columns;
  }
  [[nodiscard]] bool owns(const Columns& columns) const { return columns.from <= i_ && i_ < columns.to; }
  [[nodiscard]] bool owns(const Fragment& fragment) const {
    Columns columns = columnsOf(fragment.face);
    if (!owns(columns) || fragment.piece < 0) return owns(columns);
    const Piece& piece = picture_.sorted().pieces[fragment.piece];
    if (j_ < piece.area.top || j_ >= piece.area.bottom) return false;
    return owns(PieceWalk{scene_, picture_.sorted(), piece}.within(j_, columns));
  }
  [[nodiscard]] double z(int face) const {
    const SnappedFace& f = scene_.faces[face];
    const std::int64_t x = std::int64_t{i_} * kGrid + kGrid / 2, y = std::int64_t{j_} * kGrid + kGrid / 2;
    return std::ldexp(depthAt(scene_.planes[f.plane], x, y), scene_.zShift - kGridBits);
  }

 private:
  const Picture& picture_;
  const SnappedScene& scene_;
  int i_, j_;
};

}  // namespace

PixelHistory historyOf(const Picture& picture, int i, int j) {
  const Picture complete = picture.withPlanes();
  const OwnersHere here{complete, i, j};
  std::vector<int> all;
  const int faces = static_cast<int>(complete.snapped().faces.size());
  for (int f = 0; f < faces; ++f)
    if (here.owns(here.columnsOf(f))) all.push_back(f);

  PixelHistory history;
  const auto add = [&](const Fragment& fragment) {
    history.painted.push_back({fragment, here.z(fragment.face)});
  };
  const int seen = picture.seen(j, j + 1).faces[static_cast<std::size_t>(i)];
  if (rowOf(picture.settings().order).bySample) {
    for (const int f : all) add({f});
    const auto shown = std::ranges::find(all, seen);
    if (shown != all.end()) history.shown = static_cast<int>(shown - all.begin());
  } else {
    for (const Fragment& fragment : picture.sorted().fragments)
      if (here.owns(fragment)) add(fragment);
    history.shown = static_cast<int>(history.painted.size()) - 1;
    std::set<int> painted;
    for (const PaintedHere& one : history.painted) painted.insert(one.fragment.face);
    history.notPainted = static_cast<int>(all.size() - painted.size());
  }
  for (const int f : all)
    if (history.nearest < 0 ||
        !(nearer(complete.snapped().planes[complete.snapped().faces[history.nearest].plane],
                 complete.snapped().planes[complete.snapped().faces[f].plane], i, j) > 0))
      history.nearest = f;
  if (history.nearest >= 0) history.check = checkOf(complete.snapped(), seen, history.nearest, i, j);
  return history;
}

}  // namespace xnewell
