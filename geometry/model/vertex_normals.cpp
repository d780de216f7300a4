#include "geometry/model/vertex_normals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"

namespace xnewell {

namespace {

constexpr double kMostDoubt = 0x1p-10;  ///< limit of FaceNormal::doubt, however coarse the rounding
/// a sum this small, relative to its terms, is all rounding; also the slack of cosines
constexpr double kRoundingOnly = 0x1p-40;

struct FaceNormal {
  glm::dvec3 N{0.0};
  double area = 0.0;   ///< twice the area
  double doubt = 0.0;  ///< bound of |N - true normal| from the rounding of the coordinates
};

/// One term of the sum at a point.
struct Term {
  glm::dvec3 N{0.0};
  double weight = 0.0;
};

/// A corner of a face, in the list of its point.
struct Corner {
  int corner = 0, face = 0;
};

/// The normals at one point that are equal to the first of them.
struct EqualNormals {
  const FaceNormal* first;
  double key;  ///< the sort key of the first; see collectDistinct()
  glm::dvec3 vectorArea{0.0};
};

class VertexNormals {
 public:
  VertexNormals(const Mesh& mesh, NormalRule rule, double creaseDegrees, std::span<const glm::dvec3> exact)
      : mesh_{mesh},
        rule_{rule},
        hasExact_{rule == NormalRule::Exact || rule == NormalRule::File},
        countsEqualOnce_{rule == NormalRule::Distinct || hasExact_},
        leastCosine_{sinCosDegrees(creaseDegrees).cos - kRoundingOnly},
        leastCosineOfHalf_{sinCosDegrees(creaseDegrees / 2.0).cos},
        exact_{exact} {
    measureFaces();
    listCorners();
  }

  [[nodiscard]] Vertices vertices() {
    Vertices result;
    result.vertices.reserve(mesh_.points.size());
    result.ofCorner.resize(mesh_.corners.size());
    const int points = static_cast<int>(mesh_.points.size());
    for (int p = 0; p < points; ++p) {
      const std::span<const Corner> corners{listed_.data() + firstListed_[p],
                                            listed_.data() + firstListed_[p + 1]};
      if (corners.empty()) continue;
      if (!hasExact_ || std::ranges::any_of(corners, [&](const Corner& c) { return !isExact(c); }))
        collectTerms(corners);
      const std::size_t firstHere = result.vertices.size();
      for (const Corner& c : corners) {
        const Vertex vertex{p, mesh_.material[c.face], normalAt(c) + 0.0};  // turns -0 into 0
        std::size_t v = firstHere;
        while (v < result.vertices.size() && !(result.vertices[v] == vertex)) ++v;
        if (v == result.vertices.size()) result.vertices.push_back(vertex);
        result.ofCorner[c.corner] = static_cast<int>(v);
      }
    }
    return result;
  }

 private:
  /// If a corner moves by d, the Newell vector changes by d x (the next corner - the previous corner). So all
  /// corners together turn the vector by at most 2 d perimeter / its length. Here d is the rounding of the
  /// file, half a unit on each axis, plus that of doubles, as in divideFaces().
  void measureFaces() {
    double magnitude = 0.0;
    for (const glm::dvec3& p : mesh_.points) magnitude = std::max(magnitude, largest(glm::abs(p)));
    faces_.resize(mesh_.faceCount());
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      const std::span<const int> corners = mesh_.face(f);
      const glm::dvec3 v = newellVector(mesh_.points, corners);
      FaceNormal& face = faces_[f];
      face.N = unit(v);
      face.area = glm::dot(face.N, v);
      if (face.area == 0.0 || !countsEqualOnce_) continue;
      double perimeter = 0.0;
      glm::dvec3 last = mesh_.points[corners.back()];
      for (const int c : corners) {
        perimeter += glm::length(mesh_.points[c] - last);
        last = mesh_.points[c];
      }
      const double shift = std::sqrt(3.0) * mesh_.roundingOf(f) + 0x1p-50 * magnitude;
      face.doubt = std::min(kMostDoubt, 2.0 * shift * (perimeter / face.area));
    }
  }

  /// Lists the corners of each point, in file order.
  void listCorners() {
    firstListed_.assign(mesh_.points.size() + 1, 0);
    for (const int p : mesh_.corners) ++firstListed_[p + 1];
    for (std::size_t p = 1; p < firstListed_.size(); ++p) firstListed_[p] += firstListed_[p - 1];
    listed_.resize(mesh_.corners.size());
    std::vector<int> next(firstListed_.begin(), firstListed_.end() - 1);
    for (int f = 0; f < mesh_.faceCount(); ++f)
      for (int c = mesh_.firstCorner[f]; c < mesh_.firstCorner[f + 1]; ++c)
        listed_[next[mesh_.corners[c]]++] = {c, f};
  }

  /// Collects the terms to sum at a point, and their sum if it is the same for all corners there.
  void collectTerms(std::span<const Corner> corners) {
    terms_.clear();
    if (countsEqualOnce_) {
      collectDistinct(corners);
    } else {
      int lastFace = -1;
      for (const Corner& c : corners) {
        const bool again = c.face == std::exchange(lastFace, c.face);
        const FaceNormal& face = faces_[c.face];
        if (face.area == 0.0) continue;
        if (again && rule_ != NormalRule::Angle) continue;
        Term& term = terms_.emplace_back();
        term.N = face.N;
        term.weight = rule_ == NormalRule::Angle  ? interiorAngle(c)
                      : rule_ == NormalRule::Area ? face.area
                                                  : 1.0;
      }
    }
    // Two normals that are within half the crease of a third are within the crease of each other.
    smooth_ = leastCosine_ <= -1.0 || std::ranges::all_of(terms_, [&](const Term& t) {
                return glm::dot(t.N, terms_.front().N) >= leastCosineOfHalf_;
              });
    common_ = normalisedSum([](const Term&) { return true; });
  }

