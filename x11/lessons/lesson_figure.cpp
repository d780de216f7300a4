#include "x11/lessons/lesson_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "depthsort/record/explain.h"
#include "depthsort/record/replay.h"
#include "shading/laboratory/errors.h"
#include "shading/laboratory/profile.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/wording.h"
#include "x11/lessons/lesson_page.h"
#include "x11/scanline/scanline_page.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_wording.h"
#include "x11/viewing/outside_view.h"
#include "x11/viewing/viewing_page.h"
#include "x11/views/plot.h"

namespace xnewell {

namespace {

constexpr int kDisc = 10;  ///< radius of the plate of a letter

constexpr int kNameWidth = 92;  ///< pixels for names at the left of bars and profiles

/// What the parts of the left side of a lesson are drawn with.
struct FigurePen : Pen {
  const FigureLayout& at;
  const DrawnFigure& drawn;

  [[nodiscard]] int right() const { return at.below.x + at.below.width; }
  /// Draws a rule and a name at the top of the area below the picture. Returns the baseline of its first
  /// line.
  int section(std::string_view name);
  void plate(int x, int y, std::string_view letter, Cell ground, Cell ink, int radius = kDisc);
  /// Words over a picture.
  void line(const Rect& on, std::string_view words);
};

int FigurePen::section(std::string_view name) {
  rule(at.below.x, at.below.y, at.below.width);
  caps(at.below.x, at.below.y + 17, name);
  return at.below.y + (at.compact ? 35 : 39);
}

void FigurePen::plate(int x, int y, std::string_view letter, Cell ground, Cell ink, int radius) {
  paint.disc(x, y, radius, (*this)(ground));
  bold(x - textWidth(letter) / 2, y + 5, letter, ink);
}

void FigurePen::line(const Rect& on, std::string_view words) {
  paint.within(on).text(on.x + 10, on.y + 18, words, (*this)(Cell::WellText));
}

/// ---- The colour cells, the rows of intensities, the filled face

/// What these z-extents say about an order.
std::string remarkOn(const std::vector<Range>& extents) {
  int same = 0, overlap = 0, pairs = 0;
  for (std::size_t p = 0; p < extents.size(); ++p)
    for (std::size_t q = 0; q < p; ++q) {
      const Range &P = extents[p], &Q = extents[q];
      const double close = 0.02 * std::max(P.high - P.low, Q.high - Q.low);
      same += std::abs(P.low - Q.low) <= close && std::abs(P.high - Q.high) <= close;
      overlap += std::max(P.low, Q.low) <= std::min(P.high, Q.high);
      ++pairs;
    }
  if (pairs == 0) return "";
  if (same == pairs) return "The extents are the same: z alone cannot say which is farthest.";
  if (overlap == 0) return "No two extents overlap: z alone says which goes first.";
  return overlap == pairs ? "All extents overlap: z alone cannot say which goes first."
                          : "Where two extents overlap, z alone cannot say which goes first.";
}

void drawExtents(FigurePen& pen) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const SnappedScene& snapped = pen.drawn.picture.snapped();
  std::vector<Range> extents(pen.drawn.figure.names.size(), {kNone, -kNone});
  Range all{kNone, -kNone};
  const auto take = [](Range& r, double z) { r = {std::min(r.low, z), std::max(r.high, z)}; };
  for (const SnappedFace& face : snapped.faces)
    for (int corner = face.first; corner < face.first + face.count; ++corner) {
      const int z = snapped.vertices[corner].z;
      take(all, z);
      for (std::size_t k = 0; k < extents.size(); ++k)
        if (pen.drawn.figure.names[k].face == face.number) take(extents[k], z);
    }
  int y = pen.section("z-extents");
  const int left = pen.at.below.x + kNameWidth, width = pen.right() - left;
  pen.soft(left, pen.at.below.y + 17, "far");
  pen.softRight(pen.right(), pen.at.below.y + 17, "near");
  const int pitch = pen.at.compact ? 21 : 22;
  const double span = std::max(1.0, all.high - all.low), margin = 0.06 * span;
  const auto place = [&](double z) {
    return left + static_cast<int>(std::lround((z - all.low + margin) / (span + 2 * margin) * width));
  };
  for (std::size_t k = 0; k < extents.size(); ++k, y += pitch) {
    pen.plate(pen.at.below.x + 9, y - 5, pen.drawn.figure.names[k].name, Cell::Ink, Cell::White, 8);
    pen.paint.fillRect({left, y - 9, width, 9}, pen(Cell::Rule));
    if (extents[k].low > extents[k].high) continue;
    const int from = place(extents[k].low);
    pen.paint.fillRect({from, y - 9, std::max(3, place(extents[k].high) - from), 9}, pen(Cell::Soft));
  }
  pen.softRight(pen.right(), y, remarkOn(extents));
}

void drawCurves(FigurePen& pen) {
  const DrawnFigure& drawn = pen.drawn;
  const Rect& below = pen.at.below;
  pen.section("what the cells hold");
  const CellRange cells = sceneCells(drawn.picture);
  const int half = (below.width - 16) / 2, top = below.y + 34, height = below.height - 34 - kPlotBelow;
  const int nameRoom = kPlotRight;
  const auto area = [&](int x) { return Rect{x + kPlotLeft, top, half - kPlotLeft - nameRoom, height}; };
  const int second = below.x + half + 16;
  pen.softRight(below.x + half, below.y + 17, "of 255");
  pen.caps(second, below.y + 17, "step to the next");
  pen.paint.textRight(pen.right(), below.y + 17, pen.at.compact ? "%" : "per cent brighter", pen(Cell::Soft));

  drawPlot(pen.paint, drawn.plan, area(below.x),
           {.cells = cells,
            .ticks = {0, 64, 128, 192, 255},
            .curves = storedCurves(drawn.picture, drawn.palette)});
  drawPlot(pen.paint, drawn.plan, area(second),
           {.cells = cells,
            .ticks = {0.1, 1, 10, 100},
            .logarithmic = true,
            .curves = stepCurves(drawn.picture, drawn.palette),
            .level = kSeenStep,
            .levelName = "the eye"});
}

/// Draws, for each method and exactly under the columns of the picture, the row as a strip and its intensity.
void drawProfiles(FigurePen& pen) {
  const DrawnFigure& drawn = pen.drawn;
  const Rect &below = pen.at.below, &at = pen.at.picture;
  const int row = defaultScanline(drawn.picture), unit = pen.paint.unit();
  Painter fine = pen.paint.pixels();
  const Scanline line = scanlineOf(drawn.picture, row, pen(Cell::Well));

  const int marked = at.y + row / unit;
  pen.paint.line(at.x, marked, at.x + at.width - 1, marked, pen(Cell::White), {1, 4, 4});
  pen.section("row " + std::to_string(row) + " of the picture");
  if (!pen.at.compact)
    pen.softRight(pen.right(), below.y + 17, "the strip repeats the row, the curve is its intensity");
  const int block = (below.height - 24) / 3, strip = block * 2 / 5, curve = block - strip - 4;
  for (int k = 0; k < 3; ++k) {
    const Profile& profile = line.profiles[k];
    const int top = below.y + 24 + k * block;
    drawStrip(pen.paint, {at.x, top, at.width, strip}, profile.cells);
    pen.paint.fillRect({at.x, top + strip, at.width, curve}, pen(Cell::Panel));
    const int left = at.x * unit, base = (top + strip + curve - 2) * unit;
    int last = -1;
    for (int i = 0; i < at.width * unit; ++i) {
      if (std::isnan(profile.I[i])) {
        last = -1;
        continue;
      }
      const int y = base - static_cast<int>(std::lround(profile.I[i] * (curve - 4) * unit));
      fine.line(left + std::max(0, i - (last >= 0)), last >= 0 ? last : y, left + i, y, pen(Cell::Ink));
      last = y;
    }
    const std::string name{rowOf(profile.method).label};
    pen.paint.fillRect({at.x + 4, top + 3, textWidth(name) + 8, 15}, pen(Cell::Paper));
    pen.bold(at.x + 8, top + 14, name);
  }
}

/// ---- A step of the depth sort

/// Draws all tests of a pair, with numbers if they were made. Returns the next baseline.
int drawTests(FigurePen& pen, const Explainer& explainer, const Event& e, int y) {
  constexpr int kAsks = 44, kNumbers = 324;  // pixels from the left
  const int x = pen.at.below.x, pitch = pen.at.compact ? 15 : 16;
  const std::vector<Test> made = explainer.testsMade(e);
  for (const TestRow& row : kTestRows) {
    if (row.id == Test::SamePlane) continue;
    const bool reached = std::ranges::find(made, row.id) != made.end();
    const bool settles = reached && row.id == made.back();
    if (settles && e.verdict != Verdict::Crossing)
      pen.paint.tick(x + 2, y - 8, pen(Cell::Good));
    else if (reached)
      pen.paint.cross(x + 2, y - 8, pen(Cell::Alarm));
    const Cell ink = !reached ? Cell::Faint : settles ? Cell::Ink : Cell::Soft;
    pen.paint.text(x + 20, y, row.name, pen(ink));
    pen.paint.text(x + kAsks, y, row.asks, pen(ink), settles ? Voice::Bold : Voice::Plain);
    if (reached)
      pen.paint.text(x + kNumbers, y, numbersThatFit(explainer, e, row.id, pen.right() - x - kNumbers),
                     pen(ink));
    y += pitch;
  }
  return y;
}

/// Draws the list of polygons that are not painted yet, in the order in which they are taken, with their
/// z-extents to scale.
void drawList(FigurePen& pen, const Explainer& explainer, const Event& e, int y) {
  const SortedScene& run = *pen.drawn.run;
  const int bottom = pen.at.below.y + pen.at.below.height, pitch = 16;
  Replay replay{pen.drawn.picture.snapped(), run};
  replay.goTo(pen.drawn.step);
  const std::vector<Replay::Listed> list = replay.list(std::max(0, (bottom - y) / pitch));
  Range all = explainer.zExtent(e.P);
  for (int face = 0; face < static_cast<int>(pen.drawn.picture.snapped().faces.size()); ++face) {
    const Range z = explainer.zExtent(face);
    all = {std::min(all.low, z.low), std::max(all.high, z.high)};
  }
  const int x = pen.at.below.x, left = x + kNameWidth + 44, width = pen.right() - left;
  const auto place = [&](double z) {
    return left + static_cast<int>(std::lround((z - all.low) / std::max(1e-9, all.high - all.low) * width));
  };
  pen.caps(x, y, "the list");
  pen.soft(left, y, "far");
  pen.softRight(pen.right(), y, "near");
  for (const auto& [id, marked] : list) {
    if ((y += pitch) > bottom) break;
    if (marked) pen.paint.triangle(x + 2, y - 8, 5, Direction::Right, pen(Cell::Ink));
    const int end = pen.ink(x + 16, y, explainer.name(id));
    if (marked) pen.soft(end + 8, y, "marked");
    const Range z = explainer.zExtent(id);
    pen.paint.fillRect({left, y - 8, width, 7}, pen(Cell::Rule));
    pen.paint.fillRect({place(z.low), y - 8, std::max(3, place(z.high) - place(z.low)), 7},
                       pen(id == e.P   ? Cell::P
                           : id == e.Q ? Cell::Q
                                       : Cell::Soft));
  }
}

void drawRun(FigurePen& pen) {
  const DrawnFigure& drawn = pen.drawn;
  const Rect& at = pen.at.picture;
  const SortedScene& run = *drawn.run;
  Frames frames{drawn.picture, run, true, {drawn.step}, drawn.plan, pen.paint.unit()};
  pen.paint.within(at).place(frames.at(drawn.step), at.x, at.y);

  const Event& e = run.events[drawn.step - 1];
  const Explainer explainer{drawn.picture.scene().mesh, drawn.picture.snapped(), run, true};
  int splits = 0;
  for (int k = 0; k + 1 < drawn.step; ++k) splits += run.events[k].kind == Event::Kind::Split;
  const int x = pen.at.below.x;
  int y = pen.section("step " + std::to_string(drawn.step) + " of " + std::to_string(run.events.size()));
  int name = pen.paint.textRight(pen.right(), pen.at.below.y + 17, explainer.name(e.P), pen(Cell::Ink));
  const auto legend = [&](Cell cell, std::string_view letter, int before) {
    const int swatch = pen.softRight(before - 6, pen.at.below.y + 17, letter) - 16;
    pen.paint.fillRect({swatch, pen.at.below.y + 8, 10, 10}, pen(cell));
    pen.paint.frame({swatch, pen.at.below.y + 8, 10, 10}, pen(Cell::Ink));
    return swatch - 16;
  };
  if (e.Q >= 0) {
    pen.paint.fillRect({name, pen.at.below.y + 5, pen.right() - name, 16}, pen(Cell::Paper));
    name = pen.paint.textRight(pen.right(), pen.at.below.y + 17, explainer.name(e.Q), pen(Cell::Ink));
    const int before = legend(Cell::Q, "Q", name);
    name = pen.paint.textRight(before, pen.at.below.y + 17, explainer.name(e.P), pen(Cell::Ink));
  }
  legend(Cell::P, "P", name);
  if (e.kind == Event::Kind::Compare) y = drawTests(pen, explainer, e, y) + 3;
  for (const std::string& line : broken(explainer.sentence(e, splits), pen.at.below.width / 6)) {
    pen.ink(x, y, line);
    y += 15;
  }
  if (e.kind != Event::Kind::Compare) drawList(pen, explainer, e, y + 8);
}

void drawFilling(FigurePen& pen) {
  const StepFigure& figure = pen.drawn.figure;
  if (figure.names.empty()) return;
  const auto run = scanlineOfFace(pen.drawn.picture, figure.names.front().face, figure.stepBits);
  if (!run || run->steps() == 0) return;
  // A step in the second half of a row, so that the charts have something to show.
  int step = static_cast<int>(figure.filled * run->steps());
  if (step > 0) {
    const ScanSample& at = run->samples()[static_cast<std::size_t>(step - 1)];
    const ScanSpan& span = run->spanOf(at);
    step = std::min(run->steps(), step + std::max(0, span.from + (span.to - span.from) * 2 / 3 - at.column));
  }
  // Its outline in the picture.
  Painter inside = pen.paint.within(pen.at.picture);
  for (const ScanPart& part : run->parts())
    for (std::size_t k = 0; k < part.outline.size(); ++k) {
      const auto place = [&](std::size_t v) {
        const glm::ivec3& p = part.outline[v % part.outline.size()];
        return glm::ivec2{pen.at.picture.x + p.x / kGrid / pen.paint.unit(),
                          pen.at.picture.y + p.y / kGrid / pen.paint.unit()};
      };
      inside.line(place(k).x, place(k).y, place(k + 1).x, place(k + 1).y, pen(Cell::White));
    }
  const int first = pen.section("face " + figure.names.front().name + ", pixel by pixel");
  pen.softRight(pen.right(), first - 22, std::to_string(figure.stepBits) + " bits after the point");
  drawScanlineFigure(
      pen,
      {pen.at.below.x, first - 8, pen.at.below.width, pen.at.below.height - (first - 8 - pen.at.below.y)},
      *run, step);
}

/// ---- A stage of the viewing transformation

void drawViewing(FigurePen& pen) {
  const StepFigure& figure = pen.drawn.figure;
  const ViewingStory story{pen.drawn.picture, figure.vertex};
  const LitParts lit{pen.drawn.picture, pen.drawn.palette, &story.stages, figure.shadedIn};
  const StagePoints points{pen.drawn.picture.scene().mesh, story.stages};
  StageImages images;
  OutsideView view{.picture = pen.drawn.picture,
                   .lit = lit,
                   .story = story,
                   .points = points,
                   .images = images,
                   .stage = figure.viewStage,
                   .programs = figure.shadedIn == ViewStage::World};
  (void)drawStage(pen, pen.at.picture, view);

  // The picture, and the angles in the world and at the stage. Where the picture's light is not computed, the
  // box has no I: that may be what the step asks.
  constexpr int kGap = 14, kName = 18, kLeastBox = 148;
  const Rect& below = pen.at.below;
  const int boxes = std::min(170, std::max(kLeastBox, (below.width - 2 * kGap) / 3 - 10));
  const Rect small{below.x, below.y, below.width - 2 * (boxes + kGap), below.height - kName};
  view.stage = ViewStage::Viewport;
  drawSmallStage(pen, small, view);
  const std::string light =
      figure.shadedIn == ViewStage::World ? "" : ", lit at " + std::string{rowOf(figure.shadedIn).name};
  pen.soft(small.x, below.y + below.height - 4, "the picture" + light);
  int x = small.x + small.width + kGap;
  for (const ViewStage stage :
       {ViewStage::World, figure.viewStage == ViewStage::World ? ViewStage::Vrc : figure.viewStage}) {
    drawAngle(pen, {x, below.y, boxes, std::min(84, below.height - kName)}, story, stage,
              stage == ViewStage::World || stage == figure.shadedIn);
    x += boxes + kGap;
  }
}

void markWrong(FigurePen& pen) {
  const Rect &at = pen.at.picture, all = at * pen.paint.unit();
  Painter fine = pen.paint.pixels();
  const std::vector<SampleCheck> checked = checkedSamples(pen.drawn.picture);
  std::int64_t wrong = 0, samples = 0;
  for (int j = 0; j < all.height; ++j)
    for (int i = 0; i < all.width; ++i) {
      const SampleCheck sample = checked[std::size_t(j) * all.width + i];
      samples += sample != SampleCheck::Nothing;
      if (!isWrong(sample)) continue;
      ++wrong;
      fine.point(all.x + i, all.y + j, pen(Cell::Q));
    }
  const std::string words = wrong == 0 ? "no sample shows a wrong face"
                                       : grouped(wrong) + " of " + grouped(samples) + " samples of " +
                                             sizeText(all.width, all.height) + " show a wrong face";
  const int baseline = at.y + at.height - 9;
  if (wrong > 0) {
    pen.paint.fillRect({at.x + 10, baseline - 10, 11, 11}, pen(Cell::Q));
    pen.paint.frame({at.x + 10, baseline - 10, 11, 11}, pen(Cell::Black));
  }
  pen.paint.text(at.x + (wrong > 0 ? 28 : 10), baseline, words, pen(Cell::WellText));
}

void drawNames(FigurePen& pen) {
  const int unit = pen.paint.unit();
  const Rect &at = pen.at.picture, all = at * unit;
  const std::vector<std::uint32_t> faces = pen.drawn.picture.faceImage();
  for (const NamedFace& named : pen.drawn.figure.names)
    if (const auto place = placeOfLetter(faces, all.width, all.height, named.face, unit))
      pen.plate(at.x + place->x / unit, at.y + place->y / unit, named.name, Cell::White, Cell::Ink);
}

void drawDifference(FigurePen& pen) {
  const DrawnFigure& drawn = pen.drawn;
  int differing = 0;
  for (std::size_t k = 0; k < drawn.image.pixels.size(); ++k)
    differing += drawn.image.pixels[k] != drawn.lower->pixels[k];
  const int y = pen.at.below.y + 13;
  pen.paint.text(pen.at.below.x, y,
                 differing == 0
                     ? "Both pictures are the same."
                     : grouped(differing) + " of " + grouped(drawn.image.pixels.size()) + " samples differ.",
                 pen(Cell::Ink));
}

}  // namespace

