#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// A bicubic Bezier patch. It has sixteen control points, and the surface passes through the four corner
/// points.
/// Space:  world, units of the file; all coordinates are finite.
/// The front of the surface is the side to which du x dv points.
/// @see Foley & van Dam 2e §11.3.2
struct BezierPatch {
  std::array<glm::dvec3, 16> p;  ///< p[4 * row + column]; rows follow u, columns follow v
};

/// S(u, v) for u and v in [0, 1]. A point on an edge is exactly the point of that edge's own cubic curve. A
/// coordinate is off by at most 2^-49 of the largest among the control points (two cubics of 8 roundings
/// each) or 2^-1070, for coordinates up to 2^1000.
[[nodiscard]] glm::dvec3 point(const BezierPatch& patch, double u, double v);

/// The unit vector along dS/du x dS/dv. That product can vanish, for example at a pole or where two edges
/// meet in one direction. There the normal is the limit along the straight line from the patch's middle (for
/// the middle itself, from u = v = 1). The function expands the product along that line and takes the first
/// term that does not vanish.
/// A vector vanishes if it is no longer than 2^-40 of the product of the control net's longest edges along u
/// and along v: so short a vector may be all rounding. The result is 0 if every term vanishes. Then the patch
/// is a curve or a point and has no normal.
/// Where du x dv does not vanish, the normal is off by at most 2^-47 E / |du x dv / 9|. E is that product of
/// edges. (du / 3 and dv / 3 have errors of 26 roundings of their longest edges, and the product has 60 of
/// E.)
[[nodiscard]] glm::dvec3 normal(const BezierPatch& patch, double u, double v);

/// The distance of `p` from the surface. It is that to the nearest point that the Gauss-Newton method finds
/// from uv on, uv in [0, 1]. It is never more than the distance to the point at uv.
[[nodiscard]] double distanceFrom(const BezierPatch& patch, const glm::dvec3& p, glm::dvec2 uv);

/// The name and the length of a run of patches, for example "spout" and 4.
struct PatchPart {
  std::string_view name;
  int patches;
};

/// The most divisions of a patch that tessellate() takes. It makes 65,536 faces a patch, 2 million a teapot.
inline constexpr int kMaxDivisions = 256;

/// Divides every patch into N x N quadrilaterals, N = divisions in [1, kMaxDivisions].
/// Face patch * N * N + row * N + column starts at u = row / N, v = column / N. It is counter-clockwise seen
/// from the side to which du x dv points.
/// Points whose coordinates are equal in every bit become one vertex, so patches with a common edge share its
/// vertices. This works because a curve evaluated from its other end gives the same bits, and so does a
/// mirror image.
/// If successive corners of a face are equal, the face lists only one of them (a triangle at a pole). A face
/// with fewer than three distinct corners keeps all four, so that every face keeps its number.
/// Groups: `parts` in order (their patches sum to patches.size()), or one group without a name. The face
/// count must fit an int. The points count as exact: Mesh::rounding is empty.
/// Texture coordinates are (u, v), so that each patch shows the whole texture. At a pole two corners
/// coincide, and the triangle has the texture coordinates of one of them.
[[nodiscard]] Mesh tessellate(std::span<const BezierPatch> patches, int divisions,
                              std::span<const PatchPart> parts = {});

/// The exact normals at the corners of tessellate()'s mesh, one for each of Mesh::corners. Each is normal()
/// at the corner's own u and v, so at a shared edge each patch has its own normal. It is 0 where the patch
/// has none.
[[nodiscard]] std::vector<glm::dvec3> cornerNormals(std::span<const BezierPatch> patches, int divisions);

/// The parts of data/teapot.bpt, in the order of its patches. A .bpt file has no place for names.
/// The bottom is not Newell's; it was added later. @see Crow 1987
inline constexpr std::array kTeapotParts{
    PatchPart{"rim", 4},   PatchPart{"upper body", 4}, PatchPart{"lower body", 4}, PatchPart{"handle", 4},
    PatchPart{"spout", 4}, PatchPart{"knob", 4},       PatchPart{"lid", 4},        PatchPart{"bottom", 4},
};

}  // namespace xnewell
