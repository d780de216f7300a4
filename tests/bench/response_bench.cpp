#include <benchmark/benchmark.h>
#include <stdlib.h>

#include <string>

#include "tests/x11/support/x_server.h"

#include "x11/app/server.h"

namespace xnewell {

// The time from a key to the picture on the server, ending in a round trip. The picture is the teapot of
// 7,300 polygons with exact order and Gouraud shading, 656 x 560. `turn` makes everything again; `hue` only
// stores colours, if there is a colormap to store them in; `explain` goes through the pixels of view 8;
// `number` changes where the eye is in view 9.

namespace {

struct Window {
  explicit Window(int depth, int divisions = 13) : server{XServer::xvfb(depth, 1280, 1024)} {
    ::setenv("DISPLAY", server.name().c_str(), 1);
    Options options;
    options.picture.shading = Shading::Gouraud;
    options.picture.order = Order::Newell;
    Scene scene = readScene("teapot", divisions);
    ours.emplace(options, scene);
    canvas.emplace(ours->display.get(), ours->colormap, Canvas::Settings{.width = 1024, .height = 768});
    bench.emplace(std::move(scene), ours->setupOf(options), ours->forBench());
    bench->resize(1024, 768);
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

/// Another number in view 9, there and back, so that the scene stays in view.
void number(benchmark::State& state) {
  Window window{static_cast<int>(state.range(0)), 8};
  press(*window.bench, '9');
  press(*window.bench, 'p');
  window.shown();
  int k = 0;
  for (auto _ : state) {
    window.bench->press({k++ / 20 % 2 == 0 ? NamedKey::Right : NamedKey::Left});
    window.shown();
  }
  state.SetLabel(window.bench->bench().status());
}

BENCHMARK(turn)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(hue)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(explain)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(number)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace xnewell

BENCHMARK_MAIN();
