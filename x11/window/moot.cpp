#include "x11/window/moot.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <ostream>
#include <span>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

Shading shading(const Picture& p) { return p.settings().shading; }
bool lit(const Picture& p) { return rowOf(shading(p)).lit; }
bool interpolates(const Picture& p) { return rowOf(shading(p)).interpolates; }
bool creased(const Picture& p) {
  return interpolates(p) && (p.settings().normals != NormalRule::Exact || p.scene().patches.empty());
}
bool specular(const Picture& p) { return lit(p) && p.shading().lighting().specular; }
bool gouraud(const Picture& p) { return shading(p) == Shading::Gouraud; }
bool mapped(const Picture& p) { return shading(p) == Shading::Environment; }
bool placesLights(const Picture& p) { return lit(p) && !mapped(p); }
bool formed(const Picture& p) { return specular(p) && !mapped(p); }
bool asksForEye(const Picture& p) { return formed(p) && p.shading().lighting().asksForEye(); }
bool anyOfKind(const Picture& p, LightKind kind) {
  return std::ranges::find(p.scene().light.lights, kind, &Light::kind) != p.scene().light.lights.end();
}
bool textured(const Picture& p) {
  return std::ranges::any_of(p.scene().mesh.materials, [](const MeshMaterial& m) { return m.texture >= 0; });
}
bool overDepth(const Picture& p) {
  return shading(p) == Shading::Phong || (lit(p) && !mapped(p) && textured(p));
}
bool oneHue(const Picture& p) { return p.colors().plan() == ColorPlan::OneHue; }
bool inColors(const Picture& p) { return channelsOf(p.colors().plan()) == Channels::Rgb; }
bool inRamps(const Picture& p) { return !inColors(p); }
bool hasShades(const Picture& p) { return p.colors().plan() != ColorPlan::Cube; }
bool corrected(const Picture& p) { return p.settings().table.kind == TableKind::Corrected && inRamps(p); }

struct Family {
  std::array<std::string_view, 10> options;
  bool (*counts)(const Picture&);
  std::string_view with;
};
constexpr std::array kFamilies{
    Family{
        {"--normals"}, interpolates, "--shade gouraud, phong and envmap, which ask for normals at vertices"},
    Family{{"--crease"},
           creased,
           "--shade gouraud, phong and envmap, and normals that are not those of patches"},
    Family{{"--polygons"}, gouraud, "--shade gouraud"},
    Family{{"--environment"}, mapped, "--shade envmap"},
    Family{{"--mapping"}, overDepth, "--shade phong and with textures"},
    Family{{"--sided", "--ia", "--ip", "--ka", "--kd", "--light", "--light-at", "--attenuation", "--ks"},
           lit,
           "a --shade that asks for light"},
    Family{
        {"--constant-l"},
        placesLights,
        "--shade flat, gouraud and phong: of envmap all lights are far away, and other shades ask for none"},
    Family{{"--n"}, specular, "highlights: ks above 0, and a --shade that asks for light"},
    Family{{"--form", "--half-vector"},
           formed,
           "highlights of --shade flat, gouraud and phong: ks above 0; envmap's are cos^n of N and L"},
    Family{{"--constant-v"},
           asksForEye,
           "highlights that ask for the eye: ks above 0, --shade flat, gouraud or phong, no --form tutorial"},
    Family{{"--shades"}, hasShades, "ramps and chosen colours; a cube has always 240"},
    Family{{"--table"}, inRamps, "ramps; here the cells hold colours"},
    Family{{"--i0", "--pick"}, corrected, "ramps of --table corrected"},
    Family{{"--hue"}, oneHue, "one hue; here the scene's own colours are shown: see --colors one"},
    Family{{"--dither"}, inColors, "cells that hold colours: see --colors cube and chosen"},
};

/// What of its scene the picture leaves out.
struct Loss {
  bool (*lost)(const Picture&);
  std::string_view what;
};
constexpr std::array kLosses{
    Loss{[](const Picture& p) { return mapped(p) && anyOfKind(p, LightKind::Spot); },
         "--shade envmap has its lights infinitely far away: the scene's spots have no cone"},
    Loss{[](const Picture& p) { return mapped(p) && anyOfKind(p, LightKind::Point); },
         "--shade envmap has its lights infinitely far away: the scene's point lights are not near"},
    Loss{[](const Picture& p) { return mapped(p) && textured(p); },
         "--shade envmap shows no textures: the scene's are left out"},
};

/// Whether a face is more than a point or a line: its area is not 0 beside its longest side, squared.
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

/// Why nothing shows, where nothing does.
void noteEmpty(std::ostream& out, const Picture& picture) {
  const Mesh& mesh = picture.scene().mesh;
  int face = 0;
  while (face < mesh.faceCount() && !hasArea(mesh, face)) ++face;
  if (face == mesh.faceCount()) {
    out << "xnewell: note: nothing of the scene can be seen: no face has an area\n";
    return;
  }
  const SnappedScene& snapped = picture.snapped();
  if (!snapped.faces.empty()) return;
  out << "xnewell: note: nothing of the scene can be seen: of " << counted(snapped.polygons, "polygon") << " "
      << snapped.degenerate << " have no area on the screen, " << snapped.culled << " are culled, "
      << snapped.outside << " lie outside the view\n";
}

}  // namespace

void noteMoot(std::ostream& out, const Options& options, const Picture& picture) {
  for (const std::string& given : options.given)
    for (const Family& family : kFamilies)
      if (std::ranges::find(family.options, given) != family.options.end() && !family.counts(picture))
        out << "xnewell: note: " << given << " does nothing here; it counts with " << family.with << '\n';
  for (const Loss& loss : kLosses)
    if (loss.lost(picture)) out << "xnewell: note: " << loss.what << '\n';
  noteEmpty(out, picture);
}

std::string_view whyMoot(char control, const Picture& picture, const Setup& setup) {
  switch (control) {
    case 'T':
    case '0':
      if (inRamps(picture)) return {};
      return "The cells hold colours here: tables count where they hold ramps.";
    case 'H':
      if (oneHue(picture)) return {};
      return "The scene's own colours are shown: the hue counts for scenes without.";
    case 'J':
      if (inRamps(picture) && setup.picture.table.kind == TableKind::Corrected) return {};
      return "Which shade is the nearest is asked of ramps of the corrected table only.";
    case 'N':
      if (rowOf(setup.picture.shading).interpolates) return {};
      return "This shading asks for no normals at vertices: Gouraud's, Phong's and env do.";
    case 'S':
      if (setup.picture.shading != Shading::Environment || !textured(picture)) return {};
      return "The environment map shows no textures: the scene's are left out.";
    default:
      return {};
  }
}

}  // namespace xnewell
