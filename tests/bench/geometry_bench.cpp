#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/files/bpt.h"
#include "geometry/files/obj.h"
#include "geometry/model/coplanar.h"
#include "geometry/model/solids.h"
#include "geometry/model/vertex_normals.h"
#include "geometry/view/camera.h"
#include "geometry/view/project.h"
#include "tests/bench/triangulated.h"
#include "tests/support/normal_error.h"
#include "tests/support/triangle_soup.h"

namespace xnewell {

namespace {

constexpr int kWidth = 800, kHeight = 600;

std::string teapotText() {
  std::ifstream file{XNEWELL_DATA_DIR "/teapot.bpt"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// A torus of 2 * side^2 triangles. Its size is in the range that readScene produces.
Mesh triangleTorus(int side) {
  Mesh mesh = triangulated(torus(side, side));
  for (glm::dvec3& p : mesh.points) p /= 2.0;
  return mesh;
}

// The teapot's 32 patches with N x N faces each: expect N^2.
void BM_Tessellate(benchmark::State& state) {
  const std::vector<BezierPatch> patches = parseBpt(teapotText(), "teapot.bpt");
  const int N = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(tessellate(patches, N));
  state.SetItemsProcessed(state.iterations() * 32 * N * N);  // faces
}
BENCHMARK(BM_Tessellate)->RangeMultiplier(4)->Range(4, 64)->Unit(benchmark::kMicrosecond);

// 545 lines, nearly all of them points.
void BM_ReadTeapot(benchmark::State& state) {
  const std::string text = teapotText();
  for (auto _ : state) benchmark::DoNotOptimize(parseBpt(text, "teapot.bpt"));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(BM_ReadTeapot)->Unit(benchmark::kMicrosecond);

// A torus as a modeller writes it, with six decimals: expect time linear in the bytes.
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

// The whole viewing transformation and the snap: expect linear time. There are half as many points as
// triangles.
void BM_Project(benchmark::State& state) {
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  const ConvexParts parts = divideFaces(mesh);
  const Camera camera = placeCamera({}, mesh.points, UpAxis::Z, double{kWidth} / kHeight);
  for (auto _ : state)
    benchmark::DoNotOptimize(project(mesh, parts, camera.view, kWidth, kHeight, Cull::Keep));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());  // triangles
}
BENCHMARK(BM_Project)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// Framing a whole scene takes passes over its points: expect linear time, less than BM_Project.
void BM_PlaceCamera(benchmark::State& state) {
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(placeCamera({}, mesh.points, UpAxis::Z, double{kWidth} / kHeight));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.points.size()));
}
BENCHMARK(BM_PlaceCamera)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// All faces are triangles already, so each is one convex part: expect linear time.
void BM_DivideFaces(benchmark::State& state) {
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(divideFaces(mesh));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());
}
BENCHMARK(BM_DivideFaces)->Arg(14)->Arg(56)->Arg(224)->Unit(benchmark::kMicrosecond);

// The exact normals of the teapot's patches at the corners of N x N faces each: expect N^2.
void BM_CornerNormals(benchmark::State& state) {
  const std::vector<BezierPatch> patches = parseBpt(teapotText(), "teapot.bpt");
  const int N = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(cornerNormals(patches, N));
  state.SetItemsProcessed(state.iterations() * 32 * N * N);  // faces
}
BENCHMARK(BM_CornerNormals)->RangeMultiplier(4)->Range(4, 64)->Unit(benchmark::kMicrosecond);

// Normals at the corners of a mesh of triangles, by rule: expect linear time.
void BM_VertexNormals(benchmark::State& state) {
  const NormalRow& rule = kNormalRules[state.range(0)];
  const Mesh mesh = triangleTorus(static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(smoothVertices(mesh, rule.id));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());  // triangles
  state.SetLabel(std::string{rule.name});
}
BENCHMARK(BM_VertexNormals)->ArgsProduct({{0, 1, 2, 3}, {45, 179}})->Unit(benchmark::kMicrosecond);

// With a crease that no edge reaches, and with one that every edge exceeds.
void BM_VertexNormalsCrease(benchmark::State& state) {
  const Mesh mesh = triangleTorus(179);
  const auto crease = static_cast<double>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(smoothVertices(mesh, NormalRule::Sum, crease));
  state.SetItemsProcessed(state.iterations() * mesh.faceCount());
}
BENCHMARK(BM_VertexNormalsCrease)->Arg(60)->Arg(0)->Unit(benchmark::kMicrosecond);

// All triangles meet at one point, and no two normals are equal: expect n log n.
void BM_VertexNormalsCone(benchmark::State& state) {
  Mesh cone = sphere(static_cast<int>(state.range(0)), 2);
  for (auto _ : state) benchmark::DoNotOptimize(smoothVertices(cone, NormalRule::Distinct));
  state.SetItemsProcessed(state.iterations() * cone.faceCount());
}
BENCHMARK(BM_VertexNormalsCone)->Arg(1000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

// The errors of each rule against the true normals: the sphere's, or the patches' at the same corner. For the
// teapot also without its creases.
void BM_NormalError(benchmark::State& state) {
  const NormalRow& rule = kNormalRules[state.range(1)];
  const std::vector<BezierPatch> patches = parseBpt(teapotText(), "teapot.bpt");
  const auto teapot = [&](int N) { return tessellate(patches, N); };
  const auto& [name, mesh, truth] = [&]() -> std::tuple<std::string, Mesh, std::vector<glm::dvec3>> {
    const auto ball = [](const char* shape, const Mesh& m) { return std::tuple{shape, m, sphereNormals(m)}; };
    const auto smooth = [&](int N) { return withoutCreases(teapot(N), cornerNormals(patches, N)); };
    switch (state.range(0)) {
      case 0:
        return ball("sphere 24 x 12", sphere(24, 12));
      case 1:
        return ball("sphere 48 x 24", sphere(48, 24));
      case 2:
        return ball("sphere 24 x 12 in triangles", triangulated(sphere(24, 12)));
      case 3:
        return ball("sphere 48 x 24 in triangles", triangulated(sphere(48, 24)));
      case 4:
        return {"teapot 8", teapot(8), cornerNormals(patches, 8)};
      case 5:
        return {"teapot 16", teapot(16), cornerNormals(patches, 16)};
      case 6:
        return {"teapot 8 but its creases", teapot(8), smooth(8)};
      default:
        return {"teapot 16 but its creases", teapot(16), smooth(16)};
    }
  }();
  NormalError error;
  for (auto _ : state) benchmark::DoNotOptimize(error = normalError(mesh, rule.id, truth));
  state.counters["mean_degrees"] = error.mean;
  state.counters["max_degrees"] = error.max;
  state.SetLabel(name + ", " + std::string{rule.name});
}
BENCHMARK(BM_NormalError)
    ->ArgsProduct({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3}})
    ->Unit(benchmark::kMicrosecond);

/// side * side unit tiles with six decimals, each with a smaller square on it.
Mesh tiledFloor(int side) {
  Mesh mesh;
  mesh.groupNames = {"floor"};
  mesh.rounding = {0.5e-6};
  const auto square = [&](double x, double y, double size) {
    const int first = static_cast<int>(mesh.points.size());
    for (const auto [dx, dy] : {std::array{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}})
      mesh.points.push_back({x + dx, y + dy, 0.0});
    mesh.addFace(std::array{first, first + 1, first + 2, first + 3}, 0);
  };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) square(i, j, 1.0);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) square(i + 0.25, j + 0.25, 0.5);
  return mesh;
}

