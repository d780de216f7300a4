#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"
#include "geometry/view/clip.h"
#include "geometry/view/plane_table.h"
#include "geometry/view/screen_plane.h"
#include "geometry/view/view.h"

namespace xnewell {

/// A convex face on the screen grid, ready to be ordered and painted.
/// Holds:  the outline has an area and runs counter-clockwise as seen on the screen (x right, y down).
struct SnappedFace {
  /// the outline: count >= 3 vertices of SnappedScene::vertices, starting at `first`
  int first = 0, count = 0;
  int number = 0;     ///< face number in the model; every part and piece keeps it
  int part = 0;       ///< index into ConvexParts; what clipping and halving make of one keep it
  bool back = false;  ///< the viewer sees the side from which the model lists the corners clockwise
  /// True if its plane goes exactly through its vertices. After snap() it is true for each triangle of the
  /// model that was not clipped; those that share their planes lose it later (scene_planes.h).
  bool throughVertices = false;
  int plane = 0;  ///< ConvexParts::plane, and index into SnappedScene::planes
};

/// The scene on the screen grid. From here on, all coordinates are integers.
/// Space:  screen. x, y in 1/65536 pixel, origin top left, y down, |x|, |y| <= 2^29; z in 2^zShift / 65536
///         pixel of the view plane, larger is nearer, 0 <= z <= 2^30.
/// Holds:  a triangle that shares its plane with no other face lies in that plane exactly.
struct SnappedScene {
  std::vector<glm::ivec3> vertices;  ///< outlines, one after the other
  /// One for each vertex: where it comes from. An index into Mesh::corners, or the complement of an index
  /// into `between`.
  std::vector<int> source;
  std::vector<Between> between;    ///< vertices that clipping made; each refers only to earlier ones
  std::vector<SnappedFace> faces;  ///< in order of number
  PlaneTable planes;               ///< empty after snap()
  int zShift = 0;
  int polygons = 0;    ///< number of convex parts given
  int culled = 0;      ///< number of back faces removed by choice
  int outside = 0;     ///< number wholly outside the view volume and its guard band
  int degenerate = 0;  ///< number without area on the grid; they cover no sample

  /// mayTouch() (scene_planes.h) compares two of `faces` by their doubts.
  [[nodiscard]] Doubt doubtOf(const SnappedFace& face) const {
    return planes.doubtOf(&face - faces.data(), face.plane);
  }
};

/// The whole viewing transformation: view, shear, warp, clip, viewport, snap. A vertex that faces share, or a
/// new one where a shared edge is clipped, snaps to the same integers in every face.
/// The scene's coordinates should be near 1 in magnitude (readScene normalises them). width and height are
/// those of the picture in pixels, 1..kMaxPicture. @throws ViewError
[[nodiscard]] SnappedScene snap(const Mesh& mesh, const ConvexParts& parts, const ViewSpec& view, int width,
                                int height, Cull cull);

/// Calls snap(), then makes all planes (scene_planes.h).
[[nodiscard]] SnappedScene project(const Mesh& mesh, const ConvexParts& parts, const ViewSpec& view,
                                   int width, int height, Cull cull);

/// The snap: a point in pixels, with z as screenFromCanonical() has it, rounded to the grid. zScale is the
/// number of z steps in a pixel, 65536 / 2^zShift. A tie goes to the even number.
[[nodiscard]] inline glm::ivec3 snapToGrid(const glm::dvec3& p, double zScale) {
  return {std::lrint(p.x * kGrid), std::lrint(p.y * kGrid), std::lrint(p.z * zScale)};
}

/// Twice the area of an outline on the grid; positive if it runs counter-clockwise as seen on the screen.
/// Exact: |x|, |y| <= 2^29 bounds it by 2^61; partial sums may wrap, but the result cannot.
[[nodiscard]] std::int64_t doubleArea(const glm::ivec3* outline, int count);

}  // namespace xnewell
