#include "depthsort/bsp_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include "depthsort/oracle.h"
#include "depthsort/pair_tests.h"
#include "depthsort/region.h"
#include "geometry/exact/give_up.h"

namespace xnewell {

namespace {

constexpr int kNoIndex = -1;
constexpr std::size_t kCandidates = 5, kAsked = 64;

/// A face or a piece that is still to be placed in the tree, or was.
struct Entry {
  Extents extents;
  int face;
  int piece = kNoIndex;  ///< index into SortedScene::pieces
};

enum class Where { Unknown, Behind, Front, InPlane, Crossing };

/// Decides in doubles for most polygons on which side of a plane they lie, from their extents alone.
class PlaneSide {
 public:
  PlaneSide(const SnappedScene& scene, const SnappedFace& face)
      : anchor_{scene.vertices[face.first]},
        z_{depthAt(scene.planes[face.plane], anchor_.x, anchor_.y)},
        A_{static_cast<double>(scene.planes[face.plane].A) / static_cast<double>(scene.planes[face.plane].C)},
        B_{static_cast<double>(scene.planes[face.plane].B) /
           static_cast<double>(scene.planes[face.plane].C)} {}

  /// The plane's z within the box lies in z -+ reach. A slope has three roundings of 2^-53 and z_ four; each
  /// product and each sum adds one. So no term has more than ten, and 2^-48 allows 32.
  [[nodiscard]] Where of(const Extents& e) const {
    const double dx = (static_cast<double>(e.box.x0) + e.box.x1) / 2.0 - anchor_.x;
    const double dy = (static_cast<double>(e.box.y0) + e.box.y1) / 2.0 - anchor_.y;
    const double z = z_ + A_ * dx + B_ * dy;
    const double reach = std::abs(A_) * ((static_cast<double>(e.box.x1) - e.box.x0) / 2.0) +
                         std::abs(B_) * ((static_cast<double>(e.box.y1) - e.box.y0) / 2.0);
    const double rounding = 0x1p-48 * (std::abs(z_) + std::abs(A_ * dx) + std::abs(B_ * dy) + reach);
    // extents that reach the ends of int may be cut off there
    constexpr int kFarthest = std::numeric_limits<int>::min(), kNearest = std::numeric_limits<int>::max();
    if (e.zNear < kNearest && e.zNear < z - reach - rounding) return Where::Behind;
    if (e.zFar > kFarthest && e.zFar > z + reach + rounding) return Where::Front;
    return Where::Unknown;
  }

 private:
  glm::ivec3 anchor_;
  double z_, A_, B_;
};

class Builder {
 public:
  Builder(const SnappedScene& scene, const SortSettings& settings)
      : scene_{scene}, settings_{settings}, tests_{scene, settings} {}

  BspTree run() {
    // Subtrees that are still to be built. There is no recursion: a tree may be as deep as it has polygons.
    std::vector<Subtree> open;
    open.push_back({faces(), kNoIndex, false, 1});
    GiveUpNowAndThen giveUp;
    while (!open.empty()) {
      giveUp();
      Subtree subtree = std::move(open.back());
      open.pop_back();
      if (subtree.polygons.empty()) continue;
      const int node = static_cast<int>(tree_.nodes.size());
      if (subtree.parent != kNoIndex)
        (subtree.inFront ? tree_.nodes[subtree.parent].front : tree_.nodes[subtree.parent].behind) = node;
      int& deepest = tree_.sorted.statistics.deepest;
      deepest = std::max(deepest, subtree.depth);

      std::vector<int> front;
      divide(subtree.polygons, front);
      open.push_back({std::move(front), node, true, subtree.depth + 1});
      open.push_back({std::move(subtree.polygons), node, false, subtree.depth + 1});
    }
    SortStatistics& statistics = tree_.sorted.statistics;
    statistics.nodes = static_cast<std::int64_t>(tree_.nodes.size());
    statistics.bytes = bytesOf(tree_.sorted) + statistics.nodes * std::int64_t{sizeof(BspNode)};
    return std::move(tree_);
  }

 private:
  struct Subtree {
    std::vector<int> polygons;  ///< indices into polygons_
    int parent;                 ///< index of a node
    bool inFront;               ///< which subtree of the parent it is
    int depth;                  ///< number of nodes from the root to this one
  };

  /// All faces that show.
  std::vector<int> faces() {
    std::vector<int> all;
    for (int f = 0; f < static_cast<int>(scene_.faces.size()); ++f) {
      const SnappedFace& face = scene_.faces[f];
      const Extents extents = extentsOf(scene_, face);
      if (!mayShow(scene_, face, extents.box, settings_.width, settings_.height, settings_.inPixels))
        continue;
      all.push_back(static_cast<int>(polygons_.size()));
      polygons_.push_back({extents, f});
    }
    return all;
  }

  [[nodiscard]] Shape shapeOf(int P) const {
    const Entry& p = polygons_[P];
    return {scene_.faces[p.face], p.face, p.extents.box, p.piece == kNoIndex ? nullptr : &regions_[p.piece]};
  }

  /// The side of Q's plane on which P lies.
  [[nodiscard]] Where sideOf(int P, const PlaneSide& plane, int Q) {
    if (const Where side = plane.of(polygons_[P].extents); side != Where::Unknown) return side;
    const Signs signs = tests_.signsOver(shapeOf(P), shapeOf(Q));
    return signs.both()     ? Where::Crossing
           : signs.positive ? Where::Front
           : signs.negative ? Where::Behind
                            : Where::InPlane;
  }

