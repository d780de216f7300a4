#include "x11/views/exactness_view.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <string>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// The verdict that a map marks: wrong if a sample is wrong, otherwise doubtful.
bool (*markedIn(const std::vector<SampleCheck>& verdicts))(SampleCheck) {
  if (std::ranges::any_of(verdicts, isWrong)) return isWrong;
  return [](SampleCheck verdict) { return verdict == SampleCheck::Doubtful; };
}

Cell cellOf(SampleCheck verdict) {
  return kVerdictSteps[isWrong(verdict) ? 2 : static_cast<std::size_t>(verdict) - 1].cell;
}

/// Makes `to` large enough for `part` too.
void add(Rect& to, const Rect& part) {
  if (to.empty()) {
    to = part;
    return;
  }
  const int right = std::max(to.x + to.width, part.x + part.width),
            bottom = std::max(to.y + to.height, part.y + part.height);
  to.x = std::min(to.x, part.x), to.y = std::min(to.y, part.y);
  to.width = right - to.x, to.height = bottom - to.y;
}

}  // namespace

IndexImage verdictImage(const std::vector<SampleCheck>& verdicts, int width, const CellPlan& plan) {
  IndexImage image{width, static_cast<int>(verdicts.size()) / width, plan[Cell::Well]};
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    if (verdicts[k] != SampleCheck::Nothing) image.pixels[k] = plan[cellOf(verdicts[k])];
  return image;
}

std::vector<Rect> spotsOf(const std::vector<SampleCheck>& verdicts, int width) {
  const auto isMarked = markedIn(verdicts);
  const int height = static_cast<int>(verdicts.size()) / width;
  const int across = (width + kSpotBlock - 1) / kSpotBlock, down = (height + kSpotBlock - 1) / kSpotBlock;
  std::vector<Rect> blocks(std::size_t(across) * down);  // each around its marked samples
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      if (isMarked(verdicts[std::size_t(j) * width + i]))
        add(blocks[std::size_t(j / kSpotBlock) * across + i / kSpotBlock], {i, j, 1, 1});
  std::vector<Rect> spots;
  std::vector<glm::ivec2> next;
  const auto take = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= across || j >= down) return;
    Rect& block = blocks[std::size_t(j) * across + i];
    if (block.empty()) return;
    add(spots.back(), block);
    block = {};
    next.emplace_back(i, j);
  };
  for (int first = 0; first < across * down; ++first) {
    if (blocks[first].empty()) continue;
    spots.emplace_back();
    take(first % across, first / across);
    while (!next.empty()) {
      const glm::ivec2 at = next.back();
      next.pop_back();
      for (int j = at.y - 1; j <= at.y + 1; ++j)
        for (int i = at.x - 1; i <= at.x + 1; ++i) take(i, j);
    }
  }
  return spots;
}

void ringSpots(Painter painter, int x, int y, const std::vector<SampleCheck>& verdicts, int width,
               const CellPlan& plan) {
  constexpr int kGap = 6;  // between a spot and its ring
  const int unit = painter.unit();
  painter = painter.pixels();
  const int most = static_cast<int>(verdicts.size()) / width / 4;
  for (const Rect& spot : spotsOf(verdicts, width)) {
    if (std::max(spot.width, spot.height) > most) continue;
    const int i = x * unit + spot.x + spot.width / 2, j = y * unit + spot.y + spot.height / 2,
              radius = kGap + static_cast<int>(std::ceil(std::hypot(spot.width, spot.height) / 2 / unit));
    painter.ring(i, j, radius, plan[Cell::White]);
    painter.ring(i, j, radius + 1, plan[Cell::White]);
    painter.ring(i, j, radius + 2, plan[Cell::Black]);
  }
}

Finding findingOf(const Exactness& e, const PictureSettings& of) {
  if (e.samples == 0) return {"Nothing shows.", ""};
  const std::string culled = of.cull == Cull::Keep ? "" : " Only the faces that culling left are compared.";
  const std::string doubtful =
      e.doubtful == 0 ? ""
                      : "At " + counted(e.doubtful, "sample") +
                            " two faces lie so near to each other that the rounding of the file, or of the "
                            "screen grid, may have changed which one is nearer.";
  if (e.wrong > 0) {
    std::string why;
    const auto add = [&](const std::string& sentence) { why += (why.empty() ? "" : " ") + sentence; };
    if (e.wrong > e.earlier)
      add("The oracle, which compares all faces at each sample, sees a nearer one" +
          (e.earlier == 0 ? " there." : " at " + grouped(e.wrong - e.earlier) + " of them."));
    if (e.earlier > 0)
      add((e.earlier == e.wrong ? "There" : "At " + grouped(e.earlier)) +
          " it lies in the plane of the face that should show: of faces in one plane, the later one wins.");
    if (!doubtful.empty()) add(doubtful);
    return {"A wrong face shows at " + grouped(e.wrong) + " of " + counted(e.samples, "sample") + " of " +
                sizeText(of.width, of.height) + ".",
            why + culled};
  }
  if (e.doubtful > 0)
    return {"No face is wrong, but " + counted(e.doubtful, "sample") + " may be.", doubtful + culled};
  return {
      culled.empty() ? "Every sample shows the right face."
                     : "Every sample shows the right one of the faces that culling left.",
      (of.order == Order::Oracle ? "The oracle painted it, and the oracle is the judge."
                                 : "The oracle, which compares all faces at each sample, sees the same.") +
          culled};
}

Lens exactnessLens(const Picture& picture, const CellPlan& plan, const Palette& palette) {
  const std::vector<SampleCheck> verdicts = checkedSamples(picture);
  const Exactness e = exactnessOf(verdicts);
  const PictureSettings& s = picture.settings();
  return {.shown = {verdictImage(verdicts, s.width, plan), palette},
          .finding = findingOf(e, s),
          .steps = {kVerdictSteps.begin(), kVerdictSteps.end()},
          .section = "faces",
          .rows = {{"order", std::string{rowOf(s.order).label}},
                   {"samples that show a face", grouped(e.samples) + " of " + sizeText(s.width, s.height)},
                   {"right", grouped(e.samples - e.doubtful - e.wrong)},
                   {"doubtful", grouped(e.doubtful)},
                   {"wrong", grouped(e.wrong)}},
          .marks = [verdicts, width = s.width, plan](Painter painter, int x, int y) {
            ringSpots(painter, x, y, verdicts, width, plan);
          }};
}

}  // namespace xnewell
