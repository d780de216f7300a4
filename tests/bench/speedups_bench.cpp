#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

#include "geometry/exact/plane.h"
#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "tests/bench/triangulated.h"

namespace xnewell {

/// The speed-ups that tutorials on flat shading name, on an object that turns before a fixed light. Each
/// computes the colour of each face, max_col cos x, for 64,800 triangles a frame. `max_error` is the largest
/// difference from the plain way in double precision, in shades of 240, after a full turn in steps of one
/// degree.

namespace {

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
