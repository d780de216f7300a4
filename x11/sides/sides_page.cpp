#include "x11/sides/sides_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/views.h"
#include "x11/window/layout.h"

namespace xnewell {

namespace {

constexpr int kCaption = 24;                      // the height of a caption above a picture
constexpr int kBelowPictures = 14;                // pixels from the pictures to the sections below
constexpr int kSection = 28;                      // the line and the name of a section
constexpr int kLower = 262, kLowerCompact = 222;  // the least height for table and finding
constexpr int kMostMagnified = 8;

/// Draws the parts of the page, one function each.
class SidesDrawing {
 public:
  SidesDrawing(Painter paint, const SidesLayout& at, const SidesPage& page, const CellPlan& plan)
      : pen_{paint, plan}, at_{at}, page_{page} {}

  void drawSide(char letter, const Rect& caption, const Rect& picture);
  void drawDifference();
  /// Returns the finding and the table in words.
  std::vector<std::string> drawNumbers();

 private:
  /// A part of the pictures as they are shown, in pixels of the window.
  [[nodiscard]] Rect shown(const Rect& part) const {
    const double scale = 1.0 * at_.A.width * pen_.paint.unit() / page_.A.width;
    const auto at = [&](int along) { return static_cast<int>(scale * along); };
    return {at(part.x), at(part.y), at(part.width), at(part.height)};
  }
  /// Draws a frame around the place, in a picture at `area` that is shown from `first` on, in units.
  void drawFrame(const Rect& area, int first);
  int drawKinds(int x, int baseline);
  void drawLegend(const Rect& at);
  /// Draws the place in both pictures, sample by sample, if there is room.
  void drawLoupe(const Rect& at);
  /// Where the difference that is shown begins, in units, so that the place is in the middle.
  [[nodiscard]] int firstRow() const;

