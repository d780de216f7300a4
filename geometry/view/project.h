#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"
#include "geometry/view/clip.h"
#include "geometry/view/screen_grid.h"
#include "geometry/view/screen_plane.h"
#include "geometry/view/view.h"

namespace xnewell {

/// How far off in z a plane may be, in z steps, by z itself: rounding in the model moves what is near the eye
/// further. Quadratic, none of the terms negative. All 0: it is taken as it is.
struct Doubt {
  float atBack = 0, byZ = 0, byZZ = 0;
  [[nodiscard]] double at(double z) const { return atBack + z * (byZ + z * byZZ); }
};

/// A convex face on the screen grid, ready to be ordered and painted.
/// Holds:  its outline has an area and runs counter-clockwise as seen (x right, y down).
struct SnappedFace {
  int first = 0, count = 0;  ///< its outline: count >= 3 vertices of SnappedScene::vertices from `first` on
  int number = 0;            ///< face number in the model; every piece keeps it
  int piece = 0;             ///< index into ConvexParts; what clipping and halving make of one keep it
  bool back = false;         ///< seen from the side from which the model lists it clockwise
  /// Index into SnappedScene::planes, one for all faces of a plane of the model; before addPlanes() it is
  /// ConvexParts::plane.
  int plane = 0;
  /// Of its plane within the face, for the rounding of the snap and of the model. Where two faces are nearer
  /// to each other than the sum of theirs, they may touch in the model.
  Doubt doubt = {};
};

/// The scene as painter and oracle see it: integers from here on.
/// Space:  screen. x, y in 1/65536 pixel, origin top left, y down, |x|, |y| <= 2^29;
///         z in 2^zShift / 65536 pixel of the view plane, larger is nearer, 0 <= z <= 2^30.
/// Holds:  a triangle that shares its plane with no other face lies in it exactly.
struct SnappedScene {
  std::vector<glm::ivec3> vertices;  ///< outlines, one after the other
  /// As many: where a vertex comes from, an index into Mesh::corners, or the complement of one into
  /// `between`.
  std::vector<int> source;
  std::vector<Between> between;    ///< vertices that clipping made; each refers to earlier ones only
  std::vector<SnappedFace> faces;  ///< in order of number
  /// Depth is what they say; that of a vertex may be a step or more off. Empty before addPlanes().
  std::vector<ScreenPlane> planes;
  int zShift = 0;
  int polygons = 0;    ///< convex pieces that came in
  int culled = 0;      ///< back faces left out by choice
  int outside = 0;     ///< wholly outside the view volume and its guard band
  int degenerate = 0;  ///< without area on the grid: they cover no sample
};

enum class Cull { Keep, Back };

/// The whole viewing transformation: view, shear, warp, clip, viewport, snap. Vertices shared in the mesh,
/// and new ones where a shared edge is clipped, snap to identical integers in every face that uses them.
/// The scene's coordinates should be near 1 in magnitude (readScene normalises).
/// width, height: the picture in pixels, 1..kMaxPicture. @throws ViewError
[[nodiscard]] SnappedScene snap(const Mesh& mesh, const ConvexParts& pieces, const ViewSpec& view, int width,
                                int height, Cull cull);

/// What only an order that compares planes needs: pieces of one plane (ConvexParts::plane) get one plane record,
/// through three of their vertices far apart: they are coplanar exactly, and of those at one sample the later
/// is seen. Once for each snap(), with the same view.
void addPlanes(SnappedScene& scene, const Mesh& mesh, const ViewSpec& view, int width, int height);

/// Both.
[[nodiscard]] SnappedScene project(const Mesh& mesh, const ConvexParts& pieces, const ViewSpec& view, int width,
                                   int height, Cull cull);

/// Twice the area of an outline on the grid, positive where it runs counter-clockwise as seen. Exact:
/// |x|, |y| <= 2^29 bounds it by 2^61; partial sums may wrap, the result cannot.
[[nodiscard]] std::int64_t doubleArea(const glm::ivec3* outline, int count);

}  // namespace xnewell
