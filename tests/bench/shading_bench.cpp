#include <benchmark/benchmark.h>

#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "shading/color/color_difference.h"
#include "shading/color/quantize.h"
#include "shading/fill/environment.h"
#include "tests/support/full_color_picture.h"

namespace xnewell {

namespace {

void everyAngle(benchmark::internal::Benchmark* error) {
  for (const int degrees : {0, 15, 30, 45, 60, 120}) error->Arg(degrees);
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
    ->Apply(everyAngle)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_EnvironmentError<EnvironmentForm::Rotated>)
    ->Name("BM_EnvironmentErrorRotated")
    ->Apply(everyAngle)
    ->Unit(benchmark::kMicrosecond);

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
