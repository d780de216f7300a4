#include "x11/homework/judge_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "depthsort/pair_tests.h"
#include "depthsort/samples.h"
#include "geometry/view/scene_planes.h"
#include "shading/diagnose/judge_order.h"
#include "shading/laboratory/exactness.h"
#include "x11/drawing/wording.h"

namespace xnewell {

/// In this order: what a run speaks of; the tests, decided exactly; the steps, each checked when it comes;
/// the end, with what was never painted and what is independent of what; the words; the page.

namespace {

constexpr double kRounded = 1.0;         ///< pixels that outlines may be off
constexpr double kOnPlane = 1.0 / 1024;  ///< pixels; a corner so near to a plane may be on it
constexpr int kTimesRepeated = 3;        ///< a test that is made so often, while nothing changes, is a loop
constexpr std::size_t kMostFound = 10'000, kMostNamed = 6;

/// Which answers of a test are wrong. Rounding may allow both.
struct Truth {
  bool yesIsWrong = false, noIsWrong = false;
  double off = 0;  ///< pixels from what a yes, or a no, would need
  Place at = {};   ///< of tests of planes: the corner
};

/// What was found, before it is put into words.
struct Found {
  Falsehood kind;
  int line = 0;
  int P = -1, Q = -1;  ///< polygons
  std::optional<Test> test = {};
  std::string_view outcome = {};
  double off = 0;
  Place at = {};
  Hidden seen = {};  ///< where it shows; without the rows
  int fragmentP = -1, fragmentQ = -1;
  std::vector<int> round = {};  ///< polygons of a loop
  std::vector<int> right = {};  ///< polygons that would have been right
  std::vector<std::vector<glm::dvec2>> told = {};
  std::string more = {};
};

double areaOf(const std::vector<glm::dvec2>& outline) {
  double twice = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2 a = outline[k] - outline[0], b = outline[(k + 1) % outline.size()] - outline[0];
    twice += a.y * b.x - a.x * b.y;
  }
  return std::abs(twice) / 2;
}

std::vector<glm::dvec2> cornersOf(const Region& region) {
  std::vector<glm::dvec2> outline;
  for (const Side& side : region) outline.push_back(glm::dvec2{side.corner.x, side.corner.y} / double{kGrid});
  return outline;
}

class RunJudge {
 public:
  explicit RunJudge(const Picture& picture)
      : picture_{picture},
        scene_{picture.snapped()},
        width_{picture.settings().width},
        height_{picture.settings().height},
        regions_{scene_},
        run_{picture, scene_, false},
        visible_{visibleFaces(scene_, width_, height_)},
        shown_(visible_.size()),
        nearest_(visible_.size(), kNothing) {}

  void step(const RunStep& s) {
    ++report_.steps;
    line_ = s.line;
    const NamedRun::Step now = run_.step(s, [&](const NamedRun::Step& at) { check(s, at.P, at.Q); });
    if (s.kind == Event::Kind::Split) checkPieces(s, now);
  }

  RunReport report() {
    for (const auto& [pair, seen] : early_) {
      Found early = seen;
      early.P = pair.first, early.Q = pair.second, early.line = run_[pair.first].line;
      found_.push_back(std::move(early));
    }
    findLost();
    std::ranges::stable_sort(found_, {}, [](const Found& f) { return std::pair{f.line == 0, f.line}; });
    Explainer explainer{picture_.scene().mesh, scene_, run_.record.sorted(), true};
    explainer.call(Called::PAndQ);
    chooseIndependent(explainer);
    return std::move(report_);
  }

 private:
  void check(const RunStep& s, int P, int Q) {
    switch (*s.kind) {
      case Event::Kind::Take:
        return take(P);
      case Event::Kind::Compare:
        return test(P, Q, *s.test, s.outcome);
      case Event::Kind::Move:
        return move(P, Q);
      case Event::Kind::Paint:
        return paint(P, s.cell);
      case Event::Kind::Split:
        return split(P, Q);
      case Event::Kind::Void:
        return goOn();
      default:
        return;
    }
  }

