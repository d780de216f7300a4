#include "shading/fill/evaluated.h"

#include <algorithm>
#include <cmath>

#include "shading/fill/dispatch.h"
#include "shading/fill/evaluate_pixels.h"

namespace xnewell {

namespace {

/// As in AffineOver: in a triangle narrower than 2^-12 pixel the snap decides the gradient.
constexpr double kSteepest = 0x1p12;

XNEWELL_DISPATCHED
void fillTerms(const TermsTriangle& t, std::uint8_t* cells, int i, int j, int count) {
  fillPixels<Lanes<float, 8>>(t, cells, i, j, count);
}

XNEWELL_DISPATCHED
void fillPhong(const PhongTriangle& t, std::uint8_t* cells, int i, int j, int count) {
  fillPixels<Lanes<float, 8>>(t, cells, i, j, count);
}

XNEWELL_DISPATCHED
void fillPhongInDouble(const PhongTriangle& t, std::uint8_t* cells, int i, int j, int count) {
  fillPixels<Lanes<double, 4>>(t, cells, i, j, count);
}

XNEWELL_DISPATCHED
void sumTerms(const TermsTriangle& t, double* sums, int i, int j, int count) {
  storeSums<Lanes<float, 8>>(t, sums, i, j, count);
}

XNEWELL_DISPATCHED
void sumPhong(const PhongTriangle& t, double* sums, int i, int j, int count) {
  storeSums<Lanes<float, 8>>(t, sums, i, j, count);
}

XNEWELL_DISPATCHED
void sumPhongInDouble(const PhongTriangle& t, double* sums, int i, int j, int count) {
  storeSums<Lanes<double, 4>>(t, sums, i, j, count);
}

/// The sum at one sample.
template <class Triangle>
double sumAt(const Triangle& t, int i, int j) {
  using Real = Lanes<double, 4>;
  const Real along = splat<Real>(i - t.i0);
  const double down = j - t.j0;
  TexelRow<Real> texels{t, down};
  if (texels) texels.locate(&along, 1);
  double sum = 0;
  withRow<Real>(t, down, [&](auto row) {
    row.evaluate(&along, 1, texels);
    sum = row.sum(0)[0];
  });
  return sum;
}

}  // namespace

PixelPlanes::PixelPlanes(const std::array<glm::ivec3, 3>& p)
    : i0_{sampleFrom(std::min({p[0].x, p[1].x, p[2].x}))},
      j0_{sampleFrom(std::min({p[0].y, p[1].y, p[2].y}))} {
  const auto pixels = [](std::int64_t steps) { return static_cast<double>(steps) / kGrid; };
  const auto centre = [](int i) { return std::int64_t{i} * kGrid + kGrid / 2; };
  x0_ = pixels(p[0].x - centre(i0_)), y0_ = pixels(p[0].y - centre(j0_));
  x1_ = pixels(std::int64_t{p[1].x} - p[0].x), y1_ = pixels(std::int64_t{p[1].y} - p[0].y);
  x2_ = pixels(std::int64_t{p[2].x} - p[0].x), y2_ = pixels(std::int64_t{p[2].y} - p[0].y);
  const double area = x1_ * y2_ - x2_ * y1_;
  const double longest = std::max({std::abs(x1_), std::abs(y1_), std::abs(x2_), std::abs(y2_)});
  perArea_ = std::abs(area) * kSteepest > longest ? 1.0 / area : 0.0;
}

PixelPlane PixelPlanes::operator()(const std::array<double, 3>& v) const {
  if (perArea_ == 0.0) return {(v[0] + v[1] + v[2]) / 3.0, 0.0, 0.0};
  const double d1 = v[1] - v[0], d2 = v[2] - v[0];
  const double gx = (d1 * y2_ - d2 * y1_) * perArea_, gy = (d2 * x1_ - d1 * x2_) * perArea_;
  return {v[0] - gx * x0_ - gy * y0_, gx, gy};
}

void PhongTriangle::span(std::uint8_t* cells, int i, int j, int count) const {
  if (material->n > kMostForSingle)
    fillPhongInDouble(*this, cells, i, j, count);
  else
    fillPhong(*this, cells, i, j, count);
}
double PhongTriangle::intensity(int i, int j) const { return sumAt(*this, i, j); }
void PhongTriangle::intensities(double* I, int i, int j, int count) const {
  if (material->n > kMostForSingle)
    sumPhongInDouble(*this, I, i, j, count);
  else
    sumPhong(*this, I, i, j, count);
}

void TermsTriangle::span(std::uint8_t* cells, int i, int j, int count) const {
  fillTerms(*this, cells, i, j, count);
}
double TermsTriangle::intensity(int i, int j) const { return sumAt(*this, i, j); }
void TermsTriangle::intensities(double* I, int i, int j, int count) const { sumTerms(*this, I, i, j, count); }

}  // namespace xnewell
