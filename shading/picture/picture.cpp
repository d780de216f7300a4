#include "shading/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "geometry/view/scene_planes.h"
#include "shading/color/quantize.h"
#include "shading/light/depth_shading.h"

namespace xnewell {

namespace {

/// channelByte() of each value; 0 for 0.
const std::array<std::uint8_t, 256> kBytes = [] {
  std::array<std::uint8_t, 256> bytes{};
  for (int v = 1; v < 256; ++v) bytes[v] = channelByte(v);
  return bytes;
}();

/// The scene without the faces whose newIndex is kNothing; newIndex gets the places of the others. It has no
/// planes.
SnappedScene onlySome(const SnappedScene& all, std::vector<int>& newIndex) {
  SnappedScene some;
  some.between = all.between;
  some.zShift = all.zShift;
  some.polygons = all.polygons, some.culled = all.culled;
  some.outside = all.outside, some.degenerate = all.degenerate;
  for (std::size_t f = 0; f < all.faces.size(); ++f) {
    if (newIndex[f] == kNothing) continue;
    newIndex[f] = static_cast<int>(some.faces.size());
    SnappedFace face = all.faces[f];
    const auto outline = [&](const auto& from, auto& to) {
      to.insert(to.end(), from.begin() + face.first, from.begin() + face.first + face.count);
    };
    outline(all.source, some.source);
    outline(all.vertices, some.vertices);
    face.first = static_cast<int>(some.vertices.size()) - face.count;
    some.faces.push_back(face);
  }
  return some;
}

/// True if the box around a face meets the samples [low, high).
bool meets(const SnappedScene& scene, const SnappedFace& face, glm::ivec2 low, glm::ivec2 high) {
  constexpr double kPixel = 65536;
  glm::dvec2 least{scene.vertices[face.first]}, most = least;
  for (int k = 1; k < face.count; ++k) {
    const glm::dvec2 at{scene.vertices[face.first + k]};
    least = glm::min(least, at), most = glm::max(most, at);
  }
  return least.x < high.x * kPixel && least.y < high.y * kPixel && most.x > low.x * kPixel &&
         most.y > low.y * kPixel;
}

}  // namespace

const std::vector<std::uint8_t>& Picture::cells() const {
  return channelsOf(colors_->plan()) == Channels::Rgb && painted_ ? painted_->cells : *cells_;
}

Picture Picture::withPlanes() const {
  Picture picture = *this;
  const auto hasPlane = [&](const SnappedFace& face) { return snapped_->planes.has(face.plane); };
  if (std::ranges::all_of(snapped_->faces, hasPlane)) return picture;
  SnappedScene snapped = *snapped_;
  ScenePlanes{snapped,      shading_.mesh(*scene_), shading_.parts(*scene_),
              camera_.view, settings_.width,        settings_.height}
      .makeAll();
  picture.snapped_ = std::move(snapped);
  return picture;
}

Picture Picture::onlyShown() const {
  std::vector<int> visible = seen(0, settings_.height).faces;
  std::vector<int> newIndex(snapped_->faces.size(), kNothing);
  for (const int face : visible)
    if (face != kNothing) newIndex[face] = 0;
  Picture picture = *this;
  picture.snapped_ = onlySome(*snapped_, newIndex);
  for (int& face : visible)
    if (face != kNothing) face = newIndex[face];
  picture.shading_ = shading_.onlyLights();
  picture.sorted_ = {};
  picture.visible_ = std::move(visible);
  picture.cells_ = {};
  return picture;
}

Picture Picture::onlyWithin(glm::ivec2 low, glm::ivec2 high) const {
  const Picture whole = withPlanes();
  std::vector<int> newIndex(snapped_->faces.size(), kNothing);
  std::vector<std::uint8_t> cells;
  for (std::size_t f = 0; f < newIndex.size(); ++f) {
    if (!meets(*snapped_, snapped_->faces[f], low, high)) continue;
    newIndex[f] = 0;
    if (!cells_->empty()) cells.push_back(cells_->at(f));
  }
  Picture picture = whole;
  SnappedScene some = onlySome(*whole.snapped_, newIndex);
  some.planes = whole.snapped_->planes;
  for (std::size_t f = 0; f < newIndex.size(); ++f)
    if (newIndex[f] != kNothing)
      some.planes.setDoubt(newIndex[f], whole.snapped_->doubtOf(whole.snapped_->faces[f]), newIndex.size());
  picture.snapped_ = std::move(some);
  picture.sorted_ = {};
  picture.visible_ = {};
  picture.cells_ = std::move(cells);
  picture.painted_ = nullptr;
  return picture;
}

std::int64_t Picture::facesWithin(glm::ivec2 low, glm::ivec2 high) const {
  return std::ranges::count_if(snapped_->faces,
                               [&](const SnappedFace& face) { return meets(*snapped_, face, low, high); });
}

std::vector<double> Picture::faceIntensities(int channel) const {
  std::vector<double> I(snapped_->faces.size(), 1.0);
  if (settings_.shading == Shading::Depth) {
    I = depthIntensities(scene_->mesh, *snapped_, camera_.view);
  } else if (settings_.shading == Shading::Flat) {
    std::ranges::transform(snapped_->faces, I.begin(), [&](const SnappedFace& f) {
      return shading_.intensities(channel).I[shading_.pointOf(f)].seen(f.back);
    });
  }
  return I;
}

std::vector<std::uint8_t> Picture::cellsOf(int channel) const {
  const std::vector<double> I = faceIntensities(channel);
  const std::vector<Ramp> ramps = colors_->ramps();
  const std::vector<CellOnRamp> cellOf{ramps.begin(), ramps.end()};
  std::vector<std::uint8_t> cells(I.size());
  for (std::size_t f = 0; f < I.size(); ++f)
    cells[f] = cellOf[scene_->mesh.material[snapped_->faces[f].number] + 1](I[f]);
  return cells;
}

Surfaces Picture::surfaces() const {
  return {.scene = *scene_,
          .mesh = shading_.mesh(*scene_),
          .snapped = *snapped_,
          .view = camera_.view,
          .settings = settings_,
          .shading = shading_};
}

std::int64_t Picture::paintChannel(IndexImage& image, int channel,
                                   const std::vector<std::uint8_t>& cells) const {
  SurfacePainter painter{surfaces(), channel, colors_->ramps(), cells};
  if (visible_->empty())
    painter.paintAll(image, *sorted_);
  else
    painter.paintVisible(image, *visible_);
  return painter.clamped();
}

Painted Picture::paint(std::uint8_t ground) const {
  Painted painted;
  painted.image = {settings_.width, settings_.height, ground};
  painted.ground = ground;
  if (channelsOf(colors_->plan()) == Channels::Rgb)
    paintColors(painted);
  else
    painted.clamped = paintChannel(painted.image, 0, *cells_);
  return painted;
}

SurfacePainter Picture::painter() const { return SurfacePainter{surfaces(), 0, colors_->ramps(), cells()}; }

void Picture::paintColors(Painted& painted) const {
  const bool oneCell = !rowOf(settings_.shading).interpolates;
  RgbImage colors{settings_.width, settings_.height};
  IndexImage channel;
  for (int c = 0; c < 3; ++c) {
    channel = IndexImage{settings_.width, settings_.height, 0};
    const std::vector<std::uint8_t> cells = oneCell ? cellsOf(c) : std::vector<std::uint8_t>{};
    painted.clamped += paintChannel(channel, c, cells);
    for (std::size_t k = 0; k < channel.pixels.size(); ++k) colors.rgb[3 * k + c] = kBytes[channel.pixels[k]];
  }
  painted.chosen =
      quantize(colors, channel.pixels,
               {.quantizer = colors_->plan() == ColorPlan::Cube ? Quantizer::Cube : Quantizer::Chosen,
                .dither = settings_.dither,
                .colors = settings_.table.shades,
                .first = table().first()},
               painted.image);
  if (oneCell) painted.cells = nearestCells(painted.chosen);
}

std::vector<std::uint8_t> Picture::nearestCells(const std::vector<Rgb16>& chosen) const {
  const std::size_t faces = snapped_->faces.size();
  std::vector<glm::u8vec3> palette;
  for (const Rgb16& c : chosen) palette.emplace_back(c.r >> 8, c.g >> 8, c.b >> 8);
  RgbImage colors{static_cast<int>(faces), 1};
  for (int c = 0; c < 3; ++c) {
    const std::vector<std::uint8_t> channel = cellsOf(c);
    for (std::size_t f = 0; f < faces; ++f) colors.rgb[3 * f + c] = kBytes[channel[f]];
  }
  IndexImage nearest{static_cast<int>(faces), 1, 0};
  if (!palette.empty()) paintNearest(colors, {}, palette, false, table().first(), nearest);
  return nearest.pixels;
}

Palette Picture::palette(const CellPlan& plan, const Palette& unneeded) const {
  Palette palette = unneeded;
  if (channelsOf(colors_->plan()) == Channels::Rgb) {
    if (painted_) std::ranges::copy(painted_->chosen, palette.begin() + table().first());
  } else {
    for (const ColorTable& table : colors_->tables())
      for (int j = 0; j < table.shades(); ++j) palette[table.first() + j] = table.color(j);
  }
  return withInterface(palette, plan);
}

template <class Span>
void Picture::paintFaces(int firstRow, int endRow, Span&& span) const {
  if (visible_->empty()) {
    for (const Fragment& fragment : sorted_->fragments)
      forEachSpan(*snapped_, *sorted_, fragment, settings_.width, endRow, [&](int row, int from, int to) {
        if (row >= firstRow) span(row, from, to, fragment.face);
      });
    return;
  }
  for (int j = firstRow; j < endRow; ++j) {
    const int* const row = visible_->data() + std::ptrdiff_t(j) * settings_.width;
    for (int from = 0, to = 0; from < settings_.width; from = to) {
      while (to < settings_.width && row[to] == row[from]) ++to;
      if (row[from] != kNothing) span(j, from, to, row[from]);
    }
  }
}

SeenRows Picture::seen(int firstRow, int endRow) const {
  SeenRows seen{settings_.width, firstRow,
                std::vector<int>(std::size_t(endRow - firstRow) * settings_.width, kNothing)};
  paintFaces(firstRow, endRow, [&](int row, int from, int to, int face) {
    const auto begin = seen.faces.begin() + std::ptrdiff_t(row - firstRow) * settings_.width;
    std::fill(begin + from, begin + to, face);
  });
  return seen;
}

std::vector<int> Picture::timesPainted() const {
  std::vector<int> times(std::size_t(settings_.width) * settings_.height, 0);
  paintFaces(0, settings_.height, [&](int row, int from, int to, int) {
    const auto begin = times.begin() + std::ptrdiff_t{row} * settings_.width;
    std::for_each(begin + from, begin + to, [](int& t) { ++t; });
  });
  return times;
}

std::vector<double> Picture::intensities(const SeenRows& rows, int channel) const {
  const std::vector<double> ofFaces =
      rowOf(settings_.shading).interpolates ? std::vector<double>{} : faceIntensities(channel);
  return intensitiesAt(rows, surfaces(), channel, ofFaces);
}

std::vector<glm::dvec3> Picture::normals(const SeenRows& rows) const { return normalsAt(rows, surfaces()); }

std::vector<std::uint32_t> Picture::faceImage() const {
  std::vector<std::uint32_t> image(std::size_t(settings_.width) * settings_.height, 0);
  const SeenRows rows = seen(0, settings_.height);
  std::ranges::transform(rows.faces, image.begin(), [&](int face) {
    return face == kNothing ? 0 : static_cast<std::uint32_t>(snapped_->faces[face].number) + 1;
  });
  return image;
}

std::int64_t Picture::saturated() const {
  std::int64_t clamped = painted_ ? painted_->clamped : 0;
  const Lighting& lighting = shading_.lighting();
  for (int c = 0; c < (lighting.luminance ? 1 : lighting.channels); ++c)
    clamped += shading_.intensities(c).clamped;
  return clamped;
}

}  // namespace xnewell
