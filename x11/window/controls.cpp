#include "x11/window/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <ostream>
#include <span>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "shading/picture/facts.h"
#include "shading/scene/units.h"
#include "x11/drawing/wording.h"

namespace xnewell {

std::string_view keepFillable(Setup& setup) {
  if (setup.fill != Fill::XFillPolygon) return {};
  const Order order = setup.picture.order;
  const bool bySample = rowOf(order).bySample;
  if (!bySample && !rowOf(setup.picture.shading).interpolates) return {};
  setup.fill = Fill::Scanline;
  return order == Order::Oracle
             ? "The oracle decides each sample by itself: there is no polygon for the server to fill."
         : bySample ? "A z-buffer decides each sample by itself: there is no polygon for the server to fill."
                    : "XFillPolygon gives a polygon one cell: the server cannot interpolate.";
}

namespace {
/// Axes of the world as the default view of a scene with this up axis sees them: right, towards the viewer,
/// up.
struct Horizon {
  glm::dvec3 right, towards, up;
};
Horizon horizon(UpAxis up) {
  if (up == UpAxis::Z) return {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  return {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
}
}  // namespace

std::vector<Light> lampsOf(const Setup& setup, const Scene& scene) {
  SceneLight own;
  own.lights = setup.picture.lights.value_or(scene.light.lights);
  Illumination light = setup.picture.light;
  if (light.lightPosition) light.lightPosition = inSceneUnits(*light.lightPosition, scene);
  light.attenuation.reset();  // it belongs to the picture
  return lightsOf(own, light, {});
}

bool hasOwnLamps(const Setup& setup, const Scene& scene) {
  return !setup.picture.lights.value_or(scene.light.lights).empty();
}

void putLamp(Setup& setup, const Scene& scene, std::size_t lamp, const Light& light) {
  if (hasOwnLamps(setup, scene)) {
    setup.picture.lights = lampsOf(setup, scene);
    (*setup.picture.lights)[lamp] = light;
    return;
  }
  setup.picture.light.light = light.direction;
  if (light.kind != LightKind::Directional)
    setup.picture.light.lightPosition = inFileUnits(light.position, scene);
}

glm::dvec3 towardsLight(const Light& light, glm::dvec3 centre) {
  return unit(light.kind == LightKind::Directional ? light.direction : light.position - centre);
}

LightAngles lightAngles(const Light& light, UpAxis up, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const glm::dvec3 L = towardsLight(light, centre);
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return {std::atan2(glm::dot(L, h.right), glm::dot(L, h.towards)) * kDegrees,
          std::asin(std::clamp(glm::dot(L, h.up), -1.0, 1.0)) * kDegrees};
}

void turnLight(Light& light, UpAxis up, double azimuth, double elevation, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const LightAngles now = lightAngles(light, up, centre);
  const double e = std::clamp(std::round(now.elevation + elevation), -90.0, 90.0);
  double a = std::round(now.azimuth + azimuth);
  a -= 360.0 * std::floor((a + 180.0) / 360.0);
  const SinCos sa = sinCosDegrees(a), se = sinCosDegrees(e);
  aimLight(light, se.cos * (sa.sin * h.right + sa.cos * h.towards) + se.sin * h.up, centre);
}

void aimLight(Light& light, glm::dvec3 towards, glm::dvec3 centre) {
  const glm::dvec3 before = towardsLight(light, centre);
  if (light.kind != LightKind::Directional)
    light.position = centre + glm::dot(light.position - centre, before) * towards;
  if (light.kind != LightKind::Spot) {
    light.direction = towards;
    return;
  }
  // The axis turns as the light does: about the normal of both directions. Opposite ones have none.
  const glm::dvec3 about = glm::cross(before, towards);
  const double cosine = glm::dot(before, towards);
  const glm::dvec3 across = glm::cross(about, light.direction);
  light.direction = cosine > -1.0 ? light.direction + across + glm::cross(about, across) / (1.0 + cosine)
                                  : -light.direction;
}

namespace {

bool mapped(const PictureSettings& s) { return s.shading == Shading::Environment; }
bool anyOfKind(const Scene& scene, LightKind kind) {
  return std::ranges::find(scene.light.lights, kind, &Light::kind) != scene.light.lights.end();
}

/// Parts of the scene that the picture leaves out.
struct Loss {
  bool (*lost)(const PictureSettings&, const Scene&);
  std::string_view what;
};
constexpr std::array kLosses{
    Loss{[](const PictureSettings& s, const Scene& scene) {
           return mapped(s) && anyOfKind(scene, LightKind::Spot);
         },
         "envmap shading puts all lights infinitely far away: spotlights lose their cones"},
    Loss{[](const PictureSettings& s, const Scene& scene) {
           return mapped(s) && anyOfKind(scene, LightKind::Point);
         },
         "envmap shading puts all lights infinitely far away: point lights act as if far away"},
    Loss{[](const PictureSettings& s, const Scene& scene) { return mapped(s) && hasTextures(scene); },
         "envmap shading shows no textures: the scene's textures are left out"},
    Loss{[](const PictureSettings& s, const Scene& scene) {
           return !rowOf(s.shading).lit && hasTextures(scene);
         },
         "shading without light shows no textures: the scene's textures are left out"},
};

/// True if a face has an area, so that it is more than a point or a line. Twice the area must exceed 2^-40 of
/// d * d, where d is the longest distance from the first corner to another one; less may be rounding.
bool hasArea(const Mesh& mesh, int face) {
  constexpr double kRounded = 0x1p-40;
  const std::span<const int> corners = mesh.face(face);
  const glm::dvec3& first = mesh.points[corners[0]];
  glm::dvec3 twice{0.0};
  double longest = 0.0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const glm::dvec3 a = mesh.points[corners[k]] - first, b = mesh.points[corners[k + 1]] - first;
    twice += glm::cross(a, b);
    longest = std::max({longest, glm::dot(a, a), glm::dot(b, b)});
  }
  return glm::length(twice) > kRounded * longest;
}

/// Writes a note if the front plane that nobody asked for cuts away something in view.
void noteCut(std::ostream& out, const Picture& picture) {
  if (const int cut = picture.camera().cutByFront; cut > 0)
    out << "xnewell: note: the front plane cuts away " << counted(cut, "polygon")
        << " in view, wholly or in part; --front moves it\n";
}

}  // namespace

void noteEmpty(std::ostream& out, const Picture& picture) {
  const Mesh& mesh = picture.scene().mesh;
  int face = 0;
  while (face < mesh.faceCount() && !hasArea(mesh, face)) ++face;
  if (face == mesh.faceCount()) {
    out << "xnewell: note: the picture is empty: no face has an area\n";
    return;
  }
  const SnappedScene& snapped = picture.snapped();
  if (!snapped.faces.empty()) return;
  out << "xnewell: note: the picture is empty: of " << counted(snapped.polygons, "polygon") << " "
      << snapped.degenerate << " have no area on the screen, " << snapped.culled << " are culled, "
      << snapped.outside << " lie outside the view\n";
}

void noteNoEffect(std::ostream& out, const Options& options, const Picture& picture) {
  const PictureFacts facts = factsOf(picture);
  for (const std::string& given : options.given) {
    const Setting* const setting = settingOf(given);
    if (!setting || hasEffect(*setting, facts)) continue;
    const std::string line = noEffect(given, *setting);
    out << "xnewell: note: " << line << '\n';
  }
  for (const Loss& loss : kLosses)
    if (loss.lost(picture.settings(), picture.scene())) out << "xnewell: note: " << loss.what << '\n';
  noteCut(out, picture);
  noteEmpty(out, picture);
}

std::string whyNoEffect(char control, const Picture& picture, const Setup& setup) {
  const Setting* const setting = settingOf(control);
  if (!setting) return {};
  if (!hasEffect(*setting, factsOf(picture, setup.picture))) return noEffect(setting->label, *setting) + ".";
  if (setting->key != "method") return {};
  const auto* const loss =
      std::ranges::find_if(kLosses, [&](const Loss& l) { return l.lost(setup.picture, picture.scene()); });
  return loss == kLosses.end() ? std::string{} : std::string{loss->what} + ".";
}

}  // namespace xnewell
