#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/files/bpt.h"
#include "geometry/model/solids.h"
#include "geometry/model/vertex_normals.h"
#include "tests/bench/triangulated.h"
#include "tests/support/normal_error.h"

namespace xnewell {

namespace {

std::string teapotText() {
  std::ifstream file{XNEWELL_DATA_DIR "/teapot.bpt"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

// The errors of each rule against the true normals: the sphere's, or the patches' at the same corner. For the
// teapot also without its creases.
void BM_NormalError(benchmark::State& state) {
  const NormalRow& rule = kNormalRules[state.range(1)];
  const std::vector<BezierPatch> patches = parseBpt(teapotText(), "teapot.bpt");
  const auto teapot = [&](int N) { return tessellate(patches, N); };
  const auto& [name, mesh, truth] = [&]() -> std::tuple<std::string, Mesh, std::vector<glm::dvec3>> {
    const auto ball = [](const char* shape, const Mesh& m) { return std::tuple{shape, m, sphereNormals(m)}; };
    const auto smooth = [&](int N) { return withoutCreases(teapot(N), cornerNormals(patches, N)); };
    switch (state.range(0)) {
      case 0:
        return ball("sphere 24 x 12", sphere(24, 12));
      case 1:
        return ball("sphere 48 x 24", sphere(48, 24));
      case 2:
        return ball("sphere 24 x 12 in triangles", triangulated(sphere(24, 12)));
      case 3:
        return ball("sphere 48 x 24 in triangles", triangulated(sphere(48, 24)));
      case 4:
        return {"teapot 8", teapot(8), cornerNormals(patches, 8)};
      case 5:
        return {"teapot 16", teapot(16), cornerNormals(patches, 16)};
      case 6:
        return {"teapot 8 but its creases", teapot(8), smooth(8)};
      default:
        return {"teapot 16 but its creases", teapot(16), smooth(16)};
    }
  }();
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
