#include "shading/picture.h"

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "geometry/screen_plane.h"
#include "shading/fill.h"
#include "shading/fragment_spans.h"

namespace {

/// Runs a stage, or a part of one, and adds the time it took.
template <class Stage>
void timed(double& ms, Stage&& stage) {
  const Stopwatch watch;
  stage();
  ms += watch.ms();
}

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

  // What changed since the results that are kept; until all is done none count, for a stage may throw.
  // At full intensity nothing is lit, and what was lit before is stale afterwards.
  const bool lit = next.shading != Shading::Full;
  const bool newLight = lit && (!any_ || made_.shading == Shading::Full || next.light != made_.light);
  const bool newEye = lit && (newLight || camera.eye != camera_.eye || camera.lookAt != camera_.lookAt);
  const bool newView = !any_ || camera.view != camera_.view || next.width != made_.width ||
                       next.height != made_.height || next.cull != made_.cull;
  const bool newOrder = newView || next.order != made_.order || next.inPixels != made_.inPixels;
  const bool newTable = !table_ || next.table != made_.table;
  any_ = false;

  // Shading, in world coordinates: once when a face is made, the specular term again when the eye moves.
  timed(times_.shade, [&] {
    if (newLight) faces_ = shadeFaces(scene_.mesh, next.light);
    if (newEye) shadeSpecular(faces_, next.light, camera.eye, camera.lookAt);
  });

  // View, shear, warp, clip, viewport, and one snap to the grid, from where all is exact.
  if (newView)
    timed(times_.transform, [&] {
      snapped_ = project(scene_.mesh, scene_.pieces, camera.view, next.width, next.height, next.cull);
    });

  // Back to front.
  if (newOrder)
    timed(times_.sort, [&] {
      sorted_ = {};
      visible_.clear();
      if (next.order == Order::Oracle)
        visible_ = visibleFaces(snapped_, next.width, next.height);
      else if (next.order == Order::Newell)
        sorted_ =
            depthSort(snapped_, {.width = next.width, .height = next.height, .inPixels = next.inPixels});
      else
        for (const int face : paintingOrder(snapped_, next.order)) sorted_.fragments.push_back({face});
    });

  // Intensities to cells of the colour table.
  if (newTable) table_.emplace(next.table);
  timed(times_.fill, [&] {
    cells_.resize(snapped_.faces.size());
    std::ranges::transform(snapped_.faces, cells_.begin(), [&](const SnappedFace& f) {
      const double I = next.shading == Shading::Full ? 1.0 : faces_[f.number].I[f.back];
      return static_cast<std::uint8_t>(table_->cell(I));
    });
  });

  camera_ = camera;
  made_ = next;
  any_ = true;
}

template <class Span>
void Picture::paintFaces(Span&& span) const {
  if (made_.order != Order::Oracle) {
    for (const Fragment& fragment : sorted_.fragments)
      forEachSpan(snapped_, sorted_, fragment, made_.width, made_.height,
                  [&](int row, int from, int to) { span(row, from, to, fragment.face); });
    return;
  }
  for (int j = 0; j < made_.height; ++j) {
    const int* const row = visible_.data() + std::ptrdiff_t(j) * made_.width;
    for (int from = 0, to = 0; from < made_.width; from = to) {
      while (to < made_.width && row[to] == row[from]) ++to;
      if (row[from] != kNothing) span(j, from, to, row[from]);
    }
  }
}

void Picture::fillFaces(IndexImage& image) const {
  // In depth order each face lies elsewhere in memory: fetch it while those before it are filled.
  const std::size_t count = sorted_.fragments.size();
  const auto ahead = [&](std::size_t k) -> const SnappedFace& {
    return snapped_.faces[sorted_.fragments[std::min(k, count - 1)].face];
  };
  for (std::size_t k = 0; k < count; ++k) {
    __builtin_prefetch(&ahead(k + 16));
    __builtin_prefetch(&snapped_.vertices[ahead(k + 8).first]);
    const Fragment& fragment = sorted_.fragments[k];
    const SnappedFace& face = snapped_.faces[fragment.face];
    const std::uint8_t cell = cells_[fragment.face];
    if (fragment.piece < 0)
      fillConvex(image, &snapped_.vertices[face.first], face.count, FlatCell{cell});
    else
      forEachSpan(snapped_, sorted_, fragment, made_.width, made_.height,
                  [&](int row, int from, int to) { fillSpan(image.row(row) + from, to - from, cell); });
  }
}

void Picture::paint(IndexImage& image, std::uint8_t ground) {
  const Stopwatch watch;
  image.width = made_.width;
  image.height = made_.height;
  image.pixels.assign(std::size_t(made_.width) * made_.height, ground);
  if (made_.order == Order::Oracle) {
    paintFaces([&](int row, int from, int to, int face) {
      std::fill(image.row(row) + from, image.row(row) + to, cells_[face]);
    });
  } else {
    fillFaces(image);
  }
  times_.fill += watch.ms();
}

std::vector<std::uint32_t> Picture::faceImage() const {
  std::vector<std::uint32_t> image(std::size_t(made_.width) * made_.height, 0);
  paintFaces([&](int row, int from, int to, int face) {
    const auto begin = image.begin() + std::ptrdiff_t(row) * made_.width;
    std::fill(begin + from, begin + to, static_cast<std::uint32_t>(snapped_.faces[face].number) + 1);
  });
  return image;
}

Picture::Exactness Picture::exactness() const {
  std::vector<int> painted(std::size_t(made_.width) * made_.height, kNothing);
  paintFaces([&](int row, int from, int to, int face) {
    const auto begin = painted.begin() + std::ptrdiff_t(row) * made_.width;
    std::fill(begin + from, begin + to, face);
  });
  const auto apart = [&](int p, int q, int i, int j) {
    const SnappedFace &P = snapped_.faces[p], &Q = snapped_.faces[q];
    const std::int64_t x = std::int64_t{i} * kGrid + kGrid / 2, y = std::int64_t{j} * kGrid + kGrid / 2;
    const double zP = depthAt(snapped_.planes[P.plane], x, y), zQ = depthAt(snapped_.planes[Q.plane], x, y);
    return P.plane == Q.plane || std::abs(zP - zQ) > P.doubt.at(zP) + Q.doubt.at(zQ);
  };
  const std::vector<int> visible = visibleFaces(snapped_, made_.width, made_.height);
  Exactness exactness;
  for (int j = 0; j < made_.height; ++j)
    for (int i = 0; i < made_.width; ++i) {
      const std::size_t k = std::size_t(j) * made_.width + i;
      if (visible[k] == kNothing) continue;
      ++exactness.samples;
      exactness.wrong += painted[k] != visible[k] && apart(painted[k], visible[k], i, j);
    }
  return exactness;
}

int Picture::saturated() const {
  if (made_.shading == Shading::Full) return 0;
  return static_cast<int>(std::ranges::count(faces_, true, &FaceShade::clamped));
}
