#pragma once

#include <cstdint>
#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// A z-buffer. It takes the faces in order of the scene. At each sample of a face it computes the depth
/// there, and if no earlier face is nearer, it keeps this face and its depth. There is no sorting and no
/// splitting; the price is an array of depths, and a test for each sample of each face.
///
/// The depth is z of the perspective warp, linear over the screen: 0 at the back plane and zF, frontDepth(),
/// at the front plane. Seen from the eye it is not linear: at distance d it is proportional to 1/d - 1/dB. It
/// is evaluated in doubles, on the plane through three of the face's own snapped vertices (planeThrough()).
/// It is stored as a level, an integer of so many bits, as hardware does: the integer nearest to z/zF (2^bits
/// - 1), halves upward. A depth outside [0, zF] gets the first or the last level.
///
/// A face wins if its level is greater or equal: of equal levels the later face of the scene is seen, as
/// everywhere in this program. So a decal that lies in the plane of a wall and comes after it is seen where
/// both have one level. Many programs compare with "greater" alone, and there the earlier face wins.
///
/// Let a quantum be zF/(2^bits - 1), and let two faces of a sample be d apart in z. Rounding keeps the order.
/// So their levels differ, and differ rightly, if d is more than a quantum. If d is less, they may have one
/// level. Then the later face is seen, and that is wrong if it is the farther one (z-fighting). The doubles
/// are off by less than 2^-48 of the depths within a face, extended to the whole of its box.
/// @see Catmull 1974; Foley & van Dam 2e §15.4
struct ZBuffer {
  std::vector<int> faces;  ///< the visible face at each sample, row by row, or kNothing (oracle.h)
  std::int64_t tests = 0;  ///< depths that were compared
  /// Size of the levels: two bytes a sample for 16 bits, four for 24 and 32. Hardware, too, keeps 24 bits in
  /// words of 32.
  std::int64_t bytes = 0;
};

/// `view`, `width` and `height` are those that the scene was snapped with. It needs no planes. bits: 16, 24
/// or 32.
[[nodiscard]] ZBuffer zBuffer(const SnappedScene& scene, const ViewSpec& view, int bits, int width,
                              int height);

}  // namespace xnewell
