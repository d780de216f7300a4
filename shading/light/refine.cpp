#include "shading/light/refine.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "geometry/exact/unit.h"
#include "shading/light/misfit.h"

namespace xnewell {

namespace {

/// Of each point the first at its place.
std::vector<int> placesOf(const std::vector<glm::dvec3>& points) {
  const auto place = [&](int p) { return std::tuple{points[p].x, points[p].y, points[p].z}; };
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int a, int b) { return std::pair{place(a), a} < std::pair{place(b), b}; });
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && place(order[k]) == place(order[k - 1]) ? first[order[k - 1]] : order[k];
  return first;
}

/// What two ends have in common, in either order.
std::uint64_t keyOf(int a, int b) {
  return std::uint64_t(std::max(a, b)) << 32 | static_cast<std::uint32_t>(std::min(a, b));
}

struct Triangle {
  std::array<int, 3> point{}, corner{};  ///< of places the first point; index into Mesh::corners
  int piece = 0;                         ///< index into the pieces that are divided
  int halvings = 0;
  bool tested = false;
};

class Refiner {
 public:
  Refiner(const Mesh& mesh, const ConvexParts& pieces, const Vertices* vertices, const ShadingPoints* faces,
          const Lighting& lighting, const RefineSettings& settings)
      : old_{pieces},
        faces_{faces},
        settings_{settings},
        misfit_{lighting, faces != nullptr, settings.tolerance},
        divided_(pieces.count(), false) {
    result_.mesh = mesh;
    if (vertices != nullptr) {
      result_.vertices = *vertices;
      for (const Vertex& v : vertices->vertices) N_.push_back(v.N);
    }
    cutFans();
    while (markMissed()) {
      markLongest();
      if (!halve()) break;
    }
    collect();
  }

  [[nodiscard]] Refined result() && { return std::move(result_); }

 private:
  [[nodiscard]] bool flat() const { return faces_ != nullptr; }
  [[nodiscard]] const glm::dvec3& at(int point) const { return result_.mesh.points[point]; }
  [[nodiscard]] static std::uint64_t keyOf(const Triangle& t, int edge) {
    return xnewell::keyOf(t.point[edge], t.point[(edge + 1) % 3]);
  }
  /// By length, of equal ones by their ends: for all who have it.
  [[nodiscard]] std::pair<double, std::uint64_t> rank(const Triangle& t, int edge) const {
    const glm::dvec3 along = at(t.point[(edge + 1) % 3]) - at(t.point[edge]);
    return {glm::dot(along, along), keyOf(t, edge)};
  }
  [[nodiscard]] int longest(const Triangle& t) const {
    int edge = 0;
    for (const int other : {1, 2})
      if (rank(t, other) > rank(t, edge)) edge = other;
    return edge;
  }
  [[nodiscard]] bool isMarked(const Triangle& t, int edge) const { return marked_.contains(keyOf(t, edge)); }

  void cutFans();
  [[nodiscard]] Facet facet(const Triangle& t) const;
  [[nodiscard]] bool isHalvable(const Triangle& t, int edge) const;
  bool mark(const Triangle& t, int edge);
  bool markMissed();
  void markLongest();
  bool halve();
  void cut(const Triangle& t, std::vector<Triangle>& into);
  int middlePoint(const Triangle& t, int edge);
  int middleVertex(int a, int b, int point);
  int middleCorner(const Triangle& t, int edge);
  void collect();

  const ConvexParts& old_;
  const ShadingPoints* faces_;
  RefineSettings settings_;
  Misfit misfit_;
  std::vector<bool> divided_;        ///< by piece
  std::vector<Triangle> triangles_;  ///< in order of their pieces
  std::vector<glm::dvec3> N_;        ///< of vertices, as interpolated: their lengths matter
  /// Edges to be cut in this round, by their ends: the point in the middle, -1 until a triangle is cut there.
  std::unordered_map<std::uint64_t, int> marked_;
  std::unordered_map<std::uint64_t, int> verticesBetween_;  ///< by two vertices; of this round
  Refined result_;
};

