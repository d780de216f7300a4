#include "x11/trade/accuracy_keeper.h"

#include <algorithm>
#include <utility>

#include "shading/trade/choice.h"
#include "x11/drawing/wording.h"
#include "x11/trade/chosen_setup.h"

namespace xnewell {

namespace {

constexpr double kSteady = 400;  // ms without a change before it measures

}  // namespace

AccuracyKeeper::Key AccuracyKeeper::keyOf(const Seen& now) {
  return {now.scene.name, measuredPart(now.setup), now.width, now.height};
}

Setup AccuracyKeeper::askedFor(const Seen& now) {
  if (!settled_ || settled_->scene != now.scene.name) return now.setup;
  // What differs from what was chosen here is the user's own choice from now on.
  for (const Setting& setting : settingRows())
    if (setting.field.get(now.setup.picture) != setting.field.get(used_.picture))
      mine_.emplace_back(setting.option.substr(2));
  if (now.setup.divisions != used_.divisions) mine_.emplace_back("divisions");
  Configuration back;
  for (const Change& change : chosen_.changes)
    if (valueOf(change, now.setup) == valueOf(change, used_))
      back.changes.push_back({change.setting, valueOf(change, asked_)});
  return withChanges(now.setup, back);
}

void AccuracyKeeper::measure(const Seen& now) {
  asked_ = askedFor(now);
  chosen_ = {};
  PictureSettings settings = asked_.picture;
  settings.width = now.width, settings.height = now.height;
  settings.inPixels = false;
  const int divisions = asked_.divisions > 0 ? asked_.divisions : now.divisions;
  Scene scene = now.scene.divisions == 0 ? now.scene : dividedAnew(now.scene, divisions);
  measuring_ = std::make_unique<Measuring>(std::move(scene), settings, request_, mine_);
}

AccuracyKeeper::News AccuracyKeeper::choose(const Seen& now, const Trade& trade, const std::string& failure) {
  const Chosen choice = chooseWithin(trade, limit_);
  if (choice.combination < 0)
    return {now.setup, failure.empty() ? "--accuracy found nothing to choose." : "--accuracy: " + failure};
  chosen_ = trade.combinations[choice.combination].configuration;
  const std::string name = chosen_.changes.empty() ? "the set-up as it is" : chosen_.name();
  const auto [off, allowed] = toldApart(errorOnAllViews(trade.combinations[choice.combination]), limit_.rms);
  return {withChanges(asked_, chosen_),
          choice.accurate
              ? "Within " + allowed + " with " + name + ": off by " + off + "."
              : "Nothing that was tried stays within " + allowed + ". Off by " + off + " with " + name + "."};
}

std::optional<AccuracyKeeper::News> AccuracyKeeper::tick(const Seen& now) {
  const Key key = keyOf(now);
  if (settled_ == key) return std::nullopt;
  if (pending_ != key) {
    pending_ = key;
    steady_ = {};
    measuring_.reset();
    return std::nullopt;
  }
  if (!measuring_) {
    if (steady_.ms() >= kSteady) measure(now);
    return std::nullopt;
  }
  const std::optional<Measuring::News> news = measuring_->news();
  if (!news || !news->done) return std::nullopt;
  measuring_.reset();
  News chosen = choose(now, news->trade, news->failure);
  used_ = chosen.setup;
  settled_ = key;
  settled_->setup = measuredPart(used_);
  return chosen;
}

}  // namespace xnewell
