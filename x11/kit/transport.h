#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "x11/kit/control.h"

namespace xnewell {

/// The lower part of a page that steps along a run: buttons, the number of the step, the kind of step to jump
/// to, the speed, and the run as a timeline. All pages with steps share it.

/// The buttons: to the start, ten back, one back, play, one forward, ten forward, to the end.
inline constexpr int kTransport = 7, kPlay = 3;
inline constexpr int kShiftSteps = 10;
/// The keys that the buttons stand for.
inline constexpr std::array<Key, kTransport> kTransportKeys{
    Key{NamedKey::Home}, {NamedKey::Left, 0, true},  {NamedKey::Left}, {NamedKey::Space},
    {NamedKey::Right},   {NamedKey::Right, 0, true}, {NamedKey::End}};

/// Steps a second. Two presses of a key double the speed.
inline constexpr TrackRange kSpeeds{.low = 0.5, .high = 2000, .step = 0.04178, .logarithmic = true};
inline constexpr double kUsualSpeed = 5;

/// Counts the steps that are due while a run plays.
class StepClock {
 public:
  static constexpr int kTick = 40;  ///< milliseconds from tick to tick
  void restart() { due_ = 0; }
  /// Another tick has passed.
  void tick(double speed) { due_ += speed * kTick / 1000.0; }
  /// True if a step is due, which is then taken.
  [[nodiscard]] bool takeStep() { return due_ >= 1.0 && (due_ -= 1.0, true); }

 private:
  double due_ = 0;
};

/// In units.
struct TransportLayout {
  bool compact = false, narrow = false;
  int left = 0;  ///< of the names of the lanes
  int rule = 0;  ///< y of the line above the buttons
  std::array<Rect, kTransport> transport;
  Rect step;  ///< where the number of the step is shown
  ControlPlace kinds, speed;
  Rect timeline;
};
/// How much of a body's lower end it takes, from the rule on.
[[nodiscard]] constexpr int transportHeight(bool compact) { return compact ? 84 : 104; }
/// `kinds` are the names of the kinds of step.
[[nodiscard]] TransportLayout layoutOfTransport(const Rect& body, bool compact, bool narrow,
                                                std::span<const std::string> kinds);

/// The column of a step on the timeline: step 0 is at the left end, the last step at the right end.
[[nodiscard]] int columnOf(const Rect& timeline, int step, int steps);

/// A lane of the timeline: the steps of one kind.
struct Lane {
  std::string_view name;
  const std::vector<int>& steps;
  Cell cell = Cell::Ink;
  bool many = false;   ///< so many steps that a mark's height tells how many are there
  bool ahead = false;  ///< later steps have the colour, too
};

/// What the page shows.
struct TransportState {
  int step = 0, steps = 0;
  bool playing = false;
  double speed = kUsualSpeed;
  bool asking = false;  ///< lanes show no later steps, which would give the answer away
};
/// The controls, by the part of their name (ControlId), whose key is none.
enum class TransportPart { Timeline = 1, Speed, Kinds, Button = 20 };
[[nodiscard]] constexpr ControlId transportId(TransportPart part, int index = 0) {
  return {0, static_cast<int>(part) + index};
}
/// The run's steps as a slider, the speed, the kinds, and the buttons. `kinds` is a choice that the page
/// made. A button presses its key.
[[nodiscard]] Controls transportControls(const TransportState& state, Control kinds, double& speed,
                                         const std::function<void(int step)>& moveTo,
                                         const std::function<void(int steps)>& by,
                                         const std::function<void(const Key&)>& press);
/// The slider alone.
[[nodiscard]] Control timelineControl(const TransportState& state, std::function<void(int step)> moveTo,
                                      std::function<void(int steps)> by);
/// Tells the list where they are. The page draws them all itself.
void placeTransport(ControlList& list, const TransportLayout& at);

/// The buttons, the number of the step, the kinds and the speed. Without a list they are drawn at rest.
void drawTransport(Pen& pen, const TransportLayout& at, const TransportState& state, const Control& kinds,
                   const ControlList* list);
/// The lanes, one below the other.
void drawTimeline(Pen& pen, const TransportLayout& at, const TransportState& state,
                  std::span<const Lane> lanes);

/// What the keys of a run do.
struct TransportActs {
  std::function<void(int steps)> by;
  std::function<void()> play, start, end;
  std::function<void(bool forward)> jump;
  std::function<void()> nextKind, askStep;
  std::function<std::string(bool forward)> whyNoJump;  ///< a sentence; "" if there is such a step
  std::string nothing = {};                            ///< why there is nothing to play
  bool atStart = false, atEnd = false;
};
/// The arrows, Space, Home, End, j, J, K and g.
void appendTransportKeys(KeyTable& table, bool playing, const TransportActs& acts);
/// - and +.
void appendSpeedKeys(KeyTable& table, double& speed);

}  // namespace xnewell