void findCoplanar(benchmark::State& state, const Mesh& mesh) {
  const ConvexParts parts = divideFaces(mesh);
  CoplanarClasses classes;
  for (auto _ : state) benchmark::DoNotOptimize(classes = coplanarClasses(mesh, parts));
  state.SetItemsProcessed(state.iterations() * parts.count());
  state.counters["planes"] = 1.0 + *std::ranges::max_element(classes.plane);
}
// No two faces are coplanar, and neighbours touch: expect n log n. The mesh is exact, or as if read with that
// many decimals.
void BM_CoplanarTorus(benchmark::State& state) {
  Mesh mesh = triangleTorus(static_cast<int>(state.range(0)));
  if (state.range(1) > 0) mesh.rounding = {0.5 / std::pow(10.0, state.range(1))};
  findCoplanar(state, mesh);
}
BENCHMARK(BM_CoplanarTorus)->ArgsProduct({{56, 224, 707}, {0, 6}})->Unit(benchmark::kMillisecond);

// No two faces are coplanar, and each box overlaps about a hundred others: expect n log n, because their
// planes differ.
void BM_CoplanarSoup(benchmark::State& state) {
  findCoplanar(state, triangleSoup(static_cast<int>(state.range(0)), 0.3, 1972));
}
BENCHMARK(BM_CoplanarSoup)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

// All faces lie in one plane, and every tile has its decal: expect n log n.
void BM_CoplanarFloor(benchmark::State& state) {
  findCoplanar(state, tiledFloor(static_cast<int>(state.range(0))));
}
BENCHMARK(BM_CoplanarFloor)->Arg(32)->Arg(100)->Arg(320)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace xnewell
