#include "geometry/model/ear_clip.h"

#include <algorithm>
#include <utility>

namespace xnewell {

namespace {

struct Triangle {
  LatticePoint a, b, c;  ///< counter-clockwise

  bool hasCorner(const LatticePoint& p) const { return p == a || p == b || p == c; }
  bool contains(const LatticePoint& p) const {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  }
};

struct EarBox {
  LatticePoint low, high;

  /// True if the box lies strictly to the right of a -> b, that is, if its leftmost corner does, seen along
  /// ab.
  bool rightOf(const LatticePoint& a, const LatticePoint& b) const {
    return turn(a, b, {b.y > a.y ? low.x : high.x, b.x > a.x ? high.y : low.y}) < 0;
  }
  bool mayMeet(const Triangle& t) const {
    return std::max({t.a.x, t.b.x, t.c.x}) >= low.x && std::min({t.a.x, t.b.x, t.c.x}) <= high.x &&
           std::max({t.a.y, t.b.y, t.c.y}) >= low.y && std::min({t.a.y, t.b.y, t.c.y}) <= high.y &&
           !rightOf(t.a, t.b) && !rightOf(t.b, t.c) && !rightOf(t.c, t.a);
  }
};

/// A k-d tree of the corners that can lie in an ear. It halves them by x and y in turn until few are left, so
/// crowded places cost no more than empty ones. Corners can be removed.
class CornerTree {
 public:
  CornerTree(std::span<const LatticePoint> points, std::vector<int> corners)
      : points_{points}, corners_{std::move(corners)}, place_(points.size(), -1) {
    if (!corners_.empty()) build(0, 0, size(), true);
    for (int i = 0; i < size(); ++i) place_[corners_[i]] = i;
  }

  [[nodiscard]] bool has(int corner) const { return place_[corner] >= 0; }

  void remove(int corner) {
    const int place = place_[corner];
    place_[corner] = -1;
    int low = 0, high = size();
    for (std::size_t node = 0;;) {
      --nodes_[node].alive;
      if (high - low <= kLeaf) return;
      const int middle = (low + high) / 2;
      const bool right = place >= middle;
      (right ? low : high) = middle;
      node = 2 * node + (right ? 2 : 1);
    }
  }

  /// A corner in the closed triangle, or -1. Corners that coincide with a corner of the triangle do not
  /// count.
  [[nodiscard]] int findIn(const Triangle& t) const { return corners_.empty() ? -1 : find(t, 0, 0, size()); }

 private:
  static constexpr int kLeaf = 6;
  struct Node {
    EarBox box;
    int alive = 0;
  };

  [[nodiscard]] int size() const { return static_cast<int>(corners_.size()); }

  void build(std::size_t node, int low, int high, bool byX) {
    if (node >= nodes_.size()) nodes_.resize(2 * node + 1);
    EarBox box{points_[corners_[low]], points_[corners_[low]]};
    for (int i = low; i < high; ++i) {
      const LatticePoint& p = points_[corners_[i]];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    nodes_[node] = {box, high - low};
    if (high - low <= kLeaf) return;
    const int middle = (low + high) / 2;
    // break ties by number, so that the tree is the same on every machine
    const auto before = [&](int i, int j) {
      const std::int64_t a = byX ? points_[i].x : points_[i].y, b = byX ? points_[j].x : points_[j].y;
      return a != b ? a < b : i < j;
    };
    std::nth_element(corners_.begin() + low, corners_.begin() + middle, corners_.begin() + high, before);
    build(2 * node + 1, low, middle, !byX);
    build(2 * node + 2, middle, high, !byX);
  }

  [[nodiscard]] int find(const Triangle& t, std::size_t node, int low, int high) const {
    if (nodes_[node].alive == 0 || !nodes_[node].box.mayMeet(t)) return -1;
    if (high - low <= kLeaf) {
      for (int i = low; i < high; ++i) {
        const LatticePoint& p = points_[corners_[i]];
        if (has(corners_[i]) && t.contains(p) && !t.hasCorner(p)) return corners_[i];
      }
      return -1;
    }
    const int middle = (low + high) / 2;
    const int found = find(t, 2 * node + 1, low, middle);
    return found >= 0 ? found : find(t, 2 * node + 2, middle, high);
  }

  std::span<const LatticePoint> points_;
  std::vector<int> corners_;  ///< in tree order
  std::vector<int> place_;    ///< place of a corner in corners_, -1 if it is not in the tree
  std::vector<Node> nodes_;   ///< children of k at 2k + 1 and 2k + 2
};

class EarClipper {
 public:
  explicit EarClipper(std::span<const LatticePoint> outline)
      : p_{outline},
        previous_(outline.size()),
        next_(outline.size()),
        version_(outline.size(), 0),
        firstWaiting_(outline.size(), -1),
        tree_{outline, ring()} {}

