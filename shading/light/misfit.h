#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "shading/light/illumination.h"
#include "shading/light/intensities.h"

namespace xnewell {

/// How far the intensities of flat and Gouraud shading are from the illumination, over one triangle.

/// A triangle and what shading knows about it.
struct Facet {
  std::array<glm::dvec3, 3> at{}, N{};  ///< at its corners; N of any length: made unit after interpolation
  glm::dvec3 centre{0};                 ///< the place that flat shading evaluates
  int material = -1;
};

/// Compares with the illumination at samples, in each channel, for the front and the back. The samples are a
/// grid with at least six steps along each edge. For Gouraud shading, it compares the interpolated I with the
/// I of the interpolated normal, made a unit vector as in Phong shading. For flat shading, it compares the I
/// of the centre with the I of each sample.
///
/// Three things are narrow and must not fall between the samples: the cone of a spot, a highlight (the parts
/// of both that are brighter than the tolerance), and the pool of light under a near lamp. Where the angles
/// say that one of them may reach the triangle, the grid is finer: no place is farther from a sample than
/// half the distance from the middle of the narrow thing to its border. If that takes more than kMostAlong
/// steps, the triangle counts as one that misses. One thing can still be overlooked: a cone that cuts off a
/// corner of less than a step, so that its border passes between samples.
class Misfit {
 public:
  static constexpr int kLeastAlong = 6, kMostAlong = 32;  ///< steps along an edge

  /// The tolerance is an intensity, 0 < tolerance <= 1.
  Misfit(const Lighting& lighting, bool flat, double tolerance);
  /// For each facet, whether it misses by more than the tolerance.
  [[nodiscard]] std::vector<bool> operator()(std::span<const Facet> facets) const;

 private:
  /// Half the angle, in degrees, of the part that is brighter than the tolerance: of a spot's cone, and of a
  /// highlight, between R and V. 0 if nothing is brighter.
  [[nodiscard]] double coneOf(const Lighting::Source& light) const;
  [[nodiscard]] double lobeOf(const Lighting::Source& light, const Material& material) const;
  [[nodiscard]] double stepsAlong(const Facet& facet) const;
  void addSamples(const Facet& facet, int along, ShadingPoints& samples) const;
  [[nodiscard]] bool misses(int along, const FrontBack<double>* I) const;

  const Lighting& lighting_;
  bool flat_;
  double tolerance_;
  std::vector<double> cones_;               ///< by source, in degrees
  std::vector<std::vector<double>> lobes_;  ///< by source and material; the first is that of no material
};

}  // namespace xnewell