Rect figureAreaOf(const Layout& window) {
  const int aboveBars = window.body.height - (window.compact ? 2 : 12);  // of the strip
  return {window.body.x, window.body.y, window.body.width - kLessonColumn - kMargin, aboveBars};
}

FigureLayout layoutOfFigure(const Rect& area, const StepFigure& figure, bool compact) {
  FigureLayout at{.picture = area, .lower = {}, .below = {}, .compact = compact};
  int height = 0;
  if (figure.extents) height = 44 + (compact ? 21 : 22) * static_cast<int>(figure.names.size());
  if (figure.stage == View::DepthSort) height = compact ? 194 : 206;
  if (figure.stage == View::Colors) height = compact ? 170 : 236;
  if (figure.stage == View::MachBands) height = compact ? 230 : 330;
  if (figure.stage == View::SideBySide) height = 18;
  if (figure.stage == View::Scanline) height = area.height * 6 / 10;
  if (figure.stage == View::Viewing) height = compact ? 110 : 150;
  if (height > 0) {
    constexpr int kGap = 14;
    at.below = {area.x, area.y + area.height - height, area.width, height};
    at.picture.height -= height + kGap;
  }
  if (figure.stage == View::SideBySide) {
    constexpr int kGap = 8;
    const int half = (at.picture.height - kGap) / 2;
    at.picture.height = half;
    at.lower = {area.x, area.y + half + kGap, area.width, half};
  }
  return at;
}

