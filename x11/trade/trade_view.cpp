#include "x11/trade/trade_view.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "geometry/exact/give_up.h"
#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "shading/picture/facts.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/stopwatch.h"
#include "shading/trade/configuration.h"
#include "x11/drawing/pen.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/kit/file_question.h"
#include "x11/views/trade_chart.h"
#include "x11/window/controls.h"
#include "x11/window/layout.h"

namespace xnewell {

namespace {

/// ---- What is measured, and what is chosen

/// The setup with what a configuration changes.
Setup withChanges(Setup setup, const Configuration& chosen) {
  for (const Change& change : chosen.changes)
    if (change.setting)
      (void)applyOverrides(setup.picture, {{change.setting, change.value}});
    else
      setup.divisions = static_cast<int>(change.value);
  return setup;
}

/// What the measurements of a trade depend on: all but the colours in the cells, the filler, and what view 1
/// shows.
Setup measuredPart(Setup setup) {
  setup.picture = withoutColors(setup.picture);
  setup.fill = Fill::Scanline;
  setup.show = View::Picture;
  return setup;
}

}  // namespace

void TradeView::measure(const Picture& picture, const Setup& setup) {
  giveUp();
  known_.doing = "The exact picture comes first, then each short cut alone.";
  chosen_ = -1, picked_.reset(), within_ = {};
  painted_.reset();
  again_ = false;
  measuredSize_ = {0, 0, picture.settings().width, picture.settings().height};
  measuredOf_ = measuredPart(setup);
  measuredScene_ = picture.scene().name;
  measuring_ = std::make_unique<Measuring>(picture.scene(), picture.settings(), request_, std::move(ending_));
  since_ = {}, told_ = 0;
}

void TradeView::tick() {
  if (!measuring_) return;
  if (const int seconds = static_cast<int>(since_.ms() / 1e3); seconds != told_) {
    told_ = seconds;
    changed_ = true;
  }
  std::optional<Measuring::News> news = measuring_->news();
  if (!news) return;
  known_ = std::move(*news);
  single_ = !areTimed(known_.trade.combinations);
  if (single_) known_.trade = withSingles(std::move(known_.trade));
  if (known_.done) measuring_.reset();
  choose();
}

void TradeView::leave() {
  WindowView::leave();
  if (!measuring_) return;
  giveUp();
  measuredOf_.reset();  // measured anew when the view appears again
}

void TradeView::giveUp() {
  if (measuring_) measuring_->stop(), ending_ = std::move(measuring_);
  known_ = {};
}

void TradeView::choose() {
  within_ = {};
  chosen_ = -1;
  if (!known_.trade.front.empty()) {
    within_ = chooseWithin(known_.trade, limit_);
    chosen_ = picked_ ? indexOfPicked() : within_.combination;
  }
  changed_ = true;
}

/// The search may leave out what was picked while only single short cuts were known. Then it is added.
int TradeView::indexOfPicked() {
  std::vector<Measured>& all = known_.trade.combinations;
  const auto same = std::ranges::find_if(
      all, [&](const Measured& one) { return one.configuration.changes == picked_->configuration.changes; });
  if (same != all.end()) return static_cast<int>(same - all.begin());
  all.push_back(*picked_);
  return static_cast<int>(all.size()) - 1;
}

void TradeView::pick(int combination) {
  chosen_ = combination;
  picked_ = known_.trade.combinations[combination];
  changed_ = true;
}

void TradeView::setLimit(double limit) {
  limit_.rms = std::clamp(limit, kLimits.low, kLimits.high);
  picked_.reset();
  choose();
}

void TradeView::walk(int steps) {
  const std::vector<int> front = frontBy(axes_, known_.trade);
  if (front.empty()) return;
  const auto at = std::ranges::find(front, chosen_);
  const auto last = static_cast<std::ptrdiff_t>(front.size()) - 1;
  const std::ptrdiff_t next =
      at == front.end() ? 0 : std::clamp<std::ptrdiff_t>(at - front.begin() + steps, 0, last);
  pick(front[static_cast<std::size_t>(next)]);
}

void TradeView::useChosen() {
  if (chosen_ < 0) return;
  const Configuration chosen = known_.trade.combinations[chosen_].configuration;
  if (withChanges(host_.setup(), chosen) == host_.setup()) return host_.tell("That is the set-up.");
  host_.change('6', [&](Setup& s) { s = withChanges(s, chosen); });
  host_.tell("The window now uses " + chosen.name() + ".");
}

void TradeView::compareChosen() {
  if (chosen_ < 0) return host_.switchTo(View::SideBySide);
  const Configuration& chosen = known_.trade.combinations[chosen_].configuration;
  const std::string name = chosen.changes.empty() ? "the set-up" : chosen.name();
  useChosen();
  Setup reference = host_.setup();
  reference.picture = withoutShortCuts(reference.picture);
  host_.compare(reference);
  // View 5 divides both sides alike.
  host_.tell("A is " + name + ", and B has no short cuts" +
             (known_.trade.referenceDivisions > 0 ? ", but the same divisions." : "."));
}

void TradeView::askToSave() {
  if (known_.trade.combinations.empty()) return host_.notify("There is nothing to save yet.");
  const std::string stem = std::filesystem::path{measuredScene_}.stem().string();
  host_.ask(fileQuestion(
      "save the chart (.png) or the table (.txt) as", stem + "-trade.png",
      [](const std::string& file) {
        return file.ends_with(".png") || file.ends_with(".txt") ? ""
                                                                : "The file's name ends in .png or .txt.";
      },
      [this](const std::string& file) {
        if (file.ends_with(".png")) {
          const ColoredImage image = drawTrade(known_.trade, "Cost against error: " + measuredScene_);
          writeFile(file, encodePng(image.image, image.palette));
        } else {
          writeFile(file, tableOfCombinations(known_.trade));
        }
        host_.tell("Saved " + file + ".");
      }));
}

Controls TradeView::controls() {
  Controls all{{.kind = Control::Kind::Slider,
                .key = 'E',
                .label = "accuracy",
                .is = "the largest error allowed",
                .value = limit_.rms,
                .range = kLimits,
                .set = [this](double limit) { setLimit(limit); }}};
  const auto axis = [&](char key, const char* label, const auto& rows, auto& chosen) {
    Control control{.kind = Control::Kind::Choice,
                    .key = key,
                    .label = label,
                    .is = "what this axis of the chart shows",
                    .legend = "axes",
                    .value = static_cast<double>(chosen),
                    .set = [this, &chosen](double option) {
                      chosen = static_cast<std::remove_reference_t<decltype(chosen)>>(option);
                      changed_ = true;
                    }};
    for (const auto& row : rows) control.options.emplace_back(row.label);
    all.push_back(std::move(control));
  };
  axis('X', "cost", kTradeCosts, axes_.cost);
  axis('Y', "error", kTradeErrors, axes_.error);
  return all;
}

KeyTable TradeView::ownKeys() {
  const auto walks = [this](int steps) {
    return [this, steps](const Key& key) { walk(key.shift ? 5 * steps : steps); };
  };
  const auto moves = [this](int steps) {
    return [this, steps](const Key& key) {
      setLimit(stepped(kLimits, limit_.rms, key.shift ? 5 * steps : steps));
    };
  };
  const std::string none = known_.trade.front.empty() ? "Nothing is measured yet." : "";
  const std::string nowhere = places_.empty() ? "There are no worst places to go to." : "";
  const char* const front = "along the front; or click a mark";
  const char* const limit = "move the limit; or drag its line";
  KeyTable table{{{NamedKey::Left}, "along the front", front, walks(-1), none},
                 {{NamedKey::Right}, "along the front", front, walks(1), none},
                 {{NamedKey::Up}, "limit", limit, moves(1)},
                 {{NamedKey::Down}, "limit", limit, moves(-1)},
                 {{NamedKey::Return},
                  "use this one",
                  "use the chosen combination in all views",
                  [this](const Key&) { useChosen(); },
                  none},
                 {{'='}, "", "type the limit", [this](const Key&) { list_.askForValue(controls().front()); }},
                 {{'5'},
                  "beside no short cuts",
                  "use it, and compare it with the set-up without short cuts",
                  [this](const Key&) { compareChosen(); }}};
  table.push_back({{'n'},
                   "next worst place",
                   "the next of the worst places; or click one",
                   [this](const Key&) {
                     place_ = (place_ + 1) % static_cast<int>(places_.size());
                     changed_ = true;
                   },
                   nowhere});
  table.push_back(
      {{'m'}, "measure again", "measure again", [this](const Key&) { again_ = changed_ = true; }});
  table.push_back({{'w'}, "save", "save the chart or the table", [this](const Key&) { askToSave(); }});
  return table;
}

bool TradeView::grab(int x, int y) {
  if (list_.grab(controls(), x, y)) return list_.dragging();
  changed_ = true;
  for (std::size_t k = places_.size(); k-- > 0;)
    if (places_[k].has(x, y)) place_ = static_cast<int>(k);
  if (known_.trade.front.empty()) return false;
  // The limit's handle, a mark, or else the limit's line.
  const TradeScale scale{at_.chart, known_.trade, axes_};
  const bool hasLimit = axes_.error == TradeError::Rms;
  if (hasLimit && limitHandle(scale, limit_.rms).has(x, y)) return limitDragged_ = true;
  if (!at_.chart.has(x, y)) return false;
  double nearest = 12 * 12;
  int mark = -1;
  for (std::size_t k = 0; k < known_.trade.combinations.size(); ++k) {
    const Measured& one = known_.trade.combinations[k];
    const double dx = scale.x(axes_.costOf(one)) - x, dy = scale.y(axes_.errorOf(one)) - y;
    if (dx * dx + dy * dy < nearest) nearest = dx * dx + dy * dy, mark = static_cast<int>(k);
  }
  if (mark >= 0) {
    pick(mark);
    return false;
  }
  return limitDragged_ = hasLimit && std::abs(scale.y(limit_.rms) - y) <= 6;
}

void TradeView::dragTo(int x, int y) {
  if (limitDragged_)
    setLimit(TradeScale{at_.chart, known_.trade, axes_}.errorAt(y));
  else
    WindowView::dragTo(x, y);
}

void TradeView::drop() {
  limitDragged_ = false;
  WindowView::drop();
}

bool TradeView::isStale(const DrawContext& context) const {
  const PictureSettings& now = context.picture.settings();
  return (measuredOf_ && *measuredOf_ != measuredPart(context.setup)) ||
         std::pair{now.width, now.height} != std::pair{measuredSize_.width, measuredSize_.height};
}

bool TradeView::late(const Setup&) const { return changed_ || list_.late(); }

void TradeView::paintChosen(const DrawContext& context) {
  if (chosen_ < 0) {
    painted_.reset();
    return;
  }
  const Configuration& chosen = known_.trade.combinations[chosen_].configuration;
  if (!pictures_ || divisions_ != chosen.divisions) {
    pictures_.emplace(dividedAnew(context.picture.scene(), chosen.divisions));
    divisions_ = chosen.divisions;
  }
  PictureSettings settings = withChanges(context.setup, chosen).picture;
  settings.camera = heldCamera(context.picture);
  const Rect place = at_.picture * context.layout.unit;
  settings.width = place.width, settings.height = place.height;
  settings.inPixels = false;
  painted_ = pictures_->make(settings, context.plan[Cell::Well]);
}

void TradeView::draw(Painter paint, const DrawContext& context) {
  at_ = layoutOfTrade(context.layout.body, context.layout.picture);
  if (measuredScene_ != context.picture.scene().name) measuredOf_.reset();
  if (again_ || !measuredOf_) {
    pictures_.reset();
    measure(context.picture, context.setup);
  }
  paintChosen(context);
  const bool stale = isStale(context);
  places_ = stale || chosen_ < 0 ? std::vector<Rect>{}
                                 : framesOfWorst(at_, measuredSize_, known_.trade.combinations[chosen_]);
  if (place_ >= static_cast<int>(places_.size())) place_ = 0;
  paint.fillRect(context.layout.body, context.plan[Cell::Paper]);
  drawTradePage(paint, at_,
                {.trade = known_.trade,
                 .doing = known_.doing,
                 .failure = known_.failure,
                 .single = single_,
                 .stale = stale,
                 .axes = axes_,
                 .limit = limit_.rms,
                 .chosen = chosen_,
                 .within = within_,
                 .picture = painted_ ? &painted_->image() : nullptr,
                 .places = places_,
                 .place = place_},
                context.plan);
  list_.forgetPlaces();
  const Controls all = controls();
  (void)list_.placeColumn(all, at_.controls.x, at_.controls.y + 15);
  Pen pen{paint, context.plan};
  list_.draw(pen, all);
  colors_ = {context.palette, std::nullopt};
  use_ = {};
  if (painted_) {
    use_ = cellUse(painted_->image());
    const Palette own = painted_->palette(context.plan, context.palette);
    colors_.palette = context.gray ? forGrayScreen(own, *painted_) : own;
  }
  status_ = measuring_
                ? "measuring, " + std::to_string(told_) + " of about " + textOf(request_.seconds) +
                      " s: " + known_.doing
                : grouped(static_cast<std::int64_t>(known_.trade.combinations.size())) + " measured, " +
                      grouped(static_cast<std::int64_t>(frontBy(axes_, known_.trade).size())) +
                      " on the front";
  aside_ = measuring_ ? "" : grouped(known_.trade.ofCombinations.rounds) + " rounds, in turn";
  changed_ = false;
}

namespace {

constexpr double kBetweenNews = 150;  // ms
constexpr double kAtOnce = 10;        // seconds

}  // namespace

Measuring::Measuring(Scene scene, const PictureSettings& settings, TradeRequest request,
                     std::unique_ptr<Measuring> before)
    : before_{std::move(before)} {
  const auto measure = [this, scene = Shared<Scene>{std::move(scene)}, settings](TradeRequest asked) {
    before_.reset();
    const MayGiveUp givesUp{[this] { return stop_.load(); }};
    try {
      asked.axes = choosableAxes(PictureCache{scene}.make(settings));
      publish({measured(scene, settings, asked), "", true, ""});
    } catch (const GivenUp&) {  // nobody asks for news any more
    } catch (const std::exception& e) {
      publish({{}, "", true, e.what()});
    }
  };
  try {
    thread_ = std::thread{measure, request};
  } catch (const std::system_error&) {  // there is no other thread, and the window stands still meanwhile
    request.seconds = std::min(request.seconds, kAtOnce);
    measure(std::move(request));
  }
}

Trade Measuring::measured(const Shared<Scene>& scene, const PictureSettings& settings,
                          const TradeRequest& request) {
  const Stopwatch watch;
  double told = -kBetweenNews;
  return tradeOf(scene, settings, request, [&](const std::string& doing, const Trade& known) {
    if (watch.ms() >= told + kBetweenNews) {
      told = watch.ms();
      publish({known, doing, false, ""});
    }
    return !stop_;
  });
}

Measuring::~Measuring() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Measuring::publish(News news) {
  const std::lock_guard lock{mutex_};
  news_ = std::move(news);
}

std::optional<Measuring::News> Measuring::news() {
  const std::lock_guard lock{mutex_};
  return std::exchange(news_, std::nullopt);
}

namespace {

constexpr int kRow = 22, kLine = 17;
/// Draws a page.
class TradeDrawing {
 public:
  TradeDrawing(Painter paint, const TradeLayout& at, const TradePage& page, const CellPlan& plan)
      : pen_{paint, plan}, at_{at}, page_{page} {}

