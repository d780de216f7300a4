#pragma once

#include "geometry/view/screen_grid.h"
#include "geometry/view/view.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

/// A view, a picture and a point. In an input of ranges:
///   0 whether parallel, 1 width, 2 height, 3 D, 4 5 prp.x and prp.y over D, 6 7 the window's lower corner
///   over D, 8 9 its size over D, 10 distance of the front plane over D, 11 that of the back plane over that
///   of the front plane, 12 d over the front's distance, 13 14 where on the window.
/// Prepared: parallel, width, height, prp, window min, window max, front, back, then the point in VRC.
inline constexpr std::size_t kPoint = 12;
inline std::vector<Coordinate> viewInput() {
  return {integers(0, 1),
          integers(1, kMaxPicture),
          integers(1, kMaxPicture),
          doubles(0x1p-40, 0x1p40),
          doubles(-10, 10),
          doubles(-10, 10),
          doubles(-10, 10),
          doubles(-10, 10),
          doubles(0x1p-14, 0x1p10),
          doubles(0x1p-14, 0x1p10),
          doubles(0x1p-20, 1),
          doubles(1, 0x1p40),
          doubles(1, 0x1p40),
          doubles(0, 1),
          doubles(0, 1)};
}
inline Numbers preparedView(const Numbers& in) {
  const double D = in[3], dF = D * in[10], dB = dF * in[11], d = dF * in[12];
  const double px = D * in[4], py = D * in[5], left = D * in[6], low = D * in[7];
  const double right = left + D * in[8], high = low + D * in[9], front = D - dF, back = D - dB;
  if (!(left < right && low < high && front > back && d <= dB && (front < D || in[0] > 0))) return {};
  const double x = left + (right - left) * in[13], y = low + (high - low) * in[14];
  const double q = d / D, Z = D - d;
  // Along the projector through the place on the window.
  const double slope = in[0] > 0 ? Z / D : 0, cx = left / 2 + right / 2, cy = low / 2 + high / 2;
  const double X = in[0] > 0 ? x + slope * (px - cx) : px + (x - px) * q;
  const double Y = in[0] > 0 ? y + slope * (py - cy) : py + (y - py) * q;
  return {in[0], in[1], in[2], px, py, D, left, low, right, high, front, back, X, Y, Z};
}
inline Numbers randomView(Random& random) {
  const double w = random.power(-12, 3), deep = random.power(0, 30);
  return {static_cast<double>(random.oneIn(4)),
          static_cast<double>(random.integer(1, kMaxPicture)),
          static_cast<double>(random.integer(1, kMaxPicture)),
          random.power(-10, 10),
          random.oneIn(2) ? 0 : random.uniform(-2, 2),
          random.oneIn(2) ? 0 : random.uniform(-2, 2),
          -w * random.uniform(0.2, 0.8),
          -w * random.uniform(0.2, 0.8),
          w,
          w * random.uniform(0.5, 2),
          random.oneIn(2) ? random.power(-10, 0) : 1 - random.power(-53, -1),
          random.oneIn(2) ? 1 + random.power(-50, 0) : deep,
          random.oneIn(2) ? 1 + random.power(-50, 0) : random.power(0, 30),
          random.uniform(0, 1),
          random.uniform(0, 1)};
}
inline ViewSpec viewOf(const Numbers& in) {
  ViewSpec view;
  view.projection = in[0] > 0 ? Projection::Parallel : Projection::Perspective;
  view.prp = {in[3], in[4], in[5]};
  view.windowMin = {in[6], in[7]};
  view.windowMax = {in[8], in[9]};
  view.front = in[10], view.back = in[11];
  return view;
}

}  // namespace xnewell
