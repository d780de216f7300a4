#include "x11/viewing/stage_image.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/view/at_source.h"

namespace xnewell {

namespace {

constexpr float kFarthest = -std::numeric_limits<float>::infinity();

/// The four corners of the volume at n, in VRC.
std::array<glm::dvec3, 4> cornersAt(const ViewSpec& view, double n) {
  const glm::dvec2 low = view.windowMin, high = view.windowMax;
  const std::array<glm::dvec2, 4> window{low, glm::dvec2{high.x, low.y}, high, glm::dvec2{low.x, high.y}};
  const glm::dvec2 towardsEye = glm::dvec2{view.prp} - (low + high) / 2.0;  // per prp.z along n
  std::array<glm::dvec3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const double share = n / view.prp.z;
    const glm::dvec2 uv = view.projection == Projection::Parallel
                              ? window[k] + share * towardsEye
                              : window[k] + share * (glm::dvec2{view.prp} - window[k]);
    corners[k] = {uv, n};
  }
  return corners;
}

/// Calls map(place in VRC) for all corners of the volume.
template <class Map>
StageVolume mappedVolume(const ViewSpec& view, const Map& map) {
  StageVolume volume;
  volume.parallel = view.projection == Projection::Parallel;
  const auto all = [&](double n) {
    std::array<glm::dvec3, 4> corners = cornersAt(view, n);
    for (glm::dvec3& p : corners) p = map(p);
    return corners;
  };
  volume.front = all(view.front), volume.window = all(0.0), volume.back = all(view.back);
  return volume;
}

/// The axes of a stage: right, up and towards the viewer, as columns.
glm::dmat3 axesOf(const Picture& picture, ViewStage stage) {
  if (stage >= ViewStage::Viewport) return {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  if (stage != ViewStage::World) return glm::dmat3{1.0};
  const glm::dvec3 up = upVector(picture.scene().up), n = unit(picture.camera().view.vpn);
  glm::dvec3 towards = unit(n - up * glm::dot(n, up));
  if (glm::length(towards) < 0.5) towards = unit(glm::dvec3{up.y, up.z, up.x});
  return {glm::cross(up, towards), up, towards};
}

glm::dvec3 dividedByW(const glm::dvec4& p) { return glm::dvec3{p} / p.w; }

}  // namespace

StageVolume volumeAt(const ViewingStory& story, const ViewSpec& view, ViewStage stage) {
  const glm::dmat3 toWorld = glm::transpose(vrcRotation(view));
  const auto world = [&](const glm::dvec3& vrc) { return view.vrp + toWorld * vrc; };
  StageVolume volume =
      mappedVolume(view, [&](const glm::dvec3& p) { return dividedByW(story.stages.at(stage, world(p))); });
  if (stage <= ViewStage::Sheared) volume.eye = glm::dvec3{story.stages.at(stage, world(view.prp))};
  return volume;
}

std::optional<StageVolume> volumeBefore(const ViewingStory& story, const ViewSpec& view, ViewStage stage) {
  const ViewMatrices m = viewMatrices(view);
  if (stage == ViewStage::Sheared && story.stages.matrix(stage)[2] != glm::dvec4{0, 0, 1, 0}) {
    StageVolume volume = mappedVolume(view, [&](const glm::dvec3& p) {
      return glm::dvec3{m.minusPrp * glm::dvec4{p, 1.0}};
    });
    volume.eye = glm::dvec3{m.minusPrp * glm::dvec4{view.prp, 1.0}};
    return volume;
  }
  if (stage != ViewStage::Warped || view.projection == Projection::Parallel) return std::nullopt;
  StageVolume volume = mappedVolume(view, [&](const glm::dvec3& p) {
    return glm::dvec3{m.S * (m.SH * (m.minusPrp * glm::dvec4{p, 1.0}))};
  });
  volume.eye = glm::dvec3{0.0};
  return volume;
}

StagePoints::StagePoints(const Mesh& mesh, const ViewStages& stages) : mesh_{mesh} {
  constexpr double kLeastW = 1e-3;  // nearer to the eye's own plane a place is thrown far away
  for (std::vector<glm::dvec3>& at : at_) at.reserve(mesh.points.size());
  near_.reserve(mesh.points.size());
  for (const glm::dvec3& p : mesh.points) {
    const glm::dvec4 vrc = stages.at(ViewStage::Vrc, p), sheared = stages.matrix(ViewStage::Sheared) * vrc;
    const glm::dvec4 warped = stages.matrix(ViewStage::Warped) * sheared;
    const bool near = warped.w > kLeastW;
    at_[0].push_back(dividedByW(vrc));
    at_[1].push_back(dividedByW(sheared));
    at_[2].push_back(near ? dividedByW(warped) : glm::dvec3{0.0});
    near_.push_back(near ? 1 : 0);
  }
}

StageImage::StageImage(const Picture& picture, const LitParts& lit, const ViewingStory& story,
                       const StagePoints& points, ViewStage stage, const OutsideTurn& turn, glm::ivec2 size,
                       std::uint8_t ground, int margin, const OutsideCamera* held, StageMemory memory)
    : image_{std::move(memory.image)},
      depth_{std::move(memory.depth)},
      face_{std::move(memory.face)},
      volume_{volumeAt(story, picture.camera().view, stage)} {
  image_.width = size.x, image_.height = size.y;
  image_.pixels.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), ground);
  depth_.assign(image_.pixels.size(), kFarthest);
  face_.resize(image_.pixels.size());  // faceAt() asks the depth first
  if (held) {
    camera_ = *held;
  } else {
    std::vector<glm::dvec3> around;
    if (stage < ViewStage::Warped) around = points.at(stage);
    for (const auto* corners : {&volume_.front, &volume_.window, &volume_.back})
      around.insert(around.end(), corners->begin(), corners->end());
    if (volume_.eye) around.push_back(*volume_.eye);
    if (const auto before = volumeBefore(story, picture.camera().view, stage);
        before && stage == ViewStage::Warped) {
      around.insert(around.end(), before->front.begin(), before->front.end());
      around.insert(around.end(), before->back.begin(), before->back.end());
      around.emplace_back(0.0);
    }
    place(around, turn, axesOf(picture, stage), margin);
  }
  if (stage <= ViewStage::Warped)
    addMesh(picture, lit, points, stage);
  else
    addSnapped(picture, lit, stage);
}

