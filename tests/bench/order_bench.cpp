#include <benchmark/benchmark.h>

#include <string>

#include "shading/picture/picture.h"

namespace xnewell {

namespace {

// Every order on six scenes at 800x600: the time to find it, and how many samples it gets wrong.
void orders(benchmark::State& state, const std::string& name, Order order) {
  Scene scene = readScene(name);
  PictureSettings settings;
  settings.camera = inSceneUnits(scene.camera, scene);
  Picture picture{std::move(scene)};
  for (auto _ : state) {
    // so that the order is computed again
    settings.order = order == Order::Unsorted ? Order::ZSort : Order::Unsorted;
    picture.make(settings);
    settings.order = order;
    picture.make(settings);
    state.SetIterationTime(picture.times().sort / 1000.0);
  }
  const Picture::Exactness exactness = picture.exactness();
  state.counters["polygons"] = static_cast<double>(picture.snapped().faces.size());
  state.counters["splits"] = static_cast<double>(picture.sorted().statistics.splits);
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
