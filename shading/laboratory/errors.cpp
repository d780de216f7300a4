#include "shading/laboratory/errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <map>
#include <utility>

#include "depthsort/oracle.h"
#include "geometry/view/scene_planes.h"
#include "shading/color/color_difference.h"
#include "shading/scene/divide_anew.h"

namespace xnewell {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr int kBlock = 8;  // pixels

double largestOf(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

glm::dvec3 shares(const Rgb16& c) { return glm::dvec3{c.r, c.g, c.b} / 65535.0; }

/// True if a face of the snapped scene covers a place on the grid, or has it on its border.
bool has(const SnappedScene& scene, const SnappedFace& face, std::int64_t x, std::int64_t y) {
  for (int k = 0; k < face.count; ++k) {
    const glm::ivec3 &a = scene.vertices[face.first + k],
                     &b = scene.vertices[face.first + (k + 1) % face.count];
    if (std::int64_t{b.y - a.y} * (x - a.x) - std::int64_t{b.x - a.x} * (y - a.y) < 0) return false;
  }
  return true;
}

}  // namespace

std::optional<PatchDistance> distanceFromPatches(const PolygonGroundTruth& view) {
  PatchDistance result;
  const TrueSurface& surface = view.surface();
  for (std::size_t k = 0; k < view.faces().size(); ++k) {
    if (view.faces()[k] == kNothing) continue;
    const SurfacePlace place = view.place(k);
    if (place.patch == nullptr) continue;
    const double distance = surface.distanceToPatch(place);
    const double inFile = std::ldexp(distance, view.picture().scene().exponent);
    const double pixels = distance * surface.pixelsPerUnit(place);
    const auto count = static_cast<double>(++result.samples);
    result.mean += (inFile - result.mean) / count;
    result.meanPixels += (pixels - result.meanPixels) / count;
    result.largest = std::max(result.largest, inFile);
    result.largestPixels = std::max(result.largestPixels, pixels);
  }
  return result.samples > 0 ? std::optional{result} : std::nullopt;
}

Spread spreadOf(std::span<const float> errors) {
  Spread spread;
  std::vector<float> counted;
  std::ranges::copy_if(errors, std::back_inserter(counted), [](float e) { return !std::isnan(e); });
  spread.count = static_cast<std::int64_t>(counted.size());
  if (counted.empty()) return spread;
  double sum = 0.0, squares = 0.0;
  for (const float e : counted) sum += e, squares += double{e} * e;
  const auto count = static_cast<double>(counted.size());
  spread.mean = sum / count;
  spread.rootMeanSquare = std::sqrt(squares / count);
  // The least rank r with r >= 99 n / 100, in whole numbers.
  const auto rank = static_cast<std::ptrdiff_t>((99 * counted.size() + 99) / 100);
  std::ranges::nth_element(counted, counted.begin() + (rank - 1));
  spread.p99 = counted[static_cast<std::size_t>(rank - 1)];
  spread.largest = *std::ranges::max_element(counted);
  return spread;
}

ErrorMap errorMap(std::vector<float> at, int width, double unit) {
  ErrorMap map{.width = width, .unit = unit, .at = std::move(at), .errors = spreadOf(map.at)};
  for (const float error : map.at) map.above += error > unit;  // false for NaN
  if (map.errors.largest > 0)
    map.largestAt = static_cast<std::size_t>(std::ranges::find(map.at, map.errors.largest) - map.at.begin());
  return map;
}

Comparison::Comparison(const Picture& picture, const Reference& reference, const Palette& palette,
                       const PolygonGroundTruth& ofItsPolygons)
    : picture_{picture},
      reference_{reference},
      polygons_{ofItsPolygons},
      palette_{palette},
      faces_{picture.seen(0, picture.settings().height)},
      ofCell_{} {
  assert(picture.isPainted());
  const SceneColors& colors = picture.colors();
  for (int cell = 0; cell < 256; ++cell) ofCell_[cell] = shares(palette[cell]);
  if (channelsOf(colors.plan()) == Channels::Rgb) return;
  for (const ColorTable& table : colors.tables())
    for (int j = 0; j < table.shades(); ++j)
      ofCell_[table.first() + j] =
          table.intensity(j) * (colors.plan() == ColorPlan::OneHue ? glm::dvec3{1.0} : table.settings().hue);
}

int Comparison::shownFace(std::size_t sample) const {
  const int face = faces_.faces[sample];
  return face == kNothing ? kNothing : picture_.snapped().faces[face].number;
}

int Comparison::dueFace(std::size_t sample) const {
  const int face = polygons_.faces()[sample];
  return face == kNothing ? kNothing : polygons_.picture().snapped().faces[face].number;
}

int Comparison::trueFace(std::size_t sample) const {
  const int face = reference_.faces()[sample];
  if (face == kNothing) return kNothing;
  const Picture& of = reference_.picture();
  return sameFaceIn(picture_.scene(), of.scene(), of.snapped().faces[face].number);
}

glm::dvec3 Comparison::shown(std::size_t sample) const {
  return faces_.faces[sample] == kNothing ? glm::dvec3{0.0} : ofCell_[picture_.image().pixels[sample]];
}

glm::dvec3 Comparison::due(std::size_t sample) const {
  const glm::dvec3 I = reference_.I(sample);
  return picture_.colors().plan() == ColorPlan::OneHue ? glm::dvec3{luminance(I)} : I;
}

Rgb16 Comparison::dueColor(std::size_t sample) const {
  glm::dvec3 I = reference_.I(sample);
  if (reference_.gray() && picture_.colors().plan() == ColorPlan::OneHue) I *= picture_.settings().table.hue;
  const auto stored = [](double v) { return static_cast<std::uint16_t>(std::floor(65535.0 * v + 0.5)); };
  return {stored(I.r), stored(I.g), stored(I.b)};
}

std::vector<float> Comparison::intensityErrors(TableSide side) const {
  std::vector<float> errors(samples(), kNone);
  std::array<std::vector<double>, 3> before;
  const SceneColors& colors = picture_.colors();
  const int channels = channelsOf(colors.plan()) == Channels::Rgb ? 3 : 1;
  if (side == TableSide::Before)
    for (int c = 0; c < channels; ++c) before[c] = picture_.intensities(faces_, c);
  const std::vector<int>& material = picture_.scene().mesh.material;
  const auto beforeTable = [&](std::size_t k) {
    if (faces_.faces[k] == kNothing) return glm::dvec3{0.0};
    if (channels == 3) return glm::dvec3{before[0][k], before[1][k], before[2][k]};
    const glm::dvec3 hue = colors.plan() == ColorPlan::OneHue
                               ? glm::dvec3{1.0}
                               : colors.tableOf(material[shownFace(k)]).settings().hue;
    return before[0][k] * hue;
  };
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (shows(k))
      errors[k] = static_cast<float>(
          largestOf(glm::abs((side == TableSide::Before ? beforeTable(k) : shown(k)) - due(k))));
  return errors;
}

std::vector<float> Comparison::colorErrors() const {
  std::vector<float> errors(samples(), kNone);
  std::array<Lab, 256> ofCell;
  std::ranges::transform(palette_, ofCell.begin(), [](const Rgb16& c) { return labFromSrgb(c); });
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (!shows(k)) continue;
    const Lab due = reference_.faces()[k] == kNothing ? ofCell[picture_.ground()] : labFromSrgb(dueColor(k));
    errors[k] = static_cast<float>(ciede2000(ofCell[picture_.image().pixels[k]], due));
  }
  return errors;
}

