#include "x11/homework/diagnosis_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr std::size_t kMostHiddenTold = 6;
constexpr double kMuch = 0.2;  ///< share of samples

using DiagnosisJson = nlohmann::ordered_json;

std::string percent(double share) { return fixed(100.0 * share, share > 0.995 && share < 1 ? 1 : 0) + " %"; }

std::string inWords(const Hypothesis& h) { return std::string{h.key} + ": " + std::string{h.sentence}; }

/// "0.35", not "0.350000".
std::string shortNumber(double v) {
  std::string words = fixed(v, 4);
  while (words.ends_with('0')) words.pop_back();
  if (words.ends_with('.')) words.pop_back();
  return words;
}

std::string inWords(const Fit& fit) {
  if (fit.number)
    return std::string{fit.first->key} + " is " + shortNumber(fit.number->is) + " where the scene says " +
           shortNumber(fit.number->was) + ".";
  std::string words = inWords(*fit.first);
  if (fit.second == nullptr) return words;
  const bool allowed = fit.second->meaning == Meaning::Allowed;
  return words +
         (allowed ? " With " + std::string{fit.second->key} + ", which the course allows: "
                  : " And " + std::string{fit.second->key} + ": ") +
         std::string{fit.second->sentence};
}

std::string fitTerms(const Fit& fit) {
  std::string terms{fit.first->term};
  if (fit.second != nullptr && fit.second->term != fit.first->term)
    terms += "; " + std::string{fit.second->term};
  return terms;
}

std::string valuesOf(const std::array<double, 3>& v, bool oneHue) {
  const auto one = [](double x) { return fixed(x, 0); };
  return oneHue ? one(v[0]) : one(v[0]) + "," + one(v[1]) + "," + one(v[2]);
}

void printWhere(const Diagnosis& d, std::ostream& out) {
  if (!d.pixel) return;
  const DiagnosedPixel& p = *d.pixel;
  out << "  most clearly at pixel " << p.i << ',' << p.j << ", face " << p.face << ": yours "
      << valuesOf(p.yours, d.oneHue) << ", right " << valuesOf(p.right, d.oneHue);
  if (!d.found.empty())
    out << (d.found.front().number ? ", with this number " : ", with this mistake ")
        << valuesOf(p.mistaken, d.oneHue);
  if (!std::isnan(p.NdotL)) out << "; N.L = " << fixed(p.NdotL, 3) << ", R.V = " << fixed(p.RdotV, 3);
  out << '\n';
}

}  // namespace

std::string_view nameOf(Marking verdict) {
  switch (verdict) {
    case Marking::Right:
      return "right";
    case Marking::Allowed:
      return "allowed";
    case Marking::Outlines:
      return "outlines";
    case Marking::Mistake:
      return "mistake";
    case Marking::OneOf:
      return "one-of";
    case Marking::Numbers:
      return "numbers";
    case Marking::Unknown:
      return "unknown";
    case Marking::OtherScene:
      return "other-scene";
  }
  return "";
}

std::string nameOf(const Fit& fit) {
  std::string name{fit.first->key};
  if (fit.number) name += '=' + shortNumber(fit.number->is);
  if (fit.second && fit.second->meaning == fit.first->meaning)  // two mistakes, or two variants
    name += '+' + std::string{fit.second->key};
  return name;
}

namespace {

/// "right, but it stores 255 I, not the table's colour", and the option with which that is plainly right.
std::string storedInWords(const Diagnosis& d) {
  const Fit& fit = d.found.front();
  const auto stores = [](const Hypothesis* h) { return h != nullptr && h->key.starts_with("stores-"); };
  if (!stores(fit.first) && !stores(fit.second)) return "";
  const Hypothesis &row = stores(fit.first) ? *fit.first : *fit.second, *const other = stores(fit.first)
                                                                                           ? fit.second
                                                                                           : fit.first;
  std::string words = "right, but i" + std::string{row.sentence.substr(1, row.sentence.size() - 2)};
  if (other != nullptr) words += ", with " + std::string{other->key} + " (the course allows it)";
  if (d.oneHue && row.key != "stores-gamma") words += ": --colors chosen accepts it";
  return words;
}

}  // namespace

