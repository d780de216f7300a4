#include "shading/picture/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "geometry/exact/give_up.h"
#include "geometry/exact/scale.h"
#include "geometry/model/coplanar.h"

namespace xnewell {

namespace {

/// For each point, the first one with the same coordinates.
std::vector<int> placesOf(const std::vector<glm::dvec3>& points) {
  const auto place = [&](int p) { return std::tuple{points[p].x, points[p].y, points[p].z}; };
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int a, int b) { return std::pair{place(a), a} < std::pair{place(b), b}; });
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && place(order[k]) == place(order[k - 1]) ? first[order[k - 1]] : order[k];
  return first;
}

/// The key of an edge: the same for both orders of its ends.
std::uint64_t keyOf(int a, int b) {
  return std::uint64_t(std::max(a, b)) << 32 | static_cast<std::uint32_t>(std::min(a, b));
}

constexpr int kAlong = 8;  // steps of the samples along an edge
constexpr int kSamples = (kAlong + 1) * (kAlong + 2) / 2;
constexpr std::size_t kTogether = 64;  // triangles; the terms of their samples fit into the cache

/// A triangle and what shading knows about it.
struct Facet {
  std::array<glm::dvec3, 3> at{}, N{};  ///< at its corners; N of any length: made unit after interpolation
  glm::dvec3 centre{0};                 ///< the place that flat shading evaluates
  int material = -1;
};

/// The shares of the corners at each sample, a grid over the triangle.
const std::vector<glm::dvec3>& grid() {
  static const std::vector<glm::dvec3> shares = [] {
    std::vector<glm::dvec3> all;
    for (int i = 0; i <= kAlong; ++i)
      for (int j = 0; i + j <= kAlong; ++j) all.push_back(glm::dvec3{i, j, kAlong - i - j} / double(kAlong));
    return all;
  }();
  return shares;
}

/// For each facet, the most by which its shading differs from the illumination at a sample, in any channel,
/// for the front and the back. For Gouraud shading, it compares the interpolated I with the I of the
/// interpolated normal, made a unit vector as in Phong shading; for flat shading, the I of the centre with
/// the I of each place.
std::vector<double> misfitsOf(std::span<const Facet> facets, const Lighting& lighting, bool flat) {
  std::vector<double> most(facets.size(), 0.0);
  Terms diffuse, specular;
  Intensities intensities;
  for (std::size_t first = 0, end = 0; first < facets.size(); first = end) {
    MayGiveUp::check();
    end = std::min(facets.size(), first + kTogether);
    ShadingPoints samples;
    const auto add = [&](const glm::dvec3& at, const glm::dvec3& N, int material) {
      samples.at.push_back(at), samples.N.push_back(unit(N)), samples.material.push_back(material);
    };
    for (const Facet& f : facets.subspan(first, end - first)) {
      for (const glm::dvec3& share : grid())
        add(share.x * f.at[0] + share.y * f.at[1] + share.z * f.at[2],
            share.x * f.N[0] + share.y * f.N[1] + share.z * f.N[2], f.material);
      if (flat) add(f.centre, f.N[0], f.material);
    }
    for (int channel = 0; channel < lighting.channels; ++channel) {
      diffuseIntensities(diffuse, samples, lighting, channel);
      specularIntensities(specular, samples, lighting, channel);
      addTerms(intensities, diffuse, specular, samples, lighting, channel);
      const FrontBack<double>* I = intensities.I.data();
      for (std::size_t k = first; k < end; ++k, I += kSamples + flat) {
        // The grid has the corner with the first share alone last, and that with the third alone first.
        const FrontBack<double>&A = I[flat ? kSamples : kSamples - 1], &B = I[flat ? kSamples : kAlong],
              &C = I[flat ? kSamples : 0];
        for (int sample = 0; sample < kSamples; ++sample) {
          const glm::dvec3& share = grid()[sample];
          const auto apart = [&](double FrontBack<double>::*side) {
            return std::abs(I[sample].*side - (share.x * A.*side + share.y * B.*side + share.z * C.*side));
          };
          most[k] = std::max({most[k], apart(&FrontBack<double>::front), apart(&FrontBack<double>::back)});
        }
      }
    }
  }
  return most;
}