bool Comparison::mayTouch(std::size_t sample) const {
  const SnappedScene& scene = polygons_.picture().snapped();
  const auto width = static_cast<std::size_t>(picture_.settings().width);
  const std::int64_t x = static_cast<std::int64_t>(sample % width) * kGrid + kGrid / 2,
                     y = static_cast<std::int64_t>(sample / width) * kGrid + kGrid / 2;
  const SnappedFace& due = scene.faces[polygons_.faces()[sample]];
  // Faces are in order of number.
  for (const SnappedFace& shown :
       std::ranges::equal_range(scene.faces, shownFace(sample), {}, &SnappedFace::number))
    if (has(scene, shown, x, y) && shown.plane != due.plane && xnewell::mayTouch(scene, due, shown, x, y))
      return true;
  return false;
}

std::vector<std::uint8_t> Comparison::wrongFaces() const {
  std::vector<std::uint8_t> wrong(samples(), 0);
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    if (shownFace(k) == dueFace(k)) continue;
    wrong[k] = shownFace(k) == kNothing || dueFace(k) == kNothing || !mayTouch(k);
  }
  return wrong;
}

std::int64_t Comparison::wrongFaceCount() const { return std::ranges::count(wrongFaces(), 1); }

std::vector<float> Comparison::blockErrors() const {
  std::vector<float> errors;
  const int width = picture_.settings().width, height = picture_.settings().height;
  for (int top = 0; top + kBlock <= height; top += kBlock)
    for (int left = 0; left + kBlock <= width; left += kBlock) {
      glm::dvec3 sum{0.0};
      bool whole = true;
      for (int j = top; j < top + kBlock; ++j)
        for (int i = left; i < left + kBlock; ++i) {
          const std::size_t k = std::size_t(j) * width + i;
          whole = whole && shownFace(k) >= 0 && reference_.faces()[k] >= 0;
          sum += shown(k) - due(k);
        }
      if (whole) errors.push_back(static_cast<float>(largestOf(glm::abs(sum)) / (kBlock * kBlock)));
    }
  return errors;
}

