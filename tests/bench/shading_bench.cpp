#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "shading/color/color_difference.h"
#include "shading/color/png.h"
#include "shading/color/quantize.h"
#include "shading/fill/environment.h"
#include "shading/fill/intensities.h"
#include "tests/bench/triangulated.h"
#include "tests/support/full_color_picture.h"
#include "tests/support/image_difference.h"

namespace xnewell {

namespace {

/// Points to shade: the centroids of a torus's triangles, with a light and an eye.
struct ShadedTorus {
  Mesh mesh;
  ShadingPoints points;
  Lighting lighting;
  explicit ShadedTorus(int side)
      : mesh{triangulated(torus(side, side))},
        points{facePoints(mesh)},
        lighting{resolve(mesh, {}, {}, Channels::Luminance, {1, -4, 2}, {0, 0, 0})} {}
};

// The normals and centroids of all faces, once for each scene: expect linear time.
void BM_FacePoints(benchmark::State& state) {
  const ShadedTorus scene{static_cast<int>(state.range(0))};
  for (auto _ : state) benchmark::DoNotOptimize(facePoints(scene.mesh));
  state.SetItemsProcessed(state.iterations() * scene.mesh.faceCount());
}
BENCHMARK(BM_FacePoints)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// The diffuse terms of every face: expect linear time.
void BM_ShadeDiffuse(benchmark::State& state) {
  const ShadedTorus scene{static_cast<int>(state.range(0))};
  Terms diffuse;
  for (auto _ : state) {
    diffuseIntensities(diffuse, scene.points, scene.lighting, 0);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * scene.mesh.faceCount());
}
BENCHMARK(BM_ShadeDiffuse)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// The specular term again, as after each move of the eye: expect linear time.
void BM_ShadeSpecular(benchmark::State& state) {
  const ShadedTorus scene{static_cast<int>(state.range(0))};
  Terms specular;
  for (auto _ : state) {
    specularIntensities(specular, scene.points, scene.lighting, 0);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * scene.mesh.faceCount());
}
BENCHMARK(BM_ShadeSpecular)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

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
    ->Arg(0)
    ->Arg(15)
    ->Arg(30)
    ->Arg(45)
    ->Arg(60)
    ->Arg(120)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_EnvironmentError<EnvironmentForm::Rotated>)
    ->Name("BM_EnvironmentErrorRotated")
    ->Arg(0)
    ->Arg(15)
    ->Arg(30)
    ->Arg(45)
    ->Arg(60)
    ->Arg(120)
    ->Unit(benchmark::kMicrosecond);

// Writes an 800x600 palette picture to a file: `range` random cells in runs of 16 pixels. Deflate is the
// cost.
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

// Balls of seven hues, 800x600, quantized into the cells. With the cube the time is linear in the pixels;
// with a chosen palette it also depends on the different colours. The differences are CIEDE2000 over the
// pixels that show something: pixel by pixel, and as means of 8x8 blocks, which is what dithering is for.
void BM_Quantize(benchmark::State& state, Quantizer quantizer, bool dither) {
  const FullColorPicture picture = coloredBalls(800, 600);
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

}  // namespace xnewell
