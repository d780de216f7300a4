#pragma once

#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"

namespace xnewell {

/// Intensities by depth: color = max - (z1 + z2 + z3) / a. The z of a face is the mean of its corners' z,
/// along the viewing direction. It is measured from the nearest face, which has the intensity 1. The constant
/// a gives the farthest face the intensity 0, so the picture uses the whole range. Returns one intensity in
/// [0, 1] for each of snapped.faces; all are 1 if all faces have the same depth. Depths count as the same if
/// they differ by no more than rounding can explain: 2 (n + 9) 2^-53 (|p| + |VRP|), where n is the number of
/// corners of a face and |p| the sum of the coordinates of one, without signs; the largest values count.
/// (The coordinates and VRP are off by 1 each, the direction by 3, its product with p - VRP by 4 more, and
/// the mean of n corners by n, in units of 2^-53 of that sum.)
[[nodiscard]] std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped,
                                                   const ViewSpec& view);

/// The numbers of that formula for one face; max is 1.
struct DepthTerms {
  std::vector<double> z;  ///< for each corner, how far it lies behind the z of the nearest face
  double range = 0.0;     ///< the distance from that z to the one of the farthest face; 0 for one depth
  double I = 1.0;         ///< 1 - (z1 + z2 + z3) / a; 1 if all faces have the same depth
  [[nodiscard]] double a() const { return static_cast<double>(z.size()) * range; }
};
/// `face` is an index into snapped.faces.
[[nodiscard]] DepthTerms depthTerms(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view,
                                    int face);

}  // namespace xnewell
