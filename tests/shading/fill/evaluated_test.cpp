#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <type_traits>

#include "geometry/model/solids.h"
#include "geometry/view/project.h"
#include "geometry/view/scanline.h"
#include "shading/fill/affine.h"
#include "shading/fill/evaluate_pixels.h"
#include "shading/fill/evaluated.h"
#include "tests/support/illuminate.h"
#include "tests/support/random_triangles.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Affine values

using Triangle = std::array<glm::ivec3, 3>;
// A face without area has no plane; it has the mean of its values, and so has a sliver that would be too
// steep.
TEST(Affine, IsFlatWithoutAnArea) {
  const Triangle line{glm::ivec3{0, 0, 0}, {kGrid, kGrid, 0}, {3 * kGrid, 3 * kGrid, 0}};
  EXPECT_EQ(affineOver(line.data(), {1, 2, 6}), (AffineValue{3u << 24, 0, 0}));
  const Triangle sliver{glm::ivec3{0, 0, 0}, {100 * kGrid, kGrid, 0}, {200 * kGrid, 2 * kGrid + 1, 0}};
  EXPECT_EQ(affineOver(sliver.data(), {100, 1, 250}), (AffineValue{117u << 24, 0, 0}));
  const Triangle point{};
  EXPECT_EQ(affineOver(point.data(), {1, 2, 6}), (AffineValue{3u << 24, 0, 0}));
}

/// ---- Terms and normals at pixels

// The pixels' single precision against the same evaluation in double: planes, normal and cosine are off by
// less than 2^-19 together, which the power multiplies by n; beyond n = 1,024 pixels have double precision
// too. So the cell is that of an intensity no farther away.
TEST(Evaluated, AgreesWithDoublePrecision) {
  int compared = 0;
  double farthest = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomTriangles random{seed};
    const double bound = std::ldexp(random.n() > 1024 ? 8.0 : random.n() + 8.0, -19);
    for (const double size : {3.0, 40.0, 700.0, 8191.0}) {
      const auto p = random.outline(size);
      random.triangle(p, seed % 4 != 0, false, [&](const auto& e) {
        int rows = 0;
        forEachSpan(p.data(), 3, 8192, 8192, [&](int j, int from, int to) {
          if (rows++ % (size > 100 ? 100 : 1) != 0) return;
          std::vector<std::uint8_t> cells(to - from);
          e.span(cells.data(), from, j, to - from);
          for (int i = from; i < to; i += 1 + (to - from) / 400) {
            const double I = e.intensity(i, j), v = cells[i - from];
            // The intensities that have this cell.
            const double low = v == 1 ? -1e9 : (v - 1.5) / 254, high = v == 255 ? 1e9 : (v - 0.5) / 254;
            const double off = std::max({0.0, low - I, I - high});
            ASSERT_LE(off, bound) << i << ", " << j << ": " << I;
            farthest = std::max(farthest, off);
            ++compared;
          }
        });
      });
    }
  }
  EXPECT_GT(compared, 1'000'000);
  EXPECT_GT(farthest, 0.0);  // the two are not the same computation
}

// In double precision a pixel's intensity is the equation's, of the normal, the place and the direction to
// the eye that are interpolated there. Planes whose parts are below 16 are off by less than 2^-47, so N
// (longer than 1/2), V and L (longer than 1/2) are off by less than 2^-44 and the cosines by less than 2^-41,
// which the power multiplies by n; a highlight below 2^-40 counts as none. Not near N.L = 0, where the
// highlight begins at once.
TEST(Evaluated, PhongIsTheEquation) {
  int compared = 0, lit = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomTriangles random{seed};
    const auto p = random.outline(300);
    const PhongTriangle e = random.phong(p, false);
    const Lighting& lighting = random.lighting();
    const Illumination user{.n = random.n()};
    for (int trial = 0; trial < 40; ++trial) {
      const int i = e.i0 + static_cast<int>(random.uniform(0, 300));
      const int j = e.j0 + static_cast<int>(random.uniform(0, 300));
      double largest = 0;
      const auto at = [&](const std::array<PixelPlane, 3>& planes) {
        glm::dvec3 v;
        for (int axis = 0; axis < 3; ++axis) {
          const double along = planes[axis].gx * (i - e.i0), down = planes[axis].gy * (j - e.j0);
          v[axis] = planes[axis].c + along + down;
          largest = std::max({largest, std::abs(planes[axis].c), std::abs(along), std::abs(down)});
        }
        return v;
      };
      const glm::dvec3 ofN = at(e.N), P = at(e.at), ofV = at(e.V);
      const glm::dvec3 N = glm::normalize(ofN), V = glm::normalize(ofV);
      if (largest > 16 || std::min(glm::length(ofN), glm::length(ofV)) < 0.5) continue;
      double I = lighting.materials[0].ambient[0], total = 0;
      bool apart = true;
      for (const Light& light : random.lights()) {
        const glm::dvec3 towards =
            light.kind == LightKind::Directional ? light.direction : light.position - P;
        const double Ip = luminance(light.Ip);
        const IlluminationTerms terms =
            illuminate(0, Ip, light, {0, user.kd, user.ks, user.n}, N, V, P, Form::Textbook);
        I += terms.diffuse + terms.specular, total += Ip;
        apart &= glm::length(towards) > 0.5 && std::abs(glm::dot(N, glm::normalize(towards))) > 1e-9;
      }
      if (!apart) continue;
      ASSERT_NEAR(e.intensity(i, j), I, std::ldexp(1.0 + user.n, -40) * 4 * total) << i << ", " << j;
      ++compared, lit += I > lighting.materials[0].ambient[0];
    }
  }
  EXPECT_GT(compared, 4000);
  EXPECT_GT(lit, 2000);
}

