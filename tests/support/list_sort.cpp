#include "tests/support/list_sort.h"

#include <algorithm>
#include <iterator>
#include <list>

namespace xnewell {

namespace {

ExactLine negative(const ExactLine& l) { return {-l.a, -l.b, -l.c}; }

Rational least(const ExactLine& l, const ExactRegion& region) { return -greatest(negative(l), region); }

class ListSort {
 public:
  ListSort(const SnappedScene& scene, const ListSettings& settings) : scene_{scene}, settings_{settings} {
    for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f)
      insert(polygon(f, exactOutline(scene, scene.faces[f])));
  }

  ListSorted run() {
    while (!list_.empty()) {
      if (sorted_.splits == settings_.mostSplits) {
        sorted_.endless = true;
        break;
      }
      step();
    }
    return std::move(sorted_);
  }

 private:
  using Place = std::list<ListPolygon>::iterator;

  [[nodiscard]] const ScreenPlane& plane(const ListPolygon& P) const {
    return scene_.planes[scene_.faces[P.face].plane];
  }
  [[nodiscard]] ListPolygon polygon(int face, ExactRegion region) const {
    const ExactLine z = exactDifference(scene_.planes[scene_.faces[face].plane], {});
    ListPolygon P{face, std::move(region), 0, 0, false};
    P.zFar = least(z, P.region), P.zNear = greatest(z, P.region);
    return P;
  }
  /// Inserts P behind all that are as far.
  void insert(ListPolygon P) {
    list_.insert(
        std::ranges::find_if(list_, [&](const ListPolygon& Q) { return !Q.marked && Q.zFar > P.zFar; }),
        std::move(P));
  }

  /// Tests 1 to 5: true if P may be painted before Q. In one plane the later face of the scene is in front.
  [[nodiscard]] bool mayGoFirst(const ListPolygon& P, const ListPolygon& Q) const {
    for (const ExactLine& along : {ExactLine{1, 0, 0}, ExactLine{0, 1, 0}})
      if (greatest(along, P.region) <= least(along, Q.region) ||
          greatest(along, Q.region) <= least(along, P.region))
        return true;
    return liesBehind(P, Q) || common(P.region, Q.region).empty();
  }
  /// Test 3 (P wholly behind Q's plane) or test 4 (Q wholly in front of P's plane). With P and Q exchanged
  /// they are 3' and 4'.
  [[nodiscard]] bool liesBehind(const ListPolygon& P, const ListPolygon& Q) const {
    const ExactLine ahead = exactDifference(plane(P), plane(Q));
    if (ahead.a == 0 && ahead.b == 0 && ahead.c == 0) return P.face <= Q.face;
    return greatest(ahead, P.region) <= 0 || greatest(ahead, Q.region) <= 0;
  }

  void step() {
    const Place P = list_.begin();
    for (Place Q = std::next(P); Q != list_.end(); ++Q) {
      if (Q->zFar > P->zNear) {
        if (settings_.stopAtFirstBeyond) break;
        continue;
      }
      if (mayGoFirst(*P, *Q)) continue;
      if (!Q->marked && liesBehind(*Q, *P)) {
        Q->marked = true;
        list_.splice(list_.begin(), list_, Q);
        ++sorted_.moves;
      } else {
        split(P, plane(*Q));
      }
      return;
    }
    sorted_.painted.push_back(std::move(*P));
    list_.erase(P);
  }

  void split(Place P, const ScreenPlane& by) {
    const ListPolygon whole = std::move(*P);
    list_.erase(P);
    ++sorted_.splits;
    const ExactLine ahead = exactDifference(plane(whole), by);
    const ExactRegion behind = clipped(whole.region, negative(ahead)), front = clipped(whole.region, ahead);
    sorted_.idle += behind.empty() || front.empty();
    for (const ExactRegion& part : {behind, front}) {
      if (part.empty()) continue;
      ListPolygon piece = polygon(whole.face, part);
      piece.marked = settings_.piecesInheritMarks && whole.marked;
      insert(std::move(piece));
    }
  }

  const SnappedScene& scene_;
  ListSettings settings_;
  std::list<ListPolygon> list_;
  ListSorted sorted_;
};

}  // namespace

ListSorted listSort(const SnappedScene& scene, const ListSettings& settings) {
  return ListSort{scene, settings}.run();
}

}  // namespace xnewell