  [[nodiscard]] int chooseRoot(const std::vector<int>& list);
  /// Makes a node of one polygon of the list and of those in its plane. What is in front of it moves to
  /// `front`; what is behind stays in the list.
  void divide(std::vector<int>& list, std::vector<int>& front);
  /// Splits P by Q's plane if both parts show. Then it returns Crossing, and the last two polygons are the
  /// parts: behind, then in front. Otherwise it returns the side of the part that shows.
  [[nodiscard]] Where split(int P, int Q);
  void enterPart(int P, Region region);
  [[nodiscard]] bool shows(const Region& part) const {
    return !part.empty() && (ownsSample(scene_, part, settings_.width, settings_.height) ||
                             (settings_.inPixels && isWide(part)));
  }
  /// Frees the region of a polygon that is split or in a node.
  void forget(int P) {
    if (polygons_[P].piece != kNoIndex) Region{}.swap(regions_[polygons_[P].piece]);
  }

  const SnappedScene& scene_;
  SortSettings settings_;
  PairTests tests_;
  std::vector<Entry> polygons_;  ///< every polygon ever made, also those that were split
  std::vector<Region> regions_;  ///< by piece
  BspTree tree_;
};

int Builder::chooseRoot(const std::vector<int>& list) {
  const auto some = [&](std::size_t k, std::size_t of) { return list[(2 * k + 1) * list.size() / (2 * of)]; };
  const std::size_t candidates = std::min(kCandidates, list.size()), asked = std::min(kAsked, list.size());
  int root = list[0];
  std::pair<int, int> least{};
  for (std::size_t c = 0; c < candidates && list.size() > 1; ++c) {
    const int Q = some(c, candidates);
    const PlaneSide plane{scene_, scene_.faces[polygons_[Q].face]};
    int crossing = 0, ahead = 0;  // `ahead`: how many more are in front than behind
    for (std::size_t a = 0; a < asked; ++a) {
      const Where side = sideOf(some(a, asked), plane, Q);
      crossing += side == Where::Crossing;
      ahead += (side == Where::Front) - (side == Where::Behind);
    }
    if (const std::pair score{crossing, std::abs(ahead)}; c == 0 || score < least) root = Q, least = score;
  }
  return root;
}

void Builder::divide(std::vector<int>& list, std::vector<int>& front) {
  const int Q = chooseRoot(list);
  const PlaneSide plane{scene_, scene_.faces[polygons_[Q].face]};
  std::vector<int> inPlane{Q};
  std::size_t behind = 0;  // what lies behind moves to the start of the list
  for (std::size_t k = 0; k < list.size(); ++k) {
    const int P = list[k];
    if (P == Q) continue;
    Where side = sideOf(P, plane, Q);
    if (side == Where::Crossing) side = split(P, Q);
    switch (side) {
      case Where::Front:
        front.push_back(P);
        break;
      case Where::InPlane:
        inPlane.push_back(P);
        break;
      case Where::Crossing:
        list[behind++] = static_cast<int>(polygons_.size()) - 2;
        front.push_back(static_cast<int>(polygons_.size()) - 1);
        break;
      default:
        list[behind++] = P;
    }
  }
  list.resize(behind);

  std::vector<Fragment>& fragments = tree_.sorted.fragments;
  tree_.nodes.push_back({static_cast<int>(fragments.size()), static_cast<int>(inPlane.size())});
  for (const int P : inPlane) {
    fragments.push_back({polygons_[P].face, polygons_[P].piece});
    forget(P);
  }
  std::sort(fragments.end() - static_cast<std::ptrdiff_t>(inPlane.size()), fragments.end(),
            [](const Fragment& f, const Fragment& g) {
              return std::pair{f.face, f.piece} < std::pair{g.face, g.piece};
            });
}

Where Builder::split(int P, int Q) {
  PairTests::Parts parts = tests_.split(shapeOf(P), shapeOf(Q));
  if (!shows(parts.front)) return Where::Behind;
  if (!shows(parts.behind)) return Where::Front;
  if (static_cast<int>(regions_.size()) + 2 > settings_.mostPieces)
    throw tooManyPieces("the BSP tree", settings_.mostPieces);
  ++tree_.sorted.statistics.splits;
  forget(P);
  enterPart(P, std::move(parts.behind));
  enterPart(P, std::move(parts.front));
  return Where::Crossing;
}

void Builder::enterPart(int P, Region region) {
  Entry part = polygons_[P];
  const int parent = part.piece == kNoIndex ? part.face : static_cast<int>(scene_.faces.size()) + part.piece;
  part.extents = extentsOf(scene_, scene_.faces[part.face], region, part.extents);
  part.piece = static_cast<int>(regions_.size());
  enterPiece(tree_.sorted, {part.face, parent}, region,
             rowsOf(part.extents.box, {0, 0, settings_.width, settings_.height}, settings_.inPixels));
  polygons_.push_back(part);
  regions_.push_back(std::move(region));
}

}  // namespace

BspTree bspTree(const SnappedScene& scene, const SortSettings& settings) {
  return Builder{scene, settings}.run();
}

SortedScene backToFront(BspTree tree) {
  SortedScene sorted = std::move(tree.sorted);
  std::vector<Fragment> ordered;
  ordered.reserve(sorted.fragments.size());
  std::vector<int> open;  // nodes whose subtree behind comes first
  int node = tree.nodes.empty() ? kNoIndex : 0;
  while (node != kNoIndex || !open.empty()) {
    for (; node != kNoIndex; node = tree.nodes[node].behind) open.push_back(node);
    const BspNode& next = tree.nodes[open.back()];
    open.pop_back();
    const auto first = sorted.fragments.begin() + next.first;
    ordered.insert(ordered.end(), first, first + next.count);
    node = next.front;
  }
  sorted.fragments = std::move(ordered);
  return sorted;
}

}  // namespace xnewell
