#include "shading/light/misfit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "geometry/exact/power.h"
#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

namespace xnewell {

namespace {

constexpr std::size_t kTogether = 4096;  // samples; their terms fit into the second-level cache

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegrees = 180.0 / std::numbers::pi;
/// Half the angle of the pool of light under a lamp, in degrees, seen from the lamp: at its border 1/d^2 is
/// half as large as in the middle.
constexpr double kPool = 45.0;
/// No place of a triangle is farther from the nearest point of its grid than this share of the longest step.
const double kFarthest = 1.0 / std::sqrt(3.0);

/// In degrees.
double angleOf(double cosine) {
  const double c = std::clamp(cosine, -1.0, 1.0);
  return degreesOf(std::sqrt(1.0 - c * c), c);
}

/// x in [0, 1] with x^n = v, for 0 < v < 1 <= n. Bisection gives the same on every machine.
double rootOf(double v, int n) {
  double low = 0.0, high = 1.0;
  for (;;) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) return low;
    (power(middle, n) < v ? low : high) = middle;
  }
}

/// The size of a facet, and how much its normal turns.
struct Extent {
  glm::dvec3 middle{0}, normal{0};  ///< unit normal of its plane
  double radius = 0, longest = 0;   ///< around the middle; the longest edge
  double turn = 0;  ///< largest distance between two unit normals: about their angle in radians

  explicit Extent(const Facet& f) {
    middle = (f.at[0] + f.at[1] + f.at[2]) / 3.0;
    normal = unit(glm::cross(f.at[1] - f.at[0], f.at[2] - f.at[0]));
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      radius = std::max(radius, glm::length(f.at[k] - middle));
      longest = std::max(longest, glm::length(f.at[next] - f.at[k]));
      turn = std::max(turn, glm::length(unit(f.N[next]) - unit(f.N[k])));
    }
  }
  /// No place of the facet is nearer to p than this.
  [[nodiscard]] double distanceFrom(const glm::dvec3& p) const {
    return std::max(std::abs(glm::dot(normal, p - middle)), glm::length(p - middle) - radius);
  }
};

/// The angle whose cosine the specular term is a power of, on the side of the facet that is lit. R is the
/// same for N and -N; the other two cosines change their sign.
double specularAngle(Form form, const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V) {
  const double cosine = specularCosine(form, N, L, V);
  return angleOf(form == Form::Textbook ? cosine : std::abs(cosine));
}

}  // namespace

Misfit::Misfit(const Lighting& lighting, bool flat, double tolerance)
    : lighting_{lighting}, flat_{flat}, tolerance_{tolerance} {
  for (const Lighting::Source& light : lighting.sources) {
    cones_.push_back(coneOf(light));
    lobes_.emplace_back();
    for (const Material& m : lighting.materials) lobes_.back().push_back(lobeOf(light, m));
  }
}

double Misfit::coneOf(const Lighting::Source& light) const {
  double brightest = 0.0;
  for (const Material& m : lighting_.materials)
    for (int c = 0; c < lighting_.channels; ++c)
      brightest = std::max(brightest, light.Ip[c] * (m.kd[c] + m.ks[c]));
  if (brightest <= tolerance_) return 0.0;
  // x^0 = 1: with falloff 0 the spot is bright up to the outer cone.
  const double share = light.falloff > 0 ? rootOf(tolerance_ / brightest, light.falloff) : 0.0;
  return angleOf(light.cosOuter + (light.cosInner - light.cosOuter) * share);
}

double Misfit::lobeOf(const Lighting::Source& light, const Material& material) const {
  double brightest = 0.0;
  for (int c = 0; c < lighting_.channels; ++c) brightest = std::max(brightest, light.Ip[c] * material.ks[c]);
  if (brightest <= tolerance_ || material.n == 0) return 0.0;
  return angleOf(rootOf(tolerance_ / brightest, material.n));
}