std::optional<LetterPlace> placeOfLetter(const std::vector<std::uint32_t>& faces, int width, int height,
                                         int face, int unit) {
  const int enough = (kDisc + 4) * unit;  // more space than this is not needed
  // The distance of each sample from other faces, in steps to the eight neighbours.
  std::vector<int> room(faces.size(), 0);
  const auto at = [&](int i, int j) {
    return i < 0 || j < 0 || i >= width || j >= height ? 0 : room[std::size_t(j) * width + i];
  };
  const auto pass = [&](int i, int j, int back) {
    int& here = room[std::size_t(j) * width + i];
    const int least = std::min({at(i - back, j), at(i - 1, j - back), at(i, j - back), at(i + 1, j - back)});
    here = std::min(here, least + 1);
  };
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (faces[k] == static_cast<std::uint32_t>(face) + 1) room[k] = enough;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) pass(i, j, 1);
  for (int j = height - 1; j >= 0; --j)
    for (int i = width - 1; i >= 0; --i) pass(i, j, -1);
  std::optional<LetterPlace> best;
  int most = 0;
  std::int64_t farthest = -1;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const std::int64_t x = 2 * i - width, y = 2 * j - height, away = x * x + y * y;
      if (const int r = at(i, j); r > most || (r == most && r > 0 && away > farthest))
        most = r, farthest = away, best = LetterPlace{i, j};
    }
  return best;
}

