#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The surface that a sample shows, as exactly as it is known: the place where the ray through the sample
/// meets the polygon, and the normal there of the surface that the polygon stands for. Everything is in
/// double precision, and nothing is interpolated over the screen.
///
/// The place. The parts of a face (ConvexParts) are planar. A part is divided into a fan of triangles around
/// its first corner. The ray meets their planes, and the place is in the triangle that it meets. The grid of
/// the screen moves an edge by up to 1/131,072 pixel, and a sliver by more than it is wide, so the ray may
/// miss all of them. Then the place is in the triangle that it misses by least: coordinates of the triangle
/// below 0 count as 0. A part without area has its first corner for a place.
///
/// The normal:
/// - A face of a Bezier patch has the normal of the patch at (u, v). u and v are those of the corners,
///   interpolated over the triangle in space. Where two corners of a quadrilateral coincide at a pole, the
///   pole has every parameter between theirs, and the one on the straight line through the sample counts.
/// - A face of a sphere or a torus has the normal of that solid at its point nearest to the place.
/// - A face with normals from its file at all three corners of the triangle has what lies between them, as in
///   Phong shading.
/// - Any other face is itself the surface, and has its own normal, by Newell's method over the face as the
///   file has it. So has a face whose patch or solid has no normal there.
/// The distance between the place and the patch is no part of this. It is an error of its own
/// (distanceToPatch()).
///
/// Far from the origin of the world only differences are exact, so places are relative to a corner.

struct SurfacePlace {
  glm::dvec3 origin{0}, at{0};         ///< world: the place is origin + at; origin is a corner of the part
  glm::dvec3 N{0};                     ///< unit, outward (see Mesh); 0 for a face without area
  std::array<int, 3> corner{};         ///< of the triangle; indices into Mesh::corners
  std::array<double, 3> share{};       ///< of the corners in the place; none is negative, and their sum is 1
  const BezierPatch* patch = nullptr;  ///< null if the face is of no patch; in file coordinates
  glm::dvec2 uv{0};                    ///< on the patch, each in [0, 1]
};

class TrueSurface {
 public:
  /// The scene must outlive this. width and height are those of the picture.
  TrueSurface(const Scene& scene, const ViewSpec& view, int width, int height);

  /// What the sample at the centre of pixel (i, j) shows of a part. `part` is an index into Scene::parts.
  [[nodiscard]] SurfacePlace at(int part, int i, int j) const;

  /// The distance of the place from its patch, in the scene's units. It is the distance to the nearest point
  /// that Newton's method finds from (u, v) on, and no more than that to the point at (u, v). 0 without a
  /// patch.
  [[nodiscard]] double distanceToPatch(const SurfacePlace& place) const;

  /// How many pixels high a world unit is that is seen from its front at the place, in the scene's units.
  [[nodiscard]] double pixelsPerUnit(const SurfacePlace& place) const;

 private:
  /// The ray through a sample, in viewing reference coordinates.
  struct Ray {
    glm::dvec3 from, along;
  };
  [[nodiscard]] Ray rayThrough(int i, int j) const;
  /// The coordinates of the point where the ray meets the plane of a triangle; false if it meets none.
  [[nodiscard]] bool meet(const Ray& ray, const std::array<glm::dvec3, 3>& triangle,
                          std::array<double, 3>& share) const;
  [[nodiscard]] glm::dvec2 parametersOf(const SurfacePlace& place, int face) const;
  [[nodiscard]] glm::dvec3 normalOf(const SurfacePlace& place, const RoundRun& run) const;

  const Scene& scene_;
  ViewSpec view_;
  int width_, height_;
  glm::dmat3 rotation_;  ///< from world to viewing reference coordinates
  /// By face: index into Scene::patches; from patches.size() on, into Scene::rounds; -1 for none.
  std::vector<int> runOf_;
};

}  // namespace xnewell
