#include "x11/viewing/viewing_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// Where the columns of the table end: in a table of 656 units, and in a narrow one of 432.
struct Columns {
  std::array<int, 4> place;
  std::array<int, 3> N;
  int NdotL, I;
};
constexpr Columns kWide{{138, 206, 274, 320}, {393, 459, 525}, 571, 615};
constexpr Columns kNarrow{{105, 153, 207, 245}, {282, 318, 354}, 393, 431};

std::string nameWithNumber(ViewStage stage) {
  return std::to_string(static_cast<int>(stage) + 1) + ' ' + std::string{rowOf(stage).name};
}

/// A section's hairline with its name and a softer text at the right. Returns the next baseline.
int section(Pen& pen, int x, int y, int width, std::string_view name, std::string_view aside) {
  pen.rule(x, y, width);
  const int end = pen.caps(x, y + 14, name);
  pen.softRight(x + width, y + 14, beginningOf(std::string{aside}, x + width - end - 12));
  return y + 30;
}

class StageTable {
 public:
  StageTable(Pen& pen, const ViewingLayout& at, const ViewingPage& page)
      : pen_{pen}, at_{at}, story_{page.view.story}, page_{page} {}

  std::array<Rect, kViewStages.size()> draw() {
    const ViewingStory& s = story_;
    const std::string face = "face " + std::to_string(s.vertex.face);
    const std::string part = partOf(page_.view.picture.scene(), s.vertex);
    const std::string which =
        (part == face ? face : face + ", " + part) + ", corner " + std::to_string(s.vertex.corner + 1);
    int y = section(pen_, at_.table.x, at_.table.y, at_.table.width, "a vertex and its plane",
                    at_.narrow ? which : which + "; click another, or press g");
    if (at_.narrow) y -= 2;
    for (const auto& [edge, name] : {std::pair{columns().place[0], "x"},
                                     {columns().place[1], "y"},
                                     {columns().place[2], "z"},
                                     {columns().place[3], "w"},
                                     {columns().N[0], "Nx"},
                                     {columns().N[1], "Ny"},
                                     {columns().N[2], "Nz"},
                                     {columns().NdotL, "N.L"},
                                     {columns().I, "I"}})
      pen_.softRight(column(edge), y, name);
    pen_.soft(at_.table.x, y, "stage");
    if (!at_.narrow && s.world().cell) pen_.soft(column(columns().I) + 17, y, "cell");
    std::array<Rect, kViewStages.size()> rows{};
    for (const ViewStageRow& row : kViewStages) {
      y += at_.pitch;
      const Rect place{at_.table.x - 4, y - 11, at_.table.width + 8, at_.pitch - 1};
      rows[static_cast<std::size_t>(row.id)] = place;
      if (row.id == page_.view.stage) pen_.paint.fillRect(place, pen_(Cell::White));
      drawRow(row.id, y);
    }
    return rows;
  }

 private:
  [[nodiscard]] const Columns& columns() const { return at_.narrow ? kNarrow : kWide; }
  [[nodiscard]] int column(int edge) const {
    return at_.table.x + edge * std::min(at_.table.width, 960) / (at_.narrow ? 432 : 656);
  }