struct Triangle {
  std::array<int, 3> point{},
      corner{};  ///< `point` is the first one with its coordinates; `corner` is an index into Mesh::corners
  int part = 0;  ///< index into the parts before the division
  int halvings = 0;
  bool tested = false;
};

class Refiner {
 public:
  Refiner(const Mesh& mesh, const ConvexParts& parts, const Vertices* vertices, const ShadingPoints* faces,
          const Lighting& lighting, const RefineSettings& settings)
      : old_{parts}, faces_{faces}, settings_{settings}, lighting_{lighting}, divided_(parts.count(), false) {
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
  /// Orders edges by length, and edges of equal length by their ends: the same order for every triangle.
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
  const Lighting& lighting_;
  std::vector<bool> divided_;        ///< by part
  std::vector<Triangle> triangles_;  ///< in the order of their parts
  std::vector<glm::dvec3> N_;  ///< of vertices, as interpolated: not unit vectors, for their lengths matter
  /// The edges to cut in this round, by their keys: the point in the middle, or -1 until a triangle is cut
  /// there.
  std::unordered_map<std::uint64_t, int> marked_;
  std::unordered_map<std::uint64_t, int> verticesBetween_;  ///< by the key of two vertices; of this round
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
      t.part = k;
      for (int c = 0; c < 3; ++c) {
        const int corner = first + (apex + (c == 0 ? 0 : v + c - 1)) % count;
        t.point[c] = places[old_.corners[corner]];
        t.corner[c] = old_.from[corner];
      }
      // A triangle without area covers nothing. It is cut only where its neighbours are.
      const glm::dvec3 a = at(t.point[1]) - at(t.point[0]), b = at(t.point[2]) - at(t.point[0]);
      t.tested = glm::cross(a, b) == glm::dvec3{0.0};
      triangles_.push_back(t);
    }
  }
}

Facet Refiner::facet(const Triangle& t) const {
  const int face = old_.face[t.part];
  Facet f;
  f.material = result_.mesh.material[face];
  for (int c = 0; c < 3; ++c) {
    f.at[c] = at(t.point[c]);
    f.N[c] = flat() ? faces_->N[face] : N_[result_.vertices.ofCorner[t.corner[c]]];
  }
  if (flat()) f.centre = divided_[t.part] ? (f.at[0] + f.at[1] + f.at[2]) / 3.0 : faces_->at[face];
  return f;
}

/// Whether the middle differs from both ends in double precision.
bool Refiner::isHalvable(const Triangle& t, int edge) const {
  const glm::dvec3 &a = at(t.point[edge]), &b = at(t.point[(edge + 1) % 3]), middle = (a + b) / 2.0;
  return middle != a && middle != b;
}

/// Marks an edge. Returns whether it was halvable and not marked before.
bool Refiner::mark(const Triangle& t, int edge) {
  return isHalvable(t, edge) && marked_.try_emplace(keyOf(t, edge), -1).second;
}

/// Marks the longest edge of each triangle that misses. Returns whether there are any.
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
  const std::vector<double> misfits = misfitsOf(facets, lighting_, flat());
  for (std::size_t k = 0; k < tested.size(); ++k) {
    if (misfits[k] <= settings_.tolerance) continue;
    const Triangle& t = triangles_[tested[k]];
    const int edge = longest(t);
    if (t.halvings < settings_.halvings && isHalvable(t, edge))
      mark(t, edge);
    else
      result_.limit = RefineLimit::Halvings;
  }
  return !marked_.empty();
}

/// Marks the longest edge of each triangle that has a marked edge, until there are no more.
void Refiner::markLongest() {
  for (bool more = true; more;) {
    MayGiveUp::check();
    more = false;
    for (const Triangle& t : triangles_)
      if (isMarked(t, 0) || isMarked(t, 1) || isMarked(t, 2)) more |= mark(t, longest(t));
  }
}

