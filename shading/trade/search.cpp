#include "shading/trade/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "shading/picture/facts.h"
#include "shading/trade/choice.h"

namespace xnewell {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Candidates that promise less are left.
constexpr double kHopeless = 2;
/// What keeps the limit, but is slower than the fastest by more, is not looked at from elsewhere.
constexpr double kSlow = 1.7;
/// A change brings nothing if it is at most so many times as slow without it.
constexpr double kIdle = 1.1;
static_assert(kIdle * kNearFastest < kSlow);

/// How costly a value is before anything is known: a step doubles the time.
int costOf(const Axis& axis, double value) {
  if (!axis.setting) return 0;
  const auto choice = static_cast<std::size_t>(value);
  if (axis.setting->key == "order") {
    const OrderRow& order = kOrders[choice];
    return order.exact ? 3 : order.bySample ? 1 : 0;  // a sort of the list looks at no pair of faces
  }
  if (axis.setting->key == "method")
    return kShadings[choice].id == Shading::Phong || kShadings[choice].id == Shading::Environment ? 2
           : kShadings[choice].interpolates                                                       ? 1
                                                                                                  : 0;
  return 0;
}

std::array<double, 4> stagesOf(const StageTimes& t) { return {t.shade, t.transform, t.sort, t.fill}; }

}  // namespace

double Search::Look::rms() const { return std::sqrt(square); }

Search::Search(Measure& measure, std::vector<Axis> axes, std::optional<AccuracyLimit> within)
    : measure_{measure}, limit_{within} {
  for (Axis& axis : axes) {
    Dial dial{axis, axis.others};
    dial.values.push_back(axis.now);
    std::ranges::sort(dial.values);
    dial.now = static_cast<int>(std::ranges::find(dial.values, axis.now) - dial.values.begin());
    dial.ordered = !axis.setting;
    const std::size_t n = dial.values.size();
    effects_.emplace_back(n, std::vector<Effect>(n));
    dials_.push_back(std::move(dial));
  }
  Key now;
  for (const Dial& dial : dials_) now.push_back(static_cast<std::int8_t>(dial.now));
  (void)nodeOf(now);
}

Configuration Search::configurationOf(const Key& key) const {
  Configuration one = measure_.askedConfiguration();
  for (std::size_t k = 0; k < dials_.size(); ++k)
    if (key[k] != dials_[k].now) one = changed(one, dials_[k].axis, dials_[k].values[key[k]]);
  return one;
}

Search::Key Search::effective(Key key) const {
  for (bool again = true; again;) {
    again = false;
    const Configuration one = configurationOf(key);
    const PictureFacts facts = factsOf(measure_.asked(), one.settings);
    for (std::size_t k = 0; k < dials_.size(); ++k) {
      const Setting* const setting = dials_[k].axis.setting;
      if (key[k] == dials_[k].now || !setting || hasEffect(*setting, facts)) continue;
      key[k] = static_cast<std::int8_t>(dials_[k].now);
      again = true;
    }
  }
  return key;
}

int Search::nodeOf(const Key& key) {
  const auto [at, isNew] = ids_.try_emplace(key, static_cast<int>(nodes_.size()));
  if (isNew) nodes_.push_back({key});
  return at->second;
}

void Search::expand(int node) {
  if (nodes_[node].expanded) return;
  std::vector<Move> moves;
  for (int k = 0; k < static_cast<int>(dials_.size()); ++k) {
    const int from = nodes_[node].key[k];
    for (int to = 0; to < static_cast<int>(dials_[k].values.size()); ++to) {
      if (to == from || (dials_[k].ordered && std::abs(to - from) > 1)) continue;
      Key key = nodes_[node].key;
      key[k] = static_cast<std::int8_t>(to);
      key = effective(std::move(key));
      if (key[k] == to) moves.push_back({k, from, to, nodeOf(key)});
    }
  }
  nodes_[node].moves = std::move(moves);
  nodes_[node].expanded = true;
}

Search::Effect Search::effectOf(const Move& move, const Look& from) const {
  const Effect& known = effect(move.dial, move.from, move.to);
  if (known.known) return known;
  const Dial& dial = dials_[move.dial];
  const Effect &back = effect(move.dial, move.from, dial.now), &there = effect(move.dial, dial.now, move.to);
  Effect guess;
  if (back.known && there.known) {
    for (std::size_t s = 0; s < guess.stages.size(); ++s) guess.stages[s] = back.stages[s] * there.stages[s];
    guess.square = back.square + there.square;
    guess.wrong = back.wrong + there.wrong;
    return guess;
  }
  const double a = dial.values[move.from], b = dial.values[move.to];
  const double ratio = dial.axis.setting ? std::exp2(costOf(dial.axis, b) - costOf(dial.axis, a))
                                         : b * b / (a * a);  // as many times the polygons
  guess.stages.fill(ratio);
  guess.square = (dial.axis.setting ? -0.5 : std::min(0.5 / (ratio * ratio), 1.0) - 0.5) * from.square;
  return guess;
}

