#pragma once

#include <cstdint>
#include <vector>

#include "depthsort/box_grid.h"
#include "depthsort/depth_sort.h"
#include "depthsort/extents.h"
#include "depthsort/region.h"

namespace xnewell {

/// The tests of the depth sort on one pair of polygons.

/// A polygon as the tests see it.
struct Shape {
  const SnappedFace& face;
  int index;             ///< of the face in its scene
  const ScreenBox& box;  ///< around it
  const Region* piece;   ///< the part of the face that it is; null: the whole face
};

/// What settled a pair, and how.
struct Relation {
  Test test;
  Verdict verdict;
  bool contact = false;  ///< a part of the overlap did not count
};

/// All answers are exact, but for what is a contact: that is estimated in doubles, and only chooses among
/// orders that are all exactly true.
class PairTests {
 public:
  PairTests(const SnappedScene& scene, const SortSettings& settings);

  /// Whether a face's plane passes through its vertices.
  [[nodiscard]] bool vertexDepthsAreExact(const SnappedFace& face) const {
    return xnewell::vertexDepthsAreExact(face, shared_);
  }
  /// May P be painted before Q? In the textbook's order of tests or in the quick one, whose caller has
  /// compared the boxes.
  [[nodiscard]] Relation compare(const Shape& P, const Shape& Q);
  /// Whether the overlap is more than a contact.
  [[nodiscard]] bool overlapCounts(const Shape& P, const Shape& Q);
  /// Whether Q's plane properly crosses P, and the parts of P behind and in front of it.
  [[nodiscard]] bool crosses(const Shape& P, const Shape& Q) { return signsOver(P, Q).both(); }
  struct Parts {
    Region behind, front;
  };
  [[nodiscard]] Parts split(const Shape& P, const Shape& Q);

 private:
  [[nodiscard]] bool projectionsApart(const Shape& P, const Shape& Q);
  [[nodiscard]] bool apartAlongEdges(const SnappedFace& P, const SnappedFace& Q) const;
  [[nodiscard]] bool apartAlongSides(const Region& P, const Region& Q) const;
  /// Signs of zP - zQ all over P.
  [[nodiscard]] Signs signsOver(const Shape& P, const Shape& Q);
  /// Test 6.
  [[nodiscard]] Relation nearerInOverlap(const Shape& P, const Shape& Q);

  /// Whether a part of the overlap, or all of it, is more than a contact: deeper than the doubt of both
  /// (asked only if they are in two planes), and wide or owner of a sample.
  [[nodiscard]] bool counts(const Region& part, const SnappedFace& p, const SnappedFace& q) const;
  /// Whether zP and zQ are further apart than both may be off, somewhere in the part.
  [[nodiscard]] bool isDeep(const Region& part, const SnappedFace& p, const SnappedFace& q) const;

  /// Regions::cut() of both planes, remembered: a pair asks for it again and again.
  [[nodiscard]] const Line& nearer(const SnappedFace& p, const SnappedFace& q);
  /// Of a whole face made in `buffer`.
  [[nodiscard]] const Region& regionOf(const Shape& P, Region& buffer) const;
  /// Into both_.
  void overlap(const Shape& P, const Shape& Q);

  const SnappedScene& scene_;
  int width_, height_;
  bool textbook_;
  Regions regions_;
  std::vector<std::uint8_t> shared_;  ///< facesOfPlanes()
  Region bufferP_, bufferQ_, both_, part_;
  Line line_;
};

}  // namespace xnewell
