#include "depthsort/z_buffer.h"

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "geometry/view/scanline.h"

namespace xnewell {

namespace {

/// The level of a face's plane over the screen, not rounded, plus 1/2.
class LevelPlane {
 public:
  LevelPlane(const SnappedScene& scene, const SnappedFace& face, double perStep) {
    const glm::ivec3* const v = &scene.vertices[face.first];
    const ScreenPlane plane = planeThrough(v, face.count);
    const double perUnit = perStep / static_cast<double>(plane.C);
    x_ = (static_cast<double>(v->x) - kGrid / 2) / kGrid,
    y_ = (static_cast<double>(v->y) - kGrid / 2) / kGrid;
    atVertex_ = depthAt(plane, v->x, v->y) * perStep + 0.5;
    right_ = static_cast<double>(plane.A) * perUnit * kGrid;
    down_ = static_cast<double>(plane.B) * perUnit * kGrid;
  }
  /// At the centre of pixel (i, j); and how much it grows to the right.
  [[nodiscard]] double at(int i, int j) const { return (i - x_) * right_ + ((j - y_) * down_ + atVertex_); }
  [[nodiscard]] double right() const { return right_; }

 private:
  double x_, y_;  ///< of the first vertex, in pixels from the centre of pixel (0, 0)
  double atVertex_, right_, down_;
};

template <class Level>
ZBuffer filled(const SnappedScene& scene, double perStep, double last, int width, int height) {
  const std::size_t samples = std::size_t(width) * height;
  std::vector<Level> levels(samples, 0);
  ZBuffer buffer{std::vector<int>(samples, kNothing), 0, static_cast<std::int64_t>(samples * sizeof(Level))};
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
    const SnappedFace& face = scene.faces[f];
    const LevelPlane plane{scene, face, perStep};
    forEachSpan(&scene.vertices[face.first], face.count, width, height, [&](int row, int from, int to) {
      const std::size_t start = std::size_t(row) * width + from;
      Level* const nearest = levels.data() + start;
      int* const seen = buffer.faces.data() + start;
      const double first = plane.at(from, row), right = plane.right();
      for (int k = 0; k < to - from; ++k) {
        const auto level = static_cast<Level>(std::clamp(first + k * right, 0.0, last + 0.5));
        if (level >= nearest[k]) nearest[k] = level, seen[k] = f;
      }
      buffer.tests += to - from;
    });
  }
  return buffer;
}

}  // namespace

ZBuffer zBuffer(const SnappedScene& scene, const ViewSpec& view, int bits, int width, int height) {
  const double front = std::ldexp(frontDepth(view, width), kGridBits - scene.zShift);  // in z steps
  const double last = std::ldexp(1.0, bits) - 1.0, perStep = last / front;
  return bits == 16 ? filled<std::uint16_t>(scene, perStep, last, width, height)
                    : filled<std::uint32_t>(scene, perStep, last, width, height);
}

}  // namespace xnewell
