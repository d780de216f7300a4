#pragma once

#include <array>
#include <string_view>

#include "depthsort/landmarks.h"
#include "x11/drawing/rect.h"

namespace xnewell {

/// Where the parts of the depth-sort stepper are, and which part a place belongs to.

/// The buttons under the table, from left to right.
enum class Transport { Start, TenBack, Back, Play, Forward, TenForward, End };
inline constexpr int kTransport = 7;

/// The boxes that the user ticks. A playing run stops at the steps of ticked boxes; the last box asks the
/// learner what follows.
inline constexpr int kStops = 6, kPolygonStop = 5, kPredict = 6, kToggleCount = 7;
inline constexpr std::array<std::string_view, kToggleCount> kToggleNames{
    "failed test", "move", "cycle", "cut", "paint", "polygon", "predict"};

/// The answers that a learner may give.
inline constexpr std::array<std::string_view, 3> kAnswers{"P first", "Q first", "they cross"};
inline constexpr std::array<char, 3> kAnswerKeys{'a', 'b', 'c'};

/// In pixels.
struct SortLayout {
  bool compact = false;
  int line = 16;  ///< from one line of text to the next
  Rect body, picture;
  Rect table;    ///< the heading and the eight tests
  Rect finding;  ///< the white box under it
  std::array<Rect, kAnswers.size()> answers;
  Rect side;  ///< the side view; the list's bars stand below it
  Rect list;  ///< rows of `line` height, all of the column's width
  Rect counts;
  std::array<Rect, kToggleCount> toggles;
  int rule = 0;  ///< y of the line above the buttons
  std::array<Rect, kTransport> transport;
  Rect step;  ///< where the number of the step is shown
  std::array<Rect, kLandmarks.size()> kinds;
  Rect speed;     ///< the slider's track, as high as its thumb
  Rect timeline;  ///< four lanes
  [[nodiscard]] int rows() const { return list.height / line; }
};
/// `body` is at least 768 x 428.
[[nodiscard]] SortLayout layoutOfSort(const Rect& body);

enum class SortPart { Nothing, Picture, Row, Toggle, Transport, Kind, Answer, Speed, Timeline };
struct SortSpot {
  SortPart part = SortPart::Nothing;
  int index = 0;  ///< index of the row, box, button, kind or answer
  bool operator==(const SortSpot&) const = default;
};
[[nodiscard]] SortSpot spotAt(const SortLayout& at, int x, int y);

/// Convert between a step and its column on the timeline: step 0 is at the left end, the last step at the
/// right end.
[[nodiscard]] int columnOf(const Rect& timeline, int step, int steps);
[[nodiscard]] int stepAt(const Rect& timeline, int x, int steps);

/// Steps per second, on a logarithmic track.
inline constexpr double kSlowest = 0.5, kFastest = 2000, kUsualSpeed = 5;
[[nodiscard]] int columnOfSpeed(const Rect& track, double speed);
[[nodiscard]] double speedAt(const Rect& track, int x);

}  // namespace xnewell
