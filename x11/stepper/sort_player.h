#pragma once

#include <memory>
#include <string>

#include "x11/kit/key_table.h"
#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_state.h"

namespace xnewell {

/// Goes along a recorded run: by steps, by kinds of step, by polygons, or by itself. It asks the learner what
/// follows, and keeps the score. While there is no run, only `view` and goTo() may be used.
class SortPlayer {
 public:
  /// The prompt must outlive it.
  explicit SortPlayer(Prompt& prompt) : prompt_{prompt} {}

  std::unique_ptr<SortRun> run;
  SortState view;

  /// Goes to a step, or to the nearest end of the run. If the learner predicts, and the step is a question,
  /// it is asked.
  void goTo(int step);
  /// The user goes to a step, which ends playing. So do the next three functions.
  void moveTo(int step);
  /// The first step forward from a question shows what follows.
  void stepBy(int steps);
  /// Goes to the next step of the kind, or to the one before.
  void jump(bool forward);
  /// Goes to the next step with this face, which the run has.
  void goToPolygon(int number);
  /// Why there is no step to jump to, a sentence; "" if there is one.
  [[nodiscard]] std::string whyNoJump(bool forward) const;
  void askPolygon();

  void toggle(int index);
  void answer(int which);
  /// Starts and stops.
  void play();
  void tick();

 private:
  [[nodiscard]] std::optional<int> stepOfKind(bool forward) const;
  [[nodiscard]] bool asks(int step) const;
  [[nodiscard]] bool stopsAt(int step) const;

  Prompt& prompt_;
  StepClock clock_;
};

}  // namespace xnewell
