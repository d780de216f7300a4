#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// A bicubic Bezier patch: sixteen control points, of which the four corners lie on the surface.
/// Space:  world, units of the file; all coordinates finite.
/// The surface is seen from its front where du x dv points to the viewer.
/// @see Foley & van Dam 2e §11.3.2
struct BezierPatch {
  std::array<glm::dvec3, 16> p;  ///< p[4 * row + column], row along u, column along v
};

/// S(u, v), u and v in [0, 1]. On an edge exactly the point of that edge's own cubic curve.
[[nodiscard]] glm::dvec3 point(const BezierPatch& patch, double u, double v);

/// The unit vector along dS/du x dS/dv. Where that product vanishes (a pole, two edges that meet in one
/// direction), its limit on the straight way from the patch's middle (from u = v = 1 for the middle
/// itself), read from the first term that does not vanish in the product's expansion along that way.
/// "Vanishes" means no longer than 2^-40 of what the control net allows, the product of its longest edges
/// along u and along v: a shorter vector may be all rounding. 0 if no term is left: the patch is a curve
/// or a point and has no normal.
[[nodiscard]] glm::dvec3 normal(const BezierPatch& patch, double u, double v);

/// The name of a run of patches, such as "spout".
struct PatchPart {
  std::string_view name;
  int patches;
};

/// The most divisions of a patch that tessellate() takes: 65,536 faces a patch, 2 million a teapot.
inline constexpr int kMaxDivisions = 256;

/// Divides every patch into N x N quadrilaterals, N = divisions in [1, kMaxDivisions].
/// Face patch * N * N + row * N + column spans u from row / N, v from column / N, and is counter-clockwise
/// seen from the side du x dv points to. Points that are equal in every bit are one vertex, so patches
/// with a common edge share its vertices: a curve evaluated from its other end gives the same bits, and
/// so does a mirror image. A face lists each of successive equal corners once (a triangle at a pole); one
/// with less than three distinct corners keeps its four, so that it keeps its number.
/// Groups: `parts` in order (their patches sum to patches.size()), or one group without a name.
/// The face count must fit an int. Its points are exact.
/// Texture coordinates are (u, v), so that each patch shows the whole texture; a triangle at a pole has those
/// of one of the two corners that coincide.
[[nodiscard]] Mesh tessellate(std::span<const BezierPatch> patches, int divisions,
                              std::span<const PatchPart> parts = {});

/// The exact normals at the corners of tessellate()'s mesh, one for each of Mesh::corners: normal() at the
/// corner's own u and v, so that at an edge each patch has its own, and 0 where it has none.
[[nodiscard]] std::vector<glm::dvec3> cornerNormals(std::span<const BezierPatch> patches, int divisions);

}  // namespace xnewell