  Pen pen_;
  const SidesLayout& at_;
  const SidesPage& page_;
};

void SidesDrawing::drawFrame(const Rect& area, int first) {
  if (!page_.place) return;
  Painter paint = pen_.paint.within(area).pixels();
  const int unit = paint.unit(), x = area.x * unit, y = (area.y - first) * unit;
  const Rect f = shown(page_.place->frame);
  for (const auto& [out, cell] : {std::pair{2 * unit, Cell::Black}, {unit, Cell::White}})
    paint.frame({x + f.x - out, y + f.y - out, f.width + 2 * out, f.height + 2 * out}, pen_(cell));
}

void SidesDrawing::drawSide(char letter, const Rect& caption, const Rect& picture) {
  const bool B = letter == 'B' || page_.blinking;
  const char shown = B ? 'B' : 'A';
  if (page_.focus == letter) {
    pen_.paint.fillRect({caption.x, caption.y, caption.width, 18}, pen_(Cell::Focus));
    pen_.paint.fillRect({caption.x - 6, caption.y, 2, 18}, pen_(Cell::Ink));
  }
  const int y = caption.y + 12, end = caption.x + caption.width;
  if (page_.focus)
    pen_.key(caption.x + 1, y - 11, std::string_view{&shown, 1});
  else
    pen_.bold(caption.x + 5, y, std::string_view{&shown, 1});
  int x = caption.x + 24;
  if (B && letter == 'A') x = pen_.paint.text(x, y, "in A's place", pen_(Cell::Alarm), Voice::Bold) + 12;
  bool first = true, differed = false;
  for (const Phrase& phrase : (B ? page_.ofB : page_.ofA).made) {
    // Settings that differ come first, apart from the others.
    const std::string_view gap = first ? "" : differed && !phrase.differs ? "  " : ", ";
    if (x + textWidth(gap) + textWidth(phrase.text) + 1 > end) break;
    const Voice voice = phrase.differs ? Voice::Bold : Voice::Plain;
    x = pen_.paint.text(x, y, gap, pen_(phrase.differs ? Cell::Ink : Cell::Soft), voice);
    x = pen_.paint.text(x, y, phrase.text, pen_(phrase.differs ? Cell::Ink : Cell::Soft), voice);
    first = false, differed = phrase.differs;
  }
  pen_.paint.fit(B ? page_.B : page_.A, picture);
  drawFrame(picture, 0);
}

int SidesDrawing::firstRow() const {
  const int height = at_.difference.height, spare = at_.A.height - height;
  if (!page_.place) return spare / 2;
  const Rect f = shown(page_.place->frame);
  return std::clamp((f.y + f.height / 2) / pen_.paint.unit() - height / 2, 0, spare);
}

int SidesDrawing::drawKinds(int x, int y) {
  if (page_.focus) x += pen_.key(x, y - 11, "f") + 8;
  for (const UnlikeRow& row : kUnlikes) {
    const bool chosen = row.id == page_.unlike.kind;
    if (!page_.focus && !chosen) continue;
    if (chosen) {
      const Rect box{x - 5, y - 13, textWidth(row.name) + 11, 18};
      pen_.paint.fillRect(box, pen_(Cell::White));
      pen_.paint.frame(box, pen_(Cell::Ink));
    }
    x = pen_.paint.text(x, y, row.name, pen_(chosen ? Cell::Ink : Cell::Soft),
                        chosen ? Voice::Bold : Voice::Plain) +
        12;
  }
  return x;
}

void SidesDrawing::drawLegend(const Rect& at) {
  const UnlikeRow& kind = rowOf(page_.unlike.kind);
  const std::array faces{LegendStep{Cell::Q, kind.differs}, LegendStep{Cell::WellLine, kind.same}};
  const bool twofold = kind.id == Unlike::Face;
  drawStepLegend(pen_.paint.within(at), pen_.plan, at.x + 8, at.y + 8,
                 twofold ? std::span<const LegendStep>{faces} : kDoublingSteps, kind.times);
}

void SidesDrawing::drawDifference() {
  const int y = at_.sections.y, x = at_.sections.x;
  pen_.rule(x, y, at_.sections.width);
  const int kinds = pen_.caps(x, y + 17, "DIFFERENCE") + 14;
  const int end = drawKinds(kinds, y + 17);
  const Difference& u = page_.unlike;
  const double share =
      u.errors.count == 0 ? 0.0 : 100.0 * static_cast<double>(u.above) / static_cast<double>(u.errors.count);
  const std::string percent = fixed(share, 2) + " %",
                    all = grouped(u.above) + " of " + counted(u.errors.count, "sample") + ", " + percent;
  const int headEnd = x + at_.captionA.width;
  const std::string& told = end + textWidth(all) + 4 <= headEnd ? all : percent;
  pen_.boldRight(headEnd - 1, y + 17, told);

  const int first = firstRow();
  pen_.paint.within(at_.difference)
      .fit(stepsImage(u, pen_.plan), {x, at_.difference.y - first, at_.A.width, at_.A.height});
  drawFrame(at_.difference, first);
  drawLegend(at_.difference);
  // Words on a dark ground at the foot of the panel, at the left or at the right.
  const int base = at_.difference.y + at_.difference.height - 8;
  const auto foot = [&](int left, const std::string& words) {
    pen_.paint.fillRect({left - 4, base - 12, textWidth(words) + 8, 16}, pen_(Cell::Well));
    pen_.paint.text(left, base, words, pen_(Cell::WellText));
  };
  const auto row = [&](int down) { return std::to_string(down * page_.A.height / at_.A.height); };
  if (at_.difference.height < at_.A.height)
    foot(x + 8, "rows " + row(first) + " to " + row(first + at_.difference.height) + " of " +
                    std::to_string(page_.A.height));
  if (!page_.place) return;
  const std::string which = "place " + std::to_string(page_.number + 1) + " of " +
                            std::to_string(page_.places) + ": " + counted(page_.place->samples, "sample");
  foot(at_.difference.x + at_.difference.width - textWidth(which) - 8, which);
}

std::string signedDifference(std::int64_t a, std::int64_t b) {
  return (a < b ? "-" : "") + grouped(std::abs(a - b));
}

std::vector<std::string> SidesDrawing::drawNumbers() {
  const Rect& at = at_.numbers;
  Sheet sheet{at.width, at.height, pen_.plan, pen_.paint.unit()};
  const std::vector<int> ends{at.width * 61 / 100, at.width * 80 / 100, at.width};
  sheet.section(0, 0, at.width, "numbers");
  for (const auto& [k, name] : {std::pair{0, "A"}, {1, "B"}, {2, "A - B"}})
    sheet.painter().textRight(ends[k] - 1, 17, name, pen_.plan[Cell::Soft], Voice::Bold);
  int y = kSection - 3;
  const SideFacts &a = page_.ofA, &b = page_.ofB;
  const Cell cell = page_.known ? Cell::Ink : Cell::Faint;
  const Voice voice = Voice::Plain;
  const bool measured = a.time.runs > 0;
  bool ready = measured;
  const auto row = [&](const std::string& label, std::string ofA, std::string ofB, std::string apart,
                       bool alarm = false) {
    if (!ready) ofA = ofB = "...", apart.clear();
    sheet.tableRow(0, y, label, {std::move(ofA), std::move(ofB)}, ends, cell, voice);
    y = sheet.tableRow(0, y, "", {std::move(apart)}, {ends[2]}, alarm && page_.known ? Cell::Alarm : cell,
                       Voice::Bold);
  };
  const auto count = [&](const std::string& label, std::int64_t ofA, std::int64_t ofB, bool alarm = false) {
    row(label, grouped(ofA), grouped(ofB), signedDifference(ofA, ofB), alarm && ofA != ofB);
  };
  const auto amount = [&](const std::string& label, double ofA, double ofB, int decimals, bool alike,
                          const std::string& otherwise = "") {
    const double unit = std::pow(10.0, decimals);  // subtracts the rounded numbers that are shown
    const double apart = (std::round(ofA * unit) - std::round(ofB * unit)) / unit;
    row(label, fixed(ofA, decimals), fixed(ofB, decimals), alike ? fixed(apart + 0.0, decimals) : otherwise);
  };
  const bool alike = a.errors.kind == b.errors.kind;
  const int decimals = alike ? rowOf(a.errors.kind).decimals : 2;
  count("wrong face, of " + sizeText(page_.A.width, page_.A.height), a.errors.wrongFaces, b.errors.wrongFaces,
        true);
  amount("largest error", a.errors.errors.largest, b.errors.errors.largest, decimals, alike);
  const bool colors = alike && a.errors.kind == Unlike::Color;
  amount(colors ? "root mean square, CIEDE2000" : "root mean square error", a.errors.errors.rootMeanSquare,
         b.errors.errors.rootMeanSquare, decimals, alike);
  ready = true;
  count("polygons painted", a.painted, b.painted);
  count("cuts", a.cuts, b.cuts);
  ready = measured;
  amount(
      "time, ms, best of " + std::to_string(std::max(1, std::min(page_.ofA.time.runs, page_.ofB.time.runs))),
      page_.ofA.time.ms, page_.ofB.time.ms, std::min(page_.ofA.time.ms, page_.ofB.time.ms) < 1 ? 3 : 1,
      !isDoubtful(page_.ofA.time, page_.ofB.time), "in doubt");

  const bool pairs = !page_.pairs.empty() && !at_.compact;
  const int room = at.height - (pairs ? 20 : 0);
  if (page_.known) {
    Finding finding = page_.finding;
    const auto fits = [&] {
      return y + 6 + Sheet::findingHeight(at.width, finding.bold, finding.why) <= room;
    };
    if (!fits()) finding.why.clear();
    if (fits()) {
      const int top = y + 6;
      y = sheet.finding(0, top, at.width, finding.bold, finding.why);
      if (a.errors.wrongFaces != b.errors.wrongFaces)
        sheet.painter().fillRect({0, top, 3, y - top}, pen_.plan[Cell::Alarm]);
    }
  }
  if (!page_.colors.empty() && y + 6 + Sheet::paragraphHeight(at.width, page_.colors) <= room)
    y = sheet.paragraph(0, y + 6, at.width, page_.colors, Cell::Soft);
  pen_.paint.place(sheet.image(), at.x, at.y);
  pen_.paint.note(sheet.writing(), at.x, at.y);
  drawLoupe({at.x, at.y + y + 12, at.width, room - y - 24});
  if (!pairs) return sheet.report();
  const int baseline = at.y + at.height - 4;
  const int cap = pen_.key(at.x, baseline - 11, "g");
  pen_.soft(at.x + cap + 6, baseline, page_.pairs);
  return sheet.report();
}

void SidesDrawing::drawLoupe(const Rect& at) {
  if (!page_.place) return;
  const Rect& f = page_.place->frame;
  Painter paint = pen_.paint.pixels();
  const int unit = paint.unit();
  const int half = (at.width - Sheet::kGutter) / 2 * unit, high = (at.height - Sheet::kLine) * unit;
  const int scale = std::min({half / f.width, 2 * high / f.height, kMostMagnified});
  if (scale < 2) return;
  // Shows at least half of the frame, around its middle.
  const int rows = std::min(f.height, high / scale), first = f.y + (f.height - rows) / 2;
  const int top = (at.y + Sheet::kLine) * unit;
  int x = at.x * unit;
  for (const auto& [image, name] : {std::pair{&page_.A, "A"}, {&page_.B, "B"}}) {
    pen_.soft(x / unit, at.y + Sheet::kAscent - 2,
              std::string{name} + " in the frame, " + std::to_string(scale) + " x");
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < f.width; ++i)
        paint.fillRect({x + i * scale, top + j * scale, scale, scale}, image->row(first + j)[f.x + i]);
    x += half + Sheet::kGutter * unit;
  }
}

}  // namespace

