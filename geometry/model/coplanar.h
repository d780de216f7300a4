#pragma once

#include <vector>

#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// The planes of a model, as ConvexParts has them: for each part the number of its plane, 0 to n - 1 in order
/// of the first part of each plane; and of them and of the parts' own planes those that are not planes of the
/// corners of one part alone.
struct CoplanarClasses {
  std::vector<int> plane;
  NumberedPlanes planes, own;
  UnitFrame frame;
};

/// Finds the planes of a model. A decal on a wall, or a box's bottom on the floor, was coplanar when it was
/// made. The rounding of the file makes the two planes differ, and so does the rounding of the projected
/// view; which one is in front would then change from pixel to pixel. Two parts in one plane are tied, and
/// the order of the scene decides.
///
/// A class is a set of faces that one plane explains (fit_plane.h). Two faces are joined if one plane
/// explains both and they overlap in area: no edge of either separates them, seen along the axis nearest to
/// the normal of the larger. Faces that only touch, along an edge or in a corner, are not joined, however
/// their corners were rounded. Chains of such pairs form sets, and most sets are classes: the plane in which
/// faces were made explains them all, also a wall of many small tiles, each of which alone says little of the
/// wall's plane. A set that no plane explains is torn: layers that lie nearly as close as the file can tell,
/// or a bent surface made of overlapping faces. From a torn set a class is peeled off: the faces nearest to
/// the plane that has the least sum of distances, as many of them as one plane explains. What is left forms
/// sets again. A set from which nothing can be peeled is joined pair by pair, as long as one plane explains
/// each class. It does not matter which way a face looks. A face without area has a plane of its own.
///
/// The roundings are those of the faces' objects, and the side is that of the scene. (A decal's own box is
/// too small for the rounding of its plane.) Parallel layers whose distance is more than 2 (|Nx| + |Ny| +
/// |Nz|) units of the last decimal are never in one class. Nearer, one plane may explain the file. All finite
/// coordinates are allowed, up to the largest double. Faces narrower than e 2^-500 count as faces without
/// area.
///
/// Work: about n log n for n parts if few overlap in one plane; otherwise the number of pairs of different
/// faces whose boxes overlap. After 64 fits that explained nothing, a face is compared with others by the
/// plane of the larger alone.
[[nodiscard]] CoplanarClasses coplanarClasses(const Mesh& mesh, const ConvexParts& parts);

/// Sets Mesh::rounding to what of it counts, and tells in a note if that is much. Few decimals may mean two
/// things. Who writes numbers by hand means them as they are: planes that are apart by less than a unit are
/// apart. A program rounds. So a rounding of more than 3e-5 / sqrt 3 of the mesh's longest side counts only
/// if two faces show it; otherwise no more than that counts. Two faces show it if they overlap in area, and
/// one plane explains both with 9/10 of it, but none without. Layers that are meant to be apart are farther
/// from each other, or exactly parallel. If the side has fewer than 32 units of the last decimal, nearly any
/// two faces lie in one plane, and nothing is shown.
void countRounding(Mesh& mesh);

/// Sets ConvexParts::plane, planes, own and frame to the classes.
void uniteCoplanar(const Mesh& mesh, ConvexParts& parts);

/// The plane of a part. Before uniteCoplanar() it is that of its own corners.
[[nodiscard]] ModelPlane planeOf(const Mesh& mesh, const ConvexParts& parts, int part);

}  // namespace xnewell