std::string verdictOf(const Diagnosis& d) {
  switch (d.verdict) {
    case Marking::Right:
      return d.exact >= kExact || !d.oneHue || d.found.front().explained < kExact
                 ? "right"
                 : "right, but for one shade at " + percent(1.0 - d.exact) + " of the samples";
    case Marking::Allowed: {
      if (const std::string stores = storedInWords(d); !stores.empty()) return stores;
      std::string words = "right, with " + std::string{d.found.front().first->key};
      if (d.found.front().second) words += " and " + std::string{d.found.front().second->key};
      return words + " (the course allows it): " + std::string{d.found.front().first->sentence};
    }
    case Marking::Outlines:
      return "wrong: the shades are right, but faces lie elsewhere: check the camera, the projection and the "
             "corners";
    case Marking::Mistake:
      return "wrong: " + inWords(d.found.front());
    case Marking::OneOf:
    case Marking::Numbers: {
      if (d.found.size() == 1)
        return "wrong: " +
               (d.found[0].number ? inWords(d.found[0]) : std::string{d.found[0].first->sentence});
      std::string words = "wrong: one of " + counted(d.found.size(), "answer") + " that look alike here: ";
      for (const Fit& fit : d.found) words += (&fit == &d.found.front() ? "" : ", ") + nameOf(fit);
      return words;
    }
    case Marking::Unknown:
      return "wrong, and none of my " + std::to_string(mistakesKnown()) +
             " mistakes: check Ia, n, the light, the camera and the divisions";
    case Marking::OtherScene:
      if (d.isOtherSize) return "another size: the picture has not as many pixels as the scene's";
      if (d.isOneColor) return "no picture of this scene: all pixels have one colour";
      return "another scene, camera or size: the outlines overlap by " + percent(d.outlines.overlap);
  }
  return "";
}

namespace {

/// At most six keys, and where to look for them.
std::string hiddenSentence(const PartedBy& parted) {
  std::string words = "this picture would be the same with ";
  const std::size_t told = std::min<std::size_t>(parted.hidden.size(), kMostHiddenTold);
  for (std::size_t k = 0; k < told; ++k) words += (k ? ", " : "") + std::string{parted.hidden[k]};
  if (told < parted.hidden.size()) words += " and " + std::to_string(parted.hidden.size() - told) + " more";
  return words + (parted.shownBy.empty() ? "" : "; " + parted.shownBy);
}

}  // namespace

void printDiagnosis(const Diagnosis& d, const PartedBy& parted, std::ostream& out) {
  out << verdictOf(d);
  if (d.verdict == Marking::Mistake) out << "  [" << fitTerms(d.found.front()) << ']';
  out << '\n';
  const bool isWrong = d.verdict != Marking::Right && d.verdict != Marking::Allowed;
  if (d.others > 0)
    out << "  at " << grouped(d.others) << " of " << counted(d.inside, "sample")
        << " inside faces it shows another shade or another face; xnewell judge says whether its order is "
           "right\n";
  if (d.found.size() > 1 && isWrong && d.verdict != Marking::Outlines)
    for (const Fit& fit : d.found) out << "  " << inWords(fit) << "  [" << fitTerms(fit) << "]\n";
  if (!d.found.empty() && isWrong && d.verdict != Marking::Outlines) {
    const Fit& fit = d.found.front();
    out << "  explains " << percent(fit.explained) << " of " << grouped(d.samples) << " samples, and "
        << percent(fit.informative) << " of the " << grouped(fit.telling) << " that tell\n";
  }
  if (d.outlines.areOff() && d.verdict != Marking::OtherScene)
    out << "  its outlines are up to " << d.outlines.farthest << (d.outlines.farthest < 40 ? "" : " or more")
        << " pixels away from the right ones, as at pixel " << d.outlines.i << ',' << d.outlines.j << '\n';
  printWhere(d, out);
  for (const Fit& fit : d.doubts) out << "  or, as this picture cannot tell: " << inWords(fit) << '\n';
  if (d.brightest >= kMuch && d.verdict != Marking::Mistake && d.verdict != Marking::OtherScene)
    out << "  " << percent(d.brightest) << " of the samples are clamped to I = 1, which hides mistakes\n";
  if (!parted.sentence.empty()) out << "  " << parted.sentence << '\n';
  if (!parted.hidden.empty()) out << "  " << hiddenSentence(parted) << '\n';
}

