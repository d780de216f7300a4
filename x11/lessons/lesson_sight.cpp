#include "x11/lessons/lesson_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "depthsort/explain.h"
#include "depthsort/replay.h"
#include "shading/picture/exactness.h"
#include "shading/picture/profile.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/wording.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/stepper/frames.h"
#include "x11/views/plot.h"

namespace xnewell {

namespace {

constexpr int kDisc = 10;       // radius of the plate of a letter
constexpr int kNameWidth = 92;  // names at the left of bars and profiles

struct SightDrawing {
  Painter paint;
  const SightLayout& at;
  const Sight& sight;

  [[nodiscard]] std::uint8_t operator()(Cell c) const { return sight.plan[c]; }
  [[nodiscard]] int right() const { return at.below.x + at.below.width; }
  /// Baseline of the first line under the section's name.
  int section(std::string_view name) {
    paint.hline(at.below.x, at.below.y, at.below.width, (*this)(Cell::Rule));
    paint.text(at.below.x, at.below.y + 17, name, (*this)(Cell::Soft), Voice::Caps);
    return at.below.y + (at.compact ? 35 : 39);
  }
  void plate(int x, int y, std::string_view letter, Cell ground, Cell ink, int radius = kDisc) {
    paint.disc(x, y, radius, (*this)(ground));
    paint.text(x - textWidth(letter) / 2, y + 5, letter, (*this)(ink), Voice::Bold);
  }
  void line(const Rect& on, std::string_view words) {
    paint.within(on).text(on.x + 10, on.y + 18, words, (*this)(Cell::WellText));
  }
};

void copyTo(IndexImage& image, const Rect& at, const IndexImage& picture) {
  for (int j = 0; j < at.height; ++j) std::copy_n(picture.row(j), at.width, image.row(at.y + j) + at.x);
}

void markWrong(IndexImage& image, SightDrawing& draws) {
  const Rect& at = draws.at.picture;
  const std::vector<SampleCheck> checked = checkedSamples(draws.sight.picture);
  std::int64_t wrong = 0, samples = 0;
  for (int j = 0; j < at.height; ++j)
    for (int i = 0; i < at.width; ++i) {
      const SampleCheck v = verdicts[std::size_t(j) * at.width + i];
      samples += v != SampleCheck::Nothing;
      if (v != SampleCheck::Wrong) continue;
      ++wrong;
      image.row(at.y + j)[at.x + i] = draws(Cell::Q);
    }
  const std::string words = wrong == 0
                                ? "no sample shows a wrong face"
                                : grouped(wrong) + " of " + grouped(samples) + " samples show a wrong face";
  const int baseline = at.y + at.height - 9;
  if (wrong > 0) {
    draws.paint.fillRect({at.x + 10, baseline - 10, 11, 11}, draws(Cell::Q));
    draws.paint.frame({at.x + 10, baseline - 10, 11, 11}, draws(Cell::Black));
  }
  draws.paint.text(at.x + (wrong > 0 ? 28 : 10), baseline, words, draws(Cell::WellText));
}

void drawNames(SightDrawing& draws) {
  const Rect& at = draws.at.picture;
  const std::vector<std::uint32_t> faces = draws.sight.picture.faceImage();
  for (const NamedFace& named : draws.sight.exhibit.names)
    if (const auto place = placeOfLetter(faces, at.width, at.height, named.face))
      draws.plate(at.x + place->x, at.y + place->y, named.name, Cell::White, Cell::Ink);
}

/// What the z-extents say of an order, true of them as they are.
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

void drawExtents(SightDrawing& draws) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const SnappedScene& snapped = draws.sight.picture.snapped();
  std::vector<Range> extents(draws.sight.exhibit.names.size(), {kNone, -kNone});
  Range all{kNone, -kNone};
  const auto take = [](Range& r, double z) { r = {std::min(r.low, z), std::max(r.high, z)}; };
  for (const SnappedFace& face : snapped.faces)
    for (int corner = face.first; corner < face.first + face.count; ++corner) {
      const int z = snapped.vertices[corner].z;
      take(all, z);
      for (std::size_t k = 0; k < extents.size(); ++k)
        if (draws.sight.exhibit.names[k].face == face.number) take(extents[k], z);
    }
  int y = draws.section("z-extents");
  const int left = draws.at.below.x + kNameWidth, width = draws.right() - left;
  draws.paint.text(left, draws.at.below.y + 17, "far", draws(Cell::Soft));
  draws.paint.textRight(draws.right(), draws.at.below.y + 17, "near", draws(Cell::Soft));
  const int pitch = draws.at.compact ? 21 : 22;
  const double span = std::max(1.0, all.high - all.low), margin = 0.06 * span;
  const auto place = [&](double z) {
    return left + static_cast<int>(std::lround((z - all.low + margin) / (span + 2 * margin) * width));
  };
  for (std::size_t k = 0; k < extents.size(); ++k, y += pitch) {
    draws.plate(draws.at.below.x + 9, y - 5, draws.sight.exhibit.names[k].name, Cell::Ink, Cell::White, 8);
    draws.paint.fillRect({left, y - 9, width, 9}, draws(Cell::Rule));
    if (extents[k].low > extents[k].high) continue;
    const int from = place(extents[k].low);
    draws.paint.fillRect({from, y - 9, std::max(3, place(extents[k].high) - from), 9}, draws(Cell::Soft));
  }
  draws.paint.textRight(draws.right(), y, remarkOn(extents), draws(Cell::Soft));
}

std::string extent(const Range& r) { return fixed(r.low, 0) + " to " + fixed(r.high, 0); }

std::string corners(const CornerCounts& c) {
  return std::to_string(c.inFront) + " in front, " + std::to_string(c.on) + " on, " +
         std::to_string(c.behind) + " behind";
}

/// The numbers that decided.
std::string decidingNumbers(const Explainer& explainer, const Event& e, Test test) {
  switch (test) {
    case Test::SamePlane:
      return "";
    case Test::XExtents:
      return "P " + extent(explainer.xExtent(e.P)) + ", Q " + extent(explainer.xExtent(e.Q));
    case Test::YExtents:
      return "P " + extent(explainer.yExtent(e.P)) + ", Q " + extent(explainer.yExtent(e.Q));
    case Test::PBehindQ:
    case Test::PInFrontOfQ:
      return "P's corners: " + corners(explainer.corners(e.P, e.Q));
    case Test::QInFrontOfP:
    case Test::QBehindP:
      return "Q's corners: " + corners(explainer.corners(e.Q, e.P));
    case Test::Projections: {
      const auto edge = explainer.separatingEdge(e.P, e.Q);
      return !edge ? "no edge parts them" : edge->ofP ? "an edge of P parts them" : "an edge of Q parts them";
    }
    case Test::Overlap:
      return grouped(std::llround(explainer.commonArea(e.P, e.Q).area)) + " square pixels in common";
  }
  return "";
}

/// All tests of a pair, those that were made with their numbers.
int drawTests(SightDrawing& draws, const Explainer& explainer, const Event& e, int y) {
  constexpr int kAsks = 44, kNumbers = 324;  // pixels from the left
  const int x = draws.at.below.x, pitch = draws.at.compact ? 15 : 16;
  const std::vector<Test> made = explainer.testsMade(e);
  for (const TestRow& row : kTestRows) {
    if (row.id == Test::SamePlane) continue;
    const bool reached = std::ranges::find(made, row.id) != made.end();
    const bool settles = reached && row.id == made.back();
    if (settles && e.verdict != Verdict::Crossing)
      draws.paint.tick(x + 2, y - 8, draws(Cell::Good));
    else if (reached)
      draws.paint.cross(x + 2, y - 8, draws(Cell::Alarm));
    const Cell ink = !reached ? Cell::Faint : settles ? Cell::Ink : Cell::Soft;
    draws.paint.text(x + 20, y, row.name, draws(ink));
    draws.paint.text(x + kAsks, y, row.asks, draws(ink), settles ? Voice::Bold : Voice::Plain);
    if (const std::string numbers = reached ? decidingNumbers(explainer, e, row.id) : "";
        x + kNumbers + textWidth(numbers) <= draws.right())
      draws.paint.text(x + kNumbers, y, numbers, draws(ink));
    y += pitch;
  }
  return y;
}

/// What is not painted yet, in the order in which it is taken, with z-extents to scale.
void drawList(SightDrawing& draws, const Explainer& explainer, const Event& e, int y) {
  const SortedScene& run = *draws.sight.run;
  const int bottom = draws.at.below.y + draws.at.below.height, pitch = 16;
  Replay replay{draws.sight.picture.snapped(), run};
  replay.goTo(draws.sight.step);
  const std::vector<Replay::Listed> list = replay.list(std::max(0, (bottom - y) / pitch));
  Range all = explainer.zExtent(e.P);
  for (int face = 0; face < static_cast<int>(draws.sight.picture.snapped().faces.size()); ++face) {
    const Range z = explainer.zExtent(face);
    all = {std::min(all.low, z.low), std::max(all.high, z.high)};
  }
  const int x = draws.at.below.x, left = x + kNameWidth + 44, width = draws.right() - left;
  const auto place = [&](double z) {
    return left + static_cast<int>(std::lround((z - all.low) / std::max(1e-9, all.high - all.low) * width));
  };
  draws.paint.text(x, y, "the list", draws(Cell::Soft), Voice::Caps);
  draws.paint.text(left, y, "far", draws(Cell::Soft));
  draws.paint.textRight(draws.right(), y, "near", draws(Cell::Soft));
  for (const auto& [id, marked] : list) {
    if ((y += pitch) > bottom) break;
    if (marked) draws.paint.triangle(x + 2, y - 8, 5, Direction::Right, draws(Cell::Ink));
    const int end = draws.paint.text(x + 16, y, explainer.name(id), draws(Cell::Ink));
    if (marked) draws.paint.text(end + 8, y, "marked", draws(Cell::Soft));
    const Range z = explainer.zExtent(id);
    draws.paint.fillRect({left, y - 8, width, 7}, draws(Cell::Rule));
    draws.paint.fillRect({place(z.low), y - 8, std::max(3, place(z.high) - place(z.low)), 7},
                         draws(id == e.P   ? Cell::P
                               : id == e.Q ? Cell::Q
                                           : Cell::Soft));
  }
}

void drawRun(IndexImage& image, SightDrawing& draws) {
  const Sight& sight = draws.sight;
  const Rect& at = draws.at.picture;
  const SortedScene& run = *sight.run;
  Frames frames{sight.picture, run, true, {sight.step}, sight.plan};
  copyTo(image, at, frames.at(sight.step));

  const Event& e = run.events[sight.step - 1];
  const Explainer explainer{sight.picture.scene().mesh, sight.picture.snapped(), run, true};
  int splits = 0;
  for (int k = 0; k + 1 < sight.step; ++k) splits += run.events[k].kind == Event::Kind::Split;
  const int x = draws.at.below.x;
  int y = draws.section("step " + std::to_string(sight.step) + " of " + std::to_string(run.events.size()));
  int name =
      draws.paint.textRight(draws.right(), draws.at.below.y + 17, explainer.name(e.P), draws(Cell::Ink));
  const auto legend = [&](Cell cell, std::string_view letter, int before) {
    const int swatch =
        draws.paint.textRight(before - 6, draws.at.below.y + 17, letter, draws(Cell::Soft)) - 16;
    draws.paint.fillRect({swatch, draws.at.below.y + 8, 10, 10}, draws(cell));
    draws.paint.frame({swatch, draws.at.below.y + 8, 10, 10}, draws(Cell::Ink));
    return swatch - 16;
  };
  if (e.Q >= 0) {
    draws.paint.fillRect({name, draws.at.below.y + 5, draws.right() - name, 16}, draws(Cell::Paper));
    name = draws.paint.textRight(draws.right(), draws.at.below.y + 17, explainer.name(e.Q), draws(Cell::Ink));
    const int before = legend(Cell::Q, "Q", name);
    name = draws.paint.textRight(before, draws.at.below.y + 17, explainer.name(e.P), draws(Cell::Ink));
  }
  legend(Cell::P, "P", name);
  if (e.kind == Event::Kind::Compare) y = drawTests(draws, explainer, e, y) + 3;
  for (const std::string& line : broken(explainer.sentence(e, splits), draws.at.below.width / 6)) {
    draws.paint.text(x, y, line, draws(Cell::Ink));
    y += 15;
  }
  if (e.kind != Event::Kind::Compare) drawList(draws, explainer, e, y + 8);
}

void drawCurves(SightDrawing& draws) {
  const Sight& sight = draws.sight;
  const Rect& below = draws.at.below;
  draws.section("what the cells hold");
  const CellRange cells = sceneCells(sight.picture);
  const int half = (below.width - 16) / 2, top = below.y + 34, height = below.height - 34 - kPlotBelow;
  const int nameRoom = kPlotRight;
  const auto area = [&](int x) { return Rect{x + kPlotLeft, top, half - kPlotLeft - nameRoom, height}; };
  const int second = below.x + half + 16;
  draws.paint.textRight(below.x + half, below.y + 17, "of 255", draws(Cell::Soft));
  draws.paint.text(second, below.y + 17, "step to the next", draws(Cell::Soft), Voice::Caps);
  draws.paint.textRight(draws.right(), below.y + 17, draws.at.compact ? "%" : "per cent brighter",
                        draws(Cell::Soft));

  drawPlot(draws.paint, sight.plan, area(below.x),
           {.cells = cells,
            .ticks = {0, 64, 128, 192, 255},
            .curves = storedCurves(sight.picture, sight.palette)});
  drawPlot(draws.paint, sight.plan, area(second),
           {.cells = cells,
            .ticks = {0.1, 1, 10, 100},
            .logarithmic = true,
            .curves = stepCurves(sight.picture, sight.palette),
            .level = kSeenStep,
            .levelName = "the eye"});
}

/// Under the picture's columns, for each method: its row as a strip, and the intensity.
void drawProfiles(IndexImage& image, SightDrawing& draws) {
  const Sight& sight = draws.sight;
  const Rect &below = draws.at.below, &at = draws.at.picture;
  const int row = defaultScanline(sight.picture);
  const Scanline line = scanlineOf(sight.picture, row, draws(Cell::Well));

  draws.paint.line(at.x, at.y + row, at.x + at.width - 1, at.y + row, draws(Cell::White), {1, 4, 4});
  draws.section("row " + std::to_string(row) + " of the picture");
  if (!draws.at.compact)
    draws.paint.textRight(draws.right(), below.y + 17,
                          "the strip repeats the row, the curve is its intensity", draws(Cell::Soft));
  const int block = (below.height - 24) / 3, strip = block * 2 / 5, curve = block - strip - 4;
  for (int k = 0; k < 3; ++k) {
    const Profile& profile = line.profiles[k];
    const int top = below.y + 24 + k * block;
    for (int j = top; j < top + strip; ++j)
      std::copy(profile.cells.begin(), profile.cells.end(), image.row(j) + at.x);
    draws.paint.fillRect({at.x, top + strip, at.width, curve}, draws(Cell::Panel));
    int last = -1;
    for (int i = 0; i < at.width; ++i) {
      if (std::isnan(profile.I[i])) {
        last = -1;
        continue;
      }
      const int y = top + strip + curve - 2 - static_cast<int>(std::lround(profile.I[i] * (curve - 4)));
      draws.paint.line(at.x + std::max(0, i - (last >= 0)), last >= 0 ? last : y, at.x + i, y,
                       draws(Cell::Ink));
      last = y;
    }
    const std::string name{rowOf(profile.method).label};
    draws.paint.fillRect({at.x + 4, top + 3, textWidth(name) + 8, 15}, draws(Cell::Paper));
    draws.paint.text(at.x + 8, top + 14, name, draws(Cell::Ink), Voice::Bold);
  }
}

void drawDifference(SightDrawing& draws) {
  const Sight& sight = draws.sight;
  int differing = 0;
  for (std::size_t k = 0; k < sight.image.pixels.size(); ++k)
    differing += sight.image.pixels[k] != sight.lower->pixels[k];
  const int y = draws.at.below.y + 13;
  draws.paint.text(
      draws.at.below.x, y,
      differing == 0 ? "Both pictures are the same."
                     : grouped(differing) + " of " + grouped(sight.image.pixels.size()) + " samples differ.",
      draws(Cell::Ink));
}

}  // namespace