  std::vector<std::array<int, 3>> run() {
    int left = static_cast<int>(p_.size());
    for (int v = 0; v < left; ++v) enqueue(v);
    for (std::size_t head = 0; left > 3; --left) {
      int ear = -1;
      while (ear < 0 && head < queue_.size()) {
        const Turn candidate = queue_[head++];
        if (isCurrent(candidate) && isEar(candidate.corner)) ear = candidate.corner;
      }
      cutOff(ear >= 0 ? ear : anyCorner());
    }
    triangles_.push_back({previous_[last_], last_, next_[last_]});
    return std::move(triangles_);
  }

 private:
  static constexpr int kGone = -1;

  /// A corner to be tested. The entry is stale after the corner is queued again or cut off.
  struct Turn {
    int corner, version;
  };
  struct Waiting {
    Turn turn;
    int next;
  };

  /// Links the corners and returns those that are not convex. Only these need testing: if any corner lies in
  /// a triangle of three successive corners, one of these does.
  std::vector<int> ring() {
    const int n = static_cast<int>(p_.size());
    std::vector<int> notConvex;
    for (int v = 0; v < n; ++v) {
      previous_[v] = (v + n - 1) % n;
      next_[v] = (v + 1) % n;
      if (!isConvex(v)) notConvex.push_back(v);
    }
    return notConvex;
  }

  [[nodiscard]] bool isConvex(int v) const { return turn(p_[previous_[v]], p_[v], p_[next_[v]]) > 0; }
  [[nodiscard]] bool isCurrent(const Turn& t) const { return version_[t.corner] == t.version; }

  /// Adds a corner at the end of the queue. A corner is queued again when a neighbour is cut off. So the cuts
  /// alternate along the outline, and the triangles grow evenly instead of fanning out from one corner.
  void enqueue(int v) { queue_.push_back({v, ++version_[v]}); }

  bool isEar(int v) {
    if (!isConvex(v)) return false;
    const int obstacle = tree_.findIn({p_[previous_[v]], p_[v], p_[next_[v]]});
    if (obstacle < 0) return true;
    waiting_.push_back({{v, version_[v]}, firstWaiting_[obstacle]});
    firstWaiting_[obstacle] = static_cast<int>(waiting_.size()) - 1;
    return false;
  }

  /// Removes a corner from the tree and queues the corners whose triangles it obstructed.
  void release(int obstacle) {
    tree_.remove(obstacle);
    for (int w = firstWaiting_[obstacle]; w >= 0; w = waiting_[w].next)
      if (isCurrent(waiting_[w].turn)) enqueue(waiting_[w].turn.corner);
    firstWaiting_[obstacle] = -1;
  }

  void cutOff(int v) {
    const int a = previous_[v], b = next_[v];
    triangles_.push_back({a, v, b});
    next_[a] = b;
    previous_[b] = a;
    version_[v] = kGone;
    last_ = a;
    if (tree_.has(v)) release(v);
    for (const int neighbour : {a, b}) {
      if (tree_.has(neighbour) && isConvex(neighbour)) release(neighbour);
      enqueue(neighbour);
    }
  }

  /// Chooses a corner when no ear is left, in an outline that crosses itself: the first obstructed convex
  /// corner that is still obstructed, otherwise any corner.
  int anyCorner() {
    for (; obstructed_ < waiting_.size(); ++obstructed_) {
      const Turn& t = waiting_[obstructed_].turn;
      if (isCurrent(t)) return t.corner;
    }
    return last_;
  }

  std::span<const LatticePoint> p_;
  std::vector<int> previous_, next_;  ///< a ring: the rest of the outline
  std::vector<int> version_;          ///< how often each corner was queued; kGone after it is cut off
  std::vector<Turn> queue_;
  std::vector<Waiting> waiting_;
  std::vector<int> firstWaiting_;  ///< first of the corners that wait for this one to go, -1 for none
  std::size_t obstructed_ = 0;     ///< entries of waiting_ before this one are stale
  int last_ = 0;                   ///< a corner of the rest of the outline
  CornerTree tree_;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace

std::vector<std::array<int, 3>> clipEars(std::span<const LatticePoint> outline) {
  return EarClipper{outline}.run();
}

}  // namespace xnewell
