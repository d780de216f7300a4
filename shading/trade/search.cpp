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
/// A change brings nothing if it is at most so many times as slow without it.
constexpr double kIdle = 1.1;

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

Search::Search(Measure& measure, std::vector<Axis> axes) : measure_{measure} {
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
  return to;
}

void Search::learn(const Move& move, const Look& from, const Look& to) {
  const auto observed = [](const Look& a, const Look& b) {
    Effect effect{.known = true, .square = b.square - a.square};
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

double Search::promise(const Look& look) const {
  const double least = leastMs(look.rms());
  // What would be more accurate than anything comes first, the cheap before the dear.
  return least == kInfinity ? 1e-3 * look.ms() / nodes_.front().look.ms() : look.ms() / least;
}

bool Search::makesIdle(const Node& simple, const Node& other) const {
  return &simple != &other && simple.look.ms() <= kIdle * other.look.ms() &&
         simple.look.rms() <= kErrorTie * other.look.rms() && isPart(simple.key, other.key);
}

bool Search::isPart(const Key& simple, const Key& other) const {
  const Key& now = nodes_.front().key;
  for (std::size_t k = 0; k < now.size(); ++k)
    if (simple[k] != now[k] && simple[k] != other[k]) return false;
  return true;
}

bool Search::helps(const Look& from, const Look& to) {
  return kErrorTie * to.ms() < from.ms() || kErrorTie * to.rms() < from.rms();
}

Search::Pick Search::pick() {
  for (const int k : nodeOfTried_)
    if (!nodes_[k].idle) expand(k);
  Pick best;
  double least = kHopeless;
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

void Search::take(int node, Measured measured, const Look& look) {
  nodes_[node].seen = true;
  nodes_[node].look = look;
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
  const Look look{stagesOf(measured.cost.stages), rms * rms};
  if (measured.configuration.changes.size() == 1)
    for (int k = 0; k < static_cast<int>(dials_.size()); ++k)
      if (key[k] != dials_[k].now) learn({k, dials_[k].now, key[k], node}, nodes_.front().look, look);
  take(node, measured, look);
}

bool Search::step() {
  const bool first = tried_.empty();
  const Pick next = first ? Pick{} : pick();
  if (!first && next.from < 0) return false;
  const int node = first ? 0 : next.move.node;
  Measured one;
  one.configuration = configurationOf(nodes_[node].key);
  const Glance glance = measure_.glance(one.configuration);
  if (glance.rms == kInfinity) {
    nodes_[node].seen = true;
    return !first;
  }
  one.here.afterTable.rootMeanSquare = glance.rms;
  one.cost.time = {.ms = glance.ms};
  one.cost.stages = glance.stages;
  take(node, std::move(one), {stagesOf(glance.stages), glance.rms * glance.rms});
  if (!first) learn(next.move, nodes_[next.from].look, nodes_[node].look);
  return true;
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
