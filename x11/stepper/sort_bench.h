#pragma once

#include <memory>
#include <optional>
#include <string>

#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_view.h"
#include "x11/window/bench.h"

namespace xnewell {

/// The depth-sort stepper in the window: which step of the textbook's run is shown, and what keys and pointer
/// do. The run is recorded when the view is first drawn, and again when there is another picture to sort. The
/// picture's own order does not matter: the stepper always shows Newell's.
class SortBench : public Bench {
 public:
  static constexpr int kTick = 40;  ///< milliseconds from tick() to tick()

  /// The host must outlive it.
  explicit SortBench(Host& host);
  ~SortBench() override;

  [[nodiscard]] bool press(const Key& key, const Setup& setup) override;
  void hover(int x, int y) override;
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override;
  void leave() override;
  [[nodiscard]] bool moving() const override { return view_.playing; }
  void tick() override;

  [[nodiscard]] Rect picture(const Layout& at) const override { return layoutOfSort(at.body).picture; }
  /// The finished picture is not needed, and a step would have to wait for it.
  [[nodiscard]] bool wantsImage() const override { return false; }
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup&) const override { return !drawn_ || *drawn_ != view_; }
  void draw(IndexImage& image, const Desk& desk) override;

  [[nodiscard]] std::string status() const override;
  [[nodiscard]] std::string aside() const override;
  [[nodiscard]] std::vector<Legend> legend() override;
  [[nodiscard]] std::vector<HelpLine> help() override;
  [[nodiscard]] const CellUse* use() const override { return &use_; }

  /// Goes to a step, or to the nearest end of the run. If the learner predicts, and the step is a question,
  /// it is asked.
  void goTo(int step);
  /// What is shown, and where it is.
  [[nodiscard]] const SortView& view() const { return view_; }
  [[nodiscard]] const SortDrawn& places() const { return places_; }
  /// Null before the view is drawn, and if the run is too long.
  [[nodiscard]] SortRun* run() { return run_.get(); }
  [[nodiscard]] bool tooLong() const { return tooLong_; }

 private:
  void record(const Desk& desk);
  /// After the view has changed, the step of the new run that is most like the one shown before. Tells the
  /// user which one it is.
  [[nodiscard]] int likeBefore();
  void drawTooLong(IndexImage& image, const Desk& desk);
  void stepBy(int steps);
  void jump(bool forward);
  /// Goes to the next step with this face, which the run has.
  void goToPolygon(int number);
  void answer(int which);
  void reveal();
  void toggle(int index);
  void push(Transport button);
  void speedUp(int notches);
  void click(const SortSpot& spot, int x, int y);
  void clickPicture(int x, int y);
  [[nodiscard]] bool stopsAt(int step) const;
  void askStep();
  void askPolygon();
  [[nodiscard]] bool pressNamed(const Key& key);

  SortView view_;
  std::vector<Key> early_;  ///< keys typed before there was a run
  double due_ = 0;          ///< the part of the next step that is due, while the run plays
  SortPart dragged_ = SortPart::Nothing;
  // The state of the last drawing.
  std::unique_ptr<SortRun> run_;
  bool tooLong_ = false;
  bool fullColor_ = false;          ///< the scene's own plan is of colours: it is shown in one hue
  std::optional<Picture> picture_;  ///< that run_ is about
  Order order_ = Order::Newell;     ///< of the picture in its own view
  std::optional<StepAbout> about_;  ///< the step; none at the start
  SortLayout at_;
  SortDrawn places_;
  std::optional<SortView> drawn_;
  std::string status_;
  CellUse use_;
};

}  // namespace xnewell
