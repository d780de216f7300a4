#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// Newell's depth sort, exact. It finds an order of painting in which no polygon is painted over a nearer
/// one, except for contacts (see below). It splits polygons where no such order exists.
///
/// P is the polygon farthest away. It is compared with every Q that is not yet painted and whose z-extent
/// reaches back to P's. The textbook's tests say whether P may be painted before Q. If not, and Q may be
/// painted before P, then Q goes first: it is marked and becomes the new P. If neither may go first, they
/// cross, and one of them is split. The textbook moves Q to the end of its list. Here the marked polygons are
/// a stack with P at its top, and the list stays sorted. (The order is the same. But once a move had unsorted
/// the list, the scan could no longer stop at the first Q beyond P's z-extent.) If a Q that must go first is
/// already marked, there is a cycle. Then one polygon of the cycle is split, if possible so that no piece of
/// it stays in the cycle, or one of its pairs is found to be a contact.
///
/// Polygons are compared over their common area on the screen. Q > P means that Q is nearer than P somewhere
/// in it. The plane records (project.h) define the depth. Of two faces in one plane, the later one of the
/// scene counts as nearer everywhere. No sample lies on a line (scanline.h), so polygons that only touch have
/// no order.
///
/// Why it ends, for every scene. A plane splits only a polygon that it properly crosses. Each piece then lies
/// on one side of that plane for good, so no plane splits a piece twice. The pieces of a face are cells
/// between the lines of at most n - 1 planes, so their number is finite. Between two splits, every step
/// settles a pair, marks a polygon or paints one. Only a split or a contact undoes a mark, and a contact
/// settles a pair.
///
/// Why every cycle A1 > A2 > ... > A1 has a proper split. Assume that it has none. Then each of the others
/// lies wholly in the closed back or wholly in the closed front of A1's plane. A1's successor is behind, and
/// A1's predecessor is in front. So on the way from one to the other, some X behind comes right before some Y
/// in front. X > Y says that zX >= zY somewhere, and they are equal only in one plane. But zY >= zA1 >= zX,
/// so all three lie in one plane. If this holds for every A1, the cycle is a cycle of face numbers, which
/// cannot exist.
///
/// Why it is right. Every order that is asserted is exactly true. P is painted when its order against
/// everything unpainted is settled in its favour. Contacts are orders that are true but not asserted
/// (pair_tests.h). Faces that touch in the model may cross because of its rounding: only where mayTouch()
/// (scene_planes.h) says so, or in a sliver without a sample. They are not split for that, and there the
/// farther one may show. The two faces at a sample were compared with each other, in a cycle too,
/// so doubts do not add up.
///
/// Where many polygons cross each other, nearly all pieces are hidden by others. There the quick run divides
/// the picture, and drops what is hidden before it is split (areas.h).
///
/// @see Newell, Newell and Sancha 1972; Foley & van Dam 2e §15.5.1

