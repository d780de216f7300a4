#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <cstring>

#include "shading/fill/phong_row.h"
#include "shading/fill/pixel_row.h"
#include "shading/fill/texel_row.h"

namespace xnewell {

/// How PhongTriangle and TermsTriangle are evaluated, several pixels at once.

/// The sum of interpolated terms along a row.
template <class Real>
class TermRow {
 public:
  [[gnu::always_inline]] TermRow(const TermsTriangle& t, double down)
      : diffuse_{t.diffuse, down}, rest_{t.rest, down} {}
  /// Moves to `blocks` times kLanes pixels, for which `texels` are located.
  [[gnu::always_inline]] void evaluate(const Real* along, int, const TexelRow<Real>& texels) {
    along_ = along, texels_ = &texels;
  }
  /// The sum at a block of them.
  [[nodiscard, gnu::always_inline]] Real sum(int b) const {
    const Real diffuse = diffuse_.at(along_[b]), rest = rest_.at(along_[b]);
    return rest + (*texels_ ? diffuse * texels_->share(b) : diffuse);
  }

 private:
  RowOf<Real> diffuse_, rest_;
  const Real* along_ = nullptr;
  const TexelRow<Real>* texels_ = nullptr;
};

/// Calls then(row) with the row of a triangle, `down` rows below its first.
template <class Real, class Then>
[[gnu::always_inline]] inline void withRow(const TermsTriangle& t, double down, const Then& then) {
  then(TermRow<Real>{t, down});
}
template <class Real, class Then>
[[gnu::always_inline]] inline void withRow(const PhongTriangle& t, double down, const Then& then) {
  if (t.lighting->mistake != Mistake::None)
    then(MistakenRow<Real>{t, down});
  else if (!isOfFarLights(t))
    then(PhongRow<Real>{t, down});
  else if (t.material->ks[t.channel] == 0.0)
    then(FarLightsRow<Real, Eye::None>{t, down});
  else if (t.variesV)
    then(FarLightsRow<Real, Eye::Near>{t, down});
  else
    then(FarLightsRow<Real, Eye::Far>{t, down});
}

/// Four or eight numbers in [0, 255], each in a byte. A number outside gives any byte.
template <class Integers>
[[gnu::always_inline]] inline auto bytesOf(const Integers& whole) {
  static_assert(kLanes<Integers> == 4 || kLanes<Integers> == 8);
  Lanes<std::uint8_t, kLanes<Integers>> bytes;
#ifdef __SSE2__
  __m128i first, last;  // the same if there are four numbers
  std::memcpy(&first, &whole, sizeof first);
  std::memcpy(&last, reinterpret_cast<const char*>(&whole) + sizeof whole - sizeof last, sizeof last);
  const __m128i words = _mm_packs_epi32(first, last), packed = _mm_packus_epi16(words, words);
  std::memcpy(&bytes, &packed, sizeof bytes);
#else
  for (int k = 0; k < kLanes<Integers>; ++k) bytes[k] = static_cast<std::uint8_t>(whole[k]);
#endif
  return bytes;
}

/// Stores the cells of a row's sums at `pixels` pixels. A sum that is not a number, past the end of a span,
/// has the lowest cell. Adds the number of sums above 1 to `above`.
template <class Real>
[[gnu::always_inline]] inline void storeCells(const Ramp& ramp, const auto& row, int pixels,
                                              std::uint8_t* cells, IntegersOf<Real>& above) {
  constexpr int kSideBySide = kLanes<Real>;
  using Bytes = Lanes<std::uint8_t, kSideBySide>;
  const Real one = splat<Real>(1.0), lane = lanesFrom0<Real>();
  const ValueOnRamp<Real> value{ramp};
  const auto cut = [](const Real& v) { return __builtin_convertvector(v, IntegersOf<Real>); };
  const auto each = [&] [[gnu::always_inline]] (const auto& cellsOf) {
    const int whole = pixels / kSideBySide, left = pixels % kSideBySide;
    for (int b = 0; b < whole; ++b) {
      const Real sum = row.sum(b);
      above -= __builtin_convertvector(sum > one, IntegersOf<Real>);
      const Bytes bytes = cellsOf(sum);
      std::memcpy(cells + b * kSideBySide, &bytes, sizeof bytes);
    }
    if (left == 0) return;
    const Real sum = row.sum(whole);
    above -= __builtin_convertvector(sum > one && lane < splat<Real>(left), IntegersOf<Real>);
    const Bytes bytes = cellsOf(sum);
    std::memcpy(cells + whole * kSideBySide, &bytes, static_cast<std::size_t>(left));
  };
  if (ramp.table != nullptr) {
    each([&] [[gnu::always_inline]] (const Real& I) { return ramp.table->cells(I); });
  } else {
    each([&] [[gnu::always_inline]] (const Real& I) { return bytesOf(cut(value(I))); });
  }
}

/// Calls use(row, pixels, done) for parts of a span, one after the other: the row is at `pixels` pixels,
/// after `done` others.
template <class Real, class Triangle, class Use>
[[gnu::always_inline]] inline void alongSpan(const Triangle& t, int i, int j, int count, const Use& use) {
  constexpr int kSideBySide = kLanes<Real>;
  constexpr int kMost = kMostBlocks * kSideBySide;
  const double down = j - t.j0;
  TexelRow<Real> texels{t, down};
  withRow<Real>(t, down, [&] [[gnu::always_inline]] (auto row) {
    Real at = splat<Real>(i - t.i0) + lanesFrom0<Real>();
    for (int done = 0; done < count; done += kMost) {
      const int pixels = std::min(kMost, count - done), blocks = (pixels + kSideBySide - 1) / kSideBySide;
      Real along[kMostBlocks];
      for (int b = 0; b < blocks; ++b, at += splat<Real>(kSideBySide)) along[b] = at;
      if (texels) texels.locate(along, blocks);
      row.evaluate(along, blocks, texels);
      use(row, pixels, done);
    }
  });
}

template <class Real, class Triangle>
[[gnu::always_inline]] inline void fillPixels(const Triangle& t, std::uint8_t* cells, int i, int j,
                                              int count) {
  IntegersOf<Real> above{};
  alongSpan<Real>(t, i, j, count, [&] [[gnu::always_inline]] (const auto& row, int pixels, int done) {
    storeCells<Real>(t.ramp, row, pixels, cells + done, above);
  });
  for (int l = 0; l < kLanes<Real>; ++l) *t.clamped += above[l];
}

/// Stores the sums instead of their cells.
template <class Real, class Triangle>
[[gnu::always_inline]] inline void storeSums(const Triangle& t, double* sums, int i, int j, int count) {
  alongSpan<Real>(t, i, j, count, [&] [[gnu::always_inline]] (const auto& row, int pixels, int done) {
    for (int k = 0; k < pixels; k += kLanes<Real>) {
      const Real sum = row.sum(k / kLanes<Real>);
      for (int l = 0; l < std::min(kLanes<Real>, pixels - k); ++l) sums[done + k + l] = sum[l];
    }
  });
}

}  // namespace xnewell