  void drawRow(ViewStage stage, int y) {
    const Voice voice = stage == page_.view.stage ? Voice::Bold : Voice::Plain;
    pen_.paint.text(at_.table.x, y, at_.narrow ? std::string{rowOf(stage).name} : nameWithNumber(stage),
                    pen_(Cell::Ink), voice);
    const int words = at_.table.x + (at_.narrow ? 62 : 104), room = at_.table.x + at_.table.width - words;
    if (stage == ViewStage::Clipped) {
      const bool whole = story_.cut == 0 && !story_.faceGone;
      pen_.paint.text(words, y, beginningOf(clippedWords(story_), room),
                      pen_(whole ? Cell::Soft : Cell::Ink));
      return;
    }
    const VertexAtStage& here = story_.of(stage);
    if (stage == ViewStage::Snapped && !story_.snapped) {
      pen_.soft(words, y, beginningOf(snappedWords(story_), room));
      return;
    }
    glm::dvec4 p = shownAt(story_, stage, lengthUnit(page_.view.picture.scene()));
    if (stage == ViewStage::Snapped) {
      const glm::dvec3 steps{*story_.snapped};
      p = {steps / double{kGrid}, 1.0};
      p.z = std::ldexp(p.z, story_.zShift);
    }
    const int decimals = at_.narrow ? 3 : 4;
    const int numbers = stage == ViewStage::Snapped ? 3 : 4;
    for (int k = 0; k < numbers; ++k) {
      const bool one = k == 3 && p[k] == 1.0;
      pen_.paint.textRight(column(columns().place[static_cast<std::size_t>(k)]), y,
                           one ? "1"
                               : fitted(p[k], decimals,
                                        k == 3       ? (at_.narrow ? 5 : 7)
                                        : at_.narrow ? 7
                                                     : 10),
                           pen_(Cell::Ink), voice);
    }
    if (stage == ViewStage::Snapped) {
      pen_.soft(column(columns().place[2]) + 16, y,
                beginningOf(
                    at_.narrow ? "whole steps of 1/65,536 pixel" : "whole steps; plane " + planeWords(story_),
                    at_.table.x + at_.table.width - column(columns().place[2]) - 16));
      return;
    }
    for (int k = 0; k < 3; ++k)
      pen_.paint.textRight(column(columns().N[static_cast<std::size_t>(k)]), y,
                           fixed(here.N[k], at_.narrow ? 2 : 4), pen_(Cell::Ink), voice);
    pen_.paint.textRight(column(columns().NdotL), y, here.NdotL ? fixed(*here.NdotL, decimals) : "-",
                         pen_(story_.differsInNdotL(stage) ? Cell::Alarm : Cell::Ink), Voice::Bold);
    pen_.paint.textRight(column(columns().I), y, fixed(here.I, decimals),
                         pen_(story_.differsInI(stage) ? Cell::Alarm : Cell::Ink), Voice::Bold);
    if (at_.narrow || !here.cell) return;
    const Rect swatch{column(columns().I) + 19, y - 9, 22, 10};
    pen_.paint.fillRect(swatch, static_cast<std::uint8_t>(*here.cell));
    pen_.paint.frame(swatch, pen_(Cell::Ink));
  }

  Pen& pen_;
  const ViewingLayout& at_;
  const ViewingStory& story_;
  const ViewingPage& page_;
};

/// Brackets around four numbers in a column.
void bracket(Pen& pen, int x, int top, int bottom, bool opens) {
  pen.paint.vline(x, top, bottom - top, pen(Cell::Soft));
  for (const int y : {top, bottom - 1}) pen.paint.hline(opens ? x : x - 3, y, 4, pen(Cell::Soft));
}

void entry(Pen& pen, int right, int y, double v, bool bold) {
  const bool plain = v == 0.0 || v == 1.0;
  pen.paint.textRight(right, y, plain ? fixed(v, 0) : fitted(v, 3, 7), pen(plain ? Cell::Soft : Cell::Ink),
                      bold && !plain ? Voice::Bold : Voice::Plain);
}

/// Lines in place of a matrix.
std::vector<std::string> withoutMatrix(const ViewingStory& story, ViewStage stage) {
  if (stage == ViewStage::Clipped)
    return {"Clipping is no matrix. It cuts polygons at", "the front plane, at the back plane, and 8,192",
            "pixels from the picture's corner. The sides", "of the window cut nothing: filling does that."};
  if (!story.snapped) return {"Rounding is no matrix.", "This vertex is cut off before it."};
  std::vector<std::string> lines{"Rounding is no matrix. In steps of the grid:"};
  const glm::dvec4 p = story.of(ViewStage::Viewport).at;
  for (int k = 0; k < 3; ++k) {
    const double steps = p[k] * (k < 2 ? double{kGrid} : std::ldexp(double{kGrid}, -story.zShift));
    lines.push_back(std::string{"xyz"[k]} + "  " + fitted(p[k], 4, 10) + " px = " + fitted(steps, 2, 14) +
                    ", so " + grouped((*story.snapped)[k]));
  }
  return lines;
}

int drawMatrix(Pen& pen, const ViewingLayout& at, const ViewingPage& page, int y) {
  const ViewStage stage = page.view.stage;
  const ViewingStory& story = page.view.story;
  const int x = at.column.x, lines = at.narrow ? 13 : 16;
  const bool none =
      (stage == ViewStage::Clipped || stage == ViewStage::Snapped) && page.matrix == ShownMatrix::ThisStage;
  if (none) {
    for (const std::string& line : withoutMatrix(story, stage)) pen.ink(x, y, line), y += lines;
    return y;
  }
  const MatrixWithVertex m = matrixOf(story, stage, page.matrix, lengthUnit(page.view.picture.scene()));
  const int top = y - 12, bottom = y + 3 * lines + 5;
  const auto brackets = [&](int from, int to) {
    bracket(pen, x + from, top, bottom, true), bracket(pen, x + to, top, bottom, false);
  };
  brackets(0, 200), brackets(205, 256), brackets(266, 319);
  pen.soft(x + 258, y + 3 * lines / 2, "=");
  for (int row = 0; row < 4; ++row, y += lines) {
    for (int k = 0; k < 4; ++k) entry(pen, x + 50 + 49 * k - (k == 3 ? 1 : 0), y, m.matrix[k][row], true);
    entry(pen, x + 253, y, m.from[row], false);
    entry(pen, x + 316, y, m.to[row], true);
  }
  return y;
}

