#include "x11/homework/reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/files/parse_error.h"
#include "shading/color/png.h"
#include "shading/diagnose/scene_for.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/wording.h"

namespace xnewell {

std::string inHtml(std::string_view text) {
  std::string html;
  for (const char c : text)
    html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string{c};
  return html;
}

std::string element(const std::string& name, std::string_view text) {
  return '<' + name + '>' + inHtml(text) + "</" + name + ">\n";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = k; i < k + 3; ++i)
      three = three << 8 | (i < bytes.size() ? static_cast<std::uint8_t>(bytes[i]) : 0U);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += k + digit <= bytes.size() ? kDigits[three >> (18 - 6 * digit) & 63] : '=';
  }
  return text;
}

std::string imageUrl(std::string_view png) { return "data:image/png;base64," + base64(png); }

std::string imageElement(std::string_view png) { return "<img alt=\"\" src=\"" + imageUrl(png) + "\">\n"; }

std::string wellFormed(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  std::string all;
  while (!text.empty()) {
    const std::uint32_t lead = static_cast<std::uint8_t>(text[0]);
    std::size_t size = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    std::uint32_t code = size == 1 ? lead : lead & (0x7FU >> size);
    bool isWell = (lead < 0x80 || lead >= 0xC2) && lead < 0xF5 && size <= text.size();
    for (std::size_t k = 1; isWell && k < size; ++k)
      isWell = continues(text[k]), code = code << 6 | (static_cast<std::uint8_t>(text[k]) & 0x3FU);
    isWell = isWell && code >= kLeast[size] && code <= 0x10FFFF && (code & 0xFFFFF800) != 0xD800 &&
             code != 0xFFFE && code != 0xFFFF && (code >= 0x20 || code == '\n' || code == '\t');
    if (isWell)
      all += text.substr(0, size);
    else
      size = 1, all += std::string{"\\x"} + kDigits[lead >> 4] + kDigits[lead & 15];
    text.remove_prefix(size);
  }
  return all;
}

