#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/fragments.h"

namespace xnewell {

/// What a recorded event means: the tests that were made, the numbers that decided, and a sentence. Numbers
/// are computed again from the fragments, by the predicates of the sort. Lengths and places are in pixels,
/// z in pixels of the view plane, larger is nearer.

/// `take`, `test`, `move`, `cycle`, `impossible`, `contact`, `cut`, `paint`.
[[nodiscard]] std::string_view wordFor(Event::Kind kind);

struct Range {
  double low = 0, high = 0;
  [[nodiscard]] bool overlaps(const Range& other) const { return low <= other.high && other.low <= high; }
};
/// A place on the screen, in pixels.
struct Place {
  double x = 0, y = 0;
};
/// A corner of a fragment and its distance from a plane, along z.
struct CornerDistance {
  Place at;
  double inFront;  ///< below 0: behind it
  int sign;        ///< exact, also where inFront rounds to 0
};
/// How many corners of a fragment lie on the viewer's side of a plane, on it and beyond it.
struct CornerCounts {
  int inFront = 0, on = 0, behind = 0;
  bool operator==(const CornerCounts&) const = default;
};
/// A line along an edge, with all of one fragment on one side and all of the other one on the other.
struct SeparatingEdge {
  bool ofP;  ///< the edge is P's, else Q's
  double fromX, fromY, toX, toY;
};
/// What P and Q have in common on the screen.
struct CommonArea {
  int corners = 0;
  double area = 0;   ///< square pixels
  CornerCounts P;    ///< its corners on P, as seen from Q's plane
  Range aheadOfQ;    ///< zP - zQ
  double doubt = 0;  ///< of both, at most (SnappedFace::doubt): a part with a larger |zP - zQ| is no contact
};

/// How sentences about two fragments call them: by name, or as P and Q of a list of numbers.
enum class Called { ByName, PAndQ };

class Explainer {
 public:
  Explainer(const Mesh& mesh, const SnappedScene& scene, const SortedScene& sorted, bool textbook)
      : scene_{&scene}, textbook_{textbook}, fragments_{mesh, scene, sorted}, regions_{scene} {}

  [[nodiscard]] const Fragments& fragments() const { return fragments_; }
  [[nodiscard]] std::string name(int id) const { return fragments_.name(id); }

  // The numbers.

  [[nodiscard]] Range xExtent(int id) const;
  [[nodiscard]] Range yExtent(int id) const;
  [[nodiscard]] Range zExtent(int id) const;
  /// Where the corners of one fragment lie from the plane of another. Exact.
  [[nodiscard]] CornerCounts corners(int of, int fromPlaneOf) const;
  /// One by one, in the outline's order.
  [[nodiscard]] std::vector<CornerDistance> distances(int of, int fromPlaneOf) const;
  /// Of the plane of a fragment at any place.
  [[nodiscard]] double depth(int id, Place at) const;
  /// Nothing where the projections overlap. Exact.
  [[nodiscard]] std::optional<SeparatingEdge> separatingEdge(int P, int Q) const;
  /// Its corners on the screen; none where they do not overlap.
  [[nodiscard]] std::vector<Place> overlap(int P, int Q) const;
  /// Counts are exact; the rest is in doubles.
  [[nodiscard]] CommonArea commonArea(int P, int Q) const;

  // The sentences.

  /// The tests of a Compare event in the order in which they were made: all but the last one failed, which
  /// proves nothing, and the last settled the pair. A test behind it was not made; nor are 3 and 4 for two
  /// in one plane.
  [[nodiscard]] std::vector<Test> testsMade(const Event& compare) const;
  /// But for the sentence about taking P, which tells which one it is.
  void call(Called called) { called_ = called; }

  /// Of one test of a Compare event, one of testsMade().
  [[nodiscard]] std::string sentence(const Event& compare, Test test) const;
  /// Of any event; of a Compare event, that of the test that settled the pair. `splits` is how many there
  /// were before it.
  [[nodiscard]] std::string sentence(const Event& event, int splits) const;

 private:
  [[nodiscard]] std::string called(int id, std::string_view letter) const {
    return called_ == Called::PAndQ ? std::string{letter} : name(id);
  }
  /// A piece that has no letter: beside P and Q, as their list has it.
  [[nodiscard]] std::string listed(int id) const {
    return called_ == Called::PAndQ && !fragments_.hasName(id) ? fragments_.number(id) : name(id);
  }
  [[nodiscard]] std::string settled(const Event& compare) const;
  [[nodiscard]] std::string failed(const Event& compare, Test test) const;
  [[nodiscard]] double pixels(double zSteps) const;
  [[nodiscard]] Region common(int P, int Q) const;

  const SnappedScene* scene_;
  bool textbook_;
  Called called_ = Called::ByName;
  Fragments fragments_;
  Regions regions_;
};

}  // namespace xnewell
