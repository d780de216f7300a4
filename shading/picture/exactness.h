#pragma once

#include <cstdint>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// Does a picture show the right faces? The visibility oracle judges, which takes as long as a picture of
/// that order.

/// Of one sample. Wrong: the picture shows another face than the oracle sees. If the two lie so close there
/// that rounding alone may part them (SnappedFace::doubt), they may be coplanar in the model, and neither is
/// called wrong.
enum class SampleCheck : std::uint8_t { Nothing, Right, Wrong };
/// Of each sample, row by row.
[[nodiscard]] std::vector<SampleCheck> checkedSamples(const Picture& picture);

/// Samples that show a face, and those of them that show a wrong one.
struct Exactness {
  int samples = 0, wrong = 0;
};
[[nodiscard]] Exactness exactnessOf(const Picture& picture);

}  // namespace xnewell
