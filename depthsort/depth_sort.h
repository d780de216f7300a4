#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// Newell's depth sort, exact: an order of painting in which nothing is painted over what is nearer, but
/// for contacts (below), with polygons split where no such order exists.
///
/// P is taken from the far end. Against every Q that is not painted yet and whose z-extent reaches back to
/// P's, the textbook's tests say whether P may be painted before Q; if not, and Q may go before P, then Q
/// comes first: it is marked and becomes the new P. The textbook moves Q to the end of its list; here the
/// marked polygons are a stack, whose top is P, and the list stays sorted. (The order is the same; the
/// list, once moves have unsorted it, could no longer stop its scan at the first Q beyond P's z-extent.) A Q
/// that must come first and is marked already closes a cycle: one of the cycle is split, or found a contact.
///
/// Polygons are compared over their common area on the screen: Q > P, Q is nearer than P somewhere in it.
/// Depth there is what the plane records say (project.h). Of two faces in one plane the later one of the
/// scene counts as nearer, everywhere. No sample lies on any line (scanline.h), so what only touches is
/// in no order.
///
/// Why it ends, whatever the scene. A plane splits only what it properly crosses, and each piece lies to one
/// side of it for good: so no plane splits a piece twice, and the pieces of a face, cells between the lines
/// of at most n - 1 planes, are finite in number. Between two splits a pair is settled, a polygon marked or
/// one painted, and none of that is undone without a split or a void mark.
///
/// That there is a proper split in every cycle A1 > A2 > ... > A1: else all others lie wholly in the closed
/// back or front of A1's plane. Going from A1's successor, behind, to its predecessor, in front, some X
/// behind comes right before a Y in front. X > Y says zX >= zY somewhere, equal only in one plane; with zY >=
/// zA1 >= zX all three are in one plane. If that is so at every such step, the cycle is one of face numbers,
/// which cannot go in a circle.
///
/// Why it is right. Every order that is asserted is exactly true, and P is painted when all orders against
/// what is still unpainted are settled in its favour. Contacts are orders that are true and not asserted
/// (pair_tests.h): what touches in the model may cross by its rounding, in no more depth than
/// SnappedFace::doubt allows, or in a sliver without a sample. It is not split for that, and there the
/// farther may show.
///
/// @see Newell, Newell and Sancha 1972; Foley & van Dam 2e §15.5.1

/// The tests that settle a pair, P against Q. 1 to 5 as the textbook counts them.
enum class Test : std::uint8_t {
  SamePlane,    ///< both in one plane: the later face is in front
  XExtents,     ///< 1: apart in x
  YExtents,     ///< 2: apart in y
  PBehindQ,     ///< 3: P is wholly on the far side of Q's plane
  QInFrontOfP,  ///< 4: Q is wholly on the near side of P's plane
  Projections,  ///< 5: the projections have no common area
  QBehindP,     ///< 3': Q is wholly on the far side of P's plane
  PInFrontOfQ,  ///< 4': P is wholly on the near side of Q's plane
  Overlap,      ///< 6: which is nearer where they overlap
};
inline constexpr int kTests = 9;
struct TestRow {
  Test id;
  std::string_view name, asks;
};
inline constexpr std::array<TestRow, kTests> kTestRows{{
    {Test::SamePlane, "plane", "do both lie in one plane?"},
    {Test::XExtents, "1", "do the x-extents not overlap?"},
    {Test::YExtents, "2", "do the y-extents not overlap?"},
    {Test::PBehindQ, "3", "is P wholly on the far side of Q's plane?"},
    {Test::QInFrontOfP, "4", "is Q wholly on the near side of P's plane?"},
    {Test::Projections, "5", "do the projections not overlap?"},
    {Test::QBehindP, "3'", "is Q wholly on the far side of P's plane?"},
    {Test::PInFrontOfQ, "4'", "is P wholly on the near side of Q's plane?"},
    {Test::Overlap, "6", "where they overlap, which is nearer?"},
}};
enum class Verdict : std::uint8_t { PFirst, QFirst, Crossing };

