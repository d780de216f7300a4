#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// The intensity along a row of a picture in three methods, and how it changes from pixel to pixel. It shows
/// where the eye sees Mach bands.

/// The profile of one method. A slope is the difference between two neighbouring pixels of one surface. A
/// kink is the difference between two neighbouring slopes.
struct Profile {
  Shading method = Shading::Flat;
  std::vector<double> I;            ///< of each pixel, before rounding to cells; NaN where nothing shows
  std::vector<double> slope;        ///< I[i + 1] - I[i]; NaN if the two pixels do not show one surface
  std::vector<std::uint8_t> cells;  ///< of each pixel, by the plan of the picture, with the background
  double largestJump = 0;           ///< the largest |slope|
  double largestKink = 0;           ///< the largest |slope[i + 1] - slope[i]|
  std::vector<int> bands;           ///< the pixels where a band is, ascending; two bands may share one
};

/// A band is where two faces of one surface meet, and the eye may see a stripe. I jumps there by kBandJump
/// or more, or its slope changes by kBandKink or more. Inside a steep slope neither is seen unless it stands
/// out: the jump by more than the slope makes from sample to sample, the change by kBandShare of the slope.
/// The slope is dI/dx, where x grows by 1 over the width of all that the row shows. Bands are found on a row
/// of kFineWidth samples at the same height of the picture, so a larger picture has the same bands. Faces
/// narrower than kLeastRun of these samples are passed over.
inline constexpr double kBandJump = 1.0 / 240, kBandKink = 0.5, kBandShare = 1.0 / 8;
inline constexpr int kFineWidth = 4096, kLeastRun = 3;

/// Samples [begin, end) of a row that show one face.
struct FaceRun {
  int begin = 0, end = 0;  ///< end >= begin + kLeastRun
  bool joinsNext = false;  ///< the next run is beside it and shows the same surface
};
/// The bands of a row of intensities, as places 0..I.size() between samples: k + 0.5 is the middle of sample
/// k. `runs` ascend. `width` is that of all that the row shows, in samples.
[[nodiscard]] std::vector<double> bandsOf(const std::vector<double>& I, const std::vector<FaceRun>& runs,
                                          double width);

inline constexpr std::array kProfiled{Shading::Flat, Shading::Gouraud, Shading::Phong};

struct Scanline {
  int row = 0, samples = 0;  ///< `samples`: those that show something
  int outlines = 0;          ///< neighbouring samples that both show something, but not one surface
  int edges = 0;             ///< places where two faces of one surface meet, as they are counted for bands
  std::array<Profile, kProfiled.size()> profiles;
};

/// The middle row; if that row shows nothing, the row that shows most.
[[nodiscard]] int defaultScanline(const Picture& picture);

/// Row `row` of the picture in each method. Its plan must be one of ramps. Two pixels show one surface if
/// they show the same face, or two faces that join smoothly. Such faces have a point in common, their
/// interpolated normals there agree within a degree, and the viewer sees the same side of both. There may
/// also be one face between them, less than a pixel wide, that joins both.
[[nodiscard]] Scanline scanlineOf(const Picture& picture, int row, std::uint8_t ground);

/// Computes the rest of a profile from its values along a row. `joined[i]` is true if pixels i and i + 1 show
/// one surface.
void addSlopes(Profile& profile, const std::vector<bool>& joined);

}  // namespace xnewell
