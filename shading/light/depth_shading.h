#pragma once

#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"

namespace xnewell {

/// Intensities by depth: color = max - (z1 + z2 + z3) / a. The z of a face is the mean of its corners' z,
/// along the viewing direction. It is measured from the nearest face, which has the intensity 1. The constant
/// a gives the farthest face the intensity 0, so the picture uses the whole range. Returns one intensity in
/// [0, 1] for each of snapped.faces; all are 1 if all faces have the same depth.
[[nodiscard]] std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped,
                                                   const ViewSpec& view);

/// The numbers of that formula for one face; max is 1.
struct DepthTerms {
  std::vector<double> z;  ///< for each corner, how far it lies behind the z of the nearest face
  double a = 0.0;         ///< z.size() times the distance from that z to the one of the farthest face
  double I = 1.0;         ///< 1 - (z1 + z2 + z3) / a; 1 if a is 0
};
/// `face` is an index into snapped.faces.
[[nodiscard]] DepthTerms depthTerms(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view,
                                    int face);

}  // namespace xnewell
