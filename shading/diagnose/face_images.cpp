#include "shading/diagnose/face_images.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>

#include "depthsort/oracle.h"
#include "shading/course/scan_conversion.h"

namespace xnewell {

namespace {

/// The faces by their nearest z, farthest first.
std::vector<int> byNearestZ(const SnappedScene& scene) {
  std::vector<int> order(scene.faces.size()), nearest(scene.faces.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t f = 0; f < order.size(); ++f) {
    const SnappedFace& face = scene.faces[f];
    nearest[f] = scene.vertices[face.first].z;
    for (int k = 1; k < face.count; ++k) nearest[f] = std::max(nearest[f], scene.vertices[face.first + k].z);
  }
  std::ranges::stable_sort(order, {}, [&](int f) { return nearest[f]; });
  return order;
}

}  // namespace

std::vector<int> paintedOver(const SnappedScene& scene, int width, int height,
                             const std::vector<int>& order) {
  std::vector<int> shown(static_cast<std::size_t>(width) * height, kNothing);
  for (const int f : order) {
    const SnappedFace& face = scene.faces[f];
    const std::span outline{scene.vertices.data() + face.first, static_cast<std::size_t>(face.count)};
    for (const ScanSpan& span : spansOf(edgesOf(outline))) {
      if (span.row < 0 || span.row >= height) continue;
      const int from = std::clamp(span.from, 0, width), to = std::clamp(span.to, from, width);
      const auto row = shown.begin() + static_cast<std::ptrdiff_t>(span.row) * width;
      std::fill(row + from, row + to, f);
    }
  }
  return shown;
}

std::vector<int> facesShown(const SnappedScene& scene, int width, int height, PaintWay way) {
  std::vector<int> order(scene.faces.size());
  std::iota(order.begin(), order.end(), 0);
  switch (way) {
    case PaintWay::Nearest:
      return visibleFaces(scene, width, height);
    case PaintWay::Listed:
      break;
    case PaintWay::Reversed:
      order = paintingOrder(scene, Order::ZSort);
      std::ranges::reverse(order);
      break;
    case PaintWay::NearestZ:
      order = byNearestZ(scene);
      break;
    case PaintWay::BacksOnly: {
      SnappedScene backs = scene;
      std::erase_if(backs.faces, [](const SnappedFace& f) { return !f.back; });
      std::erase_if(order, [&](int f) { return !scene.faces[f].back; });
      std::vector<int> shown = visibleFaces(backs, width, height);
      for (int& f : shown)
        if (f != kNothing) f = order[f];
      return shown;
    }
  }
  return paintedOver(scene, width, height, order);
}

}  // namespace xnewell
