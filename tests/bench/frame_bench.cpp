#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <string>
#include <vector>

#include "geometry/exact/plane.h"
#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "shading/laboratory/errors.h"
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

const bool kOrdersRegistered = [] {
  for (const char* scene : {"teapot", "room", "nested-cycles", "crossing-sheets", "slivers", "tori"})
    for (const OrderRow& row : kOrders)
      benchmark::RegisterBenchmark(("Orders/" + std::string{scene} + '/' + std::string{row.name}).c_str(),
                                   orders, scene, row.id)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
  return true;
}();

/// The speed-ups that tutorials on flat shading name, on an object that turns before a fixed light. Each
/// computes the colour of each face, max_col cos x, for 64,800 triangles a frame. `max_error` is the largest
/// difference from the plain way in double precision, in shades of 240, after a full turn in steps of one
/// degree.

constexpr float kMaxColor = 239;
constexpr int kSteps = 360;

using Points = std::vector<glm::vec3>;

glm::mat3 turnedBy(int degrees) {
  const SinCos a = sinCosDegrees(degrees);
  const auto s = static_cast<float>(a.sin), c = static_cast<float>(a.cos);
  return glm::mat3{c, s, 0, -s, c, 0, 0, 0, 1};
}

struct Object {
  Mesh mesh = triangulated(torus(180, 180));
  Points points;                        ///< three for each face
  Points normals;                       ///< one for each face, not normalised
  glm::vec3 light{-0.9f, -1.1f, 0.9f};  ///< not of unit length
  Object() {
    for (int f = 0; f < mesh.faceCount(); ++f) {
      for (const int c : mesh.face(f)) points.emplace_back(mesh.points[c]);
      normals.emplace_back(newellVector(mesh.points, mesh.face(f)));
    }
  }
};
const Object& object() {
  static const Object made;
  return made;
}

/// A way to colour all faces has two parts: one runs once, the other for each frame at its angle in degrees.
void nothing(const Object&, Points&) {}

/// Turns the vertices, computes each face's normal, and finds its angle with two square roots and a division.
void plain(const Object& o, Points&, int degrees, std::vector<float>& colors) {
  const glm::mat3 turn = turnedBy(degrees);
  for (std::size_t f = 0; f < colors.size(); ++f) {
    const glm::vec3 a = turn * o.points[3 * f], b = turn * o.points[3 * f + 1],
                    c = turn * o.points[3 * f + 2];
    const glm::vec3 N = glm::cross(b - a, c - a);
    const float cosine =
        glm::dot(N, o.light) / (std::sqrt(glm::dot(N, N)) * std::sqrt(glm::dot(o.light, o.light)));
    colors[f] = kMaxColor * std::max(0.0f, cosine);
  }
}

void unitNormals(const Object& o, Points& N) {
  for (const glm::vec3& n : o.normals) N.push_back(glm::normalize(n));
}
/// Turns unit normals, made once, with the object.
void turnedNormals(const Object& o, Points& N, int degrees, std::vector<float>& colors) {
  const glm::mat3 turn = turnedBy(degrees);
  const glm::vec3 L = glm::normalize(o.light);
  for (std::size_t f = 0; f < colors.size(); ++f)
    colors[f] = kMaxColor * std::max(0.0f, glm::dot(turn * N[f], L));
}

void scaledNormals(const Object& o, Points& N) {
  for (const glm::vec3& n : o.normals) N.push_back(kMaxColor * glm::normalize(n));
}
/// Turns the light back instead. This is not in the tutorials.
void turnedLight(const Object& o, Points& N, int degrees, std::vector<float>& colors) {
  const glm::vec3 L = glm::transpose(turnedBy(degrees)) * glm::normalize(o.light);
  for (std::size_t f = 0; f < colors.size(); ++f) colors[f] = std::max(0.0f, glm::dot(N[f], L));
}

double largestError(const Object& o, const std::vector<float>& colors, int degrees) {
  const SinCos a = sinCosDegrees(degrees);
  const glm::dmat3 turn{a.cos, a.sin, 0, -a.sin, a.cos, 0, 0, 0, 1};
  const glm::dvec3 L = glm::normalize(glm::dvec3{o.light});
  double largest = 0;
  for (std::size_t f = 0; f < colors.size(); ++f) {
    const glm::dvec3 N = turn * newellVector(o.mesh.points, o.mesh.face(static_cast<int>(f)));
    const double color = kMaxColor * std::max(0.0, glm::dot(glm::normalize(N), L));
    largest = std::max(largest, std::abs(colors[f] - color));
  }
  return largest;
}

template <auto kPrepare, auto kFrame>
void BM_Speedup(benchmark::State& state) {
  const Object& o = object();
  Points kept;
  kPrepare(o, kept);
  std::vector<float> colors(o.normals.size());
  for (int degrees = 0; degrees <= kSteps; ++degrees) kFrame(o, kept, degrees, colors);
  state.counters["max_error"] = largestError(o, colors, kSteps);
  for (auto _ : state) {
    kFrame(o, kept, 1, colors);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(colors.size()));
}
BENCHMARK(BM_Speedup<nothing, plain>)->Name("BM_SpeedupPlain")->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Speedup<unitNormals, turnedNormals>)
    ->Name("BM_SpeedupTurnedNormals")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Speedup<scaledNormals, turnedLight>)
    ->Name("BM_SpeedupTurnedLight")
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace xnewell
