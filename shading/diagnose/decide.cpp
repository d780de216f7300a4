#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <set>
#include <utility>

#include "depthsort/oracle.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/scene_for.h"

namespace xnewell {

/// From costs to a verdict.

namespace {

constexpr std::array kWidths{0.08, 0.25, 0.6, 1.2, 2.5, 5.0};  ///< of the distribution of d, in shades
constexpr double kAnything = 0.03;   ///< the share of samples that may differ by any number of shades
constexpr double kNearlyAll = 0.98;  ///< of the samples, where no row fits
constexpr double kSameValue = 0.75;  ///< of 255: the values are whole numbers
constexpr double kAsWell = 1e-6;     ///< of cost
constexpr double kLargeN = 32;
constexpr int kFewTelling = 12;  ///< samples; fewer tell nothing
constexpr int kFewFaces = 2;
constexpr int kFewOfFace = 2;  ///< samples, more of which tell against a row
/// Shades: a sample counts as no farther off than the first; the mean of what tells, as the noise and so
/// much.
constexpr double kMostOff = 10, kMostNoise = 0.3, kOff = 0.15, kOffOfOne = 1;
constexpr int kPlacesForTwo = 3;  ///< pairs of values that must tell before two mistakes are named
/// The faces, or values of smooth ones, that must tell a number; a third of those that are not right will do.
constexpr int kFacesForNumber = 3;
constexpr double kShareForNumber = 0.03;  ///< of the samples: a number that fewer tell is no number

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

bool isFirstForm(const Hypothesis& h) { return hypothesisNamed(h.key) == &h; }

/// The rank of two hypotheses at once: fewer mistakes first.
int mistakesIn(const Fit& fit) {
  return (fit.first->meaning == Meaning::Wrong) + (fit.second && fit.second->meaning == Meaning::Wrong);
}

}  // namespace

double Diagnoser::tolerance() const {
  return (rowOf(settings_.shading).interpolates ? 2.0 : 1.0) + (model_.colors ? 2.0 : 0.0);
}

bool Diagnoser::applies(const Hypothesis& h) const {
  if (h.key.starts_with("stores-2") && model_.colors && !model_.ramps) return false;  // right is 255 I there
  return (h.applies == nullptr || h.applies(settings_)) &&
         (h.changes == nullptr || std::ranges::any_of(model_.lights, h.changes));
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

/// Flat faces of one hue have one value each, and it is the same or it is not.
bool Diagnoser::tellsExactly() const { return settings_.shading == Shading::Flat && !model_.colors; }

bool Diagnoser::isSame(const Read& yours, std::size_t sample, const Predicted& other) const {
  const double shown = other.shows ? double{other.value[0]} : std::max({ground_[0], ground_[1], ground_[2]});
  return std::abs(yours.value[sample][0] - shown) < kSameValue &&
         (yours.cell.empty() || !other.shows || yours.cell[sample] == other.cell);
}

double Diagnoser::cellsApart(double cell, const Predicted& other) const {
  return std::abs(cell - other.cell) / (1.0 + other.slope / other.step);
}

Fit Diagnoser::fit(const std::vector<Predicted>& other, std::size_t stride) {
  const Read& yours = asHanded_;
  const std::vector<Predicted>& right = known(hypotheses().front());
  Fit fit;
  std::vector<double> d(other.size()), fromRight(other.size()), otherFromRight(other.size());
  double most = 0.0;
  for (std::size_t k = 0; k < other.size(); ++k) {
    const std::size_t s = k * stride;
    d[k] = apart(yours, s, other[k]);
    fromRight[k] = apart(yours, s, right[s]);
    otherFromRight[k] = apart(right[s], other[k]);
    if (!yours.cell.empty() && other[k].shows) {
      d[k] = std::max(d[k], cellsApart(yours.cell[s], other[k]));
      fromRight[k] = std::max(fromRight[k], cellsApart(yours.cell[s], right[s]));
      otherFromRight[k] = std::max(otherFromRight[k], cellsApart(other[k].cell, right[s]));
    }
    most = std::max(most, otherFromRight[k]);
  }
  fit.cost = costOf(d);
  // A mistake that is off by a shade at most is told by cells that are exactly its own.
  const double t = tolerance(), own = 0.0 < most && most <= t ? 0.5 : t;
  const bool exactly = tellsExactly();
  std::bitset<256 * 256> places;
  int explained = 0, told = 0, lastFace = kNothing;  // samples are in order of faces
  int ofFace = 0;                                    // those that it explains less those that it does not
  for (std::size_t k = 0; k < d.size(); ++k) {
    const std::size_t s = k * stride;
    explained += d[k] <= t;
    ofFace += d[k] <= t ? 1 : -1;
    if (k + 1 == d.size() || samples_[s + stride].face != samples_[s].face)
      fit.against += ofFace < -kFewOfFace, ofFace = 0;
    const bool byValue = exactly && other[k].slope == 0.0F;
    const bool yoursIsRight =
        byValue ? fromRight[k] < 200.0 && isSame(yours, s, right[s]) : fromRight[k] <= own;
    const bool otherIsRight = byValue ? otherFromRight[k] < 200.0 &&
                                            std::abs(right[s].value[0] - other[k].value[0]) < kSameValue &&
                                            (yours.cell.empty() || right[s].cell == other[k].cell)
                                      : otherFromRight[k] <= own;
    if (yoursIsRight && otherIsRight) {
      fit.noise += std::min(d[k], kMostOff);
      continue;
    }
    ++fit.telling;
    const bool isTold = byValue ? isSame(yours, s, other[k]) : d[k] <= own;
    told += isTold;
    fit.off += std::min(d[k], kMostOff);
    if (isTold && samples_[s].face != lastFace) ++fit.faces, lastFace = samples_[s].face;
    places.set(256 * std::clamp(static_cast<int>(right[s].value[0] + 0.5F), 0, 255) + yours.value[s][0]);
  }
  fit.places = static_cast<int>(places.count());
  fit.explained = static_cast<double>(explained) / static_cast<double>(d.size());
  fit.informative = fit.telling > 0 ? static_cast<double>(told) / fit.telling : 0.0;
  fit.off /= std::max(1, fit.telling);
  fit.noise /= std::max(1, static_cast<int>(d.size()) - fit.telling);
  return fit;
}

std::optional<Fit> Diagnoser::promising(const std::vector<Predicted>& few, const Approach& way) {
  if (fit(few, kFew).explained < kExplainsFew) return std::nullopt;
  const Fit some = fit(predicted(way, kThinned), kThinned);
  return some.explained < kExplainsSome ? std::nullopt : std::optional{some};
}

/// True if faces speak against a row, or if it is farther from the picture where it tells than elsewhere. A
/// mean of few samples is less certain. In a wrong order it depends on small things which face shows; of
/// several hues each has few shades.
bool Diagnoser::isContradicted(const Fit& fit) const {
  if (model_.colors || approachOf(fit).paint != PaintWay::Nearest) return false;
  const double most = (mistakesIn(fit) > 1 ? kOff / 2 : kOff) + std::min(fit.noise, kMostNoise) +
                      kOffOfOne / std::sqrt(std::max(1, fit.telling));
  return fit.against > 0 || (!tellsExactly() && (fit.noise > 2 * kMostNoise || fit.off > most));
}

/// True if a row or a number explains what it must.
bool Diagnoser::isTold(const Fit& fit) const {
  // Which face shows in a wrong order depends on small things, so not all of it is explained.
  const bool byFaces = approachOf(fit).paint != PaintWay::Nearest;
  if (fit.informative < (byFaces ? kInformativeOrder : tellsExactly() ? kExact : kInformative)) return false;
  return isOk(fit.first->meaning) || (!isContradicted(fit) && fit.telling >= kFewTelling &&
                                      (fit.faces >= kFewFaces || kFewFaces * fit.faces >= facesSampled_));
}

/// True if several faces, or values of smooth ones, tell a number from the row that fits best without it: the
/// picture has there what the number makes of them, and not what that row does.
bool Diagnoser::severalTell(const Fit& number, const Hypothesis& best) {
  if (number.telling < kShareForNumber * static_cast<double>(samples_.size())) return false;
  const std::vector<Predicted> mine = predicted(approachOf(number));
  const std::vector<Predicted>& theirs = known(best);
  const auto shows = [&](std::size_t s, const Predicted& one) {
    return tellsExactly() && one.slope == 0.0F ? isSame(asHanded_, s, one)
                                               : apart(asHanded_, s, one) <= tolerance();
  };
  std::set<std::pair<int, int>> faces;
  for (std::size_t s = 0; s < mine.size(); ++s)
    if (shows(s, mine[s]) && !shows(s, theirs[s]))
      faces.emplace(samples_[s].face, tellsExactly() ? 0 : asHanded_.value[s][0]);
  const auto tell = static_cast<int>(faces.size());
  return tell >= kFacesForNumber || tell * kFacesForNumber >= number.places;
}

void Diagnoser::decide(Diagnosis& d) {
  std::vector<Fit> numbers;
  for (const Hypothesis& h : hypotheses()) {
    if (!applies(h) || (h.way.view && h.way.view->isSmall())) continue;
    Fit one = fit(known(h));
    one.first = &h;
    if (h.meaning != Meaning::Numbers)
      d.all.push_back(one);
    else if (one.explained >= kExplainsRight && isTold(one))
      numbers.push_back(one);
  }
  std::ranges::stable_sort(d.all, {}, &Fit::cost);
  if (d.all.empty()) {
    d.verdict = Marking::OtherScene;
    return;
  }
  const double best = d.all.front().cost;
  const auto right = std::ranges::find(d.all, Meaning::Right, [](const Fit& f) { return f.first->meaning; });
  if (right != d.all.end()) d.exact = 1.0 - static_cast<double>(right->telling) / d.samples;
  const bool isBest =
      right != d.all.end() && right->cost <= best + kClass && right->explained >= kExplainsRight;
  if (isBest && (!tellsExactly() || d.exact >= kExact)) {
    d.verdict = Marking::Right, d.found = {*right};
    return;
  }
  for (const Fit& f : numbersThatFit(false)) {
    if (f.number->which == NumberOf::n)  // which says more than half or twice of it
      std::erase_if(numbers,
                    [](const Fit& one) { return one.first && one.first->term == "n" && !one.number; });
    numbers.push_back(f);
  }
  std::ranges::stable_sort(numbers, {}, &Fit::cost);
  const Hypothesis& bestRow = *d.all.front().first;
  /// Those of the best class that several faces tell.
  const auto toldBySeveral = [&](std::vector<Fit> all) {
    std::erase_if(all, [&](const Fit& f) { return !severalTell(f, bestRow); });
    if (!all.empty())
      std::erase_if(all, [least = all.front().cost](const Fit& f) { return f.cost > least + kClass; });
    return all;
  };
  const std::vector<Fit> told = toldBySeveral(numbers);
  const auto nameNumbers = [&](const std::vector<Fit>& found) {
    d.verdict = Marking::Numbers, d.found = found;
    addPixel(d);
  };
  if (!told.empty() && told.front().cost < best - kClass) return nameNumbers(told);
  if (isBest) {
    d.verdict = Marking::Right, d.found = {*right};
    return;
  }
  bool beaten = true;
  for (const Fit& f : d.all) {
    if (f.cost > best + kClass) break;
    if (f.first->meaning != Meaning::Allowed) continue;
    beaten = false;
    if (f.explained >= kExplainsRight && (!tellsExactly() || isTold(f))) d.found.push_back(f);
  }
  if (!d.found.empty()) {
    d.verdict = Marking::Allowed;
    for (const std::vector<Fit>* others : {&std::as_const(d.all), &std::as_const(numbers)})
      for (const Fit& f : *others)
        if (!isOk(f.first->meaning) && isTold(f) && f.cost <= d.found.front().cost + kAsWell)
          d.doubts.push_back(f);
    return;
  }
  std::set<std::string_view> names;
  for (const Fit& f : d.all)
    if (beaten && f.cost <= best + kClass && isTold(f) && names.insert(f.first->key).second)
      d.found.push_back(f);
  if (!d.found.empty()) {
    // A large n is another name for a highlight that is left out, and half of 2 for an n that is forgotten.
    const double least = d.found.front().cost + kAsWell;
    if (d.found.size() == 1)
      for (const Fit& f : numbers)
        if (f.cost <= least &&
            (f.number ? f.number->which != NumberOf::n || f.number->is <= kLargeN : f.first->term != "n"))
          d.found.push_back(f);
    d.verdict = d.found.size() == 1 ? Marking::Mistake : Marking::OneOf;
    return addPixel(d);
  }
  if (!told.empty()) return nameNumbers(told);
  if (decideByTwo(d, best, false)) return addPixel(d);
  if (const std::vector<Fit> fine = toldBySeveral(numbersThatFit(true)); !fine.empty())
    return nameNumbers(fine);
  if (decideByTwo(d, best, true)) return addPixel(d);
  if (right != d.all.end() && right->explained >= kNearlyAll) {
    d.verdict = Marking::Right, d.found = {*right};
    return;
  }
  d.verdict = Marking::Unknown;
  addPixel(d);
}

/// Two rows at once: two that the course allows, or one of these and a mistake; or two mistakes. First with
/// few samples; what fits there is looked at with all. Smooth pictures take long: of each key the first form.
bool Diagnoser::decideByTwo(Diagnosis& d, double best, bool twoMistakes) {
  std::vector<Fit> pairs;
  const auto rows = hypotheses();
  for (std::size_t a = 1; a < rows.size(); ++a)
    for (std::size_t b = a + 1; b < rows.size(); ++b) {
      const Hypothesis &first = rows[a], &second = rows[b];
      const bool wrong = first.meaning == Meaning::Wrong && second.meaning == Meaning::Wrong;
      if (!(tellsExactly() || (isFirstForm(first) && isFirstForm(second)))) continue;
      if (first.meaning == Meaning::Numbers || second.meaning == Meaning::Numbers || wrong != twoMistakes ||
          first.key == second.key || first.way.view || second.way.view || !applies(first) || !applies(second))
        continue;
      const auto [at, isNew] = two_.try_emplace({&first, &second});
      const Approach way = approachWith(first, &second);
      if (isNew) at->second = predicted(way, kFew);
      std::optional<Fit> one = promising(at->second, way);
      if (!one) continue;
      one->first = &first, one->second = &second;
      pairs.push_back(*one);
    }
  std::ranges::stable_sort(pairs, {}, &Fit::cost);
  if (pairs.empty() || pairs.front().cost > best - 2 * kClass) return false;
  const double least = pairs.front().cost;
  std::set<std::set<std::string_view>> names;
  for (const Fit& pair : pairs) {
    if (pair.cost > least + kClass) break;
    Fit whole = fit(predicted(approachWith(*pair.first, pair.second)));
    whole.first = pair.first, whole.second = pair.second;
    if (whole.explained < kExplainsRight || whole.informative < kExact) continue;
    if (twoMistakes && whole.places < kPlacesForTwo) continue;
    if (mistakesIn(whole) > 0 && isContradicted(whole)) continue;
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

std::vector<std::string_view> Diagnoser::whatCannotBeSeen() {
  const std::vector<Predicted>& right = known(hypotheses().front());
  std::vector<std::string_view> keys;
  std::set<std::string_view> seen;
  for (const Hypothesis& h : hypotheses()) {
    if (h.meaning != Meaning::Wrong || h.way.view || !applies(h) || !seen.insert(h.key).second) continue;
    const std::vector<Predicted>& other = known(h);
    int shown = 0;
    for (std::size_t k = 0; k < right.size() && shown < kFewTelling; ++k)
      shown += tellsExactly() && other[k].slope == 0.0F && other[k].shows
                   ? std::abs(right[k].value[0] - other[k].value[0]) >= kSameValue
                   : apart(right[k], other[k]) > tolerance();
    if (shown < kFewTelling && !differsSomewhere(h)) keys.push_back(h.key);
  }
  return keys;
}

bool Diagnoser::differsSomewhere(const Hypothesis& h) {
  const std::vector<int> right = facesOf({});
  const Approach way = approachWith(h);
  const std::vector<int>& faces = facesOf(way);
  OtherProgram rightly{model_, Approach{}}, wrongly{model_, way};
  int shown = 0;
  for (std::size_t at = 0; at < right.size(); ++at) {
    if (right[at] == kNothing || faces[at] == kNothing || !rightly.canShow(right[at])) continue;
    const int i = static_cast<int>(at) % settings_.width, j = static_cast<int>(at) / settings_.width;
    const Predicted a{rightly.at(right[at], i, j)}, b{wrongly.at(faces[at], i, j)};
    // Cells that are one off along a whole slope are no difference that shows.
    shown += apart(a, b) > (tellsExactly() ? 1.0 : 3.0) * tolerance();
    if (shown >= kFewTelling) return true;
  }
  return false;
}

/// The sample where picture and mistake are both furthest from right, and nearest to each other; without a
/// mistake, where the picture is furthest from right.
void Diagnoser::addPixel(Diagnosis& d) {
  const std::vector<Predicted>& right = known(hypotheses().front());
  const bool named = !d.found.empty();
  const std::vector<Predicted> other = predicted(named ? approachOf(d.found.front()) : Approach{});
  double most = 0.0;
  std::optional<std::size_t> at;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    double here = apart(asHanded_, k, right[k]);
    if (named) {
      const double off = apart(asHanded_, k, other[k]);
      if (off > tolerance()) continue;
      here = std::min(here, apart(right[k], other[k])) - off;
    }
    if (here <= most) continue;
    most = here, at = k;
  }
  if (!at) return;
  OtherProgram program{model_, Approach{}};
  const DiagnosedSample& s = samples_[*at];
  const ShownHere shown = program.at(s.face, s.i, s.j);
  DiagnosedPixel pixel{.i = s.i, .j = s.j, .face = picture_.snapped().faces[s.face].number};
  for (int c = 0; c < 3; ++c) {
    pixel.yours[c] = asHanded_.value[*at][c];
    pixel.right[c] = right[*at].value[c];
    pixel.mistaken[c] = other[*at].shows ? other[*at].value[c] : ground_[c];
  }
  pixel.NdotL = shown.NdotL, pixel.RdotV = shown.RdotV;
  d.pixel = pixel;
}

}  // namespace xnewell
