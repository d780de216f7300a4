#include "x11/command/commands.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <nlohmann/json.hpp>
#include <ostream>
#include <system_error>

#include "depthsort/record/explain.h"
#include "depthsort/record/replay.h"
#include "x11/homework/run_record.h"

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

  void tell(const Event& e) {
    if (e.kind == Event::Kind::Compare) return tests(e);
    RunStep step = stepOf(e);
    if (e.kind == Event::Kind::Split) {
      const int behind = explainer_.fragments().pieceOf(splits_);
      step.behind = polygon(behind), step.inFront = polygon(behind + 1);
    }
    Json object = asJson(step);
    switch (e.kind) {
      case Event::Kind::Take:
        object["numbers"] = {{"P_z", json(explainer_.zExtent(e.P))}};
        break;
      case Event::Kind::Cycle:
        addMembers(object, e);
        break;
      case Event::Kind::Impossible:
      case Event::Kind::Vain:
      case Event::Kind::Split:
        object["numbers"] = {{"P_from_plane_of_Q", json(explainer_.corners(e.P, e.Q))}};
        break;
      case Event::Kind::Void:
        object["numbers"] = json(explainer_.commonArea(e.P, e.Q));
        break;
      case Event::Kind::Paint:
        object["face"] = explainer_.fragments().face(e.P).number;
        object["painted"] = replay_.painted();
        break;
      default:
        break;
    }
    object["says"] = explainer_.sentence(e, splits_);
    line(object);
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
    if (const std::optional<PlaneTest> plane = planeTestOf(test))
      return plane->ofP ? Json{{"P_from_plane_of_Q", json(explainer_.corners(e.P, e.Q))}}
                        : Json{{"Q_from_plane_of_P", json(explainer_.corners(e.Q, e.P))}};
    switch (test) {
      case Test::XExtents:
        return {{"P_x", json(explainer_.xExtent(e.P))}, {"Q_x", json(explainer_.xExtent(e.Q))}};
      case Test::YExtents:
        return {{"P_y", json(explainer_.yExtent(e.P))}, {"Q_y", json(explainer_.yExtent(e.Q))}};
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
      default:
        return {};
    }
  }

  /// The members of the cycle, from Q, which would come first, to P. Each must be painted after the next one.
  void addMembers(Json& object, const Event& e) const {
    constexpr std::size_t kMostNamed = 100;
    std::vector<int> members = replay_.marked();
    members.erase(std::ranges::find(members, e.Q) + 1, members.end());
    std::ranges::reverse(members);
    object["length"] = members.size();
    Json& names = object["members"] = Json::array();
    for (std::size_t k = 0; k < std::min(members.size(), kMostNamed); ++k)
      names.push_back(explainer_.name(members[k]));
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