std::vector<std::size_t> worstSamples(std::span<const float> errors, int width) {
  std::vector<std::size_t> worst;
  const auto apart = [&](std::size_t a, std::size_t b) {
    const auto w = static_cast<std::size_t>(width);
    const auto gap = [](std::size_t p, std::size_t q) { return p > q ? p - q : q - p; };
    return std::max(gap(a % w, b % w), gap(a / w, b / w)) >= kBetweenWorstPlaces;
  };
  while (static_cast<int>(worst.size()) < kMostWorstPlaces) {
    std::size_t next = errors.size();
    float most = 0.0F;
    for (std::size_t k = 0; k < errors.size(); ++k)
      if (errors[k] > most && std::ranges::all_of(worst, [&](std::size_t w) { return apart(k, w); }))
        next = k, most = errors[k];
    if (next == errors.size()) break;
    worst.push_back(next);
  }
  return worst;
}

std::vector<WorstPlace> worstPlaces(const Comparison& comparison, std::span<const float> errors) {
  const int width = comparison.picture().settings().width;
  std::vector<WorstPlace> places;
  for (const std::size_t k : worstSamples(errors, width))
    places.push_back({.x = static_cast<int>(k) % width,
                      .y = static_cast<int>(k) / width,
                      .face = comparison.trueFace(k),
                      .shownFace = comparison.shownFace(k),
                      .due = comparison.due(k),
                      .shown = comparison.shown(k),
                      .error = errors[k]});
  return places;
}

Errors errorsOf(const Comparison& comparison) {
  const Picture& picture = comparison.picture();
  Errors errors;
  errors.beforeTable = spreadOf(comparison.intensityErrors(TableSide::Before));
  const std::vector<float> after = comparison.intensityErrors(TableSide::After);
  errors.afterTable = spreadOf(after);
  errors.color = spreadOf(comparison.colorErrors());
  errors.samples = errors.afterTable.count;
  errors.wrongFaces = comparison.wrongFaceCount();
  if (picture.settings().dither && channelsOf(picture.colors().plan()) == Channels::Rgb)
    errors.blocks = spreadOf(comparison.blockErrors());
  errors.worst = worstPlaces(comparison, after);
  return errors;
}

Errors errorsOf(const Picture& picture, const Palette& palette) {
  const GroundTruth truth{picture};
  Errors errors = errorsOf(Comparison{picture, truth, palette});
  errors.patches = distanceFromPatches(truth.polygons());
  return errors;
}

SampleCheck checkOf(const SnappedScene& scene, int painted, int visible, int i, int j) {
  if (painted == visible) return SampleCheck::Right;
  if (painted == kNothing) return SampleCheck::Wrong;
  const std::int64_t x = std::int64_t{i} * kGrid + kGrid / 2, y = std::int64_t{j} * kGrid + kGrid / 2;
  const SnappedFace &front = scene.faces[visible], &behind = scene.faces[painted];
  if (front.plane == behind.plane) return SampleCheck::Earlier;
  return mayTouch(scene, front, behind, x, y) ? SampleCheck::Doubtful : SampleCheck::Wrong;
}

namespace {

/// Calls use(verdicts) for one band of rows after the other, with verdicts on its samples.
template <class Use>
void forEachBand(const Picture& picture, int rowsInBand, Use&& use) {
  const int width = picture.settings().width, height = picture.settings().height;
  const Picture complete = picture.withPlanes();
  const SnappedScene& snapped = complete.snapped();
  VisibleFaces oracle{snapped};
  std::vector<SampleCheck> verdicts;
  for (int first = 0; first < height; first += rowsInBand) {
    const int end = std::min(height, first + rowsInBand);
    const std::vector<int> painted = picture.seen(first, end).faces, visible = oracle.rows(first, end, width);
    verdicts.assign(visible.size(), SampleCheck::Nothing);
    for (int j = first; j < end; ++j)
      for (int i = 0; i < width; ++i) {
        const std::size_t k = std::size_t(j - first) * width + i;
        if (visible[k] != kNothing) verdicts[k] = checkOf(snapped, painted[k], visible[k], i, j);
      }
    use(verdicts);
  }
}

}  // namespace

std::vector<SampleCheck> checkedSamples(const Picture& picture) {
  std::vector<SampleCheck> all;
  forEachBand(picture, picture.settings().height,
              [&](std::vector<SampleCheck>& verdicts) { all = std::move(verdicts); });
  return all;
}

Exactness exactnessOf(std::span<const SampleCheck> verdicts) {
  Exactness exactness;
  for (const SampleCheck verdict : verdicts) {
    exactness.samples += verdict != SampleCheck::Nothing;
    exactness.wrong += isWrong(verdict);
    exactness.earlier += verdict == SampleCheck::Earlier;
    exactness.doubtful += verdict == SampleCheck::Doubtful;
  }
  return exactness;
}

Exactness exactnessOf(const Picture& picture) {
  constexpr int kSamplesInBand = 1 << 17;  // they stay in the second cache
  Exactness all;
  forEachBand(picture, std::max(1, kSamplesInBand / picture.settings().width),
              [&](const std::vector<SampleCheck>& verdicts) {
                const Exactness band = exactnessOf(verdicts);
                all.samples += band.samples, all.wrong += band.wrong;
                all.earlier += band.earlier, all.doubtful += band.doubtful;
              });
  return all;
}

}  // namespace xnewell
