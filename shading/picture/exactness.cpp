#include "shading/picture/exactness.h"

#include "depthsort/oracle.h"
#include "geometry/view/touch.h"

namespace xnewell {

SampleCheck checkOf(const SnappedScene& scene, int painted, int visible, int i, int j) {
  if (painted == visible) return SampleCheck::Right;
  if (painted == kNothing) return SampleCheck::Wrong;
  const std::int64_t x = std::int64_t{i} * kGrid + kGrid / 2, y = std::int64_t{j} * kGrid + kGrid / 2;
  const SnappedFace &front = scene.faces[visible], &behind = scene.faces[painted];
  if (front.plane == behind.plane) return SampleCheck::Earlier;
  return mayTouch(scene, front, behind, x, y) ? SampleCheck::Doubtful : SampleCheck::Wrong;
}

std::vector<SampleCheck> checkedSamples(const Picture& picture) {
  const int width = picture.settings().width, height = picture.settings().height;
  const Picture complete = picture.withPlanes();
  const SnappedScene& snapped = complete.snapped();
  const std::vector<int> painted = picture.seen(0, height).faces;
  const std::vector<int> visible = visibleFaces(snapped, width, height);
  std::vector<SampleCheck> verdicts(visible.size(), SampleCheck::Nothing);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const std::size_t k = std::size_t(j) * width + i;
      if (visible[k] != kNothing) verdicts[k] = checkOf(snapped, painted[k], visible[k], i, j);
    }
  return verdicts;
}

Exactness exactnessOf(std::span<const SampleCheck> verdicts) {
  Exactness exactness;
  for (const SampleCheck verdict : verdicts) {
    exactness.samples += verdict != SampleCheck::Nothing;
    exactness.wrong += isWrong(verdict);
    exactness.earlier += verdict == SampleCheck::Earlier;
    exactness.doubtful += verdict == SampleCheck::Doubtful;
  }
  return exactness;
}

Exactness exactnessOf(const Picture& picture) { return exactnessOf(checkedSamples(picture)); }

}  // namespace xnewell
