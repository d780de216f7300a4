#include <benchmark/benchmark.h>

#include <string>

#include "shading/laboratory/exactness.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

// Every order on six scenes at 800x600: the time to find it, and how many samples it gets wrong.
void orders(benchmark::State& state, const std::string& name, Order order) {
  Scene scene = readScene(name);
  PictureSettings settings;
  settings.camera = scene.camera;
  PictureCache pictures{std::move(scene)};
  for (auto _ : state) {
    // so that the order is computed again
    settings.order = order == Order::Unsorted ? Order::ZSort : Order::Unsorted;
    pictures.make(settings);
    settings.order = order;
    pictures.make(settings);
    state.SetIterationTime(pictures.last().times().sort / 1000.0);
  }
  const Exactness exactness = exactnessOf(pictures.last());
  state.counters["polygons"] = static_cast<double>(pictures.last().snapped().faces.size());
  state.counters["bytes"] = static_cast<double>(pictures.last().sorted().statistics.bytes);
  state.counters["splits"] = static_cast<double>(pictures.last().sorted().statistics.splits);
  state.counters["wrong"] = exactness.wrong;
  state.counters["samples"] = exactness.samples;
}

const bool kRegistered = [] {
  for (const char* scene : {"teapot", "room", "nested-cycles", "crossing-sheets", "slivers", "tori"})
    for (const OrderRow& row : kOrders)
      benchmark::RegisterBenchmark(("Orders/" + std::string{scene} + '/' + std::string{row.name}).c_str(),
                                   orders, scene, row.id)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace

}  // namespace xnewell
