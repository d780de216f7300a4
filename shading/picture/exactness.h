#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// Checks whether a picture shows the right faces. The visibility oracle is the judge. The check takes as
/// long as a picture with Order::Oracle.

/// The verdict on one sample. It is Wrong if the picture shows another face than the oracle sees. There is
/// one exception: rounding alone may separate two faces in different planes (mayTouch() in touch.h).
/// They may touch in the model, so neither counts as wrong: the sample is Doubtful.
enum class SampleCheck : std::uint8_t { Nothing, Right, Doubtful, Wrong };
/// The verdict on each sample, row by row.
[[nodiscard]] std::vector<SampleCheck> checkedSamples(const Picture& picture);

/// `samples` counts the samples that show a face, `wrong` those that show a wrong face, `doubtful` those that
/// show a farther face which rounding alone may part from the nearest.
struct Exactness {
  int samples = 0, wrong = 0, doubtful = 0;
};
[[nodiscard]] Exactness exactnessOf(std::span<const SampleCheck> verdicts);
[[nodiscard]] Exactness exactnessOf(const Picture& picture);

}  // namespace xnewell