void drawFinding(Pen& pen, const Rect& box, const ViewingFinding& finding, int pitch) {
  if (box.height < 2 * pitch) return;
  pen.paint.fillRect(box, pen(Cell::White));
  pen.paint.fillRect({box.x, box.y, 4, box.height}, pen(finding.keeps ? Cell::Good : Cell::Alarm));
  int y = box.y + pitch - 2;
  const int room = box.width - 18, end = box.y + box.height;
  for (const std::string& line : broken(finding.heading, room / 6)) {
    pen.bold(box.x + 12, y, line);
    y += pitch;
  }
  std::vector<std::string> lines = broken(finding.why, room / 6);
  for (std::size_t k = 0; k < lines.size() && y + 3 <= end; ++k, y += pitch) {
    const bool last = y + pitch + 3 > end && k + 1 < lines.size();
    pen.ink(box.x + 12, y, last ? beginningOf(lines[k] + ' ' + lines[k + 1], room) : lines[k]);
  }
}

}  // namespace

void drawAngle(Pen& pen, const Rect& box, const ViewingStory& story, ViewStage stage, bool lit) {
  pen.paint.fillRect(box, pen(Cell::White));
  pen.paint.frame(box, pen(Cell::Rule));
  const VertexAtStage& here = story.of(stage);
  const bool wrong = lit && (story.differsInNdotL(stage) || story.differsInI(stage));
  const Cell cell = wrong ? Cell::Alarm : Cell::Ink;
  const int right = box.x + box.width - 7, pitch = (box.height - 8) / 4;
  int y = box.y + pitch;
  pen.boldRight(right, y, rowOf(stage).name);
  Painter paint = pen.paint.within(box);
  // An L below the surface needs room there.
  const double below = here.NdotL ? std::clamp(-*here.NdotL, 0.0, 1.0) : 0.0;
  constexpr int kLetter = 13;
  const int cx = box.x + 58, foot = below > 0 ? kLetter : 0,
            reach = std::min(44, static_cast<int>((box.height - 26 - foot) / (1 + below))),
            cy = box.y + box.height - 9 - foot - static_cast<int>(reach * below);
  paint.hline(cx - 40, cy, 74, pen(Cell::Faint));
  const auto arrow = [&](double angle, std::string_view name, Cell as) {
    const double dx = -std::sin(angle), dy = -std::cos(angle);
    const auto at = [](double v) { return static_cast<int>(std::lround(v)); };
    const int tx = at(cx + reach * dx), ty = at(cy + reach * dy);
    paint.line(cx, cy, tx, ty, pen(as), {.thickness = name == "N" ? 2 : 1});
    for (const double side : {-1.0, 1.0})
      paint.line(tx, ty, at(tx - 6 * dx + side * 3 * dy), at(ty - 6 * dy - side * 3 * dx), pen(as));
    paint.text(std::clamp(at(tx + 8 * dx) - 3, box.x + 3, right - 60),
               std::clamp(at(ty + 7 * dy) + 4, box.y + 12, box.y + box.height - 4), name, pen(as),
               Voice::Bold);
  };
  if (here.N != glm::dvec3{0.0}) arrow(0.0, "N", Cell::Ink);
  if (here.NdotL) {
    const double angle = std::acos(std::clamp(*here.NdotL, -1.0, 1.0));
    arrow(angle, "L", cell);
    paint.textRight(right, y += pitch, fixed(angle * 57.29577951308232, 1) + "\u00B0", pen(Cell::Soft));
  } else {
    paint.textRight(right, y += pitch, here.equation.lights.empty() ? "no L" : "no N", pen(Cell::Soft));
  }
  if (!lit) return;
  paint.textRight(right, y += pitch, "I " + fixed(here.I, 3), pen(cell), Voice::Bold);
  if (!here.cell) return;
  paint.textRight(right - 26, y += pitch, std::to_string(*here.cell), pen(Cell::Soft));
  const Rect swatch{right - 22, y - 9, 22, 10};
  paint.fillRect(swatch, static_cast<std::uint8_t>(*here.cell));
  paint.frame(swatch, pen(Cell::Ink));
}

