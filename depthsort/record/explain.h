#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/region.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// The fragments of a recorded run by their ids: name, outline and extents, exactly as the sort had them.
/// They are computed on demand. The scene, the mesh and the run must outlive this object.
class Fragments {
 public:
  Fragments(const Mesh& mesh, const SnappedScene& scene, const SortedScene& sorted);

  [[nodiscard]] const SnappedFace& face(int id) const { return scene_->faces[faceIndex(id)]; }
  [[nodiscard]] int faceIndex(int id) const { return isPiece(id) ? sorted_->pieces[id - faces_].face : id; }
  [[nodiscard]] bool isPiece(int id) const { return id >= faces_; }
  [[nodiscard]] int parent(int piece) const { return sorted_->pieces[piece - faces_].parent; }
  /// The id of the k-th split's piece behind the plane. The piece in front has the next id.
  [[nodiscard]] int pieceOf(int k) const { return faces_ + 2 * k; }

  /// The region of a fragment. Work: one clip for each split that led to it.
  [[nodiscard]] Region region(int id) const;
  [[nodiscard]] Extents extents(int id) const;

  /// The name of a fragment. For a face it is the group's name if no other face has that group and it is not
  /// that of a role, P or Q, otherwise `face 12`. The second convex part of a divided face is `face 12.2`.
  /// The pieces of a face are `face 12a` behind the plane that split it and `face 12b` in front; their pieces
  /// add letters: `face 12ba`. After a name that ends in a letter a point comes first: `bar.a`.
  [[nodiscard]] std::string name(int id) const;
  /// True if the fragment is named by its group.
  [[nodiscard]] bool hasName(int id) const;
  /// number() is the face's number with its path: `12`, `12.2`, `12ba`. part() is what the fragment is a part
  /// of: its own name if it has one, otherwise its group's name, shortened, or "".
  [[nodiscard]] std::string number(int id) const;
  [[nodiscard]] std::string part(int id) const;

 private:
  /// The part of a divided face, then the letters of the splits: `.2ba`.
  [[nodiscard]] std::string path(int id) const;
  [[nodiscard]] const std::string& group(int id) const;

  const Mesh* mesh_;
  const SnappedScene* scene_;
  const SortedScene* sorted_;
  int faces_;
  Regions regions_;
  std::vector<int> splitter_;              ///< for each split: the plane that split
  std::map<std::string, int> facesNamed_;  ///< for each group name in the mesh: the number of faces
};

/// Explains a recorded event: the tests that were made, the numbers that decided, and a sentence. It computes
/// the numbers again from the fragments, with the predicates of the sort. Lengths and places are in pixels, z
/// is in pixels of the view plane, larger is nearer.

/// One of `take`, `test`, `move`, `cycle`, `impossible`, `contact`, `cut`, `paint`.
[[nodiscard]] std::string_view wordFor(Event::Kind kind);

/// Tests 3, 4, 3' and 4': whose corners they look at, and on which side of the other's plane these must lie:
/// 1 in front, -1 behind.
struct PlaneTest {
  bool ofP;
  int side;
};
[[nodiscard]] std::optional<PlaneTest> planeTestOf(Test test);

struct Range {
  double low = 0, high = 0;
  [[nodiscard]] bool overlaps(const Range& other) const { return low <= other.high && other.low <= high; }
};
/// A place on the screen, in pixels.
struct Place {
  double x = 0, y = 0;
};
/// A corner of a fragment and its distance along z from a plane.
struct CornerDistance {
  Place at;
  double inFront;  ///< negative if it is behind the plane
  int sign;        ///< exact, even if inFront rounds to 0
  bool mayBeOn;    ///< rounding explains the distance (scene_planes.h)
};
/// The distances of all corners, in the outline's order. `region` is all of `of` or a part of it.
[[nodiscard]] std::vector<CornerDistance> distancesFromPlane(const SnappedScene& scene, const Region& region,
                                                             const SnappedFace& of,
                                                             const SnappedFace& planeOf);
/// How many corners of a fragment lie in front of a plane (on the viewer's side), on it and behind it.
struct CornerCounts {
  int inFront = 0, on = 0, behind = 0;
  bool operator==(const CornerCounts&) const = default;
};
/// An edge whose line separates two fragments: one lies wholly on one side, the other on the other.
struct SeparatingEdge {
  bool ofP;  ///< true if it is an edge of P, false if of Q
  double fromX, fromY, toX, toY;
};
/// The common area of P and Q on the screen.
struct CommonArea {
  int corners = 0;
  double area = 0;  ///< square pixels
  CornerCounts P;   ///< the corners of the area, on P, relative to Q's plane
  Range aheadOfQ;   ///< zP - zQ
  /// the largest sum of both doubts (SnappedFace::doubt) in the area; a part in which one is nearer by more,
  /// as the planes of their own corners have it (scene_planes.h), is no contact
  double doubt = 0;
};

/// What sentences call two fragments: their names, or P and Q.
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
  /// How many corners of one fragment lie on which side of another's plane. Exact.
  [[nodiscard]] CornerCounts corners(int of, int fromPlaneOf) const;
  /// The corners one by one, in the outline's order.
  [[nodiscard]] std::vector<CornerDistance> distances(int of, int fromPlaneOf) const;
  /// The depth of a fragment's plane at any place.
  [[nodiscard]] double depth(int id, Place at) const;
  /// An edge that separates P and Q; nothing if their projections overlap. Exact.
  [[nodiscard]] std::optional<SeparatingEdge> separatingEdge(int P, int Q) const;
  /// The corners of the common area on the screen; none if P and Q do not overlap.
  [[nodiscard]] std::vector<Place> overlap(int P, int Q) const;
  /// The counts are exact; the rest is in doubles.
  [[nodiscard]] CommonArea commonArea(int P, int Q) const;

  // The sentences.

  /// The tests of a Compare event, in the order in which they were made. The last one settled the pair. All
  /// others failed, which proves nothing. Later tests were not made. Tests 3 and 4 are not made for two
  /// polygons in one plane.
  [[nodiscard]] std::vector<Test> testsMade(const Event& compare) const;
  /// True if a test of a plane that was made would pass if each corner were on the plane that may be on it.
  /// So who does the test by hand, without the rounding, finds that it settles the pair.
  [[nodiscard]] bool failsByRounding(const Event& compare, Test test) const;
  /// Chooses what sentences call P and Q. The sentence about taking P always gives its name.
  void call(Called called) { called_ = called; }

  /// The sentence for one test of a Compare event. `test` is one of testsMade().
  [[nodiscard]] std::string sentence(const Event& compare, Test test) const;
  /// The sentence for any event. For a Compare event it is about the test that settled the pair. `splits` is
  /// the number of splits before the event. `swapped`: the sentence calls P of the event Q, and Q of it P.
  [[nodiscard]] std::string sentence(const Event& event, int splits, bool swapped = false) const;

 private:
  [[nodiscard]] std::string called(int id, std::string_view letter) const {
    return called_ == Called::PAndQ ? std::string{letter} : name(id);
  }
  /// What a sentence calls a piece that is neither P nor Q. With P and Q it is the number from their list, or
  /// the name if there is one.
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
