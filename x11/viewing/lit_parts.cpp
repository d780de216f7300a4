#include "x11/viewing/lit_parts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "shading/explain/equation_at.h"
#include "shading/fill/intensities.h"
#include "shading/picture/cell_use.h"

namespace xnewell {

namespace {

Intensities litAt(const ShadingPoints& points, const Lighting& lighting, int channel) {
  Terms diffuse, specular;
  Intensities lit;
  diffuseIntensities(diffuse, points, lighting, channel);
  specularIntensities(specular, points, lighting, channel);
  addTerms(lit, diffuse, specular, points, lighting, channel);
  return lit;
}

/// All channels at all points, as the equation has them behind a stage.
std::vector<std::vector<FrontBack<double>>> litBehind(const Picture& picture, const ShadingPoints& points,
                                                      const ViewStages& stages, ViewStage stage) {
  const Surfaces surfaces = picture.surfaces();
  const Lighting& lighting = picture.shading().lighting();
  std::vector<std::optional<EquationAt>> equations(picture.scene().mesh.materials.size() + 1);
  std::vector<std::vector<FrontBack<double>>> channels(static_cast<std::size_t>(lighting.channels));
  for (std::size_t k = 0; k < points.count(); ++k) {
    const int material = points.material[k] + 1;
    std::optional<EquationAt>& equation = equations[static_cast<std::size_t>(material)];
    if (!equation) equation.emplace(surfaces, material);
    const glm::dmat3 derivative = stages.derivative(stage, points.at[k]);
    const ByChannel front = equation->behind(derivative, points.at[k], points.N[k]).I;
    const ByChannel back =
        lighting.twoSided ? equation->behind(derivative, points.at[k], -points.N[k]).I : front;
    for (std::size_t c = 0; c < channels.size(); ++c)
      channels[c].push_back({std::clamp(front[c], 0.0, 1.0), std::clamp(back[c], 0.0, 1.0)});
  }
  return channels;
}

/// The cell of the scene's that is nearest to a colour.
std::uint8_t nearestCell(const Palette& palette, const CellRange& cells, const glm::dvec3& color) {
  int best = cells.first;
  double least = std::numeric_limits<double>::infinity();
  for (int cell = cells.first; cell <= cells.last(); ++cell) {
    const Rgb16 c = palette[static_cast<std::size_t>(cell)];
    const glm::dvec3 away = glm::dvec3{c.r, c.g, c.b} / 65535.0 - color;
    const double distance = glm::dot(away, away);
    if (distance < least) least = distance, best = cell;
  }
  return static_cast<std::uint8_t>(best);
}

}  // namespace

LitParts::LitParts(const Picture& picture, const Palette& palette, const ViewStages* stages,
                   ViewStage shadedIn)
    : material_{picture.scene().mesh.material}, of_{picture.colors().ramps()} {
  const Scene& scene = picture.scene();
  const Mesh& mesh = scene.mesh;
  const Lighting& lighting = picture.shading().lighting();
  const bool ofVertices = rowOf(picture.settings().shading).interpolates;
  const Shading method = picture.settings().shading;
  const bool world = !stages || shadedIn == ViewStage::World;
  // The picture has the intensities already, if it evaluates them where this does.
  const bool has = world && (method == Shading::Flat || method == Shading::Gouraud) &&
                   !picture.shading().refined() && !lighting.onlyAmbient() && !lighting.luminance;
  ShadingPoints points;
  if (has && ofVertices) {
    pointOf_ = picture.shading().vertices().ofCorner;
  } else if (ofVertices) {
    Vertices vertices = smoothVertices(scene, picture.settings());
    points = vertexPoints(mesh, vertices);
    pointOf_ = std::move(vertices.ofCorner);
  } else {
    if (!has) points = facePoints(mesh);
    pointOf_.resize(mesh.corners.size());
    for (int face = 0; face < mesh.faceCount(); ++face)
      std::fill(pointOf_.begin() + mesh.firstCorner[face], pointOf_.begin() + mesh.firstCorner[face + 1],
                face);
  }
  std::vector<std::vector<FrontBack<double>>> channels;
  if (!world && !lighting.onlyAmbient())
    channels = litBehind(picture, points, *stages, shadedIn);
  else
    for (int c = 0; c < lighting.channels; ++c)
      channels.push_back(has ? picture.shading().intensities(c).I : litAt(points, lighting, c).I);
  intensities_ = channels.front();
  const auto gray = [&](std::size_t k, double FrontBack<double>::*side) {
    return luminance({channels[0][k].*side, channels[1][k].*side, channels[2][k].*side});
  };
  for (std::size_t k = 0; k < intensities_.size() && lighting.channels == 3; ++k)
    intensities_[k] = {gray(k, &FrontBack<double>::front), gray(k, &FrontBack<double>::back)};
  for (const Ramp& ramp : of_) ramps_.emplace_back(ramp);
  colored_ = channelsOf(picture.colors().plan()) == Channels::Rgb;
  if (!colored_ || lighting.channels != 3) return;
  const CellRange cells = sceneCells(picture);
  for (int face = 0; face < mesh.faceCount(); ++face)
    for (const auto side : {&FrontBack<double>::front, &FrontBack<double>::back}) {
      glm::dvec3 sum{0.0};
      const int first = mesh.firstCorner[face], end = mesh.firstCorner[face + 1];
      for (int corner = first; corner < end; ++corner)
        for (int c = 0; c < 3; ++c)
          sum[c] += channels[static_cast<std::size_t>(c)][static_cast<std::size_t>(pointOf_[corner])].*side;
      cells_.push_back(nearestCell(palette, cells, sum / double(end - first)));
    }
}

}  // namespace xnewell
