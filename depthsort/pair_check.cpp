#include "depthsort/pair_check.h"

#include <algorithm>
#include <vector>

#include "depthsort/pair_tests.h"

namespace xnewell {

PairCheck checkPairs(const SnappedScene& scene, std::span<const int> order, int width, int height,
                     std::int64_t most) {
  PairTests tests{scene, {.width = width, .height = height}};
  std::vector<ScreenBox> boxes;
  for (const SnappedFace& face : scene.faces)
    boxes.push_back(extentsOf(scene, face, tests.vertexDepthsAreExact(face)).box);
  std::vector<int> place(scene.faces.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  // A sweep from left to right: a face can overlap only those that begin before it ends.
  std::vector<int> byLeft(order.begin(), order.end());
  std::ranges::sort(byLeft, {}, [&](int face) { return boxes[face].x0; });

  PairCheck check;
  for (std::size_t a = 0; a < byLeft.size(); ++a)
    for (std::size_t b = a + 1; b < byLeft.size() && boxes[byLeft[b]].x0 < boxes[byLeft[a]].x1; ++b) {
      int P = byLeft[a], Q = byLeft[b];
      if (!boxes[P].overlaps(boxes[Q])) continue;
      if (++check.pairs > most) {
        check.complete = false;
        return check;
      }
      if (place[P] > place[Q]) std::swap(P, Q);
      const Shape first{scene.faces[P], P, boxes[P], nullptr}, second{scene.faces[Q], Q, boxes[Q], nullptr};
      check.outOfOrder += tests.compare(first, second).verdict != Verdict::PFirst;
    }
  return check;
}

}  // namespace xnewell
