#include <algorithm>
#include <functional>
#include <map>

#include "x11/drawing/wording.h"
#include "x11/sides/sides.h"
#include "x11/window/caption.h"

namespace xnewell {

/// The words about two pictures beside each other: how they were made, and what was found.

namespace {

std::string shortNameOf(Order order) {
  switch (order) {
    case Order::Unsorted:
      return "unsorted";
    case Order::ZMean:
      return "z-sort by mean z";
    case Order::ZSort:
      return "z-sort by farthest z";
    case Order::Newell:
      return "Newell";
    case Order::Oracle:
      return "oracle";
  }
  return "";
}

/// A number with as many decimals as it needs, up to six.
std::string inWords(double v) {
  int decimals = 0;
  while (decimals < 6 && std::stod(fixed(v, decimals)) != v) ++decimals;
  return fixed(v, decimals);
}
std::string inWords(const glm::dvec3& v) { return inWords(v.x) + ", " + inWords(v.y) + ", " + inWords(v.z); }

/// A setting in which two pictures may differ.
struct Item {
  using S = PictureSettings;
  std::string_view what;
  bool always;  ///< shown even if both have the same value
  std::function<bool(const S&, const S&)> same;
  std::function<std::string(const S&)> words;
};
template <class Get, class Words>
Item item(std::string_view what, bool always, Get get, Words words) {
  return {what, always, [=](const auto& a, const auto& b) { return get(a) == get(b); }, words};
}

const std::vector<Item>& items() {
  using S = PictureSettings;
  const auto number = [](std::string_view what, std::string name, auto get) {
    return item(what, false, get, [=](const S& s) { return name + ' ' + inWords(get(s)); });
  };
  static const std::vector<Item> all{
      item(
          "order", true, [](const S& s) { return s.order; }, [](const S& s) { return shortNameOf(s.order); }),
      item(
          "shading", true, [](const S& s) { return s.shading; },
          [](const S& s) { return shadingInWords(s.shading); }),
      item(
          "normals", true, [](const S& s) { return s.normals; },
          [](const S& s) { return std::string{kNormalRules[int(s.normals)].name} + " normals"; }),
      item(
          "table", true, [](const S& s) { return s.table.kind; },
          [](const S& s) { return std::string{kTables[int(s.table.kind)].name}; }),
      item(
          "shades", false, [](const S& s) { return s.table.shades; },
          [](const S& s) { return std::to_string(s.table.shades) + " shades"; }),
      number("table", "I0", [](const S& s) { return s.table.I0; }),
      item(
          "table", false, [](const S& s) { return s.table.pick; },
          [](const S& s) { return "nearest by " + std::string{kPicks[int(s.table.pick)].name}; }),
      item(
          "table", false,
          [](const S& s) {
            return std::pair{s.table.low, s.table.high};
          },
          [](const S& s) { return inWords(s.table.low) + " to " + inWords(s.table.high); }),
      item(
          "hue", false, [](const S& s) { return s.table.hue; },
          [](const S& s) { return "hue " + inWords(s.table.hue); }),
      item(
          "bits", false, [](const S& s) { return s.table.bits; },
          [](const S& s) { return std::to_string(s.table.bits) + " bits"; }),
      item(
          "colours", false, [](const S& s) { return s.colors; },
          [](const S& s) { return "colours " + std::string{kColorPlans[int(s.colors)].name}; }),
      item(
          "dither", false, [](const S& s) { return s.dither; },
          [](const S& s) { return std::string{s.dither ? "dithered" : "not dithered"}; }),
      item(
          "backs", false, [](const S& s) { return s.cull; },
          [](const S& s) { return std::string{s.cull == Cull::Back ? "backs culled" : "backs kept"}; }),
      number("light", "Ia", [](const S& s) { return s.light.Ia; }),
      number("light", "Ip", [](const S& s) { return s.light.Ip; }),
      number("surface", "ka", [](const S& s) { return s.light.ka; }),
      number("surface", "kd", [](const S& s) { return s.light.kd; }),
      number("surface", "ks", [](const S& s) { return s.light.ks; }),
      item(
          "surface", false, [](const S& s) { return s.light.n; },
          [](const S& s) { return "n " + std::to_string(s.light.n); }),
      item(
          "L", false, [](const S& s) { return s.light.constantL; },
          [](const S& s) { return std::string{s.light.constantL ? "L constant" : "L from each place"}; }),
      item(
          "V", false, [](const S& s) { return s.light.constantV; },
          [](const S& s) { return std::string{s.light.constantV ? "V constant" : "V from each place"}; }),
      item(
          "light", false,
          [](const S& s) {
            return std::pair{s.light.light, s.light.lightPosition};
          },
          [](const S& s) {
            return s.light.lightPosition ? "light at " + inWords(*s.light.lightPosition)
                                         : "light from " + inWords(s.light.light);
          }),
      item(
          "light", false,
          [](const S& s) {
            return std::tuple{s.light.attenuation, s.light.range, s.light.c};
          },
          [](const S& s) {
            return "attenuation " + std::string{kAttenuations[int(s.light.attenuation)].name};
          }),
      item(
          "form", false, [](const S& s) { return s.light.form; },
          [](const S& s) { return std::string{kForms[int(s.light.form)].name}; }),
      item(
          "light", false, [](const S& s) { return s.light.twoSided; },
          [](const S& s) { return std::string{s.light.twoSided ? "both sides lit" : "fronts lit"}; }),
      item(
          "crease", false, [](const S& s) { return s.crease; },
          [](const S& s) { return "crease " + inWords(s.crease) + "\u00B0"; }),
      item(
          "polygons", false, [](const S& s) { return s.polygons; },
          [](const S& s) { return "by " + std::string{kPolygons[int(s.polygons)].name}; }),
      item(
          "division", false, [](const S& s) { return s.adapt; },
          [](const S& s) { return s.adapt > 0 ? "divided to " + inWords(s.adapt) : "not divided"; }),
      item(
          "environment", false, [](const S& s) { return s.environment; },
          [](const S& s) { return std::string{kEnvironmentForms[int(s.environment)].name}; }),
      item(
          "mapping", false, [](const S& s) { return s.mapping; },
          [](const S& s) { return std::string{kTextureMappings[int(s.mapping)].name} + " mapping"; }),
  };
  return all;
}

/// "where body and spout meet", if most of the differing samples in the frame show faces of these two groups;
/// "" if groups have no names.
std::string meetingOf(const Picture& A, const Picture& B, const Unlikeness& unlike, const Rect& frame) {
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

std::string whyOf(Order order, std::string_view other, const SideNumbers& numbers) {
  std::string why =
      order == Order::Unsorted
          ? "The scene's own order ignores depth"
          : "One z for each face cannot order faces that overlap in z or pass through each other";
  if (numbers.cuts > 0)
    why +=
        "; " + std::string{other} + " cuts " + (numbers.cuts == 1 ? "once" : counted(numbers.cuts, "time"));
  return why + ".";
}

}  // namespace

std::vector<Phrase> phrasesOf(const PictureSettings& mine, const PictureSettings& other) {
  std::vector<Phrase> phrases;
  const auto say = [&](bool differing) {
    for (const Item& i : items()) {
      const bool differs = !i.same(mine, other);
      if (differs != differing || !(i.always || differs)) continue;
      if (!differs && i.what == "normals" && !rowOf(mine.shading).interpolates) continue;
      phrases.push_back({i.words(mine), differs});
    }
  };
  say(true), say(false);
  return phrases;
}

std::vector<std::string> differencesOf(const PictureSettings& A, const PictureSettings& B) {
  std::vector<std::string> what;
  for (const Item& i : items())
    if (!i.same(A, B) && std::ranges::find(what, i.what) == what.end()) what.emplace_back(i.what);
  return what;
}

Finding findingOf(const Picture& A, const Picture& B, const SideNumbers& ofA, const SideNumbers& ofB,
                  const Unlikeness& unlike, const std::optional<DifferingPlace>& place) {
  const std::vector<std::string> what = differencesOf(A.settings(), B.settings());
  if (unlike.samples == 0) return {"Nothing shows.", "Turn both with t, or zoom with z."};
  if (what.empty())
    return {"A and B have the same settings.",
            "Change one of them, for example its order with O. This page then shows what differs."};
  for (const auto& [picture, name] : {std::pair{&A, "A"}, {&B, "B"}})
    if (picture->snapped().faces.empty())
      return {std::string{name} + " shows nothing.", "All its faces are turned away or out of view."};
  const std::string meeting =
      place && unlike.kind == Unlike::Face ? meetingOf(A, B, unlike, place->frame) : "";
  const std::string where = meeting.empty() ? "" : ", " + grouped(place->samples) + " of them " + meeting;

  if (A.settings().order != B.settings().order && ofA.wrong + ofB.wrong > 0) {
    const bool aIsWorse = ofA.wrong >= ofB.wrong;
    const SideNumbers &worse = aIsWorse ? ofA : ofB, &better = aIsWorse ? ofB : ofA;
    const std::string name = aIsWorse ? "A" : "B", other = aIsWorse ? "B" : "A";
    if (better.wrong == 0)
      return {name + " is wrong at " + counted(worse.wrong, "sample") + where + ".",
              whyOf((aIsWorse ? A : B).settings().order, other, better)};
    if (better.wrong == worse.wrong)
      return {"Both are wrong at " + counted(worse.wrong, "sample") + ".",
              "Neither order is exact: Newell's and the oracle's are."};
    return {name + " is wrong at " + counted(worse.wrong, "sample") + ", " + other + " at " +
                grouped(better.wrong) + ".",
            "Neither order is exact: Newell's and the oracle's are."};
  }
  const std::string share = shareOf(unlike.differ, unlike.samples);
  const Measure measure = unlike.kind == Unlike::Intensity ? Measure::Intensity : Measure::Color;
  const std::string they = unlike.differ > 0 ? "They differ at " + share + " of the samples."
                           : unlike.kind == Unlike::Face
                               ? "Both show the same face at every sample."
                               : "The two pictures differ nowhere by more than " +
                                     std::string{kMeasures[static_cast<int>(measure)].unitInWords} + ".";
  const auto table = [](const Picture& picture) { return picture.settings().table.kind; };
  if (what.size() == 1 &&
      std::minmax({table(A), table(B)}) == std::pair{TableKind::Linear, TableKind::Corrected})
    return {"The same intensities get different shades. " + they,
            "In the linear table all steps are equally large. In the corrected table all are the same "
            "percentage, and that is what the eye compares. View 3 plots both."};
  const int decimals = ofA.measure == Measure::Intensity ? 4 : 2;
  const bool aIsNearer = ofA.rootMeanSquare < ofB.rootMeanSquare;
  const std::string least = fixed(std::min(ofA.rootMeanSquare, ofB.rootMeanSquare), decimals),
                    most = fixed(std::max(ofA.rootMeanSquare, ofB.rootMeanSquare), decimals);
  if (ofA.measure == ofB.measure && least != most)
    return {std::string{aIsNearer ? "A" : "B"} + " is closer to Phong's method overall.",
            "Its root mean square error is " + least + ", against " + most + ". " + they};
  if (unlike.differ > 0)
    return {"A and B differ at " + share + " of the samples.",
            unlike.kind == Unlike::Color ? "The largest difference is " + fixed(unlike.largest, 1) +
                                               "; the eye just sees a difference of 1."
                                         : ""};
  return {"A and B show the same picture.", they};
}

}  // namespace xnewell
