#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/images.h"
#include "shading/color/quantize.h"
#include "shading/laboratory/errors.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture.h"
#include "shading/scene/picture_settings.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// A picture in full colour with colours of its own in the scene's cells, on the dark background. The rest of
/// its palette is `palette`. The cube of a plan of colours stays as it is.
[[nodiscard]] inline ColoredImage inOwnColors(const RgbImage& colors, Shows shows, bool dither,
                                              const PictureSettings& settings, const CellPlan& plan,
                                              const Palette& palette) {
  const bool cube = settings.colors == ColorPlan::Cube;
  const int first = kTables[static_cast<int>(settings.table.kind)].first;
  ColoredImage own{{colors.width, colors.height, plan[Cell::Well]}, palette};
  const std::vector<Rgb16> chosen = quantize(
      colors, shows,
      {.quantizer = cube ? Quantizer::Cube : Quantizer::Chosen, .dither = dither || cube, .first = first},
      own.image);
  std::ranges::copy(chosen, own.palette.begin() + first);
  return own;
}

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

/// How often each sample was painted. The painter's algorithm paints many samples more than once: this is the
/// price of its simplicity. A method that decides at each sample paints each once. @see Foley & van Dam 2e
/// §15.5

struct Overdraw {
  int width = 0;
  std::vector<int> times;    ///< of each sample, row by row
  std::int64_t painted = 0;  ///< the sum of these: the length of all spans
  std::int64_t samples = 0;  ///< samples painted at least once
  std::int64_t once = 0;     ///< samples painted exactly once
  int most = 0;
  std::size_t mostAt = 0;  ///< index of the first sample that was painted most often
  /// Mean over the samples that were painted; 0 if there are none.
  [[nodiscard]] double mean() const {
    return samples == 0 ? 0.0 : static_cast<double>(painted) / static_cast<double>(samples);
  }
};
[[nodiscard]] Overdraw overdrawOf(const Picture& picture);

/// The steps of the map: a sample is brighter the more often it was painted.
struct OverdrawStep {
  int most;  ///< times at most; the last step has no limit
  Cell cell;
  std::string_view label;
};
inline constexpr std::array kOverdrawSteps{
    OverdrawStep{1, Cell::WellLine, "once"}, OverdrawStep{2, Cell::Soft, "2"},
    OverdrawStep{3, Cell::Faint, "3"},       OverdrawStep{4, Cell::WellText, "4"},
    OverdrawStep{8, Cell::White, "5 to 8"},  OverdrawStep{1 << 30, Cell::Q, "more"},
};

[[nodiscard]] Finding findingOf(const Overdraw& overdraw, const Picture& picture);

/// Samples that were not painted stay background.
[[nodiscard]] IndexImage overdrawImage(const Overdraw& overdraw, const CellPlan& plan);

/// The map, its numbers, and what the order costs.
[[nodiscard]] Lens overdrawLens(const Picture& picture, const CellPlan& plan, const Palette& palette);

}  // namespace xnewell
