#include "shading/laboratory/exactness.h"

#include <algorithm>
#include <utility>

#include "depthsort/oracle.h"
#include "geometry/view/scene_planes.h"

namespace xnewell {

SampleCheck checkOf(const SnappedScene& scene, int painted, int visible, int i, int j) {
  if (painted == visible) return SampleCheck::Right;
  if (painted == kNothing) return SampleCheck::Wrong;
  const std::int64_t x = std::int64_t{i} * kGrid + kGrid / 2, y = std::int64_t{j} * kGrid + kGrid / 2;
  const SnappedFace &front = scene.faces[visible], &behind = scene.faces[painted];
  if (front.plane == behind.plane) return SampleCheck::Earlier;
  return mayTouch(scene, front, behind, x, y) ? SampleCheck::Doubtful : SampleCheck::Wrong;
}

namespace {

/// Calls use(verdicts) for one band of rows after the other, with verdicts on its samples.
template <class Use>
void forEachBand(const Picture& picture, int rowsInBand, Use&& use) {
  const int width = picture.settings().width, height = picture.settings().height;
  const Picture complete = picture.withPlanes();
  const SnappedScene& snapped = complete.snapped();
  VisibleFaces oracle{snapped};
  std::vector<SampleCheck> verdicts;
  for (int first = 0; first < height; first += rowsInBand) {
    const int end = std::min(height, first + rowsInBand);
    const std::vector<int> painted = picture.seen(first, end).faces, visible = oracle.rows(first, end, width);
    verdicts.assign(visible.size(), SampleCheck::Nothing);
    for (int j = first; j < end; ++j)
      for (int i = 0; i < width; ++i) {
        const std::size_t k = std::size_t(j - first) * width + i;
        if (visible[k] != kNothing) verdicts[k] = checkOf(snapped, painted[k], visible[k], i, j);
      }
    use(verdicts);
  }
}

}  // namespace

std::vector<SampleCheck> checkedSamples(const Picture& picture) {
  std::vector<SampleCheck> all;
  forEachBand(picture, picture.settings().height,
              [&](std::vector<SampleCheck>& verdicts) { all = std::move(verdicts); });
  return all;
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

Exactness exactnessOf(const Picture& picture) {
  constexpr int kSamplesInBand = 1 << 17;  // they stay in the second cache
  Exactness all;
  forEachBand(picture, std::max(1, kSamplesInBand / picture.settings().width),
              [&](const std::vector<SampleCheck>& verdicts) {
                const Exactness band = exactnessOf(verdicts);
                all.samples += band.samples, all.wrong += band.wrong;
                all.earlier += band.earlier, all.doubtful += band.doubtful;
              });
  return all;
}

}  // namespace xnewell