double Misfit::stepsAlong(const Facet& facet) const {
  const Extent extent{facet};
  double steps = kLeastAlong;
  // Makes the steps small enough for a feature with the half angle `half`, in degrees. The angle changes by
  // at most `change` radians along the longest edge.
  const auto resolve = [&](double change, double half) {
    if (half > 0.0) steps = std::max(steps, 2.0 * kFarthest * change * kDegrees / half);
  };
  const double eye = lighting_.constantV ? kInfinity : extent.distanceFrom(lighting_.eye);
  const glm::dvec3 N = unit(facet.N[0] + facet.N[1] + facet.N[2]);
  const glm::dvec3 V = lighting_.constantV ? lighting_.farV : unit(lighting_.eye - extent.middle);
  for (std::size_t s = 0; s < lighting_.sources.size(); ++s) {
    const Lighting::Source& light = lighting_.sources[s];
    const glm::dvec3 to = light.position - extent.middle;
    const double apart = glm::length(to), nearest = extent.distanceFrom(light.position);
    if (light.placed && !light.constantL) resolve(extent.longest / nearest, kPool);
    if (light.spot) {
      const double sine = apart > extent.radius ? extent.radius / apart : 1.0;
      const double around = sine < 1.0 ? degreesOf(sine, std::sqrt(1.0 - sine * sine)) : 180.0;
      if (angleOf(-glm::dot(light.axis, unit(to))) <= cones_[s] + around)
        resolve(extent.longest / nearest, cones_[s]);
    }
    const double lobe = lobes_[s][facet.material + 1];
    if (lobe <= 0.0) continue;
    const double change = 2.0 * extent.turn + (light.constantL ? 0.0 : extent.longest / nearest) +
                          (lighting_.form == Form::Tutorial ? 0.0 : extent.longest / eye);
    const glm::dvec3 L = light.constantL ? light.L : unit(to);
    if (specularAngle(lighting_.form, N, L, V) <= lobe + change * kDegrees) resolve(change, lobe);
  }
  return steps;
}

void Misfit::addSamples(const Facet& f, int along, ShadingPoints& samples) const {
  const auto add = [&](const glm::dvec3& at, const glm::dvec3& N) {
    samples.at.push_back(at);
    samples.N.push_back(unit(N));
    samples.material.push_back(f.material);
  };
  if (flat_) add(f.centre, f.N[0]);
  for (int i = 0; i <= along; ++i)
    for (int j = 0; i + j <= along; ++j) {
      const double a = double(i) / along, b = double(j) / along, c = double(along - i - j) / along;
      add(a * f.at[0] + b * f.at[1] + c * f.at[2], a * f.N[0] + b * f.N[1] + c * f.N[2]);
    }
}

bool Misfit::misses(int along, const FrontBack<double>* I) const {
  const auto apart = [&](const FrontBack<double>& is, double front, double back) {
    return std::max(std::abs(is.front - front), std::abs(is.back - back)) > tolerance_;
  };
  const int samples = (along + 1) * (along + 2) / 2;
  if (flat_)
    return std::any_of(I + 1, I + 1 + samples,
                       [&](const FrontBack<double>& is) { return apart(is, I->front, I->back); });
  const FrontBack<double>&A = I[samples - 1], &B = I[along], &C = I[0];
  for (int i = 0; i <= along; ++i)
    for (int j = 0; i + j <= along; ++j, ++I) {
      const double a = double(i) / along, b = double(j) / along, c = double(along - i - j) / along;
      if (apart(*I, a * A.front + b * B.front + c * C.front, a * A.back + b * B.back + c * C.back))
        return true;
    }
  return false;
}

std::vector<bool> Misfit::operator()(std::span<const Facet> facets) const {
  std::vector<bool> result(facets.size(), false);
  std::vector<int> along(facets.size());
  ShadingPoints samples;
  Terms diffuse, specular;
  Intensities intensities;
  for (std::size_t first = 0, end = 0; first < facets.size(); first = end) {
    samples = {};
    for (; end < facets.size() && samples.at.size() < kTogether; ++end) {
      const double steps = stepsAlong(facets[end]);
      along[end] = steps <= kMostAlong ? static_cast<int>(std::ceil(steps)) : 0;
      if (along[end] > 0)
        addSamples(facets[end], along[end], samples);
      else
        result[end] = true;
    }
    for (int channel = 0; channel < lighting_.channels; ++channel) {
      diffuseIntensities(diffuse, samples, lighting_, channel);
      specularIntensities(specular, samples, lighting_, channel);
      addTerms(intensities, diffuse, specular, samples, lighting_, channel);
      const FrontBack<double>* I = intensities.I.data();
      for (std::size_t k = first; k < end; ++k) {
        if (along[k] == 0) continue;
        result[k] = result[k] || misses(along[k], I);
        I += (along[k] + 1) * (along[k] + 2) / 2 + flat_;
      }
    }
  }
  return result;
}

}  // namespace xnewell
