#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/color/rgb_image.h"
#include "shading/diagnose/approach.h"

namespace xnewell {

/// How the outlines of a picture that somebody hands in lie beside the right ones.
struct Outlines {
  /// The pixels that both pictures paint over those that either paints, away from outlines. Where the ground
  /// is nearly black a face may be, too, so there only faces where none should be count.
  double overlap = 0;
  /// Pixels with ground where a face should be, or a face where ground should be, although all pixels within
  /// two steps of them should be the same. Other edge rules and corners that are rounded to pixels reach less
  /// far.
  int apart = 0;
  int farthest = 0, i = 0, j = 0;  ///< of these pixels, how far one lies from the right outline, and where

  /// True if more pixels are apart than stray ones.
  [[nodiscard]] bool areOff() const { return apart > kStray; }
  static constexpr int kStray = 20;
};

/// @param faces   what the right picture shows, row by row; kNothing for ground
/// @param ground  the colour of the handed picture where the right one shows ground
/// @param least   with less overlap, only the overlap is told
[[nodiscard]] Outlines outlinesOf(const RgbImage& handed, const std::vector<int>& faces, TurnWay turn,
                                  std::array<std::uint8_t, 3> ground, double least);

}  // namespace xnewell
