#include "x11/stepper/fragment_tint.h"

#include <algorithm>

#include "depthsort/fragment_spans.h"

namespace xnewell {

Fragment fragmentOf(const SnappedScene& scene, const SortedScene& sorted, int id) {
  const int faces = static_cast<int>(scene.faces.size());
  return id < faces ? Fragment{id} : Fragment{sorted.pieces[id - faces].face, id - faces};
}

Samples tintFragment(Painter paint, const Rect& at, glm::ivec2 size, const SnappedScene& scene,
                     const SortedScene& sorted, int id, std::optional<Stipple> tint, std::uint8_t cell) {
  const Rect all = at * paint.unit();
  const double scale = 1.0 * all.width / size.x;
  Painter fine = paint.pixels();
  const auto pixel = [&](std::int64_t sample) {
    return static_cast<int>(scale * static_cast<double>(sample));
  };
  std::int64_t x = 0, y = 0, samples = 0;
  forEachSpan(scene, sorted, fragmentOf(scene, sorted, id), size.x, size.y, [&](int row, int from, int to) {
    samples += to - from, y += std::int64_t{row} * (to - from),
        x += std::int64_t{from + to} * (to - from) / 2;
    if (tint)
      fine.stipple({all.x + pixel(from), all.y + pixel(row), pixel(to) - pixel(from),
                    std::max(1, pixel(row + 1) - pixel(row))},
                   *tint, cell);
  });
  if (samples == 0) return {};
  const int unit = paint.unit();
  return {static_cast<std::int64_t>(scale * scale * static_cast<double>(samples)),
          at.x + pixel(x / samples) / unit, at.y + pixel(y / samples) / unit};
}

std::int64_t samplesWithin(const SnappedScene& scene, const SortedScene& sorted, int id, const Rect& area) {
  std::int64_t samples = 0;
  forEachSpan(scene, sorted, fragmentOf(scene, sorted, id), area.x + area.width, area.y + area.height,
              [&](int row, int from, int to) {
                if (row >= area.y) samples += std::max(0, to - std::max(from, area.x));
              });
  return samples;
}

bool owns(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment, int column,
          int row) {
  bool found = false;
  const SnappedFace& face = scene.faces[fragment.face];
  forEachSpan(&scene.vertices[face.first], face.count, row, column + 1, row + 1,
              [&](int j, int from, int to) {
                Columns columns{from, to};
                if (fragment.piece >= 0)
                  columns = PieceWalk{scene, sorted, sorted.pieces[fragment.piece]}.within(j, columns);
                found |= columns.from <= column && column < columns.to;
              });
  return found;
}

}  // namespace xnewell
