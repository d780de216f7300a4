#include "x11/command/trace.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <nlohmann/json.hpp>
#include <ostream>
#include <system_error>

#include "depthsort/record/explain.h"
#include "depthsort/record/replay.h"
#include "x11/homework/run_file.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

/// Rounds to ten significant digits: grid positions and depths have no more.
double shown(double v) {
  std::array<char, 32> text;
  const char* const end = std::to_chars(text.begin(), text.end(), v, std::chars_format::scientific, 9).ptr;
  std::from_chars(text.begin(), end, v);
  return v;
}

Json json(const Range& range) { return {shown(range.low), shown(range.high)}; }

Json json(const CornerCounts& counts) {
  return {{"in_front", counts.inFront}, {"on", counts.on}, {"behind", counts.behind}};
}

Json json(const CommonArea& common) {
  return {{"common_area", shown(common.area)}, {"corners", common.corners},
          {"P_nearer", common.P.inFront},      {"equal", common.P.on},
          {"Q_nearer", common.P.behind},       {"zP_minus_zQ", json(common.aheadOfQ)},
          {"doubt", shown(common.doubt)}};
}

/// Writes a run event by event.
class Teller {
 public:
  Teller(const Options& options, const Picture& picture, const SortedScene& sorted, std::ostream& out)
      : options_{options},
        picture_{picture},
        sorted_{sorted},
        explainer_{picture.scene().mesh, picture.snapped(), sorted, !options.quick},
        replay_{picture.snapped(), sorted},
        out_{out} {}

  void tell() {
    line({{"event", "run"},
          {"scene", options_.scene},
          {"size", {picture_.settings().width, picture_.settings().height}},
          {"run", options_.quick ? "quick" : "textbook"},
          {"polygons", sorted_.list.size()},
          {"steps", replay_.steps()}});
    for (int step = 1; step <= replay_.steps(); ++step) {
      splits_ = replay_.splits();
      replay_.goTo(step);
      tell(*replay_.event());
    }
    summary();
  }

 private:
  void line(const Json& object) {
    // A name need not be UTF-8, but JSON can hold nothing else.
    out_ << object.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
    if (!out_) throw std::system_error{errno, std::generic_category(), "standard output"};
  }

  [[nodiscard]] RunPolygon polygon(int id) const {
    return id < 0 ? RunPolygon{} : RunPolygon{id, explainer_.name(id)};
  }
  [[nodiscard]] RunStep stepOf(const Event& e) const {
    return {.kind = e.kind, .P = polygon(e.P), .Q = polygon(e.Q), .step = replay_.step()};
  }
  [[nodiscard]] Json begun(const Event& e) const { return asJson(stepOf(e)); }
  void finish(Json object, const Event& e) {
    object["says"] = explainer_.sentence(e, splits_);
    line(object);
  }

  void tell(const Event& e) {
    switch (e.kind) {
      case Event::Kind::Take: {
        Json take = begun(e);
        take["numbers"] = {{"P_z", json(explainer_.zExtent(e.P))}};
        return finish(std::move(take), e);
      }
      case Event::Kind::Compare:
        return tests(e);
      case Event::Kind::Move:
        return finish(begun(e), e);
      case Event::Kind::Cycle:
        return cycle(e);
      case Event::Kind::Impossible:
      case Event::Kind::Vain: {
        Json noCut = begun(e);
        noCut["numbers"] = {{"P_from_plane_of_Q", json(explainer_.corners(e.P, e.Q))}};
        return finish(std::move(noCut), e);
      }
      case Event::Kind::Void: {
        Json contact = begun(e);
        contact["numbers"] = json(explainer_.commonArea(e.P, e.Q));
        return finish(std::move(contact), e);
      }
      case Event::Kind::Split: {
        const int behind = explainer_.fragments().pieceOf(splits_);
        RunStep step = stepOf(e);
        step.behind = polygon(behind), step.inFront = polygon(behind + 1);
        Json cut = asJson(step);
        cut["numbers"] = {{"P_from_plane_of_Q", json(explainer_.corners(e.P, e.Q))}};
        return finish(std::move(cut), e);
      }
      case Event::Kind::Paint: {
        Json paint = begun(e);
        paint["face"] = explainer_.fragments().face(e.P).number;
        paint["painted"] = replay_.painted();
        return finish(std::move(paint), e);
      }
    }
  }