/// Where planes[over] is nearer than planes[under], by the sample rule.
struct CutLine {
  int over, under;
};

/// A face or, after splits, a part of one: its outline's part where all its cut lines hold. All of its
/// attributes are the face's: a split changes no shading.
struct Piece {
  int face;            ///< index into SnappedScene::faces
  int firstCut, cuts;  ///< range of SortedScene::cuts
  int firstRow, rows;  ///< of the picture: all that it may reach into
  int parent;          ///< fragment id
};
/// What is painted at once. An id names a face (0..#faces-1) or a piece (#faces + index into pieces).
struct Fragment {
  int face;
  int piece = -1;  ///< index into SortedScene::pieces; -1: the whole face
};

/// One step of a run, for whoever wants to follow it: what was decided, not how it looked.
struct Event {
  enum class Kind : std::uint8_t {
    Take,        ///< P is the farthest that is left
    Compare,     ///< `test` settled P against Q, with `verdict`
    Move,        ///< Q goes first: it is marked and becomes P
    Cycle,       ///< Q, marked already, should go first
    Impossible,  ///< P is not properly crossed by Q's plane: no split
    Void,        ///< P > Q does not count in the cycle: a contact; P is on top of the stack again
    Split,       ///< P is split by Q's plane, the k-th of all splits into pieces 2k (behind it) and 2k + 1;
                 ///< P leaves the stack, with all above it, if it was there
    Paint,       ///< P is painted
  };
  Kind kind;
  Test test = Test::SamePlane;
  Verdict verdict = Verdict::PFirst;
  bool contact = false;  ///< of Test::Overlap: a part of the overlap did not count
  int P, Q = -1;         ///< fragment ids
};
static_assert(sizeof(Event) == 12);

struct SortStatistics {
  std::array<std::int64_t, kTests> settled{};  ///< pairs that each test settled
  /// Of the quick run: Q's dropped on the way, without an event, for boxes apart in x, or in y.
  std::array<std::int64_t, 2> boxesApart{};
  std::int64_t moves = 0, cycles = 0, impossible = 0, splits = 0, voids = 0, contacts = 0;
  int deepest = 0;  ///< marked polygons at once
  [[nodiscard]] std::int64_t pairs() const {
    std::int64_t sum = 0;
    for (const std::int64_t count : settled) sum += count;
    return sum;
  }
};

struct SortSettings {
  int width, height;  ///< the picture in pixels
  /// The textbook's run, for learners: every Q in the list whose z-extent reaches back to P's, in order of
  /// farthest z, tests 1, 2, 3, 4, 5, 3', 4', 6, and no polygon left out. Else the quick one: Q's found
  /// through a grid, P's taken from one part of the screen after the other, test 5 before 3 and 4,
  /// and faces that show nowhere left out. Both paint the same picture.
  bool textbook = false;
  /// The polygons are to be painted with their vertices rounded to pixels (fill_polygons.h): faces without a
  /// sample may show.
  bool inPixels = false;
  bool grid = true;                               ///< of the quick run: else Q's come from one list
  bool record = false;                            ///< fills SortedScene::list and events
  std::size_t mostEvents = std::size_t{1} << 27;  ///< of 12 bytes
  enum class Split { Smaller, First, Second } crossing = Split::Smaller;  ///< of P and Q, which is split
};

struct SortedScene {
  std::vector<Fragment> fragments;  ///< in painting order
  std::vector<Piece> pieces;        ///< all that ever were, also those split again
  std::vector<CutLine> cuts;
  std::vector<int> list;  ///< the faces as the list has them at the start, P's are taken in this order
  std::vector<Event> events;
  SortStatistics statistics;
};

/// A run with more events than were to be recorded.
struct TooManyEvents : std::length_error {
  using std::length_error::length_error;
};

/// @throws TooManyEvents only where it records
[[nodiscard]] SortedScene depthSort(const SnappedScene& scene, const SortSettings& settings);

}  // namespace xnewell