Search::Look Search::after(const Look& from, const Effect& effect) {
  constexpr double kLeastGuess = 0.02;  // of the square: an error does not vanish
  Look to;
  for (std::size_t s = 0; s < to.stages.size(); ++s) to.stages[s] = from.stages[s] * effect.stages[s];
  to.square = std::max(from.square + effect.square, kLeastGuess * from.square);
  to.wrong = std::max(0.0, from.wrong + effect.wrong);
  return to;
}

void Search::learn(const Move& move, const Look& from, const Look& to) {
  const auto observed = [](const Look& a, const Look& b) {
    Effect effect{.known = true, .square = b.square - a.square, .wrong = b.wrong - a.wrong};
    const double floor = 0.005 * (a.ms() + b.ms());  // a stage that takes no time tells no ratio
    for (std::size_t s = 0; s < effect.stages.size(); ++s)
      effect.stages[s] = (b.stages[s] + floor) / (a.stages[s] + floor);
    return effect;
  };
  effect(move.dial, move.from, move.to) = observed(from, to);
  effect(move.dial, move.to, move.from) = observed(to, from);
}

double Search::leastMs(double rms) const {
  double least = kInfinity;
  for (const int k : nodeOfTried_)
    if (nodes_[k].look.rms() <= rms) least = std::min(least, nodes_[k].look.ms());
  return least;
}

double Search::excess(double rms, double wrong) const {
  double most = std::max(1.0, rms / ((1 - kSpare) * limit_->rms));
  if (limit_->wrong) most = std::max(most, (wrong + 1) / (static_cast<double>(*limit_->wrong) + 1));
  return most;
}

double Search::promise(const Look& look) const {
  if (!limit_) {
    const double least = leastMs(look.rms());
    // What would be more accurate than anything comes first, the cheap before the dear.
    return least == kInfinity ? 1e-3 * look.ms() / nodes_.front().look.ms() : look.ms() / least;
  }
  const double over = excess(look.rms(), look.wrong);
  if (least_ > 0) return look.ms() / least_ * over * over;
  return 1e-3 * std::sqrt(look.ms() / nodes_.front().look.ms()) * over * over;
}

bool Search::makesIdle(const Node& simple, const Node& other) const {
  return &simple != &other && simple.look.ms() <= kIdle * other.look.ms() &&
         simple.look.rms() <= kErrorTie * other.look.rms() && simple.look.wrong <= other.look.wrong &&
         isPart(simple.key, other.key);
}

bool Search::isPart(const Key& simple, const Key& other) const {
  const Key& now = nodes_.front().key;
  for (std::size_t k = 0; k < now.size(); ++k)
    if (simple[k] != now[k] && simple[k] != other[k]) return false;
  return true;
}

bool Search::helps(const Look& from, const Look& to) {
  return kErrorTie * to.ms() < from.ms() || kErrorTie * to.rms() < from.rms() || to.wrong < from.wrong;
}

Search::Pick Search::pick() {
  for (const int k : nodeOfTried_)
    if (!nodes_[k].idle) expand(k);
  Pick best;
  // As long as nothing keeps the limit, nothing is hopeless.
  double least = limit_ && least_ == 0 ? kInfinity : kHopeless;
  for (const int k : nodeOfTried_)
    for (const Move& move : nodes_[k].moves) {
      if (nodes_[k].idle) break;
      if (nodes_[move.node].seen) continue;
      const Look& from = nodes_[k].look;
      const Look to = after(from, effectOf(move, from));
      if (!helps(from, to)) continue;
      const double value = promise(to);
      if (value < least) least = value, best = {k, move};
    }
  return best;
}

Search::Pick Search::pickBeside() {
  if (!limit_ || least_ == 0) return {};
  for (const int k : within(kNearFastest, kIdle)) {
    const int from = nodeOfTried_[k];
    expand(from);
    for (const Move& move : nodes_[from].moves) {
      if (nodes_[move.node].seen) continue;
      const Look& look = nodes_[from].look;
      if (move.to == dials_[move.dial].now || promise(after(look, effectOf(move, look))) < kHopeless)
        return {from, move};
    }
  }
  return {};
}