  [[nodiscard]] const RunRecord::Part& part(int id) const { return run_.record[id]; }
  [[nodiscard]] const SnappedFace& face(int id) const { return run_.record.face(id); }
  template <class Use>
  void forEachPair(int P, int Q, const Use& use) const {
    for (const int p : run_[P].parts)
      for (const int q : run_[Q].parts) use(p, q);
  }

  // The tests.

  /// True if the two do not overlap along an axis, by how much.
  [[nodiscard]] Truth apart(int P, int Q, int ScreenBox::*low, int ScreenBox::*high) const {
    const auto reach = [&](int polygon) {
      std::pair range{std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
      for (const int id : run_[polygon].parts)
        range = {std::min(range.first, part(id).extents.box.*low),
                 std::max(range.second, part(id).extents.box.*high)};
      return range;
    };
    const auto [p0, p1] = reach(P);
    const auto [q0, q1] = reach(Q);
    return truth(std::max(q0 - p1, p0 - q1) / double{kGrid});
  }
  /// Of a gap in pixels, negative if there is none.
  [[nodiscard]] static Truth truth(double gap) { return {gap<-kRounded, gap> kRounded, std::abs(gap)}; }
  /// The widest gap between two fragments along one of their edges.
  [[nodiscard]] double gap(int p, int q) const {
    double widest = -1e300;
    for (const auto& [of, other] : {std::pair{p, q}, {q, p}})
      for (const Side& side : part(of).region) {
        double least = 1e300;
        for (const Side& at : part(other).region)
          least = std::min(least, -(side.line.a * at.corner.x + side.line.b * at.corner.y + side.line.c));
        widest = std::max(widest, least / std::hypot(side.line.a, side.line.b));
      }
    return widest / kGrid;
  }
  /// Is `of` wholly on one side of a plane? `allowed`: 1 in front, -1 behind.
  [[nodiscard]] Truth onSide(int of, int planeOf, int allowed) const {
    Truth found{.noIsWrong = true};
    double needed = 1e300;
    for (const CornerDistance& c : distancesFromPlane(scene_, part(of).region, face(of), face(planeOf))) {
      const bool mayBeOn = c.mayBeOn || std::abs(c.inFront) <= kOnPlane, beyond = c.sign == -allowed;
      if (beyond && !mayBeOn && (!found.yesIsWrong || std::abs(c.inFront) > found.off))
        found = {true, false, std::abs(c.inFront), c.at};
      if (beyond || mayBeOn) found.noIsWrong = false;
      if (found.noIsWrong && std::abs(c.inFront) < needed)
        needed = found.off = std::abs(c.inFront), found.at = c.at;
    }
    return found;
  }
  [[nodiscard]] int samplesNearer(int P, int Q, Found* first = nullptr) const {
    int samples = 0;
    forEachPair(P, Q, [&](int p, int q) {
      const Hidden here = run_.record.hidden(p, q);
      if (samples == 0 && here.samples > 0 && first)
        first->seen = {.i = here.i, .j = here.j}, first->fragmentP = q, first->fragmentQ = p;
      samples += here.samples;
    });
    if (first) first->seen.samples = samples;
    return samples;
  }
  /// True if P may be painted before Q, whatever rounding says.
  [[nodiscard]] bool mayGoFirst(int P, int Q) {
    bool may = true;
    forEachPair(P, Q, [&](int p, int q) {
      may = may && (regions_.samePlane(face(p).plane, face(q).plane) ||
                    run_.record.compare(p, q).verdict == Verdict::PFirst);
    });
    return may;
  }
  [[nodiscard]] Truth truthOf(Test test, int P, int Q) {
    if (run_[P].parts.empty() || run_[Q].parts.empty()) return {};
    if (test == Test::XExtents) return apart(P, Q, &ScreenBox::x0, &ScreenBox::x1);
    if (test == Test::YExtents) return apart(P, Q, &ScreenBox::y0, &ScreenBox::y1);
    if (test == Test::Overlap) {
      std::optional<Truth>& known = record(P, Q).overlap;
      if (known) return *known;
      Truth found;
      if (mayGoFirst(P, Q)) {
        found.noIsWrong = !mayGoFirst(Q, P) && samplesNearer(Q, P) > 0;
      } else {
        found.off = samplesNearer(P, Q);
        found.yesIsWrong = found.off > 0;
      }
      return *(known = found);
    }
    Truth all{.noIsWrong = true};
    forEachPair(P, Q, [&](int p, int q) {
      Truth one;
      if (const std::optional<PlaneTest> plane = planeTestOf(test)) {
        one = plane->ofP ? onSide(p, q, plane->side) : onSide(q, p, plane->side);
      } else if (test == Test::Projections) {
        one = truth(gap(p, q));
      } else {
        one = onSide(p, q, 1);  // in one plane if wholly on both sides of it
        if (!one.yesIsWrong) one = onSide(p, q, -1);
        one.noIsWrong = false;
      }
      const bool no = all.noIsWrong && one.noIsWrong;
      if (one.yesIsWrong || (no && !all.yesIsWrong)) all = one;
      all.noIsWrong = no && !all.yesIsWrong;
    });
    return all;
  }

  struct PairRecord {
    unsigned made = 0;  ///< bits of tests
    int since = -1;     ///< the changes when these were counted
    std::array<std::uint8_t, kTests> times{};
    std::optional<Truth> overlap;  ///< of test 6, which takes long
  };
  [[nodiscard]] PairRecord& record(int P, int Q) {
    return pairs_[(static_cast<std::uint64_t>(P) << 32) | static_cast<unsigned>(Q)];
  }

  // The steps.

  void tell(Found found) {
    found.line = line_;
    if (found_.size() < kMostFound) found_.push_back(std::move(found));
  }
  [[nodiscard]] bool isThere(int P) {
    const NamedRun::Polygon& polygon = run_[P];
    if (polygon.state == NamedRun::Polygon::State::Waiting) return true;
    const bool painted = polygon.state == NamedRun::Polygon::State::Painted;
    tell({.kind = Falsehood::Gone,
          .P = P,
          .more = (painted ? "was painted in line " : "was split in line ") + std::to_string(polygon.line)});
    return false;
  }
  /// What was moved may be moved again: the run comes nearer to its end.
  void goOn() {
    ++changes_;
    moved_.clear();
    lastTaken_ = -1;
  }
  void loop(int P, int Q, std::vector<int> round) {
    tell({.kind = Falsehood::Loop, .P = P, .Q = Q, .round = std::move(round)});
  }

  void take(int P) {
    if (!isThere(P)) return;
    if (P == lastTaken_ && tested_.first == P) loop(P, tested_.second, {});
    lastTaken_ = P;
    if (std::ranges::find(chain_, P) != chain_.end()) return;
    chain_ = {P};
    moved_.clear();
  }

  void test(int P, int Q, Test test, std::string_view outcome) {
    PairRecord& pair = record(P, Q);
    pair.made |= 1U << static_cast<int>(test);
    ++tests_made_;
    if (pair.since != changes_) pair.since = changes_, pair.times = {};
    if (++pair.times[static_cast<int>(test)] == kTimesRepeated) loop(P, Q, {});
    tested_ = {P, Q};
    const bool yes = outcome == "yes" || outcome == nameOf(Verdict::PFirst);
    Truth truth = truthOf(test, P, Q);
    if (outcome == nameOf(Verdict::QFirst)) truth.noIsWrong = truthOf(Test::Overlap, Q, P).yesIsWrong;
    if (!(yes ? truth.yesIsWrong : truth.noIsWrong)) return;
    tell({.kind = Falsehood::Answer,
          .P = P,
          .Q = Q,
          .test = test,
          .outcome = outcome,
          .off = truth.off,
          .at = truth.at});
  }

  /// Tells of a test that was not made for a pair, and that says yes whatever rounding does. False if there
  /// is none.
  bool leftOut(int P, int Q, bool alsoExchanged) {
    if (tests_made_ == 0) return false;  // a run that does not write its tests
    using enum Test;
    const unsigned made = record(P, Q).made;
    for (const Test test : {Projections, PBehindQ, QInFrontOfP, QBehindP, PInFrontOfQ}) {
      const bool exchanged = test == QBehindP || test == PInFrontOfQ;
      if (exchanged && !alsoExchanged) break;
      const Truth truth = truthOf(test, P, Q);
      if (!truth.noIsWrong) continue;
      if ((made & (1U << static_cast<int>(test))) != 0) return false;  // with a wrong answer
      Test told = test;
      for (const Test cheap : {YExtents, XExtents})
        if (test == Projections && (made & (1U << static_cast<int>(cheap))) == 0 &&
            truthOf(cheap, P, Q).noIsWrong)
          told = cheap;
      tell({.kind = Falsehood::LeftOut, .P = P, .Q = Q, .test = told, .off = truth.off});
      return true;
    }
    return false;
  }

  void move(int P, int Q) {
    if (!isThere(P) || !isThere(Q)) return;
    if (moved_.contains(Q)) {
      const auto from = std::ranges::find(chain_, Q);
      loop(P, Q, {from, chain_.end()});
      moved_.clear();
    } else if (Found found{.kind = Falsehood::NotFirst, .P = P, .Q = Q};
               !mayGoFirst(Q, P) && samplesNearer(Q, P, &found) > 0) {
      tell(std::move(found));
    } else {
      leftOut(P, Q, false);
    }
    if (std::ranges::find(chain_, P) == chain_.end()) chain_ = {P};
    chain_.push_back(Q);
    moved_.insert(Q);
    ++changes_;
    lastTaken_ = -1;
    tested_ = {-1, -1};
  }

  void paint(int P, int cell) {
    if (!isThere(P)) return;
    const NamedRun::Polygon& polygon = run_[P];
    const std::vector<int>& parts = polygon.parts;
    if (cell >= 0 && (polygon.shade || (parts.size() == 1 && part(parts[0]).fragment.piece >= 0))) {
      const int is = polygon.shade ? static_cast<int>((*polygon.shade)[4])
                                   : cellOf_.emplace(polygon.face, cell).first->second;
      if (cell != is)
        tell({.kind = Falsehood::Shade,
              .P = P,
              .more = "is painted with cell " + std::to_string(cell) + ", and its face has cell " +
                      std::to_string(is) + ": a split copies the shading"});
    }
    for (const int p : parts)
      forEachSpan(scene_, run_.record.sorted(), part(p).fragment, width_, height_,
                  [&](int row, int from, int to) {
                    for (int i = from; i < to; ++i) paintSample(p, i, row);
                  });
    std::erase(chain_, P);
    goOn();
  }
  void paintSample(int p, int i, int j) {
    const std::size_t at = static_cast<std::size_t>(j) * width_ + i;
    const int mine = part(p).fragment.face;
    if (visible_[at] == mine) shown_[at] = true;
    const int before = nearest_[at];
    if (before == kNothing ||
        nearer(scene_.planes[face(before).plane], scene_.planes[face(p).plane], i, j) <= 0) {
      nearest_[at] = p;
      return;
    }
    if (checkOf(scene_, mine, part(before).fragment.face, i, j) != SampleCheck::Wrong) return;
    const std::pair pair{run_.polygonOf(before), run_.polygonOf(p)};
    if (early_.size() >= kMostFound && !early_.contains(pair)) return;
    Found& early = early_[pair];
    if (early.seen.samples++ == 0)
      early = {
          .kind = Falsehood::TooEarly, .line = 0, .seen = {1, i, j, {}}, .fragmentP = before, .fragmentQ = p};
  }

  void split(int P, int Q) {
    if (!isThere(P)) return;
    // The pair that led to it; in a cycle others may be split.
    const auto [p, q] = tested_;
    if (p >= 0 && std::pair{std::min(P, Q), std::max(P, Q)} == std::pair{std::min(p, q), std::max(p, q)})
      leftOut(p, q, std::ranges::find(chain_, q) == chain_.end());
    bool crosses = run_[P].parts.empty() || run_[Q].parts.empty();
    double beyond = 0;
    for (const int id : crosses ? std::vector<int>{} : run_[P].parts) {
      const int by = run_[Q].parts.front();
      const Truth isBehind = onSide(id, by, -1), isInFront = onSide(id, by, 1);
      crosses |= run_.record.crosses(id, by) || (!isBehind.noIsWrong && !isInFront.noIsWrong);
      beyond = isBehind.noIsWrong ? isBehind.off : isInFront.off;
    }
    if (!crosses) tell({.kind = Falsehood::NoCut, .P = P, .Q = Q, .off = beyond});
    std::erase(chain_, P);
    goOn();
  }
  void checkPieces(const RunStep& s, const NamedRun::Step& at) {
    if (run_[at.P].line == line_) {
      checkOutlines(s, at);
      checkShade(at.P, s.P, false);
    }
    for (const auto& [piece, told] : {std::pair{at.behind, &s.behind}, {at.inFront, &s.inFront}}) {
      checkShade(at.P, *told, true);
      run_[piece].shade = run_[at.P].shade;
    }
  }
  /// The shading of P, as it was told first, and that of P or of a piece now.
  void checkShade(int P, const RunPolygon& now, bool isPiece) {
    NamedRun::Polygon& polygon = run_[P];
    if (!polygon.shade) polygon.shade = now.shade;
    if (!polygon.shade || !now.shade) return;
    constexpr std::array kNames{"normal x", "normal y", "normal z", "N.L", "cell"};
    for (std::size_t k = 0; k < kNames.size(); ++k) {
      const double is = (*now.shade)[k], was = (*polygon.shade)[k];
      if (std::abs(is - was) <= 1e-6 * std::max(1.0, std::abs(was))) continue;
      tell({.kind = Falsehood::Shade,
            .P = P,
            .more = "has " + std::string{kNames[k]} + ' ' + significant(was, 6) + ", and " +
                    (isPiece ? "its piece " + std::to_string(now.id) : "now") + ' ' + significant(is, 6) +
                    ": a split copies the shading"});
      return;
    }
  }
  /// The farthest place that one outline has and a piece has not, or the other way round. Places where both
  /// planes may touch do not count: there the line of the cut is uncertain.
  [[nodiscard]] double difference(const std::vector<glm::dvec2>& told, int piece, int by,
                                  Place& where) const {
    const std::vector<glm::dvec2> right = cornersOf(part(piece).region);
    double most = 0;
    const auto compare = [&](const std::vector<glm::dvec2>& from, const std::vector<glm::dvec2>& to) {
      for (const glm::dvec2& at : from) {
        const double off = isInside(to, at) ? 0 : std::sqrt(distanceToBorder(to, at));
        if (off <= most) continue;
        const auto x = std::llrint(std::clamp(at.x, -8e3, 1.6e4) * kGrid),
                   y = std::llrint(std::clamp(at.y, -8e3, 1.6e4) * kGrid);
        const int sign = compareDepths(scene_.planes[face(piece).plane], scene_.planes[face(by).plane], x, y);
        if (mayTouch(scene_, face(sign > 0 ? piece : by), face(sign > 0 ? by : piece), x, y)) continue;
        most = off, where = {at.x, at.y};
      }
    };
    compare(told, right);
    compare(right, told);
    return most;
  }
  void checkOutlines(const RunStep& s, const NamedRun::Step& at) {
    const std::vector<int>&whole = run_[at.P].parts, &behinds = run_[at.behind].parts,
          &fronts = run_[at.inFront].parts;
    if (whole.size() != 1 || behinds.size() != 1 || fronts.size() != 1 || s.behind.outline.empty() ||
        s.inFront.outline.empty())
      return;
    const int by = run_[at.Q].parts.front(), behind = behinds[0], inFront = fronts[0];
    constexpr double kOff = 1.5 * kRounded;
    const std::array told{s.behind.outline, s.inFront.outline};
    const double sum = areaOf(told[0]) + areaOf(told[1]);
    Place where, elsewhere;
    const double off = difference(told[0], behind, by, where),
                 other = difference(told[1], inFront, by, elsewhere);
    if (off <= kOff && other <= kOff) return;
    Found found{.kind = Falsehood::Plane,
                .P = at.P,
                .Q = at.Q,
                .off = std::max(off, other),
                .at = off >= other ? where : elsewhere,
                .right = {at.behind, at.inFront},
                .told = {told[0], told[1]}};
    Place ignored;
    const double all = areaOf(cornersOf(part(whole[0]).region));
    double around = 0;
    for (const auto& outline : told)
      for (std::size_t k = 0; k < outline.size(); ++k)
        around += glm::length(outline[k] - outline[(k + 1) % outline.size()]);
    if (difference(told[0], inFront, by, ignored) <= kOff &&
        difference(told[1], behind, by, ignored) <= kOff) {
      found.kind = Falsehood::Sides;
    } else if (std::abs(sum - all) > kRounded * around / 2) {
      found.kind = Falsehood::Cover;
      found.more = "their areas are " + significant(areaOf(told[0]), 6) + " and " +
                   significant(areaOf(told[1]), 6) + ", its own is " + significant(all, 6) + " pixels";
    }
    tell(std::move(found));
  }

  // The end.

  void findLost() {
    line_ = 0;
    std::map<int, Found> lost;  // by face
    for (int j = 0; j < height_; ++j)
      for (int i = 0; i < width_; ++i) {
        const std::size_t at = static_cast<std::size_t>(j) * width_ + i;
        const int face = visible_[at];
        if (face == kNothing || shown_[at]) continue;
        if (nearest_[at] != kNothing &&
            checkOf(scene_, part(nearest_[at]).fragment.face, face, i, j) == SampleCheck::Doubtful)
          continue;
        Found& one = lost[scene_.faces[face].number];
        if (one.seen.samples++ == 0)
          one = {.kind = Falsehood::Lost, .line = 0, .seen = {1, i, j, {}}, .fragmentP = face};
      }
    for (auto& [number, one] : lost) {
      for (int id = 0; id < run_.record.parts() && one.P < 0; ++id)
        if (const int P = run_.polygonOf(id); P >= 0 && part(id).fragment.face == one.fragmentP &&
                                              run_[P].state == NamedRun::Polygon::State::Waiting &&
                                              owns(part(id).region, one.seen.i, one.seen.j))
          one.P = P;
      if (one.P < 0) one.P = run_.add({"face " + std::to_string(number), number});
      one.right = {one.P};
      tell(one);
    }
  }
  [[nodiscard]] bool owns(const Region& region, int i, int j) const {
    return std::ranges::all_of(region,
                               [&](const Side& side) { return signAtSample(scene_, side.line, i, j) > 0; });
  }

  /// Leaves out what may follow from a step before, and counts what is like one before.
  void chooseIndependent(const Explainer& explainer) {
    std::set<std::pair<int, int>> blamed;
    std::set<int> spoilt;
    std::map<std::pair<Falsehood, int>, std::size_t> like;
    bool looped = false;
    for (const Found& f : found_) {
      const int p = run_[f.P].face, q = f.Q < 0 ? -1 : run_[f.Q].face;
      const std::pair pair{std::min(p, q), std::max(p, q)};
      const bool ofPieces = f.kind == Falsehood::Shade;
      const bool follows = !ofPieces && (blamed.contains(pair) || spoilt.contains(p) || spoilt.contains(q) ||
                                         (looped && f.kind == Falsehood::Lost));
      FalseStep step = inWords(f, explainer);
      if (follows) {
        ++report_.follow;
        step.follows = true;
        report_.others.push_back(std::move(step));
        continue;
      }
      if (!ofPieces) blamed.insert(pair);
      looped |= f.kind == Falsehood::Loop;
      if (f.kind >= Falsehood::NoCut && f.kind <= Falsehood::Cover) spoilt.insert(p);
      const auto [at, isNew] =
          like.try_emplace({f.kind, f.test ? static_cast<int>(*f.test) : -1}, report_.wrong.size());
      if (isNew)
        report_.wrong.push_back(std::move(step));
      else
        ++report_.wrong[at->second].alike, report_.others.push_back(std::move(step));
    }
  }

  // The words.

  /// The test that settles a pair of fragments, in words.
  [[nodiscard]] std::string settling(const Found& f, const Explainer& explainer) {
    const Relation r = run_.record.compare(f.fragmentP, f.fragmentQ);
    return explainer.sentence({.kind = Event::Kind::Compare,
                               .test = r.test,
                               .verdict = r.verdict,
                               .contact = r.contact,
                               .P = f.fragmentP,
                               .Q = f.fragmentQ},
                              r.test);
  }
  [[nodiscard]] FalseStep inWords(const Found& f, const Explainer& explainer) {
    const std::string P = run_[f.P].name, Q = f.Q < 0 ? "" : run_[f.Q].name;
    FalseStep step{.kind = f.kind,
                   .line = f.line,
                   .P = P,
                   .Q = Q,
                   .test = f.test,
                   .polygonQ = f.Q,
                   .right = f.right,
                   .told = f.told};
    std::string& says = step.says;
    const std::string shows = f.seen.inWords();
    if (f.seen.samples > 0)
      step.numbers = {{"samples", f.seen.samples}, {"pixel", page::List{f.seen.i, f.seen.j}}};
    else if (f.off > 0)
      step.numbers = {{"pixels", f.off}};
    const std::string off = significant(f.off, 4) + " pixels";
    const std::string named = P + " (P) and " + Q + " (Q)";
    const TestRow& row = kTestRows[static_cast<std::size_t>(f.test.value_or(Test::SamePlane))];
    const std::string test = "test " + std::string{row.name} + " of " + named,
                      asks = row.id == Test::Overlap ? "is P nowhere nearer where they overlap?"
                                                     : std::string{row.asks};
    switch (f.kind) {
      case Falsehood::Answer: {
        const bool yes = f.outcome == "yes" || f.outcome == nameOf(Verdict::PFirst);
        says = test + " says " + std::string{f.outcome} + ": " + asks + (yes ? " No" : " Yes");
        if (*f.test == Test::Overlap)
          says += f.off > 0 ? ": P is nearer at " + counted(static_cast<int>(f.off), "sample") : "";
        else if (*f.test == Test::XExtents || *f.test == Test::YExtents || *f.test == Test::Projections)
          says += (yes ? ": they overlap by " : ": they are apart by ") + off;
        else
          says += (yes ? ": the corner at " : ": the nearest corner, at ") + fixed(f.at.x, 1) + ',' +
                  fixed(f.at.y, 1) + " is " + off + (yes ? " beyond the plane" : " away from the plane");
        break;
      }
      case Falsehood::LeftOut:
        says = test + " is left out, and it would have told: " + asks + " Yes";
        break;
      case Falsehood::NotFirst:
        says =
            Q + " (Q) goes before " + P + " (P), and is nearer at " + shows + ". " + settling(f, explainer);
        break;
      case Falsehood::TooEarly: {
        const bool tested = record(f.P, f.Q).made != 0 || record(f.Q, f.P).made != 0;
        says = P + " (P) is painted before " + Q + " (Q), and is nearer at " + shows + ". " +
               settling(f, explainer) + (tested || tests_made_ == 0 ? "" : " The run never tests them");
        break;
      }
      case Falsehood::Loop:
        if (f.round.empty()) {
          says = named +
                 " again, and nothing was moved, painted or split since: Q goes before P, or one is split";
        } else {
          says = Q + " goes before " + P + " again, and nothing was painted or split since: ";
          const std::size_t first = f.round.size() > kMostNamed ? f.round.size() - kMostNamed : 0;
          for (std::size_t k = first; k < f.round.size(); ++k) says += run_[f.round[k]].name + " after ";
          says += Q + ". Q has a mark, so one of them is split";
        }
        break;
      case Falsehood::NoCut:
        says = P + " is split by the plane of " + Q + ", which does not cross it: it is " + off + " away";
        break;
      case Falsehood::Sides:
        says =
            "the pieces of " + P + " are exchanged: what is called behind lies in front of the plane of " + Q;
        break;
      case Falsehood::Plane:
        says = "the pieces of " + P + " are not those of the plane of " + Q + ": at " + fixed(f.at.x, 1) +
               ',' + fixed(f.at.y, 1) + " their outline is " + off + " off";
        break;
      case Falsehood::Cover:
        says = "the pieces do not cover " + P + " once: " + f.more;
        break;
      case Falsehood::Shade:
      case Falsehood::Gone:
        says = P + ' ' + f.more;
        break;
      case Falsehood::Lost:
        says = P + " is never painted; it shows at " + shows;
        break;
    }
    if (says.ends_with('.')) says.pop_back();
    return step;
  }

  const Picture& picture_;
  const SnappedScene& scene_;
  int width_, height_;
  Regions regions_;
  NamedRun run_;
  std::vector<int> visible_;
  std::vector<bool> shown_;   ///< each sample: whether what is visible there was painted
  std::vector<int> nearest_;  ///< each sample: the nearest fragment that was painted
  std::unordered_map<std::uint64_t, PairRecord> pairs_;
  std::map<int, int> cellOf_;  ///< of faces: the cell of the first piece that was painted
  std::map<std::pair<int, int>, Found> early_;
  std::vector<Found> found_;
  std::vector<int> chain_;  ///< what was taken, and what was moved since
  std::set<int> moved_;
  std::pair<int, int> tested_{-1, -1};
  int lastTaken_ = -1, changes_ = 0, line_ = 0, tests_made_ = 0;
  RunReport report_;
};

}  // namespace

RunReport judgeRun(const Picture& picture, const RunFile& run) {
  RunJudge judge{picture};
  int steps = 0;
  run.forEach([&](const RunStep& step) { judge.step(step), ++steps; });
  if (steps == 0) throw ParseError{run.name(), 0, "no line is a step of a run"};
  return judge.report();
}

std::string verdictOf(const RunReport& report) {
  if (report.wrong.empty()) return "right: " + counted(report.steps, "step") + ", and none is false";
  const FalseStep& first = report.wrong.front();
  return "wrong: " + (first.line > 0 ? "line " + std::to_string(first.line) : "at the end") + ": " +
         first.says;
}

page::Page pageOf(const RunReport& report) {
  const bool isRight = report.wrong.empty();
  page::Page page;
  page.of = isRight ? verdictOf(report)
                    : "wrong: " + counted(report.steps, "step") + ", and this is the first false one";
  page::Section& section = page.sections.emplace_back();
  page::List wrong;
  for (const FalseStep& step : report.wrong) {
    const std::string more =
        step.alike == 0 ? "" : " (and " + std::to_string(step.alike) + " more of this kind)";
    section.add(
        page::Finding{.bold = step.line > 0 ? "line " + std::to_string(step.line) + ":" : "at the end:",
                      .why = step.says + more,
                      .alarm = true});
    wrong.emplace_back(page::Object{{"kind", nameOf(step.kind)},
                                    {"line", step.line},
                                    {"P", step.P},
                                    {"Q", step.Q.empty() ? page::Data{nullptr} : page::Data{step.Q}},
                                    {"says", step.says},
                                    {"numbers", step.numbers},
                                    {"alike", step.alike}});
  }
  section.fact("verdict", isRight ? "right" : "wrong");
  section.fact("steps", report.steps);
  section.fact("wrong", std::move(wrong));
  section.fact("follow", report.follow,
               report.follow == 0 ? "" : counted(report.follow, "other") + " may follow from these");
  return page;
}

}  // namespace xnewell
