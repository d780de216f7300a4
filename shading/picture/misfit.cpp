#include "shading/picture/misfit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>

#include "geometry/exact/give_up.h"
#include "geometry/exact/power.h"
#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

namespace xnewell {

namespace {

constexpr std::size_t kTogether = 4096;  // samples; their terms fit into the second-level cache
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegrees = 180.0 / std::numbers::pi;

// How far a function may be, inside a small triangle, from the linear one through its values at the corners.
// The longest edge of the triangle has the length l, in whatever measure; slopes and second derivatives are
// along any direction in it.
//
// Smooth, second derivative at most M: (2/9) M l^2. Taylor's formula about the place p gives at most half the
// sum of share_i M |v_i - p|^2, and |v_i - p| <= (1 - share_i) l.
constexpr double kSmooth = 2.0 / 9.0;
// Cut off at a bound, slope at most s: s l / 4 more. So far is the corner of max(0, x) from its chord.
constexpr double kCut = 1.0 / 4.0;
/// No place of a triangle is farther from its middle than this share of the longest edge.
constexpr double kFromMiddle = 2.0 / 3.0;
/// |u''| <= kTurning w^2 for a unit vector u towards a place, if the line of sight moves on a line and turns
/// by at most w. At the angle a to the line it is w^2 sin a sqrt(4 - 3 sin^2 a).
constexpr double kTurning = 1.16;
/// |c''| <= kReflecting w^2 for R.V and N.H, if the angle changes by at most w. R = 2 N (N.L) - L has
/// |R''| <= kTurning (8 wN^2 + 8 wN wL + 3 wL^2) <= 3 kTurning (2 wN + wL)^2.
constexpr double kReflecting = 3.0 * kTurning;

/// What is known of a term of the equation over a facet: what it is at most, how much it changes in a small
/// triangle of the facet, and the distance explained above.
struct Term {
  double most = 0, change = 0, error = 0;

  Term() = default;
  /// No term is below 0. So neither bound need be larger than `most`, and what is not a number counts as
  /// most.
  Term(double largest, double changes, double errs)
      : most{largest}, change{std::min(largest, changes)}, error{std::min(largest, errs)} {}
};

/// The product of the interpolated factors is not linear: it is off by the covariance of the corners' values,
/// at most a quarter of both ranges.
Term operator*(const Term& a, const Term& b) {
  return {a.most * b.most, a.change * b.most + a.most * b.change,
          a.error * b.most + a.most * b.error + a.change * b.change / 4.0};
}
Term operator*(double share, const Term& a) { return {share * a.most, share * a.change, share * a.error}; }
Term operator+(const Term& a, const Term& b) {
  return {a.most + b.most, a.change + b.change, a.error + b.error};
}
Term constant(double v) { return {v, 0.0, 0.0}; }

/// x^n for a term x in [0, 1].
Term raised(const Term& x, int n) {
  if (n == 0) return constant(1.0);
  const double first = n * power(x.most, n - 1);
  const double second = n > 1 ? double(n) * (n - 1) * power(x.most, n - 2) : 0.0;
  return {power(x.most, n), first * x.change, first * x.error + second * x.change * x.change / 8.0};
}

/// max(0, cos a)^n for an angle of at least `least` that changes by at most `turn` in a small triangle, where
/// |cos''| <= kReflecting turn^2. The slope n cos^(n-1) sin and the second derivative n (n - 1) cos^(n-2)
/// sin^2 have their largest values where cos^2 is (n - 1) / n and (n - 2) / n.
Term cosineRaised(double least, double turn, int n) {
  if (n == 0) return constant(1.0);
  const double cosine = std::max(0.0, sinCosDegrees(least * kDegrees).cos);
  const double steepest = std::min(cosine, std::sqrt((n - 1.0) / n)), slope = n * power(cosine, n - 1);
  double error = slope * kSmooth * kReflecting * turn * turn;
  if (n == 1) error += kCut * turn;
  if (n > 1) {
    const double c = std::min(cosine, std::sqrt((n - 2.0) / n)), both = double(n) * (n - 1);
    // sin^2 as far away as `turn` is at most 2 sin^2 + 2 turn^2
    const double second = both * (power(c, n - 2) * (1.0 - c * c) + power(cosine, n - 2) * turn * turn);
    error += second * turn * turn / 4.0;
  }
  return {power(cosine, n), turn * n * power(steepest, n - 1) * std::sqrt(1.0 - steepest * steepest), error};
}

/// In radians.
double angleOf(double cosine) {
  const double c = std::clamp(cosine, -1.0, 1.0);
  return degreesOf(std::sqrt(1.0 - c * c), c) / kDegrees;
}

/// The size of a facet, and how much its normal turns.
struct Extent {
  glm::dvec3 middle{0}, normal{0}, N{0};  ///< unit vectors: of its plane, and interpolated in the middle
  double radius = 0, longest = 0;         ///< around the middle; the longest edge
  double turn = 0;                        ///< the unit normal turns by at most this along an edge, in radians

