#include "x11/moot.h"

#include <algorithm>
#include <ostream>

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
bool overDepth(const Picture& p) {
  const auto wears = [](const MeshMaterial& m) { return m.texture >= 0; };
  return shading(p) == Shading::Phong || (lit(p) && std::ranges::any_of(p.scene().mesh.materials, wears));
}
bool oneHue(const Picture& p) { return p.colors().plan() == ColorPlan::OneHue; }
bool inColors(const Picture& p) { return channelsOf(p.colors().plan()) == Channels::Rgb; }
bool inRamps(const Picture& p) { return !inColors(p); }
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
    Family{{"--sided", "--ia", "--ip", "--ka", "--kd", "--light", "--light-at", "--attenuation",
            "--constant-l", "--ks"},
           lit,
           "a --shade that asks for light"},
    Family{{"--n", "--form", "--half-vector", "--constant-v"},
           specular,
           "highlights: ks above 0, and a --shade that asks for light"},
    Family{{"--table"}, inRamps, "ramps; here the cells hold colours"},
    Family{{"--i0", "--pick"}, corrected, "ramps of --table corrected"},
    Family{{"--hue"}, oneHue, "one hue; here the scene's own colours are shown: see --colors one"},
    Family{{"--dither"}, inColors, "cells that hold colours: see --colors cube and chosen"},
};

}  // namespace

void noteMoot(std::ostream& out, const Options& options, const Picture& picture) {
  for (const std::string& given : options.given)
    for (const Family& family : kFamilies)
      if (std::ranges::find(family.options, given) != family.options.end() && !family.counts(picture))
        out << "xnewell: note: " << given << " does nothing here; it counts with " << family.with << '\n';
}
