#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "shading/color/images.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/shared.h"
#include "shading/trade/trade.h"
#include "x11/kit/control.h"
#include "x11/kit/page.h"
#include "x11/views/trade_chart.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// What does accuracy cost on this scene, and which is enough? At the left the chart, at the right what is
/// chosen, why, and the limit.

/// The places of the view's parts, in units.
struct TradeLayout {
  Rect chart;     ///< the area of the marks
  Rect page;      ///< what is chosen, and why
  Rect controls;  ///< their rows
};
/// `body` is at least 768 x 428.
[[nodiscard]] TradeLayout layoutOfTrade(const Rect& body);

/// The limits that the slider reaches.
inline constexpr TrackRange kLimits{
    .low = 0.001, .high = 0.5, .step = 1.0 / 40, .logarithmic = true, .decimals = 4};

/// A trade that is measured on a thread of its own, while the window goes on.
class Measuring {
 public:
  /// Starts at once, on the axes of choosableAxes(); on its thread it waits first for the end of `before`.
  Measuring(Scene scene, const PictureSettings& settings, TradeRequest request,
            std::unique_ptr<Measuring> before);
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;
  /// Stops it and waits for the end of what it is doing, at most one picture.
  ~Measuring();
  /// Stops it and does not wait.
  void stop() { stop_ = true; }

  struct News {
    Trade trade;
    std::string doing;  ///< "timing short cuts: round 3"
    bool done = false;
    std::string failure;  ///< why it ended without a trade; "" if it did not
  };
  /// What is new since the last call; nothing if that was all.
  [[nodiscard]] std::optional<News> news();

 private:
  [[nodiscard]] Trade measured(const Shared<Scene>& scene, const PictureSettings& settings,
                               const TradeRequest& request);
  void publish(News news);

  std::unique_ptr<Measuring> before_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::optional<News> news_;
  std::thread thread_;  // last, so that it finds the others
};

/// The view of the trade in the window. It begins to measure when it first appears, and draws what is known.
class TradeView : public WindowView {
 public:
  /// `request` says how long it measures.
  explicit TradeView(Host& host, const TradeRequest& request = {.brief = true, .seconds = 20})
      : WindowView{host}, request_{request} {}

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override;
  void enter() override { list_.setFocus(ControlId{'E'}); }
  /// Other views must not share the processor with the measuring, so it ends with this view.
  void leave() override;
  [[nodiscard]] bool moving() const override { return measuring_ != nullptr; }
  void tick() override;

  /// The pictures that are measured have the size of the first view's.
  [[nodiscard]] Rect picture(const Layout& at) const override { return at.picture; }
  [[nodiscard]] bool wantsImage() const override { return false; }
  [[nodiscard]] bool late(const Setup& setup) const override;
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::string aside() const override { return aside_; }
  [[nodiscard]] std::vector<std::string> report() const override { return words_; }
  [[nodiscard]] const CellUse* use() const override { return &use_; }
  [[nodiscard]] const OwnColors* colors() const override { return &colors_; }

  [[nodiscard]] const Trade& trade() const { return known_.trade; }
  [[nodiscard]] int chosen() const { return chosen_; }
  [[nodiscard]] double limit() const { return limit_.rms; }
  /// The ground of the chosen picture, and the frames of its worst places, the worst first.
  [[nodiscard]] const Rect& well() const { return well_; }
  [[nodiscard]] const std::vector<Rect>& places() const { return places_; }

 private:
  void measure(const Picture& picture, const Setup& setup);
  void giveUp();
  /// Chooses within the limit again, unless the user has picked a combination and it is still there.
  void choose();
  /// The user picks a combination himself.
  void pick(int combination);
  /// Where the picked combination is among those that are known now.
  [[nodiscard]] int indexOfPicked();
  void setLimit(double limit);
  /// Goes along the front, to the right if `steps` > 0.
  void walk(int steps);
  void useChosen();
  /// Shows it in view 5, beside the set-up without short cuts.
  void compareChosen();
  void askToSave();
  void drawChosen(Pen& pen, const Rect& well, const DrawContext& context);
  [[nodiscard]] page::Page page(const DrawContext& context);
  void drawChart(Pen& pen, bool stale, bool compact);
  [[nodiscard]] bool isStale(const DrawContext& context) const;

  TradeRequest request_;
  std::unique_ptr<Measuring> measuring_;
  std::unique_ptr<Measuring> ending_;  ///< was stopped, and may still be making its last picture
  Measuring::News known_;
  Stopwatch since_;      ///< the measuring began
  int told_ = 0;         ///< the seconds that the status line tells
  bool single_ = false;  ///< only single short cuts are known as yet
  std::optional<Setup> measuredOf_;
  std::string measuredScene_;
  Rect measuredSize_;
  TradeAxes axes_;
  AccuracyLimit limit_;
  int chosen_ = -1;
  std::optional<Measured> picked_;  ///< the combination that the user picked
  Chosen within_;
  int place_ = 0;              ///< index into the worst places of the chosen combination
  std::vector<Rect> places_;   ///< their frames in the picture
  bool limitDragged_ = false;  ///< by its line in the chart
  bool changed_ = true;        ///< something must be drawn
  bool again_ = false;         ///< the user asked to measure again

  std::optional<PictureCache> pictures_;  ///< of the chosen combination
  int divisions_ = 0;                     ///< of their scene
  std::optional<Picture> painted_;
  // The state of the last drawing.
  TradeLayout at_;
  Rect well_;
  std::vector<std::string> words_;
  CellUse use_;
  OwnColors colors_{};
  std::string status_, aside_;
};

}  // namespace xnewell