void Refiner::cutFans() {
  const std::vector<int> places = placesOf(result_.mesh.points);
  for (int k = 0; k < old_.count(); ++k) {
    const int first = old_.firstCorner[k], count = old_.firstCorner[k + 1] - first;
    const auto from = old_.from.begin() + first;
    const int apex = static_cast<int>(std::min_element(from, from + count) - from);
    for (int v = 1; v + 1 < count; ++v) {
      Triangle t;
      t.piece = k;
      for (int c = 0; c < 3; ++c) {
        const int corner = first + (apex + (c == 0 ? 0 : v + c - 1)) % count;
        t.point[c] = places[old_.corners[corner]];
        t.corner[c] = old_.from[corner];
      }
      // What has no area covers nothing; it is cut where its neighbours are.
      const glm::dvec3 a = at(t.point[1]) - at(t.point[0]), b = at(t.point[2]) - at(t.point[0]);
      t.tested = glm::cross(a, b) == glm::dvec3{0.0};
      triangles_.push_back(t);
    }
  }
}

Facet Refiner::facet(const Triangle& t) const {
  const int face = old_.face[t.piece];
  Facet f;
  f.material = result_.mesh.material[face];
  for (int c = 0; c < 3; ++c) {
    f.at[c] = at(t.point[c]);
    f.N[c] = flat() ? faces_->N[face] : N_[result_.vertices.ofCorner[t.corner[c]]];
  }
  if (flat()) f.centre = divided_[t.piece] ? (f.at[0] + f.at[1] + f.at[2]) / 3.0 : faces_->at[face];
  return f;
}

/// Whether doubles hold a place between the ends.
bool Refiner::isHalvable(const Triangle& t, int edge) const {
  const glm::dvec3 &a = at(t.point[edge]), &b = at(t.point[(edge + 1) % 3]), middle = (a + b) / 2.0;
  return middle != a && middle != b;
}

/// Whether it was not marked before.
bool Refiner::mark(const Triangle& t, int edge) {
  return isHalvable(t, edge) && marked_.try_emplace(keyOf(t, edge), -1).second;
}

/// Marks the longest edges of the triangles that miss; whether there are any.
bool Refiner::markMissed() {
  marked_.clear();
  verticesBetween_.clear();
  std::vector<Facet> facets;
  std::vector<int> tested;
  for (std::size_t k = 0; k < triangles_.size(); ++k)
    if (!std::exchange(triangles_[k].tested, true)) {
      tested.push_back(static_cast<int>(k));
      facets.push_back(facet(triangles_[k]));
    }
  const std::vector<bool> missed = misfit_(facets);
  for (std::size_t k = 0; k < tested.size(); ++k) {
    if (!missed[k]) continue;
    const Triangle& t = triangles_[tested[k]];
    const int edge = longest(t);
    if (t.halvings < settings_.halvings && isHalvable(t, edge))
      mark(t, edge);
    else
      result_.limit = RefineLimit::Halvings;
  }
  return !marked_.empty();
}

/// Where any edge of a triangle is marked, its longest is.
void Refiner::markLongest() {
  for (bool more = true; more;) {
    more = false;
    for (const Triangle& t : triangles_)
      if (isMarked(t, 0) || isMarked(t, 1) || isMarked(t, 2)) more |= mark(t, longest(t));
  }
}

/// Cuts all triangles at their marked edges, unless that would be too many.
bool Refiner::halve() {
  std::size_t count = triangles_.size();
  std::vector<bool> newlyDivided(old_.count(), false);
  for (const Triangle& t : triangles_) {
    const int cuts = isMarked(t, 0) + isMarked(t, 1) + isMarked(t, 2);
    count += cuts;
    if (cuts > 0 && !divided_[t.piece]) newlyDivided[t.piece] = true;
  }
  if (count > static_cast<std::size_t>(settings_.pieces)) {
    result_.limit = RefineLimit::ConvexParts;
    return false;
  }
  std::vector<Triangle> next;
  next.reserve(count);
  for (Triangle& t : triangles_) {
    // The rest of a fan has its own centroids from now on.
    if (flat() && newlyDivided[t.piece]) t.tested = false;
    cut(t, next);
  }
  for (int k = 0; k < old_.count(); ++k)
    if (newlyDivided[k]) divided_[k] = true;
  triangles_ = std::move(next);
  return true;
}

/// From the longest marked edge on; each half then has one of the others.
void Refiner::cut(const Triangle& t, std::vector<Triangle>& into) {
  int edge = -1;
  for (int other = 0; other < 3; ++other)
    if (isMarked(t, other) && (edge < 0 || rank(t, other) > rank(t, edge))) edge = other;
  if (edge < 0) {
    into.push_back(t);
    return;
  }
  const int point = middlePoint(t, edge), corner = middleCorner(t, edge), end = (edge + 1) % 3;
  Triangle a = t, b = t;
  a.point[end] = b.point[edge] = point;
  a.corner[end] = b.corner[edge] = corner;
  a.halvings = b.halvings = t.halvings + 1;
  a.tested = b.tested = false;
  cut(a, into);
  cut(b, into);
}

