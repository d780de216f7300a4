#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// Checks whether a picture shows the right faces. The visibility oracle is the judge. The check takes as
/// long as a picture with Order::Oracle.

/// The verdict on one sample. It is Wrong if the picture shows another face than the oracle sees, and the
/// oracle's is nearer; Earlier, which is wrong too, if both lie in one plane, where the later face should
/// win. There is one exception: rounding alone may separate two faces in different planes (mayTouch() in
/// scene_planes.h). They may touch in the model, so neither counts as wrong: the sample is Doubtful.
enum class SampleCheck : std::uint8_t { Nothing, Right, Doubtful, Wrong, Earlier };
[[nodiscard]] constexpr bool isWrong(SampleCheck verdict) {
  return verdict == SampleCheck::Wrong || verdict == SampleCheck::Earlier;
}
/// The verdict on the sample of pixel (i, j) that shows the face `painted` where the oracle sees `visible`;
/// both are indices into the faces of a scene with planes, `visible` is not kNothing.
[[nodiscard]] SampleCheck checkOf(const SnappedScene& scene, int painted, int visible, int i, int j);
/// The verdict on each sample, row by row.
[[nodiscard]] std::vector<SampleCheck> checkedSamples(const Picture& picture);

/// `samples` counts the samples that show a face, `wrong` those that show a wrong face, and `earlier` those
/// of the wrong ones whose face lies in the plane of the right one. `doubtful` counts those that show a
/// farther face which rounding alone may part from the nearest.
struct Exactness {
  int samples = 0, wrong = 0, earlier = 0, doubtful = 0;
};
[[nodiscard]] Exactness exactnessOf(std::span<const SampleCheck> verdicts);
[[nodiscard]] Exactness exactnessOf(const Picture& picture);

}  // namespace xnewell