  explicit Extent(const Facet& f) {
    middle = (f.at[0] + f.at[1] + f.at[2]) / 3.0;
    normal = unit(glm::cross(f.at[1] - f.at[0], f.at[2] - f.at[0]));
    N = unit(f.N[0] + f.N[1] + f.N[2]);
    double shortest = kInfinity, change = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      radius = std::max(radius, glm::length(f.at[k] - middle));
      longest = std::max(longest, glm::length(f.at[next] - f.at[k]));
      change = std::max(change, glm::length(f.N[next] - f.N[k]));
      shortest = std::min(shortest, glm::dot(f.N[k], N));
    }
    if (change > 0.0) turn = shortest > 0.0 ? change / shortest : kInfinity;
  }
  /// No place of the facet is nearer to p than this.
  [[nodiscard]] double distanceFrom(const glm::dvec3& p) const {
    return std::max(std::abs(glm::dot(normal, p - middle)), glm::length(p - middle) - radius);
  }
};

/// A unit vector towards a place, seen from a facet. It turns by at most `turn` along an edge, in radians.
struct Sight {
  glm::dvec3 towards{0};  ///< from the middle
  double turn = 0;
};
Sight sightOf(const glm::dvec3& place, const Extent& extent) {
  return {unit(place - extent.middle), extent.longest / extent.distanceFrom(place)};
}

/// Whether N.L may change its sign on a facet. Where only one of the two turns, N.L is a linear function
/// times a positive one, so the corners say it.
bool turnsAway(const Facet& f, const Lighting::Source& light, const Extent& extent, const Sight& sight) {
  if (extent.turn > 0.0 && sight.turn > 0.0)
    return !(std::abs(glm::dot(extent.N, sight.towards)) > kFromMiddle * (extent.turn + sight.turn));
  bool to = false, from = false;
  for (int k = 0; k < 3; ++k) {
    const double NdotL = glm::dot(f.N[k], light.constantL ? light.L : light.position - f.at[k]);
    to |= NdotL > 0.0, from |= NdotL < 0.0;
  }
  return to && from;
}

/// max(0, R.V)^n, or with another form's cosine.
Term highlight(Form form, int n, const Extent& extent, const Sight& light, const Sight& eye, double step) {
  const double cosine = specularCosine(form, extent.N, light.towards, eye.towards);
  // R is the same for N and -N. The other two cosines change their sign.
  const double angle = angleOf(form == Form::Textbook ? cosine : std::abs(cosine));
  double turn = extent.turn + light.turn;
  if (form == Form::Textbook) turn = 2.0 * extent.turn + light.turn + eye.turn;
  if (form == Form::HalfVector) {
    const double both = light.turn + eye.turn;
    const double least = glm::length(light.towards + eye.towards) - kFromMiddle * both;  // of L + V
    turn = extent.turn + (both == 0.0 ? 0.0 : least > 0.0 ? both / least : kInfinity);
  }
  return cosineRaised(std::max(0.0, angle - kFromMiddle * turn), step * turn, n);
}

/// fatt of a light at a place. q = c.x + c.y d + c.z d^2 has q'/q <= 2/d. So 1/q has at most the slope 2/(q
/// d) and, with d'' <= 1/d, at most the second derivative (8 + 2) / (q d^2).
Term attenuated(const Lighting::Source& light, const Extent& extent, double step) {
  const double nearest = extent.distanceFrom(light.position);
  const double farthest = glm::length(light.position - extent.middle) + extent.radius;
  const double turn = step * extent.longest / nearest;
  if (light.linear) {
    const double slope = light.c.x * step * extent.longest;
    const bool ends = light.c.x * farthest > 1.0;
    return {std::max(0.0, 1.0 - light.c.x * nearest), slope,
            kSmooth * slope * turn + (ends ? kCut * slope : 0.0)};
  }
  const auto q = [&](double d) { return (light.c.z * d + light.c.y) * d + light.c.x; };
  const double most = 1.0 / std::max(1.0, q(nearest)), slope = 2.0 * turn * most;
  if (q(farthest) <= 1.0 || (light.c.y == 0.0 && light.c.z == 0.0)) return constant(most);
  return {most, slope, kSmooth * 10.0 * turn * turn * most + (q(nearest) < 1.0 ? kCut * slope : 0.0)};
}

/// The share of a spot, seen from a facet.
Term spotted(const Lighting::Source& light, const Sight& sight, double step) {
  const double angle = angleOf(-glm::dot(light.axis, sight.towards)), turn = step * sight.turn;
  const double least = angle - kFromMiddle * sight.turn, most = angle + kFromMiddle * sight.turn;
  const double inner = angleOf(light.cosInner), outer = angleOf(light.cosOuter);
  if (most < (light.falloff == 0 ? outer : inner)) return constant(1.0);
  if (least > outer) return {};
  const double width = light.cosInner - light.cosOuter;
  if (width <= 0.0 || light.falloff == 0) return {1.0, 1.0, 1.0};  // it jumps
  const double brightest = least > inner ? sinCosDegrees(least * kDegrees).cos : light.cosInner;
  const int cuts = (least < inner) + (most > outer);
  const Term between{std::min(1.0, (brightest - light.cosOuter) / width), turn / width,
                     (kSmooth * kTurning * turn + cuts * kCut) * turn / width};
  return raised(between, light.falloff);
}

}  // namespace

