#pragma once

#include <cstdint>
#include <vector>

#include "depthsort/box_grid.h"
#include "depthsort/depth_sort.h"
#include "depthsort/region.h"

namespace xnewell {

/// The tests of the depth sort for one pair of polygons.

/// A polygon as the tests see it.
struct Shape {
  const SnappedFace& face;
  int index;             ///< index of the face in its scene
  const ScreenBox& box;  ///< bounding box
  const Region* piece;   ///< the part of the face that the polygon is; null for the whole face
};

/// Which test settled a pair, and how.
struct Relation {
  Test test;
  Verdict verdict;
  bool contact = false;  ///< a part of the overlap did not count
};

/// All answers are exact, with one exception: whether a part of an overlap is a contact is estimated in
/// doubles. That only chooses between orders that are both exactly true.
class PairTests {
 public:
  PairTests(const SnappedScene& scene, const SortSettings& settings);

  /// Decides whether P may be painted before Q. It makes the tests in the textbook's order or in the quick
  /// one. For the quick one the caller must have compared the boxes.
  [[nodiscard]] Relation compare(const Shape& P, const Shape& Q);
  /// True if this one of the textbook's tests 1 to 5, made alone, says that P may be painted before Q. Tests
  /// 3 and 4 say nothing of two polygons in one plane.
  [[nodiscard]] bool passes(Test test, const Shape& P, const Shape& Q);
  /// True if Q's whole face covers P, and its plane is in front of all of P.
  [[nodiscard]] bool hides(const Shape& Q, const Shape& P);
  /// True if there is an overlap, where P is in front of Q, and it is more than a contact.
  [[nodiscard]] bool overlapCounts(const Shape& P, const Shape& Q);
  /// True if Q's plane properly crosses P. Then split() returns the parts of P behind it and in front of it.
  [[nodiscard]] bool crosses(const Shape& P, const Shape& Q) { return signsOver(P, Q).both(); }
  /// True unless the faces may touch (scene_planes.h) everywhere in a part of both.
  [[nodiscard]] bool isDeep(const Region& part, const SnappedFace& front, const SnappedFace& behind) const;
  struct Parts {
    Region behind, front;
  };
  [[nodiscard]] Parts split(const Shape& P, const Shape& Q);
  /// In a cycle, `before` is in front of A, and A is in front of `next`. True if that holds for no piece of A
  /// after Q's plane, which properly crosses A, has cut it.
  [[nodiscard]] bool separates(const Shape& before, const Shape& A, const Shape& next, const Shape& Q);
  /// The signs of zP - zQ in all of P. None means that both lie in one plane.
  [[nodiscard]] Signs signsOver(const Shape& P, const Shape& Q);

 private:
  [[nodiscard]] bool projectionsApart(const Shape& P, const Shape& Q);
  [[nodiscard]] bool apartAlongEdges(const SnappedFace& P, const SnappedFace& Q) const;
  [[nodiscard]] bool apartAlongSides(const Region& P, const Region& Q) const;
  /// Test 6.
  [[nodiscard]] Relation nearerInOverlap(const Shape& P, const Shape& Q);

  /// True if `part`, a part of the overlap or all of it, where one face is in front of the other, is more
  /// than a contact. It must be deep (tested only if they lie in two planes), and it must be wide or own a
  /// sample.
  [[nodiscard]] bool counts(const Region& part, const SnappedFace& front, const SnappedFace& behind) const;
  /// The plane of a face. It is made if need be.
  const ScreenPlane& planeOf(const SnappedFace& face);
  /// Regions::cut() of both planes. It remembers the last one, because a pair asks for it again and again.
  [[nodiscard]] const Line& nearer(const SnappedFace& p, const SnappedFace& q);
  /// The region of P. For a whole face it is made in `buffer`.
  [[nodiscard]] const Region& regionOf(const Shape& P, Region& buffer) const;
  /// Sets both_ to the common area of P and Q.
  void overlap(const Shape& P, const Shape& Q);

  const SnappedScene& scene_;
  int width_, height_;
  bool textbook_;
  ScenePlanes* planes_;  ///< of SortSettings
  Regions regions_;
  Region bufferP_, bufferQ_, both_, part_;
  Line line_;
};

}  // namespace xnewell
