#include "shading/light/depth_shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Vector = std::array<Real, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unitOf(const Vector& a) {
  const Real length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return {a[0] / length, a[1] / length, a[2] / length};
}
double sumOf(const glm::dvec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

/// Faces of 3 to 9 corners in one plane across the view, rounded to doubles, at any place and of any size;
/// the last one may be moved away from the eye.
struct Across {
  Mesh mesh;
  SnappedScene snapped;
  ViewSpec view;
  double bound = 0.0;  ///< what the header lets rounding explain

  explicit Across(unsigned seed) : rng_{seed} {
    view.vpn = {any(1.0), any(1.0), any(1.0)};
    view.vup = {any(1.0), any(1.0), any(1.0)};
    view.vrp = std::exp2(any(12.0)) * glm::dvec3{any(1.0), any(1.0), any(1.0)};
    N_ = unitOf({view.vpn.x, view.vpn.y, view.vpn.z});
    u_ = unitOf(cross(N_, {view.vup.x, view.vup.y, view.vup.z}));
    v_ = cross(N_, u_);
    size_ = std::exp2(any(12.0));
    for (unsigned f = 0; f < 2 + seed % 20; ++f) add(0.0);
  }
  void add(double behind) {
    const int n = 3 + static_cast<int>(rng_() % 7);
    std::vector<int> corners;
    for (int k = 0; k < n; ++k) {
      const Real a = any(size_), b = any(size_);
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<double>(Real{view.vrp[axis]} + a * u_[axis] + b * v_[axis] - behind * N_[axis]);
      corners.push_back(static_cast<int>(mesh.points.size()));
      mesh.points.push_back(p);
      bound = std::max(bound, 2.0 * (n + 9) * 0x1p-53 * (sumOf(p) + sumOf(view.vrp)));
    }
    snapped.faces.push_back({.number = mesh.faceCount()});
    mesh.addFace(corners, 0);
  }
  [[nodiscard]] std::vector<double> intensities() const { return depthIntensities(mesh, snapped, view); }
  /// The distance between the nearest and the farthest mean, as the program's z of the corners have it.
  [[nodiscard]] double apart() const {
    std::vector<double> means;
    for (const SnappedFace& face : snapped.faces) {
      double sum = 0.0;
      const DepthTerms terms = depthTerms(mesh, view, {.near = 0.0, .length = 1.0}, face.number);
      for (const double z : terms.z) sum += z;
      means.push_back(sum / static_cast<double>(terms.z.size()));
    }
    const auto [least, most] = std::ranges::minmax_element(means);
    return *most - *least;
  }

 private:
  double any(double most) { return std::uniform_real_distribution<double>{-most, most}(rng_); }

  std::mt19937 rng_;
  double size_;
  Vector N_, u_, v_;
};

}  // namespace

// Faces in a plane across the view have one depth, whatever rounding makes of their corners: all have the
// intensity 1. Random errors mostly cancel: the largest share of the bound is 0.02.
TEST(DepthShading, OneDepthWhateverTheDirection) {
  double most = 0.0;
  const Seeds seeds{2'000};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const Across across{seed};
    const double share = across.apart() / across.bound;
    ASSERT_LE(share, 1.0);
    most = std::max(most, share);
    EXPECT_EQ(depthRange(across.mesh, across.snapped, across.view).length, 0.0);
    for (const double I : across.intensities()) ASSERT_EQ(I, 1.0);
  }
  if (seeds.all()) {
    EXPECT_GT(most, 0.01);
  }
}

// A face that lies farther away by three times the bound is told apart: it has 0, and the others have
// nearly 1.
TEST(DepthShading, DepthsBeyondRoundingDiffer) {
  const Seeds seeds{2'000};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    Across across{seed};
    across.add(3.0 * across.bound);
    const std::vector<double> I = across.intensities();
    EXPECT_EQ(I.back(), 0.0);
    EXPECT_EQ(std::ranges::max(I), 1.0);
    for (std::size_t f = 0; f + 1 < I.size(); ++f) EXPECT_GT(I[f], 0.5);
  }
}

}  // namespace xnewell::THIS_FILE
