#include <benchmark/benchmark.h>
#include <stdlib.h>

#include <algorithm>
#include <string>
#include <utility>

#include "tests/x11/support/x_server.h"

#include "x11/app/server.h"

namespace xnewell {

// The time from a key to the picture on the server, ending in a round trip. The picture is the teapot of
// 7,300 polygons with exact order and Gouraud shading, 656 x 560. `turn` makes everything again; `hue` only
// stores colours, if there is a colormap to store them in; `hover` draws the window again with the same
// picture; `step` goes through the depth sort, and `explain` through the pixels of view 8. The last three are
// of view 9: `number` changes where the eye is, `outside` turns the view from outside, and `stage` goes from
// stage to stage.

namespace {

struct Window {
  explicit Window(int depth, int width = 1024, int height = 768, int divisions = 13)
      : server{XServer::xvfb(depth, std::max(width, 1280), std::max(height, 1024))} {
    ::setenv("DISPLAY", server.name().c_str(), 1);
    Options options;
    options.picture.shading = Shading::Gouraud;
    options.picture.order = Order::Newell;
    Scene scene = readScene("teapot", divisions);
    ours.emplace(options, scene);
    canvas.emplace(ours->display.get(), ours->colormap, Canvas::Settings{.width = width, .height = height});
    bench.emplace(std::move(scene), ours->setupOf(options), ours->forBench());
    bench->resize(width, height);
    canvas->map();
    shown();
  }
  void shown() {
    bringUpToDate(*ours, *canvas, *bench, [this] { bench->update(); });
    XSync(ours->display.get(), 0);
  }

  XServer server;
  std::optional<Server> ours;
  std::optional<Canvas> canvas;
  std::optional<Workbench> bench;
};

void press(Workbench& bench, char letter) { bench.press({NamedKey::Letter, letter}); }

void turn(benchmark::State& state) {
  Window window{static_cast<int>(state.range(0))};
  press(*window.bench, 't');
  window.shown();
  for (auto _ : state) {
    window.bench->press({NamedKey::Right});
    window.shown();
  }
  const auto& faces = window.bench->picture().snapped().faces;
  state.SetLabel(std::to_string(faces.size()) + " polygons, " +
                 std::to_string(window.bench->picture().sorted().statistics.splits) + " cuts");
}

void hue(benchmark::State& state) {
  Window window{static_cast<int>(state.range(0))};
  for (auto _ : state) {
    press(*window.bench, 'H');
    window.shown();
  }
}

void hover(benchmark::State& state) {
  Window window{static_cast<int>(state.range(0))};
  const Rect& at = window.bench->layout().controls;
  int y = 0;
  for (auto _ : state) {
    window.bench->hover(at.x + 100, at.y + 220 + (y += 21) % 420);
    window.shown();
  }
}

/// A step of the depth sort forward, in its view.
void step(benchmark::State& state) {
  Window window{static_cast<int>(state.range(0))};
  press(*window.bench, '2');
  window.shown();
  for (auto _ : state) {
    window.bench->press({NamedKey::Right});
    window.shown();
  }
}

/// Another pixel in view 8, and so another explanation: the time from a press in the picture to its page.
void explain(benchmark::State& state) {
  Window window{static_cast<int>(state.range(0))};
  press(*window.bench, '8');
  window.shown();
  const Rect at = window.bench->bench().picture(window.bench->layout());
  int k = 0;
  for (auto _ : state) {
    k = (k + 37) % 1000;
    (void)window.bench->grab(at.x + at.width * (300 + k % 400) / 1000,
                             at.y + at.height * (300 + k % 7 * 50) / 1000);
    window.bench->settle();
    window.shown();
  }
  state.SetLabel(window.bench->bench().status());
}

/// View 9 in a window of this size, with the teapot as the program opens it.
struct ViewingWindow : Window {
  explicit ViewingWindow(const benchmark::State& state)
      : Window{static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
               static_cast<int>(state.range(2)), 8} {
    press(*bench, '9');
    shown();
  }
  /// Presses one of two keys by turns, so that the scene stays in view.
  void measure(benchmark::State& state, NamedKey there, NamedKey back, int times) {
    int k = 0;
    for (auto _ : state) {
      bench->press({k++ / times % 2 == 0 ? there : back});
      shown();
    }
    state.SetLabel(bench->bench().status());
  }
};

void number(benchmark::State& state) {
  ViewingWindow window{state};
  press(*window.bench, 'p');
  window.measure(state, NamedKey::Right, NamedKey::Left, 20);
}

void outside(benchmark::State& state) {
  ViewingWindow window{state};
  press(*window.bench, 't');
  window.measure(state, NamedKey::Right, NamedKey::Left, 20);
}

void stage(benchmark::State& state) {
  ViewingWindow window{state};
  window.measure(state, NamedKey::Right, NamedKey::Left, 6);
}

BENCHMARK(turn)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(hue)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(hover)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(step)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(explain)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
void inSizes(benchmark::internal::Benchmark* b) {
  for (const int depth : {8, 24})
    for (const auto& [width, height] : {std::pair{1024, 768}, {1920, 1080}}) b->Args({depth, width, height});
  b->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(number)->Apply(inSizes);
BENCHMARK(outside)->Apply(inSizes);
BENCHMARK(stage)->Apply(inSizes);

}  // namespace

}  // namespace xnewell

BENCHMARK_MAIN();
