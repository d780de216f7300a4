#include "x11/homework/judge_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "depthsort/pair_tests.h"
#include "geometry/view/scene_planes.h"
#include "shading/diagnose/judge_order.h"
#include "shading/laboratory/errors.h"
#include "x11/drawing/wording.h"

namespace xnewell {

/// In this order: the tests, decided exactly; the steps, each checked when it comes; the end, with what was
/// never painted and what is independent of what; the page.

namespace {

constexpr double kRounded = 1.0;         ///< pixels that outlines may be off
constexpr double kOff = 1.5 * kRounded;  ///< pixels; a corner may be off in x and y
constexpr double kOnPlane = 1.0 / 1024;  ///< pixels; a corner so near to a plane may be on it
constexpr int kTimesRepeated = 3;        ///< a test that is made so often, while nothing changes, is a loop
constexpr std::size_t kMostFound = 10'000, kMostNamed = 6, kMostKnown = 1 << 16;

/// Which answers of a test are wrong. Rounding may allow both.
struct Truth {
  bool yesIsWrong = false, noIsWrong = false;
  double off = 0;  ///< pixels from what a yes, or a no, would need
  Place at = {};   ///< of tests of planes: the corner
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

using Figures = std::vector<std::vector<glm::dvec2>>;

class RunJudge {
 public:
  explicit RunJudge(const Picture& picture)
      : scene_{picture.snapped()},
        width_{picture.settings().width},
        height_{picture.settings().height},
        regions_{scene_},
        run_{picture, scene_, false},
        explainer_{picture.scene().mesh, scene_, run_.record.sorted(), true},
        visible_{visibleFaces(scene_, width_, height_)},
        shown_(visible_.size()),
        nearest_(visible_.size(), kNothing) {
    explainer_.call(Called::PAndQ);
  }

  void step(const RunStep& s) {
    ++report_.steps;
    line_ = s.line;
    const NamedRun::Step now = run_.step(s, [&](const NamedRun::Step& at) { check(s, at.P, at.Q); });
    if (s.kind == Event::Kind::Split) checkPieces(s, now);
  }

  RunReport report() {
    for (const auto& [pair, early] : early_) tellEarly(pair.first, pair.second, early);
    findLost();
    std::ranges::stable_sort(found_, {}, [](const FalseStep& f) { return std::pair{f.line == 0, f.line}; });
    report_.untested = static_cast<int>(untested_.size());
    chooseIndependent();
    return std::move(report_);
  }

 private:
  void check(const RunStep& s, int P, int Q) {
    const bool areKnown = isKnown(P) && (Q < 0 || isKnown(Q));
    if (areKnown && P == Q) tell({Falsehood::Itself, P, -1, "P and Q are both " + name(P)});
    const bool canBeChecked = areKnown && P != Q && s.kind;
    const auto kind = s.kind.value_or(Event::Kind::Take);
    if (kind == Event::Kind::Take && canBeChecked) take(P);
    if (kind == Event::Kind::Compare && canBeChecked) test(P, Q, *s.test, s.outcome);
    if (kind == Event::Kind::Move && canBeChecked) move(P, Q);
    if (kind == Event::Kind::Paint && canBeChecked) paint(P, s.cell);
    if (kind == Event::Kind::Split && canBeChecked) split(P, Q);
    if (kind == Event::Kind::Paint || kind == Event::Kind::Split) leave(P);
    if (kind == Event::Kind::Paint || kind == Event::Kind::Split || kind == Event::Kind::Void) goOn();
  }

