#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shading/laboratory/errors.h"
#include "shading/laboratory/truth.h"
#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// How wrong is a picture, and where? It is compared with the truth about it (truth.h): the same scene,
/// camera and light, and no short cut. The errors are those of errors.h, after the table.

/// How a difference is measured, one row for each measure.
enum class DifferenceMeasure { Intensity, Color };
struct MeasureRow {
  DifferenceMeasure id;
  double unit;  ///< a difference should stay below this
  std::string_view unitInWords, times, means;
};
inline constexpr std::array kMeasures{
    MeasureRow{DifferenceMeasure::Intensity, 1.0 / 240, "1/240", "x 1/240", "one shade of 240"},
    MeasureRow{DifferenceMeasure::Color, 1.0, "CIEDE2000 1", "CIEDE2000",
               "what the eye just sees side by side"},
};

/// The errors by that measure; Color if the cells hold colours, not ramps.
struct Difference : ErrorMap {
  DifferenceMeasure measure = DifferenceMeasure::Intensity;
  std::int64_t wrongFaces = 0;
};

/// The reference in the picture's own cells, and how far the picture is from it.
struct Compared {
  IndexImage reference;
  Difference difference;
};

/// `picture` is painted; the reference is on its ground.
[[nodiscard]] Compared comparedWithReference(const Picture& picture, const Truth& truth);

/// The errors as an image of the picture's size, in six steps: each is twice as large as the one before, the
/// first is the unit. Without a unit there are two steps: none, and any.
[[nodiscard]] IndexImage stepsImage(const ErrorMap& errors, const CellPlan& plan);
[[nodiscard]] Finding findingOf(const Difference& difference);

/// Both pictures, the difference image, and its numbers in words.
[[nodiscard]] ColoredImage drawDifference(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForDifference(const ViewSettings& settings);

}  // namespace xnewell
