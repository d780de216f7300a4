#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shading/laboratory/errors.h"
#include "shading/laboratory/ground_truth.h"
#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// How wrong is a picture, and where? It is compared with the truth about it (ground_truth.h): the same
/// scene, camera and light, and no short cut. The errors are those of errors.h, after the table.

/// What two pictures may differ in at a sample, one row for each.
enum class Unlike { Face, Intensity, Color };
struct UnlikeRow {
  Unlike id;
  std::string_view name;
  double unit;   ///< samples count as different above this
  int decimals;  ///< of a difference
  std::string_view differs, same, times, unitText, means;
};
inline constexpr std::array kUnlikes{
    UnlikeRow{Unlike::Face, "face", 0.0, 0, "another face", "same in A and B", "", "", ""},
    UnlikeRow{Unlike::Intensity, "intensity", 1.0 / 240, 4, "differs", "below 1/240", "x 1/240", "1/240",
              "one shade of 240"},
    UnlikeRow{Unlike::Color, "colour", 1.0, 2, "differs", "below 1", "CIEDE2000", "CIEDE2000 1",
              "what the eye just sees side by side"},
};
[[nodiscard]] constexpr const UnlikeRow& rowOf(Unlike kind) {
  return kUnlikes[static_cast<std::size_t>(kind)];
}

/// How unlike two pictures are, or a picture and the truth about it.
struct Difference : ErrorMap {
  Unlike kind = Unlike::Intensity;  ///< for faces an error is 0 or 1
  std::int64_t wrongFaces = 0;      ///< of a picture beside the truth
};

/// The reference in the picture's own cells, and how far the picture is from it.
struct Compared {
  IndexImage reference;
  Difference difference;
};

/// `picture` is painted; the reference is on its ground.
[[nodiscard]] Compared comparedWithReference(const Picture& picture, const GroundTruth& truth);

/// The errors as an image of the picture's size, in six steps: each is twice as large as the one before, the
/// first is the unit. Without a unit there are two steps: none, and any.
[[nodiscard]] IndexImage stepsImage(const ErrorMap& errors, const CellPlan& plan);
[[nodiscard]] Finding findingOf(const Difference& difference);

/// Both pictures, the difference image, and its numbers in words.
[[nodiscard]] ColoredImage drawDifference(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForDifference(const ViewSettings& settings);

}  // namespace xnewell
