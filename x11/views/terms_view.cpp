#include "x11/views/terms_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/views/own_colors.h"

namespace xnewell {

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
