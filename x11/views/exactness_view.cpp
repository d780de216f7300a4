#include "x11/views/exactness_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <string>

#include "x11/drawing/wording.h"
#include "x11/views/difference.h"

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

namespace {

constexpr double kHalfAShade = 1.0 / 480;
constexpr int kScaleLeft = 8, kScaleTop = 8, kScaleHigh = 12, kScaleWide = 120;  // units

/// Grays from 0 to 1, blues from -1 to 0. With 120 of each, all fit in the scene's cells.
std::array<std::uint8_t, 3> colorOf(double value, bool isCosine) {
  const int steps = isCosine ? 119 : 239;
  const auto level = [&](double v) { return std::round(std::clamp(v, 0.0, 1.0) * steps) / steps; };
  const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(v)); };
  const double share = level(std::abs(value));
  if (value >= 0.0) return {byte(255 * share), byte(255 * share), byte(255 * share)};
  return {0, byte(90 * share), byte(80 + 175 * share)};
}

/// The values of the legend, from left to right.
double onScale(double share, bool isCosine) { return isCosine ? 2.0 * share - 1.0 : share; }

struct TermColors {
  RgbImage colors;
  std::vector<std::uint8_t> shows;
};

TermColors colorsOf(const TermValues& found, int height, int unit) {
  TermColors made{{found.width, height}, std::vector<std::uint8_t>(found.values.size(), 0)};
  const bool isCosine = rowOf(found.term).isCosine;
  const auto paint = [&](std::size_t k, double value) {
    made.shows[k] = 1;
    std::ranges::copy(colorOf(value, isCosine), &made.colors.rgb[3 * k]);
  };
  for (std::size_t k = 0; k < found.values.size(); ++k)
    if (!std::isnan(found.values[k])) paint(k, found.values[k]);
  const int wide = kScaleWide * unit;
  for (int y = kScaleTop * unit; y < std::min(height, (kScaleTop + kScaleHigh) * unit); ++y)
    for (int x = 0; x < wide && kScaleLeft * unit + x < found.width; ++x)
      paint(static_cast<std::size_t>(y) * found.width + kScaleLeft * unit + x,
            onScale((x + 0.5) / wide, isCosine));
  return made;
}

/// The numbers below the scale.
void drawScaleNumbers(Painter painter, const CellPlan& plan, bool isCosine) {
  const int top = kScaleTop + kScaleHigh, ticks = 4;
  painter.fillRect({kScaleLeft - 2, top, kScaleWide + 20, 15}, plan[Cell::Well]);
  for (int k = 0; k <= ticks; k += isCosine ? 2 : 1) {
    const int x = kScaleLeft + k * (kScaleWide - 1) / ticks;
    painter.vline(x, top, 3, plan[Cell::WellText]);
    const double value = onScale(static_cast<double>(k) / ticks, isCosine);
    const std::string text = value == std::round(value) ? fixed(value, 0) : fixed(value, 2);
    painter.text(std::max(kScaleLeft - 1, x - textWidth(text) / 2), top + 13, text, plan[Cell::WellText]);
  }
}

}  // namespace

TermValues termValuesOf(const Picture& picture, Term term) {
  const PictureSettings& settings = picture.settings();
  TermValues found{.term = term, .width = settings.width};
  if (!hasTerms(settings)) {
    found.values.assign(static_cast<std::size_t>(settings.width) * settings.height, std::nan(""));
    return found;
  }
  found.values = termValues(picture, picture.seen(0, settings.height), term);
  for (const double value : found.values) {
    if (std::isnan(value)) continue;
    found.least = found.samples == 0 ? value : std::min(found.least, value);
    found.most = found.samples == 0 ? value : std::max(found.most, value);
    ++found.samples;
    found.counted += rowOf(term).isCosine ? value > 0.0 : value >= kHalfAShade;
    found.mean += value;
  }
  if (found.samples > 0) found.mean /= static_cast<double>(found.samples);
  return found;
}

std::string termName(Term term, Form form) {
  return std::string{term == Term::Cosine ? cosineName(form) : rowOf(term).name};
}

Finding findingOf(const TermValues& found, const Picture& picture) {
  const PictureSettings& settings = picture.settings();
  const std::string name = termName(found.term, settings.light.form);
  if (!hasTerms(settings))
    return {std::string{rowOf(settings.shading).label} +
                (settings.shading == Shading::Environment ? " looks up sums" : " computes no light") +
                ": there is no " + name + ".",
            "Choose flat, Gouraud or Phong shading."};
  if (found.samples == 0)
    return {picture.shading().lighting().onlyAmbient() ? "All light is ambient: there is no " + name + "."
                                                       : "Nothing shows.",
            ""};
  const double share =
      100.0 * static_cast<double>(found.samples - found.counted) / static_cast<double>(found.samples);
  const std::string least = fixed(found.least, 4), most = fixed(found.most, 4);
  Finding finding{name + (least == most ? " is " + least + " everywhere" : ": " + least + " to " + most), ""};
  if (found.counted < found.samples)
    finding.bold += std::string{rowOf(found.term).isCosine ? "; 0 or less" : "; below half a shade"} +
                    " on " + fixed(share, 1) + " % of the surface";
  finding.bold += '.';
  const std::size_t lights = picture.scene().light.lights.size();
  switch (found.term) {
    case Term::Ambient:
      finding.why =
          "ka Ia, in the surface's colour. It knows no direction, so a shape shows only at its outline.";
      break;
    case Term::Diffuse:
      finding.why = "f Ip kd N.L, the light that a matt surface scatters. It does not depend on the eye.";
      break;
    case Term::Specular:
      finding.why = "f Ip ks (" + termName(Term::Cosine, settings.light.form) +
                    ")^n, the highlight. It moves with the eye.";
      break;
    case Term::NdotL:
      finding.why =
          "The cosine of the angle between N and L. Where it is below 0 the light is behind the "
          "surface, and the equation takes 0.";
      break;
    case Term::Cosine:
      finding.why =
          "The n-th power of this cosine is the highlight. Below 0 it counts as 0, and so it does "
          "where N.L is below 0.";
      break;
  }
  if (rowOf(found.term).isCosine && lights > 1)
    finding.why += " This is the first of " + std::to_string(lights) + " lights.";
  return finding;
}

ColoredImage termImage(const TermValues& found, const Picture& picture, const CellPlan& plan,
                       const Palette& palette, int unit) {
  const PictureSettings& settings = picture.settings();
  const TermColors made = colorsOf(found, settings.height, unit);
  ColoredImage own = inOwnColors(made.colors, made.shows, false, settings, plan, palette);
  drawScaleNumbers({own.image, unit}, plan, rowOf(found.term).isCosine);
  return own;
}

Lens termLens(const Picture& picture, const CellPlan& plan, const Palette& palette, Term term, int unit) {
  const TermValues found = termValuesOf(picture, term);
  const PictureSettings& s = picture.settings();
  return {.shown = termImage(found, picture, plan, palette, unit),
          .finding = findingOf(found, picture),
          .section = termName(term, s.light.form) + ", " + std::string{rowOf(s.shading).label} + " shading",
          .rows = {{"samples that show a face", grouped(found.samples)},
                   {rowOf(term).isCosine ? "above 0" : "half a shade of 240 or more", grouped(found.counted)},
                   {"least and largest", fixed(found.least, 4) + "   " + fixed(found.most, 4)},
                   {"mean", fixed(found.mean, 4)}}};
}

}  // namespace xnewell
