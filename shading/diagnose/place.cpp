#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "depthsort/oracle.h"
#include "shading/diagnose/diagnose.h"

namespace xnewell {

/// Mistakes of the viewing transformation: faces lie elsewhere.

namespace {

constexpr double kPlaced = 0.9;          ///< of the places where a face shows in either picture
constexpr double kPlacedTwo = 0.93;      ///< the same, for two rows at once
constexpr double kOutlinesTell = 0.985;  ///< of the outlines, before they tell a view by themselves
constexpr double kOutlinesOnly = 0.95;   ///< of the outlines, before a row of shading is tried with a view
constexpr double kPlacedFew = 0.8;       ///< of every 16th place, before all are looked at
constexpr std::size_t kMostPlaces = 12'000, kMostViews = 4, kFewPlaced = 16;
constexpr double kOfFewFaces = 0.97;  ///< where kFacesForAPlace show or less
constexpr float kSteep = 12;          ///< values from a pixel to the next, of which a shade tells nothing
constexpr int kFewPlaces = 30, kManyPlaces = 200, kFacesForAPlace = 3;

}  // namespace

const Diagnoser::Seen& Diagnoser::seenBy(const Hypothesis& h) {
  const int w = settings_.width, height = settings_.height;
  if (places_.empty()) {
    const int step = std::max(1, static_cast<int>(std::sqrt(double(w) * height / kMostPlaces)));
    for (int j = 1; j + 1 < height; j += step)
      for (int i = 1; i + 1 < w; i += step) places_.push_back({i, j, 0});
  }
  const auto [at, isNew] = seen_.try_emplace(&h);
  if (!isNew) return at->second;
  const Approach way = approachWith(h);
  const std::vector<int>& faces = facesOf(way);
  OtherProgram program{model_, way};
  for (const DiagnosedSample& s : places_) {
    const int face = faces[indexOf(s.i, s.j)];
    const bool isKnown = isInside(faces, s.i, s.j) && (face == kNothing || program.canShow(face));
    at->second.face.push_back(isKnown ? face : kEdge);
    at->second.shown.push_back(isKnown && face != kNothing ? predictedAt(program, s, face) : Predicted{});
  }
  return at->second;
}

/// How much of what either picture shows is the same. The ground is the commonest colour beside the faces.
Diagnoser::Score Diagnoser::scoreOf(const HandedIn& handed, const Seen& seen, const Read& yours,
                                    std::size_t stride) const {
  using Color = std::array<std::uint8_t, 3>;
  const auto colorAt = [&](std::size_t k) {
    const std::uint8_t* const p = handed.picture.pixel(places_[k].i, places_[k].j);
    return Color{p[0], p[1], p[2]};
  };
  std::map<Color, std::size_t> beside;
  for (std::size_t k = 0; k < seen.face.size(); ++k)
    if (seen.face[k] == kNothing) ++beside[colorAt(k)];
  std::optional<Color> ground;
  if (!beside.empty())
    ground = std::ranges::max_element(beside, {}, [](const auto& c) { return c.second; })->first;
  if (ground && beside[*ground] * 100 < seen.face.size()) ground.reset();
  Score score{.hasGround = ground.has_value()};
  std::set<int> faces;
  int hits = 0, both = 0;
  for (std::size_t k = 0; k < seen.face.size(); k += stride) {
    if (seen.face[k] == kEdge) continue;
    ++score.known;
    const bool theirs = !ground || colorAt(k) != *ground, ours = seen.face[k] != kNothing;
    if (!ours && (!theirs || !ground)) continue;
    ++score.counted, both += ours && theirs;
    if (!ours || seen.shown[k].slope > kSteep || apart(yours, k, seen.shown[k]) > tolerance()) continue;
    ++hits, faces.insert(seen.face[k]);
  }
  const double share = score.counted > 0 ? 1.0 / score.counted : 0.0;
  score.share = hits * share, score.overlap = both * share, score.faces = static_cast<int>(faces.size());
  return score;
}

/// The rows of the view that put the faces where the picture has them: with the right shades; or with one of
/// the other rows, where the outlines fit.
bool Diagnoser::decidePlaced(const HandedIn& handed, Diagnosis& d) {
  const Hypothesis& right = hypotheses().front();
  const Seen& rightly = seenBy(right);  // finds the places
  const Read yours = read(handed, places_, false);
  const Score asItIs = scoreOf(handed, rightly, yours);
  // A view explains at least half of what is not right.
  const double least = asItIs.share + std::max(0.02, 0.5 * (1.0 - asItIs.share));
  std::vector<std::pair<Score, Fit>> views, pairs;
  // On this scene a row may change nothing: a window whose centre is on the axis has no shear to forget.
  const auto changesNothing = [&](const Seen& seen) {
    constexpr int kByRounding = 3;
    int others = 0;
    for (std::size_t k = 0; k < seen.face.size() && others <= kByRounding; ++k)
      if (seen.face[k] != kEdge && rightly.face[k] != kEdge)
        others += seen.face[k] != rightly.face[k] || seen.shown[k].value != rightly.shown[k].value;
    return others <= kByRounding;
  };
  for (const Hypothesis& h : hypotheses())
    if (h.way.view && !h.way.view->isSmall() && !changesNothing(seenBy(h))) {
      const Score score = scoreOf(handed, seenBy(h), yours);
      Fit fit{.first = &h, .cost = 1.0 - score.share, .explained = score.share, .telling = score.counted};
      fit.informative = score.share, fit.faces = score.faces;
      views.emplace_back(score, fit);
    }
  const auto isFound = [&](const std::pair<Score, Fit>& one, double share) {
    const Score& score = one.first;
    if (score.share < share || score.share <= least || score.counted < kFewPlaces) return false;
    // What it calls ground is all over the faces, too; or the faces lie better as they are.
    if (score.overlap < std::max(0.5, asItIs.overlap - 0.02)) return false;
    // Of one or two faces, the outline tells.
    const bool hasOutline = score.counted < 0.95 * score.known;
    return score.faces >= kFacesForAPlace ||
           (score.share >= kOfFewFaces && score.counted >= kManyPlaces && hasOutline);
  };
  const auto take = [&](const std::vector<Fit>& found) {
    if (found.empty() || found.size() > 6) return false;
    d.found = found;
    d.verdict = found.size() > 1 ? Marking::OneOf : Marking::Mistake;
    addPixel(d);
    return true;
  };
  const auto name = [&](std::vector<std::pair<Score, Fit>>& all, double share) {
    std::ranges::stable_sort(all, {}, [](const auto& one) { return one.second.cost; });
    std::set<std::pair<std::string_view, std::string_view>> names;
    std::vector<Fit> found;
    for (const auto& one : all) {
      const Fit& fit = one.second;
      const bool two = fit.second && fit.second->meaning == Meaning::Wrong;
      if (isFound(one, share) && fit.cost <= all.front().second.cost + kClass &&
          names.insert({fit.first->key, two ? fit.second->key : ""}).second)
        found.push_back(fit);
    }
    return take(found);
  };
  if (name(views, kPlaced)) return true;
  std::ranges::stable_sort(views, {}, [](const auto& one) { return -one.first.overlap; });
  for (std::size_t k = 0; k < std::min(views.size(), kMostViews); ++k) {
    // No view is to blame where the outlines lie right.
    if (views[k].first.overlap < std::max(kOutlinesOnly, asItIs.overlap + 0.02)) continue;
    const Hypothesis& view = *views[k].second.first;
    for (const Hypothesis& h : hypotheses()) {
      if (h.way.view || (h.meaning != Meaning::Wrong && h.meaning != Meaning::Allowed) || !applies(h))
        continue;
      Seen seen = seenBy(view);
      const Approach way = approachWith(view, &h);
      if (way.paint != PaintWay::Nearest) continue;
      OtherProgram program{model_, way};
      Score score;
      for (const std::size_t stride : {kFewPlaced, std::size_t{1}}) {  // few places tell most rows off
        for (std::size_t p = 0; p < places_.size(); p += stride)
          if (seen.face[p] >= 0) seen.shown[p] = predictedAt(program, places_[p], seen.face[p]);
        score = scoreOf(handed, seen, yours, stride);
        if (score.share < kPlacedFew) break;
      }
      if (score.share < kPlacedTwo) continue;
      Fit fit{.first = &view, .second = &h, .cost = 1.0 - score.share, .explained = score.share};
      fit.telling = score.counted, fit.informative = score.share, fit.faces = score.faces;
      pairs.emplace_back(score, fit);
    }
  }
  if (name(pairs, kPlacedTwo)) return true;
  // Whatever the shades are, outlines that fit a view alone tell it.
  std::erase_if(views, [&](auto& one) {
    one.second.cost = 1.0 - one.first.overlap;
    return !one.first.hasGround || one.first.overlap < std::max(kOutlinesTell, asItIs.overlap + 0.05) ||
           one.first.counted < kManyPlaces || one.first.counted > 0.95 * one.first.known;
  });
  std::vector<Fit> found;
  for (const auto& one : views)  // the best overlap first
    if (one.second.cost <= views.front().second.cost + kClass / 2 &&
        std::ranges::none_of(found, [&](const Fit& f) { return f.first->key == one.second.first->key; }))
      found.push_back(one.second);
  return take(found);
}

/// Of a picture of one colour, the views that put no face into it, or one all over it.
void Diagnoser::addWhatShowsNothing(const HandedIn& handed, Diagnosis& d) {
  std::set<std::string_view> keys;
  for (const Hypothesis& h : hypotheses()) {
    if (!h.way.view) continue;
    const Seen& seen = seenBy(h);
    const Read yours = read(handed, places_, false);
    const auto shows = [](int face) { return face >= 0; };
    bool isSame = std::ranges::none_of(seen.face, shows);
    if (std::ranges::all_of(seen.face, [](int face) { return face != kNothing; })) {
      isSame = true;
      for (std::size_t k = 0; k < places_.size() && isSame; ++k)
        isSame = !shows(seen.face[k]) || apart(yours, k, seen.shown[k]) <= tolerance();
    }
    if (isSame && keys.insert(h.key).second) d.found.push_back({.first = &h});
  }
}

/// A picture that is right inside faces may lie less than a pixel off, and only the edges of faces tell.
void Diagnoser::decideByEdges(const HandedIn& handed, Diagnosis& d) {
  constexpr int kFewElsewhere = 4;
  constexpr double kMost = 0.9, kAlmostAll = 0.98, kMoreThanHalf = 0.04;
  const Approach right = approachOf(d.found.front());
  const std::vector<int> exact = facesOf(right);
  OtherProgram rightly{model_, right};
  const Fit base = d.found.front();
  double best = kMost;
  for (const Hypothesis& h : hypotheses()) {
    if (!h.way.view || !h.way.view->isSmall()) continue;
    const Approach way = approachWith(h, base.first);
    const std::vector<int>& faces = facesOf(way);
    OtherProgram program{model_, way};
    int counted = 0, ours = 0, theirs = 0, neither = 0;
    for (int j = 1; j + 1 < settings_.height; ++j)
      for (int i = 1; i + 1 < settings_.width; ++i) {
        const int a = exact[indexOf(i, j)], b = faces[indexOf(i, j)];
        if ((a == b && isInside(exact, i, j)) || (a != kNothing && !rightly.canShow(a)) ||
            (b != kNothing && !program.canShow(b)))
          continue;
        const DiagnosedSample s{i, j, 0};
        const Read yours = read(handed, {&s, 1}, false);
        Predicted nothing;
        nothing.shows = false;
        const double fromRight = apart(yours, 0, a == kNothing ? nothing : predictedAt(rightly, s, a)),
                     fromOther = apart(yours, 0, b == kNothing ? nothing : predictedAt(program, s, b));
        neither += a == b && fromRight > tolerance();
        if ((fromRight <= tolerance()) == (fromOther <= tolerance())) continue;
        ++counted, (fromOther <= tolerance() ? ours : theirs) += 1;
      }
    const double share = counted > 0 ? static_cast<double>(ours) / counted : 0.0;
    // Half a pixel is allowed, and not far from a viewport that is too small.
    const double most = h.meaning == Meaning::Allowed ? best : std::max(kAlmostAll, best + kMoreThanHalf);
    // A picture that is farther off than this row differs at other edges, too.
    if (counted < 2 * kFewPlaces || share <= most || neither * kFewElsewhere > ours) continue;
    best = share;
    Fit fit{.first = &h, .explained = base.explained, .telling = counted, .informative = share};
    if (base.first->meaning == Meaning::Allowed) fit.second = base.first;
    d.found = {fit};
    d.verdict = h.meaning == Meaning::Allowed ? Marking::Allowed : Marking::Mistake;
  }
}

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