// Lights far away are evaluated from planes of N.L and L.V; as all other lights, from vectors, they give the
// same, with any number of them and V near or far.
TEST(Evaluated, FarLightsAreAsAnyLights) {
  using Real = Lanes<double, 4>;
  int highlights = 0;
  for (unsigned seed = 0; seed < 400; seed += 2) {
    SCOPED_TRACE(seed);
    RandomTriangles random{seed};
    const auto p = random.outline(700);
    PhongTriangle e = random.phong(p, seed % 3 == 0);
    Lighting lighting = *e.lighting;
    Material material = *e.material;
    while (lighting.sources.size() < 1 + seed / 2 % 3) {
      Lighting::Source light = lighting.sources[0];
      light.L = glm::normalize(glm::dvec3{random.uniform(-1, 1), random.uniform(-1, 1), 0.5});
      light.f = 0.75;
      lighting.sources.push_back(light);
    }
    e.lighting = &lighting, e.material = &material;
    e.variesV = seed % 4 == 0;
    if (seed % 10 == 0) material.ks = {};
    if (material.n == 0) material.n = 1;
    const bool shines = material.ks[0] != 0.0;
    for (int j = e.j0; j < e.j0 + 700; j += 41) {
      const Real along{random.uniform(0, 700), random.uniform(0, 700), 0, 699};
      const double down = j - e.j0;
      TexelRow<Real> texels{e, down};
      if (texels) texels.locate(&along, 1);
      PhongRow<Real> any{e, down};
      any.evaluate(&along, 1, texels);
      withRow<Real>(e, down, [&](auto far) {
        ASSERT_NE((std::is_same_v<decltype(far), PhongRow<Real>>), true);
        far.evaluate(&along, 1, texels);
        for (int k = 0; k < 4; ++k) ASSERT_NEAR(far.sum(0)[k], any.sum(0)[k], 1e-14 * (material.n + 50)) << j;
      });
      if (!shines) continue;
      material.ks = {};
      PhongRow<Real> dull{e, down};
      dull.evaluate(&along, 1, texels);
      for (int k = 0; k < 4; ++k) highlights += any.sum(0)[k] > dull.sum(0)[k] + 1e-6;
      material.ks = random.lighting().materials[0].ks;
    }
  }
  EXPECT_GT(highlights, 300);
}

// Between opposite normals there is a place that has none. Beside it pixels are as lit as a unit vector can
// make them and no more, wherever rounding leaves the normal there.
TEST(Evaluated, OppositeNormalsStayWithinBounds) {
  RandomTriangles random{4};
  for (int trial = 0; trial < 2000; ++trial) {
    SCOPED_TRACE(trial);
    const auto p = random.outline(trial % 2 ? 9 : 300);
    PhongTriangle e = random.phong(p, false);
    Material matt = *e.material;
    matt.ks = {};
    e.material = &matt;
    const double zero = std::round(random.uniform(1, trial % 2 ? 9 : 300)), slope = random.uniform(1e-3, 1);
    for (PixelPlane& plane : e.N) {
      const double c = random.uniform(-1, 1) * slope;
      plane = {-c * zero, c, 0};  // but for rounding all are 0 at the same pixel
    }
    double most = matt.ambient[0];
    for (const Lighting::Source& light : e.lighting->sources) most += light.f * light.Ip[0] * matt.kd[0];
    ASSERT_LT(most, 1);
    std::vector<std::uint8_t> cells(300);
    random.clamped = 0;
    e.span(cells.data(), e.i0, e.j0, 300);
    EXPECT_EQ(random.clamped, 0);
    for (const std::uint8_t cell : cells) ASSERT_LE(cell, kChannelRamp.cell(most + 1e-6));
  }
}

