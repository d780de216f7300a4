#include "shading/scene/setting_rows.h"

#include "shading/scene/setting_choices.h"
#include "shading/scene/setting_field.h"
#include "shading/scene/setting_needs.h"

namespace xnewell {

using namespace needs;
using Unmet = Need::Unmet;

std::vector<Setting> methodRows() {
  return {
      {.key = "method",
       .option = "--shade",
       .label = "shading",
       .control = 'S',
       .section = Section::Method,
       .is = "where the illumination is evaluated, per face, per vertex or per pixel",
       .role = Role::shortCut("phong"),
       .field = chooses(
           kShadings, [](auto& s) -> auto& { return s.shading; }),
       .words = {"full intensity", "depth", "flat", "Gouraud", "Phong", "environment map"},
       .alwaysSaid = true},
      {.key = "normals",
       .option = "--normals",
       .label = "normals",
       .control = 'N',
       .section = Section::Method,
       .is = "how a vertex gets its normal from the faces around it",
       .role = Role::shortCut("exact"),
       .field = chooses(
           kNormalRules, [](auto& s) -> auto& { return s.normals; }),
       .need = {interpolates, "gouraud, phong and envmap shading, which use normals at vertices"},
       .phrase = "{} normals",
       .alwaysSaid = true},
      {.key = "crease",
       .option = "--crease",
       .label = "crease",
       .is = "largest angle between faces that share a vertex normal",
       // A short cut like `normals`: it tells where to guess that polygons stand for a smooth surface. Where
       // that surface is known, its own normals are used, and elsewhere the polygons are all that is known.
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.crease; }),
       .range = {0, 180},
       .unit = "degrees",
       .trials = {0, 30, 180},
       .need = {creased, "gouraud, phong and envmap shading with normals that are not those of patches"}},
      {.key = "polygons",
       .option = "--polygons",
       .label = "polygons",
       .is = "how Gouraud shading interpolates over polygons of more than three corners",
       .role = Role::shortCut("triangles"),
       .field = chooses(
           kPolygons, [](auto& s) -> auto& { return s.polygons; }),
       .need = {gouraud, "gouraud shading"},
       .phrase = "by {}"},
      {.key = "adapt",
       .option = "--adapt",
       .label = "tolerance",
       .is = "divide polygons where flat or Gouraud shading is off by more than this intensity, 0 for none",
       .more = "At most a million pieces are made.",
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.adapt; }),
       .trials = {0, 0.1, 0.03, 0.01},
       .need = {dividing, "flat and gouraud shading", Unmet::RefusedOrKept},
       .differsIn = "division"},
      {.key = "environment",
       .option = "--environment",
       .label = "environment",
       .is = "how envmap shading looks up its map",
       .role = Role::shortCut("rotated"),
       .field = chooses(
           kEnvironmentForms, [](auto& s) -> auto& { return s.environment; }),
       .need = {mapped, "envmap shading"}},
      {.key = "mapping",
       .option = "--mapping",
       .label = "mapping",
       .is = "how texture coordinates, and Phong's normals and places, are interpolated",
       .role = Role::shortCut("perspective"),
       .field = chooses(
           kTextureMappings, [](auto& s) -> auto& { return s.mapping; }),
       .need = {overDepth, "phong shading and textures"},
       .phrase = "{} mapping"},
      {.key = "order",
       .option = "--order",
       .label = "order",
       .control = 'O',
       .section = Section::Method,
       .is = "hidden-surface method: which faces are painted first, so that later ones cover them",
       .role = Role::shortCut("oracle"),
       .field = chooses(
           kOrders, [](auto& s) -> auto& { return s.order; }),
       .words = {"unsorted", "z-sort by mean z", "z-sort by farthest z", "Newell", "BSP tree",
                 "16-bit z-buffer", "24-bit z-buffer", "32-bit z-buffer", "oracle"},
       .alwaysSaid = true},
      {.key = "fill",
       .option = "--fill",
       .label = "fill",
       .control = 'F',
       .section = Section::Method,
       .is = "which program fills polygons: the X server or xnewell",
       .role = Role::shortCut("scanline"),
       .field = chooses(
           kFillers, [](auto& s) -> auto& { return s.inPixels; })},
      {.key = "cull",
       .option = "--cull",
       .label = "backs",
       .control = 'K',
       .section = Section::Method,
       .is = "which faces are culled: back faces or none",
       .role = Role::shortCut("none"),
       .field = chooses(
           kCulls, [](auto& s) -> auto& { return s.cull; }),
       .words = {"backs kept", "backs culled"}},
      {.key = "colors",
       .option = "--colors",
       .label = "colours",
       .is = "which colours the cells of the scene hold",
       .role = Role::shortCut("needed"),
       .field = chooses(
           kColorPlans, [](auto& s) -> auto& { return s.colors; })},
      {.key = "dither",
       .option = "--dither",
       .label = "dither",
       .is = "ordered dithering, where the cells hold colours and not ramps",
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.dither; }),
       .need = {inColors, "cells that hold colours: --colors cube and chosen"},
       .words = {"not dithered", "dithered"}},
  };
}

}  // namespace xnewell