ViewingLayout layoutOfViewing(const Layout& at) {
  ViewingLayout layout;
  const Rect& body = at.body;
  const int left = at.controls.x - kMargin - body.x;
  layout.narrow = left < 600;
  layout.pitch = at.low ? 13 : at.compact ? 14 : 16;
  layout.rowPitch = at.low ? 17 : at.compact ? 18 : 22;
  layout.box = at.low ? 62 : at.compact ? 70 : 84;
  layout.column = {at.controls.x, body.y, kControls, body.height};
  constexpr int kGap = 16;
  const int stages = static_cast<int>(kViewStages.size());
  const int width = (left - (stages - 1) * kGap) / stages;
  const int height = std::min(width * 3 / 4, body.height / 9), name = at.low ? 14 : 18;
  const int table = 30 + (stages + 1) * layout.pitch - 8, gap = at.low ? 6 : 14;
  layout.outside = {body.x, body.y, left, body.height - table - gap - height - name - gap};
  const int y = layout.outside.y + layout.outside.height + gap;
  for (int k = 0; k < stages; ++k)
    layout.small[static_cast<std::size_t>(k)] = {body.x + k * (width + kGap), y, width, height};
  layout.table = {body.x, y + height + name + gap - (at.low ? 4 : 6), left, table};
  return layout;
}

std::array<Rect, kViewStages.size()> drawStageTable(Pen& pen, const ViewingLayout& at,
                                                    const ViewingPage& page) {
  return StageTable{pen, at, page}.draw();
}

int matrixRow(const ViewingLayout& at, int y) { return y + (at.narrow ? 16 : 30); }

void drawMatrixAndLight(Pen& pen, const ViewingLayout& at, const ViewingPage& page, int baseline) {
  const ViewStage stage = page.view.stage;
  const ViewingStory& story = page.view.story;
  const int x = at.column.x, width = at.column.width;
  std::string letters{story.stages.letters(stage)};
  if (page.matrix == ShownMatrix::AllSoFar) letters = "from the world to " + std::string{rowOf(stage).name};
  if (page.matrix == ShownMatrix::ToTheScreen)
    letters = "from " + std::string{rowOf(stage).name} + " to pixels, before / w";
  section(pen, x, baseline - (at.narrow ? 29 : 35), width,
          "matrix " + std::to_string(static_cast<int>(stage) + 1), letters);
  int y = drawMatrix(pen, at, page, baseline + (at.narrow ? 17 : 22));
  const bool lit = rowOf(page.view.picture.settings().shading).lit;
  y = section(pen, x, y - (at.narrow ? 7 : 6), width, "shading",
              lit ? "N and L at the true angle" : "the picture itself uses no light") -
      (at.narrow ? 11 : 8);
  const int half = (width - 16) / 2;
  drawAngle(pen, {x, y, half, at.box}, story, ViewStage::World);
  const ViewStage beside = stage == ViewStage::World ? ViewStage::Vrc : stage;
  drawAngle(pen, {x + half + 16, y, half, at.box}, story, beside);
  y += at.box + (at.narrow ? 6 : 10);
  const int pitch = at.pitch, end = at.column.y + at.column.height;
  const ViewingFinding finding = findingOf(story, stage);
  const int lines = static_cast<int>(broken(finding.heading, (width - 18) / 6).size() +
                                     broken(finding.why, (width - 18) / 6).size());
  drawFinding(pen, {x, y, width, std::min(end - y, lines * pitch + 8)}, finding, pitch);
}

std::vector<std::string> inWords(const ViewingPage& page) {
  const ViewingStory& story = page.view.story;
  const double unit = lengthUnit(page.view.picture.scene());
  std::vector<std::string> lines{stageTitle(story, page.view.stage)};
  for (const ViewStageRow& row : kViewStages) {
    std::string line = nameWithNumber(row.id);
    line.resize(12, ' ');
    if (row.id == ViewStage::Clipped || row.id == ViewStage::Snapped) {
      lines.push_back(line + (row.id == ViewStage::Clipped ? clippedWords(story) : snappedWords(story)));
      continue;
    }
    const VertexAtStage& here = story.of(row.id);
    const glm::dvec4 p = shownAt(story, row.id, unit);
    line += "at";
    for (int k = 0; k < 4; ++k) line += ' ' + fitted(p[k], 4, 11);
    line += "; N";
    for (int k = 0; k < 3; ++k) line += ' ' + fixed(here.N[k], 4);
    lines.push_back(line + "; N.L " + (here.NdotL ? fixed(*here.NdotL, 4) : "-") + ", I " + fixed(here.I, 4));
  }
  const ViewingFinding finding = findingOf(story, page.view.stage);
  lines.push_back(finding.heading + ' ' + finding.why);
  return lines;
}

}  // namespace xnewell
