#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "geometry/solids.h"
#include "shading/illumination.h"
#include "shading/png.h"
#include "triangulated.h"

namespace {

// Normal, N.L, ambient and diffuse of every face: expect linear.
void BM_ShadeFaces(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const Mesh mesh = triangulated(torus(side, side));
  for (auto _ : state) benchmark::DoNotOptimize(shadeFaces(mesh, {}));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());
}
BENCHMARK(BM_ShadeFaces)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// The specular term again, as whenever the eye moves: expect linear.
void BM_ShadeSpecular(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const Mesh mesh = triangulated(torus(side, side));
  std::vector<FaceShade> faces = shadeFaces(mesh, {});
  for (auto _ : state) {
    shadeSpecular(faces, {}, {1, -4, 2}, {0, 0, 0});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());
}
BENCHMARK(BM_ShadeSpecular)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// An 800x600 palette picture of `range` random cells in runs of 16 pixels, to a file: deflate is the cost.
void BM_WritePng(benchmark::State& state) {
  IndexImage image{800, 600, 0};
  std::mt19937 rng{1972};
  for (std::size_t k = 0; k < image.pixels.size(); k += 16)
    std::fill_n(image.pixels.begin() + std::ptrdiff_t(k), 16,
                static_cast<std::uint8_t>(rng() % static_cast<unsigned>(state.range(0))));
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "xnewell_bench.png";
  for (auto _ : state) writePng(file.string(), image, Palette{});
  state.counters["file_bytes"] = static_cast<double>(std::filesystem::file_size(file));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(image.pixels.size()));
  std::filesystem::remove(file);
}
BENCHMARK(BM_WritePng)->Arg(1)->Arg(240)->Unit(benchmark::kMillisecond);

}  // namespace
