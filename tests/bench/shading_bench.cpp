#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "geometry/solids.h"
#include "shading/color_difference.h"
#include "shading/png.h"
#include "shading/quantize.h"
#include "shading/shade.h"
#include "tests/colored_picture.h"
#include "triangulated.h"

namespace {

/// Points to shade: the centroids of a torus's triangles, its light and an eye.
struct ShadedTorus {
  Mesh mesh;
  ShadingPoints points;
  Lighting lighting;
  explicit ShadedTorus(int side)
      : mesh{triangulated(torus(side, side))},
        points{facePoints(mesh)},
        lighting{resolve(mesh, {}, {}, Channels::Luminance, {1, -4, 2}, {0, 0, 0})} {}
};

// Normals and centroids of all faces, once a scene: expect linear.
void BM_FacePoints(benchmark::State& state) {
  const ShadedTorus scene{static_cast<int>(state.range(0))};
  for (auto _ : state) benchmark::DoNotOptimize(facePoints(scene.mesh));
  state.SetItemsProcessed(state.iterations() * scene.mesh.faceCount());
}
BENCHMARK(BM_FacePoints)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// Diffuse terms of every face: expect linear.
void BM_ShadeDiffuse(benchmark::State& state) {
  const ShadedTorus scene{static_cast<int>(state.range(0))};
  Shades shades;
  for (auto _ : state) {
    shadeDiffuse(shades, scene.points, scene.lighting, 0);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * scene.mesh.faceCount());
}
BENCHMARK(BM_ShadeDiffuse)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// The specular term again, as whenever the eye moves: expect linear.
void BM_ShadeSpecular(benchmark::State& state) {
  const ShadedTorus scene{static_cast<int>(state.range(0))};
  Shades shades;
  shadeDiffuse(shades, scene.points, scene.lighting, 0);
  for (auto _ : state) {
    shadeSpecular(shades, scene.points, scene.lighting, 0);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * scene.mesh.faceCount());
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

// Balls of seven hues, 800x600, into the cells: with the cube linear in the pixels, with a chosen palette
// also in the different colours. The differences are CIEDE2000 over the pixels that show something, as they
// are and as means of 8x8 blocks, which is what dithering is for.
void BM_Quantize(benchmark::State& state, Quantizer quantizer, bool dither) {
  const ColoredPicture picture = coloredBalls(800, 600);
  const QuantizeSettings settings{.quantizer = quantizer, .dither = dither};
  IndexImage cells{800, 600, 0};
  std::vector<Rgb16> colors;
  for (auto _ : state)
    benchmark::DoNotOptimize(colors = quantize(picture.rgb, picture.shows, settings, cells));
  const RgbImage result = shown(cells, colors, settings.first);
  const ImageDifference difference = imageDifference(picture.rgb, result, picture.shows);
  state.counters["mean_delta_e"] = difference.mean;
  state.counters["max_delta_e"] = difference.largest;
  state.counters["mean_delta_e_of_blocks"] = imageDifference(blocksOf(picture.rgb), blocksOf(result)).mean;
  state.SetItemsProcessed(state.iterations() * difference.pixels);
}
BENCHMARK_CAPTURE(BM_Quantize, cube, Quantizer::Cube, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Quantize, cube_dithered, Quantizer::Cube, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Quantize, chosen, Quantizer::Chosen, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Quantize, chosen_dithered, Quantizer::Chosen, true)->Unit(benchmark::kMillisecond);

}  // namespace
