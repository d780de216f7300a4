#pragma once

#include <memory>
#include <optional>
#include <string>

#include "x11/kit/pseudocode.h"
#include "x11/stepper/own_sort.h"
#include "x11/stepper/sort_player.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// The depth-sort stepper in the window: it records the run, draws the page, and has its keys and controls.
/// The run is recorded when the view is first drawn, and again when there is another picture to sort. The
/// picture's own order does not matter: the stepper always shows Newell's.
class SortView : public WindowView {
 public:
  /// The host must outlive it.
  explicit SortView(Host& host) : WindowView{host}, player_{host} {}

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  [[nodiscard]] bool press(const Key& key) override;
  [[nodiscard]] bool grab(int x, int y) override;
  void enter() override;
  void leave() override;
  bool reset() override;
  [[nodiscard]] bool moving() const override { return view().playing; }
  void tick() override { player_.tick(); }

  [[nodiscard]] Rect picture(const Layout& at) const override { return layoutIn(at).picture; }
  /// The run of another program is shown in a picture of its proportions.
  [[nodiscard]] Rect frame(const Layout& at) const override {
    return showsTheirs() ? layoutIn(at).picture : at.frame;
  }
  [[nodiscard]] bool hasDrawer() const override { return true; }
  /// The finished picture is not needed, and a step would have to wait for it.
  [[nodiscard]] bool wantsImage() const override { return false; }
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup&) const override {
    return drawn_ != view() || part_ != recorded_ || startKind_ || list_.late();
  }
  void draw(Painter paint, const DrawContext& context) override;

  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::string aside() const override;
  [[nodiscard]] std::vector<std::string> report() const override;
  [[nodiscard]] std::optional<std::string> command() const override;
  [[nodiscard]] const CellUse* use() const override { return &use_; }

  /// Goes to a step of the run, which must be recorded.
  void goTo(int step) { player_.goTo(step); }
  /// The step to begin with when the next run is recorded.
  void startAt(int step) { start_ = step; }
  /// Begins with the first step of a kind, or says that there is none.
  void startAt(Landmark kind) { startKind_ = kind; }
  /// Shows the run of another program from now on. @throws ParseError if it is none of the scene
  void open(const std::string& file, const Scene& scene);
  /// Its file, if it is shown; or else "".
  [[nodiscard]] std::string theirs() const { return view().theirs ? theirs_->file.name() : ""; }
  /// What is shown, and where it is.
  [[nodiscard]] const SortState& view() const { return player_.view; }
  [[nodiscard]] const SortDrawn& places() const { return places_; }
  /// Null before the view is drawn, and if the run is too long.
  [[nodiscard]] SortRun* run() { return player_.run.get(); }
  [[nodiscard]] bool tooLong() const { return tooLong_; }
  /// What the student has sorted; null before that.
  [[nodiscard]] const OwnSort* own() const { return own_.get(); }
  /// What `xnewell judge` would say of it.
  [[nodiscard]] OrderReport ownReport() const;

 private:
  [[nodiscard]] SortLayout layoutIn(const Layout& at) const {
    SortLayout sort = layoutOfSort(at.body, at.drawer == Drawer::Shut, view().own.has_value());
    sort.picture = showsTheirs() ? theirPicture(sort.well, at.unit) : framed(sort.well, at.frame.width);
    return sort;
  }
  /// The sample of the picture that is shown at this unit of the window.
  [[nodiscard]] glm::ivec2 sampleAt(int x, int y) const;
  /// True if the run of another program was opened, and the view is still its own.
  [[nodiscard]] bool showsTheirs() const {
    return theirs_ && theirs_->picture.settings().camera == host_.setup().picture.camera;
  }
  /// The place for a picture of their size, or else of their shape.
  [[nodiscard]] Rect theirPicture(const Rect& room, int unit) const;
  void record(const DrawContext& context);
  /// After the view has changed, the step of the new run that is most like the one shown before. Tells the
  /// user which one it is.
  [[nodiscard]] int likeBefore();
  /// The run's steps as a slider.
  [[nodiscard]] Control timeline();
  void drawTooLong(Painter paint, const DrawContext& context);
  /// Where a run is too long: sorts only the polygons around this sample, as many as make a run.
  void choosePart(glm::ivec2 sample);
  /// Goes to the next step with the face of this fragment.
  void goToFaceOf(int id);

  // While the student sorts (own_view.cpp).
  /// The student sorts from now on, or no longer.
  void sortOneself(bool on);
  /// Shows the student's run, and what became of the last step. P and Q are chosen, or the next that are
  /// left. The run of the program is in newell_ by then.
  void showOwn(int P, int Q, const OwnSort::Reply& reply);
  /// Puts into the view what became of the step that is shown.
  void tellOwn();
  void addOwnKeys(KeyTable& table);
  void addOwnControls(Controls& all);
  void choose(int P, int Q);
  void chooseP(int along);
  void chooseQ(int along);
  /// Chooses a polygon that is left to paint at a sample; of several, another one each time.
  void chooseAt(int column, int row);
  void chooseClicked(int id);
  void act(int index);
  void tellTest(int index);
  void undoOwn();
  void askToWrite();
  /// The command that judges a file of the student's order, or a run.
  [[nodiscard]] std::string judgeCommand(const std::string& what) const;

  SortPlayer player_;
  std::shared_ptr<const JudgedRun> theirs_;
  std::unique_ptr<OwnSort> own_;     ///< kept when the student leaves it
  std::unique_ptr<SortRun> newell_;  ///< the program's run, while the student's is shown
  int newellStep_ = 0;
  OwnSort::Reply endReply_;  ///< what is told at the end of the student's run
  std::string judges_;       ///< the command that judges the file written last; "" if there is none
  std::uint8_t ground_ = 0;
  // The state of the last drawing.
  bool tooLong_ = false;
  bool fullColor_ = false;  ///< the scene's own plan is of colours: it is shown in one hue
  /// The samples of the part that is sorted; none: all of the picture.
  struct Part {
    glm::ivec2 low, high;
    bool operator==(const Part&) const = default;
  };
  std::optional<Part> part_, recorded_;
  std::optional<int> start_;  ///< of startAt(), until a run is recorded
  std::optional<Landmark> startKind_;
  std::optional<Picture> picture_;  ///< that the run is about
  Order order_ = Order::Newell;     ///< of the picture in its own view
  std::optional<StepAbout> about_;  ///< the step; none at the start
  SortLayout at_;
  Drawer drawer_ = Drawer::Whole;
  SortDrawn places_;
  std::optional<SortState> drawn_;
  std::string status_;
  CellUse use_;
};

}  // namespace xnewell
