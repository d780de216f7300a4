#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "shading/diagnose/diagnose.h"

namespace xnewell {

/// From costs to a verdict.

namespace {

constexpr std::array kWidths{0.08, 0.25, 0.6, 1.2, 2.5, 5.0};  ///< of the distribution of d, in shades
constexpr double kAnything = 0.03;       ///< the share of samples that may differ by any number of shades
constexpr double kExplainsRight = 0.97;  ///< of the samples, before a picture is called right by its cost
constexpr double kNearlyAll = 0.98;      ///< of the samples, where no row fits
constexpr int kFewTelling = 5;           ///< samples; fewer tell nothing
constexpr double kTwoInformative = 0.95;
constexpr std::size_t kThin = 6;  ///< every sixth sample stands for all while pairs are tried

/// -log p(d) for each width, in steps of 1/16 shade.
constexpr int kSteps = 16, kFarthest = 256 * kSteps;
using Costs = std::array<std::array<double, kFarthest + 1>, kWidths.size()>;
const Costs& costs() {
  static const Costs all = [] {
    Costs made{};
    for (std::size_t w = 0; w < kWidths.size(); ++w) {
      const double q = std::exp(-1.0 / kWidths[w]), peak = (1.0 - kAnything) * (1.0 - q) / (1.0 + q);
      for (int k = 0; k <= kFarthest; ++k)
        made[w][k] = -std::log(peak * std::exp(-k / (kSteps * kWidths[w])) + kAnything / 256.0);
    }
    return made;
  }();
  return all;
}

/// The mean of -log p(d), with the best width.
double costOf(const std::vector<double>& d) {
  std::vector<int> step(d.size());
  std::ranges::transform(d, step.begin(), [](double v) {
    return static_cast<int>(std::min(v * kSteps + 0.5, double{kFarthest}));
  });
  double best = 1e300;
  for (const auto& cost : costs()) {
    double sum = 0.0;
    for (const int k : step) sum += cost[k];
    best = std::min(best, sum / static_cast<double>(d.size()));
  }
  return best;
}

bool isOk(Meaning meaning) { return meaning == Meaning::Right || meaning == Meaning::Allowed; }

/// The rank of two hypotheses at once: fewer mistakes first.
int mistakesIn(const Fit& fit) {
  return (fit.first->meaning == Meaning::Wrong) + (fit.second && fit.second->meaning == Meaning::Wrong);
}

}  // namespace

double Diagnoser::tolerance() const {
  return (rowOf(settings_.shading).interpolates ? 2.0 : 1.0) + (model_.colors ? 2.0 : 0.0);
}

bool Diagnoser::applies(const Hypothesis& h) const {
  return (h.applies == nullptr || h.applies(settings_)) && (leftOut_.empty() || h.key != leftOut_);
}

/// How many shades the picture is from a prediction.
double Diagnoser::apart(const Read& yours, std::size_t sample, const Predicted& other) const {
  double most = 0.0;
  for (int c = 0; c < (model_.colors ? 3 : 1); ++c) {
    const double ground = model_.colors ? ground_[c] : std::max({ground_[0], ground_[1], ground_[2]});
    const double shown = other.shows ? other.value[c] : ground;
    most = std::max(most, std::abs(yours.value[sample][c] - shown) / (other.step + other.slope));
  }
  return most;
}

double Diagnoser::apart(const Predicted& a, const Predicted& b) const {
  if (!a.shows || !b.shows) return a.shows == b.shows ? 0.0 : 255.0;
  double most = 0.0;
  for (int c = 0; c < (model_.colors ? 3 : 1); ++c)
    most = std::max(most, std::abs(double{a.value[c]} - b.value[c]) / (a.step + a.slope));
  return most;
}

double Diagnoser::cellsApart(double cell, const Predicted& other) const {
  return std::abs(cell - other.cell) / (1.0 + other.slope / other.step);
}

Fit Diagnoser::fit(TurnWay turn, const std::vector<Predicted>& other, std::size_t stride) {
  const Read& yours = reads_[static_cast<std::size_t>(turn)];
  const Read& upright = reads_.front();
  const std::vector<Predicted>& right = known(hypotheses().front());
  Fit fit;
  std::vector<double> d(other.size()), fromRight(other.size()), otherFromRight(other.size());
  double most = 0.0;
  for (std::size_t k = 0; k < other.size(); ++k) {
    const std::size_t s = k * stride;
    d[k] = apart(yours, s, other[k]);
    // A picture whose outlines fit only when it is turned differs from the right one everywhere.
    fromRight[k] = upright.value.empty() ? 255.0 : apart(upright, s, right[s]);
    otherFromRight[k] = apart(right[s], other[k]);
    if (!yours.cell.empty() && other[k].shows) {
      d[k] = std::max(d[k], cellsApart(yours.cell[s], other[k]));
      if (!upright.value.empty())
        fromRight[k] = std::max(fromRight[k], cellsApart(upright.cell[s], right[s]));
      otherFromRight[k] = std::max(otherFromRight[k], cellsApart(other[k].cell, right[s]));
    }
    most = std::max(most, otherFromRight[k]);
  }
  fit.cost = costOf(d);
  // A mistake that is off by a shade at most is told by cells that are exactly its own.
  const double t = tolerance(), own = 0.0 < most && most <= t ? 0.5 : t;
  int explained = 0, told = 0;
  for (std::size_t k = 0; k < d.size(); ++k) {
    explained += d[k] <= t;
    if (fromRight[k] <= own && otherFromRight[k] <= own) continue;
    ++fit.telling;
    told += d[k] <= own;
  }
  fit.explained = static_cast<double>(explained) / static_cast<double>(d.size());
  fit.informative = fit.telling > 0 ? static_cast<double>(told) / fit.telling : 0.0;
  return fit;
}

void Diagnoser::decide(Diagnosis& d) {
  std::vector<Fit> numbers;
  for (const Hypothesis& h : hypotheses()) {
    const Approach way = approachWith(h);
    if (!applies(h) || reads_[static_cast<std::size_t>(way.turn)].value.empty()) continue;
    if (h.key == "direct-colours" && !model_.colors) continue;
    Fit one = fit(way.turn, known(h));
    one.first = &h;
    (h.meaning == Meaning::Numbers ? numbers : d.all).push_back(one);
  }
  std::ranges::stable_sort(d.all, {}, &Fit::cost);
  std::ranges::stable_sort(numbers, {}, &Fit::cost);
  if (d.all.empty()) {
    d.verdict = Marking::OtherScene;
    return;
  }
  const double best = d.all.front().cost;
  const bool byNumbers = !numbers.empty() && numbers.front().cost < best - kClass &&
                         numbers.front().informative >= kInformative &&
                         numbers.front().telling >= kFewTelling;
  const auto accuses = [&](const Fit& f) {
    return f.telling >= kFewTelling && f.informative >= kInformative;
  };
  bool beaten = true;
  for (const Fit& f : d.all) {
    if (f.cost > best + kClass) break;
    if (!isOk(f.first->meaning)) continue;
    beaten = false;
    if (byNumbers || f.explained < kExplainsRight) continue;
    if (f.first->meaning == Meaning::Right)
      d.found.insert(d.found.begin(), f);
    else
      d.found.push_back(f);
  }
  if (!d.found.empty()) {
    d.verdict = d.found.front().first->meaning == Meaning::Right ? Marking::Right : Marking::Allowed;
    return;
  }
  if (byNumbers) {
    d.verdict = Marking::Numbers, d.found = {numbers.front()};
    return addPixel(d);
  }
  std::set<std::string_view> names;
  for (const Fit& f : d.all)
    if (beaten && f.cost <= best + kClass && accuses(f) && names.insert(f.first->key).second)
      d.found.push_back(f);
  if (!d.found.empty()) {
    d.verdict = d.found.size() == 1 ? Marking::Mistake : Marking::OneOf;
    return addPixel(d);
  }
  if (decideByTwo(d, best, false) || decideByTwo(d, best, true)) return addPixel(d);
  const Fit& right =
      *std::ranges::find_if(d.all, [](const Fit& f) { return f.first->meaning == Meaning::Right; });
  if (right.explained >= kNearlyAll) {
    d.verdict = Marking::Right, d.found = {right};
    return;
  }
  d.verdict = Marking::Unknown;
  addPixel(d);
}

/// Two rows at once: two that the course allows, or one of these and a mistake; or two mistakes. First with
/// few samples; what fits there is looked at with all.
bool Diagnoser::decideByTwo(Diagnosis& d, double best, bool twoMistakes) {
  std::vector<Fit> pairs;
  const auto rows = hypotheses();
  for (std::size_t a = 1; a < rows.size(); ++a)
    for (std::size_t b = a + 1; b < rows.size(); ++b) {
      const Hypothesis &first = rows[a], &second = rows[b];
      const bool wrong = first.meaning == Meaning::Wrong && second.meaning == Meaning::Wrong;
      if (first.meaning == Meaning::Numbers || second.meaning == Meaning::Numbers || wrong != twoMistakes ||
          first.key == second.key || !applies(first) || !applies(second))
        continue;
      const Approach way = approachWith(first, &second);
      if (reads_[static_cast<std::size_t>(way.turn)].value.empty()) continue;
      const auto [at, isNew] = two_.try_emplace({&first, &second});
      if (isNew) at->second = predicted(way, kThin);
      Fit one = fit(way.turn, at->second, kThin);
      one.first = &first, one.second = &second;
      pairs.push_back(one);
    }
  std::ranges::stable_sort(pairs, {}, &Fit::cost);
  if (pairs.empty() || pairs.front().cost > best - 2 * kClass) return false;
  const double least = pairs.front().cost;
  std::set<std::set<std::string_view>> names;
  for (const Fit& pair : pairs) {
    if (pair.cost > least + kClass) break;
    const Approach way = approachWith(*pair.first, pair.second);
    Fit whole = fit(way.turn, predicted(way));
    whole.first = pair.first, whole.second = pair.second;
    if (whole.explained < kExplainsRight || whole.informative < kTwoInformative) continue;
    std::set<std::string_view> wrong;
    for (const Hypothesis* h : {whole.first, whole.second})
      if (h->meaning == Meaning::Wrong) wrong.insert(h->key);
    if (whole.first->meaning != Meaning::Wrong && whole.second->meaning == Meaning::Wrong)
      std::swap(whole.first, whole.second);
    if (names.insert(wrong).second) d.found.push_back(whole);
  }
  std::ranges::stable_sort(d.found, {}, mistakesIn);
  if (d.found.empty()) return false;
  if (mistakesIn(d.found.front()) == 0) {
    d.found.resize(1);
    d.verdict = Marking::Allowed;
    return true;
  }
  if (d.found.size() > 6) return d.found.clear(), false;
  d.verdict = d.found.size() == 1 ? Marking::Mistake : Marking::OneOf;
  return true;
}

/// The sample where the mistake is furthest from right and the picture has it; without a mistake, the sample
/// where the picture is furthest from right.
void Diagnoser::addPixel(Diagnosis& d) {
  if (d.verdict == Marking::Allowed) return;
  const std::vector<Predicted>& right = known(hypotheses().front());
  const bool named = !d.found.empty();
  Approach way = approachOf(settings_);
  if (named) way = approachWith(*d.found.front().first, d.found.front().second);
  const std::vector<Predicted> other = predicted(way);
  const Read& yours = reads_[static_cast<std::size_t>(
      reads_[static_cast<std::size_t>(way.turn)].value.empty() ? 0 : static_cast<int>(way.turn))];
  if (yours.value.empty()) return;
  double most = -1.0;
  std::size_t at = 0;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const double here = named ? apart(right[k], other[k]) : apart(yours, k, right[k]);
    if (here <= most || (named && apart(yours, k, other[k]) > tolerance())) continue;
    most = here, at = k;
  }
  if (most < 0.0) return;
  OtherProgram program{model_, approachOf(settings_)};
  const DiagnosedSample& s = samples_[at];
  const ShownHere shown = program.at(s.face, s.i, s.j);
  DiagnosedPixel pixel{.i = s.i, .j = s.j, .face = picture_.snapped().faces[s.face].number};
  for (int c = 0; c < 3; ++c) {
    pixel.yours[c] = yours.value[at][c];
    pixel.right[c] = right[at].value[c];
    pixel.mistaken[c] = other[at].shows ? other[at].value[c] : ground_[c];
  }
  pixel.NdotL = shown.NdotL, pixel.RdotV = shown.RdotV;
  d.pixel = pixel;
}

}  // namespace xnewell
