#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shading/diagnose/judge_order.h"
#include "x11/homework/run_record.h"
#include "x11/kit/quiz.h"
#include "x11/stepper/sort_run.h"

namespace xnewell {

/// The depth sort by hand: the student decides each step, and not the program. What is decided becomes a
/// recorded run like that of the program, so the same page shows it.
///
/// A step is valid if it is true, also where Newell's sort would not take it:
/// - P is painted: no polygon that is left to paint is farther than P at a common sample. Each sample is
///   decided as judgeOrder() decides it, and by none of the sort's tests.
/// - a test of 1 to 5 tells that P may be painted before Q: it passes. One that fails is no step and does not
///   count, so that they can be made in the book's order.
/// - Q goes before P: Q is nearer than P at no common sample.
/// - a polygon is cut by a plane: the plane properly crosses it.
/// What is not valid is not done, except for painting: it spoils the picture.

class OwnSort {
 public:
  /// `list` has the faces of picture.snapped(), which has planes: the farthest first.
  OwnSort(const Picture& picture, std::vector<int> list) : picture_{picture}, record_{picture} {
    record_.begin(std::move(list));
  }

  /// What became of a step: a sentence, and why.
  struct Reply {
    bool valid = true;
    std::string bold, why;
    bool told = true;  ///< tell(): the test passes
  };
  // The steps. P and Q are ids of fragments that wait. `run` is that of makeRun() after the step before.
  Reply paint(const SortRun& run, int P, int Q);
  Reply tell(const SortRun& run, Test test, int P, int Q);
  Reply move(const SortRun& run, int P, int Q);
  Reply cut(int polygon, int by, bool isP);
  /// Takes back the last step that was done, and returns its P and Q. Nothing if there is none. The score
  /// stays.
  std::optional<std::pair<int, int>> undo();

  /// The run so far, to be shown.
  [[nodiscard]] std::unique_ptr<SortRun> makeRun(std::uint8_t ground) const;
  /// The same scene and view, shaded otherwise.
  void show(Picture picture) { picture_ = std::move(picture); }

  [[nodiscard]] const Score& score() const { return score_; }
  [[nodiscard]] int events() const { return record_.events(); }
  /// The first piece of the last cut, which is behind the plane; -1 if the last step was none.
  [[nodiscard]] int lastPiece() const;
  /// The polygon that the moves made P, once the one before is painted; -1 if there is none.
  [[nodiscard]] int marked() const { return record_.marked().empty() ? -1 : record_.marked().back(); }
  /// The samples that painting too early has spoilt in the first `events` events.
  [[nodiscard]] std::vector<SampleRow> spoilt(int events) const;
  /// What became of the last step among the first `events` events.
  [[nodiscard]] const Reply* replyAt(int events) const;

  /// What is painted, as a file for judgeOrder() has it. A face of several convex parts is in pieces. The
  /// lines are those of a file with a size; the names are the page's.
  [[nodiscard]] std::vector<PaintStep> steps(const SortRun& run) const;

 private:
  struct Done {
    RunRecord::State before;
    int P, Q;
    int after = 0;  ///< events
    std::vector<SampleRow> spoilt = {};
    Reply reply = {};
  };
  [[nodiscard]] PaintStep stepOf(const SortRun& run, int id) const;
  void begin(int P, int Q) { done_.push_back({.before = record_.state(), .P = P, .Q = Q}); }
  Reply refuse(std::string bold, std::string why);
  Reply done(Reply reply, std::vector<SampleRow> spoilt = {});

  Picture picture_;
  RunRecord record_;
  std::vector<Done> done_;
  Score score_;
};

}  // namespace xnewell