  void drawChart() {
    const int x = at_.chart.x - 48, y = at_.chart.y - 36;
    pen_.paint.text(x, y + 8, "Cost against error", pen_(Cell::Ink), Voice::Title);
    pen_.softRight(at_.chart.x + at_.chart.width, y + 8, heading());
    if (!hasTimes()) {
      drawWaiting();
      return;
    }
    drawTradePlot(pen_.paint, pen_.plan, TradeScale{at_.chart, page_.trade, page_.axes}, page_.trade,
                  page_.chosen,
                  page_.axes.error == TradeError::Rms ? std::optional{page_.limit} : std::nullopt);
  }

  void drawColumn() {
    const int x = at_.column.x, width = at_.column.width;
    int y = at_.column.y + 11;
    pen_.caps(x, y, "chosen");
    pen_.softRight(x + width, y,
                   page_.chosen < 0 ? ""
                   : page_.chosen == page_.within.combination
                       ? (page_.within.accurate ? "cheapest within the limit" : "the most accurate")
                   : isOnFront() ? "on the front"
                                 : "not on the front");
    pen_.paint.fillRect(at_.well, pen_(Cell::Well));
    if (page_.picture) pen_.paint.place(*page_.picture, at_.picture.x, at_.picture.y);
    drawPlaces();
    y = at_.well.y + at_.well.height + 20;
    if (page_.chosen >= 0) y = drawNumbers(x, y, width);
    drawControls();
    if (page_.chosen >= 0) drawWhy(x, y, width);
  }

