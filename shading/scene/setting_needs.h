#pragma once

#include "shading/scene/settings.h"

namespace xnewell::needs {

/// The conditions under which settings have an effect.

using Facts = const PictureFacts&;

inline bool interpolates(Facts f) { return rowOf(f.settings.shading).interpolates; }
inline bool creased(Facts f) {
  const NormalRule rule = f.settings.normals;
  const bool known =
      rule == NormalRule::File ? f.patches || f.normals : rule == NormalRule::Exact && f.patches;
  return interpolates(f) && !known;
}
inline bool gouraud(Facts f) { return f.settings.shading == Shading::Gouraud; }
inline bool phong(Facts f) { return f.settings.shading == Shading::Phong; }
inline bool mapped(Facts f) { return f.settings.shading == Shading::Environment; }
inline bool dividing(Facts f) {
  return (gouraud(f) || f.settings.shading == Shading::Flat) && f.settings.light.mistake == Mistake::None;
}
inline bool lit(Facts f) { return rowOf(f.settings.shading).lit; }
inline bool litInPlace(Facts f) { return lit(f) && !mapped(f); }
/// R stands only in the textbook's form.
inline bool takesMistake(Facts f) {
  const Illumination& light = f.settings.light;
  return litInPlace(f) && (!rowOf(light.mistake).changesR() || light.form == Form::Textbook);
}
inline bool textured(Facts f) { return litInPlace(f) && f.textures; }
inline bool overDepth(Facts f) { return f.settings.shading == Shading::Phong || textured(f); }
inline bool specular(Facts f) { return lit(f) && f.highlights; }
inline bool formed(Facts f) { return specular(f) && !mapped(f); }
inline bool asksForEye(Facts f) { return formed(f) && f.settings.light.form != Form::Tutorial; }
inline bool fadesLinearly(Facts f) { return f.settings.light.attenuation == Attenuation::Linear; }
inline bool fadesAsTextbook(Facts f) { return f.settings.light.attenuation == Attenuation::Textbook; }
inline bool inColors(Facts f) { return f.plan == ColorPlan::Cube || f.plan == ColorPlan::Chosen; }
inline bool inRamps(Facts f) { return !inColors(f); }
inline bool inOneHue(Facts f) { return f.plan == ColorPlan::OneHue; }
inline bool shaded(Facts f) { return f.plan != ColorPlan::Cube; }
inline bool corrected(Facts f) { return inRamps(f) && f.settings.table.kind == TableKind::Corrected; }

inline constexpr Need kLit{lit, "flat, gouraud, phong and envmap shading, which use light"};
inline constexpr Need kTextured{textured, "textures, in flat, gouraud and phong shading"};
inline constexpr Need kSpecular{specular, "highlights: ks above 0 and a shading method that uses light"};
inline constexpr Need kFormed{
    formed,
    "highlights (ks above 0) of flat, gouraud and phong shading; envmap always uses cos^n of N and L"};
inline constexpr Need kEye{asksForEye,
                           "highlights (ks above 0) of flat, gouraud and phong shading with V in their form"};
inline constexpr Need kInPlace{litInPlace,
                               "flat, gouraud and phong shading; for envmap all lights are far away"};
inline constexpr Need kEvaluated{takesMistake,
                                 "flat, gouraud and phong shading, which evaluate the equation; mistakes in "
                                 "R only to the textbook's form"};
inline constexpr Need kCorrected{corrected, "ramps of the corrected table"};

}  // namespace xnewell::needs