void printDiagnosisAsJson(const Diagnosis& d, const PartedBy& parted, std::ostream& out) {
  const auto asJson = [](const Fit& fit) {
    DiagnosisJson one{{"key", fit.first->key},   {"sentence", fit.first->sentence},
                      {"term", fit.first->term}, {"allowed", fit.first->meaning == Meaning::Allowed},
                      {"cost", fit.cost},        {"explained", fit.explained},
                      {"telling", fit.telling},  {"informative", fit.informative}};
    if (fit.second) one["with"] = fit.second->key;
    if (fit.number) one["value"] = fit.number->is, one["right_value"] = fit.number->was;
    return one;
  };
  DiagnosisJson found = DiagnosisJson::array(), all = DiagnosisJson::array();
  for (const Fit& fit : d.found) found.push_back(asJson(fit));
  for (const Fit& fit : d.all) all.push_back(asJson(fit));
  DiagnosisJson json{
      {"verdict", nameOf(d.verdict)}, {"words", verdictOf(d)},         {"found", found},
      {"samples", d.samples},         {"overlap", d.outlines.overlap}, {"reads_cells", d.readsCells}};
  if (d.outlines.apart > 0)
    json["outlines"] = {{"pixels", d.outlines.apart},
                        {"farthest", d.outlines.farthest},
                        {"x", d.outlines.i},
                        {"y", d.outlines.j}};
  if (d.pixel) {
    const auto values = [&](const std::array<double, 3>& v) -> DiagnosisJson {
      if (d.oneHue) return v[0];
      return {v[0], v[1], v[2]};
    };
    json["pixel"] = {{"at", {d.pixel->i, d.pixel->j}},
                     {"face", d.pixel->face},
                     {"yours", values(d.pixel->yours)},
                     {"right", values(d.pixel->right)},
                     {"with_mistake", values(d.pixel->mistaken)},
                     {"N.L", d.pixel->NdotL},
                     {"R.V", d.pixel->RdotV}};
  }
  if (!parted.sentence.empty()) json["parted_by"] = parted.sentence;
  if (!d.doubts.empty()) {
    DiagnosisJson doubts = DiagnosisJson::array();
    for (const Fit& fit : d.doubts) doubts.push_back(asJson(fit));
    json["doubts"] = doubts;
  }
  json["exact"] = d.exact, json["brightest"] = d.brightest, json["cannot_show"] = parted.hidden;
  json["hypotheses"] = all;
  out << json.dump(-1, ' ', false, DiagnosisJson::error_handler_t::replace) << '\n';
}

namespace {

std::string_view tableName(TableKind kind) { return kTables[static_cast<std::size_t>(kind)].name; }

std::string optionsOf(const PartingPicture& picture) {
  return std::string{picture.scene} + " --size " + std::to_string(kPartingSize.x) + "x" +
         std::to_string(kPartingSize.y) + " --shade " + std::string{rowOf(picture.method).name} +
         " --table " + std::string{tableName(picture.table)};
}

/// What is shown at a pixel: the value, or the cell if only cells tell.
std::string shownAs(const std::optional<double>& value, int cell, bool byCells) {
  if (!value) return "no face";
  return byCells ? "cell " + std::to_string(cell) : fixed(*value, 0);
}

}  // namespace

std::string partingSentence(std::string_view a, std::string_view b, const SceneFor& found) {
  const std::string A{a}, B{b}, pictures = counted(found.tried, "picture");
  if (found.tried == 0) return A + " and " + B + " are mistakes of different methods or tables";
  const Parting& p = found.parting;
  if (!found.picture)
    return "no scene tells " + A + " and " + B + " apart: in " + pictures + " they differ by " +
           (p.shades < 0.005 ? "nothing, so they may be the same by algebra"
                             : fixed(p.shades, 2) + " shades at most");
  return "to tell " + A + " and " + B + " apart, draw " + optionsOf(*found.picture) + ": at pixel " +
         std::to_string(p.i) + "," + std::to_string(p.j) + ", face " + std::to_string(p.face) + ", " + A +
         " shows " + shownAs(p.first, p.firstCell, found.byCells) + ", and " + B + " shows " +
         shownAs(p.second, p.secondCell, found.byCells) + "; right is " +
         shownAs(p.right, p.rightCell, found.byCells) +
         (found.byCells ? ". Only a file with the cells tells: an indexed PNG or a window dump" : "");
}

void printSceneFor(std::string_view a, std::string_view b, const SceneFor& found, std::ostream& out) {
  out << partingSentence(a, b, found) << '\n';
  for (const std::string_view key : {a, b}) out << "  " << inWords(*hypothesisNamed(key)) << '\n';
}

void printSceneForAsJson(std::string_view a, std::string_view b, const SceneFor& found, std::ostream& out) {
  DiagnosisJson json{{"first", a},
                     {"second", b},
                     {"told_apart", found.picture.has_value()},
                     {"words", partingSentence(a, b, found)},
                     {"tried", found.tried}};
  if (found.tried > 0) json["shades_apart"] = found.parting.shades;
  if (found.picture) {
    const Parting& p = found.parting;
    const auto shown = [](const std::optional<double>& value, int cell) -> DiagnosisJson {
      if (!value) return nullptr;
      return {{"value", *value}, {"cell", cell}};
    };
    json["scene"] = found.picture->scene;
    json["size"] = {kPartingSize.x, kPartingSize.y};
    json["shade"] = rowOf(found.picture->method).name;
    json["table"] = tableName(found.picture->table);
    json["pixel"] = {p.i, p.j};
    json["face"] = p.face;
    json["by_cells"] = found.byCells;
    json["first_shows"] = shown(p.first, p.firstCell);
    json["second_shows"] = shown(p.second, p.secondCell);
    json["right_shows"] = shown(p.right, p.rightCell);
  }
  out << json.dump() << '\n';
}

}  // namespace xnewell
