#include "x11/viewing/viewing_words.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/options/options.h"

namespace xnewell {

namespace {

/// Up to the shear a stage has lengths; from the warp on, shares of the volume and then pixels.
double unitAt(ViewStage stage, double unit) { return stage <= ViewStage::Sheared ? unit : 1.0; }

glm::dvec4 inUnit(const glm::dvec4& p, double unit) { return {glm::dvec3{p} / unit, p.w}; }

ViewStage before(ViewStage stage) { return static_cast<ViewStage>(std::max(0, static_cast<int>(stage) - 1)); }

bool isParallel(const ViewingStory& story) {
  return story.stages.letters(ViewStage::Sheared) == rowOf(ViewStage::Sheared).parallel;
}

/// What a stage is, in the sentences of the finding.
std::string deedOf(const ViewingStory& story, ViewStage stage) {
  switch (stage) {
    case ViewStage::World:
      return "the world";
    case ViewStage::Vrc:
      return "the turn";
    case ViewStage::Sheared:
      return "the shear";
    case ViewStage::Warped:
      return isParallel(story) ? "the scaling" : "the warp";
    case ViewStage::Clipped:
      return "the clipping";
    case ViewStage::Viewport:
    case ViewStage::Snapped:
      return "the viewport";
  }
  return {};
}

std::string planesIn(unsigned mask) {
  std::string names;
  for (int k = 0; k < 6; ++k)
    if (mask >> k & 1u) names += (names.empty() ? "" : ", ") + std::string{clipPlaneName(k)};
  return names;
}

int countOf(unsigned mask) { return std::popcount(mask & 63u); }

std::string cellsApart(const ViewingStory& story, ViewStage stage) {
  const std::optional<int> here = story.of(stage).cell, world = story.world().cell;
  if (!here || !world) return "";
  if (*here == *world) return ", here the same cell";
  return ": " + counted(std::abs(*here - *world), "cell") + (*here > *world ? " too bright" : " too dark");
}

std::string three(double v) { return fixed(v, 3); }

}  // namespace

double lengthUnit(const Scene& scene) {
  constexpr int kMostExponent = 20;
  return std::abs(scene.exponent) > kMostExponent ? 1.0 : std::ldexp(1.0, -scene.exponent);
}

FaceCorner vertexOf(const Picture& picture, const std::string& text) {
  if (text.empty()) return middleCorner(picture);
  const Mesh& mesh = picture.scene().mesh;
  if (const std::optional<FaceCorner> vertex = cornerOf(mesh, text)) return *vertex;
  throw UsageError{"--viewing: the scene has no vertex " + text + ": it has " +
                   grouped(static_cast<std::int64_t>(mesh.points.size())) + " vertices" + " and " +
                   counted(mesh.faceCount(), "face") + ", counted from 0, and corners from 1"};
}

std::string lengthsInWords(const Scene& scene) {
  return lengthUnit(scene) == std::ldexp(1.0, -scene.exponent)
             ? ""
             : "lengths are multiples of 2^" + std::to_string(scene.exponent) + " of the file's";
}

std::string partOf(const Scene& scene, const FaceCorner& vertex) {
  const std::string& group = scene.mesh.groupNames[scene.mesh.group[vertex.face]];
  return group.empty() ? "face " + std::to_string(vertex.face) : group;
}

glm::dvec4 shownAt(const ViewingStory& story, ViewStage stage, double unit) {
  return inUnit(story.of(stage).at, unitAt(stage, unit));
}

MatrixWithVertex matrixOf(const ViewingStory& story, ViewStage stage, ShownMatrix shown, double unit) {
  const ViewStages& s = story.stages;
  const bool toScreen = shown == ShownMatrix::ToTheScreen;
  const ViewStage from = toScreen ? stage : shown == ShownMatrix::AllSoFar ? ViewStage::World : before(stage);
  const ViewStage to = toScreen ? ViewStage::Viewport : stage;
  MatrixWithVertex m{.matrix = toScreen                         ? s.toScreen(stage)
                               : shown == ShownMatrix::AllSoFar ? s.soFar(stage)
                                                                : s.matrix(stage),
                     .from = story.of(from).at};
  m.to = m.matrix * m.from;
  const double fromUnit = unitAt(from, unit), toUnit = unitAt(to, unit);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) m.matrix[column][row] /= toUnit;
    if (column < 3) m.matrix[column] *= fromUnit;
  }
  m.from = inUnit(m.from, fromUnit), m.to = inUnit(m.to, toUnit);
  return m;
}