 private:
  [[nodiscard]] bool hasTimes() const {
    return std::ranges::any_of(page_.trade.combinations,
                               [](const Measured& m) { return m.cost.time.ms > 0; });
  }

  [[nodiscard]] bool isOnFront() const {
    const std::vector<int> front = frontBy(page_.axes, page_.trade);
    return std::ranges::find(front, page_.chosen) != front.end();
  }

  [[nodiscard]] std::string heading() const {
    return page_.stale
               ? (at_.compact ? "out of date: press m" : "measured for an earlier set-up: m measures again")
               : counted(static_cast<std::int64_t>(page_.trade.combinations.size()), "configuration") +
                     (at_.compact    ? ""
                      : page_.single ? ", one change each"
                                     : ", this scene, this view");
  }

  void drawWaiting() {
    const int x = at_.chart.x, y = at_.chart.y + at_.chart.height / 2;
    pen_.bold(x, y, page_.failure.empty() ? "Measuring" : "This set-up cannot be measured.");
    for (int line = 0; const std::string& words :
                       broken(page_.failure.empty() ? page_.doing : page_.failure, at_.chart.width / 6))
      pen_.soft(x, y + kLine * ++line, words);
  }

  void drawPlaces() {
    Painter inside = pen_.paint.within(at_.well);
    for (std::size_t k = page_.places.size(); k-- > 0;) {
      const Rect& frame = page_.places[k];
      const bool told = static_cast<int>(k) == page_.place;
      inside.frame({frame.x - 1, frame.y - 1, frame.width + 2, frame.height + 2}, pen_(Cell::Well));
      inside.frame(frame, pen_(told ? Cell::White : Cell::WellText));
      if (told)
        inside.frame({frame.x + 1, frame.y + 1, frame.width - 2, frame.height - 2}, pen_(Cell::White));
    }
  }

