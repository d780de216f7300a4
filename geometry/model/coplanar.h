#pragma once

#include <vector>

#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// Finds the planes of a model. The result holds for each part the number of its plane: 0 to n - 1, in order
/// of the first part of each plane. A decal on a wall, or a box's bottom on the floor, was coplanar when it
/// was made. The rounding of the file makes the two planes differ, and so does the rounding of the projected
/// view; which one is in front would then change from pixel to pixel. Two parts in one plane are tied, and
/// the order of the scene decides.
///
/// Two parts share a plane if they are parts of one planar face, or if they
/// - are coplanar: every corner of one is within tol of the plane of the other, whose face is the larger; and
/// - overlap in area: no edge of either separates them, seen along the axis nearest to the normal of the
///   larger. An edge, lengthened, separates them if the other part reaches no further than tol across it. So
///   parts that only touch along an edge or in a corner are not united, however their corners were rounded;
/// or if a chain of such pairs joins them. A chain can drift. So a face leaves its class if one of its
/// corners is further than 3 tol from the plane of the largest face in the class. It does not matter which
/// way a face looks. A face without area has a plane of its own.
///
/// tol = min(7 u, 3e-5 e) + 2^-46 e + 2^-50 m, as in divideFaces(), with two differences: e is the longest
/// side of the scene's box (a decal's own box is too small for the rounding of its plane), and u is the
/// coarser rounding of the two. All finite coordinates are allowed, up to the largest double. Faces narrower
/// than e 2^-500 count as faces without area.
///
/// Work: about n log n for n parts if few overlap in one plane; otherwise the number of pairs of different
/// faces whose boxes overlap.
[[nodiscard]] std::vector<int> coplanarClasses(const Mesh& mesh, const ConvexParts& parts);

}  // namespace xnewell
