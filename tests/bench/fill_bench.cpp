#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/exact/trig.h"
#include "geometry/files/bpt.h"
#include "geometry/model/solids.h"
#include "geometry/model/vertex_normals.h"
#include "shading/fill/environment.h"
#include "shading/fill/evaluated.h"
#include "shading/fill/fill.h"
#include "shading/fill/gouraud.h"
#include "tests/bench/least.h"
#include "tests/bench/triangulated.h"
#include "tests/support/normal_error.h"
#include "tests/support/random_triangles.h"

namespace xnewell {

namespace {

/// Equilateral triangles with sides of `side` pixels, anywhere within 800x600 and turned any way.
std::vector<glm::ivec3> randomTriangles(int side, int count) {
  std::mt19937 rng{1972};
  const double radius = side / std::sqrt(3.0);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(rng()) * 0x1p-32);
  };
  std::vector<glm::ivec3> p;
  for (int t = 0; t < count; ++t) {
    const double x = uniform(radius, 800 - radius), y = uniform(radius, 600 - radius), a = uniform(0, 6.2832);
    for (int k = 0; k < 3; ++k)  // counter-clockwise as seen, with y down
      p.push_back({std::lrint((x + radius * std::cos(a + k * 2.0944)) * kGrid),
                   std::lrint((y - radius * std::sin(a + k * 2.0944)) * kGrid), 0});
  }
  return p;
}

/// Nanoseconds a byte of an explicit loop of stores over the image, the best so far. No filler can be faster.
double storeLoop(IndexImage& image) {
  constexpr int kPasses = 40;
  static double best = 1e30;
  for (int batch = 0; batch < 10; ++batch) {
    const double start = processorTime();
    for (int pass = 0; pass < kPasses; ++pass) {
      std::uint8_t* at = image.pixels.data();
      for (const std::uint8_t* const end = at + image.pixels.size() / 16 * 16; at != end; at += 16) {
        for (int i = 0; i < 16; ++i) at[i] = static_cast<std::uint8_t>(pass);
        benchmark::ClobberMemory();
      }
    }
    best = std::min(best, processorTime() - start);
  }
  return 1e6 * best / kPasses / static_cast<double>(image.pixels.size());
}