  int drawNumbers(int x, int y, int width) {
    const Measured& one = page_.trade.combinations[page_.chosen];
    const std::vector<std::string> name = broken(labelOf(one.configuration), width / 6);
    for (const std::string& line : name) pen_.bold(x, y, line), y += kLine;
    const auto row = [&](std::string_view label, const std::string& value, const std::string& soft) {
      pen_.soft(x, y, label);
      pen_.boldRight(x + 190, y, value);
      pen_.soft(x + 200, y, soft);
      y += kLine;
    };
    row("error", fixed(errorOnAllViews(one), 4), "limit " + textOfLimit(page_.limit));
    row("time", msText(one.cost.time.ms) + " ms", fixed(one.cost.time.ratio, 2) + " x the set-up");
    if (!at_.compact) {
      row("memory", fixed(static_cast<double>(one.cost.bytes) / 1e6, 1) + " MB", "");
      const PictureSettings& measured = one.configuration.settings;
      row("wrong, of " + sizeText(measured.width, measured.height), grouped(one.here.wrongFaces),
          "of " + grouped(one.here.samples));
    }
    if (page_.place < static_cast<int>(one.here.worst.size())) {
      const WorstPlace& place = one.here.worst[page_.place];
      row("place " + std::to_string(page_.place + 1) + " of " + std::to_string(one.here.worst.size()) +
              ", off by",
          fixed(place.error, 3), place.shownFace != place.face ? "a wrong face" : "");
    }
    return y;
  }