  /// Collects the equal normals. Equal normals have nearly the same component along any direction. So the
  /// faces are sorted by this component, and a face finds its equals among the few before it. The direction
  /// is one that is unlikely to be the axis of a cone.
  void collectDistinct(std::span<const Corner> corners) {
    constexpr glm::dvec3 kDirection{0.48, 0.6, 0.64};
    sorted_.clear();
    for (const Corner& c : corners)
      if (faces_[c.face].area > 0.0) sorted_.emplace_back(glm::dot(faces_[c.face].N, kDirection), c.face);
    std::ranges::sort(sorted_);
    equal_.clear();
    for (const auto& entry : sorted_) {
      const double key = entry.first;
      const FaceNormal& face = faces_[entry.second];
      const double within = face.doubt + kMostDoubt;
      const auto found = std::find_if(equal_.rbegin(), equal_.rend(), [&](const EqualNormals& e) {
        return key - e.key > within || equal(face, *e.first);
      });
      const bool isNew = found == equal_.rend() || key - found->key > within;
      EqualNormals& mine = isNew ? equal_.emplace_back(EqualNormals{&face, key}) : *found;
      mine.vectorArea += face.area * face.N;
    }
    for (const EqualNormals& e : equal_) terms_.push_back({unit(e.vectorArea), 1.0});
  }

  static bool equal(const FaceNormal& a, const FaceNormal& b) {
    const glm::dvec3 apart = a.N - b.N;
    const double doubt = a.doubt + b.doubt;
    return glm::dot(apart, apart) <= doubt * doubt;
  }

  /// In degrees, in [0, 360).
  [[nodiscard]] double interiorAngle(const Corner& c) const {
    const int first = mesh_.firstCorner[c.face], last = mesh_.firstCorner[c.face + 1] - 1;
    const auto at = [&](int corner) { return mesh_.points[mesh_.corners[corner]]; };
    const auto before = [&](int corner) { return corner == first ? last : corner - 1; };
    const auto after = [&](int corner) { return corner == last ? first : corner + 1; };
    const glm::dvec3 here = at(c.corner);
    int next = after(c.corner);
    while (at(next) == here) next = after(next);
    // If the previous corner is at the same place, b is 0 and so is the angle.
    const glm::dvec3 a = at(next) - here, b = at(before(c.corner)) - here, N = faces_[c.face].N;
    const double sine = glm::dot(glm::cross(a, b), N);
    const double cosine = glm::dot(a, b) - glm::dot(a, N) * glm::dot(b, N);
    const double degrees = degreesOf(sine, cosine);
    return degrees < 0.0 ? degrees + 360.0 : degrees;
  }

  [[nodiscard]] bool isExact(const Corner& c) const {
    return hasExact_ && !exact_.empty() && exact_[c.corner] != glm::dvec3{0.0};
  }

  [[nodiscard]] glm::dvec3 normalAt(const Corner& c) const {
    if (isExact(c)) return exact_[c.corner];
    const glm::dvec3 own = faces_[c.face].N;
    const bool all = smooth_ || own == glm::dvec3{0.0};
    const glm::dvec3 sum =
        all ? common_ : normalisedSum([&](const Term& t) { return glm::dot(t.N, own) >= leastCosine_; });
    return sum == glm::dvec3{0.0} ? own : sum;
  }

  /// The unit vector along the sum of the terms that `takes` selects; 0 if the sum is all rounding.
  template <typename Takes>
  [[nodiscard]] glm::dvec3 normalisedSum(Takes takes) const {
    glm::dvec3 sum{0.0};
    double total = 0.0;
    for (const Term& t : terms_) {
      if (!takes(t)) continue;
      sum += t.weight * t.N;
      total += t.weight;
    }
    return largest(glm::abs(sum)) <= kRoundingOnly * total ? glm::dvec3{0.0} : unit(sum);
  }

  const Mesh& mesh_;
  NormalRule rule_;
  bool hasExact_, countsEqualOnce_;
  double leastCosine_, leastCosineOfHalf_;
  std::span<const glm::dvec3> exact_;
  std::vector<FaceNormal> faces_;
  std::vector<int> firstListed_;  ///< #points + 1, into listed_
  std::vector<Corner> listed_;

  // For the current point. They are members to reuse their memory.
  std::vector<Term> terms_;
  std::vector<std::pair<double, int>> sorted_;
  std::vector<EqualNormals> equal_;
  bool smooth_ = true;  ///< true if no two terms are further apart than the crease
  glm::dvec3 common_{0.0};
};

}  // namespace

Vertices smoothVertices(const Mesh& mesh, NormalRule rule, double creaseDegrees,
                        std::span<const glm::dvec3> exact) {
  assert(0.0 <= creaseDegrees && creaseDegrees <= 180.0);
  assert(exact.empty() || exact.size() == mesh.corners.size());
  return VertexNormals{mesh, rule, creaseDegrees, exact}.vertices();
}

}  // namespace xnewell