// A pixel has one value: whole spans, parts of them and single pixels agree, and so do the code that is
// chosen for the processor and the code for any.
TEST(Evaluated, SpansMayBeginAnywhere) {
  int pixels = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    RandomTriangles random{seed};
    const auto p = random.outline(seed % 2 ? 60 : 900);
    random.triangle(p, seed % 5 != 0, seed % 3 == 1, [&](const auto& e) {
      constexpr bool kPhong = std::is_same_v<decltype(e), const PhongTriangle&>;
      forEachSpan(p.data(), 3, 8192, 8192, [&](int j, int from, int to) {
        if (j % 7 != 0) return;
        const int count = to - from, cut = static_cast<int>(random.uniform(0, count));
        std::vector<std::uint8_t> whole(count), parts(count), plain(count);
        random.clamped = 0;
        e.span(whole.data(), from, j, count);
        const std::int64_t clamped = random.clamped;
        if (cut > 0) e.span(parts.data(), from, j, cut);
        e.span(parts.data() + cut, from + cut, j, count - cut);
        ASSERT_EQ(whole, parts) << j;
        ASSERT_EQ(random.clamped, 2 * clamped);
        if (kPhong && random.n() > 1024)
          fillPixels<Lanes<double, 4>>(e, plain.data(), from, j, count);
        else
          fillPixels<Lanes<float, 8>>(e, plain.data(), from, j, count);
        ASSERT_EQ(whole, plain) << j;
        pixels += count;
      });
    });
  }
  EXPECT_GT(pixels, 300'000);
}

// A sliver has the mean of its corners, and no normal at all only ambient light.
TEST(Evaluated, DegenerateTrianglesStayFinite) {
  const PixelPlanes planes{{{{0, 0, 0}, {100 * kGrid, kGrid, 0}, {200 * kGrid, 2 * kGrid + 1, 0}}}};
  const PixelPlane plane = planes({1, 2, 6});
  EXPECT_EQ(plane.c, 3.0);
  EXPECT_EQ(plane.gx, 0.0);
  RandomTriangles random{1};
  const auto p = random.outline(50);
  PhongTriangle e = random.phong(p, false);
  e.N = {};
  std::array<std::uint8_t, 20> cells;
  e.span(cells.data(), e.i0, e.j0, 20);
  for (const std::uint8_t c : cells) EXPECT_EQ(c, kChannelRamp.cell(e.material->ambient[0]));
}

// Lanes are evaluated past the end of a span, where 1/w may be 0, negative or beyond all bounds: what they
// read stays within texture and table, and the span's own samples know nothing of it.
TEST(Evaluated, LanesPastTheEndReadNothingElse) {
  RandomTriangles random{1};
  const auto p = random.outline(50);
  const TableCells table{ColorTable{{.kind = TableKind::Corrected}}};
  for (const double past : {0.0, 1e-300, 1e-30, 1e-9, -1e-9, -0.25}) {
    SCOPED_TRACE(past);
    const auto fill = [&](auto e) {
      e.q = {1, past - 1, 0};  // 1/w falls to `past` at the second pixel, and is negative beyond
      e.u = {0.3, 2e6, 0}, e.v = {-0.3, -3e7, 0};
      std::uint8_t cell = 0;
      e.span(&cell, e.i0, e.j0, 1);
      EXPECT_EQ(cell, kChannelRamp.cell(e.intensity(e.i0, e.j0)));
      e.ramp.table = &table;
      e.span(&cell, e.i0, e.j0, 1);
      EXPECT_EQ(cell, table.cell(e.intensity(e.i0, e.j0)));
    };
    fill(random.phong(p, true));
    for (const double scale : {1.0, 1e30, -1e30}) {
      TermsTriangle e = random.terms(p, true);
      e.rest.gx = scale;
      fill(e);
    }
  }
}

/// ---- Textures

// A texture that does not repeat ends with its last texels, where coordinates are 1 to the last bit or a
// rounding beyond; one that repeats begins again there. v = 0 is the lowest row in both.
TEST(Evaluated, TexturesEndOrRepeat) {
  RandomTriangles random{2};
  const auto p = random.outline(50);
  TermsTriangle e = random.terms(p, true);  // 5 x 3 texels, the k-th is 17 k
  e.diffuse = {1, 0, 0}, e.rest = {0, 0, 0}, e.q = {1, 0, 0};
  const auto texel = [&](double u, double v, bool repeats) {
    e.u = {u, 0, 0}, e.v = {v, 0, 0}, e.repeats = repeats;
    return std::lrint(e.intensity(e.i0, e.j0) * 255) / 17;
  };
  for (const double beyond : {0.0, 1e-15, 1e-9}) {
    EXPECT_EQ(texel(1 + beyond, 0.5, false), 9);
    EXPECT_EQ(texel(1 + beyond, 0.5, true), 5);
    EXPECT_EQ(texel(0.5, 1 + beyond, false), 2);
    EXPECT_EQ(texel(0.5, 1 + beyond, true), 12);
    EXPECT_EQ(texel(0 - beyond, 0.5, false), 5);
    EXPECT_EQ(texel(0.5, 0 - beyond, false), 12);
  }
  EXPECT_EQ(texel(0.5, 0, true), 12);
  EXPECT_EQ(texel(-1.5, 7.5, true), 7);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