  [[nodiscard]] const std::string& name(int polygon) const { return run_[polygon].name; }
  [[nodiscard]] std::string both(int P, int Q) const { return name(P) + " (P) and " + name(Q) + " (Q)"; }
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
    Truth found = truth(std::max(q0 - p1, p0 - q1) / double{kGrid});
    if (const int shared = std::min(p1, q1) - std::max(p0, q0); shared > 0)
      found.off = shared / double{kGrid};
    return found;
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
  /// The samples where a fragment hides another one, without the rows, and the two at the first of them.
  struct Nearer {
    Hidden at = {};
    int front = -1, behind = -1;
  };
  [[nodiscard]] Nearer nearer(int P, int Q) const {
    Nearer all;
    forEachPair(P, Q, [&](int p, int q) {
      const Hidden here = run_.record.hidden(p, q);
      if (all.at.samples == 0 && here.samples > 0) all = {{.i = here.i, .j = here.j}, p, q};
      all.at.samples += here.samples;
    });
    return all;
  }
  [[nodiscard]] static page::Object numbersOf(const Hidden& at) {
    return {{"samples", at.samples}, {"pixel", page::List{at.i, at.j}}};
  }
  /// The test that settles a pair of fragments, in words.
  [[nodiscard]] std::string settling(int p, int q) {
    const Relation r = run_.record.compare(p, q);
    std::string words = explainer_.sentence({.kind = Event::Kind::Compare,
                                             .test = r.test,
                                             .verdict = r.verdict,
                                             .contact = r.contact,
                                             .P = p,
                                             .Q = q},
                                            r.test);
    if (words.ends_with('.')) words.pop_back();
    return words;
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
  /// A run may make the same test again and again.
  [[nodiscard]] Truth truthOf(Test test, int P, int Q) {
    if (known_.size() > kMostKnown) known_.clear();
    const auto [at, isNew] = known_.try_emplace(keyOf(P, Q) * kTests + static_cast<unsigned>(test));
    return isNew ? at->second = decided(test, P, Q) : at->second;
  }
  [[nodiscard]] Truth decided(Test test, int P, int Q) {
    if (run_[P].parts.empty() || run_[Q].parts.empty()) return {};
    if (test == Test::XExtents) return apart(P, Q, &ScreenBox::x0, &ScreenBox::x1);
    if (test == Test::YExtents) return apart(P, Q, &ScreenBox::y0, &ScreenBox::y1);
    if (test == Test::Overlap) {
      if (mayGoFirst(P, Q)) return {.noIsWrong = !mayGoFirst(Q, P) && nearer(Q, P).at.samples > 0};
      const int samples = nearer(P, Q).at.samples;
      return {.yesIsWrong = samples > 0, .off = 1.0 * samples};
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
  };
  [[nodiscard]] static std::uint64_t keyOf(int P, int Q) {  // a file has less than 2^28 polygons
    return (static_cast<std::uint64_t>(P) << 28) | static_cast<unsigned>(Q);
  }
  [[nodiscard]] PairRecord& record(int P, int Q) { return pairs_[keyOf(P, Q)]; }
  [[nodiscard]] std::uint64_t keyOfFaces(int P, int Q) const {
    const auto [first, last] = std::minmax(run_[P].face, run_[Q].face);
    return keyOf(first, last);
  }
  /// True if a test was made of the two, or of other pieces of their faces.
  [[nodiscard]] bool areTested(int P, int Q) const { return testedFaces_.contains(keyOfFaces(P, Q)); }

  // The steps.

  /// True if there is no need for words: the same was told before, and is told again, or too much was.
  [[nodiscard]] bool wasTold(Falsehood kind, int P, int Q, std::optional<Test> test = {}) {
    if (found_.size() >= kMostFound) return true;
    const auto at = told_.find({kind, P, Q, test});
    if (at == told_.end()) return false;
    FalseStep again = found_[at->second];
    again.line = line_;
    found_.push_back(std::move(again));
    return true;
  }
  void tell(FalseStep step) {
    if (found_.size() >= kMostFound) return;
    told_.emplace(std::tuple{step.kind, step.P, step.Q, step.test}, found_.size());
    step.line = line_;
    step.nameP = name(step.P);
    if (step.Q >= 0) step.nameQ = name(step.Q);
    found_.push_back(std::move(step));
  }
  /// Tells it once of each polygon that there is none.
  [[nodiscard]] bool isKnown(int P) {
    NamedRun::Polygon& polygon = run_[P];
    if (polygon.state != NamedRun::Polygon::State::Unknown) return true;
    if (std::exchange(polygon.line, line_) == 0)
      tell({Falsehood::Unknown, P, -1,
            "there is no " + name(P) + ": the faces are 0 to " + std::to_string(run_.faces() - 1) +
                ", and no split before has made it"});
    return false;
  }
  [[nodiscard]] bool isThere(int P) {
    const NamedRun::Polygon& polygon = run_[P];
    if (polygon.state == NamedRun::Polygon::State::Waiting) return true;
    const bool painted = polygon.state == NamedRun::Polygon::State::Painted;
    tell({Falsehood::Gone, P, -1,
          name(P) + (painted ? " was painted in line " : " was split in line ") +
              std::to_string(polygon.line)});
    return false;
  }

  // What was taken, and what was moved since: each with its place in joins_.

  [[nodiscard]] int joined(int P) const { return P < std::ssize(joined_) ? joined_[P] : -1; }
  [[nodiscard]] bool isInChain(int P) const { return joined(P) >= chain_; }
  [[nodiscard]] bool isMoved(int P) const { return joined(P) >= moved_; }
  void join(int P) {
    joined_.resize(run_.polygons(), -1);
    joined_[P] = static_cast<int>(joins_.size());
    joins_.push_back(P);
  }
  void beginChain(int P) {
    chain_ = static_cast<int>(joins_.size());
    join(P);
    moved_ = static_cast<int>(joins_.size());
  }
  void leave(int P) {
    if (joined(P) >= 0) joined_[P] = -1;
  }
  /// What was moved may be moved again: the run comes nearer to its end.
  void goOn() {
    ++changes_;
    moved_ = static_cast<int>(joins_.size());
    lastTaken_ = -1;
  }
  void tellAgain(int P, int Q) {
    if (wasTold(Falsehood::Loop, P, Q)) return;
    tell({Falsehood::Loop, P, Q,
          both(P, Q) +
              " again, and nothing was moved, painted or split since: Q goes before P, or one is split"});
  }
  void tellRound(int P, int Q) {
    if (wasTold(Falsehood::Loop, P, Q)) return;
    std::string round;
    int named = 0;
    for (int k = static_cast<int>(joins_.size()); k-- > joined_[Q] && named < static_cast<int>(kMostNamed);)
      if (joined_[joins_[k]] == k) round = name(joins_[k]) + " after " + round, ++named;
    tell({Falsehood::Loop, P, Q,
          name(Q) + " goes before " + name(P) + " again, and nothing was painted or split since: " + round +
              name(Q) + ". Q has a mark, so one of them is split"});
  }

  void take(int P) {
    if (!isThere(P)) return;
    if (P == lastTaken_ && tested_.first == P) tellAgain(P, tested_.second);
    lastTaken_ = P;
    if (!isInChain(P)) beginChain(P);
  }

  void test(int P, int Q, Test test, std::string_view outcome) {
    PairRecord& pair = record(P, Q);
    pair.made |= 1U << static_cast<int>(test);
    testedFaces_.insert(keyOfFaces(P, Q));
    if (pair.since != changes_) pair.since = changes_, pair.times = {};
    const bool yes = outcome == "yes" || outcome == nameOf(Verdict::PFirst);
    if (!yes && ++pair.times[static_cast<int>(test)] == kTimesRepeated) tellAgain(P, Q);
    tested_ = {P, Q};
    Truth truth = truthOf(test, P, Q);
    if (outcome == nameOf(Verdict::QFirst)) truth.noIsWrong = truthOf(Test::Overlap, Q, P).yesIsWrong;
    if (!(yes ? truth.yesIsWrong : truth.noIsWrong) || wasTold(Falsehood::Answer, P, Q, test)) return;
    std::string says = testOf(test, P, Q) + " says " + std::string{outcome} + ": " + std::string{asks(test)} +
                       (yes ? " No" : " Yes");
    if (test == Test::Overlap)
      says += truth.off > 0 ? ": P is nearer at " + counted(static_cast<int>(truth.off), "sample") : "";
    else if (test == Test::XExtents || test == Test::YExtents || test == Test::Projections)
      says += (yes ? ": they overlap by " : ": they are apart by ") + pixels(truth.off);
    else
      says += (yes ? ": the corner at " : ": the nearest corner, at ") + placeText(truth.at) + ", is " +
              pixels(truth.off) + (yes ? " beyond the plane" : " away from the plane");
    tell({Falsehood::Answer, P, Q, std::move(says), numbersOf(truth.off), test});
  }
  [[nodiscard]] std::string testOf(Test test, int P, int Q) const {
    return "test " + std::string{kTestRows[static_cast<std::size_t>(test)].name} + " of " + both(P, Q);
  }
  [[nodiscard]] static std::string_view asks(Test test) {
    return test == Test::Overlap ? "is P nowhere nearer where they overlap?"
                                 : kTestRows[static_cast<std::size_t>(test)].asks;
  }
  [[nodiscard]] static std::string pixels(double off) { return significant(off, 4) + " pixels"; }
  [[nodiscard]] static std::string placeText(const Place& at) {
    return fixed(at.x, 1) + ',' + fixed(at.y, 1);
  }
  [[nodiscard]] static page::Object numbersOf(double off) {
    return off > 0 ? page::Object{{"pixels", off}} : page::Object{};
  }

  /// Tells of a test that was not made for a pair, and that says yes whatever rounding does. False if there
  /// is none.
  bool leftOut(int P, int Q, bool alsoExchanged) {
    if (testedFaces_.empty()) return false;  // a run that does not write its tests
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
      tell({Falsehood::LeftOut, P, Q,
            testOf(told, P, Q) + " is left out, and it would have told: " + std::string{asks(told)} + " Yes",
            numbersOf(truth.off), told});
      return true;
    }
    return false;
  }

  void move(int P, int Q) {
    if (!isThere(P) || !isThere(Q)) return;
    if (isMoved(Q)) {
      tellRound(P, Q);
      moved_ = static_cast<int>(joins_.size());
    } else if (truthOf(Test::Overlap, Q, P).yesIsWrong) {
      if (!wasTold(Falsehood::NotFirst, P, Q)) tellNotFirst(P, Q);
    } else {
      leftOut(P, Q, false);
    }
    if (!isInChain(P)) beginChain(P);
    join(Q);
    ++changes_;
    lastTaken_ = -1;
    tested_ = {-1, -1};
  }

  void tellNotFirst(int P, int Q) {
    const Nearer found = nearer(Q, P);
    tell({Falsehood::NotFirst, P, Q,
          name(Q) + " (Q) goes before " + name(P) + " (P), and is nearer at " + found.at.text() + ". " +
              settling(found.behind, found.front),
          numbersOf(found.at)});
  }

  void paint(int P, int cell) {
    if (!isThere(P)) return;
    const NamedRun::Polygon& polygon = run_[P];
    const std::vector<int>& parts = polygon.parts;
    if (cell >= 0 && (polygon.shade || (parts.size() == 1 && part(parts[0]).fragment.piece >= 0))) {
      const int is = polygon.shade ? static_cast<int>((*polygon.shade)[4])
                                   : cellOf_.emplace(polygon.face, cell).first->second;
      if (cell != is)
        tell({Falsehood::Shade, P, -1,
              name(P) + " is painted with cell " + std::to_string(cell) + ", and its face has cell " +
                  std::to_string(is) + ": a split copies the shading"});
    }
    for (const int p : parts)
      forEachSpan(scene_, run_.record.sorted(), part(p).fragment, width_, height_,
                  [&](int row, int from, int to) {
                    for (int i = from; i < to; ++i) paintSample(p, i, row);
                  });
  }
  void paintSample(int p, int i, int j) {
    const std::size_t at = static_cast<std::size_t>(j) * width_ + i;
    const int mine = part(p).fragment.face;
    if (visible_[at] == mine) shown_[at] = true;
    const int before = nearest_[at];
    if (before != kNothing && std::pair{before, p} != over_) {
      over_ = {before, p};
      const Extents &far = part(before).extents, &near = part(p).extents;
      if (far.zFar < near.zNear && near.zFar < far.zNear &&
          !areTested(run_.polygonOf(before), run_.polygonOf(p)))
        untested_.emplace(run_.polygonOf(before), run_.polygonOf(p));
    }
    if (before == kNothing ||
        xnewell::nearer(scene_.planes[face(before).plane], scene_.planes[face(p).plane], i, j) <= 0) {
      nearest_[at] = p;
      return;
    }
    if (checkOf(scene_, mine, part(before).fragment.face, i, j) != SampleCheck::Wrong) return;
    const std::pair pair{run_.polygonOf(before), run_.polygonOf(p)};
    if (early_.size() >= kMostFound && !early_.contains(pair)) return;
    Nearer& early = early_[pair];
    if (early.at.samples++ == 0) early = {{1, i, j, {}}, before, p};
  }
  void tellEarly(int P, int Q, const Nearer& early) {
    line_ = run_[P].line;
    tell({Falsehood::TooEarly, P, Q,
          name(P) + " (P) is painted before " + name(Q) + " (Q), and is nearer at " + early.at.text() + ". " +
              settling(early.front, early.behind) +
              (areTested(P, Q) || testedFaces_.empty() ? "" : ". The run never tests them"),
          numbersOf(early.at)});
  }

  /// True if the plane of a face made a side of the fragment.
  [[nodiscard]] bool wasCutBy(int id, int by) const {
    return std::ranges::any_of(part(id).region, [plane = face(by).plane](const Side& side) {
      return side.line.kind == Line::Kind::Cut && (side.line.p == plane || side.line.q == plane);
    });
  }
  void split(int P, int Q) {
    if (!isThere(P)) return;
    // The pair that led to it; in a cycle others may be split.
    const auto [p, q] = tested_;
    if (p >= 0 && std::minmax(P, Q) == std::minmax(p, q)) leftOut(p, q, !isInChain(q));
    bool crosses = run_[P].parts.empty() || run_[Q].parts.empty();
    bool wasCut = false;
    double beyond = 0;
    for (const int id : crosses ? std::vector<int>{} : run_[P].parts) {
      const int by = run_[Q].parts.front();
      const Truth isBehind = onSide(id, by, -1), isInFront = onSide(id, by, 1);
      const bool was = wasCutBy(id, by);
      wasCut |= was;
      crosses |= run_.record.crosses(id, by) || (!was && !isBehind.noIsWrong && !isInFront.noIsWrong);
      beyond = isBehind.noIsWrong ? isBehind.off : isInFront.off;
    }
    if (!crosses)
      tell({Falsehood::NoCut, P, Q,
            name(P) + " is split by the plane of " + name(Q) + ", which does not cross it: it " +
                (wasCut ? "has cut it before" : "is " + pixels(beyond) + " away"),
            numbersOf(beyond)});
  }
  void checkPieces(const RunStep& s, const NamedRun::Step& at) {
    if (run_[at.P].line == line_) {
      if (at.P != at.Q) checkOutlines(s, at);
      checkShade(at.P, s.P, false);
    }
    for (const int k : {0, 1}) {
      const int piece = at.pieces[k], before = at.before[k];
      if (before >= 0)
        tell({Falsehood::Number, at.P, before,
              "a piece of " + name(at.P) + " has the number of " + name(before) +
                  ": each polygon has its own"});
      checkShade(at.P, k == 0 ? s.behind : s.inFront, true);
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
      tell({Falsehood::Shade, P, -1,
            name(P) + " has " + std::string{kNames[k]} + ' ' + significant(was, 6) + ", and " +
                (isPiece ? "its piece " + std::to_string(now.id) + " has " : "now ") + significant(is, 6) +
                ": a split copies the shading"});
      return;
    }
  }
  /// The corner of outlines that is farthest from others, but for those that may be off.
  struct Off {
    double pixels = 0;
    Place at = {};
  };
  template <class MayBeOff>
  [[nodiscard]] static Off farthest(const Figures& from, const Figures& to, const MayBeOff& mayBeOff) {
    Off most;
    for (const auto& outline : from)
      for (const glm::dvec2& at : outline) {
        double off = 1e300;
        for (const auto& other : to)
          off = isInside(other, at) ? 0 : std::min(off, std::sqrt(distanceToBorder(other, at)));
        if (off > most.pixels && !mayBeOff(at)) most = {off, {at.x, at.y}};
      }
    return most;
  }
  [[nodiscard]] static const Off& larger(const Off& a, const Off& b) { return a.pixels < b.pixels ? b : a; }
  [[nodiscard]] Figures outlinesOf(int polygon) const {
    Figures all;
    for (const int id : run_[polygon].parts) all.push_back(cornersOf(part(id).region));
    return all;
  }
  /// Outside some programs clip, and others do not.
  [[nodiscard]] bool isInPicture(const glm::dvec2& at) const {
    return at.x >= 0 && at.y >= 0 && at.x <= width_ && at.y <= height_;
  }
  [[nodiscard]] bool hasOutline(const RunStep& s, int P) {
    const Figures told{s.P.outline}, right = outlinesOf(P);
    if (told[0].empty() || right.empty() || part(run_[P].parts[0]).fragment.piece >= 0) return true;
    const auto mayBeOff = [&](const glm::dvec2& at) { return !isInPicture(at); };
    const Off off = larger(farthest(told, right, mayBeOff), farthest(right, told, mayBeOff));
    ++outlinesTold_;
    if (off.pixels <= kOff) return true;
    ++outlinesOff_;
    tell({Falsehood::Figure,
          P,
          -1,
          name(P) + " has another outline in the scene: at " + placeText(off.at) + " it is " +
              pixels(off.pixels) + " off",
          numbersOf(off.pixels),
          {},
          std::vector{P},
          told});
    return false;
  }
  /// A piece that is told without an outline has no area: then P lies on one side of the plane, and the other
  /// piece is all of it.
  void checkOutlines(const RunStep& s, const NamedRun::Step& at) {
    if (!hasOutline(s, at.P)) return;
    const std::array<Figures, 2> told{Figures{s.behind.outline}, Figures{s.inFront.outline}},
        right{outlinesOf(at.pieces[0]), outlinesOf(at.pieces[1])};
    const std::array isTold{!told[0][0].empty(), !told[1][0].empty()};
    const Figures whole = outlinesOf(at.P);
    if (whole.empty() || run_[at.Q].parts.empty() || !(isTold[0] || isTold[1])) return;
    const SnappedFace &P = face(run_[at.P].parts[0]), &Q = face(run_[at.Q].parts[0]);
    // Where both planes may touch, the line of the cut is uncertain.
    const auto mayBeOff = [&](const glm::dvec2& place) {
      if (!isInPicture(place)) return true;
      const auto x = std::llrint(place.x * kGrid), y = std::llrint(place.y * kGrid);
      const bool isP = compareDepths(scene_.planes[P.plane], scene_.planes[Q.plane], x, y) > 0;
      return mayTouch(scene_, isP ? P : Q, isP ? Q : P, x, y);
    };
    Off off, exchanged;
    int empty = -1;
    for (const int k : {0, 1}) {
      const Figures &mine = right[k].empty() ? right[1 - k] : right[k], &theirs = isTold[k] ? told[k]
                                                                                  : right[1 - k].empty()
                                                                                      ? told[1 - k]
                                                                                      : right[1 - k];
      if (isTold[k]) off = larger(off, farthest(told[k], mine, mayBeOff));
      const Off missing = farthest(right[k], theirs, mayBeOff);
      if (!isTold[k] && missing.pixels > off.pixels) empty = k;
      off = larger(off, missing);
      exchanged = larger(exchanged, larger(farthest(told[k], right[1 - k], mayBeOff),
                                           farthest(right[1 - k], told[k], mayBeOff)));
    }
    double area = 0, around = 0;
    for (const auto& outline : whole) area += areaOf(outline);
    for (const Figures& piece : told)
      for (std::size_t k = 0; k < piece[0].size(); ++k)
        around += glm::length(piece[0][k] - piece[0][(k + 1) % piece[0].size()]);
    const double behind = areaOf(told[0][0]), inFront = areaOf(told[1][0]);
    // Wherever the cut is, the areas add up, unless the program clips.
    const bool addUp = std::abs(behind + inFront - area) <= kRounded * around / 2,
               isCounted =
                   isTold[0] && isTold[1] && whole.size() == 1 &&
                   std::ranges::all_of(whole[0], [&](const glm::dvec2&to) { return isInPicture(to); });
    if (off.pixels <= kOff && (addUp || !isCounted)) return;
    const Off beyond = farthest({told[0][0], told[1][0]}, whole,
                                [&](const glm::dvec2& place) { return !isInPicture(place); });
    FalseStep found{.kind = Falsehood::Cover,
                    .P = at.P,
                    .Q = at.Q,
                    .says = "the pieces do not cover " + name(at.P) + " once: ",
                    .numbers = numbersOf(off.pixels),
                    .right = {at.pieces[0], at.pieces[1]},
                    .told = {told[0][0], told[1][0]}};
    if (isTold[0] && isTold[1] && off.pixels > kOff && exchanged.pixels <= kOff) {
      found.kind = Falsehood::Sides;
      found.says = "the pieces of " + name(at.P) +
                   " are exchanged: what is called behind lies in front of the plane of " + name(at.Q);
    } else if (beyond.pixels > kOff) {
      found.says += "at " + placeText(beyond.at) + " one reaches " + pixels(beyond.pixels) + " beyond it";
    } else if (!addUp) {
      found.says += "their areas are " + significant(behind, 6) + " and " + significant(inFront, 6) +
                    ", its own is " + significant(area, 6) + " pixels";
    } else {
      found.kind = Falsehood::Plane;
      found.says = "the pieces of " + name(at.P) + " are not those of the plane of " + name(at.Q) + ": " +
                   (empty < 0 ? "at " + placeText(off.at) + " their outline is " + pixels(off.pixels) + " off"
                              : std::string{"the one "} + (empty == 0 ? "behind" : "in front") +
                                    " has no outline, and reaches " + pixels(off.pixels) + " from the plane");
    }
    tell(std::move(found));
  }

  // The end.

  void findLost() {
    line_ = 0;
    std::map<int, Nearer> lost;  // by face: what shows of it, and its place among the faces
    for (int j = 0; j < height_; ++j)
      for (int i = 0; i < width_; ++i) {
        const std::size_t at = static_cast<std::size_t>(j) * width_ + i;
        const int face = visible_[at];
        if (face == kNothing || shown_[at]) continue;
        if (nearest_[at] != kNothing &&
            checkOf(scene_, part(nearest_[at]).fragment.face, face, i, j) == SampleCheck::Doubtful)
          continue;
        Nearer& one = lost[scene_.faces[face].number];
        if (one.at.samples++ == 0) one = {{1, i, j, {}}, face};
      }
    std::map<int, std::vector<int>> left;  // by face
    for (int P = 0; P < run_.polygons(); ++P)
      if (run_[P].state == NamedRun::Polygon::State::Waiting) left[run_[P].face].push_back(P);
    for (const auto& [number, one] : lost) {
      std::vector<int>& waiting = left[number];
      std::ranges::stable_partition(waiting, [&](int P) {  // first the one that shows there
        return std::ranges::any_of(run_[P].parts, [&](int id) {
          return part(id).fragment.face == one.front && owns(part(id).region, one.at.i, one.at.j);
        });
      });
      if (waiting.empty()) waiting.push_back(run_.polygonOfFace(number)), report_.unnamed.push_back(number);
      tell({Falsehood::Lost,
            waiting[0],
            -1,
            name(waiting[0]) + " is never painted; it shows at " + one.at.text(),
            numbersOf(one.at),
            {},
            waiting});
    }
  }
  [[nodiscard]] bool owns(const Region& region, int i, int j) const {
    return std::ranges::all_of(region,
                               [&](const Side& side) { return signAtSample(scene_, side.line, i, j) > 0; });
  }

  /// Leaves out what may follow from a step before, and counts what is like one before.
  void chooseIndependent() {
    std::set<std::pair<int, int>> blamed;
    std::set<int> spoilt;
    std::map<std::pair<Falsehood, int>, std::size_t> like;
    bool loses = false, isOther = false;
    if (outlinesOff_ > 0 && outlinesOff_ == outlinesTold_) {
      const auto first = std::ranges::find(found_, Falsehood::Figure, &FalseStep::kind);
      first->says += (outlinesOff_ == 1 ? "" : ", and so are all others that the run tells") +
                     std::string{". Is it the same scene and camera, and does y go down?"};
      std::rotate(found_.begin(), first, first + 1);
      isOther = true;
    }
    for (FalseStep& step : found_) {
      const int p = run_[step.P].face, q = step.Q < 0 ? kNothing : run_[step.Q].face;
      const std::pair pair{std::min(p, q), std::max(p, q)};
      const bool ofPieces = step.kind == Falsehood::Shade;
      step.follows = (isOther && !report_.wrong.empty()) ||
                     (!ofPieces && (blamed.contains(pair) || spoilt.contains(p) || spoilt.contains(q) ||
                                    (loses && step.kind == Falsehood::Lost)));
      if (step.follows) {
        ++report_.follow;
        report_.others.push_back(std::move(step));
        continue;
      }
      if (!ofPieces) blamed.insert(pair);
      loses |= step.kind == Falsehood::Loop || step.kind == Falsehood::Unknown;
      if (step.kind >= Falsehood::NoCut && step.kind <= Falsehood::Number) spoilt.insert(p);
      if (step.kind == Falsehood::Number) spoilt.insert(q);
      const auto [at, isNew] =
          like.try_emplace({step.kind, step.test ? static_cast<int>(*step.test) : -1}, report_.wrong.size());
      if (isNew)
        report_.wrong.push_back(std::move(step));
      else
        ++report_.wrong[at->second].alike, report_.others.push_back(std::move(step));
    }
  }

  const SnappedScene& scene_;
  int width_, height_;
  Regions regions_;
  NamedRun run_;
  Explainer explainer_;
  std::vector<int> visible_;
  std::vector<bool> shown_;   ///< each sample: whether what is visible there was painted
  std::vector<int> nearest_;  ///< each sample: the nearest fragment that was painted
  std::unordered_map<std::uint64_t, PairRecord> pairs_;
  std::unordered_map<std::uint64_t, Truth> known_;
  std::unordered_set<std::uint64_t> testedFaces_;
  std::map<int, int> cellOf_;  ///< of faces: the cell of the first piece that was painted
  std::map<std::pair<int, int>, Nearer> early_;
  std::set<std::pair<int, int>> untested_;
  std::pair<int, int> over_{-1, -1};  ///< fragments: painted, and painted over it; the last that were seen
  std::vector<FalseStep> found_;
  std::map<std::tuple<Falsehood, int, int, std::optional<Test>>, std::size_t> told_;  ///< places in found_
  std::vector<int> joins_, joined_;
  int chain_ = 0, moved_ = 0;  ///< where they begin in joins_
  std::pair<int, int> tested_{-1, -1};
  int lastTaken_ = -1, changes_ = 0, line_ = 0, outlinesTold_ = 0, outlinesOff_ = 0;
  RunReport report_;
};

}  // namespace

RunReport judgeRun(const Picture& picture, const RunFile& run) {
  if (const std::string& scene = picture.scene().name; !run.isOf(scene))
    throw ParseError{run.name(), 1,
                     "a run of the scene " + inQuotes(run.scene()) + ", and this one is " + inQuotes(scene)};
  RunJudge judge{picture};
  int steps = 0;
  run.forEach([&](const RunStep& step) { judge.step(step), ++steps; });
  if (steps == 0) throw ParseError{run.name(), 0, "no line is a step of a run"};
  return judge.report();
}

std::string verdictOf(const RunReport& report) {
  if (report.wrong.empty())
    return "right: " + counted(report.steps, "step") + ", and none is false" +
           (report.untested == 0 ? ""
                                 : ", but " + counted(report.untested, "pair") +
                                       (report.untested == 1 ? " was" : " were") + " never tested");
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
                                    {"P", step.nameP},
                                    {"Q", step.Q < 0 ? page::Data{nullptr} : page::Data{step.nameQ}},
                                    {"says", step.says},
                                    {"numbers", step.numbers},
                                    {"alike", step.alike}});
  }
  section.fact("verdict", isRight ? "right" : "wrong");
  section.fact("steps", report.steps);
  section.fact("untested", report.untested);
  section.fact("wrong", std::move(wrong));
  section.fact("follow", report.follow,
               report.follow == 0 ? "" : counted(report.follow, "other") + " may follow from these");
  return page;
}

}  // namespace xnewell
