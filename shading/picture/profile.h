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
  int bands = 0;  ///< places with a kink that stands out (kBand); those at most two pixels apart count as one
};

/// A kink stands out if it is at least kBand, a fifth of the step between two of 240 shades, and at least
/// twice as large as the kinks kBeside pixels to either side. Where a curve bends smoothly, neighbouring
/// kinks have much the same size.
inline constexpr double kBand = 1.0 / 1200;
inline constexpr int kBeside = 3;

inline constexpr std::array kProfiled{Shading::Flat, Shading::Gouraud, Shading::Phong};

struct Scanline {
  int row = 0, samples = 0;  ///< `samples`: those that show something
  int edges = 0;             ///< neighbouring samples that both show something, but not one surface
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
