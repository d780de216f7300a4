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
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/exact/box.h"
#include "geometry/exact/give_up.h"
#include "geometry/model/sheets.h"

namespace xnewell {

namespace {

constexpr int kMostSteps = 100, kMostTurns = 4;
/// Relative to h: the step that ends the search for the best plane.
constexpr double kNearly = 1e-6;

using Column = std::array<double, 4>;

/// Solves a 4 x 4 system whose columns are given: sum x_k columns[k] = b. Or, transposed: columns[k].x =
/// b[k].
std::optional<Column> solve(const std::array<Column, 4>& columns, Column b, bool transposed) {
  std::array<Column, 4> m;  // rows
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] = transposed ? columns[i][j] : columns[j][i];
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 4; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    if (!(std::abs(m[pivot][k]) > 1e-13)) return {};
    std::swap(m[k], m[pivot]), std::swap(b[k], b[pivot]);
    for (int i = k + 1; i < 4; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (int j = k; j < 4; ++j) m[i][j] -= factor * m[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (int k = 3; k >= 0; --k) {
    for (int j = k + 1; j < 4; ++j) b[k] -= m[k][j] * b[j];
    b[k] /= m[k][k];
  }
  return b;
}

/// A point as the programme sees it: z over the plane of x and y, and the weight of its error.
struct Height {
  double x, y, z, w;
};

/// The plane z = a x + b y + c with the least h, |z - a x - b y - c| <= h w at all points.
struct Exchange {
  std::span<const Height> points;
  double a = 0, b = 0, c = 0;
  double least = 0;  ///< no plane has a smaller h

  void run(FitGoal goal) {
    // One point holds the plane from above and from below, two more only from above. So h = 0, and the
    // weights of the two are 0.
    const std::optional<std::array<int, 3>> start = farApart();
    if (!start) return;
    std::array<int, 4> held{(*start)[0], (*start)[0], (*start)[1], (*start)[2]};
    std::array<double, 4> sign{1, -1, 1, 1};
    std::array<Column, 4> columns;
    const auto column = [&](int i, double s) -> Column {
      return {s * points[i].x, s * points[i].y, s, points[i].w};
    };
    for (int step = 0; step < kMostSteps; ++step) {
      Column heights;
      for (int k = 0; k < 4; ++k)
        columns[k] = column(held[k], sign[k]), heights[k] = sign[k] * points[held[k]].z;
      const auto plane = solve(columns, heights, true);
      auto weight = solve(columns, {0, 0, 0, 1}, false);
      if (!plane || !weight) return;
      a = (*plane)[0], b = (*plane)[1], c = (*plane)[2];
      least = std::max(least, (*plane)[3]);
      const auto [furthest, off] = furthestOff();
      const double h = std::abs(off) / points[furthest].w;
      if (h <= least * (1 + kNearly) || (goal == FitGoal::Explain && (h <= 1 || least > 1 + kNearly))) return;

      const double s = off < 0 ? -1 : 1;
      auto d = solve(columns, column(furthest, s), false);
      if (!d) return;
      // A point of weight 0 can hold the plane from the other side as well.
      if (step == 0)
        for (const int k : {2, 3})
          if ((*d)[k] > 0) {
            const double share = (*d)[k] * points[held[k]].w / points[held[0]].w;
            (*d)[0] += share, (*d)[1] += share;
            (*d)[k] = -(*d)[k];
            sign[k] = -sign[k];
          }
      int leaves = -1;
      for (int k = 0; k < 4; ++k) {
        if (!((*d)[k] > 1e-12)) continue;
        const double ratio = std::max(0.0, (*weight)[k]) / (*d)[k];
        if (leaves < 0 || ratio < std::max(0.0, (*weight)[leaves]) / (*d)[leaves]) leaves = k;
      }
      if (leaves < 0) return;
      held[leaves] = furthest, sign[leaves] = s;
    }
  }

 private:
  /// Three points that span a large triangle; none if all are in line.
  [[nodiscard]] std::optional<std::array<int, 3>> farApart() const {
    const auto most = [&](const auto& measure) {
      int best = 0;
      double is = -1.0;
      for (int i = 0; i < static_cast<int>(points.size()); ++i)
        if (const double mine = measure(points[i]); mine > is) best = i, is = mine;
      return std::pair{best, is};
    };
    const Height& first = points[0];
    const int second =
        most([&](const Height& p) { return std::abs(p.x - first.x) + std::abs(p.y - first.y); }).first;
    const double ex = points[second].x - first.x, ey = points[second].y - first.y;
    const auto [third, area] =
        most([&](const Height& p) { return std::abs(ex * (p.y - first.y) - ey * (p.x - first.x)); });
    if (!(area > 1e-10)) return {};
    return std::array{0, second, third};
  }
  [[nodiscard]] std::pair<int, double> furthestOff() const {
    int furthest = 0;
    double off = 0.0, most = -1.0;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      const Height& p = points[i];
      const double z = p.z - (a * p.x + b * p.y + c);
      if (std::abs(z) > most * p.w) furthest = i, off = z, most = std::abs(z) / p.w;
    }
    return {furthest, off};
  }
};

/// Two unit vectors at right angles to N and to each other.
std::pair<glm::dvec3, glm::dvec3> tangents(const glm::dvec3& N) {
  const glm::dvec3 n = glm::abs(N);
  const glm::dvec3 axis = n.x <= n.y && n.x <= n.z ? glm::dvec3{1, 0, 0}
                          : n.y <= n.z             ? glm::dvec3{0, 1, 0}
                                                   : glm::dvec3{0, 0, 1};
  const glm::dvec3 first = glm::normalize(glm::cross(N, axis));
  return {first, glm::cross(N, first)};
}

}  // namespace

PlaneFit fitOf(const Plane& plane, std::span<const RoundedPoint> points, const Rounding& rounding) {
  PlaneFit fit{plane};
  for (const RoundedPoint& q : points)
    fit.h = std::max(fit.h, std::abs(glm::dot(plane.N, q.p) - plane.d) / rounding.of(plane.N, q.u));
  return fit;
}

PlaneFit fitPlane(std::span<const RoundedPoint> points, const Plane& start, const Rounding& rounding,
                  FitGoal goal) {
  PlaneFit best = fitOf(start, points, rounding);
  if (goal == FitGoal::Explain && best.explains()) return best;
  std::vector<Height> heights(points.size());
  glm::dvec3 N = start.N;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const auto [T, U] = tangents(N);
    const glm::dvec3 origin = points[0].p;
    double reach = 0.0;
    for (const RoundedPoint& q : points) reach = std::max(reach, glm::length(q.p - origin));
    if (reach == 0.0) return best;
    const double w = rounding.most(points[0].u);  // the unit of z
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 q = points[i].p - origin;
      heights[i] = {glm::dot(T, q) / reach, glm::dot(U, q) / reach, glm::dot(N, q) / w,
                    rounding.of(N, points[i].u) / w};
    }
    Exchange exchange{heights};
    exchange.run(goal);
    const double a = exchange.a * w / reach, b = exchange.b * w / reach;
    N = glm::normalize(N - a * T - b * U);
    const double length = std::sqrt(1.0 + a * a + b * b);
    const PlaneFit fit = fitOf({N, glm::dot(N, origin) + exchange.c * w / length}, points, rounding);
    if (fit.h < best.h) best = fit;
    if (goal == FitGoal::Explain && best.explains()) break;
    if (std::abs(a) + std::abs(b) < 0x1p-10) break;
  }
  return best;
}

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
  Coplanarity(const Mesh& mesh, const ConvexParts& parts)
      : model_{mesh, parts}, classOf_(model_.count(), kAlone) {}

  /// The roundings above `least`, in the mesh's units, that pairs of faces show (countRounding()).
  [[nodiscard]] std::vector<double> shown(const Mesh& mesh, double least) {
    constexpr double kSurely = 0.9;
    const double exact = 4.0 * model_.rounding.arithmetic();
    std::vector<double> shown;
    GiveUpNowAndThen giveUp;
    model_.forAllNear([&](const SheetPart& i, const SheetPart& j) {
      giveUp();
      const std::array pair{sheetOf(i), sheetOf(j)};
      const ModelSheet &P = i.sheet, &Q = j.sheet;
      const double u =
          std::max(mesh.roundingOf(model_.parts.face[i.part]), mesh.roundingOf(model_.parts.face[j.part]));
      if (pair[0] == pair[1] || u <= least || std::ranges::find(shown, u) != shown.end()) return;
      if (glm::length(glm::cross(P.plane.N, Q.plane.N)) * model_.box.side <= exact || !inOnePlane(i, j))
        return;
      const PlaneFit best = fit(pair, FitGoal::Best);
      if (best.h <= kSurely && best.h * model_.rounding.of(best.plane.N, std::max(P.u, Q.u)) > exact)
        shown.push_back(u);
    });
    return shown;
  }

  [[nodiscard]] CoplanarClasses classes() {
    std::vector<int> torn, open(model_.count());
    std::iota(open.begin(), open.end(), 0);
    while (!open.empty()) open = afterRound(open, torn);
    if (!torn.empty()) mergePairs(torn);
    return numbered();
  }

 private:
  /// A sheet that so many others overlap, nearly in its plane but not explained with it, is compared with the
  /// planes of further ones as they are, without a fit.
  static constexpr int kMostFailures = 64;
  /// From so many on, it may matter in which order the pairs come. Then they come in that of the sheets.
  static constexpr int kFewFailures = 8;

  /// The corners of some sheets, in a buffer.
  [[nodiscard]] std::span<const RoundedPoint> pointsOf(std::span<const int> sheets) {
    points_.clear();
    for (const int s : sheets) {
      const double u = model_.roundingOf(s);
      for (const int c : model_.corners(s)) points_.push_back({model_.box.points[c], u});
    }
    return points_;
  }
  [[nodiscard]] int sheetOf(const SheetPart& P) const { return model_.parts.plane[P.part]; }
  [[nodiscard]] Plane planeOfLargest(std::span<const int> sheets) const {
    ModelSheet largest = model_.sheet(sheets[0]);
    for (const int s : sheets.subspan(1))
      if (const ModelSheet sheet = model_.sheet(s); sheet.area > largest.area) largest = sheet;
    return largest.plane;
  }
  [[nodiscard]] PlaneFit fit(std::span<const int> sheets, FitGoal goal) {
    return fitPlane(pointsOf(sheets), planeOfLargest(sheets), model_.rounding, goal);
  }

  void makeClass(std::span<const int> sheets, const Plane& plane) {
    for (const int s : sheets) classOf_[s] = static_cast<int>(planes_.size());
    planes_.push_back(plane);
    several_.push_back(sheets.size() > 1);
  }
  /// A sheet of one part needs no class if its own plane explains it.
  void makeAlone(int s) {
    const bool divided = model_.partCount(s) > 1;
    if (!divided && model_.corners(s).size() == 3) return;
    const std::array one{s};
    const ModelSheet sheet = model_.sheet(s);
    const bool explains = sheet.area == 0.0 || fitOf(sheet.plane, pointsOf(one), model_.rounding).explains();
    if (divided || !explains) makeClass(one, explains ? sheet.plane : fit(one, FitGoal::Best).plane);
  }

  /// Calls visit(set) for each set of sheets that a chain of pairs joins.
  template <class Visit>
  void forSets(const std::vector<int>& open, const Visit& visit) {
    DisjointSets sets{model_.count()};
    GiveUpNowAndThen giveUp;
    const auto unite = [&](const SheetPart& i, const SheetPart& j) {
      giveUp();
      const int P = sheetOf(i), Q = sheetOf(j);
      if (sets.of(P) != sets.of(Q) && inOnePlane(i, j)) sets.unite(P, Q);
    };
    bool byCells = std::ssize(open) == model_.count();
    if (byCells)
      model_.forAllNear([&](const SheetPart& i, const SheetPart& j) {
        if (mostFailures_ < kFewFailures) unite(i, j);
      });
    if (mostFailures_ >= kFewFailures && byCells) {  // begin again
      byCells = false;
      failures_.clear();
      sets = DisjointSets{model_.count()};
    }
    if (!byCells) model_.forNear(open, unite);
    std::vector<std::pair<int, int>> bySet;
    std::vector<char> several(model_.count(), false);
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
    Plane plane = planeOfLargest(set);
    std::vector<ModelSheet> sheets;
    for (const int s : set) sheets.push_back(model_.sheet(s));
    for (int step = 0; step < 12; ++step) {
      const glm::dvec3 n = glm::abs(plane.N);
      const int z = n.z >= n.x && n.z >= n.y ? 2 : n.y >= n.x ? 1 : 0, x = (z + 1) % 3, y = (z + 2) % 3;
      const glm::dvec3 origin = sheets[0].centroid;
      glm::dmat3 M{0.0};
      glm::dvec3 right{0.0};
      for (std::size_t k = 0; k < set.size(); ++k) {
        const ModelSheet& sheet = sheets[k];
        const auto outline = model_.corners(set[k]);
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
    DisjointSets sets{model_.count()};
    std::vector<std::vector<int>> members(model_.count());
    for (const int s : open) members[s] = {s};
    std::vector<int> both;
    model_.forNear(open, [&](const SheetPart& i, const SheetPart& j) {
      const int P = sets.of(sheetOf(i)), Q = sets.of(sheetOf(j));
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
    result.frame = model_.box.frame;
    result.plane.resize(model_.parts.count());
    std::vector<int> number(planes_.size(), -1);
    int planes = 0;
    for (int s = 0; s < model_.count(); ++s) {
      const int from = model_.firstPart(s), end = model_.firstPart(s + 1), mine = classOf_[s];
      if (mine == kAlone) {
        result.plane[from] = planes++;
        continue;
      }
      const ModelSheet sheet = model_.sheet(s);
      if (number[mine] < 0) {
        number[mine] = planes++;
        result.planes.add(number[mine], inMesh(planes_[mine], sheet));
      }
      for (int k = from; k < end; ++k) {
        result.plane[k] = number[mine];
        if (several_[mine] && sheet.area > 0.0) result.own.add(k, inMesh(sheet.plane, sheet));
      }
    }
    return result;
  }
  /// The plane, through the point of it that is nearest to the sheet's centroid.
  [[nodiscard]] ModelPlane inMesh(const Plane& plane, const ModelSheet& sheet) const {
    const glm::dvec3 foot = sheet.centroid - plane.N * (glm::dot(plane.N, sheet.centroid) - plane.d);
    return {plane.N, model_.box.frame.inMesh(foot)};
  }

  /// True if two parts overlap in area and one plane explains their sheets.
  [[nodiscard]] bool inOnePlane(const SheetPart& i, const SheetPart& j) {
    const int p = sheetOf(i), q = sheetOf(j);
    const ModelSheet &P = i.sheet, &Q = j.sheet;
    if (model_.tooFar(i, j)) return false;
    const ModelSheet& larger = P.area > Q.area || (P.area == Q.area && i.part < j.part) ? P : Q;
    if (model_.parted(i, j, larger.plane.N)) return false;
    const std::span<const RoundedPoint> both = pointsOf(std::array{p, q});
    if (failures_[p] >= kMostFailures || failures_[q] >= kMostFailures)
      return fitOf(larger.plane, both, model_.rounding).explains();
    const bool explained = fitPlane(both, larger.plane, model_.rounding, FitGoal::Explain).explains();
    if (!explained) mostFailures_ = std::max({mostFailures_, ++failures_[p], ++failures_[q]});
    return explained;
  }
  Sheets model_;
  std::vector<RoundedPoint> points_;  ///< buffer of pointsOf()
  static constexpr int kAlone = -1;
  std::vector<int> classOf_;               ///< of each sheet, an index into planes_, or kAlone
  std::unordered_map<int, int> failures_;  ///< of each sheet: fits with others that explained nothing
  int mostFailures_ = 0;
  std::vector<char> several_;  ///< of the classes: true if it has several sheets
  std::vector<Plane> planes_;  ///< of the classes
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
      std::string{text.data(), end} +
      " of one plane count as lying in it, and a painting order shows the later one");
}

void uniteCoplanar(const Mesh& mesh, ConvexParts& parts) {
  CoplanarClasses classes = coplanarClasses(mesh, parts);
  parts.plane = std::move(classes.plane);
  parts.planes = std::move(classes.planes);
  parts.own = std::move(classes.own);
  parts.frame = classes.frame;
}

ModelPlane planeOf(const Mesh& mesh, const ConvexParts& parts, int part) {
  if (const ModelPlane* const found = parts.planes.find(parts.plane[part])) return *found;
  const UnitFrame frame = parts.frame.value_or(UnitFrame{});
  const auto outline = parts.part(part);
  std::vector<glm::dvec3> points(outline.size());
  std::ranges::transform(outline, points.begin(), [&](int c) { return frame.inUnits(mesh.points[c]); });
  std::vector<int> corners(outline.size());
  std::iota(corners.begin(), corners.end(), 0);
  const glm::dvec3 v = newellVector(points, corners);
  const double area = glm::length(v);
  return {area > 0.0 ? v / area : glm::dvec3{0.0}, frame.inMesh(centroid(points, corners))};
}

}  // namespace xnewell
