#include <benchmark/benchmark.h>

#include <memory>
#include <optional>
#include <random>

#include "shading/picture/picture_cache.h"
#include "shading/picture/stopwatch.h"
#include "x11/stepper/sort_page.h"

namespace xnewell {

// The steps of the depth-sort stepper as they are shown: each goes to its step of the run and draws the whole
// page, at 1024 x 768. The teapot with 5 divisions has some 110,000 steps, with 8 some 420,000. The view must
// follow a key within 16 ms, so the slowest step is reported beside the mean.

namespace {

struct Page {
  static constexpr Rect kBody{16, 48, 992, 612};

  std::optional<Picture> picture;
  CellPlan plan;
  std::unique_ptr<SortRun> run;
  SortLayout at = layoutOfSort(kBody);
  IndexImage image{1024, 768, 0};
  SortView view;

  explicit Page(int divisions) {
    PictureSettings settings;
    settings.width = at.picture.width;
    settings.height = at.picture.height;
    picture = makePicture(readScene("teapot", divisions), settings);
    run = std::make_unique<SortRun>(*picture, plan[Cell::Well]);
  }
  /// In milliseconds.
  double show(int step) {
    const Stopwatch watch;
    view.step = step;
    benchmark::DoNotOptimize(drawSortPage(image, at, *run, view, plan).rows.data());
    return watch.ms();
  }
};

template <class Next>
void showSteps(benchmark::State& state, Next&& next) {
  Page page{static_cast<int>(state.range(0))};
  double slowest = 0;
  for (auto _ : state) slowest = std::max(slowest, page.show(next(page)));
  state.counters["slowest_ms"] = slowest;
  state.counters["steps"] = page.run->steps();
}

void BM_StepForward(benchmark::State& state) {
  showSteps(state, [](const Page& page) { return (page.view.step + 1) % (page.run->steps() + 1); });
}
BENCHMARK(BM_StepForward)->Arg(5)->Arg(8)->Unit(benchmark::kMillisecond);

// From the end, where most is painted.
void BM_StepBack(benchmark::State& state) {
  showSteps(state,
            [](const Page& page) { return (page.view.step + page.run->steps()) % (page.run->steps() + 1); });
}
BENCHMARK(BM_StepBack)->Arg(5)->Arg(8)->Unit(benchmark::kMillisecond);

void BM_JumpAnywhere(benchmark::State& state) {
  std::mt19937 rng{1972};
  showSteps(state, [&](const Page& page) { return static_cast<int>(rng() % page.run->steps()); });
}
BENCHMARK(BM_JumpAnywhere)->Arg(5)->Arg(8)->Unit(benchmark::kMillisecond);

// Sorting, keeping copies of the picture, and depths: expect time linear in the number of steps.
void BM_Record(benchmark::State& state) {
  Page page{static_cast<int>(state.range(0))};
  for (auto _ : state) page.run = std::make_unique<SortRun>(*page.picture, page.plan[Cell::Well]);
  state.counters["steps"] = page.run->steps();
}
BENCHMARK(BM_Record)->Arg(3)->Arg(5)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace xnewell
