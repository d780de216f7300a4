#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "geometry/view/scanline.h"

namespace xnewell {

/// The index of the face painted last at each sample, row by row, with the fragments in their order; kNothing
/// where there is none.
[[nodiscard]] inline std::vector<int> painted(const SnappedScene& scene, const SortedScene& sorted, int width,
                                              int height) {
  std::vector<int> faces(std::size_t(width) * height, kNothing);
  for (const Fragment& fragment : sorted.fragments)
    forEachSpan(scene, sorted, fragment, width, height, [&](int row, int from, int to) {
      const auto begin = faces.begin() + std::ptrdiff_t{row} * width;
      std::fill(begin + from, begin + to, fragment.face);
    });
  return faces;
}

/// Finds where a picture of a model may differ from the oracle's, which takes the rounded scene as exact.

/// True if face p may touch the nearer face q at sample k, as far as the model tells: they lie in two planes,
/// and the plane of q's own corners is not nearer than that of p's by more than the rounding of both.
inline bool mayTouch(const SnappedScene& scene, int p, int q, int k, int width) {
  const SnappedFace &P = scene.faces[p], &Q = scene.faces[q];
  const std::int64_t x = std::int64_t{k % width} * kGrid + kGrid / 2,
                     y = std::int64_t{k / width} * kGrid + kGrid / 2;
  const double zP = depthAt(scene.planes[P.plane], x, y), zQ = depthAt(scene.planes[Q.plane], x, y);
  const auto ahead = [&](const SnappedFace& face) { return scene.planes.ahead(face.part).at(x, y); };
  return P.plane != Q.plane &&
         zQ + ahead(Q) - zP - ahead(P) <= scene.doubtOf(P).at(zP) + scene.doubtOf(Q).at(zQ);
}

/// Calls visit(k, face) for each sample of each face.
template <class Visit>
void forEachSample(const SnappedScene& scene, int width, int height, Visit&& visit) {
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f)
    forEachSpan(&scene.vertices[scene.faces[f].first], scene.faces[f].count, width, height,
                [&](int row, int from, int to) {
                  for (int i = from; i < to; ++i) visit(row * width + i, f);
                });
}

/// The doubtful samples, where a face may touch the face that is seen.
inline std::vector<char> doubtful(const SnappedScene& scene, const std::vector<int>& seen, int width,
                                  int height) {
  std::vector<char> samples(seen.size(), false);
  forEachSample(scene, width, height, [&](int k, int face) {
    samples[k] |= face != seen[k] && mayTouch(scene, face, seen[k], k, width);
  });
  return samples;
}

}  // namespace xnewell