namespace {

/// ---- A diagnosis

using page::Data;
using page::List;
using page::Object;

constexpr std::size_t kMostHiddenTold = 6;
constexpr double kMuch = 0.2;  ///< share of samples

std::string pixelText(int i, int j) { return std::to_string(i) + ',' + std::to_string(j); }
std::string percent(double share) { return fixed(100.0 * share, share > 0.995 && share < 1 ? 1 : 0) + " %"; }

std::string wordsOf(const Hypothesis& h) { return std::string{h.key} + ": " + std::string{h.sentence}; }

/// "0.35", not "0.350000".
std::string shortNumber(double v) {
  std::string words = fixed(v, 4);
  while (words.ends_with('0')) words.pop_back();
  if (words.ends_with('.')) words.pop_back();
  return words;
}

std::string wordsOf(const Fit& fit) {
  if (fit.number)
    return std::string{fit.first->key} + " is " + shortNumber(fit.number->is) + " where the scene says " +
           shortNumber(fit.number->was) + ".";
  std::string words = wordsOf(*fit.first);
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

Data dataOf(const Fit& fit) {
  Object one{{"key", fit.first->key},   {"sentence", fit.first->sentence},
             {"term", fit.first->term}, {"allowed", fit.first->meaning == Meaning::Allowed},
             {"cost", fit.cost},        {"explained", fit.explained},
             {"telling", fit.telling},  {"informative", fit.informative}};
  if (fit.second) one.emplace_back("with", fit.second->key);
  if (fit.number) {
    one.emplace_back("value", fit.number->is);
    one.emplace_back("right_value", fit.number->was);
  }
  return one;
}
List dataOf(const std::vector<Fit>& fits) {
  List all;
  for (const Fit& fit : fits) all.push_back(dataOf(fit));
  return all;
}

/// Where it shows most clearly.
void addPixel(page::Section& s, const Diagnosis& d) {
  if (!d.pixel) return;
  const DiagnosedPixel& p = *d.pixel;
  std::string words = "  most clearly at pixel " + pixelText(p.i, p.j) + ", face " + std::to_string(p.face) +
                      ": yours " + valuesOf(p.yours, d.oneHue) + ", right " + valuesOf(p.right, d.oneHue);
  if (!d.found.empty())
    words += (d.found.front().number ? ", with this number " : ", with this mistake ") +
             valuesOf(p.mistaken, d.oneHue);
  if (!std::isnan(p.NdotL)) words += "; N.L = " + fixed(p.NdotL, 3) + ", R.V = " + fixed(p.RdotV, 3);
  const auto values = [&](const std::array<double, 3>& v) {
    return d.oneHue ? Data{v[0]} : Data{List{v[0], v[1], v[2]}};
  };
  s.fact("pixel",
         Object{{"at", List{p.i, p.j}},
                {"face", p.face},
                {"yours", values(p.yours)},
                {"right", values(p.right)},
                {"with_mistake", values(p.mistaken)},
                {"N.L", p.NdotL},
                {"R.V", p.RdotV}},
         words);
}

}  // namespace

std::string_view nameOf(Marking verdict) {
  constexpr std::array<std::string_view, 8> kNames{"right",  "allowed", "outlines", "mistake",
                                                   "one-of", "numbers", "unknown",  "other-scene"};
  return kNames[static_cast<std::size_t>(verdict)];
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
std::string storedText(const Diagnosis& d) {
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
      if (const std::string stores = storedText(d); !stores.empty()) return stores;
      std::string words = "right, with " + std::string{d.found.front().first->key};
      if (d.found.front().second) words += " and " + std::string{d.found.front().second->key};
      return words + " (the course allows it): " + std::string{d.found.front().first->sentence};
    }
    case Marking::Outlines:
      return "wrong: the shades are right, but faces lie elsewhere: check the camera, the projection and the "
             "corners";
    case Marking::Mistake:
      return "wrong: " + wordsOf(d.found.front());
    case Marking::OneOf:
    case Marking::Numbers: {
      if (d.found.size() == 1)
        return "wrong: " +
               (d.found[0].number ? wordsOf(d.found[0]) : std::string{d.found[0].first->sentence});
      std::string words = "wrong: one of " + counted(d.found.size(), "answer") + " that look alike here: ";
      for (const Fit& fit : d.found) words += (&fit == &d.found.front() ? "" : ", ") + nameOf(fit);
      return words;
    }
    case Marking::Unknown:
      return "wrong, and none of my " + std::to_string(mistakesKnown()) +
             " mistakes: check Ia, n, the light, the camera and the divisions";
    case Marking::OtherScene:
      if (d.isOtherSize) return "another size: the picture has not as many pixels as the scene's";
      if (d.isBlack)
        return "no picture to judge: it is black where faces show, so nothing was painted or stored, or I "
               "was "
               "divided as whole numbers";
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

page::Page pageOf(const Diagnosis& d, const PartedBy& parted) {
  page::Page page{.sections = {{}},
                  .order = "verdict words found samples overlap reads_cells outlines pixel parted_by doubts"};
  page::Section& s = page.sections.front();
  const std::string verdict = verdictOf(d);
  const bool isWrong = d.verdict != Marking::Right && d.verdict != Marking::Allowed,
             isFound = !d.found.empty() && isWrong && d.verdict != Marking::Outlines;
  s.fact("verdict", nameOf(d.verdict));
  s.fact("words", verdict,
         verdict + (d.verdict == Marking::Mistake ? "  [" + fitTerms(d.found.front()) + ']' : ""));
  if (d.others > 0)
    s.say("  at " + grouped(d.others) + " of " + counted(d.inside, "sample") +
          " inside faces it shows another face; xnewell judge says whether its order is right");
  if (d.strange > 0) s.say("  at " + counted(d.strange, "pixel") + " it has another shade");
  if (d.found.size() > 1 && isFound)
    for (const Fit& fit : d.found) s.say("  " + wordsOf(fit) + "  [" + fitTerms(fit) + ']');
  s.fact("found", dataOf(d.found));
  s.fact("samples", d.samples,
         !isFound ? ""
                  : "  explains " + percent(d.found.front().explained) + " of " + grouped(d.samples) +
                        " samples, and " + percent(d.found.front().informative) + " of the " +
                        grouped(d.found.front().telling) + " that tell");
  s.fact("overlap", d.outlines.overlap);
  s.fact("reads_cells", d.readsCells);
  const Outlines& lines = d.outlines;
  if (lines.areOff() && d.verdict != Marking::OtherScene)
    s.say("  its outlines are up to " + std::to_string(lines.farthest) +
          (lines.farthest < 40 ? "" : " or more") + " pixels away from the right ones, as at pixel " +
          pixelText(lines.i, lines.j));
  if (lines.apart > 0)
    s.fact("outlines",
           Object{{"pixels", lines.apart}, {"farthest", lines.farthest}, {"x", lines.i}, {"y", lines.j}});
  addPixel(s, d);
  for (const Fit& fit : d.doubts) s.say("  or, as this picture cannot tell: " + wordsOf(fit));
  if (!d.doubts.empty()) s.fact("doubts", dataOf(d.doubts));
  s.fact("exact", d.exact);
  s.fact("brightest", d.brightest,
         d.brightest < kMuch || d.verdict == Marking::Mistake || d.verdict == Marking::OtherScene
             ? ""
             : "  " + percent(d.brightest) + " of the samples are clamped to I = 1, which hides mistakes");
  if (!parted.sentence.empty()) s.fact("parted_by", parted.sentence, "  " + parted.sentence);
  s.fact("cannot_show", parted.hidden, parted.hidden.empty() ? "" : "  " + hiddenSentence(parted));
  s.fact("hypotheses", dataOf(d.all));
  return page;
}

/// ---- A picture that tells two mistakes apart

namespace {

std::string_view tableName(TableKind kind) { return kTables[static_cast<std::size_t>(kind)].name; }

std::string numbersText(const glm::dvec4& v) {
  std::string text = shortNumber(v[0]);
  for (int k = 1; k < 4; ++k) text += ',' + shortNumber(v[k]);
  return text;
}

std::string optionsOf(const PartingPicture& picture) {
  return std::string{picture.scene} + " --size " + std::to_string(kPartingSize.x) + "x" +
         std::to_string(kPartingSize.y) + " --shade " + std::string{rowOf(picture.method).name} +
         " --table " + std::string{tableName(picture.table)} +
         (picture.window ? " --view-window=" + numbersText(*picture.window) : "");
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
         pixelText(p.i, p.j) + ", face " + std::to_string(p.face) + ", " + A + " shows " +
         shownAs(p.first, p.firstCell, found.byCells) + ", and " + B + " shows " +
         shownAs(p.second, p.secondCell, found.byCells) + "; right is " +
         shownAs(p.right, p.rightCell, found.byCells) +
         (found.byCells ? ". Only a file with the cells tells: an indexed PNG or a window dump" : "");
}

page::Page pageOf(std::string_view a, std::string_view b, const SceneFor& found) {
  page::Page page{.sections = {{}}};
  page::Section& s = page.sections.front();
  const std::string words = partingSentence(a, b, found);
  s.fact("first", a);
  s.fact("second", b);
  s.fact("told_apart", found.picture.has_value());
  s.fact("words", words, words);
  s.fact("tried", found.tried);
  for (const std::string_view key : {a, b}) s.say("  " + wordsOf(*hypothesisNamed(key)));
  if (found.tried > 0) s.fact("shades_apart", found.parting.shades);
  if (!found.picture) return page;
  const Parting& p = found.parting;
  const auto shown = [](const std::optional<double>& value, int cell) -> Data {
    if (!value) return nullptr;
    return Object{{"value", *value}, {"cell", cell}};
  };
  s.fact("scene", found.picture->scene);
  s.fact("size", kPartingSize);
  s.fact("shade", rowOf(found.picture->method).name);
  s.fact("table", tableName(found.picture->table));
  if (const auto& w = found.picture->window) s.fact("view_window", List{w->x, w->y, w->z, w->w});
  s.fact("pixel", List{p.i, p.j});
  s.fact("face", p.face);
  s.fact("by_cells", found.byCells);
  s.fact("first_shows", shown(p.first, p.firstCell));
  s.fact("second_shows", shown(p.second, p.secondCell));
  s.fact("right_shows", shown(p.right, p.rightCell));
  return page;
}

/// ---- A painting order that was judged

namespace {

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

page::Page pageOf(const OrderReport& r, std::span<const PaintStep> steps) {
  page::Page page{.sections = {{}}};
  page::Section& s = page.sections.front();
  List covers, outside;
  for (const BadCover& bad : r.covers)
    covers.push_back(Object{
        {"face", bad.face}, {"pixel", List{bad.i, bad.j}}, {"times", bad.times}, {"samples", bad.samples}});
  for (const OutsidePiece& piece : r.outside)
    outside.push_back(Object{{"face", steps[piece.step].face},
                             {"line", steps[piece.step].line},
                             {"pixel", List{piece.i, piece.j}},
                             {"samples", piece.samples}});
  const std::string verdict = verdictOf(r, steps);
  s.fact("verdict", r.isRight() ? "right" : "wrong");
  s.fact("words", verdict, verdict);
  s.fact("steps", r.steps);
  s.fact("missing", r.missing);
  s.fact("unseen", r.unseen);
  s.fact("repeated", r.repeated);
  s.fact("covers", covers);
  s.fact("outside", outside);
  s.fact("wrong_samples", r.wrongSamples);
  s.fact("wrong_pairs", r.wrongPairs);
  s.fact("in_one_plane", r.inOnePlane);
  if (!r.first) return page;
  const WrongPair& pair = *r.first;
  const std::string lesson = lessonOf(pair, steps);
  s.say("  it shows at pixel " + pixelText(pair.i, pair.j) + ", and at " + counted(pair.samples, "sample") +
        " in all; " + counted(r.wrongSamples, "sample") + " of " + counted(r.wrongPairs, "pair") +
        " are wrong, and this pair is the first");
  s.fact(
      "first",
      Object{{"shown", steps[pair.shown].face},
             {"shown_line", steps[pair.shown].line},
             {"hidden", steps[pair.hidden].face},
             {"hidden_line", steps[pair.hidden].line},
             {"pixel", List{pair.i, pair.j}},
             {"samples", pair.samples},
             {"test", pair.told && !pair.needsCut ? Data{kTestRows[static_cast<std::size_t>(*pair.told)].name}
                                                  : Data{nullptr}},
             {"needs_cut", pair.needsCut},
             {"cycle", pair.cycle},
             {"says", lesson}},
      "  " + lesson);
  return page;
}

/// ---- The sheet of a diagnosis

namespace {

constexpr int kSheetGap = 8, kSheetHead = 24;
constexpr std::array<std::uint8_t, 3> kFrame{255, 220, 0};

/// Copies a picture to (x, kSheetHead).
void placeOn(RgbImage& sheet, const RgbImage& picture, int x) {
  for (int j = 0; j < picture.height; ++j)
    std::copy_n(picture.pixel(0, j), std::size_t{3} * picture.width, sheet.pixel(x, kSheetHead + j));
}

/// Writes a title above a picture, in white.
void writeOn(RgbImage& sheet, int x, int width, const std::string& text) {
  IndexImage strip{width, kSheetHead, 0};
  Painter{strip}.text(4, 16, beginningOf(text, width - 8), 1);
  for (int j = 0; j < strip.height; ++j)
    for (int i = 0; i < width; ++i)
      if (strip.row(j)[i] != 0) std::fill_n(sheet.pixel(x + i, j), 3, std::uint8_t{255});
}

/// A frame around [low, high], three pixels outside of it.
void frameOn(RgbImage& sheet, int x, int width, int height, std::array<int, 4> box) {
  const int left = std::max(0, box[0] - 3), top = std::max(0, box[1] - 3);
  const int right = std::min(width - 1, box[2] + 3), bottom = std::min(height - 1, box[3] + 3);
  const auto dot = [&](int i, int j) { std::ranges::copy(kFrame, sheet.pixel(x + i, kSheetHead + j)); };
  for (int i = left; i <= right; ++i) dot(i, top), dot(i, bottom);
  for (int j = top; j <= bottom; ++j) dot(left, j), dot(right, j);
}

}  // namespace

std::string diagnosisSheet(Diagnoser& diagnoser, const HandedIn& handed, const Diagnosis& d) {
  const PictureSettings& settings = diagnoser.picture().settings();
  const int w = settings.width, h = settings.height;
  const Hypothesis& right = hypotheses().front();
  const bool named = !d.found.empty();
  std::vector<std::pair<std::string, RgbImage>> pictures{
      {"yours", handed.picture}, {"right", diagnoser.pictureBy(diagnoser.approachWith(right))}};
  if (named && d.found.front().first != &right)
    pictures.emplace_back("with " + nameOf(d.found.front()),
                          diagnoser.pictureBy(diagnoser.approachOf(d.found.front())));
  std::array<int, 4> box{w, h, -1, -1};
  if (d.pixel) {
    const SnappedScene& scene = diagnoser.picture().snapped();
    box = {d.pixel->i, d.pixel->j, d.pixel->i, d.pixel->j};
    for (const SnappedFace& face : scene.faces)
      for (int k = 0; k < face.count && face.number == d.pixel->face; ++k) {
        const glm::ivec3 p = scene.vertices[face.first + k] / kGrid;
        box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x), std::max(box[3], p.y)};
      }
  }
  int width = 0, height = 0;
  for (const auto& [name, picture] : pictures)
    width += picture.width + kSheetGap, height = std::max(height, picture.height);
  RgbImage sheet{width - kSheetGap, height + kSheetHead};
  int x = 0;
  for (const auto& [name, picture] : pictures) {
    placeOn(sheet, picture, x);
    writeOn(sheet, x, picture.width, name);
    if (d.pixel && picture.width == w && picture.height == h) frameOn(sheet, x, w, h, box);
    x += picture.width + kSheetGap;
  }
  return encodePng(sheet);
}

}  // namespace xnewell
