#include "shading/scene/divide_anew.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"

namespace xnewell {

namespace {

constexpr int kFinest = 64;
constexpr std::int64_t kMostFaces = 300'000;
/// A surface that is smaller than this share of the scene keeps its polygons, and so does the run of such a
/// patch: finer ones would be as small as the rounding of the scene's coordinates, which is 2^-53.
constexpr double kLeastSide = 0x1p-42;

/// A grid of faces, `rows` by `columns`, row by row: a patch, or a round solid.
struct Grid {
  int rows = 1, columns = 1;
  [[nodiscard]] int faces() const { return rows * columns; }
  bool operator==(const Grid&) const = default;
};

/// The grid whose rows run around a sphere, or across a torus' tube.
Grid gridOf(const RoundRun& run) { return {run.faces / run.columns, run.columns}; }

/// n divisions for a quarter of a circle; more if the run has more faces than that.
Grid fineGrid(const RoundRun& run, int n) {
  if (run.solid == RoundSolid::Sphere) {
    while (8 * n * n < run.faces) ++n;
    return {2 * n, 4 * n};
  }
  while (16 * n * n < run.faces) ++n;
  return {4 * n, 4 * n};
}

bool isTiny(const RoundRun& run, double least) {
  return std::max({glm::length(run.axes[0]), glm::length(run.axes[1]), glm::length(run.axes[2])}) < least;
}

bool isTiny(const PatchRun& run, double least) {
  return std::ranges::any_of(run.patches, [&](const BezierPatch& patch) {
    Box box;
    for (const glm::dvec3& p : patch.p) box.add(p);
    return box.side() > 0.0 && box.side() < least;  // one without extent has no faces to tell apart
  });
}

/// Faces that follow each other: of one run of patches, of one round solid, or of no curved surface.
struct Stretch {
  int first = 0, faces = 0;
  const PatchRun* patches = nullptr;
  const RoundRun* round = nullptr;
};

/// All faces of a scene in order. A scene with other divisions has as many stretches of the same kinds.
std::vector<Stretch> stretchesOf(const Scene& scene) {
  std::vector<Stretch> curved;
  for (const PatchRun& run : scene.patches)
    curved.push_back({firstFaceOf(scene.mesh, run), facesOf(run), &run, nullptr});
  for (const RoundRun& run : scene.rounds) curved.push_back({run.firstFace, run.faces, nullptr, &run});
  std::ranges::sort(curved, {}, &Stretch::first);
  std::vector<Stretch> all;
  int end = 0;
  const auto fillTo = [&](int first) {
    if (end < first) all.push_back({end, first - end});
  };
  for (const Stretch& stretch : curved) {
    fillTo(stretch.first);
    all.push_back(stretch);
    end = stretch.first + stretch.faces;
  }
  fillTo(scene.mesh.faceCount());
  return all;
}

/// How often to divide each run.
struct Divisions {
  std::function<int(const PatchRun&)> ofPatches;
  std::function<Grid(const RoundRun&)> ofRound;
};

/// How often a reference divides them.
Divisions fineDivisions(const Scene& scene) {
  const int n = finestDivisions(scene);
  const double least = std::ldexp(kLeastSide, scene.exponent);
  return {
      [=](const PatchRun& run) { return isTiny(run, least) ? run.divisions : std::max(n, run.divisions); },
      [=](const RoundRun& run) { return isTiny(run, least) ? gridOf(run) : fineGrid(run, n); }};
}

/// Makes the mesh anew, in file coordinates. Faces of curved surfaces get the group and the material of the
/// old face in their place.
class Divider {
 public:
  explicit Divider(const Scene& scene) : scene_{scene} {
    const Mesh& old = scene.mesh;
    for (const glm::dvec3& p : old.points) mesh_.points.push_back(scaled(p, scene.exponent));
    mesh_.groupNames = old.groupNames;
    mesh_.materials = old.materials;
    mesh_.uv = old.uv;
    for (const double u : old.rounding) mesh_.rounding.push_back(std::ldexp(u, scene.exponent));
  }

  [[nodiscard]] Scene divided(const Divisions& divisions) {
    std::vector<PatchRun> patches;
    std::vector<RoundRun> rounds;
    for (const Stretch& stretch : stretchesOf(scene_)) {
      if (stretch.patches != nullptr)
        patches.push_back(add(stretch, *stretch.patches, divisions.ofPatches(*stretch.patches)));
      else if (stretch.round != nullptr)
        rounds.push_back(add(stretch, *stretch.round, divisions.ofRound(*stretch.round)));
      else
        copy(stretch);
    }
    return finish(std::move(patches), std::move(rounds));
  }

 private:
  void copy(const Stretch& stretch) {
    const Mesh& old = scene_.mesh;
    for (int f = stretch.first; f < stretch.first + stretch.faces; ++f) {
      const auto uv = [&]() -> std::span<const int> {
        if (old.uvOfCorner.empty()) return {};
        return {old.uvOfCorner.data() + old.firstCorner[f], old.uvOfCorner.data() + old.firstCorner[f + 1]};
      }();
      mesh_.addFace(old.face(f), old.group[f], old.material[f], uv, old.normalsOf(f));
    }
  }

