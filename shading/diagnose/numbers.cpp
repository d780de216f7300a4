#include <algorithm>
#include <cmath>
#include <set>

#include "shading/diagnose/diagnose.h"

namespace xnewell {

/// Other numbers than the scene's: one at a time, over a range.

namespace {

constexpr std::size_t kMostFullyTried = 12;
constexpr int kMostWholeN = 32;

/// n: whole numbers, then the round ones. The factors: hundredths, or multiples of 1/20.
std::vector<double> valuesOf(NumberOf which, bool fine) {
  std::vector<double> all;
  if (which == NumberOf::n) {
    for (int n = 0; n <= (fine ? 300 : kMostWholeN); ++n) all.push_back(n);
    if (!fine) all.insert(all.end(), {40, 50, 60, 64, 80, 100, 128, 200, 250, 256, 300, 500, 1000});
  } else if (which == NumberOf::I0) {
    for (int k = 1; k <= (fine ? 200 : 20); ++k) all.push_back(fine ? k / 1000.0 : k / 200.0);
  } else {
    for (int k = 1; k <= (fine ? 100 : 20); ++k) all.push_back(fine ? k / 100.0 : k / 20.0);
  }
  return all;
}

}  // namespace

/// The numbers of the faces in view that may be others, each with values. A value that is another name of a
/// row of hypotheses() is left out: a factor of 0 or, where 1 is what is left if it is forgotten, of 1; ka or
/// Ia twice; ka Ia that is Ia alone.
std::vector<OtherNumber> Diagnoser::likelyNumbers(bool fine) const {
  std::set<double> n, ka, kd, ks, Ia, Ip, I0;
  const int channels = model_.channels;
  for (const DiagnosedSample& s : samples_) {
    const int material = model_.mesh().material[picture_.snapped().faces[s.face].number];
    for (int c = 0; c < channels; ++c) {
      const Reflection& r = model_.surface[material + 1][c];
      n.insert(r.n), ka.insert(r.ka), kd.insert(r.kd), ks.insert(r.ks);
    }
  }
  for (int c = 0; c < channels; ++c) {
    Ia.insert(model_.Ia[c]);
    for (const Light& light : model_.lights) Ip.insert(light.Ip[c]);
  }
  if (settings_.table.kind == TableKind::Corrected && !model_.colors) I0.insert(settings_.table.I0);
  const auto isNamed = [&](NumberOf which, double was, double is) {
    const auto near = [&](double v) { return std::abs(is - v) < 0.006; };
    switch (which) {
      case NumberOf::n:
      case NumberOf::Ip:
        return near(1);
      case NumberOf::ka:
        return near(1) || near(2 * was);
      case NumberOf::Ia:
        return near(2 * was) || std::ranges::any_of(ka, [&](double k) { return k > 0 && near(was / k); });
      default:
        return false;
    }
  };
  std::vector<OtherNumber> all;
  const auto add = [&](NumberOf which, const std::set<double>& said) {
    if (said.size() > 6) return;  // values that belong to no name
    for (const double was : said)
      for (const double is : valuesOf(which, fine))
        if (std::abs(was - is) > 1e-9 && !isNamed(which, was, is) && (was != 0.0 || which == NumberOf::n))
          all.push_back({which, was, is});
  };
  add(NumberOf::n, n), add(NumberOf::ka, ka), add(NumberOf::kd, kd), add(NumberOf::ks, ks);
  add(NumberOf::Ia, Ia), add(NumberOf::Ip, Ip), add(NumberOf::I0, I0);
  return all;
}

/// The numbers that explain the picture, best first: within kClass of the best, each once.
std::vector<Fit> Diagnoser::numbersThatFit(bool fine) {
  auto& known = fine ? fineNumbers_ : numbers_;
  if (known.empty())
    for (const OtherNumber& number : likelyNumbers(fine)) {
      known.emplace_back(number, predicted({.number = number}, kFew));
    }
  std::vector<Fit> some;
  for (const auto& [number, shown] : known) {
    std::optional<Fit> one = promising(shown, {.number = number});
    if (!one) continue;
    one->first = &rowOfNumber(number.which), one->number = number;
    some.push_back(*one);
  }
  std::ranges::stable_sort(some, {}, &Fit::cost);
  std::vector<Fit> all;
  for (const Fit& one : some) {
    if (all.size() >= kMostFullyTried || one.cost > some.front().cost + 2 * kClass) break;
    Fit whole = fit(predicted(approachOf(one)));
    whole.first = one.first, whole.number = one.number;
    if (whole.explained >= kExplainsRight && isTold(whole)) all.push_back(whole);
  }
  std::ranges::stable_sort(all, {}, &Fit::cost);
  std::vector<Fit> best;
  for (const Fit& one : all)
    if (one.cost <= all.front().cost + kClass && std::ranges::none_of(best, [&](const Fit& f) {
          return f.number->which == one.number->which && f.number->was == one.number->was;
        }))
      best.push_back(one);
  return best;
}

}  // namespace xnewell
