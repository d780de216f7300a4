#include "shading/picture/scene_colors.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/view/at_source.h"
#include "shading/color/color_plan.h"
#include "shading/picture/surface_painter.h"

namespace xnewell {

namespace {

bool gray(const glm::dvec3& color) { return color.r == color.g && color.g == color.b; }

/// Scales the colour so that its largest component is 1. Black has no hue and becomes white.
glm::dvec3 hueOf(const glm::dvec3& color) {
  const double largest = std::max({color.r, color.g, color.b});
  return largest > 0.0 ? color / largest : glm::dvec3{1.0};
}

/// `hues` are the hues of the materials, each once. `ofMaterial` is the index of each material's hue. Its
/// first entry is for faces without a material; their hue is white, because they reflect all light.
struct Hues {
  std::vector<glm::dvec3> hues;
  std::vector<int> ofMaterial;
};
Hues huesOf(const Scene& scene) {
  Hues result;
  const auto add = [&](const glm::dvec3& hue) {
    const auto known = std::ranges::find(result.hues, hue);
    result.ofMaterial.push_back(static_cast<int>(known - result.hues.begin()));
    if (known == result.hues.end()) result.hues.push_back(hue);
  };
  const std::vector<int>& used = scene.mesh.material;
  const bool bare = std::ranges::find(used, -1) != used.end();
  if (bare || scene.mesh.materials.empty())
    add(glm::dvec3{1.0});
  else
    result.ofMaterial.push_back(0);
  for (const MeshMaterial& m : scene.mesh.materials) add(hueOf(m.diffuse));
  return result;
}

/// Finds the range of a face's intensities. Flat shading has one intensity at the face, and Gouraud shading
/// has those at its vertices. If intensities are found pixel by pixel, the range is that of all samples of
/// the face. Without light it is 0 to 1.
class FaceRanges {
 public:
  struct Range {
    double low, high;
  };

  explicit FaceRanges(const Surfaces& surfaces)
      : s_{surfaces},
        painter_{
            surfaces, 0, std::vector<Ramp>(surfaces.shading.lighting().materials.size(), kChannelRamp), {}} {}

  /// `f` is an index into snapped.faces. low > high if the face has no sample.
  [[nodiscard]] Range operator()(int f) {
    const Shading method = s_.settings.shading;
    if (!rowOf(method).lit) return {0.0, 1.0};
    const SnappedFace& face = s_.snapped.faces[f];
    if (method == Shading::Environment || painter_.evaluates(face)) {
      // The cell of an intensity I is round(first + (shades - 1) I).
      const auto [least, greatest] = painter_.cellEnds(f, s_.settings.width, s_.settings.height);
      const double perCell = 1.0 / (kChannelRamp.shades - 1);
      return {(least - kChannelRamp.first - 0.5) * perCell, (greatest - kChannelRamp.first + 0.5) * perCell};
    }
    const std::vector<FrontBack<double>>& I = s_.shading.intensities(0).I;
    const auto seen = [&](int point) { return I[point].seen(face.back); };
    if (method == Shading::Flat) return {seen(s_.shading.pointOf(face)), seen(s_.shading.pointOf(face))};
    Range range{1.0, 0.0};
    for (int k = face.first; k < face.first + face.count; ++k) {
      const double v = atSource(s_.snapped, s_.snapped.source[k],
                                [&](int corner) { return seen(s_.shading.vertices().ofCorner[corner]); });
      range = {std::min(range.low, v), std::max(range.high, v)};
    }
    return range;
  }