  void tests(const Event& e) {
    const std::vector<Test> made = explainer_.testsMade(e);
    for (const Test test : made) {
      RunStep step = stepOf(e);
      step.test = test, step.outcome = "no";
      if (test == e.test) {
        step.outcome = test == Test::Overlap ? nameOf(e.verdict) : "yes";
        step.verdict = e.verdict;
      }
      Json object = asJson(step);
      Json numbers = numbersOf(e, test);
      if (test == made.front())
        numbers.update({{"P_z", json(explainer_.zExtent(e.P))}, {"Q_z", json(explainer_.zExtent(e.Q))}});
      object["numbers"] = std::move(numbers);
      object["says"] = explainer_.sentence(e, test);
      line(object);
    }
  }

  [[nodiscard]] Json numbersOf(const Event& e, Test test) const {
    switch (test) {
      case Test::XExtents:
        return {{"P_x", json(explainer_.xExtent(e.P))}, {"Q_x", json(explainer_.xExtent(e.Q))}};
      case Test::YExtents:
        return {{"P_y", json(explainer_.yExtent(e.P))}, {"Q_y", json(explainer_.yExtent(e.Q))}};
      case Test::PBehindQ:
      case Test::PInFrontOfQ:
        return {{"P_from_plane_of_Q", json(explainer_.corners(e.P, e.Q))}};
      case Test::QInFrontOfP:
      case Test::QBehindP:
        return {{"Q_from_plane_of_P", json(explainer_.corners(e.Q, e.P))}};
      case Test::Projections: {
        const auto edge = explainer_.separatingEdge(e.P, e.Q);
        if (!edge) return {{"separating_edge", nullptr}};
        return {{"separating_edge",
                 {{"of", edge->ofP ? "P" : "Q"},
                  {"from", {shown(edge->fromX), shown(edge->fromY)}},
                  {"to", {shown(edge->toX), shown(edge->toY)}}}}};
      }
      case Test::SamePlane:
        return {{"P_place", explainer_.fragments().faceIndex(e.P)},
                {"Q_place", explainer_.fragments().faceIndex(e.Q)}};
      case Test::Overlap: {
        Json numbers = json(explainer_.commonArea(e.P, e.Q));
        numbers["contact"] = e.contact;
        return numbers;
      }
    }
    return {};
  }

  /// The members of the cycle, from Q, which would come first, to P. Each must be painted after the next one.
  void cycle(const Event& e) {
    constexpr std::size_t kMostNamed = 100;
    std::vector<int> members = replay_.marked();
    members.erase(std::ranges::find(members, e.Q) + 1, members.end());
    std::ranges::reverse(members);
    Json object = begun(e);
    object["length"] = members.size();
    Json& names = object["members"] = Json::array();
    for (std::size_t k = 0; k < std::min(members.size(), kMostNamed); ++k)
      names.push_back(explainer_.name(members[k]));
    finish(std::move(object), e);
  }

  void summary() {
    const SortStatistics& s = sorted_.statistics;
    Json settled;
    for (const TestRow& row : kTestRows) settled[row.name] = s.settled[static_cast<int>(row.id)];
    line({{"event", "summary"},
          {"fragments", sorted_.fragments.size()},
          {"free", s.free},
          {"pairs", s.pairs()},
          {"settled_by", settled},
          {"moves", s.moves},
          {"cycles", s.cycles},
          {"impossible", s.impossible},
          {"vain", s.vain},
          {"cuts", s.splits},
          {"contacts", s.contacts + s.voids},
          {"most_marked", s.deepest}});
  }

  const Options& options_;
  const Picture& picture_;
  const SortedScene& sorted_;
  Explainer explainer_;
  Replay replay_;
  std::ostream& out_;
  int splits_ = 0;  ///< the number of splits before the current event
};

}  // namespace

SortedScene recordedRun(const Options& options, const Picture& picture) {
  SortSettings settings{picture.settings().width, picture.settings().height, !options.quick};
  settings.record = true;
  settings.mostPieces = picture.settings().mostPieces;
  try {
    return depthSort(picture.snapped(), settings);
  } catch (const TooManyEvents& e) {
    throw std::runtime_error{options.scene + ": " + e.what() +
                             (options.quick ? "" : "; --quick records fewer")};
  }
}

void printTrace(const Options& options, const Picture& picture, const SortedScene& sorted,
                std::ostream& out) {
  std::signal(SIGPIPE, SIG_DFL);  // the reader may stop reading early
  Teller{options, picture, sorted, out}.tell();
}

}  // namespace xnewell
