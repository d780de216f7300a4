#pragma once

#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"

namespace xnewell {

/// Intensities by depth: color = max - (z1 + z2 + z3) / a. The z of a face is the mean of its corners' z,
/// along the viewing direction. It is measured from the nearest face, which has the intensity 1. The constant
/// a gives the farthest face the intensity 0, so the picture uses the whole range. Returns one intensity in
/// [0, 1] for each of snapped.faces; all are 1 if all faces have the same depth. Depths count as the same if
/// they differ by no more than the rounding of the corners p, of VRP and of the computation can explain: by
/// 2 (n + 9) 2^-53 (|p| + |VRP|), where n is the number of corners of a face and |p| the sum of the
/// coordinates of one, without signs; the largest values count. (In units of 2^-53 of that sum, p and VRP are
/// off by 1, p - VRP by 1, the direction by 4, its product with p - VRP by 3, and the mean of n corners by
/// n.)
[[nodiscard]] std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped,
                                                   const ViewSpec& view);

/// What all faces share: the z of the nearest face, and the distance from there to the farthest.
struct DepthRange {
  double near = 0.0;    ///< larger is nearer
  double length = 0.0;  ///< 0 if all faces have the same depth
};
[[nodiscard]] DepthRange depthRange(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view);

/// The numbers of that formula for one face; max is 1.
struct DepthTerms {
  std::vector<double> z;  ///< for each corner, how far it lies behind the z of the nearest face
  double range = 0.0;     ///< DepthRange::length
  [[nodiscard]] double a() const { return static_cast<double>(z.size()) * range; }
};
/// `face` is the number of a face of the mesh.
[[nodiscard]] DepthTerms depthTerms(const Mesh& mesh, const ViewSpec& view, const DepthRange& range,
                                    int face);

}  // namespace xnewell