 private:
  Surfaces s_;
  SurfacePainter painter_;
};

/// Widens the range to whole 255ths, so that it does not change with every turn. The range is at least 1/255
/// wide.
void toBytes(HueNeed& need) {
  need.low = std::floor(255.0 * std::clamp(need.low, 0.0, 1.0)) / 255.0;
  need.high = std::ceil(255.0 * std::clamp(need.high, 0.0, 1.0)) / 255.0;
  if (need.low < need.high) return;
  need.low = std::min(need.low, 254.0 / 255.0);
  need.high = need.low + 1.0 / 255.0;
}

}  // namespace

ColorPlan planOf(const Scene& scene, const PictureSettings& settings) {
  if (settings.colors == ColorPlan::Hues) {
    const int hues = static_cast<int>(huesOf(scene).hues.size());
    if (2 * hues > settings.table.shades)
      throw ViewError{std::to_string(hues) + " hues need two shades each, but the table has only " +
                      std::to_string(settings.table.shades) + ": choose another --colors"};
  }
  if (settings.colors != ColorPlan::Needed) return settings.colors;
  if (!rowOf(settings.shading).lit) return ColorPlan::OneHue;
  const bool coloredLight =
      std::ranges::any_of(scene.light.lights, [](const Light& l) { return !gray(l.Ip); }) ||
      !gray(scene.light.Ia.value_or(glm::dvec3{0.0}));
  // The ambient term has the surface's colour, and the texels have none.
  const auto mixes = [&](const MeshMaterial& m) {
    return settings.shading != Shading::Environment && m.texture >= 0 &&
           settings.light.texel == TexelUse::Replaces && !gray(m.diffuse);
  };
  if (std::ranges::any_of(scene.mesh.materials, mixes)) return ColorPlan::Chosen;
  if (coloredLight || std::ranges::any_of(scene.textures, &Texture::colored)) return ColorPlan::Chosen;
  if (std::ranges::all_of(scene.mesh.materials, [](const MeshMaterial& m) { return gray(m.diffuse); }))
    return ColorPlan::OneHue;
  const int hues = static_cast<int>(huesOf(scene).hues.size());
  return hues * kLeastShades <= settings.table.shades ? ColorPlan::Hues : ColorPlan::Chosen;
}

void SceneColors::make(const Surfaces& surfaces, ColorPlan plan) {
  const Scene& scene = surfaces.scene;
  const SnappedScene& snapped = surfaces.snapped;
  const PictureSettings& settings = surfaces.settings;
  plan_ = plan;
  const std::size_t materials = scene.mesh.materials.size() + 1;
  tables_.clear();
  if (plan != ColorPlan::Hues) {
    tables_.emplace_back(settings.table);
    tableOf_.assign(materials, 0);
  } else {
    const Hues hues = huesOf(scene);
    tableOf_ = hues.ofMaterial;
    std::vector<HueNeed> needs;
    for (const glm::dvec3& hue : hues.hues) needs.push_back({hue, 1.0, 0.0, 0});
    FaceRanges rangeOf{surfaces};
    for (int f = 0; f < static_cast<int>(snapped.faces.size()); ++f) {
      const SnappedFace& face = snapped.faces[f];
      HueNeed& need = needs[tableOf_[scene.mesh.material[face.number] + 1]];
      const double pixels =
          static_cast<double>(doubleArea(&snapped.vertices[face.first], face.count)) / (2.0 * kGrid * kGrid);
      need.samples += std::lround(pixels);
      const auto [low, high] = rangeOf(f);
      need.low = std::min(need.low, low), need.high = std::max(need.high, high);
    }
    for (HueNeed& need : needs) toBytes(need);
    for (const TableSettings& table : planHues(needs, settings.table)) tables_.emplace_back(table);
  }

  cells_.clear();
  if (!isEven(settings.table.kind) && channelsOf(plan) != Channels::Rgb)
    cells_ = {tables_.begin(), tables_.end()};
}

double SceneColors::intensityOf(int cell) const {
  const auto table = std::ranges::find_if(
      tables_, [&](const ColorTable& t) { return cell >= t.first() && cell < t.first() + t.shades(); });
  assert(table != tables_.end());
  return table->intensity(cell - table->first());
}

std::vector<Ramp> SceneColors::ramps() const {
  std::vector<Ramp> ramps;
  for (const int t : tableOf_) {
    const ColorTable& table = tables_[t];
    if (channelsOf(plan_) == Channels::Rgb)
      ramps.push_back(kChannelRamp);
    else if (isEven(table.settings().kind))
      ramps.push_back({table.first(), table.shades(), table.low(), table.high()});
    else
      (ramps.emplace_back(kTableRamp)).table = &cells_[t];
  }
  return ramps;
}

}  // namespace xnewell