/// What the triangles are filled with, made from values at their vertices. Its set-up is a part of the work.
struct Values {
  const glm::ivec3* p;
  const std::array<double, 3>*u, *v, *w;
};
const std::vector<std::uint8_t>& table() {
  static const std::vector<std::uint8_t> cells = [] {
    std::vector<std::uint8_t> grows(65'536);
    for (std::size_t k = 0; k < grows.size(); ++k) grows[k] = static_cast<std::uint8_t>(std::sqrt(k));
    return grows;
  }();
  return cells;
}
FlatCell flat(const Values& at) { return {static_cast<std::uint8_t>((*at.u)[0])}; }
GouraudLinear gouraudLinear(const Values& at) { return {affineOver(at.p, *at.u)}; }
GouraudTable gouraudTable(const Values& at) {
  static const CellsByKey cells = [] {
    std::vector<std::uint32_t> begins;  // as those of a table that is corrected for the eye
    for (int j = 1; j < 240; ++j) begins.push_back(static_cast<std::uint32_t>(std::exp2(27 + j / 48.0)));
    return CellsByKey{11, begins};
  }();
  return {affineOver(at.p, *at.u), &cells};
}
EnvironmentMap environmentMap(const Values& at) {
  const AffineOver over{at.p};
  return {over(*at.u), over(*at.v), table().data()};
}
/// What Phong shading and textures need: one light far away, as by default.
struct Evaluation {
  Lighting lighting;
  Texture texture{256, 256, {}, std::vector<std::uint8_t>(65'536, 200)};
  std::int64_t clamped = 0;
  explicit Evaluation(bool constantV)
      : lighting{resolve(cube(), {}, {.constantV = constantV}, Channels::Luminance, {2, -5, 3}, {0, 0, 0})} {}
};
/// Unit normals that turn by up to a right angle from vertex to vertex, at places beside each other.
PhongTriangle phong(const Values& at) {
  static Evaluation with{false};
  const PixelPlanes planes{{at.p[0], at.p[1], at.p[2]}};
  PhongTriangle e;
  e.i0 = planes.i0(), e.j0 = planes.j0();
  e.clamped = &with.clamped;
  e.lighting = &with.lighting;
  e.material = &with.lighting.materials[0];
  const double u = (*at.u)[0] / 256, v = (*at.v)[0] / 256;
  e.N = {planes({u, 1, 0}), planes({1 - u, 0, v}), planes({0.5, 0.5, 1})};
  e.variesV = with.lighting.variesV();
  e.V = {planes({2, 2 - u, 1.9}), planes({-5, -5.1, -5 - v}), planes({3, 2.95, 2.9})};
  return e;
}
/// Constant terms times the texel.
TermsTriangle perspectiveTexture(const Values& at) {
  static Evaluation with{true};
  const PixelPlanes planes{{at.p[0], at.p[1], at.p[2]}};
  TermsTriangle e;
  e.i0 = planes.i0(), e.j0 = planes.j0();
  e.clamped = &with.clamped;
  e.diffuse.c = (*at.w)[0] / 512, e.rest.c = 0.2;
  e.texture = &with.texture;
  e.texels = with.texture.gray.data();
  const std::array q{0.5, 0.7, 0.9};
  const auto overW = [&](const std::array<double, 3>& c) {
    return planes({c[0] / 256 * q[0], c[1] / 256 * q[1], c[2] / 256 * q[2]});
  };
  e.u = overW(*at.u), e.v = overW(*at.v), e.q = planes(q);
  return e;
}

template <class S>
void fillTriangle(IndexImage& image, const glm::ivec3* p, const S& shader) {
  if constexpr (Shader<S>)
    fillConvex(image, p, 3, shader);
  else
    forEachSpan(p, 3, image.width, image.height,
                [&](int row, int from, int to) { shader.span(image.row(row) + from, from, row, to - from); });
}

// Triangles in random order, with random values at their vertices. Expect a constant cost for the three edges
// and the planes of the values, plus a cost for each row and for each pixel.
// `store_ns_byte`: the time of a byte in the store loop. (Their ratio is not a counter. If another program
// disturbs only the store loop, the least of the ratios is too good.)
template <auto Shading>
void BM_Fill(benchmark::State& state) {
  IndexImage image{800, 600, 0};
  const std::vector<glm::ivec3> triangles = randomTriangles(static_cast<int>(state.range(0)), 4096);
  std::mt19937 rng{1972};
  std::vector<std::array<double, 3>> values(triangles.size());
  for (std::array<double, 3>& at : values)
    for (double& v : at)
      v = kLeastValue + (kLargestValue - kLeastValue) * (static_cast<double>(rng()) * 0x1p-32);
  std::int64_t pixels = 0, rows = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
    forEachSpan(&triangles[t], 3, 800, 600, [&](int, int from, int to) { pixels += to - from, ++rows; });
  double fill = 0;
  for (auto _ : state) {
    const double start = processorTime();
    for (std::size_t t = 0; t < triangles.size(); t += 3)
      fillTriangle(image, &triangles[t],
                   Shading({&triangles[t], &values[t], &values[t + 1], &values[t + 2]}));
    benchmark::ClobberMemory();
    fill += processorTime() - start;
  }
  const double count = static_cast<double>(triangles.size()) / 3;
  const double ns = 1e6 * fill / static_cast<double>(state.iterations());
  state.counters["ns_triangle"] = ns / count;
  state.counters["ns_pixel"] = ns / static_cast<double>(pixels);
  state.counters["store_ns_byte"] = storeLoop(image);
  state.counters["pixels"] = static_cast<double>(pixels) / count;
  state.counters["rows"] = static_cast<double>(rows) / count;
}
void everySide(benchmark::internal::Benchmark* fill) {
  fill->Arg(300)->Unit(benchmark::kMicrosecond);
  fill->ComputeStatistics("least", least);
}
BENCHMARK(BM_Fill<flat>)->Name("BM_FillFlat")->Apply(everySide);
BENCHMARK(BM_Fill<gouraudLinear>)->Name("BM_FillGouraudLinear")->Apply(everySide);
BENCHMARK(BM_Fill<gouraudTable>)->Name("BM_FillGouraudTable")->Apply(everySide);
BENCHMARK(BM_Fill<environmentMap>)->Name("BM_FillEnvironmentMap")->Apply(everySide);
BENCHMARK(BM_Fill<phong>)->Name("BM_FillPhong")->Apply(everySide);
BENCHMARK(BM_Fill<perspectiveTexture>)->Name("BM_FillPerspectiveTexture")->Apply(everySide);

/// ---- What an environment map and normals cost, and how far off they are.

void everyAngle(benchmark::internal::Benchmark* error) {
  for (const int degrees : {0, 15, 30, 45, 60, 120}) error->Arg(degrees)->Unit(benchmark::kMicrosecond);
}

// The environment map against the illumination equation, for a light some degrees off the view axis on a
// white surface. The map is as published or turned. All normals count that face the eye and have a place in
// the map. `rms`: root of the mean square error of the intensity. Time: making one map.
template <EnvironmentForm kForm>
void BM_EnvironmentError(benchmark::State& state) {
  const SinCos angle = sinCosDegrees(static_cast<double>(state.range(0)));
  const glm::dvec3 L{angle.sin, 0, angle.cos};
  const Lighting lighting = resolve(cube(), {}, {.Ia = 0, .Ip = 1, .kd = 1, .ks = 0, .light = L},
                                    Channels::Luminance, {0, 0, 5}, {0, 0, 0});
  Environment map;
  for (auto _ : state)
    map = makeEnvironment(kForm, lighting, lighting.materials[0], 0, glm::dmat3{1.0}, {0, 0, 0});
  double squares = 0;
  int count = 0;
  for (int k = 0; k < 1'000'000; ++k) {
    const double x = (k % 1000 + 0.5) / 500 - 1, y = (k / 1000 + 0.5) / 500 - 1, z = 1 - x * x - y * y;
    if (z < 0) continue;
    const glm::dvec3 N{x, y, std::sqrt(z)}, at = map.frame * N;
    const int column = static_cast<int>(kMapCentre + kMapScale * at.x);
    const int row = static_cast<int>(kMapCentre + kMapScale * at.y);
    const std::vector<float>& side = map.twoMaps && at.z < 0 ? map.away : map.front;
    const double error = side[256 * row + column] - std::max(0.0, glm::dot(N, L));
    squares += error * error;
    ++count;
  }
  state.counters["rms"] = std::sqrt(squares / count);
}
BENCHMARK(BM_EnvironmentError<EnvironmentForm::Published>)
    ->Name("BM_EnvironmentErrorPublished")
    ->Apply(everyAngle);
BENCHMARK(BM_EnvironmentError<EnvironmentForm::Rotated>)
    ->Name("BM_EnvironmentErrorRotated")
    ->Apply(everyAngle);

// The errors of each rule against the true normals: the sphere's, or the patches' at the same corner. For the
// teapot also without its creases.
void BM_NormalError(benchmark::State& state) {
  const NormalRow& rule = kNormalRules[state.range(1)];
  const std::vector<BezierPatch> patches = readBpt(XNEWELL_DATA_DIR "/teapot.bpt");
  const auto teapot = [&](int N) { return tessellate(patches, N); };
  const auto ball = [](const char* shape, const Mesh& m) { return std::tuple{shape, m, sphereNormals(m)}; };
  const auto smooth = [&](int N) { return withoutCreases(teapot(N), cornerNormals(patches, N)); };
  const std::array<std::tuple<std::string, Mesh, std::vector<glm::dvec3>>, 8> cases{
      ball("sphere 24 x 12", sphere(24, 12)),
      ball("sphere 48 x 24", sphere(48, 24)),
      ball("sphere 24 x 12 in triangles", triangulated(sphere(24, 12))),
      ball("sphere 48 x 24 in triangles", triangulated(sphere(48, 24))),
      std::tuple{"teapot 8", teapot(8), cornerNormals(patches, 8)},
      std::tuple{"teapot 16", teapot(16), cornerNormals(patches, 16)},
      std::tuple{"teapot 8 but its creases", teapot(8), smooth(8)},
      std::tuple{"teapot 16 but its creases", teapot(16), smooth(16)}};
  const auto& [name, mesh, truth] = cases[static_cast<std::size_t>(state.range(0))];
  NormalError error;
  for (auto _ : state) benchmark::DoNotOptimize(error = normalError(mesh, rule.id, truth));
  state.counters["mean_degrees"] = error.mean;
  state.counters["max_degrees"] = error.max;
  state.SetLabel(name + ", " + std::string{rule.name});
}
BENCHMARK(BM_NormalError)
    ->ArgsProduct({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace xnewell
