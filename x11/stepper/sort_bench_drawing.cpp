#include <algorithm>
#include <utility>

#include "x11/drawing/wording.h"
#include "x11/stepper/sort_bench.h"
#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_wording.h"
#include "x11/window/caption.h"

namespace xnewell {

// This file records the run and draws the view. Keys and pointer: sort_bench.cpp.

SortBench::SortBench(Host& host) : Bench{host} {}
SortBench::~SortBench() = default;

Setup SortBench::painted(const Setup& setup) const {
  Setup newell = setup;
  newell.picture.order = Order::Newell;
  newell.picture.inPixels = false;
  // In full colour a picture chooses its colours after all of it is painted, but a run is painted piece by
  // piece.
  if (fullColor_) newell.picture.colors = ColorPlan::OneHue;
  newell.fill = Fill::Scanline;
  return newell;
}

void SortBench::record(const Desk& desk) {
  const bool sameScene = picture_ && &picture_->scene() == &desk.picture.scene();
  const bool same = sameScene && picture_->snapped().vertices == desk.picture.snapped().vertices;
  if ((run_ || tooLong_) && same && picture_->settings() == desk.picture.settings()) return;
  const int step = view_.step;
  const bool atEnd = run_ && step > 0 && step == run_->steps();
  run_.reset();
  tooLong_ = false;
  if (!sameScene) view_.polygon.reset(), about_.reset();
  picture_ = desk.picture;
  try {
    run_ = std::make_unique<SortRun>(desk.picture, desk.plan[Cell::Well]);
  } catch (const TooLongRun&) {
    tooLong_ = true;
    early_.clear();
    view_.playing = false;
    return;
  }
  const bool asking = view_.asking && same;
  const std::optional<Verdict> answer = same ? view_.answer : std::nullopt;
  goTo(same ? step : atEnd && sameScene ? run_->steps() : likeBefore());
  view_.asking = view_.asking && asking;
  view_.answer = answer;
  for (const Key& key : std::exchange(early_, {})) static_cast<void>(press(key, desk.setup));
}

int SortBench::likeBefore() {
  if (!about_) return 0;
  const std::optional<int> step = run_->stepAbout(*about_);
  host_.tell(step ? "The new view has its own run: this is its step most like the one before."
                  : "The new view has its own run, without such a step: this is its start.");
  return step.value_or(0);
}

void SortBench::drawTooLong(IndexImage& image, const Desk& desk) {
  const Rect &body = desk.layout.body, picture = this->picture(desk.layout);
  Painter paint = Painter{image}.within(body);
  const IndexImage whole = desk.picture.paint(desk.plan[Cell::Well]).image;
  use_ = cellUse(whole);
  paint.place(whole, picture.x, picture.y);
  int y = picture.y + picture.height + 30;
  paint.text(body.x, y, "This run is too long to step through.", desk.plan[Cell::Ink], Voice::Bold);
  for (const std::string& line :
       broken("Newell's sort of " +
                  counted(static_cast<std::int64_t>(desk.picture.snapped().faces.size()), "polygon") +
                  " takes more than " + grouped(SortRun::kMostEvents) +
                  " steps. Use fewer divisions if the scene has patches (k in view 4), or zoom in so that "
                  "fewer polygons are visible.",
              90)) {
    y += 16;
    paint.text(body.x, y, line, desk.plan[Cell::Ink]);
  }
}

void SortBench::draw(IndexImage& image, const Desk& desk) {
  at_ = layoutOfSort(desk.layout.body);
  order_ = desk.setup.picture.order;
  if (channelsOf(desk.picture.colors().plan()) == Channels::Rgb) {
    fullColor_ = true;  // the view is still late, so it is drawn again at once
    drawn_.reset();
    return;
  }
  record(desk);
  if (!run_) {
    drawTooLong(image, desk);
    status_ = "Newell's sort of this scene is too long to step through.";
  } else {
    places_ = drawSortPage(image, at_, *run_, view_, desk.plan);
    status_ = stepInWords(*run_);
    about_ = view_.step > 0 ? std::optional{run_->about(view_.step)} : std::nullopt;
    use_ = cellUse(run_->soFar());
  }
  drawn_ = view_;
}

std::string SortBench::status() const { return status_; }

std::vector<HelpLine> SortBench::help() {
  return {{"arrows Home End", "a step back or forward, ten with Shift; the ends"},
          {"Space - +", "play and stop; slower, faster"},
          {"j J K", "next and previous step of a kind; the next kind"},
          {"g /", "go to a step by its number; to a polygon's next one"},
          {"b, then 1..6", "stop at a kind of step, or at the polygon"},
          {"y, then a b c", "predict: answer what follows; Return shows it"},
          {"l", "the loupe the loupe is shown over the picture, shown or not"},
          {"click", "a polygon, a row, the timeline, any box"}};
}

std::string SortBench::aside() const {
  if (!run_) return "";
  if (fullColor_) return "in one hue: the picture chooses its colours after all of it is painted";
  return order_ == Order::Newell ? "the textbook's run; the picture uses a quicker one, which may cut others"
                                 : "Newell's sort; the picture itself: " + orderInWords(order_);
}

std::vector<Legend> SortBench::legend() {
  if (!run_) return {};
  if (view_.asking)
    return {{{"a"}, "P first"},
            {{"b"}, "Q first"},
            {{"c"}, "they cross"},
            {{"Return"}, "show"},
            {{"y"}, "stop predicting"}};
  return {{{"<", ">"}, "step"},    {{"Space"}, view_.playing ? "stop" : "play"},
          {{"Home"}, "start"},     {{"End"}, "end"},
          {{"j"}, "next of kind"}, {{"J"}, "back"},
          {{"K"}, "kind"},         {{"g"}, "go to step"},
          {{"/"}, "polygon"},      {{"b"}, "stop at"},
          {{"y"}, "predict"},      {{"-", "+"}, "speed"}};
}

}  // namespace xnewell
