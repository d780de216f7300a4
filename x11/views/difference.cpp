#include "x11/views/difference.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_precision.hpp>
#include <string>

#include "depthsort/oracle.h"
#include "shading/color/quantize.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/views.h"

namespace xnewell {

namespace {

Difference differenceOf(Unlike kind, std::vector<float> errors, int width) {
  return {errorMap(std::move(errors), width, rowOf(kind).unit), kind};
}

/// The reference in the ramps of the picture. Several hues share the cells by what a picture shows of each,
/// so the reference's own ramps may be others.
void paintInRamps(IndexImage& image, const Picture& picture, const Reference& reference,
                  const Comparison& comparison) {
  const std::vector<Ramp> ramps = picture.colors().ramps();
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const int face = reference.faces()[k];
    if (face == kNothing) continue;
    const glm::dvec3 I = comparison.due(k);
    const int number = reference.picture().snapped().faces[face].number;
    image.pixels[k] =
        ramps[reference.picture().scene().mesh.material[number] + 1].cell(std::max({I.r, I.g, I.b}));
  }
}

/// The reference in the colours of the picture.
void paintInColors(IndexImage& image, const Picture& picture, const Palette& palette,
                   const Reference& reference, const Comparison& comparison) {
  RgbImage bytes{image.width, image.height};
  std::vector<std::uint8_t> shows(image.pixels.size(), 0);
  for (std::size_t k = 0; k < shows.size(); ++k) {
    if (reference.faces()[k] == kNothing) continue;
    shows[k] = 1;
    const Rgb16 color = comparison.dueColor(k);
    bytes.rgb[3 * k] = static_cast<std::uint8_t>(color.r >> 8);
    bytes.rgb[3 * k + 1] = static_cast<std::uint8_t>(color.g >> 8);
    bytes.rgb[3 * k + 2] = static_cast<std::uint8_t>(color.b >> 8);
  }
  std::vector<glm::u8vec3> colors;
  const int first = picture.table().first();
  for (int c = first; c < first + kMaxShades; ++c)
    colors.emplace_back(palette[c].r >> 8, palette[c].g >> 8, palette[c].b >> 8);
  paintNearest(bytes, shows, colors, false, first, image);
}

}  // namespace

Compared comparedWithReference(const Picture& picture, const GroundTruth& truth) {
  const PictureSettings& settings = picture.settings();
  const Palette palette = picture.palette(CellPlan{settings.table.kind});
  const Reference& reference = truth.reference();
  const Comparison comparison{picture, truth, palette};
  Compared result{{settings.width, settings.height, picture.ground()}, {}};
  if (channelsOf(picture.colors().plan()) == Channels::Rgb) {
    result.difference = differenceOf(Unlike::Color, comparison.colorErrors(), settings.width);
    paintInColors(result.reference, picture, palette, reference, comparison);
  } else {
    result.difference =
        differenceOf(Unlike::Intensity, comparison.intensityErrors(TableSide::After), settings.width);
    paintInRamps(result.reference, picture, reference, comparison);
  }
  result.difference.wrongFaces = comparison.wrongFaceCount();
  return result;
}

namespace {

constexpr int kDifferenceSwatch = 36;

/// The layout: the two pictures above, the difference and its numbers below.
struct DifferencePlaces {
  Rect picture, reference, difference;
  int captions, sections;  ///< y
  int numbers;             ///< x

