#include "geometry/model/coplanar.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numeric>
#include <string>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/exact/give_up.h"
#include "geometry/model/fit_plane.h"
#include "geometry/model/sheets.h"

namespace xnewell {

namespace {

/// Disjoint sets of numbers. @see Tarjan 1975
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  [[nodiscard]] int of(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(int i, int j) { parent_[of(j)] = of(i); }

 private:
  std::vector<int> parent_;
};

class Coplanarity {
 public:
  Coplanarity(const Mesh& mesh, const ConvexParts& parts) : model_{mesh, parts} {
    classOf_.assign(model_.sheets.size(), -1);
    failures_.assign(model_.sheets.size(), 0);
  }

  /// The roundings above `least`, in the mesh's units, that pairs of faces show (countRounding()).
  [[nodiscard]] std::vector<double> shown(const Mesh& mesh, double least) {
    constexpr double kSurely = 0.9;
    const double exact = 4.0 * model_.rounding.arithmetic();
    std::vector<double> shown;
    std::vector<int> all(model_.sheets.size());
    std::iota(all.begin(), all.end(), 0);
    GiveUpNowAndThen giveUp;
    model_.forNear(all, [&](int i, int j) {
      giveUp();
      const std::array pair{model_.parts.plane[i], model_.parts.plane[j]};
      const ModelSheet &P = model_.sheets[pair[0]], &Q = model_.sheets[pair[1]];
      const double u = std::max(mesh.roundingOf(model_.parts.face[i]), mesh.roundingOf(model_.parts.face[j]));
      if (&P == &Q || u <= least || std::ranges::find(shown, u) != shown.end()) return;
      if (glm::length(glm::cross(P.plane.N, Q.plane.N)) * model_.box.side <= exact || !inOnePlane(i, j))
        return;
      const PlaneFit best = fit(pair, FitGoal::Best);
      if (best.h <= kSurely && best.h * model_.rounding.of(best.plane.N, std::max(P.u, Q.u)) > exact)
        shown.push_back(u);
    });
    return shown;
  }

  [[nodiscard]] CoplanarClasses classes() {
    std::vector<int> open(model_.sheets.size());
    std::iota(open.begin(), open.end(), 0);
    std::vector<int> torn;
    while (!open.empty()) open = afterRound(open, torn);
    if (!torn.empty()) mergePairs(torn);
    return numbered();
  }

 private:
  /// A sheet that so many others overlap, nearly in its plane but not explained with it, is compared with the
  /// planes of further ones as they are, without a fit.
  static constexpr int kMostFailures = 64;

  /// The corners of some sheets, in a buffer.
  [[nodiscard]] std::span<const RoundedPoint> pointsOf(std::span<const int> sheets) {
    points_.clear();
    for (const int s : sheets)
      for (const int c : model_.corners(model_.sheets[s]))
        points_.push_back({model_.box.points[c], model_.sheets[s].u});
    return points_;
  }
  [[nodiscard]] const ModelSheet& largestOf(std::span<const int> sheets) const {
    return model_.sheets[*std::ranges::max_element(sheets, {}, [&](int s) { return model_.sheets[s].area; })];
  }
  [[nodiscard]] PlaneFit fit(std::span<const int> sheets, FitGoal goal) {
    return fitPlane(pointsOf(sheets), largestOf(sheets).plane, model_.rounding, goal);
  }

  void makeClass(std::span<const int> sheets, const Plane& plane) {
    for (const int s : sheets) classOf_[s] = static_cast<int>(planes_.size());
    planes_.push_back(plane);
    several_.push_back(sheets.size() > 1);
  }
  void makeAlone(int s) {
    const std::array one{s};
    const ModelSheet& sheet = model_.sheets[s];
    if (sheet.area == 0.0 || model_.corners(sheet).size() == 3) return makeClass(one, sheet.plane);
    const bool explains = fitOf(sheet.plane, pointsOf(one), model_.rounding).explains();
    makeClass(one, explains ? sheet.plane : fit(one, FitGoal::Best).plane);
  }

  /// Calls visit(set) for each set of sheets that a chain of pairs joins.
  template <class Visit>
  void forSets(const std::vector<int>& open, const Visit& visit) {
    DisjointSets sets{static_cast<int>(model_.sheets.size())};
    GiveUpNowAndThen giveUp;
    model_.forNear(open, [&](int i, int j) {
      giveUp();
      const int P = model_.parts.plane[i], Q = model_.parts.plane[j];
      if (sets.of(P) != sets.of(Q) && inOnePlane(i, j)) sets.unite(P, Q);
    });
    std::vector<std::pair<int, int>> bySet;
    bySet.reserve(open.size());
    std::vector<char> several(model_.sheets.size(), false);
    for (const int s : open)
      if (const int root = sets.of(s); root != s) several[root] = true;
    std::vector<int> one(1);
    for (const int s : open) {
      const int root = sets.of(s);
      if (several[root]) {
        bySet.emplace_back(root, s);
      } else {
        one[0] = s;
        visit(one);
      }
    }
    std::ranges::sort(bySet);
    std::vector<int> set;
    for (std::size_t k = 0; k < bySet.size(); ++k) {
      set.push_back(bySet[k].second);
      if (k + 1 < bySet.size() && bySet[k + 1].first == bySet[k].first) continue;
      visit(set);
      set.clear();
    }
  }

