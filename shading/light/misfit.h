#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "shading/light/illumination.h"
#include "shading/light/intensities.h"

namespace xnewell {

/// How far flat and Gouraud shading miss the illumination that they stand for, over one triangle.

/// A triangle as it is shaded.
struct Facet {
  std::array<glm::dvec3, 3> at{}, N{};  ///< at its corners; N of any length, unit only once interpolated
  glm::dvec3 centre{0};                 ///< where flat shading evaluates
  int material = -1;
};

/// Compares, in each channel and on both sides, with the illumination evaluated at samples: a grid of at
/// least six steps along each edge. Gouraud: the interpolated I with that of the normal interpolated and made
/// unit, as Phong has it. Flat: the I at the centre with that of all places.
///
/// What is narrow is not to fall between the samples: the cone of a spot, a highlight (as far as either is
/// brighter than the tolerance), the pool of light under a near lamp. Where the angles say that one of them
/// may reach the triangle, no place is farther from a sample than half the way from its middle to its border;
/// and if that would take more than kMostAlong steps, the triangle counts as missed. What can still be missed
/// is a border that passes between samples: a corner that a cone cuts off, of less than a step.
class Misfit {
 public:
  static constexpr int kLeastAlong = 6, kMostAlong = 32;  ///< steps of an edge

  /// 0 < tolerance <= 1, in intensity.
  Misfit(const Lighting& lighting, bool flat, double tolerance);
  /// For each facet whether it misses by more than the tolerance.
  [[nodiscard]] std::vector<bool> operator()(std::span<const Facet> facets) const;

 private:
  /// Half the angle of what is brighter than the tolerance, in degrees: of a spot's cone, of a highlight
  /// between R and V. 0 where nothing is.
  [[nodiscard]] double coneOf(const Lighting::Source& light) const;
  [[nodiscard]] double lobeOf(const Lighting::Source& light, const Material& material) const;
  [[nodiscard]] double stepsAlong(const Facet& facet) const;
  void addSamples(const Facet& facet, int along, ShadingPoints& samples) const;
  [[nodiscard]] bool misses(int along, const FrontBack<double>* I) const;

  const Lighting& lighting_;
  bool flat_;
  double tolerance_;
  std::vector<double> cones_;               ///< by source; degrees
  std::vector<std::vector<double>> lobes_;  ///< by source and material, of none first
};

}  // namespace xnewell