  DifferencePlaces(int width, int height) {
    const int left = Sheet::kMargin, column = (width - 2 * Sheet::kMargin - Sheet::kGutter) / 2;
    captions = Sheet::kMargin - 4;
    const int top = captions + 20, between = 12;
    const int rows = (height - top - between - Sheet::kSection - Sheet::kMargin) / 2;
    sections = top + rows + between;
    numbers = width - Sheet::kMargin - column;
    picture = {left, top, column, rows};
    reference = {numbers, top, column, rows};
    difference = {left, sections + Sheet::kSection, column, rows};
  }
};

void caption(Sheet& sheet, const Rect& of, int y, std::string_view bold, std::string_view soft) {
  const int x = sheet.painter().text(of.x, y + Sheet::kAscent, bold, sheet.cell(Cell::Ink), Voice::Bold);
  if (x + 12 + textWidth(soft) <= of.x + of.width)
    sheet.painter().text(x + 12, y + Sheet::kAscent, soft, sheet.cell(Cell::Soft));
}

void drawSteps(Sheet& sheet, const Difference& d, const Rect& at, const CellPlan& plan) {
  sheet.painter().place(stepsImage(d, plan), {0, 0, at.width, at.height}, at.x, at.y);
  if (d.above == 0) return;
  Painter painter = sheet.painter().within(at);
  const int x = at.x + static_cast<int>(d.largestAt % d.width),
            y = at.y + static_cast<int>(d.largestAt / d.width);
  painter.ring(x, y, 8, sheet.cell(Cell::White));
  painter.ring(x, y, 9, sheet.cell(Cell::Black));
}

/// Draws the steps side by side with their limits below the borders, and what they mean in words.
int drawScale(Sheet& sheet, const UnlikeRow& measure, int x, int y) {
  Painter painter = sheet.painter();
  for (int step = 0; step < static_cast<int>(kDoublingSteps.size()); ++step) {
    painter.fillRect({x + step * kDifferenceSwatch, y, kDifferenceSwatch, 12},
                     sheet.cell(kDoublingSteps[step].cell));
    if (step == 0) continue;
    const std::string limit = std::to_string(1 << (step - 1));
    painter.text(x + step * kDifferenceSwatch - textWidth(limit) / 2, y + 14 + Sheet::kAscent, limit,
                 sheet.cell(Cell::Soft));
  }
  const int width = kDifferenceSwatch * static_cast<int>(kDoublingSteps.size());
  painter.frame({x, y, width, 12}, sheet.cell(Cell::Ink));
  painter.text(x + width + 8, y + Sheet::kAscent - 1, measure.times, sheet.cell(Cell::Soft));
  painter.text(x, y + 32 + Sheet::kAscent,
               "Darkest: below " + std::string{measure.unitText} + "; each step doubles.",
               sheet.cell(Cell::Soft));
  return y + 32 + Sheet::kLine;
}

std::string share(const Difference& d) {
  return fixed(d.errors.count == 0
                   ? 0.0
                   : 100.0 * static_cast<double>(d.above) / static_cast<double>(d.errors.count),
               2) +
         " %";
}

void drawNumbers(Sheet& sheet, const Difference& d, int x, int y, int width) {
  const int height = static_cast<int>(d.at.size()) / d.width;
  const UnlikeRow& measure = rowOf(d.kind);
  const int decimals = measure.decimals;
  const auto row = [&](const std::string& label, const std::string& value) {
    y = sheet.tableRow(x, y, label, {value}, {width});
  };
  const std::string of = d.kind == Unlike::Intensity ? ", intensity" : ", CIEDE2000";
  row("samples that show a face", grouped(d.errors.count) + " of " + sizeText(d.width, height));
  row("mean difference" + of, fixed(d.errors.mean, decimals));
  row("largest difference", fixed(d.errors.largest, decimals));
  row("above " + std::string{measure.unitText}, share(d));
  row("wrong face", grouped(d.wrongFaces));
  y = drawScale(sheet, measure, x, y + 6);
  const Finding finding = findingOf(d);
  sheet.finding(x, y + 6, width, finding.bold, finding.why);
}

}  // namespace

IndexImage stepsImage(const ErrorMap& errors, const CellPlan& plan) {
  IndexImage image{errors.width, static_cast<int>(errors.at.size()) / errors.width, plan[Cell::Well]};
  for (std::size_t k = 0; k < errors.at.size(); ++k)
    if (const double error = errors.at[k]; !std::isnan(error))
      image.pixels[k] = plan[doublingStep(error, errors.unit).cell];
  return image;
}

Finding findingOf(const Difference& d) {
  const UnlikeRow& measure = rowOf(d.kind);
  const int decimals = measure.decimals;
  const std::string unit{measure.unitText};
  if (d.errors.count == 0) return {"Nothing shows.", ""};
  Finding finding{
      d.above == 0 ? "The picture is nowhere more than " + unit + " off, " + std::string{measure.means} + "."
                   : "The picture is more than " + unit + " off at " + share(d) + " of the samples.",
      "The mean error is " + fixed(d.errors.mean, decimals) + ", the largest " +
          fixed(d.errors.largest, decimals) + (d.above == 0 ? "." : " (in the ring).")};
  if (d.wrongFaces > 0) finding.why += " A wrong face shows at " + counted(d.wrongFaces, "sample") + ".";
  return finding;
}

PictureSettings pictureForDifference(const ViewSettings& settings) {
  const DifferencePlaces at{settings.picture.width, settings.picture.height};
  PictureSettings shown = settings.picture;
  shown.width = at.picture.width, shown.height = at.picture.height;
  return shown;
}

ColoredImage drawDifference(const Picture& picture, const ViewSettings& settings) {
  const DifferencePlaces at{settings.picture.width, settings.picture.height};
  const PictureSettings& shown = picture.settings();
  const Compared compared = comparedWithReference(picture, GroundTruth{picture});

  Sheet sheet{settings.picture.width, settings.picture.height, settings.cells};
  const Rect whole{0, 0, shown.width, shown.height};
  caption(sheet, at.picture, at.captions,
          std::string{rowOf(shown.shading).label} + ", " + std::string{rowOf(shown.order).label},
          "as it is painted");
  caption(sheet, at.reference, at.captions, "the reference",
          compared.difference.kind == Unlike::Color ? "without short cuts, in the picture's cells"
                                                    : "true normals, L and V at every pixel");
  sheet.painter().place(picture.image(), whole, at.picture.x, at.picture.y);
  sheet.painter().place(compared.reference, whole, at.reference.x, at.reference.y);
  sheet.section(at.difference.x, at.sections, at.difference.width, "difference");
  drawSteps(sheet, compared.difference, at.difference, settings.cells);
  const int y = sheet.section(at.numbers, at.sections, at.reference.width, "numbers");
  drawNumbers(sheet, compared.difference, at.numbers, y, at.reference.width);
  return {sheet.image(), picture.palette(settings.cells, settings.unneeded)};
}

