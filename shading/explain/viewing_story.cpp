#include "shading/explain/viewing_story.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "geometry/exact/plane.h"
#include "geometry/view/screen_plane.h"
#include "shading/explain/pixel_history.h"

namespace xnewell {

namespace {

constexpr double kSame = 0x1p-30;  // of numbers up to 1: a smaller difference is put down to rounding

std::optional<int> wholeNumberIn(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty() && value >= 0
             ? std::optional{value}
             : std::nullopt;
}

/// The corner of a face that is nearest to a place of the picture, of those in front of the eye.
int nearestCorner(const Mesh& mesh, const ViewStages& stages, int face, const glm::dvec2& place) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  const std::span<const int> corners = mesh.face(face);
  for (int k = 0; k < static_cast<int>(corners.size()); ++k) {
    if (stages.at(ViewStage::Clipped, mesh.points[corners[k]]).w <= 0.0) continue;
    const double distance =
        glm::length(glm::dvec2{stages.at(ViewStage::Viewport, mesh.points[corners[k]])} - place);
    if (distance < least) least = distance, best = k;
  }
  return best;
}

/// A vertex of the picture's polygons.
struct SnappedVertex {
  const SnappedFace* face = nullptr;
  int vertex = -1;  ///< index into SnappedScene::vertices
};
SnappedVertex snappedVertexOf(const Picture& picture, int face, int meshCorner) {
  if (picture.shading().refined()) return {};  // its polygons have corners of their own
  const SnappedScene& scene = picture.snapped();
  const auto own = std::ranges::equal_range(scene.faces, face, {}, &SnappedFace::number);
  for (const SnappedFace& f : own)
    for (int k = f.first; k < f.first + f.count; ++k)
      if (scene.source[k] == meshCorner) return {&f, k};
  if (!own.empty()) return {&own.front(), -1};  // the vertex was cut away
  return {};
}

double luminanceOf(const ByChannel& I, int channels) {
  return channels == 1 ? I[0] : luminance({I[0], I[1], I[2]});
}

}  // namespace

std::string textOf(const FaceCorner& vertex) {
  return std::to_string(vertex.face) + '.' + std::to_string(vertex.corner + 1);
}

std::optional<FaceCorner> cornerOf(const Mesh& mesh, const std::string& text) {
  const std::size_t dot = text.find('.');
  const std::optional<int> first = wholeNumberIn(std::string_view{text}.substr(0, dot));
  if (!first) return std::nullopt;
  if (dot == std::string::npos) {
    const auto corner = std::ranges::find(mesh.corners, *first);
    if (corner == mesh.corners.end()) return std::nullopt;
    const int at = static_cast<int>(corner - mesh.corners.begin());
    const auto next = std::ranges::upper_bound(mesh.firstCorner, at);
    const int face = static_cast<int>(next - mesh.firstCorner.begin()) - 1;
    return FaceCorner{face, at - mesh.firstCorner[face]};
  }
  const std::optional<int> corner = wholeNumberIn(std::string_view{text}.substr(dot + 1));
  if (!corner || *first >= mesh.faceCount() || *corner < 1 ||
      *corner > static_cast<int>(mesh.face(*first).size()))
    return std::nullopt;
  return FaceCorner{*first, *corner - 1};
}

FaceCorner middleCorner(const Picture& picture) {
  const int width = picture.settings().width, height = picture.settings().height;
  const Mesh& mesh = picture.scene().mesh;
  const ViewStages stages{picture.camera().view, width, height};
  const glm::dvec2 middle{width / 2.0, height / 2.0};
  const SnappedScene& scene = picture.snapped();
  int face = -1;
  if (!picture.shading().refined()) {
    const PixelHistory history = historyOf(picture, width / 2, height / 2);
    if (history.nearest >= 0) face = scene.faces[history.nearest].number;
  }
  if (face < 0) {
    double least = std::numeric_limits<double>::infinity();
    for (const SnappedFace& f : scene.faces) {
      for (int k = f.first; k < f.first + f.count; ++k) {
        const double distance = glm::length(glm::dvec2{scene.vertices[k]} / double{kGrid} - middle);
        if (!f.back && distance < least) least = distance, face = f.number;
      }
    }
  }
  if (face < 0) face = scene.faces.empty() ? 0 : scene.faces.front().number;
  return {face, nearestCorner(mesh, stages, face, middle)};
}