/// Turns the axes, then fits what stands around into the image.
void StageImage::place(const std::vector<glm::dvec3>& points, const OutsideTurn& turn, const glm::dmat3& axes,
                       int margin) {
  constexpr double kFilled = 0.82;
  const SinCos a = sinCosDegrees(turn.around), d = sinCosDegrees(turn.down);
  const glm::dvec3 right = a.cos * axes[0] - a.sin * axes[2], level = a.sin * axes[0] + a.cos * axes[2];
  camera_.turn =
      glm::transpose(glm::dmat3{right, d.cos * axes[1] - d.sin * level, d.sin * axes[1] + d.cos * level});
  glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-low};
  for (const glm::dvec3& p : points) {
    const glm::dvec2 q{camera_.turn * p};
    if (!std::isfinite(q.x) || !std::isfinite(q.y)) continue;
    low = glm::min(low, q), high = glm::max(high, q);
  }
  const glm::dvec2 extent = glm::max(high - low, glm::dvec2{1e-300});
  const glm::dvec2 size{image_.width, image_.height};
  const glm::dvec2 room{kFilled * size.x, std::max(1.0, std::min(kFilled * size.y, size.y - 2.0 * margin))};
  camera_.scale = turn.zoom * std::min(room.x / extent.x, room.y / extent.y);
  const glm::dvec2 middle = (low + high) / 2.0;
  camera_.shift = {size.x / 2.0 - camera_.scale * middle.x, size.y / 2.0 + camera_.scale * middle.y};
}

void StageImage::addMesh(const Picture& picture, const LitParts& lit, const StagePoints& points,
                         ViewStage stage) {
  const ConvexParts& parts = picture.scene().parts;
  std::vector<glm::dvec3> seen;
  seen.reserve(points.at(stage).size());
  for (const glm::dvec3& p : points.at(stage)) seen.push_back(camera_(p));
  std::vector<Corner> corners;
  for (int k = 0; k < parts.count(); ++k) {
    const std::span<const int> part = parts.part(k);
    if (stage == ViewStage::Warped && !std::ranges::all_of(part, [&](int p) { return points.staysNear(p); }))
      continue;
    double area = 0.0;  // positive if it runs counter-clockwise, with y up
    for (std::size_t c = 1; c + 1 < part.size(); ++c) {
      const glm::dvec3 u = seen[part[c]] - seen[part[0]], v = seen[part[c + 1]] - seen[part[0]];
      area -= u.x * v.y - u.y * v.x;
    }
    const bool back = area < 0.0;
    corners.clear();
    for (std::size_t c = 0; c < part.size(); ++c)
      corners.push_back(
          {seen[part[c]], lit.at(parts.from[parts.firstCorner[k] + static_cast<int>(c)], back)});
    const int face = parts.face[k];
    const CellOnRamp* const ramp = lit.ramp(face);
    polygon(corners, ramp, ramp ? 0 : lit.cell(face, back), face);
  }
}

