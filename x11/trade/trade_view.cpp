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
#include "shading/picture/shared.h"
#include "shading/trade/configuration.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"
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

/// ---- What is drawn

TradeLayout layoutOfTrade(const Rect& body) {
  constexpr int kRows = 3 * 22;
  const Rect column{body.x + body.width - kControls, body.y, kControls, body.height - kRows - 26};
  return {.chart = {body.x + 56, body.y + 44, column.x - kMargin - body.x - 64, body.height - 88},
          .page = {column.x, column.y, kControls, column.height - 30},
          .controls = {column.x, column.y + column.height, kControls, kRows}};
}

/// The chosen picture and the frames around its worst places.
void TradeView::drawChosen(Pen& pen, const Rect& well, const DrawContext& context) {
  constexpr int kFrame = 9;
  well_ = well;
  pen.paint.fillRect(well, pen(Cell::Well));
  painted_.reset(), places_.clear();
  if (chosen_ < 0) return;
  const Measured& one = known_.trade.combinations[chosen_];
  const Configuration& chosen = one.configuration;
  if (!pictures_ || divisions_ != chosen.divisions) {
    pictures_.emplace(dividedAnew(context.picture.scene(), chosen.divisions));
    divisions_ = chosen.divisions;
  }
  const Rect& like = context.layout.picture;
  const double scale = std::min(double(well.width) / like.width, double(well.height) / like.height);
  const int width = std::max(1, static_cast<int>(scale * like.width)),
            height = std::max(1, static_cast<int>(scale * like.height));
  const Rect at{well.x + (well.width - width) / 2, well.y + (well.height - height) / 2, width, height};
  PictureSettings settings = withChanges(context.setup, chosen).picture;
  settings.camera = heldCamera(context.picture);
  settings.width = width * context.layout.unit, settings.height = height * context.layout.unit;
  settings.inPixels = false;
  painted_ = pictures_->make(settings, context.plan[Cell::Well]);
  pen.paint.place(painted_->image(), at.x, at.y);
  if (isStale(context)) return;
  for (const WorstPlace& place : one.here.worst)
    places_.push_back({at.x + place.x * width / measuredSize_.width - kFrame / 2,
                       at.y + place.y * height / measuredSize_.height - kFrame / 2, kFrame, kFrame});
  if (place_ >= static_cast<int>(places_.size())) place_ = 0;
  Painter inside = pen.paint.within(well);
  for (std::size_t k = places_.size(); k-- > 0;) {
    const auto frame = [&, f = places_[k]](int by, Cell cell) {
      inside.frame({f.x - by, f.y - by, f.width + 2 * by, f.height + 2 * by}, pen(cell));
    };
    const bool told = static_cast<int>(k) == place_;
    frame(1, Cell::Well), frame(0, told ? Cell::White : Cell::WellText);
    if (told) frame(-1, Cell::White);
  }
}

/// The chosen combination, its numbers, and why it is this one.
page::Page TradeView::page(const DrawContext& context) {
  const std::vector<int> front = frontBy(axes_, known_.trade);
  const bool compact = context.layout.body.height < kCompactBelow, byLimit = chosen_ == within_.combination;
  page::Page page{.sections = {{.title = "chosen"}}};
  page::Section& top = page.sections.front();
  top.add(page::Sketch{.draw = [&](Pen& pen, const Rect& well) { drawChosen(pen, well, context); },
                       .lines = compact ? 8 : 12,
                       .weight = 9});
  if (chosen_ < 0) return page;
  top.aside = byLimit ? (within_.accurate ? "cheapest within the limit" : "the most accurate")
              : std::ranges::find(front, chosen_) != front.end() ? "on the front"
                                                                 : "not on the front";
  const Measured& one = known_.trade.combinations[chosen_];
  top.say(labelOf(one.configuration), 9).tone = page::Tone::Bold;
  page::Table numbers{.columns = {{}, {.right = true}, {}}, .least = 5};
  const auto row = [&](std::string label, std::string value, std::string more) {
    numbers.rows.push_back({{.words = std::move(label), .tone = page::Tone::Soft},
                            {.words = std::move(value), .tone = page::Tone::Bold},
                            {.words = std::move(more), .tone = page::Tone::Soft}});
  };
  const double limit = limit_.rms;
  row("error", fixed(errorOnAllViews(one), 4), "limit " + fixed(limit, limit < 0.01 ? 4 : 3));
  row("time", msText(one.cost.time.ms) + " ms", fixed(one.cost.time.ratio, 2) + " x the set-up");
  if (!compact) {
    row("memory", fixed(static_cast<double>(one.cost.bytes) / 1e6, 1) + " MB", "");
    const PictureSettings& measured = one.configuration.settings;
    row("wrong, of " + sizeText(measured.width, measured.height), grouped(one.here.wrongFaces),
        "of " + grouped(one.here.samples));
  }
  if (place_ < std::ssize(one.here.worst)) {
    const WorstPlace& place = one.here.worst[place_];
    row("place " + std::to_string(place_ + 1) + " of " + std::to_string(one.here.worst.size()) + ", off by",
        fixed(place.error, 3), place.shownFace != place.face ? "a wrong face" : "");
  }
  top.add(std::move(numbers));
  if (!byLimit) return page;
  page::Section& why = page.sections.emplace_back(page::Section{.title = "why this one"});
  // The rows above say what the first two sentences say.
  for (std::size_t k = 2; k < within_.why.size(); ++k) {
    std::string words = within_.why[k];
    for (std::size_t at = 0; (at = words.find("--")) != words.npos;) words.erase(at, 2);  // no command line
    why.say(std::move(words), 3);
  }
  return page;
}