std::unique_ptr<ScanlineRun> scanlineOfFace(const Picture& picture, int number, int bits) {
  const auto& faces = picture.snapped().faces;
  const auto face = std::ranges::find(faces, number, &SnappedFace::number);
  if (face == faces.end() || channelsOf(picture.colors().plan()) == Channels::Rgb) return nullptr;
  return std::make_unique<ScanlineRun>(picture, static_cast<int>(face - faces.begin()), bits);
}

void drawFigure(Painter paint, const FigureLayout& at, const DrawnFigure& drawn) {
  FigurePen pen{{paint, drawn.plan}, at, drawn};
  const StepFigure& figure = drawn.figure;
  if (figure.stage == View::DepthSort && drawn.run)
    drawRun(pen);
  else if (figure.stage == View::Viewing)
    drawViewing(pen);
  else
    pen.paint.within(at.picture).place(drawn.image, at.picture.x, at.picture.y);
  if (figure.stage == View::Viewing) return pen.line(at.picture, figure.line);
  if (figure.wrongMarked && figure.stage != View::DepthSort) markWrong(pen);
  if (figure.named && !figure.names.empty() && figure.stage != View::DepthSort) drawNames(pen);
  if (figure.extents) drawExtents(pen);
  if (figure.stage == View::Colors) drawCurves(pen);
  if (figure.stage == View::MachBands) drawProfiles(pen);
  if (figure.stage == View::Scanline) drawFilling(pen);
  if (figure.stage == View::SideBySide && drawn.lower) {
    pen.paint.within(at.lower).place(*drawn.lower, at.lower.x, at.lower.y);
    pen.line(at.lower, figure.lowerLine);
    drawDifference(pen);
  }
  pen.line(at.picture, figure.stage == View::SideBySide ? figure.upperLine : figure.line);
}

}  // namespace xnewell