/// Cuts all triangles at their marked edges, unless that makes too many. Returns whether it did.
bool Refiner::halve() {
  std::size_t count = triangles_.size();
  std::vector<bool> newlyDivided(old_.count(), false);
  for (const Triangle& t : triangles_) {
    const int cuts = isMarked(t, 0) + isMarked(t, 1) + isMarked(t, 2);
    count += cuts;
    if (cuts > 0 && !divided_[t.part]) newlyDivided[t.part] = true;
  }
  if (count > static_cast<std::size_t>(settings_.parts)) {
    result_.limit = RefineLimit::Parts;
    return false;
  }
  std::vector<Triangle> next;
  next.reserve(count);
  for (Triangle& t : triangles_) {
    // From now on each triangle of this fan is shaded at its own centroid.
    if (flat() && newlyDivided[t.part]) t.tested = false;
    cut(t, next);
  }
  for (int k = 0; k < old_.count(); ++k)
    if (newlyDivided[k]) divided_[k] = true;
  triangles_ = std::move(next);
  return true;
}

/// Cuts a triangle at its longest marked edge, then the halves at theirs. Each half has one of the other
/// edges.
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

/// Makes the parts from the triangles, and the points at which they are shaded.
void Refiner::collect() {
  ConvexParts& parts = result_.parts;
  parts.frame = old_.frame;
  int planes = 0;
  ShadingPoints& points = result_.points;
  auto next = triangles_.begin();
  for (int k = 0; k < old_.count(); ++k) {
    const int face = old_.face[k];
    // The plane of a part that is divided is no longer that of the corners of one part.
    if (old_.frame && old_.plane[k] == planes) {
      const ModelPlane* const found = old_.planes.find(planes);
      if (found || divided_[k]) parts.planes.add(planes, found ? *found : planeOf(result_.mesh, old_, k));
      ++planes;
    }
    const auto end = std::find_if(next, triangles_.end(), [&](const Triangle& t) { return t.part != k; });
    const auto finish = [&](const glm::dvec3& centre) {
      parts.firstCorner.push_back(static_cast<int>(parts.corners.size()));
      parts.face.push_back(face);
      parts.plane.push_back(old_.plane[k]);
      if (const ModelPlane* const own = old_.own.find(k)) parts.own.add(parts.count() - 1, *own);
      if (!flat()) return;
      points.at.push_back(centre);
      points.N.push_back(faces_->N[face]);
      points.material.push_back(faces_->material[face]);
    };
    if (divided_[k]) {
      for (; next != end; ++next) {
        parts.corners.insert(parts.corners.end(), next->point.begin(), next->point.end());
        parts.from.insert(parts.from.end(), next->corner.begin(), next->corner.end());
        finish((at(next->point[0]) + at(next->point[1]) + at(next->point[2])) / 3.0);
      }
    } else {
      const int first = old_.firstCorner[k], last = old_.firstCorner[k + 1];
      parts.corners.insert(parts.corners.end(), old_.corners.begin() + first, old_.corners.begin() + last);
      parts.from.insert(parts.from.end(), old_.from.begin() + first, old_.from.begin() + last);
      finish(flat() ? faces_->at[face] : glm::dvec3{0.0});
      next = end;
    }
  }
  if (!flat()) points = vertexPoints(result_.mesh, result_.vertices);
}

}  // namespace

Refined refineSmooth(const Mesh& mesh, const ConvexParts& parts, const Vertices& vertices,
                     const Lighting& lighting, const RefineSettings& settings) {
  return Refiner{mesh, parts, &vertices, nullptr, lighting, settings}.result();
}

Refined refineFlat(const Mesh& mesh, const ConvexParts& parts, const ShadingPoints& faces,
                   const Lighting& lighting, const RefineSettings& settings) {
  return Refiner{mesh, parts, nullptr, &faces, lighting, settings}.result();
}

}  // namespace xnewell