void TradeView::drawChart(Pen& pen, bool stale, bool compact) {
  const Rect& chart = at_.chart;
  const std::vector<Measured>& all = known_.trade.combinations;
  pen.paint.text(chart.x - 48, chart.y - 28, "Cost against error", pen(Cell::Ink), Voice::Title);
  pen.softRight(chart.x + chart.width, chart.y - 28,
                stale
                    ? (compact ? "out of date: press m" : "measured for an earlier set-up: m measures again")
                    : counted(std::ssize(all), "configuration") + (compact   ? ""
                                                                   : single_ ? ", one change each"
                                                                             : ", this scene, this view"));
  if (areTimed(all))
    return drawTradePlot(pen.paint, pen.plan, TradeScale{chart, known_.trade, axes_}, known_.trade, chosen_,
                         axes_.error == TradeError::Rms ? std::optional{limit_.rms} : std::nullopt);
  const bool failed = !known_.failure.empty();
  int y = chart.y + chart.height / 2;
  pen.bold(chart.x, y, failed ? "This set-up cannot be measured." : "Measuring");
  for (const std::string& words : broken(failed ? known_.failure : known_.doing, chart.width / 6))
    pen.soft(chart.x, y += 17, words);
}

void TradeView::draw(Painter paint, const DrawContext& context) {
  const Rect& body = context.layout.body;
  at_ = layoutOfTrade(body);
  if (measuredScene_ != context.picture.scene().name) measuredOf_.reset();
  if (again_ || !measuredOf_) {
    pictures_.reset();
    measure(context.picture, context.setup);
  }
  Pen pen{paint, context.plan};
  paint.fillRect(body, context.plan[Cell::Paper]);
  drawChart(pen, isStale(context), body.height < kCompactBelow);
  const page::Page page = this->page(context);
  page::draw(pen, page, at_.page, page::pitchOf(body));
  const Rect& below = at_.controls;
  pen.rule(below.x, below.y - 22, below.width);
  pen.caps(below.x, below.y - 6, "limit and axes");
  drawTradeLegend(paint, context.plan, below.x, below.y + below.height + 12);
  list_.forgetPlaces();
  const Controls all = controls();
  (void)list_.placeColumn(all, below.x, below.y + 15);
  list_.draw(pen, all);
  colors_ = {context.palette, std::nullopt};
  use_ = {};
  if (painted_) {
    use_ = cellUse(painted_->image());
    const Palette own = painted_->palette(context.plan, context.palette);
    colors_.palette = context.gray ? forGrayScreen(own, *painted_) : own;
  }
  status_ = measuring_ ? "measuring, " + std::to_string(told_) + " of about " + textOf(request_.seconds) +
                             " s: " + known_.doing
                       : grouped(std::ssize(known_.trade.combinations)) + " measured, " +
                             grouped(std::ssize(frontBy(axes_, known_.trade))) + " on the front";
  aside_ = measuring_ ? "" : grouped(known_.trade.ofCombinations.rounds) + " rounds, in turn";
  words_ = page::asLines(page);
  words_.insert(words_.begin(), status_);
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

}  // namespace xnewell
