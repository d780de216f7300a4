#pragma once

#include <array>
#include <string_view>

#include "depthsort/landmarks.h"
#include "x11/kit/transport.h"

namespace xnewell {

/// Where the parts of the depth-sort stepper are.

/// The boxes that the user ticks. A playing run stops at the steps of ticked boxes; the last box asks the
/// learner what follows.
inline constexpr int kStops = 6, kPolygonStop = 5, kPredict = 6, kToggleCount = 7;
inline constexpr std::array<std::string_view, kToggleCount> kToggleNames{
    "failed test", "move", "cycle", "cut", "paint", "polygon", "predict"};

/// The answers that a learner may give.
inline constexpr std::array<std::string_view, 3> kAnswers{"P first", "Q first", "they cross"};
inline constexpr std::array<char, 3> kAnswerKeys{'a', 'b', 'c'};

/// In units.
struct SortLayout : TransportLayout {
  bool shut = false;  ///< without list and side view, so that the picture is larger
  int line = 16;      ///< from one line of text to the next
  Rect body, picture;
  Rect headline;  ///< the finding in large letters; empty unless `shut`
  Rect table;     ///< the heading and the eight tests
  Rect finding;   ///< the white box under it
  std::array<Rect, kAnswers.size()> answers;
  Rect side;  ///< the side view; the list's bars stand below it; empty if `shut`
  Rect list;  ///< rows of `line` height, all of the column's width; empty if `shut`
  Rect counts;
  std::array<ControlPlace, kToggleCount> toggles;
  [[nodiscard]] int rows() const { return list.height / line; }
};
/// `body` is at least 744 x 428.
[[nodiscard]] SortLayout layoutOfSort(const Rect& body, bool shut = false);

}  // namespace xnewell