SidesLayout layoutOfSides(const Rect& body) {
  SidesLayout at;
  at.compact = body.height < kCompactBelow;
  const int column = (body.width - Sheet::kGutter) / 2, right = body.x + body.width - column;
  const int free = body.height - kCaption - kBelowPictures;
  // The lower part gets its least height, and the pictures the rest.
  const int height = std::min(free - (at.compact ? kLowerCompact : kLower), column * 2 / 3);
  at.captionA = {body.x, body.y, column, kCaption};
  at.captionB = {right, body.y, column, kCaption};
  at.A = framed({body.x, body.y + kCaption, column, height});
  at.A.x = body.x;
  at.B = at.A, at.B.x = right;
  const int sections = body.y + kCaption + height + kBelowPictures, left = body.y + body.height - sections;
  at.sections = {body.x, sections, body.width, kSection};
  at.difference = {at.A.x, sections + kSection, at.A.width, std::min(at.A.height, left - kSection)};
  at.numbers = {right, sections, column, left};
  at.frameWidth = std::max(24, column / 10);
  at.frameHeight = std::max(24, height / 4);
  return at;
}

std::string sidesStatus(const PictureSettings& A, const PictureSettings& B) {
  const std::vector<std::string> what = differencesOf(A, B);
  const auto differs = [&](std::string_view name) { return std::ranges::find(what, name) != what.end(); };
  std::string text = "same scene, same view";
  if (!differs("light") && !differs("L") && !differs("V")) text += ", same light";
  if (what.empty()) return text + "   nothing differs";
  text += what.size() == 1 ? "   only the " : "   the ";
  for (std::size_t k = 0; k < what.size(); ++k) {
    if (k == 3 && what.size() > 4) {
      text += " and " + std::to_string(what.size() - k) + " more";
      break;
    }
    text += (k == 0 ? "" : k + 1 == what.size() ? " and " : ", ") + what[k];
  }
  const bool plural = what.size() > 1 || what[0].ends_with('s');  // "shades"
  return text + (plural ? " differ" : " differs");
}

std::vector<std::string> drawSidesPage(Painter paint, const SidesLayout& at, const SidesPage& page,
                                       const CellPlan& plan) {
  SidesDrawing draws{paint, at, page, plan};
  draws.drawSide('A', at.captionA, at.A);
  draws.drawSide('B', at.captionB, at.B);
  draws.drawDifference();
  return draws.drawNumbers();
}

}  // namespace xnewell