int Refiner::middlePoint(const Triangle& t, int edge) {
  int& point = marked_.find(keyOf(t, edge))->second;
  if (point < 0) {
    point = static_cast<int>(result_.mesh.points.size());
    const glm::dvec3 middle = (at(t.point[edge]) + at(t.point[(edge + 1) % 3])) / 2.0;
    result_.mesh.points.push_back(middle);
  }
  return point;
}

int Refiner::middleVertex(int a, int b, int point) {
  const int next = static_cast<int>(N_.size());
  const auto [known, isNew] = verticesBetween_.try_emplace(xnewell::keyOf(a, b), next);
  if (isNew) {
    N_.push_back((N_[a] + N_[b]) / 2.0);
    result_.vertices.vertices.push_back({point, result_.vertices.vertices[a].material, unit(N_.back())});
  }
  return known->second;
}

int Refiner::middleCorner(const Triangle& t, int edge) {
  Mesh& mesh = result_.mesh;
  const int a = t.corner[edge], b = t.corner[(edge + 1) % 3];
  const int corner = static_cast<int>(mesh.corners.size()), point = middlePoint(t, edge);
  mesh.corners.push_back(point);
  if (!mesh.uvOfCorner.empty()) {
    const int u = mesh.uvOfCorner[a], v = mesh.uvOfCorner[b];
    mesh.uvOfCorner.push_back(u < 0 || v < 0 ? -1 : static_cast<int>(mesh.uv.size()));
    if (u >= 0 && v >= 0) mesh.uv.push_back((mesh.uv[u] + mesh.uv[v]) / 2.0);
  }
  std::vector<int>& vertexOf = result_.vertices.ofCorner;
  if (!flat()) vertexOf.push_back(middleVertex(vertexOf[a], vertexOf[b], point));
  return corner;
}

/// ConvexParts from triangles, and where to shade them.
void Refiner::collect() {
  ConvexParts& pieces = result_.pieces;
  ShadingPoints& points = result_.points;
  auto next = triangles_.begin();
  for (int k = 0; k < old_.count(); ++k) {
    const int face = old_.face[k];
    const auto end = std::find_if(next, triangles_.end(), [&](const Triangle& t) { return t.piece != k; });
    const auto finish = [&](const glm::dvec3& centre) {
      pieces.firstCorner.push_back(static_cast<int>(pieces.corners.size()));
      pieces.face.push_back(face);
      pieces.plane.push_back(old_.plane[k]);
      if (!flat()) return;
      points.at.push_back(centre);
      points.N.push_back(faces_->N[face]);
      points.material.push_back(faces_->material[face]);
    };
    if (divided_[k]) {
      for (; next != end; ++next) {
        pieces.corners.insert(pieces.corners.end(), next->point.begin(), next->point.end());
        pieces.from.insert(pieces.from.end(), next->corner.begin(), next->corner.end());
        finish((at(next->point[0]) + at(next->point[1]) + at(next->point[2])) / 3.0);
      }
    } else {
      const int first = old_.firstCorner[k], last = old_.firstCorner[k + 1];
      pieces.corners.insert(pieces.corners.end(), old_.corners.begin() + first, old_.corners.begin() + last);
      pieces.from.insert(pieces.from.end(), old_.from.begin() + first, old_.from.begin() + last);
      finish(flat() ? faces_->at[face] : glm::dvec3{0.0});
      next = end;
    }
  }
  if (!flat()) points = vertexPoints(result_.mesh, result_.vertices);
}

}  // namespace

Refined refineSmooth(const Mesh& mesh, const ConvexParts& pieces, const Vertices& vertices,
                     const Lighting& lighting, const RefineSettings& settings) {
  return Refiner{mesh, pieces, &vertices, nullptr, lighting, settings}.result();
}

Refined refineFlat(const Mesh& mesh, const ConvexParts& pieces, const ShadingPoints& faces,
                   const Lighting& lighting, const RefineSettings& settings) {
  return Refiner{mesh, pieces, nullptr, &faces, lighting, settings}.result();
}

}  // namespace xnewell
