#pragma once

#include <array>
#include <string_view>

#include "depthsort/landmarks.h"
#include "x11/drawing/rect.h"

namespace xnewell {

/// Where the parts of the depth-sort stepper are, and which of them a place belongs to.

/// The buttons under the table, from the left.
enum class Transport { Start, TenBack, Back, Play, Forward, TenForward, End };
inline constexpr int kTransport = 7;

/// The boxes to tick: a run that plays stops at these steps; the last one asks what follows.
inline constexpr int kStops = 6, kPolygonStop = 5, kPredict = 6, kToggleCount = 7;
inline constexpr std::array<std::string_view, kToggleCount> kToggleNames{
    "failed test", "move", "cycle", "cut", "paint", "polygon", "predict"};

/// What follows, as a learner may answer.
inline constexpr std::array<std::string_view, 3> kAnswers{"P first", "Q first", "they cross"};
inline constexpr std::array<char, 3> kAnswerKeys{'a', 'b', 'c'};

/// In pixels.
struct SortLayout {
  bool compact = false;
  int line = 16;  ///< from one line of text to the next
  Rect body, picture;
  Rect table;    ///< its heading and the eight tests
  Rect finding;  ///< the white box under it
  std::array<Rect, kAnswers.size()> answers;
  Rect side;  ///< the side view; the list's bars stand below it
  Rect list;  ///< rows of `line` height, all of the column's width
  Rect counts;
  std::array<Rect, kToggleCount> toggles;
  int rule = 0;  ///< y of the line above the buttons
  std::array<Rect, kTransport> transport;
  Rect step;  ///< where the step's number is told
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
  int index = 0;  ///< of the row, box, button, kind or answer
  bool operator==(const SortSpot&) const = default;
};
[[nodiscard]] SortSpot spotAt(const SortLayout& at, int x, int y);

/// Between a step and its column on the timeline: 0 at the left end, all steps at the right one.
[[nodiscard]] int columnOf(const Rect& timeline, int step, int steps);
[[nodiscard]] int stepAt(const Rect& timeline, int x, int steps);

/// Steps a second, on a logarithmic track.
inline constexpr double kSlowest = 0.5, kFastest = 2000, kUsualSpeed = 5;
[[nodiscard]] int columnOfSpeed(const Rect& track, double speed);
[[nodiscard]] double speedAt(const Rect& track, int x);

}  // namespace xnewell
