#pragma once

#include <array>
#include <string_view>

#include "depthsort/record/replay.h"
#include "x11/kit/transport.h"

namespace xnewell {

/// Where the parts of the depth-sort stepper are.

/// The boxes that the user ticks. A playing run stops at the steps of ticked boxes; then one box asks the
/// learner what follows, and with the last one the learner sorts.
inline constexpr int kStops = 6, kPolygonStop = 5, kPredict = 6, kOwn = 7, kToggleCount = 8;
inline constexpr std::array<std::string_view, kToggleCount> kToggleNames{
    "failed test", "move", "cycle", "cut", "paint", "polygon", "predict", "by hand"};

/// The answers that a learner may give.
inline constexpr std::array<std::string_view, 3> kAnswers{"P first", "Q first", "they cross"};
inline constexpr std::array<char, 3> kAnswerKeys{'a', 'b', 'c'};

/// What a student who sorts may do with P and Q, beside naming one of the tests.
inline constexpr std::array<std::string_view, 4> kActs{"paint P", "move Q before P", "cut P by Q",
                                                       "cut Q by P"};
inline constexpr std::array<char, 4> kActKeys{'p', 'm', 'c', 's'};
inline constexpr int kOwnTests = 5;  ///< the textbook's

/// In units.
struct SortLayout : TransportLayout {
  bool shut = false;  ///< without list and side view, so that the picture is larger
  int line = 16;      ///< from one line of text to the next
  Rect body, picture;
  Rect well;      ///< the ground around the picture
  Rect headline;  ///< the finding in large letters; empty unless `shut`
  Rect table;     ///< the heading and the eight tests, or five if `own`
  Rect finding;   ///< the white box under it
  std::array<Rect, kAnswers.size()> answers;
  std::array<Rect, kActs.size()> acts;
  [[nodiscard]] Rect testRow(int index) const {
    return {table.x, table.y + heading + index * line, table.width, line};
  }
  int heading = 0;  ///< the height of the table's heading
  Rect side;        ///< the side view; the list's bars stand below it; empty if `shut`
  Rect list;        ///< rows of `line` height, all of the column's width; empty if `shut`
  Rect ring;        ///< of a cycle: it has the lower rows of the list, or the room below the finding
  Rect counts;
  std::array<ControlPlace, kToggleCount> toggles;
  [[nodiscard]] int rows() const { return list.height / line; }
};
/// `body` is at least 744 x 428. With `own` the finding takes the rows of the tests that only the program
/// makes; all other parts stay where they are.
[[nodiscard]] SortLayout layoutOfSort(const Rect& body, bool shut = false, bool own = false);

}  // namespace xnewell
