#include "shading/picture/exactness.h"

#include <cmath>

#include "depthsort/oracle.h"
#include "geometry/view/screen_plane.h"

namespace xnewell {

std::vector<SampleCheck> checkedSamples(const Picture& picture) {
  const int width = picture.settings().width, height = picture.settings().height;
  const Picture complete = picture.withPlanes();
  const SnappedScene& snapped = complete.snapped();
  const auto apart = [&](int p, int q, int i, int j) {
    const SnappedFace &P = snapped.faces[p], &Q = snapped.faces[q];
    const std::int64_t x = std::int64_t{i} * kGrid + kGrid / 2, y = std::int64_t{j} * kGrid + kGrid / 2;
    const double zP = depthAt(snapped.planes[P.plane], x, y), zQ = depthAt(snapped.planes[Q.plane], x, y);
    return P.plane == Q.plane || std::abs(zP - zQ) > P.doubt.at(zP) + Q.doubt.at(zQ);
  };
  const std::vector<int> painted = picture.seen(0, height).faces;
  const std::vector<int> visible = visibleFaces(snapped, width, height);
  std::vector<SampleCheck> verdicts(visible.size(), SampleCheck::Nothing);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const std::size_t k = std::size_t(j) * width + i;
      if (visible[k] == kNothing) continue;
      verdicts[k] = painted[k] == visible[k]              ? SampleCheck::Right
                    : apart(painted[k], visible[k], i, j) ? SampleCheck::Wrong
                                                          : SampleCheck::Doubtful;
    }
  return verdicts;
}

Exactness exactnessOf(const Picture& picture) {
  Exactness exactness;
  for (const SampleCheck verdict : checkedSamples(picture)) {
    exactness.samples += verdict != SampleCheck::Nothing;
    exactness.wrong += verdict == SampleCheck::Wrong;
    exactness.doubtful += verdict == SampleCheck::Doubtful;
  }
  return exactness;
}

}  // namespace xnewell
