#include <benchmark/benchmark.h>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "tests/bench/least.h"
#include "tests/bench/triangulated.h"

namespace xnewell {

namespace {

/// Reports the share of each stage in the frames, in percent, and the counts of the picture.
void reportShares(benchmark::State& state, const StageTimes& sum, const Picture& picture) {
  const double percent = 100.0 / sum.total();
  state.counters["%shade"] = sum.shade * percent;
  state.counters["%transform"] = sum.transform * percent;
  state.counters["%sort"] = sum.sort * percent;
  state.counters["%fill"] = sum.fill * percent;
  state.counters["triangles"] = static_cast<double>(picture.snapped().faces.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(picture.snapped().faces.size()));
}

void add(StageTimes& sum, const StageTimes& t) {
  sum.shade += t.shade;
  sum.transform += t.transform;
  sum.sort += t.sort;
  sum.fill += t.fill;
}

/// Makes frames while the eye moves by a degree, with everything that such a frame needs. Returns the sum of
/// their stages.
StageTimes moveEye(benchmark::State& state, PictureCache& pictures, PictureSettings settings) {
  Picture picture = pictures.make(settings);
  StageTimes sum;
  for (auto _ : state) {
    settings.camera = moved(settings.camera, picture.camera(), picture.scene(), 1.0, 0.0, 1.0);
    picture = pictures.make(settings, 0);
    add(sum, picture.times());
  }
  return sum;
}

void ofAFrame(benchmark::internal::Benchmark* frame) {
  frame->Unit(benchmark::kMillisecond)->ComputeStatistics("least", least);
}

// Frames of 64,800 triangles while the eye moves, by method and order: transform, shade, order, fill. What a
// method costs beyond flat shading is what it requires. The exact order costs its sort and its planes.
template <Shading kShading, Order kOrder>
void BM_Frame64k(benchmark::State& state) {
  PictureCache pictures{makeScene("torus", triangulated(torus(180, 180)), UpAxis::Z)};
  PictureSettings settings;
  settings.shading = kShading;
  settings.order = kOrder;
  const StageTimes sum = moveEye(state, pictures, settings);
  reportShares(state, sum, pictures.last());
}
BENCHMARK(BM_Frame64k<Shading::Gouraud, Order::ZSort>)->Apply(ofAFrame);
BENCHMARK(BM_Frame64k<Shading::Gouraud, Order::Newell>)->Apply(ofAFrame);
BENCHMARK(BM_Frame64k<Shading::Gouraud, Order::ZBuffer24>)->Apply(ofAFrame);
BENCHMARK(BM_Frame64k<Shading::Phong, Order::ZSort>)->Apply(ofAFrame);

/// The things that a scene may require, one after the other.
struct Requirement {
  const char* name;
  void (*add)(Scene& scene, PictureSettings& settings);
};
Light pointLight(double distance) {
  return {.kind = LightKind::Point,
          .Ip = glm::dvec3{0.3},
          .position = {0, -distance, distance},
          .attenuation = Attenuation::Linear,
          .range = 4};
}
constexpr std::array kRequirements{
    Requirement{"Nothing", [](Scene&, PictureSettings& s) { s.shading = Shading::Full; }},
    Requirement{"Diffuse", [](Scene&, PictureSettings& s) { s.light.ks = 0; }},
    Requirement{"Specular", [](Scene&, PictureSettings&) {}},
    Requirement{"LightOutOfReach",
                [](Scene& scene, PictureSettings&) {
                  scene.light.lights = {{}, pointLight(100)};
                }},
    Requirement{"TwoLights",
                [](Scene& scene, PictureSettings&) {
                  scene.light.lights = {{}, pointLight(1)};
                }},
    Requirement{"ThreeChannels", [](Scene&, PictureSettings& s) { s.colors = ColorPlan::Cube; }},
};

// A flat frame of 64,800 triangles while the eye moves, by what the scene requires. A scene that does not use
// a feature does not pay for it. `shade_ms`, `fill_ms`: times of a frame.
void BM_Required(benchmark::State& state, const Requirement& requirement) {
  Scene scene = makeScene("torus", triangulated(torus(180, 180)), UpAxis::Z);
  PictureSettings settings;
  settings.order = Order::ZSort;
  requirement.add(scene, settings);
  PictureCache pictures{std::move(scene)};
  const StageTimes sum = moveEye(state, pictures, settings);
  const auto frames = static_cast<double>(state.iterations());
  state.counters["shade_ms"] = sum.shade / frames;
  state.counters["fill_ms"] = sum.fill / frames;
}
const int kRegistered = [] {
  for (const Requirement& requirement : kRequirements)
    benchmark::RegisterBenchmark((std::string{"BM_Required"} + requirement.name).c_str(), BM_Required,
                                 requirement)
        ->Apply(ofAFrame);
  return 0;
}();

}  // namespace

}  // namespace xnewell