std::string stageTitle(const ViewingStory& story, ViewStage stage) {
  const std::string number = std::to_string(static_cast<int>(stage) + 1) + ' ';
  const bool parallel = isParallel(story);
  switch (stage) {
    case ViewStage::World:
      return number + "world: the scene as it was built; light is computed here";
    case ViewStage::Vrc:
      return number + "VRC: VRP is the origin; u, v and n are the axes";
    case ViewStage::Sheared:
      return number + (parallel ? "sheared: the volume stands upright, projectors run along z"
                                : "sheared: the eye is the origin, the pyramid stands upright");
    case ViewStage::Warped:
      return number + (parallel ? "warped: no warp here, the volume is scaled to a box of one size"
                                : "warped: near things grow, and the pyramid becomes a box");
    case ViewStage::Clipped:
      return number + "clipped: what lies in front, behind or far outside is cut off";
    case ViewStage::Viewport:
      return number + "viewport: pixels; x runs right, y down, z towards you";
    case ViewStage::Snapped:
      return number + "snapped: each vertex goes to a grid of 1/65,536 pixel";
  }
  return {};
}

std::string clippedWords(const ViewingStory& story) {
  if (story.faceGone) return "the whole face lies outside: nothing of it is left";
  if (story.cut == 0) return "inside all six planes: nothing is cut, the numbers stay";
  return std::to_string(countOf(story.cut)) + " of the six planes cut" +
         (countOf(story.cut) == 1 ? "s" : "") + " the face (" + planesIn(story.cut) +
         "): " + (story.outside == 0 ? "this vertex stays" : "this vertex is cut off");
}

std::string snappedWords(const ViewingStory& story) {
  if (!story.snapped) return "this vertex is cut off, so it is not snapped";
  const glm::ivec3 p = *story.snapped;
  return grouped(p.x) + "  " + grouped(p.y) + "  " + grouped(p.z) + " steps of 1/65,536 pixel" +
         (story.zShift > 0 ? ", z of " + grouped(1 << std::min(story.zShift, 30)) + "/65,536" : "");
}

std::string planeWords(const ViewingStory& story) {
  if (!story.plane) return "the picture has no polygon of this face";
  const auto term = [](double v, const char* of) {
    return (v < 0 ? " - " : " + ") + fitted(std::abs(v), 4, 11) + of;
  };
  const glm::dvec3 k = *story.plane;
  return "z = " + fitted(k.x, 4, 11) + " x" + term(k.y, " y") + term(k.z, "");
}

ViewingFinding findingOf(const ViewingStory& story, ViewStage stage) {
  const VertexAtStage &here = story.of(stage), &world = story.world();
  if (!world.NdotL && !world.equation.lights.empty())
    return {true, "This face has no area.",
            "It has no plane and no N, so only ambient light reaches it. I is " + three(world.I) +
                " at every stage, and no picture shows it."};
  if (!world.NdotL)
    return {true, "All light is ambient.",
            "The equation asks for no N and no L, so I is " + three(world.I) + " at every stage."};
  const std::string numbers = "N.L is " + three(*here.NdotL) + " and I is " + three(here.I);
  if (stage == ViewStage::World)
    return {true, "Light is computed here.",
            numbers +
                ". N, L and V have their true angles. Each later stage shows what the equation would "
                "have there."};
  if (here.keepsAngles) {
    const bool turn = stage == ViewStage::Vrc, scaled = stage > ViewStage::Sheared;
    return {true,
            turn     ? "A turn keeps angles."
            : scaled ? "The same scale in x, y and z keeps angles."
                     : "Nothing is sheared: angles stay.",
            numbers + " as in the world." +
                (turn || scaled ? std::string{}
                                : std::string{" The window's middle is straight before the "} +
                                      (isParallel(story) ? "projectors" : "eye") + ".")};
  }
  // The first stage that does not keep angles: from there on, light would be wrong.
  int first = 1;
  while (story.at[static_cast<std::size_t>(first)].keepsAngles) ++first;
  const std::string deed = deedOf(story, static_cast<ViewStage>(first));
  ViewingFinding finding{false, "Shade in the world, not behind " + deed + ".", {}};
  finding.why = first == 2 ? "The shear leans each plane, and N with it; L goes along as a direction"
                           : "Up to here all angles stayed, but " + deed + " does not keep them";
  if (first < static_cast<int>(stage)) finding.why = "From " + deed + " on, angles are not kept";
  if (!story.differsInNdotL(stage) && !story.differsInI(stage)) {
    finding.why +=
        ": this plane's N.L is still " + three(*here.NdotL) + ", by chance or because it faces away.";
    return finding;
  }
  finding.why += ": N.L " + three(*world.NdotL) + " becomes " + three(*here.NdotL) +
                 ", and the equation gives " + three(here.I) + " for " + three(world.I) +
                 cellsApart(story, stage) + ". So compute I in the world.";
  return finding;
}

}  // namespace xnewell