void Search::take(int node, Measured measured, const Look& look) {
  nodes_[node].seen = true;
  nodes_[node].look = look;
  if (limit_ && excess(look.rms(), look.wrong) <= 1 && (least_ == 0 || look.ms() < kSlow * least_)) {
    const Glance turned = measure_.glanceElsewhere(measured.configuration, limit_->wrong.has_value());
    measured.elsewhere = turned.rms, measured.wrongElsewhere = turned.wrong;
    nodes_[node].look.square = std::max(look.square, turned.rms * turned.rms);
    nodes_[node].look.wrong = std::max(look.wrong, static_cast<double>(turned.wrong));
    if (keeps(measured, *limit_) && (least_ == 0 || look.ms() < least_)) least_ = look.ms();
  }
  for (const int other : nodeOfTried_) {
    nodes_[node].idle = nodes_[node].idle || makesIdle(nodes_[other], nodes_[node]);
    nodes_[other].idle = nodes_[other].idle || makesIdle(nodes_[node], nodes_[other]);
  }
  tried_.push_back(std::move(measured));
  nodeOfTried_.push_back(node);
}

void Search::know(const Measured& measured) {
  Key key = nodes_.front().key;
  for (const Change& change : measured.configuration.changes)
    for (std::size_t k = 0; k < dials_.size(); ++k)
      if (dials_[k].axis.setting == change.setting)
        key[k] = static_cast<std::int8_t>(std::ranges::find(dials_[k].values, change.value) -
                                          dials_[k].values.begin());
  const int node = nodeOf(key);
  if (nodes_[node].seen) return;
  const double rms = std::max(measured.here.afterTable.rootMeanSquare, measured.elsewhere);
  const Look look{stagesOf(measured.cost.stages), rms * rms, static_cast<double>(measured.here.wrongFaces)};
  if (measured.configuration.changes.size() == 1)
    for (int k = 0; k < static_cast<int>(dials_.size()); ++k)
      if (key[k] != dials_[k].now) learn({k, dials_[k].now, key[k], node}, nodes_.front().look, look);
  take(node, measured, look);
}

bool Search::step() {
  const bool first = tried_.empty();
  Pick next = first ? Pick{} : pick();
  if (!first && next.from < 0) next = pickBeside();
  if (!first && next.from < 0) return false;
  const int node = first ? 0 : next.move.node;
  Measured one;
  one.configuration = configurationOf(nodes_[node].key);
  const Glance glance = measure_.glance(one.configuration, limit_ && limit_->wrong);
  if (glance.rms == kInfinity) {
    nodes_[node].seen = true;
    return !first;
  }
  one.here.afterTable.rootMeanSquare = glance.rms;
  one.here.wrongFaces = glance.wrong;
  one.cost.time = {.ms = glance.ms};
  one.cost.stages = glance.stages;
  one.cost.rough = true;
  take(node, std::move(one),
       {stagesOf(glance.stages), glance.rms * glance.rms, static_cast<double>(glance.wrong)});
  if (!first) learn(next.move, nodes_[next.from].look, nodes_[node].look);
  return true;
}

std::vector<int> Search::within(double times, double saves) const {
  std::vector<int> all;
  const auto isWithin = [&](int k, double most) {
    return keeps(tried_[k], *limit_) && tried_[k].cost.time.ms <= most * least_;
  };
  std::vector<const Measured*> some;
  for (int k = 0; k < static_cast<int>(tried_.size()); ++k)
    if (isWithin(k, saves * times)) all.push_back(k), some.push_back(&tried_[k]);
  const std::vector<const Measured*> useful = usefulOf(std::move(some), saves);
  std::erase_if(all, [&](int k) {
    return !isWithin(k, times) || std::ranges::find(useful, &tried_[k]) == useful.end();
  });
  std::ranges::stable_sort(all, {}, [&](int k) { return tried_[k].cost.time.ms; });
  return all;
}

std::vector<int> Search::byError() const {
  std::vector<int> all(tried_.size());
  std::iota(all.begin(), all.end(), 0);
  std::ranges::stable_sort(all, {}, [&](int k) { return errorOnAllViews(tried_[k]); });
  return all;
}

std::vector<int> Search::nearFront(std::size_t count) const {
  std::vector<int> all(tried_.size());
  std::iota(all.begin(), all.end(), 0);
  std::erase_if(all, [&](int k) { return nodes_[nodeOfTried_[k]].idle; });
  std::ranges::stable_sort(all, {}, [&](int k) {
    const Look& look = nodes_[nodeOfTried_[k]].look;
    return look.ms() / leastMs(look.rms());
  });
  if (all.size() > count) all.resize(count);
  return all;
}

std::string Search::neverTried() const {
  std::string all;
  for (std::size_t k = 0; k < dials_.size(); ++k) {
    std::string values;
    for (std::size_t v = 0; v < dials_[k].values.size(); ++v)
      if (std::ranges::none_of(nodeOfTried_, [&](int n) { return nodes_[n].key[k] == static_cast<int>(v); }))
        values += (values.empty() ? " " : ", ") + dials_[k].axis.text(dials_[k].values[v]);
    if (!values.empty())
      all += (all.empty() ? "" : "; ") + ("--" + std::string{dials_[k].axis.name()}) + values;
  }
  return all;
}

}  // namespace xnewell
