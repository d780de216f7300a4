#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "x11/scanline/scanline_page.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// View 0: how one polygon becomes pixels, step by step. It has the timeline of the depth-sort stepper. A
/// changed setting keeps the polygon, if the new picture has it.
class ScanlineView : public WindowView {
 public:
  /// The host must outlive it.
  ScanlineView(Host& host, std::function<Subject()> subject)
      : WindowView{host}, subject_{std::move(subject)} {}

  /// Chooses a polygon by its name: "59.1", or "59" for its first part. Names that the picture does not have
  /// are told.
  void choose(std::string polygon) { name_ = std::move(polygon), late_ = true; }
  /// The step to begin with.
  void startAt(int step) { start_ = step; }
  /// The name of the polygon that was drawn last; "" before that.
  [[nodiscard]] std::string polygon() const { return run_ ? name_ : ""; }

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  void enter() override;
  void leave() override;
  [[nodiscard]] bool moving() const override { return view_.playing; }
  void tick() override;

  [[nodiscard]] Rect picture(const Layout& at) const override { return scanlinePicture(at.body); }
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup& setup) const override {
    return late_ || drawn_ != view_ || setup_ != setup || list_.late();
  }
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::string aside() const override;
  [[nodiscard]] std::vector<std::string> report() const override;
  [[nodiscard]] std::optional<int> inspected() const override;

  /// What is shown; the run is null before the view is drawn.
  [[nodiscard]] const ScanlineState& view() const { return view_; }
  [[nodiscard]] const ScanlineRun* run() const { return run_.get(); }

 private:
  void goTo(int step);
  void moveTo(int step);
  void jump(bool forward);
  [[nodiscard]] std::optional<int> stepOfKind(bool forward) const;
  [[nodiscard]] std::string whyNoJump(bool forward) const;
  void play();
  void askPolygon();
  void predict();
  /// The next polygon that shows, or the one before.
  void walk(int direction);
  /// What the pointer presses in the overview and in the grid, in units.
  void pressOverview(int x, int y);
  void pressGrid(int x, int y);
  /// Makes the run of the polygon with this name, or of one that shows its steps well.
  void follow(const DrawContext& context);
  [[nodiscard]] int faceToBegin() const;
  [[nodiscard]] Control bitsControl();
  [[nodiscard]] Control polygonsControl();

  std::function<Subject()> subject_;
  ScanlineState view_;
  StepClock clock_;
  std::string name_;  ///< of the polygon; "" for one that the view chooses
  std::optional<int> start_;
  double share_ = 0.6;  ///< of the steps: another polygon is shown as far filled as the one before
  bool late_ = true;
  // The state of the last drawing.
  bool fullColor_ = false;                    ///< the scene's own plan is of colours: it is shown in one hue
  std::optional<Picture> picture_;            ///< that the runs are about
  std::vector<int> shows_;                    ///< at how many samples each face shows
  std::unique_ptr<ScanlineRun> run_, eight_;  ///< with the chosen bits; with 8, to compare
  Finding finding_;
  ScanlineLayout at_;
  int unit_ = 1;
  std::optional<ScanlineState> drawn_;
  std::optional<Setup> setup_;
  std::string status_;
};

}  // namespace xnewell
