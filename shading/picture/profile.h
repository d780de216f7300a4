#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// The intensity along a row of a picture in three methods, and how it changes from pixel to pixel: where
/// the eye sees Mach bands.

/// One method's. Between two neighbouring pixels of one surface is a slope, between two such slopes a kink.
struct Profile {
  Shading method = Shading::Flat;
  std::vector<double> I;            ///< of each pixel, unquantised; NaN where nothing shows
  std::vector<double> slope;        ///< I[i + 1] - I[i]; NaN where the two are not of one surface
  std::vector<std::uint8_t> cells;  ///< as the picture shows it, on its ground
  double largestJump = 0;           ///< |slope|
  double largestKink = 0;           ///< |slope[i + 1] - slope[i]|
  int bands = 0;  ///< places with a kink of at least kBand; those next to each other are one
};

/// A kink stands out if it is at least a fifth of a shade of 240, and twice as large as those kBeside pixels
/// away: where a curve bends smoothly they are much the same.
inline constexpr double kBand = 1.0 / 1200;
inline constexpr int kBeside = 3;

inline constexpr std::array kProfiled{Shading::Flat, Shading::Gouraud, Shading::Phong};

struct Scanline {
  int row = 0, samples = 0;  ///< of those that show something
  int edges = 0;             ///< neighbours that show something, but not one surface
  std::array<Profile, kProfiled.size()> profiles;
};

/// The middle row, or where that shows nothing the one that shows most.
[[nodiscard]] int defaultScanline(const Picture& picture);

/// Row `row` of the picture in each method. Its plan must be of ramps. Two pixels are of one surface if they
/// show one face, or two that go on into each other: they have a point in common, where the normals that are
/// interpolated agree within a degree, and show the same side. A face less than a pixel wide may lie between.
[[nodiscard]] Scanline scanlineOf(const Picture& picture, int row, std::uint8_t ground);

/// Of values along a row: the rest of a profile. `joined[i]` says whether pixels i and i + 1 are of one
/// surface.
void addSlopes(Profile& profile, const std::vector<bool>& joined);

}  // namespace xnewell
