#include "x11/window/no_effect.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <ostream>
#include <span>

#include "shading/picture/facts.h"
#include "x11/drawing/wording.h"

namespace xnewell {

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