SightLayout layoutOfSight(const Rect& area, const Exhibit& exhibit, bool compact) {
  SightLayout at{.picture = area, .lower = {}, .below = {}, .compact = compact};
  int height = 0;
  if (exhibit.extents) height = 44 + (compact ? 21 : 22) * static_cast<int>(exhibit.names.size());
  if (exhibit.stage == Stage::DepthSort) height = compact ? 194 : 206;
  if (exhibit.stage == Stage::Colors) height = compact ? 170 : 236;
  if (exhibit.stage == Stage::MachBands) height = compact ? 230 : 330;
  if (exhibit.stage == Stage::SideBySide) height = 18;
  if (height > 0) {
    constexpr int kGap = 14;
    at.below = {area.x, area.y + area.height - height, area.width, height};
    at.picture.height -= height + kGap;
  }
  if (exhibit.stage == Stage::SideBySide) {
    constexpr int kGap = 8;
    const int half = (at.picture.height - kGap) / 2;
    at.picture.height = half;
    at.lower = {area.x, area.y + half + kGap, area.width, half};
  }
  return at;
}

std::optional<LetterPlace> placeOfLetter(const std::vector<std::uint32_t>& faces, int width, int height,
                                         int face) {
  constexpr int kRoom = kDisc + 4;  // more is no better
  // How far each sample is from another face, counted in steps to the eight neighbours.
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
    if (faces[k] == static_cast<std::uint32_t>(face) + 1) room[k] = kRoom;
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

void drawSight(IndexImage& image, const SightLayout& at, const Sight& sight) {
  SightDrawing draws{Painter{image}, at, sight};
  const Exhibit& exhibit = sight.exhibit;
  if (exhibit.stage == Stage::DepthSort && sight.run)
    drawRun(image, draws);
  else
    copyTo(image, at.picture, sight.image);
  if (exhibit.wrongMarked && exhibit.stage != Stage::DepthSort) markWrong(image, draws);
  if (exhibit.named && !exhibit.names.empty() && exhibit.stage != Stage::DepthSort) drawNames(draws);
  if (exhibit.extents) drawExtents(draws);
  if (exhibit.stage == Stage::Colors) drawCurves(draws);
  if (exhibit.stage == Stage::MachBands) drawProfiles(image, draws);
  if (exhibit.stage == Stage::SideBySide && sight.lower) {
    copyTo(image, at.lower, *sight.lower);
    draws.line(at.lower, exhibit.lowerLine);
    drawDifference(draws);
  }
  draws.line(at.picture, exhibit.stage == Stage::SideBySide ? exhibit.upperLine : exhibit.line);
}

}  // namespace xnewell
