#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "shading/fill/intensities.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// How far the intensities of flat and Gouraud shading are from the illumination, over one triangle.

/// A triangle and what shading knows about it.
struct Facet {
  std::array<glm::dvec3, 3> at{}, N{};  ///< at its corners; N of any length: made unit after interpolation
  glm::dvec3 centre{0};                 ///< the place that flat shading evaluates
  int material = -1;
};

/// Compares with the illumination, in each channel, for the front and the back. For Gouraud shading, it
/// compares the interpolated I with the I of the interpolated normal, made a unit vector as in Phong shading.
/// For flat shading, it compares the I of the centre with the I of each place.
///
/// The comparison is made at samples, a grid with as many steps along each edge. What lies between the
/// samples is bounded: by how much the directions to the lights and to the eye, and the normal, turn over the
/// triangle, by the second derivatives of the equation's terms, and by the corners that their clamps make. So
/// nothing can hide between the samples, however narrow it is: no cone of a spot, no highlight, no pool of
/// light under a lamp. Where samples and bound together exceed the tolerance, the grid becomes finer. If the
/// finest does not decide, the triangle counts as one that misses.
class Misfit {
 public:
  static constexpr std::array<int, 3> kAlong{6, 12, 24};  ///< steps along an edge

  /// The tolerance is an intensity, 0 < tolerance <= 1.
  Misfit(const Lighting& lighting, bool flat, double tolerance);
  /// For each facet, whether it misses by more than the tolerance. If not, it is within it at every place.
  [[nodiscard]] std::vector<bool> operator()(std::span<const Facet> facets) const;

 private:
  void addSamples(const Facet& facet, int along, ShadingPoints& samples) const;
  /// The largest difference at the samples of one facet.
  [[nodiscard]] double mostApart(int along, const FrontBack<double>* I) const;
  /// The same for the facets numbered `which`, in all channels.
  [[nodiscard]] std::vector<double> atSamples(std::span<const Facet> facets, std::span<const int> which,
                                              int along) const;
  /// A bound for the difference at all places of a facet, from that at its samples.
  [[nodiscard]] double everywhere(const Facet& facet, int along, double atSamples) const;

  const Lighting& lighting_;
  bool flat_;
  double tolerance_;
};

}  // namespace xnewell