Misfit::Misfit(const Lighting& lighting, bool flat, double tolerance)
    : lighting_{lighting}, flat_{flat}, tolerance_{tolerance} {}

double Misfit::everywhere(const Facet& facet, int along, double atSamples) const {
  const Extent extent{facet};
  const Material& material = lighting_.materials[facet.material + 1];
  const double step = 1.0 / along;
  const Sight eye = lighting_.constantV ? Sight{lighting_.farV, 0.0} : sightOf(lighting_.eye, extent);
  std::array<Term, 3> I;
  for (int c = 0; c < lighting_.channels; ++c) I[c] = constant(material.ambient[c]);
  for (const Lighting::Source& light : lighting_.sources) {
    const Sight at = light.placed ? sightOf(light.position, extent) : Sight{};
    const Sight sight = light.constantL ? Sight{light.L, 0.0} : at;
    const Term f = (light.constantL ? constant(light.f) : attenuated(light, extent, step)) *
                   (light.spot ? spotted(light, at, step) : constant(1.0));

    const double NdotL = glm::dot(extent.N, sight.towards), turn = extent.turn + sight.turn;
    const bool ends = turnsAway(facet, light, extent, sight);
    const Term diffuse{std::min(1.0, std::abs(NdotL) + kFromMiddle * turn), step * turn,
                       (kSmooth * kTurning * step * turn + (ends ? kCut : 0.0)) * step * turn};
    Term specular = highlight(lighting_.form, material.n, extent, sight, eye, step);
    if (ends && (lighting_.form != Form::Tutorial || material.n == 0)) specular.error = specular.most;
    for (int c = 0; c < lighting_.channels; ++c)
      I[c] = I[c] + light.Ip[c] * (f * (material.kd[c] * diffuse + material.ks[c] * specular));
  }
  double most = 0;
  for (int c = 0; c < lighting_.channels; ++c) {
    const double error = I[c].error + (I[c].most > 1.0 ? kCut * I[c].change : 0.0);
    // both intensities are between the ambient one and the most
    const double range = std::min(1.0, I[c].most) - std::min(1.0, material.ambient[c]);
    most = std::max(most, std::min(range, atSamples + error));
  }
  return most;
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

double Misfit::mostApart(int along, const FrontBack<double>* I) const {
  double most = 0;
  const auto compare = [&](const FrontBack<double>& is, double front, double back) {
    most = std::max({most, std::abs(is.front - front), std::abs(is.back - back)});
  };
  const int samples = (along + 1) * (along + 2) / 2;
  if (flat_) {
    for (int k = 1; k <= samples; ++k) compare(I[k], I->front, I->back);
    return most;
  }
  const FrontBack<double>&A = I[samples - 1], &B = I[along], &C = I[0];
  for (int i = 0; i <= along; ++i)
    for (int j = 0; i + j <= along; ++j, ++I) {
      const double a = double(i) / along, b = double(j) / along, c = double(along - i - j) / along;
      compare(*I, a * A.front + b * B.front + c * C.front, a * A.back + b * B.back + c * C.back);
    }
  return most;
}

std::vector<double> Misfit::atSamples(std::span<const Facet> facets, std::span<const int> which,
                                      int along) const {
  std::vector<double> most(which.size(), 0.0);
  const std::size_t each = (along + 1) * (along + 2) / 2 + flat_;
  ShadingPoints samples;
  Terms diffuse, specular;
  Intensities intensities;
  for (std::size_t first = 0, end = 0; first < which.size(); first = end) {
    end = std::min(which.size(), first + kTogether / each + 1);
    MayGiveUp::check();
    samples = {};
    for (std::size_t k = first; k < end; ++k) addSamples(facets[which[k]], along, samples);
    for (int channel = 0; channel < lighting_.channels; ++channel) {
      diffuseIntensities(diffuse, samples, lighting_, channel);
      specularIntensities(specular, samples, lighting_, channel);
      addTerms(intensities, diffuse, specular, samples, lighting_, channel);
      for (std::size_t k = first; k < end; ++k)
        most[k] = std::max(most[k], mostApart(along, intensities.I.data() + (k - first) * each));
    }
  }
  return most;
}

std::vector<bool> Misfit::operator()(std::span<const Facet> facets) const {
  std::vector<bool> result(facets.size(), true);
  std::array<std::vector<int>, kAlong.size()> open;
  // Each grid holds the samples of the coarser ones. So a grid that cannot decide for a facet, even if its
  // new samples are no farther apart, is left out.
  const auto ask = [&](int k, std::size_t level, double atSamples) {
    while (level < kAlong.size() && everywhere(facets[k], kAlong[level], atSamples) > tolerance_) ++level;
    if (level < kAlong.size()) open[level].push_back(k);
  };
  for (int k = 0; k < static_cast<int>(facets.size()); ++k) ask(k, 0, 0.0);
  for (std::size_t level = 0; level < kAlong.size(); ++level) {
    const std::vector<double> most = atSamples(facets, open[level], kAlong[level]);
    for (std::size_t at = 0; at < most.size(); ++at) {
      const int k = open[level][at];
      if (everywhere(facets[k], kAlong[level], most[at]) <= tolerance_)
        result[k] = false;
      else
        ask(k, level + 1, most[at]);
    }
  }
  return result;
}

}  // namespace xnewell
