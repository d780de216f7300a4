#include "x11/homework/judgement_report.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "shading/diagnose/pair_scene.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using OrderJson = nlohmann::ordered_json;

/// "3, 5, 8 and 12 more"
std::string listOf(const std::vector<int>& numbers) {
  constexpr std::size_t kMostListed = 8;
  std::string all;
  for (std::size_t k = 0; k < std::min(kMostListed, numbers.size()); ++k)
    all += (k > 0 ? ", " : "") + std::to_string(numbers[k]);
  if (numbers.size() > kMostListed) all += " and " + std::to_string(numbers.size() - kMostListed) + " more";
  return all;
}

}  // namespace

std::string lessonOf(const WrongPair& pair, std::span<const PaintStep> steps) {
  const std::string A = stepName(steps[pair.shown]), B = stepName(steps[pair.hidden]);
  if (pair.needsCut && pair.cycle.size() > 3) {
    std::string way;
    for (const int face : pair.cycle) way += (way.empty() ? "" : " before ") + std::to_string(face);
    return "only a cut helps: faces must be painted " + way;
  }
  if (pair.needsCut)
    return "only a cut helps: " + A + " is nearer than " + B + " in one part, and farther in another";
  if (!pair.told) return "no test of the depth sort tells: rounding parts them";
  switch (*pair.told) {
    case Test::PBehindQ:
      return "test 3 tells: " + A + " is wholly on the far side of the plane of " + B;
    case Test::QInFrontOfP:
      return "test 4 tells: " + B + " is wholly on the near side of the plane of " + A;
    case Test::Overlap:
      return "none of tests 1 to 5 tells, but no cut is needed: where they overlap, " + A +
             " is nowhere nearer";
    default:
      return "test " + std::string{kTestRows[static_cast<std::size_t>(*pair.told)].name} + " tells";
  }
}

std::string verdictOf(const OrderReport& r, std::span<const PaintStep> steps) {
  if (r.isRight()) return "right: " + counted(r.steps, "step") + ", and every sample shows the nearest face";
  std::string words = "wrong:";
  auto add = [&, first = true](const std::string& more) mutable {
    words += (first ? " " : "; ") + more;
    first = false;
  };
  if (!r.missing.empty())
    add(counted(static_cast<std::int64_t>(r.missing.size()), "face") + " missing that should show (" +
        listOf(r.missing) + ")" +
        (r.unseen.empty() ? ""
                          : ", and " + std::to_string(r.unseen.size()) + " that nobody would see (" +
                                listOf(r.unseen) + ")"));
  if (!r.repeated.empty())
    add(counted(static_cast<std::int64_t>(r.repeated.size()), "face") + " repeated (" + listOf(r.repeated) +
        ")");
  for (std::size_t k = 0; k < std::min<std::size_t>(3, r.covers.size()); ++k) {
    const BadCover& bad = r.covers[k];
    add("the pieces of face " + std::to_string(bad.face) +
        (bad.times == 0 ? " leave out" : " cover more than once") + " pixel " + std::to_string(bad.i) + "," +
        std::to_string(bad.j));
  }
  for (std::size_t k = 0; k < std::min<std::size_t>(3, r.outside.size()); ++k) {
    const OutsidePiece& piece = r.outside[k];
    add(stepName(steps[piece.step]) + " (line " + std::to_string(steps[piece.step].line) + ") fills pixel " +
        std::to_string(piece.i) + "," + std::to_string(piece.j) + " outside of the face");
  }
  if (r.first)
    add(stepName(steps[r.first->shown]) + " (line " + std::to_string(steps[r.first->shown].line) +
        ") is painted over " + stepName(steps[r.first->hidden]) + " (line " +
        std::to_string(steps[r.first->hidden].line) + "), which is nearer");
  return words;
}

std::string kindOf(const OrderReport& r) {
  std::string kinds;
  const auto add = [&](bool there, const char* kind) {
    if (there) kinds += (kinds.empty() ? "" : " ") + std::string{kind};
  };
  add(!r.missing.empty(), "missing"), add(!r.repeated.empty(), "repeated"), add(!r.covers.empty(), "covers");
  add(!r.outside.empty(), "outside");
  add(r.first && !r.first->needsCut, "order"), add(r.first && r.first->needsCut, "needs-cut");
  return kinds;
}

void printJudgement(const OrderReport& r, std::span<const PaintStep> steps, std::ostream& out) {
  out << verdictOf(r, steps) << '\n';
  if (!r.first) return;
  out << "  it shows at pixel " << r.first->i << ',' << r.first->j << ", and at "
      << counted(r.first->samples, "sample") << " in all; " << counted(r.wrongSamples, "sample") << " of "
      << counted(r.wrongPairs, "pair") << " are wrong, and this pair is the first\n  "
      << lessonOf(*r.first, steps) << '\n';
}

void printJudgementAsJson(const OrderReport& r, std::span<const PaintStep> steps, std::ostream& out) {
  OrderJson covers = OrderJson::array();
  for (const BadCover& bad : r.covers)
    covers.push_back(
        {{"face", bad.face}, {"pixel", {bad.i, bad.j}}, {"times", bad.times}, {"samples", bad.samples}});
  OrderJson outside = OrderJson::array();
  for (const OutsidePiece& piece : r.outside)
    outside.push_back({{"face", steps[piece.step].face},
                       {"line", steps[piece.step].line},
                       {"pixel", {piece.i, piece.j}},
                       {"samples", piece.samples}});
  OrderJson json{{"verdict", r.isRight() ? "right" : "wrong"},
                 {"words", verdictOf(r, steps)},
                 {"steps", r.steps},
                 {"missing", r.missing},
                 {"unseen", r.unseen},
                 {"repeated", r.repeated},
                 {"covers", covers},
                 {"outside", outside},
                 {"wrong_samples", r.wrongSamples},
                 {"wrong_pairs", r.wrongPairs},
                 {"in_one_plane", r.inOnePlane}};
  if (const auto& pair = r.first) {
    json["first"] = {{"shown", steps[pair->shown].face},
                     {"shown_line", steps[pair->shown].line},
                     {"hidden", steps[pair->hidden].face},
                     {"hidden_line", steps[pair->hidden].line},
                     {"pixel", {pair->i, pair->j}},
                     {"samples", pair->samples},
                     {"test", nullptr},
                     {"needs_cut", pair->needsCut},
                     {"cycle", pair->cycle},
                     {"says", lessonOf(*pair, steps)}};
    if (pair->told && !pair->needsCut)
      json["first"]["test"] = kTestRows[static_cast<std::size_t>(*pair->told)].name;
  }
  out << json.dump() << '\n';
}

}  // namespace xnewell