/// The polygons of the picture, from their grid: in pixels, or as shares of the volume.
void StageImage::addSnapped(const Picture& picture, const LitParts& lit, ViewStage stage) {
  const SnappedScene& scene = picture.snapped();
  const double zStep = std::ldexp(1.0, scene.zShift - kGridBits);
  const glm::dvec2 half{picture.settings().width / 2.0, picture.settings().height / 2.0};
  const double zFront = frontDepth(picture.camera().view, picture.settings().width);
  const bool refined = picture.shading().refined().has_value();
  std::vector<Corner> corners;
  for (const SnappedFace& f : scene.faces) {
    corners.clear();
    double area = 0.0;
    for (int k = f.first; k < f.first + f.count; ++k) {
      const glm::ivec3& v = scene.vertices[k];
      glm::dvec3 p{v.x / double{kGrid}, v.y / double{kGrid}, v.z * zStep};
      if (stage == ViewStage::Clipped) p = {p.x / half.x - 1.0, 1.0 - p.y / half.y, p.z / zFront - 1.0};
      corners.push_back({camera_(p), 0.0});
      if (k < f.first + 2) continue;
      const glm::dvec3 u = corners[corners.size() - 2].at - corners[0].at,
                       w = corners.back().at - corners[0].at;
      area -= u.x * w.y - u.y * w.x;
    }
    const bool back = (area < 0.0) != f.back;
    for (int k = 0; k < f.count; ++k) {
      const int first = picture.scene().mesh.firstCorner[f.number];
      corners[static_cast<std::size_t>(k)].I =
          refined
              ? lit.at(first, back)
              : atSource(scene, scene.source[f.first + k], [&](int corner) { return lit.at(corner, back); });
    }
    const CellOnRamp* const ramp = lit.ramp(f.number);
    polygon(corners, ramp, ramp ? 0 : lit.cell(f.number, back), f.number);
  }
}

void StageImage::polygon(const std::vector<Corner>& corners, const CellOnRamp* ramp, std::uint8_t cell,
                         int face) {
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    triangle(corners[0], corners[k], corners[k + 1], ramp, cell, face);
}

void StageImage::triangle(const Corner& a, const Corner& b, const Corner& c, const CellOnRamp* ramp,
                          std::uint8_t cell, int face) {
  if (!std::isfinite(a.at.x + a.at.y + b.at.x + b.at.y + c.at.x + c.at.y)) return;
  // The first sample at a place or after it, within the image.
  const auto clamped = [](double place, int most) {
    const double p = place - 0.5;
    if (!(p > 0.0)) return 0;
    if (p >= most) return most;
    const int k = static_cast<int>(p);
    return k + (k < p ? 1 : 0);
  };
  const int first = clamped(std::min({a.at.y, b.at.y, c.at.y}), image_.height);
  const int end = clamped(std::max({a.at.y, b.at.y, c.at.y}), image_.height);
  // Most triangles of a small drawing lie between the samples.
  if (first >= end || clamped(std::min({a.at.x, b.at.x, c.at.x}), image_.width) >=
                          clamped(std::max({a.at.x, b.at.x, c.at.x}), image_.width))
    return;
  const glm::dvec3 u = b.at - a.at, v = c.at - a.at;
  const double area = u.x * v.y - u.y * v.x;
  if (!(std::abs(area) > 1e-9) || !std::isfinite(area)) return;
  // z and I are linear over the image.
  const auto slopes = [&](double alongU, double alongV) {
    return glm::dvec2{(alongU * v.y - alongV * u.y) / area, (alongV * u.x - alongU * v.x) / area};
  };
  const glm::dvec2 ofZ = slopes(u.z, v.z), ofI = slopes(b.I - a.I, c.I - a.I);
  // Each edge from its upper end, so that the faces on both sides of it end at the same places.
  struct Edge {
    double top, bottom, x, slope;
  };
  const auto edge = [](const glm::dvec3& p, const glm::dvec3& q) {
    const auto& [upper, lower] = std::minmax(p, q, [](const auto& s, const auto& t) { return s.y < t.y; });
    return Edge{upper.y, lower.y, upper.x, (lower.x - upper.x) / (lower.y - upper.y)};
  };
  const std::array edges{edge(a.at, b.at), edge(b.at, c.at), edge(c.at, a.at)};
  for (int j = first; j < end; ++j) {
    const double y = j + 0.5;
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (const Edge& e : edges) {
      if (!(e.top <= y && y < e.bottom)) continue;
      const double x = e.x + e.slope * (y - e.top);
      from = std::min(from, x), to = std::max(to, x);
    }
    const int start = clamped(from, image_.width), stop = clamped(to, image_.width);
    if (start >= stop) continue;
    const std::size_t row = static_cast<std::size_t>(j) * image_.width;
    double z = a.at.z + ofZ.x * (start + 0.5 - a.at.x) + ofZ.y * (y - a.at.y);
    double I = a.I + ofI.x * (start + 0.5 - a.at.x) + ofI.y * (y - a.at.y);
    for (int i = start; i < stop; ++i, z += ofZ.x, I += ofI.x) {
      if (!(static_cast<float>(z) > depth_[row + i])) continue;
      depth_[row + i] = static_cast<float>(z);
      face_[row + i] = face;
      image_.pixels[row + i] = ramp ? (*ramp)(I) : cell;
    }
  }
}

int StageImage::faceAt(int x, int y) const {
  if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return -1;
  const std::size_t at = static_cast<std::size_t>(y) * image_.width + x;
  return depth_[at] == kFarthest ? -1 : face_[at];
}

bool StageImage::shows(const glm::dvec3& place) const {
  const double x = std::floor(place.x), y = std::floor(place.y);
  if (!(x >= 0 && y >= 0 && x < image_.width && y < image_.height)) return true;
  const float depth = depth_[static_cast<std::size_t>(y) * image_.width + static_cast<std::size_t>(x)];
  return static_cast<float>(place.z) >= depth - 0.5f;
}

}  // namespace xnewell