ViewingStory::ViewingStory(const Picture& picture, FaceCorner of)
    : vertex{of},
      point{picture.scene().mesh.face(of.face)[of.corner]},
      place{picture.scene().mesh.points[point]},
      stages{picture.camera().view, picture.settings().width, picture.settings().height},
      zShift{picture.snapped().zShift} {
  const Mesh& mesh = picture.scene().mesh;
  const SnappedScene& scene = picture.snapped();
  const Surfaces surfaces = picture.surfaces();
  const SnappedVertex own = snappedVertexOf(picture, of.face, mesh.firstCorner[of.face] + of.corner);

  outside = stages.outside(place);
  unsigned any = 0, all = ~0u;
  for (const int corner : mesh.face(of.face)) {
    const unsigned code = stages.outside(mesh.points[corner]);
    any |= code, all &= code;
  }
  faceGone = all != 0, cut = faceGone ? 0 : any;

  const double zScale = std::ldexp(1.0, kGridBits - zShift);
  if (outside == 0) snapped = snapToGrid(glm::dvec3{stages.at(ViewStage::Viewport, place)}, zScale);
  if (own.vertex >= 0) {
    ofPicture = true;
    agrees = snapped == scene.vertices[own.vertex];
    snapped = scene.vertices[own.vertex];
  }
  if (own.face) {
    const ScreenPlane record = scene.planes.empty()
                                   ? planeThrough(&scene.vertices[own.face->first], own.face->count)
                                   : picture.withPlanes().snapped().planes[own.face->plane];
    const double C = static_cast<double>(record.C), step = 1.0 / zScale;
    plane = glm::dvec3{static_cast<double>(record.A) / C * kGrid * step,
                       static_cast<double>(record.B) / C * kGrid * step, depthAt(record, 0, 0) * step};
  }

  // Towards the side that the light is computed for.
  glm::dvec3 N = newellPlane(mesh.points, mesh.face(of.face)).N;
  const bool back = own.face ? own.face->back : glm::dot(N, picture.camera().eye - place) < 0.0;
  if (back && picture.settings().light.twoSided) N = -N;
  const Lighting& lighting = picture.shading().lighting();
  const EquationAt equation{surfaces, mesh.material[of.face] + 1};
  const bool colored = channelsOf(picture.colors().plan()) == Channels::Rgb;
  for (const ViewStageRow& row : kViewStages) {
    VertexAtStage& here = at[static_cast<std::size_t>(row.id)];
    here.at = stages.at(row.id, place);
    const glm::dmat3 derivative = stages.derivative(row.id, place);
    here.N = carriedNormal(derivative, N);
    here.keepsAngles = keepsAngles(derivative);
    const bool needsN = !lighting.onlyAmbient();
    here.equation = row.id == ViewStage::World ? equation(place, needsN ? N : glm::dvec3{0.0})
                                               : equation.behind(derivative, place, N);
    if (!here.equation.lights.empty() && N != glm::dvec3{0.0})
      here.NdotL = here.equation.lights.front().NdotL;
    here.I = luminanceOf(here.equation.I, lighting.channels);
    if (!colored)
      here.cell = picture.colors().tableOf(mesh.material[of.face]).cell(std::clamp(here.I, 0.0, 1.0));
  }
}

bool ViewingStory::differsInNdotL(ViewStage stage) const {
  return of(stage).NdotL && std::abs(*of(stage).NdotL - *world().NdotL) > kSame;
}

bool ViewingStory::differsInI(ViewStage stage) const { return std::abs(of(stage).I - world().I) > kSame; }

std::string_view clipPlaneName(int plane) {
  constexpr std::array<std::string_view, 6> kNames{"front", "back", "left", "right", "top", "bottom"};
  return kNames[static_cast<std::size_t>(plane)];
}

}  // namespace xnewell