  /// Makes classes of the sets that one plane explains. Of each other set it makes a class of the sheets at
  /// its principal plane, and returns the rest of it; if there is no such class, the set goes to `torn`.
  std::vector<int> afterRound(const std::vector<int>& open, std::vector<int>& torn) {
    std::vector<int> left;
    forSets(open, [&](std::vector<int>& set) {
      if (set.size() == 1) return makeAlone(set[0]);
      const PlaneFit whole = fit(set, FitGoal::Best);
      if (whole.explains()) return makeClass(set, whole.plane);
      const std::size_t peeled = peel(set);
      std::vector<int>& to = peeled == 0 ? torn : left;
      to.insert(to.end(), set.begin() + static_cast<std::ptrdiff_t>(peeled), set.end());
    });
    return left;
  }

  /// Makes a class of as many sheets as one plane explains, in the order of their distance from the plane
  /// that has the least sum of distances from the corners, weighted by area: most of the area lies in that
  /// plane, if half of it lies in one. It moves these sheets to the front and returns their number, which may
  /// be 0.
  std::size_t peel(std::vector<int>& set) {
    const Plane plane = principalPlane(set);
    std::vector<std::pair<double, int>> byDistance;
    for (const int s : set)
      byDistance.emplace_back(fitOf(plane, pointsOf(std::array{s}), model_.rounding).h, s);
    std::ranges::sort(byDistance);
    std::ranges::transform(byDistance, set.begin(), [](const auto& entry) { return entry.second; });
    const auto prefix = [&](std::size_t n) {
      return fitPlane(pointsOf(std::span{set}.first(n)), plane, model_.rounding, FitGoal::Explain).explains();
    };
    std::size_t explained = 1, notExplained = set.size();
    while (notExplained - explained > 1) {
      const std::size_t middle = (explained + notExplained) / 2;
      (prefix(middle) ? explained : notExplained) = middle;
    }
    if (explained == 1) return 0;
    const std::span<const int> sheets = std::span{set}.first(explained);
    makeClass(sheets, fitPlane(pointsOf(sheets), plane, model_.rounding, FitGoal::Best).plane);
    return explained;
  }

  /// The plane with the least sum of distances, by weighted least squares with weights 1 / distance. What is
  /// nearer than r counts as r away: there, only rounding tells the distances apart.
  [[nodiscard]] Plane principalPlane(std::span<const int> set) {
    Plane plane = largestOf(set).plane;
    for (int step = 0; step < 12; ++step) {
      const glm::dvec3 n = glm::abs(plane.N);
      const int z = n.z >= n.x && n.z >= n.y ? 2 : n.y >= n.x ? 1 : 0, x = (z + 1) % 3, y = (z + 2) % 3;
      const glm::dvec3 origin = model_.sheets[set[0]].centroid;
      glm::dmat3 M{0.0};
      glm::dvec3 right{0.0};
      for (const int s : set) {
        const ModelSheet& sheet = model_.sheets[s];
        const auto outline = model_.corners(sheet);
        for (const int c : outline) {
          const glm::dvec3 q = model_.box.points[c] - origin, column{q[x], q[y], 1.0};
          const double off = std::abs(glm::dot(plane.N, model_.box.points[c]) - plane.d);
          const double weight =
              sheet.area / static_cast<double>(outline.size()) / std::max(off, model_.rounding.most(sheet.u));
          M += weight * glm::outerProduct(column, column);
          right += weight * q[z] * column;
        }
      }
      if (!(std::abs(glm::determinant(M)) > 0.0)) break;
      const glm::dvec3 solution = glm::inverse(M) * right;  // z = solution . (x, y, 1)
      glm::dvec3 N;
      N[x] = -solution.x, N[y] = -solution.y, N[z] = 1.0;
      const double length = glm::length(N);
      if (!std::isfinite(length)) break;
      plane = {N / length, (glm::dot(N, origin) + solution.z) / length};
    }
    return plane;
  }

  /// Unites pairs of the sheets that are left, and then the sets that they form, only if one plane explains
  /// both together.
  void mergePairs(const std::vector<int>& open) {
    DisjointSets sets{static_cast<int>(model_.sheets.size())};
    std::vector<std::vector<int>> members(model_.sheets.size());
    for (const int s : open) members[s] = {s};
    std::vector<int> both;
    model_.forNear(open, [&](int i, int j) {
      const int P = sets.of(model_.parts.plane[i]), Q = sets.of(model_.parts.plane[j]);
      if (P == Q || !inOnePlane(i, j)) return;
      both = members[P];
      both.insert(both.end(), members[Q].begin(), members[Q].end());
      if (both.size() > 2) {
        if (failures_[P] >= kMostFailures || failures_[Q] >= kMostFailures) return;
        if (!fit(both, FitGoal::Explain).explains()) {
          ++failures_[P], ++failures_[Q];
          return;
        }
      }
      sets.unite(P, Q);
      members[sets.of(P)] = both;
    });
    for (const int s : open) {
      if (sets.of(s) != s) continue;
      if (members[s].size() == 1)
        makeAlone(s);
      else
        makeClass(members[s], fit(members[s], FitGoal::Best).plane);
    }
  }

