#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "geometry/bpt.h"
#include "geometry/camera.h"
#include "geometry/obj.h"
#include "geometry/project.h"
#include "geometry/solids.h"
#include "triangulated.h"

namespace {

constexpr int kWidth = 800, kHeight = 600;

std::string teapotText() {
  std::ifstream file{XNEWELL_DATA_DIR "/teapot.bpt"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// A torus of 2 * side^2 triangles. Its size is within the range that readScene makes.
Mesh triangleTorus(int side) {
  Mesh mesh = triangulated(torus(side, side));
  for (glm::dvec3& p : mesh.points) p /= 2.0;
  return mesh;
}

// The teapot's 32 patches, N x N faces each: expect N^2.
void BM_Tessellate(benchmark::State& state) {
  const std::vector<BezierPatch> patches = parseBpt(teapotText(), "teapot.bpt");
  const int N = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(tessellate(patches, N));
  state.SetItemsProcessed(state.iterations() * 32 * N * N);  // faces
}
BENCHMARK(BM_Tessellate)->RangeMultiplier(4)->Range(4, 64)->Unit(benchmark::kMicrosecond);

// 545 lines, of which all but a few are points.
void BM_ReadTeapot(benchmark::State& state) {
  const std::string text = teapotText();
  for (auto _ : state) benchmark::DoNotOptimize(parseBpt(text, "teapot.bpt"));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(BM_ReadTeapot)->Unit(benchmark::kMicrosecond);

// A torus as a modeller writes it, six decimals: expect linear, by the byte.
void BM_ReadObj(benchmark::State& state) {
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  std::ostringstream out;
  out << std::fixed;
  for (const glm::dvec3& p : mesh.points) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (int f = 0; f < mesh.faceCount(); ++f)
    out << "f " << mesh.face(f)[0] + 1 << ' ' << mesh.face(f)[1] + 1 << ' ' << mesh.face(f)[2] + 1 << '\n';
  const std::string text = out.str();
  for (auto _ : state) benchmark::DoNotOptimize(parseObj(text, "torus.obj", "."));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
  state.counters["triangles"] = mesh.faceCount();
}
BENCHMARK(BM_ReadObj)->Arg(45)->Arg(179)->Unit(benchmark::kMillisecond);  // 4k and 64k triangles

// The whole viewing transformation and the snap: expect linear; half as many points as triangles.
void BM_Project(benchmark::State& state) {
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  const Pieces pieces = divideFaces(mesh);
  const Camera camera = placeCamera({}, mesh.points, UpAxis::Z, double{kWidth} / kHeight);
  for (auto _ : state)
    benchmark::DoNotOptimize(project(mesh, pieces, camera.view, kWidth, kHeight, Cull::Keep));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());  // triangles
}
BENCHMARK(BM_Project)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// Framing a scene whole: passes over its points, expect linear and less than BM_Project.
void BM_PlaceCamera(benchmark::State& state) {
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(placeCamera({}, mesh.points, UpAxis::Z, double{kWidth} / kHeight));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.points.size()));
}
BENCHMARK(BM_PlaceCamera)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// Convex planar pieces, all of them triangles already: expect linear.
void BM_DivideFaces(benchmark::State& state) {
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(divideFaces(mesh));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());
}
BENCHMARK(BM_DivideFaces)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

}  // namespace
