#include "x11/trade/trade_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "shading/trade/combine.h"
#include "x11/drawing/pen.h"
#include "x11/drawing/wording.h"
#include "x11/trade/chosen_setup.h"
#include "x11/views/trade_table.h"
#include "x11/window/typed_number.h"

namespace xnewell {

namespace {

constexpr int kSteps = 40;  // of the limit's track

}  // namespace

void TradeBench::measure(const Picture& picture, const Setup& setup) {
  measuring_.reset();
  known_ = {};
  chosen_ = -1, picked_.reset(), within_ = {};
  painted_.reset();
  again_ = false;
  measuredSize_ = {0, 0, picture.settings().width, picture.settings().height};
  measuredOf_ = measuredPart(setup);
  measuredScene_ = picture.scene().name;
  measuring_ = std::make_unique<Measuring>(picture.scene(), picture.settings(), request_);
}

void TradeBench::tick() {
  if (!measuring_) return;
  std::optional<Measuring::News> news = measuring_->news();
  if (!news) return;
  known_ = std::move(*news);
  single_ = !areTimed(known_.trade.combinations);
  if (single_) known_.trade = withSingles(std::move(known_.trade));
  if (known_.done) measuring_.reset();
  choose();
}

void TradeBench::leave() {
  hovered_ = 0;
  if (!measuring_) return;
  measuring_.reset();
  known_ = {};
  measuredOf_.reset();  // measured anew when the view appears again
}

void TradeBench::choose() {
  within_ = {};
  chosen_ = -1;
  if (!known_.trade.front.empty()) {
    within_ = chooseWithin(known_.trade, limit_);
    chosen_ = picked_ ? indexOfPicked() : within_.combination;
  }
  changed_ = true;
}

/// The search may leave out what was picked while only single short cuts were known. Then it is added.
int TradeBench::indexOfPicked() {
  std::vector<Measured>& all = known_.trade.combinations;
  const auto same = std::ranges::find_if(
      all, [&](const Measured& one) { return one.configuration.changes == picked_->configuration.changes; });
  if (same != all.end()) return static_cast<int>(same - all.begin());
  all.push_back(*picked_);
  return static_cast<int>(all.size()) - 1;
}

void TradeBench::pick(int combination) {
  chosen_ = combination;
  picked_ = known_.trade.combinations[combination];
  changed_ = true;
}

void TradeBench::setLimit(double limit) {
  limit_.rms = std::clamp(limit, limitOfShare(0), limitOfShare(1));
  if (host_.keptWithin()) host_.keepWithin(limit_);
  picked_.reset();
  choose();
}

void TradeBench::walk(int steps) {
  const std::vector<int> front = frontBy(axes_, known_.trade);
  if (front.empty()) return;
  const auto at = std::ranges::find(front, chosen_);
  const auto last = static_cast<std::ptrdiff_t>(front.size()) - 1;
  const std::ptrdiff_t next =
      at == front.end() ? 0 : std::clamp<std::ptrdiff_t>(at - front.begin() + steps, 0, last);
  pick(front[static_cast<std::size_t>(next)]);
}

void TradeBench::useChosen() {
  if (chosen_ < 0) return;
  const Configuration chosen = known_.trade.combinations[chosen_].configuration;
  if (withChanges(host_.setup(), chosen) == host_.setup()) return host_.tell("That is the set-up.");
  host_.change('6', [&](Setup& s) { s = withChanges(s, chosen); });
  host_.tell("The window now uses " + chosen.name() + ".");
}

void TradeBench::compareChosen() {
  if (chosen_ < 0) return;
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

void TradeBench::askToSave() {
  if (known_.trade.combinations.empty()) return host_.notify("There is nothing to save yet.");
  const std::string stem = std::filesystem::path{measuredScene_}.stem().string();
  host_.ask({.asks = "save the chart (.png) or the table (.txt) as",
             .text = stem + "-trade.png",
             .take = [this, replaced = std::string{}](const std::string& file) mutable -> std::string {
               const bool chart = file.ends_with(".png");
               if (!chart && !file.ends_with(".txt")) return "The file's name ends in .png or .txt.";
               if (std::filesystem::is_directory(file)) return "That is a folder.";
               if (file != replaced && std::filesystem::exists(file)) {
                 replaced = file;
                 return "The file exists. Press Return again to replace it.";
               }
               try {
                 if (chart) {
                   const ColoredImage image =
                       drawTrade(known_.trade, "Cost against error: " + measuredScene_);
                   writeFile(file, encodePng(image.image, image.palette));
                 } else {
                   writeFile(file, tableOfCombinations(known_.trade));
                 }
               } catch (const std::system_error& e) {
                 return e.what();
               }
               host_.tell("Saved " + file + ".");
               return {};
             }});
}

bool TradeBench::press(const Key& key, const Setup&) {
  const int times = key.shift ? 5 : 1;
  switch (key.name) {
    case NamedKey::Left:
      return walk(-times), true;
    case NamedKey::Right:
      return walk(times), true;
    case NamedKey::Up:
      return setLimit(limitOfShare(shareOfLimit(limit_.rms) + double(times) / kSteps)), true;
    case NamedKey::Down:
      return setLimit(limitOfShare(shareOfLimit(limit_.rms) - double(times) / kSteps)), true;
    case NamedKey::Return:
      return useChosen(), true;
    case NamedKey::Letter:
      break;
    default:
      return false;
  }
  switch (key.letter) {
    case 'm':
      again_ = changed_ = true;
      return true;
    case 'k':
      host_.keepWithin(host_.keptWithin() ? std::nullopt : std::optional{limit_});
      host_.tell(host_.keptWithin() ? "The other views now keep within " + textOfLimit(limit_.rms) +
                                          ", and measure after each change."
                                    : "The set-up stays as it is now.");
      return changed_ = true;
    case 'n':
      place_ = places_.empty() ? 0 : (place_ + 1) % static_cast<int>(places_.size());
      return changed_ = true;
    case 'w':
      return askToSave(), true;
    case '5':
      return compareChosen(), chosen_ >= 0;
    case 'X':
      axes_.cost = static_cast<TradeCost>((static_cast<std::size_t>(axes_.cost) + 1) % kTradeCosts.size());
      return changed_ = true;
    case 'Y':
      axes_.error =
          static_cast<TradeError>((static_cast<std::size_t>(axes_.error) + 1) % kTradeErrors.size());
      return changed_ = true;
    case 'E':
    case '=':
      host_.ask({.asks = "largest error allowed, 0.001 to 0.5",
                 .text = textOfLimit(limit_.rms),
                 .take = [this](const std::string& text) -> std::string {
                   const std::optional<double> value = typedNumber(text);
                   if (!value || *value < limitOfShare(0) || *value > limitOfShare(1) + 1e-9)
                     return "The limit is a number from 0.001 to 0.5.";
                   setLimit(*value);
                   return {};
                 }});
      return true;
    default:
      return false;
  }
}

void TradeBench::hover(int x, int y) {
  const char before = hovered_;
  const int option = option_;
  hovered_ = at_.limit.has(x, y) ? 'E' : at_.costs.has(x, y) ? 'X' : at_.errors.has(x, y) ? 'Y' : 0;
  option_ = -1;
  const std::vector<Rect> options = hovered_ == 'X'   ? costOptions(at_)
                                    : hovered_ == 'Y' ? errorOptions(at_)
                                                      : std::vector<Rect>{};
  for (std::size_t k = 0; k < options.size(); ++k)
    if (options[k].has(x, y)) option_ = static_cast<int>(k);
  changed_ = changed_ || before != hovered_ || option != option_;
}

bool TradeBench::grab(int x, int y) {
  hover(x, y);
  if (hovered_ == 'X' && option_ >= 0) axes_.cost = static_cast<TradeCost>(option_);
  if (hovered_ == 'Y' && option_ >= 0) axes_.error = static_cast<TradeError>(option_);
  changed_ = true;
  if (hovered_ == 'E') {
    dragged_ = 'E';
    dragTo(x, y);
    return true;
  }
  for (std::size_t k = places_.size(); k-- > 0;)
    if (places_[k].has(x, y)) place_ = static_cast<int>(k);
  if (hovered_ != 0 || known_.trade.front.empty()) return false;
  // The limit's handle, a mark, or else the limit's line.
  const TradeScale scale{at_.chart, known_.trade, axes_};
  const bool hasLimit = axes_.error == TradeError::Rms;
  if (hasLimit && limitHandle(scale, limit_.rms).has(x, y)) {
    dragged_ = 'L';
    return true;
  }
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
  if (!hasLimit || std::abs(scale.y(limit_.rms) - y) > 6) return false;
  dragged_ = 'L';
  return true;
}

void TradeBench::dragTo(int x, int y) {
  if (dragged_ == 'E')
    setLimit(limitOfShare(double(x - at_.limit.x - kColumnTrackAt) / kColumnTrack));
  else if (dragged_ == 'L')
    setLimit(TradeScale{at_.chart, known_.trade, axes_}.errorAt(y));
}

bool TradeBench::isStale(const Desk& desk) const {
  const PictureSettings& now = desk.picture.settings();
  return (measuredOf_ && *measuredOf_ != measuredPart(desk.setup)) ||
         std::pair{now.width, now.height} != std::pair{measuredSize_.width, measuredSize_.height};
}

bool TradeBench::late(const Setup&) const { return changed_; }

void TradeBench::paintChosen(const Desk& desk) {
  if (chosen_ < 0) {
    painted_.reset();
    return;
  }
  const Configuration& chosen = known_.trade.combinations[chosen_].configuration;
  if (!pictures_ || divisions_ != chosen.divisions) {
    pictures_.emplace(dividedAnew(desk.picture.scene(), chosen.divisions));
    divisions_ = chosen.divisions;
  }
  PictureSettings settings = withChanges(desk.setup, chosen).picture;
  settings.camera = heldCamera(desk.picture);
  settings.width = at_.picture.width, settings.height = at_.picture.height;
  settings.inPixels = false;
  painted_ = pictures_->make(settings, desk.plan[Cell::Well]);
}

void TradeBench::draw(IndexImage& image, const Desk& desk) {
  at_ = layoutOfTrade(desk.layout.body, desk.layout.picture);
  if (const std::optional<AccuracyLimit> kept = host_.keptWithin(); kept && *kept != limit_) {
    limit_ = *kept;
    choose();
  }
  if (measuredScene_ != desk.picture.scene().name) measuredOf_.reset();
  if (again_ || !measuredOf_) {
    pictures_.reset();
    measure(desk.picture, desk.setup);
  }
  paintChosen(desk);
  const bool stale = isStale(desk);
  places_ = stale || chosen_ < 0 ? std::vector<Rect>{}
                                 : framesOfWorst(at_, measuredSize_, known_.trade.combinations[chosen_]);
  if (place_ >= static_cast<int>(places_.size())) place_ = 0;
  Painter{image}.fillRect(desk.layout.body, desk.plan[Cell::Paper]);
  drawTradePage(image, at_,
                {.trade = known_.trade,
                 .doing = known_.doing,
                 .failure = known_.failure,
                 .single = single_,
                 .kept = host_.keptWithin().has_value(),
                 .stale = stale,
                 .axes = axes_,
                 .limit = limit_.rms,
                 .chosen = chosen_,
                 .within = within_,
                 .picture = painted_ ? &painted_->image() : nullptr,
                 .places = places_,
                 .place = place_,
                 .hovered = hovered_,
                 .dragged = dragged_,
                 .option = option_},
                desk.plan);
  colors_ = {desk.palette, std::nullopt};
  use_ = {};
  if (painted_) {
    use_ = cellUse(painted_->image());
    const Palette own = painted_->palette(desk.plan, desk.palette);
    colors_.palette = desk.gray ? forGrayScreen(own, *painted_) : own;
  }
  status_ = measuring_
                ? "measuring: " + known_.doing
                : grouped(static_cast<std::int64_t>(known_.trade.combinations.size())) + " measured, " +
                      grouped(static_cast<std::int64_t>(frontBy(axes_, known_.trade).size())) +
                      " on the front";
  aside_ = measuring_ ? "" : grouped(known_.trade.ofCombinations.rounds) + " rounds, in turn";
  changed_ = false;
}

std::vector<Legend> TradeBench::legend() const {
  return {{{"<", ">"}, "along the front"}, {{"^", "v"}, "limit"},     {{"Return"}, "use this one"},
          {{"5"}, "beside no short cuts"}, {{"k"}, "keep the limit"}, {{"n"}, "next worst place"},
          {{"m"}, "measure again"},        {{"X", "Y"}, "axes"},      {{"w"}, "save"}};
}

std::vector<HelpLine> TradeBench::help() const {
  return {{"left, right", "along the front; or click a mark"},
          {"up, down", "the limit; or drag its line, or its slider; = types it"},
          {"Return", "use the chosen combination in all views"},
          {"5", "use it, and compare it with the set-up without short cuts"},
          {"n", "the next of the worst places; or click one"},
          {"X Y", "what the axes show"},
          {"w", "save the chart or the table"},
          {"k", "keep the limit: other views choose again after each change"},
          {"m", "measure again"}};
}

}  // namespace xnewell
