#pragma once

#include <vector>

#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// The planes of a model: for each piece the number of its plane, 0 to n - 1 in order of the first piece of
/// each. A decal on a wall, a box's bottom on the floor: coplanar where they were made, their planes differ
/// by the rounding of the file, and of the view once they are projected, so that which is in front would
/// change from pixel to pixel. In one plane they are tied, and the scene's order decides.
///
/// Two pieces share a plane if they are pieces of one planar face, or if they
/// - are coplanar: every corner of the one is within tol of the plane of the other, whose face is larger; and
/// - overlap in area: no edge of either, lengthened, parts them, seen along the axis nearest to the larger
///   one's normal. An edge parts them if the other piece reaches no further than tol across it, so those that
///   only touch along an edge or in a corner are not united, however their corners were rounded;
/// or if a chain of such pairs joins them. Then, against drift along a chain, a face with a corner further
/// than 3 tol from the plane of the largest face in its class leaves it. Which way a face looks is no matter;
/// one without area has a plane of its own.
///
/// tol = min(7 u, 3e-5 e) + 2^-46 e + 2^-50 m, as in divideFaces() but with e the longest side of the
/// scene's box (a decal's own is too small for its rounding) and u the coarser rounding of the two. Any
/// finite coordinates, up to the largest double; faces narrower than e 2^-500 count as without area.
///
/// Work: about n log n for n pieces that seldom overlap in one plane; else the number of pairs whose boxes
/// overlap, without those of two pieces of one planar face.
[[nodiscard]] std::vector<int> coplanarClasses(const Mesh& mesh, const ConvexParts& pieces);

}  // namespace xnewell
