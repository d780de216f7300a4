#include <algorithm>
#include <map>

#include "shading/scene/settings.h"
#include "x11/drawing/wording.h"
#include "x11/sides/sides.h"
#include "x11/window/caption.h"

namespace xnewell {

/// The words about two pictures beside each other: how they were made, and what was found.

namespace {

bool differs(const Setting& setting, const PictureSettings& A, const PictureSettings& B) {
  return setting.field.get(A) != setting.field.get(B);
}

/// "where body and spout meet", if most of the differing samples in the frame show faces of these two groups;
/// "" if groups have no names.
std::string meetingOf(const Picture& A, const Picture& B, const Difference& unlike, const Rect& frame) {
  const Mesh& mesh = A.scene().mesh;
  std::map<std::string, int> groups;
  const SeenRows a = A.seen(frame.y, frame.y + frame.height), b = B.seen(frame.y, frame.y + frame.height);
  const auto count = [&](const Picture& picture, int face) {
    if (face >= 0) ++groups[mesh.groupNames[mesh.group[picture.snapped().faces[face].number]]];
  };
  for (int j = 0; j < frame.height; ++j)
    for (int i = frame.x; i < frame.x + frame.width; ++i) {
      if (!(unlike.at[std::size_t(frame.y + j) * unlike.width + i] > rowOf(unlike.kind).unit)) continue;
      count(A, a.faces[std::size_t(j) * unlike.width + i]);
      count(B, b.faces[std::size_t(j) * unlike.width + i]);
    }
  groups.erase("");
  std::vector<std::pair<int, std::string>> most;
  for (const auto& [name, n] : groups) most.emplace_back(n, name);
  std::ranges::sort(most, std::greater{});
  if (most.empty()) return "";
  if (most.size() == 1) return "within \"" + most[0].second + '"';
  return "where " + most[0].second + " and " + most[1].second + " meet";
}

std::string shareOf(std::int64_t part, std::int64_t all) {
  return fixed(all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all), 2) + " %";
}

std::string whyOf(Order order, std::string_view other, std::int64_t cuts) {
  std::string why =
      rowOf(order).bits > 0 ? "Where two depths round to one level of the buffer, the later face shows"
      : order == Order::Unsorted
          ? "The scene's own order ignores depth"
          : "One z for each face cannot order faces that overlap in z or pass through each other";
  if (cuts > 0) why += "; " + std::string{other} + " cuts " + (cuts == 1 ? "once" : counted(cuts, "time"));
  return why + ".";
}

}  // namespace

std::vector<Phrase> phrasesOf(const PictureSettings& mine, const PictureSettings& other) {
  std::vector<Phrase> phrases;
  for (const Setting& setting : settingRows())
    if (differs(setting, mine, other)) phrases.push_back({phraseOf(setting, mine), true});
  for (const Setting& setting : settingRows())
    if (setting.alwaysSaid && !differs(setting, mine, other) && hasEffect(setting, factsOf(mine)))
      phrases.push_back({phraseOf(setting, mine), false});
  return phrases;
}

std::vector<std::string> differencesOf(const PictureSettings& A, const PictureSettings& B) {
  std::vector<std::string> what;
  for (const Setting& setting : settingRows()) {
    const std::string_view in = setting.differsIn.empty() ? setting.label : setting.differsIn;
    if (differs(setting, A, B) && std::ranges::find(what, in) == what.end()) what.emplace_back(in);
  }
  return what;
}

Finding findingOf(const Picture& A, const Picture& B, const Difference& ofA, const Difference& ofB,
                  const Difference& unlike, const std::optional<DifferingPlace>& place) {
  const std::vector<std::string> what = differencesOf(A.settings(), B.settings());
  if (unlike.errors.count == 0) return {"Nothing shows.", "Turn both with t, or zoom with z."};
  if (what.empty())
    return {"A and B have the same settings.",
            "Change one of them, for example its order with O. This page then shows what differs."};
  for (const auto& [picture, name] : {std::pair{&A, "A"}, {&B, "B"}})
    if (picture->snapped().faces.empty())
      return {std::string{name} + " shows nothing.", "All its faces are turned away or out of view."};
  const std::string meeting =
      place && unlike.kind == Unlike::Face ? meetingOf(A, B, unlike, place->frame) : "";
  const std::string where = meeting.empty() ? "" : ", " + grouped(place->samples) + " of them " + meeting;

  if (A.settings().order != B.settings().order && ofA.wrongFaces + ofB.wrongFaces > 0) {
    const bool aIsWorse = ofA.wrongFaces >= ofB.wrongFaces;
    const Difference &worse = aIsWorse ? ofA : ofB, &better = aIsWorse ? ofB : ofA;
    const std::string name = aIsWorse ? "A" : "B", other = aIsWorse ? "B" : "A";
    if (better.wrongFaces == 0)
      return {
          name + " is wrong at " + counted(worse.wrongFaces, "sample") + where + ".",
          whyOf((aIsWorse ? A : B).settings().order, other, (aIsWorse ? B : A).sorted().statistics.splits)};
    // Where an order is exact, only faces that are left out can make a sample wrong.
    const auto exact = [](const Picture& p) { return rowOf(p.settings().order).exact; };
    const std::string reason =
        exact(A) || exact(B) ? "Backs that can be seen are not painted."
                             : "Neither order is exact: those of Newell, the BSP tree and the oracle are.";
    if (better.wrongFaces == worse.wrongFaces)
      return {"Both are wrong at " + counted(worse.wrongFaces, "sample") + ".", reason};
    return {name + " is wrong at " + counted(worse.wrongFaces, "sample") + ", " + other + " at " +
                grouped(better.wrongFaces) + ".",
            reason};
  }
  const std::string share = shareOf(unlike.above, unlike.errors.count);
  const std::string they = unlike.above > 0 ? "They differ at " + share + " of the samples that show a face."
                           : unlike.kind == Unlike::Face
                               ? "Both show the same face at every sample."
                               : "The two pictures differ nowhere by more than " +
                                     std::string{rowOf(unlike.kind).unitInWords} + ".";
  const auto table = [](const Picture& picture) { return picture.settings().table.kind; };
  if (what.size() == 1 &&
      std::minmax({table(A), table(B)}) == std::pair{TableKind::Linear, TableKind::Corrected})
    return {"The same intensities get different shades. " + they,
            "In the linear table all steps are equally large. In the corrected table all are the same "
            "percentage, and that is what the eye compares. View 3 plots both."};
  const int decimals = rowOf(ofA.kind).decimals;
  const bool aIsNearer = ofA.errors.rootMeanSquare < ofB.errors.rootMeanSquare;
  const std::string least = fixed(std::min(ofA.errors.rootMeanSquare, ofB.errors.rootMeanSquare), decimals),
                    most = fixed(std::max(ofA.errors.rootMeanSquare, ofB.errors.rootMeanSquare), decimals);
  if (ofA.kind == ofB.kind && least != most)
    return {std::string{aIsNearer ? "A" : "B"} + " is closer to the truth overall.",
            "Its root mean square error is " + least + ", against " + most + ". " + they};
  if (unlike.above > 0)
    return {"A and B differ at " + share + " of the samples that show a face.",
            unlike.kind == Unlike::Color ? "The largest difference is " + fixed(unlike.errors.largest, 1) +
                                               "; the eye just sees a difference of 1."
                                         : ""};
  return {"A and B show the same picture.", they};
}

}  // namespace xnewell