  void drawWhy(int x, int y, int width) {
    if (page_.chosen != page_.within.combination) return;
    pen_.rule(x, y - 8, width);
    y += 10;
    pen_.caps(x, y, "why this one");
    y += kLine + 2;
    // The rows above say what the first two sentences say.
    const std::vector<std::string>& why = page_.within.why;
    const int room = (at_.controls.y - 26 - y) / (kLine - 1) + 1;
    for (const std::string& line : wholeSentences(
             {why.begin() + std::min<std::ptrdiff_t>(2, std::ssize(why)), why.end()}, width / 6, room))
      pen_.ink(x, y, line), y += kLine - 1;
  }

  void drawControls() {
    const int x = at_.controls.x, width = at_.controls.width;
    pen_.rule(x, at_.controls.y - 22, width);
    pen_.caps(x, at_.controls.y - 6, "limit and axes");
    drawTradeLegend(pen_.paint, pen_.plan, x, at_.controls.y + at_.controls.height + 12);
  }

  Pen pen_;
  const TradeLayout& at_;
  const TradePage& page_;
};

}  // namespace

TradeLayout layoutOfTrade(const Rect& body, const Rect& measured) {
  TradeLayout at;
  at.compact = body.height < kCompactBelow;
  at.column = {body.x + body.width - kControls, body.y, kControls, body.height};
  const int wide = at.column.x - kMargin - body.x;
  at.chart = {body.x + 56, body.y + 44, wide - 64, body.height - 44 - 44};
  at.well = {at.column.x, body.y + 18, kControls, at.compact ? 120 : 196};
  const double scale =
      std::min(double(at.well.width) / measured.width, double(at.well.height) / measured.height);
  const int w = std::max(1, static_cast<int>(scale * measured.width)),
            h = std::max(1, static_cast<int>(scale * measured.height));
  at.picture = {at.well.x + (at.well.width - w) / 2, at.well.y + (at.well.height - h) / 2, w, h};
  const int controls = body.y + body.height - 3 * kRow - 26;
  at.controls = {at.column.x, controls, kControls, 3 * kRow};
  return at;
}

std::string textOfLimit(double limit) {
  return limit < kLimits.low ? textOf(limit) : fixed(limit, limit < 0.01 ? 4 : 3);
}

std::vector<std::string> wholeSentences(const std::vector<std::string>& sentences, int most, int room) {
  std::vector<std::string> all;
  for (const std::string& sentence : sentences) {
    const std::vector<std::string> lines = broken(sentence, most);
    if (std::ssize(all) + std::ssize(lines) <= room) all.insert(all.end(), lines.begin(), lines.end());
  }
  return all;
}

std::vector<Rect> framesOfWorst(const TradeLayout& at, const Rect& measured, const Measured& one) {
  constexpr int kFrame = 9;
  std::vector<Rect> frames;
  for (const WorstPlace& place : one.here.worst)
    frames.push_back({at.picture.x + place.x * at.picture.width / measured.width - kFrame / 2,
                      at.picture.y + place.y * at.picture.height / measured.height - kFrame / 2, kFrame,
                      kFrame});
  return frames;
}

void drawTradePage(Painter paint, const TradeLayout& at, const TradePage& page, const CellPlan& plan) {
  TradeDrawing drawing{paint, at, page, plan};
  drawing.drawChart();
  drawing.drawColumn();
}

}  // namespace xnewell
