#pragma once

#include <array>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"
#include "shading/light/equation.h"
#include "shading/picture/picture.h"
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

/// The settings of a picture without its short cuts, and without what only painting needs: nothing is shaded,
/// and no cells are chosen.
[[nodiscard]] PictureSettings trueSettings(const PictureSettings& settings);

/// What each sample of a picture should see: the face that is nearest there, and the place on the true
/// surface. It has the scene, the camera and the size of a picture, and none of its short cuts (Role in
/// settings.h). visibleFaces() finds the faces on the grid of the screen; it keeps back faces.
class PolygonGroundTruth {
 public:
  explicit PolygonGroundTruth(const Picture& of);

  /// Forgets the faces that no sample shows, which saves most of the memory. Such a view cannot tell whether
  /// a face that it does not show may touch the one that it shows (Comparison::wrongFaces()).
  void keepShownOnly();

  /// The picture of the same view without short cuts, which is not painted. faces() are among its faces.
  [[nodiscard]] const Picture& picture() const { return picture_; }
  /// Indices into picture().snapped().faces, row by row; kNothing where no face shows.
  [[nodiscard]] const std::vector<int>& faces() const { return faces_; }
  /// The place that a sample shows. Precondition: a face shows there.
  [[nodiscard]] SurfacePlace place(std::size_t sample) const;
  [[nodiscard]] const TrueSurface& surface() const { return surface_; }

 private:
  Picture picture_;
  std::vector<int> faces_;
  TrueSurface surface_;
};

/// What a picture should show, without any short cut. Pictures are measured against it (errors.h).
///
/// It has the true view of a picture: the nearest face and the true surface at each sample. To these it adds
/// the illumination equation (equation.h) in double precision, once for each light and channel, with
/// - the true place and normal (TrueSurface), the true L and V there, and the texel there;
/// - those settings of the picture that belong to the model (Role in settings.h): light, surfaces, the form
///   of the equation;
/// - for a colour the illumination of each of its channels, each clamped to [0, 1].
/// It uses nothing that the painters use: no vertex normals, no interpolation over the screen, no table, no
/// shades. N is turned towards the side of the polygon that is seen, unless only fronts are lit.
///
/// It belongs to the polygons of the picture's scene. The truth about a picture is the reference of a scene
/// with finer ones (ground_truth.h).
class Reference : public PolygonGroundTruth {
 public:
  explicit Reference(const Picture& of);

  /// True if lights, surfaces and textures have no colour. Then all three channels are the same.
  [[nodiscard]] bool gray() const { return gray_; }
  /// The intensity at a sample, RGB; 0 where no face shows.
  [[nodiscard]] glm::dvec3 I(std::size_t sample) const {
    return gray_ ? glm::dvec3{I_[0][sample]} : glm::dvec3{I_[0][sample], I_[1][sample], I_[2][sample]};
  }

 private:
  using Rgb = std::array<Reflection, 3>;
  /// The intensity at a place of a face, in the first `channels` channels, not clamped.
  [[nodiscard]] glm::dvec3 illumination(const SurfacePlace& place, const SnappedFace& face) const;
  /// The share of the diffuse light that the texture of a face leaves at a place, by channel.
  [[nodiscard]] glm::dvec3 texel(const SurfacePlace& place, int face) const;

  bool gray_;
  glm::dvec3 Ia_;
  std::vector<Light> lights_;
  std::vector<Rgb> materials_;  ///< the first is for faces without a material
  std::array<std::vector<double>, 3> I_;
};

/// The scene with finely divided surfaces (finelyDivided()); nothing if the scene's own are as fine.
using FineScene = std::optional<Shared<Scene>>;
[[nodiscard]] FineScene fineSceneOf(const Scene& scene);

/// What a picture should show: the reference of its view on the fine scene of its scene. Eye and window are
/// those of the picture to the last bit. Clipping planes that the user did not give are placed anew, so that
/// they enclose the surfaces. @throws ViewError
[[nodiscard]] Reference referenceOf(const Picture& picture, const FineScene& fine);

/// The truth about a picture. Every error that the program tells, in a number or in a view, is against it.
///
/// What should be seen is the reference of the fine scene, so coarse polygons are a short cut like any other.
/// Which face is the right one is asked of the picture's own polygons, because no other could be painted.
class GroundTruth {
 public:
  /// @throws ViewError if the fine surfaces cannot be pictured
  explicit GroundTruth(const Picture& of) : GroundTruth{of, fineSceneOf(of.scene())} {}
  GroundTruth(const Picture& of, const FineScene& fine);

  [[nodiscard]] const Reference& reference() const { return reference_; }
  /// The true view of the picture's own polygons.
  [[nodiscard]] const PolygonGroundTruth& polygons() const { return polygons_ ? *polygons_ : reference_; }

 private:
  Reference reference_;
  std::optional<PolygonGroundTruth> polygons_;  ///< nothing if the reference has the same polygons
};

/// Keeps the last truth for the next picture. It is made anew when the scene, the view or a setting of the
/// model changes. If only the view changes, the fine surfaces stay.
class CachedGroundTruth {
 public:
  [[nodiscard]] const GroundTruth& of(const Picture& picture);
  /// True if of() has nothing to make.
  [[nodiscard]] bool knows(const Picture& picture) const;

 private:
  std::optional<Picture> of_;  ///< keeps its scene alive, so that its address tells it
  FineScene fine_;
  std::optional<GroundTruth> truth_;
};

}  // namespace xnewell
