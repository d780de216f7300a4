#pragma once

#include <memory>
#include <optional>
#include <string>

#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_view.h"
#include "x11/window/bench.h"

namespace xnewell {

/// The depth-sort stepper in the window: which step of the textbook's run is shown, and what keys and pointer
/// do to it. The run is recorded when the view is drawn first, and again when another picture is to be
/// sorted. The picture's own order plays no part: what is shown is always Newell's.
class SortBench : public Bench {
 public:
  static constexpr int kTick = 40;  ///< milliseconds from tick() to tick()

  /// The host outlives it.
  explicit SortBench(Host& host);
  ~SortBench() override;

  [[nodiscard]] bool press(const Key& key, const Setup& setup) override;
  [[nodiscard]] std::string_view sharedKeys() const override { return ""; }
  void hover(int x, int y) override;
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override;
  void leave() override;
  [[nodiscard]] bool moving() const override { return view_.playing; }
  void tick() override;

  [[nodiscard]] Rect picture(const Layout& at) const override { return layoutOfSort(at.body).picture; }
  /// The finished picture is drawn by nobody: a step would wait for it.
  [[nodiscard]] bool wantsImage() const override { return false; }
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup&) const override { return !drawn_ || *drawn_ != view_; }
  void draw(IndexImage& image, const Desk& desk) override;

  [[nodiscard]] std::string status() const override;
  [[nodiscard]] std::string aside() const override;
  [[nodiscard]] std::vector<Legend> legend() const override;
  [[nodiscard]] std::vector<HelpLine> help() const override;
  [[nodiscard]] const CellUse* use() const override { return &use_; }

  /// To a step, within the run; a step that may be asked about is asked about, where that is chosen.
  void goTo(int step);
  /// What is shown, and where.
  [[nodiscard]] const SortView& view() const { return view_; }
  [[nodiscard]] const SortDrawn& places() const { return places_; }
  /// Null before it is drawn, and where the run is too long.
  [[nodiscard]] SortRun* run() { return run_.get(); }
  [[nodiscard]] bool tooLong() const { return tooLong_; }

 private:
  void record(const Desk& desk);
  /// The step of a run of another view that is most like the one shown before; says which it is.
  [[nodiscard]] int likeBefore();
  void drawTooLong(IndexImage& image, const Desk& desk);
  void stepBy(int steps);
  void jump(bool forward);
  /// Of the face with this number, of those that the run has.
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

  Host& host_;
  SortView view_;
  std::vector<Key> early_;  ///< typed before there was a run
  double due_ = 0;          ///< of a step, while it plays
  SortPart dragged_ = SortPart::Nothing;
  // Of what was drawn last.
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
