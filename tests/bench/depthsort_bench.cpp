#include <benchmark/benchmark.h>

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "depthsort/bsp_tree.h"
#include "depthsort/depth_sort.h"
#include "geometry/files/bpt.h"
#include "geometry/model/solids.h"
#include "geometry/view/camera.h"
#include "tests/bench/least.h"
#include "tests/bench/triangulated.h"
#include "tests/support/triangle_soup.h"

/// The bytes in use, and the most since `most` was set. All allocations are counted here.
static std::size_t inUse = 0, most = 0;
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const p = std::malloc(size);
  if (!p) throw std::bad_alloc{};
  most = std::max(most, inUse += malloc_usable_size(p));
  return p;
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  inUse -= malloc_usable_size(p);
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

namespace xnewell {

namespace {

constexpr int kWidth = 800, kHeight = 600;

SnappedScene seen(Mesh mesh) {
  for (glm::dvec3& p : mesh.points) p /= 2.0;
  const Camera camera = placeCamera({}, mesh.points, UpAxis::Z, double{kWidth} / kHeight);
  return project(mesh, divideFaces(mesh), camera.view, kWidth, kHeight, Cull::Keep);
}

int sideOf(int count) { return static_cast<int>(std::lround(std::sqrt(count / 2.0))); }
/// The edge of the cube that each of `count` triangles has to itself in the cube of edge 2.
double spacing(int count) { return 2.0 / std::cbrt(count); }

Mesh triangleTorus(int count) { return triangulated(torus(sideOf(count), sideOf(count))); }
/// Triangles. If their size is half the room that each has to itself, they cross here and there; if it is all
/// of it, everywhere.
Mesh soup(int count) { return triangleSoup(count, spacing(count) / 2.0, 1972); }
Mesh denseSoup(int count) { return triangleSoup(count, spacing(count), 1972); }
Mesh largeTriangles(int count) { return triangleSoup(count, 1.0, 1972); }

Mesh teapot(int count) {
  return triangulated(tessellate(readBpt(XNEWELL_DATA_DIR "/teapot.bpt"),
                                 static_cast<int>(std::lround(std::sqrt(count / 64.0)))));
}

/// For comparison: std::sort of the same polygons by farthest z.
double sortByZ(const SnappedScene& scene) {
  std::vector<int> far(scene.faces.size()), order(scene.faces.size());
  std::ranges::transform(scene.faces, far.begin(), [&](const SnappedFace& f) {
    int z = scene.vertices[f.first].z;
    for (int k = 1; k < f.count; ++k) z = std::min(z, scene.vertices[f.first + k].z);
    return z;
  });
  std::iota(order.begin(), order.end(), 0);
  const auto start = std::chrono::steady_clock::now();
  std::sort(order.begin(), order.end(), [&](int a, int b) { return far[a] < far[b]; });
  benchmark::DoNotOptimize(order.data());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Expect about n log n, and no split where nothing crosses.
void BM_DepthSort(benchmark::State& state, Mesh (*make)(int), SortSettings settings) {
  const SnappedScene scene = seen(make(static_cast<int>(state.range(0))));
  SortedScene sorted;
  double byZ = 0.0;
  const std::size_t before = most = inUse;
  for (auto _ : state) {
    sorted = depthSort(scene, settings);
    state.PauseTiming();
    byZ += sortByZ(scene);
    state.ResumeTiming();
  }
  const SortStatistics& s = sorted.statistics;
  const auto polygons = static_cast<double>(scene.faces.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.faces.size()));
  state.counters["bytes"] = static_cast<double>(most - before) / polygons;
  state.counters["sort_ms"] = 1000.0 * byZ / static_cast<double>(state.iterations());
  state.counters["polygons"] = polygons;
  state.counters["painted"] = static_cast<double>(sorted.fragments.size());
  state.counters["pairs"] = static_cast<double>(s.pairs()) / polygons;
  state.counters["splits"] = static_cast<double>(s.splits);
  state.counters["cycles"] = static_cast<double>(s.cycles);
  state.counters["crossings"] = static_cast<double>(s.settled[static_cast<int>(Test::Overlap)]);
  state.SetComplexityN(static_cast<std::int64_t>(polygons));
}

constexpr SortSettings kQuick{kWidth, kHeight};
#define SCENE(name, most)                             \
  BENCHMARK_CAPTURE(BM_DepthSort, name, name, kQuick) \
      ->RangeMultiplier(10)                           \
      ->Range(1000, most)                             \
      ->Unit(benchmark::kMillisecond)
SCENE(triangleTorus, 1000000);
SCENE(soup, 1000000);
SCENE(denseSoup, 1000000);
SCENE(largeTriangles, 1000);

/// The same scenes as BSP trees. The time is that of building a tree; `walk_ms` is that of walking it, which
/// is what a tree of the world would cost in each view. `newell_ms` is the depth sort of the same scene, in
/// turns with the tree. All are the least of the run, in processor time.
void BM_BspTree(benchmark::State& state, Mesh (*make)(int)) {
  const SnappedScene scene = seen(make(static_cast<int>(state.range(0))));
  double built = std::numeric_limits<double>::infinity(), walked = built, sorted = built;
  SortStatistics statistics;
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::size_t before = most = inUse;
    double start = processorTime();
    BspTree tree = bspTree(scene, kQuick);
    built = std::min(built, processorTime() - start);
    bytes = most - before;
    start = processorTime();
    const SortedScene order = backToFront(std::move(tree));
    walked = std::min(walked, processorTime() - start);
    statistics = order.statistics;
    state.PauseTiming();
    start = processorTime();
    benchmark::DoNotOptimize(depthSort(scene, kQuick));
    sorted = std::min(sorted, processorTime() - start);
    state.ResumeTiming();
  }
  const auto polygons = static_cast<double>(scene.faces.size());
  state.counters["build_ms"] = built;
  state.counters["walk_ms"] = walked;
  state.counters["newell_ms"] = sorted;
  state.counters["splits"] = static_cast<double>(statistics.splits);
  state.counters["nodes"] = static_cast<double>(statistics.nodes);
  state.counters["depth"] = statistics.deepest;
  state.counters["bytes"] = static_cast<double>(bytes) / polygons;
  state.counters["polygons"] = polygons;
}
BENCHMARK_CAPTURE(BM_BspTree, teapot, teapot)->Arg(10000)->Unit(benchmark::kMillisecond);

/// The quick run with events against the same without, in turns, so that a machine that slows down slows
/// both. Expect at most 1.1 times the time, and some pairs a polygon of 12 bytes each.
void BM_Record(benchmark::State& state, Mesh (*make)(int)) {
  const SnappedScene scene = seen(make(static_cast<int>(state.range(0))));
  SortSettings recording = kQuick;
  recording.record = true;
  double plain = std::numeric_limits<double>::infinity(), recorded = plain;
  SortedScene sorted;
  for (auto _ : state) {
    state.PauseTiming();
    double start = processorTime();
    sorted = depthSort(scene, kQuick);
    plain = std::min(plain, processorTime() - start);
    sorted = {};
    state.ResumeTiming();
    start = processorTime();
    sorted = depthSort(scene, recording);
    recorded = std::min(recorded, processorTime() - start);
  }
  const auto polygons = static_cast<double>(scene.faces.size());
  const std::size_t bytes = sorted.events.size() * sizeof(Event) + sorted.list.size() * sizeof(int);
  state.counters["plain_ms"] = plain;
  state.counters["recorded_ms"] = recorded;
  state.counters["ratio"] = recorded / plain;
  state.counters["events"] = static_cast<double>(sorted.events.size()) / polygons;
  state.counters["bytes_polygon"] = static_cast<double>(bytes) / polygons;
}
#define RECORD(name) \
  BENCHMARK_CAPTURE(BM_Record, name, name)->Arg(100000)->Unit(benchmark::kMillisecond)->MinTime(3)
RECORD(triangleTorus);
RECORD(soup);

}  // namespace

}  // namespace xnewell