  /// Adds a mesh in file coordinates. oldFace(f) is the old face in the place of its face f.
  template <class OldFace>
  void add(const Mesh& part, const OldFace& oldFace) {
    const int points = static_cast<int>(mesh_.points.size()), uvs = static_cast<int>(mesh_.uv.size());
    mesh_.points.insert(mesh_.points.end(), part.points.begin(), part.points.end());
    mesh_.uv.insert(mesh_.uv.end(), part.uv.begin(), part.uv.end());
    std::vector<int> corners, uv;
    for (int f = 0; f < part.faceCount(); ++f) {
      corners.assign(part.face(f).begin(), part.face(f).end());
      for (int& c : corners) c += points;
      uv.assign(part.uvOfCorner.begin() + part.firstCorner[f],
                part.uvOfCorner.begin() + part.firstCorner[f + 1]);
      for (int& k : uv) k += uvs;
      const int old = oldFace(f);
      mesh_.addFace(corners, scene_.mesh.group[old], scene_.mesh.material[old], uv);
    }
  }

  PatchRun add(const Stretch& stretch, const PatchRun& run, int n) {
    PatchRun anew{static_cast<int>(mesh_.corners.size()), run.patches, n, run.own};
    const int cells = n * n, oldCells = run.divisions * run.divisions;
    add(tessellate(run.patches, n), [&](int f) { return stretch.first + f / cells * oldCells; });
    return anew;
  }

  RoundRun add(const Stretch& stretch, const RoundRun& run, const Grid& grid) {
    RoundRun anew = run;
    anew.firstFace = mesh_.faceCount(), anew.faces = grid.faces(), anew.columns = grid.columns;
    Mesh part =
        run.solid == RoundSolid::Sphere ? sphere(grid.columns, grid.rows) : torus(grid.rows, grid.columns);
    for (glm::dvec3& p : part.points) p = run.axes * p + run.centre;
    add(part, [&](int) { return stretch.first; });
    return anew;
  }

  Scene finish(std::vector<PatchRun> patches, std::vector<RoundRun> rounds) {
    Scene scene = makeScene(scene_.name, std::move(mesh_), scene_.up);
    const int exponent = scene.exponent - scene_.exponent;
    const double factor = std::ldexp(1.0, exponent);  // exact
    for (glm::dvec3& p : scene.mesh.points) p *= factor;
    for (double& u : scene.mesh.rounding) u *= factor;
    for (NumberedPlanes* const planes : {&scene.parts.planes, &scene.parts.own})
      for (ModelPlane& plane : planes->planes) plane.at *= factor;
    scene.parts.frame->first += exponent;
    scene.exponent = scene_.exponent;
    for (const PatchRun& run : patches)
      if (!run.own) scene.divisions = run.divisions;
    scene.patches = std::move(patches);
    scene.rounds = std::move(rounds);
    scene.camera = scene_.camera;
    scene.settings = scene_.settings;
    scene.light = scene_.light;
    scene.origin = scene_.origin;
    scene.textures = scene_.textures;
    scene.marks = scene_.marks;
    return scene;
  }

  const Scene& scene_;
  Mesh mesh_;
};

}  // namespace

Scene dividedAnew(const Scene& scene, int divisions) {
  if (scene.divisions == 0 || divisions == scene.divisions) return scene;
  Scene other = Divider{scene}.divided(
      {[&](const PatchRun& run) { return run.own ? run.divisions : divisions; }, gridOf});
  other.origin.divisions = divisions;
  return other;
}

Scene finelyDivided(const Scene& scene) { return Divider{scene}.divided(fineDivisions(scene)); }

bool isCoarse(const Scene& scene) {
  const Divisions fine = fineDivisions(scene);
  return std::ranges::any_of(scene.patches,
                             [&](const PatchRun& run) { return fine.ofPatches(run) != run.divisions; }) ||
         std::ranges::any_of(scene.rounds,
                             [&](const RoundRun& run) { return fine.ofRound(run) != gridOf(run); });
}

int finestDivisions(const Scene& scene) {
  std::int64_t patches = 0;
  for (const PatchRun& run : scene.patches) patches += static_cast<std::int64_t>(run.patches.size());
  for (const RoundRun& run : scene.rounds) patches += run.solid == RoundSolid::Sphere ? 8 : 16;
  if (patches == 0) return 0;
  int finest = kFinest;
  while (finest > 1 && patches * finest * finest > kMostFaces) --finest;
  return finest;
}

int sameFaceIn(const Scene& other, const Scene& scene, int face) {
  const std::vector<Stretch> all = stretchesOf(scene), others = stretchesOf(other);
  assert(all.size() == others.size());
  const std::size_t k =
      std::ranges::upper_bound(all, face, {}, &Stretch::first) - all.begin() - std::ptrdiff_t{1};
  const Stretch &from = all[k], &to = others[k];
  const int within = face - from.first;
  const auto gridIn = [](const Stretch& s) {
    if (s.patches != nullptr) return Grid{s.patches->divisions, s.patches->divisions};
    return s.round != nullptr ? gridOf(*s.round) : Grid{1, s.faces};
  };
  const Grid a = gridIn(from), b = gridIn(to);
  // The middle of cell i of n is at (2 i + 1) / 2 n.
  const auto at = [](int i, int n, int of) {
    return static_cast<int>((2 * std::int64_t{i} + 1) * of / (2 * std::int64_t{n}));
  };
  const int row = within % a.faces() / a.columns, column = within % a.columns;
  return to.first + within / a.faces() * b.faces() + at(row, a.rows, b.rows) * b.columns +
         at(column, a.columns, b.columns);
}

}  // namespace xnewell