/// The tests that settle a pair, P against Q. The numbers 1 to 5 are the textbook's.
enum class Test : std::uint8_t {
  SamePlane,    ///< both lie in one plane: the later face is in front
  XExtents,     ///< 1: they are apart in x
  YExtents,     ///< 2: they are apart in y
  PBehindQ,     ///< 3: P is wholly on the far side of Q's plane
  QInFrontOfP,  ///< 4: Q is wholly on the near side of P's plane
  Projections,  ///< 5: the projections have no common area
  QBehindP,     ///< 3': Q is wholly on the far side of P's plane
  PInFrontOfQ,  ///< 4': P is wholly on the near side of Q's plane
  Overlap,      ///< 6: which one is nearer where they overlap
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

/// The line where two planes meet. The kept side is where planes[over] is nearer than planes[under], by the
/// sample rule.
struct CutLine {
  int over, under;
};

/// A rectangle of pixels: columns [left, right) of rows [top, bottom).
struct PixelArea {
  int left, top, right, bottom;
  bool operator==(const PixelArea&) const = default;
};
/// A part of a face, made by splits. It is the part of the face's outline where all its cut lines hold, in an
/// area. It has all attributes of the face: a split changes no shading.
struct Piece {
  int face;            ///< index into SnappedScene::faces
  int firstCut, cuts;  ///< range of SortedScene::cuts
  PixelArea area;      ///< the piece owns no sample outside of it
  int parent;          ///< fragment id
};
/// What is painted at once: a face or a piece. An id is the index of a face (0..#faces-1), or #faces + the
/// index of a piece.
struct Fragment {
  int face;
  int piece = -1;  ///< index into SortedScene::pieces; -1 for the whole face
};

/// One step of a recorded run. It tells what was decided, not how it looked.
struct Event {
  enum class Kind : std::uint8_t {
    Take,        ///< P is the farthest polygon that is left
    Compare,     ///< `test` settled P against Q, with `verdict`
    Move,        ///< Q goes first: it is marked and becomes P
    Cycle,       ///< Q should go first but is already marked
    Impossible,  ///< Q's plane does not properly cross P: no split
    Vain,   ///< Q's plane crosses P, but a piece of P would stay in the cycle: another split is looked for
    Void,   ///< P > Q is only a contact and does not count in the cycle; P is on top of the stack again
    Split,  ///< P is split by Q's plane. The k-th split makes pieces 2k (behind the plane) and 2k + 1. If P
            ///< was in the stack, it leaves it, with all above it.
    Paint,  ///< P is painted
  };
  Kind kind;
  Test test = Test::SamePlane;
  Verdict verdict = Verdict::PFirst;
  bool contact = false;  ///< for Test::Overlap: a part of the overlap did not count
  int P, Q = -1;         ///< fragment ids
};
static_assert(sizeof(Event) == 12);

/// Counts of the run that painted. What a run did that gave up (areas.h) is not counted.
struct SortStatistics {
  std::array<std::int64_t, kTests> settled{};  ///< pairs that each test settled
  /// In the quick run only: the Q's that were skipped, without an event, because their boxes are apart in x,
  /// or in y.
  std::array<std::int64_t, 2> boxesApart{};
  std::int64_t moves = 0, cycles = 0, impossible = 0, vain = 0, splits = 0, voids = 0, contacts = 0;
  std::int64_t free = 0;  ///< polygons that were painted without a test (free_polygons.h)
  int deepest = 0;  ///< most polygons marked at once; in a BSP tree, most nodes on the way from the root
  std::int64_t areas = 0;       ///< into which the picture was divided; 0 if it was not (areas.h)
  std::int64_t hidden = 0;      ///< polygons that were left out, or cut, because they are hidden
  std::int64_t nodes = 0;       ///< of a BSP tree (bsp_tree.h)
  std::int64_t depthTests = 0;  ///< of a z-buffer: depths that were compared (z_buffer.h)
  /// What the method keeps while it paints: the list of bytesOf(), with the nodes of a BSP tree; or a
  /// z-buffer. 0 for the oracle.
  std::int64_t bytes = 0;
  [[nodiscard]] std::int64_t pairs() const {
    std::int64_t sum = 0;
    for (const std::int64_t count : settled) sum += count;
    return sum;
  }
};

/// How many pieces an order makes before it gives up. Each takes some hundred bytes while it waits.
inline constexpr int kMostPieces = 5'000'000;

class ScenePlanes;

struct SortSettings {
  int width, height;  ///< size of the picture in pixels
  /// True for the textbook's run, for learners. It takes every Q in the list whose z-extent reaches back to
  /// P's, in order of farthest z; the tests are 1, 2, 3, 4, 5, 3', 4', 6; no polygon is left out. False for
  /// the quick run. It finds the Q's through a grid, paints free polygons without a test
  /// (free_polygons.h), makes test 5 before 3 and 4, and leaves out faces that do not show. Both paint the
  /// same picture.
  bool textbook = false;
  /// True if the polygons are painted with their vertices rounded to pixels (fill_polygons.h). Then faces
  /// without a sample may show.
  bool inPixels = false;
  /// For the quick run: true if only the samples of a picture must be right. If false, the order is right at
  /// every place; no polygon counts as free, and none is left out because it has no sample.
  bool samples = true;
  bool grid = true;  ///< for the quick run; if false, the Q's come from one list
  /// True if the quick run may divide the picture (areas.h). A run that records does not.
  bool areas = true;
  /// After so many splits, polygons that one face hides are left out, if the picture is not divided: most
  /// pieces are hidden where many polygons cross.
  std::int64_t keepHidden = std::numeric_limits<std::int64_t>::max();
  ScenePlanes* planes =
      nullptr;          ///< makes those planes of the scene that are compared; null if all are there
  bool record = false;  ///< fills SortedScene::list and events
  std::size_t mostEvents = std::size_t{1} << 24;  ///< of 12 bytes each
  int mostPieces = kMostPieces;
  /// which of P and Q is split if they cross
  enum class Split { Smaller, First, Second } crossing = Split::Smaller;
};

struct SortedScene {
  std::vector<Fragment> fragments;  ///< in painting order
  std::vector<Piece> pieces;        ///< every piece ever made, also those that were split again
  std::vector<CutLine> cuts;
  std::vector<int> list;  ///< the faces in the order of the list at the start; P's are taken in this order
  std::vector<Event> events;
  SortStatistics statistics;
};

/// The size of the fragments, pieces and cuts.
[[nodiscard]] std::int64_t bytesOf(const SortedScene& sorted);

/// The errors if a run has more events than it may record, or makes more pieces than it may.
struct TooLongRun : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct TooManyEvents : TooLongRun {
  using TooLongRun::TooLongRun;
};
struct TooManyPieces : TooLongRun {
  using TooLongRun::TooLongRun;
};
/// @param who  "the depth sort"
[[nodiscard]] TooManyPieces tooManyPieces(std::string_view who, int most);

/// Sorts a scene. @throws TooManyPieces, and TooManyEvents if it records
[[nodiscard]] SortedScene depthSort(const SnappedScene& scene, const SortSettings& settings);

}  // namespace xnewell
