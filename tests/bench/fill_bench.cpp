#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <vector>

#include "shading/fill.h"

namespace {

/// Triangles of equal sides, `side` pixels, anywhere within 800x600 and turned any way.
std::vector<glm::ivec3> randomTriangles(int side, int count) {
  std::mt19937 rng{1972};
  const double radius = side / std::sqrt(3.0);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(rng()) * 0x1p-32);
  };
  std::vector<glm::ivec3> p;
  for (int t = 0; t < count; ++t) {
    const double x = uniform(radius, 800 - radius), y = uniform(radius, 600 - radius), a = uniform(0, 6.2832);
    for (int k = 0; k < 3; ++k)  // counter-clockwise as seen: y runs down
      p.push_back({std::lrint((x + radius * std::cos(a + k * 2.0944)) * kGrid),
                   std::lrint((y - radius * std::sin(a + k * 2.0944)) * kGrid), 0});
  }
  return p;
}

/// Nanoseconds of the processor, not of the wall: machines are shared.
double processorTime() { return 1e9 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Nanoseconds a byte of an explicit loop of stores over the image, the best of ten: the floor of filling.
double storeLoop(IndexImage& image) {
  constexpr int kPasses = 40;
  double best = 1e30;
  for (int batch = 0; batch < 10; ++batch) {
    const double start = processorTime();
    for (int pass = 0; pass < kPasses; ++pass) {
      std::uint8_t* const at = image.pixels.data();
      for (std::size_t k = 0; k + 16 <= image.pixels.size(); k += 16) {
        for (std::size_t i = 0; i < 16; ++i) at[k + i] = static_cast<std::uint8_t>(pass);
        benchmark::ClobberMemory();
      }
    }
    best = std::min(best, processorTime() - start);
  }
  return best / kPasses / static_cast<double>(image.pixels.size());
}

// Flat triangles in random order. Expect a constant for the three edges, one share a row, one a pixel.
// `store_ratio`: the time a pixel over that of a byte in the store loop beside it.
void BM_FillFlat(benchmark::State& state) {
  IndexImage image{800, 600, 0};
  const std::vector<glm::ivec3> triangles = randomTriangles(static_cast<int>(state.range(0)), 4096);
  std::int64_t pixels = 0, rows = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
    forEachSpan(&triangles[t], 3, 800, 600, [&](int, int from, int to) { pixels += to - from, ++rows; });
  double store = storeLoop(image), fill = 0;
  for (auto _ : state) {
    const double start = processorTime();
    for (std::size_t t = 0; t < triangles.size(); t += 3)
      fillConvex(image, &triangles[t], 3, FlatCell{static_cast<std::uint8_t>(t)});
    benchmark::ClobberMemory();
    fill += processorTime() - start;
  }
  store = std::min(store, storeLoop(image));
  const double count = static_cast<double>(triangles.size()) / 3;
  const double ns = fill / static_cast<double>(state.iterations());
  state.counters["ns_triangle"] = ns / count;
  state.counters["ns_pixel"] = ns / static_cast<double>(pixels);
  state.counters["store_ns_byte"] = store;
  state.counters["store_ratio"] = ns / static_cast<double>(pixels) / store;
  state.counters["pixels"] = static_cast<double>(pixels) / count;
  state.counters["rows"] = static_cast<double>(rows) / count;
}
BENCHMARK(BM_FillFlat)->Arg(4)->Arg(10)->Arg(30)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);

}  // namespace