  /// Numbers the classes in the order of their first sheets.
  [[nodiscard]] CoplanarClasses numbered() const {
    CoplanarClasses result;
    result.plane.resize(model_.parts.count());
    std::vector<int> number(planes_.size(), -1);
    for (std::size_t s = 0; s < model_.sheets.size(); ++s) {
      int& mine = number[classOf_[s]];
      if (mine < 0) {
        mine = static_cast<int>(result.planes.size());
        result.planes.push_back(inModel(planes_[classOf_[s]], model_.sheets[s]));
      }
      std::fill_n(result.plane.begin() + model_.sheets[s].firstPart, model_.sheets[s].partCount, mine);
    }
    result.own = result.plane;
    for (std::size_t s = 0; s < model_.sheets.size(); ++s) {
      const ModelSheet& sheet = model_.sheets[s];
      if (!several_[classOf_[s]] || sheet.area == 0.0) continue;
      std::fill_n(result.own.begin() + sheet.firstPart, sheet.partCount,
                  static_cast<int>(result.planes.size()));
      result.planes.push_back(inModel(sheet.plane, sheet));
    }
    return result;
  }
  /// The plane, through the point of it that is nearest to the sheet's centroid.
  [[nodiscard]] ModelPlane inModel(const Plane& plane, const ModelSheet& sheet) const {
    const glm::dvec3 foot = sheet.centroid - plane.N * (glm::dot(plane.N, sheet.centroid) - plane.d);
    return {plane.N, model_.box.inWorld(foot)};
  }

  /// True if parts i and j overlap in area and one plane explains their sheets.
  [[nodiscard]] bool inOnePlane(int i, int j) {
    const int p = model_.parts.plane[i], q = model_.parts.plane[j];
    const ModelSheet &P = model_.sheets[p], &Q = model_.sheets[q];
    if (model_.tooFar(i, j)) return false;
    const ModelSheet& larger = P.area > Q.area || (P.area == Q.area && i < j) ? P : Q;
    if (model_.parted(i, j, larger.plane.N)) return false;
    const std::span<const RoundedPoint> both = pointsOf(std::array{p, q});
    if (failures_[p] >= kMostFailures || failures_[q] >= kMostFailures)
      return fitOf(larger.plane, both, model_.rounding).explains();
    const bool explained = fitPlane(both, larger.plane, model_.rounding, FitGoal::Explain).explains();
    if (!explained) ++failures_[p], ++failures_[q];
    return explained;
  }
  Sheets model_;
  std::vector<RoundedPoint> points_;  ///< buffer of pointsOf()
  std::vector<int> classOf_;          ///< of each sheet, an index into planes_
  std::vector<int> failures_;         ///< of each sheet: fits with others that explained nothing
  std::vector<char> several_;         ///< of the classes: true if it has several sheets
  std::vector<Plane> planes_;         ///< of the classes
};

}  // namespace

CoplanarClasses coplanarClasses(const Mesh& mesh, const ConvexParts& parts) {
  if (parts.count() == 0) return {};
  return Coplanarity{mesh, parts}.classes();
}

void countRounding(Mesh& mesh) {
  const double side = boxOf(mesh.points).side(), least = 3e-5 / Rounding::kSqrt3 * side;
  const auto isCoarse = [&](double u) { return u > least; };
  for (double& u : mesh.rounding)
    if (u > side / 64) u = least;
  if (std::ranges::none_of(mesh.rounding, isCoarse)) return;
  const ConvexParts parts = divideFaces(mesh);
  const std::vector<double> shown = Coplanarity{mesh, parts}.shown(mesh, least);
  for (double& u : mesh.rounding)
    if (isCoarse(u) && std::ranges::find(shown, u) == shown.end()) u = least;
  if (shown.empty()) return;
  std::array<char, 32> text;
  const auto [end, error] =
      std::to_chars(text.begin(), text.end(), std::ranges::max(shown), std::chars_format::general, 3);
  mesh.notes.push_back(
      "some faces are nearer to each other than the file's decimals tell: those that lie within " +
      std::string{text.data(), end} + " of one plane count as lying in it, and the later one shows");
}

void uniteCoplanar(const Mesh& mesh, ConvexParts& parts) {
  CoplanarClasses classes = coplanarClasses(mesh, parts);
  parts.plane = std::move(classes.plane);
  parts.planes = std::move(classes.planes);
  parts.own = std::move(classes.own);
}

}  // namespace xnewell
