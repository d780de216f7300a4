#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/exact/two_doubles.h"
#include "geometry/view/camera.h"
#include "geometry/view/project.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What rays from the eye see of a scene. They judge pictures at extremes. They compute from the model's
/// coordinates with sums of two doubles, and use no matrix, grid, plane record or tolerance of the walk that
/// made the picture.
class Rays {
 public:
  /// Rays end at the front and the back plane only if the user gave these: the planes that the program
  /// chooses must not cut away what is in view. Size, planes and culling come from the settings.
  Rays(const Scene& scene, const Camera& camera, const PictureSettings& settings);

  /// A face that a ray meets.
  struct Hit {
    int face;      ///< face number
    TwoDoubles t;  ///< how far along the ray, in world units
    /// How far along the ray the plane may move if the file's rounding moves the corners.
    TwoDoubles play;
  };
  /// The nearest face at a place of the picture, x and y in pixels; nothing if the ray meets no face.
  [[nodiscard]] std::optional<Hit> nearest(TwoDoubles x, TwoDoubles y) const {
    return nearestOf(parts_, x, y);
  }
  /// The place where the ray at (x, y) meets a face; nothing if it does not meet it.
  [[nodiscard]] std::optional<Hit> hit(int face, TwoDoubles x, TwoDoubles y) const;
  /// The z of a hit of the ray at (x, y), in pixels of the view plane, larger where it is nearer: 1 / depth
  /// in perspective, as project() measures z, but from another zero.
  [[nodiscard]] TwoDoubles z(const Hit& hit, TwoDoubles x, TwoDoubles y) const;
  /// The point at t along the ray at (x, y), in world units.
  [[nodiscard]] glm::dvec3 point(TwoDoubles x, TwoDoubles y, TwoDoubles t) const;

 private:
  using Vec = glm::vec<3, TwoDoubles>;
  struct Ray {
    Vec from, along;  ///< `along` is a unit vector
  };
  struct Part {
    int face, part;
    Vec N;                                      ///< unit
    TwoDoubles play;                            ///< how far the file's rounding moves the plane, along N
    TwoDoubles x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< pixels that it may cover
  };
  [[nodiscard]] Ray ray(TwoDoubles x, TwoDoubles y) const;
  [[nodiscard]] std::optional<Hit> meet(const Part& part, const Ray& ray) const;
  [[nodiscard]] std::optional<Hit> nearestOf(std::span<const Part> parts, TwoDoubles x, TwoDoubles y) const;
  void bound(Part& part) const;

  const Scene& scene_;
  Vec u_, v_, n_;  ///< VRC's axes
  Vec vrp_, prp_;
  bool perspective_;
  glm::dvec2 low_, high_;  ///< the window
  TwoDoubles front_, back_;
  int width_, height_;
  Cull cull_;
  std::vector<Part> parts_;
};

/// A picture as rays judge it. A sample is wrong if it shows a face that is not the nearest. There are two
/// exceptions. The snap may move a face by 1/65536 pixel, so a face counts as nearest if it is the nearest at
/// a place that close. And the rounding of the file may move a plane: two planes that are no farther apart
/// than that may show either face. A sample is doubtful, and not wrong, if rounding in the snap can let the
/// farther face look nearer: it moves each corner by up to half a step of the grid in x, y and z.
struct ByGroundTruth {
  int samples = 0;    ///< that show a face or should show one
  int wrong = 0;      ///< that show another face than the rays, or none
  int missing = 0;    ///< those of them that show none
  int doubtful = 0;   ///< that show another face than the rays, as near as the snap can tell
  double behind = 0;  ///< the most by which a shown face lies behind the nearest, as a share of its distance
};
[[nodiscard]] ByGroundTruth byGroundTruth(const Picture& picture);

}  // namespace xnewell
