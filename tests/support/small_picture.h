#pragma once

#include <vector>

#include "depthsort/fragment_spans.h"
#include "shading/picture/picture.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

/// The settings of a picture that is quickly made.
inline PictureSettings small() {
  PictureSettings s;
  s.width = 240;
  s.height = 180;
  return s;
}

/// What the scene asks for, in a picture of this size.
inline PictureSettings setUpOf(const Scene& scene, int width, int height) {
  PictureSettings s = scene.settings;
  s.camera = scene.camera;
  s.width = width, s.height = height;
  return s;
}

/// How often the painter paints each sample.
inline std::vector<int> timesPainted(const SnappedScene& scene, int width, int height) {
  std::vector<int> times(std::size_t(width) * height, 0);
  for (const SnappedFace& f : scene.faces)
    forEachSpan(&scene.vertices[f.first], f.count, width, height, [&](int row, int from, int to) {
      for (int i = from; i < to; ++i) ++times[std::size_t(row) * width + i];
    });
  return times;
}

inline IndexImage painted(PictureCache& pictures, const PictureSettings& settings) {
  return pictures.make(settings, 8).image();
}

}  // namespace xnewell
