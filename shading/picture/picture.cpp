#include "shading/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "depthsort/oracle.h"
#include "geometry/view/screen_plane.h"
#include "shading/color/quantize.h"
#include "shading/fill/fragment_spans.h"
#include "shading/light/depth_shading.h"

namespace xnewell {

namespace {

/// Runs a stage, or a part of one, and adds the time it took.
template <class Stage>
void timed(double& ms, Stage&& stage) {
  const Stopwatch watch;
  stage();
  ms += watch.ms();
}

/// The byte of a full-colour channel that shows a value of kChannelRamp: 1 to 255 spread over 0 to 255.
const std::array<std::uint8_t, 256> kBytes = [] {
  std::array<std::uint8_t, 256> bytes{};
  for (int v = 1; v < 256; ++v) bytes[v] = static_cast<std::uint8_t>((255 * (v - 1) + 127) / 254);
  return bytes;
}();

bool comparesPlanes(Order order) { return order == Order::Newell || order == Order::Oracle; }

}  // namespace

void Picture::make(const PictureSettings& next) {
  times_ = {};

  // The camera: from what the user said, and from the scene for the rest, which means passes over its points.
  const bool newCamera =
      !any_ || next.camera != made_.camera || next.width != made_.width || next.height != made_.height;
  Camera camera = camera_;
  if (newCamera)
    timed(times_.transform, [&] {
      const double aspect = static_cast<double>(next.width) / next.height;
      camera = placeCamera(next.camera, scene_.mesh.points, scene_.up, aspect);
    });

  // Until all is done no result counts, for a stage may throw.
  const bool any = std::exchange(any_, false);

  // Shading, in world coordinates: once when a face is made, the specular term again when the eye moves.
  const ColorPlan plan = planOf(scene_, next);
  bool newPolygons = false;
  timed(times_.shade, [&] { newPolygons = shading_.make(scene_, next, channelsOf(plan), camera); });

  // What changed since the results that are kept.
  const bool newView = !any || newPolygons || camera.view != camera_.view || next.width != made_.width ||
                       next.height != made_.height || next.cull != made_.cull;
  const bool newOrder = newView || next.order != made_.order || next.inPixels != made_.inPixels;

  // View, shear, warp, clip, viewport, and one snap to the grid, from where all is exact.
  if (newView)
    timed(times_.transform, [&] {
      snapped_ = snap(shading_.mesh(scene_), shading_.parts(scene_), camera.view, next.width, next.height,
                      next.cull);
    });
  camera_ = camera;

  // Back to front.
  if (newOrder)
    timed(times_.sort, [&] {
      sorted_ = {};
      visible_.clear();
      if (comparesPlanes(next.order) && snapped_.planes.empty())
        xnewell::addPlanes(snapped_, scene_.mesh, camera_.view, next.width, next.height);
      if (next.order == Order::Oracle)
        visible_ = visibleFaces(snapped_, next.width, next.height);
      else if (next.order == Order::Newell)
        sorted_ =
            depthSort(snapped_, {.width = next.width, .height = next.height, .inPixels = next.inPixels});
      else
        std::ranges::transform(paintingOrder(snapped_, next.order), std::back_inserter(sorted_.fragments),
                               [](int face) { return Fragment{face}; });
    });

  // Intensities to cells of the colour table.
  timed(times_.fill, [&] {
    colors_.make(surfaces(next), plan);
    if (rowOf(next.shading).interpolates)
      cells_.clear();
    else if (channelsOf(plan) != Channels::Rgb)
      cells_ = cellsOf(next, 0);
    else
      cells_.resize(snapped_.faces.size());  // paint() chooses the colours
  });

  made_ = next;
  any_ = true;
}

void Picture::addPlanes() {
  if (snapped_.planes.empty())
    xnewell::addPlanes(snapped_, scene_.mesh, camera_.view, made_.width, made_.height);
}

std::vector<double> Picture::faceIntensities(const PictureSettings& settings, int channel) const {
  std::vector<double> I(snapped_.faces.size(), 1.0);
  if (settings.shading == Shading::Depth) {
    I = depthIntensities(scene_.mesh, snapped_, camera_.view);
  } else if (settings.shading == Shading::Flat) {
    std::ranges::transform(snapped_.faces, I.begin(), [&](const SnappedFace& f) {
      return shading_.intensities(channel).I[shading_.pointOf(f)].seen(f.back);
    });
  }
  return I;
}

std::vector<std::uint8_t> Picture::cellsOf(const PictureSettings& settings, int channel) const {
  const std::vector<double> I = faceIntensities(settings, channel);
  const std::vector<Ramp> ramps = colors_.ramps();
  std::vector<std::uint8_t> cells(I.size());
  for (std::size_t f = 0; f < I.size(); ++f)
    cells[f] = ramps[scene_.mesh.material[snapped_.faces[f].number] + 1].cell(I[f]);
  return cells;
}

Surfaces Picture::surfaces(const PictureSettings& settings) const {
  return {.scene = scene_,
          .mesh = shading_.mesh(scene_),
          .snapped = snapped_,
          .view = camera_.view,
          .settings = settings,
          .shading = shading_};
}

void Picture::paintChannel(IndexImage& image, int channel, const std::vector<std::uint8_t>& cells) {
  SurfacePainter painter{surfaces(made_), channel, colors_.ramps(), cells};
  if (visible_.empty())
    painter.paintAll(image, sorted_);
  else
    painter.paintVisible(image, visible_);
  clampedPixels_ += painter.clamped();
}

void Picture::paint(IndexImage& image, std::uint8_t ground) {
  const Stopwatch watch;
  image.width = made_.width;
  image.height = made_.height;
  image.pixels.assign(std::size_t(made_.width) * made_.height, ground);
  clampedPixels_ = 0;
  if (channelsOf(colors_.plan()) == Channels::Rgb)
    paintColors(image);
  else
    paintChannel(image, 0, cells_);
  times_.fill += watch.ms();
}

SurfacePainter Picture::painter() const {
  return SurfacePainter{surfaces(made_), 0, colors_.ramps(), cells_};
}

void Picture::paintColors(IndexImage& image) {
  RgbImage colors{made_.width, made_.height};
  IndexImage channel;
  for (int c = 0; c < 3; ++c) {
    channel = IndexImage{made_.width, made_.height, 0};
    const std::vector<std::uint8_t> cells =
        rowOf(made_.shading).interpolates ? std::vector<std::uint8_t>{} : cellsOf(made_, c);
    paintChannel(channel, c, cells);
    for (std::size_t k = 0; k < channel.pixels.size(); ++k) colors.rgb[3 * k + c] = kBytes[channel.pixels[k]];
  }
  chosen_ = quantize(colors, channel.pixels,
                     {.quantizer = colors_.plan() == ColorPlan::Cube ? Quantizer::Cube : Quantizer::Chosen,
                      .dither = made_.dither,
                      .colors = made_.table.shades,
                      .first = colors_.table().first()},
                     image);
  if (!rowOf(made_.shading).interpolates) cells_ = nearestCells();
}

std::vector<std::uint8_t> Picture::nearestCells() const {
  const std::size_t faces = snapped_.faces.size();
  std::vector<glm::u8vec3> palette;
  for (const Rgb16& c : chosen_) palette.emplace_back(c.r >> 8, c.g >> 8, c.b >> 8);
  RgbImage colors{static_cast<int>(faces), 1};
  for (int c = 0; c < 3; ++c) {
    const std::vector<std::uint8_t> channel = cellsOf(made_, c);
    for (std::size_t f = 0; f < faces; ++f) colors.rgb[3 * f + c] = kBytes[channel[f]];
  }
  IndexImage nearest{static_cast<int>(faces), 1, 0};
  if (!palette.empty()) paintNearest(colors, {}, palette, false, colors_.table().first(), nearest);
  return nearest.pixels;
}

Palette Picture::palette(const CellPlan& plan, const Palette& unneeded) const {
  Palette palette = unneeded;
  if (channelsOf(colors_.plan()) == Channels::Rgb) {
    std::ranges::copy(chosen_, palette.begin() + colors_.table().first());
  } else {
    for (const ColorTable& table : colors_.tables())
      for (int j = 0; j < table.shades(); ++j) palette[table.first() + j] = table.color(j);
  }
  return withInterface(palette, plan);
}

template <class Span>
void Picture::paintFaces(int firstRow, int endRow, Span&& span) const {
  if (made_.order != Order::Oracle) {
    for (const Fragment& fragment : sorted_.fragments)
      forEachSpan(snapped_, sorted_, fragment, made_.width, endRow, [&](int row, int from, int to) {
        if (row >= firstRow) span(row, from, to, fragment.face);
      });
    return;
  }
  for (int j = firstRow; j < endRow; ++j) {
    const int* const row = visible_.data() + std::ptrdiff_t(j) * made_.width;
    for (int from = 0, to = 0; from < made_.width; from = to) {
      while (to < made_.width && row[to] == row[from]) ++to;
      if (row[from] != kNothing) span(j, from, to, row[from]);
    }
  }
}

SeenRows Picture::seen(int firstRow, int endRow) const {
  SeenRows seen{made_.width, firstRow,
                std::vector<int>(std::size_t(endRow - firstRow) * made_.width, kNothing)};
  paintFaces(firstRow, endRow, [&](int row, int from, int to, int face) {
    const auto begin = seen.faces.begin() + std::ptrdiff_t(row - firstRow) * made_.width;
    std::fill(begin + from, begin + to, face);
  });
  return seen;
}

std::vector<int> Picture::timesPainted() const {
  std::vector<int> times(std::size_t(made_.width) * made_.height, 0);
  paintFaces(0, made_.height, [&](int row, int from, int to, int) {
    const auto begin = times.begin() + std::ptrdiff_t{row} * made_.width;
    std::for_each(begin + from, begin + to, [](int& t) { ++t; });
  });
  return times;
}

std::vector<double> Picture::intensities(const SeenRows& rows, int channel) const {
  const std::vector<double> ofFaces =
      rowOf(made_.shading).interpolates ? std::vector<double>{} : faceIntensities(made_, channel);
  return intensitiesAt(rows, surfaces(made_), channel, ofFaces);
}

std::vector<glm::dvec3> Picture::normals(const SeenRows& rows) const {
  return normalsAt(rows, surfaces(made_));
}

std::vector<std::uint32_t> Picture::faceImage() const {
  std::vector<std::uint32_t> image(std::size_t(made_.width) * made_.height, 0);
  const SeenRows rows = seen(0, made_.height);
  std::ranges::transform(rows.faces, image.begin(), [&](int face) {
    return face == kNothing ? 0 : static_cast<std::uint32_t>(snapped_.faces[face].number) + 1;
  });
  return image;
}

std::vector<Picture::SampleCheck> Picture::checkedSamples() {
  addPlanes();
  const std::vector<int> painted = seen(0, made_.height).faces;
  const auto apart = [&](int p, int q, int i, int j) {
    const SnappedFace &P = snapped_.faces[p], &Q = snapped_.faces[q];
    const std::int64_t x = std::int64_t{i} * kGrid + kGrid / 2, y = std::int64_t{j} * kGrid + kGrid / 2;
    const double zP = depthAt(snapped_.planes[P.plane], x, y), zQ = depthAt(snapped_.planes[Q.plane], x, y);
    return P.plane == Q.plane || std::abs(zP - zQ) > P.doubt.at(zP) + Q.doubt.at(zQ);
  };
  const std::vector<int> visible = visibleFaces(snapped_, made_.width, made_.height);
  std::vector<SampleCheck> checked(visible.size(), SampleCheck::Nothing);
  for (int j = 0; j < made_.height; ++j)
    for (int i = 0; i < made_.width; ++i) {
      const std::size_t k = std::size_t(j) * made_.width + i;
      if (visible[k] == kNothing) continue;
      const bool wrong = painted[k] != visible[k] && apart(painted[k], visible[k], i, j);
      checked[k] = wrong ? SampleCheck::Wrong : SampleCheck::Right;
    }
  return checked;
}

Picture::Exactness Picture::exactness() {
  Exactness exactness;
  for (const SampleCheck sample : checkedSamples()) {
    exactness.samples += sample != SampleCheck::Nothing;
    exactness.wrong += sample == SampleCheck::Wrong;
  }
  return exactness;
}

std::int64_t Picture::saturated() const {
  std::int64_t clamped = clampedPixels_;
  for (int c = 0; c < shading_.lighting().channels; ++c) clamped += shading_.intensities(c).clamped;
  return clamped;
}

}  // namespace xnewell
