#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "shading/laboratory/true_view.h"
#include "shading/light/equation.h"

namespace xnewell {

/// What a picture should show, without any short cut. Pictures are measured against it (errors.h).
///
/// It has the true view of a picture: the nearest face and the true surface at each sample. To these it adds
/// the illumination equation (equation.h) in double precision, once for each light and channel, with
/// - the true place and normal (true_surface.h), the true L and V there, and the texel there;
/// - those settings of the picture that belong to the model (Role in settings.h): light, surfaces, the form
///   of the equation;
/// - for a colour the illumination of each of its channels, each clamped to [0, 1].
/// It uses nothing that the painters use: no vertex normals, no interpolation over the screen, no table, no
/// shades. N is turned towards the side of the polygon that is seen, unless only fronts are lit.
///
/// It belongs to the polygons of the picture's scene. The truth about a picture is the reference of a scene
/// with finer ones (truth.h).
class Reference : public TrueView {
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

}  // namespace xnewell