namespace {

constexpr int kCountSwatch = 48;

void drawCountLegend(Sheet& sheet, int x, int y) {
  Painter painter = sheet.painter();
  const int steps = static_cast<int>(kOverdrawSteps.size());
  for (int k = 0; k < steps; ++k) {
    const OverdrawStep& step = kOverdrawSteps[k];
    painter.fillRect({x + k * kCountSwatch, y, kCountSwatch, 12}, sheet.cell(step.cell));
    painter.text(x + k * kCountSwatch + (kCountSwatch - textWidth(step.label)) / 2, y + 14 + Sheet::kAscent,
                 step.label, sheet.cell(Cell::Soft));
  }
  painter.frame({x, y, steps * kCountSwatch, 12}, sheet.cell(Cell::Ink));
}

}  // namespace

Finding findingOf(const Overdraw& o, const Picture& picture) {
  if (o.samples == 0) return {"Nothing shows.", ""};
  const Order order = picture.settings().order;
  if (order == Order::Oracle)
    return {"Every sample is painted once.",
            "The oracle finds the face that each sample shows and paints no other, so nothing is painted "
            "over. The orders by a sort paint whole faces."};
  if (rowOf(order).bits > 0)
    return {"Every sample is painted once.", "The z-buffer found the face that each sample shows by " +
                                                 grouped(picture.sorted().statistics.depthTests) +
                                                 " tests of a depth, one for each sample of each face."};
  const double over = 100.0 * static_cast<double>(o.painted - o.samples) / static_cast<double>(o.painted);
  Finding finding{"A sample is painted " + fixed(o.mean(), 2) + " times on average, " +
                      std::to_string(o.most) + " at most.",
                  fixed(over, 1) +
                      " % of all painted samples are painted over. This is the price of an order that needs "
                      "no depth at any sample."};
  const auto faces = static_cast<std::int64_t>(picture.snapped().faces.size());
  if (order == Order::Newell && picture.sorted().statistics.splits == 0 &&
      static_cast<std::int64_t>(picture.sorted().fragments.size()) < faces)
    finding.why += " " + grouped(faces - static_cast<std::int64_t>(picture.sorted().fragments.size())) +
                   " of " + grouped(faces) + " polygons show nowhere and were left out.";
  return finding;
}

Overdraw overdrawOf(const Picture& picture) {
  Overdraw o{.width = picture.settings().width, .times = picture.timesPainted()};
  for (std::size_t k = 0; k < o.times.size(); ++k) {
    const int times = o.times[k];
    o.painted += times;
    o.samples += times > 0;
    o.once += times == 1;
    if (times > o.most) o.most = times, o.mostAt = k;
  }
  return o;
}

IndexImage overdrawImage(const Overdraw& overdraw, const CellPlan& plan) {
  IndexImage image{overdraw.width, static_cast<int>(overdraw.times.size()) / overdraw.width,
                   plan[Cell::Well]};
  for (std::size_t k = 0; k < overdraw.times.size(); ++k)
    if (overdraw.times[k] > 0)
      image.pixels[k] =
          plan[std::ranges::lower_bound(kOverdrawSteps, overdraw.times[k], {}, &OverdrawStep::most)->cell];
  return image;
}

Lens overdrawLens(const Picture& picture, const CellPlan& plan, const Palette& palette) {
  const Overdraw o = overdrawOf(picture);
  const double once =
      o.samples == 0 ? 0.0 : 100.0 * static_cast<double>(o.once) / static_cast<double>(o.samples);
  Lens lens{.shown = {overdrawImage(o, plan), palette},
            .finding = findingOf(o, picture),
            .section = "times painted",
            .rows = {{"order", std::string{rowOf(picture.settings().order).label}},
                     {"samples that show a face", grouped(o.samples)},
                     {"samples painted in total", grouped(o.painted)},
                     {"times each, mean and largest", fixed(o.mean(), 2) + "   " + std::to_string(o.most)},
                     {"painted once", fixed(once, 1) + " %"}},
            .onSheet = [most = o.most, at = static_cast<int>(o.mostAt), width = o.width](PictureSheet& page,
                                                                                         int y) {
              drawCountLegend(page.sheet, page.left, y);
              if (most <= 1) return;
              Painter painter = page.sheet.painter().within(page.at);
              const int x = page.at.x + at % width, row = page.at.y + at / width;
              painter.ring(x, row, 8, page.sheet.cell(Cell::White));
              painter.ring(x, row, 9, page.sheet.cell(Cell::Black));
            }};
  for (const OverdrawStep& step : kOverdrawSteps) lens.steps.push_back({step.cell, step.label});
  return lens;
}

}  // namespace xnewell
