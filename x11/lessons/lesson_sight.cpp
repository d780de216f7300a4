#include "x11/lessons/lesson_sight.h"
#include "x11/lessons/lesson_page.h"

#include <algorithm>

#include "shading/laboratory/exactness.h"
#include "x11/drawing/wording.h"
#include "x11/lessons/sight_pen.h"

namespace xnewell {

int SightPen::section(std::string_view name) {
  rule(at.below.x, at.below.y, at.below.width);
  caps(at.below.x, at.below.y + 17, name);
  return at.below.y + (at.compact ? 35 : 39);
}

void SightPen::plate(int x, int y, std::string_view letter, Cell ground, Cell ink, int radius) {
  paint.disc(x, y, radius, (*this)(ground));
  bold(x - textWidth(letter) / 2, y + 5, letter, ink);
}

void SightPen::line(const Rect& on, std::string_view words) {
  paint.within(on).text(on.x + 10, on.y + 18, words, (*this)(Cell::WellText));
}

namespace {

void markWrong(SightPen& pen) {
  const Rect &at = pen.at.picture, all = at * pen.paint.unit();
  Painter fine = pen.paint.pixels();
  const std::vector<SampleCheck> checked = checkedSamples(pen.sight.picture);
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

void drawNames(SightPen& pen) {
  const int unit = pen.paint.unit();
  const Rect &at = pen.at.picture, all = at * unit;
  const std::vector<std::uint32_t> faces = pen.sight.picture.faceImage();
  for (const NamedFace& named : pen.sight.exhibit.names)
    if (const auto place = placeOfLetter(faces, all.width, all.height, named.face, unit))
      pen.plate(at.x + place->x / unit, at.y + place->y / unit, named.name, Cell::White, Cell::Ink);
}

void drawDifference(SightPen& pen) {
  const Sight& sight = pen.sight;
  int differing = 0;
  for (std::size_t k = 0; k < sight.image.pixels.size(); ++k)
    differing += sight.image.pixels[k] != sight.lower->pixels[k];
  const int y = pen.at.below.y + 13;
  pen.paint.text(pen.at.below.x, y,
                 differing == 0
                     ? "Both pictures are the same."
                     : grouped(differing) + " of " + grouped(sight.image.pixels.size()) + " samples differ.",
                 pen(Cell::Ink));
}

}  // namespace

Rect sightOf(const Layout& window) {
  const int aboveBars = window.body.height - (window.compact ? 2 : 12);  // of the strip
  return {window.body.x, window.body.y, window.body.width - kLessonColumn - kMargin, aboveBars};
}

SightLayout layoutOfSight(const Rect& area, const Exhibit& exhibit, bool compact) {
  SightLayout at{.picture = area, .lower = {}, .below = {}, .compact = compact};
  int height = 0;
  if (exhibit.extents) height = 44 + (compact ? 21 : 22) * static_cast<int>(exhibit.names.size());
  if (exhibit.stage == Stage::DepthSort) height = compact ? 194 : 206;
  if (exhibit.stage == Stage::Colors) height = compact ? 170 : 236;
  if (exhibit.stage == Stage::MachBands) height = compact ? 230 : 330;
  if (exhibit.stage == Stage::SideBySide) height = 18;
  if (exhibit.stage == Stage::Scanline) height = area.height * 6 / 10;
  if (exhibit.stage == Stage::Viewing) height = compact ? 110 : 150;
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

void drawSight(Painter paint, const SightLayout& at, const Sight& sight) {
  SightPen pen{{paint, sight.plan}, at, sight};
  const Exhibit& exhibit = sight.exhibit;
  if (exhibit.stage == Stage::DepthSort && sight.run)
    drawRun(pen);
  else if (exhibit.stage == Stage::Viewing)
    drawViewing(pen);
  else
    pen.paint.within(at.picture).place(sight.image, at.picture.x, at.picture.y);
  if (exhibit.stage == Stage::Viewing) return pen.line(at.picture, exhibit.line);
  if (exhibit.wrongMarked && exhibit.stage != Stage::DepthSort) markWrong(pen);
  if (exhibit.named && !exhibit.names.empty() && exhibit.stage != Stage::DepthSort) drawNames(pen);
  if (exhibit.extents) drawExtents(pen);
  if (exhibit.stage == Stage::Colors) drawCurves(pen);
  if (exhibit.stage == Stage::MachBands) drawProfiles(pen);
  if (exhibit.stage == Stage::Scanline) drawFilling(pen);
  if (exhibit.stage == Stage::SideBySide && sight.lower) {
    pen.paint.within(at.lower).place(*sight.lower, at.lower.x, at.lower.y);
    pen.line(at.lower, exhibit.lowerLine);
    drawDifference(pen);
  }
  pen.line(at.picture, exhibit.stage == Stage::SideBySide ? exhibit.upperLine : exhibit.line);
}

}  // namespace xnewell
