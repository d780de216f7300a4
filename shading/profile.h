#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/picture.h"

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

/// The least change of slope that counts as a band: a fifth of a shade of 240 from one pixel to the next.
inline constexpr double kBand = 1.0 / 1200;

inline constexpr std::array kProfiled{Shading::Flat, Shading::Gouraud, Shading::Phong};

struct Scanline {
  int row = 0, samples = 0;  ///< of those that show something
  int edges = 0;             ///< neighbours that show something, but not one surface
  std::array<Profile, kProfiled.size()> profiles;
};

/// The row that shows most, of several the one nearest to the middle. `picture` has been made.
[[nodiscard]] int defaultScanline(const Picture& picture);

/// Makes `picture` in each method and last in `settings`, whose plan is of ramps. Two pixels are of one
/// surface if they show one face, or two that meet in a point, or that both meet a third; where they meet,
/// their normals of interpolated shading agree within a degree.
[[nodiscard]] Scanline scanlineOf(Picture& picture, const PictureSettings& settings, int row,
                                  std::uint8_t ground);

/// Of values along a row: the rest of a profile. `joined[i]` says whether pixels i and i + 1 are of one
/// surface.
void addSlopes(Profile& profile, const std::vector<bool>& joined);
