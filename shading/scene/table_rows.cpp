#include "shading/scene/setting_rows.h"

#include <algorithm>

#include "shading/scene/setting_choices.h"
#include "shading/scene/setting_field.h"
#include "shading/scene/setting_needs.h"

namespace xnewell {

using namespace needs;

namespace {

bool brightest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}) == 1.0; }

}  // namespace

std::vector<Setting> tableRows() {
  return {
      {.key = "table.kind",
       .option = "--table",
       .label = "table",
       .control = 'T',
       .section = Section::ColourTable,
       .is = "which intensity the i-th shade of the colour table stands for",
       .role = Role::shortCut("linear"),
       .field = chooses<kTables>([](auto& s) -> auto& { return s.table.kind; }),
       .need = {inRamps, "cells that hold ramps; here they hold colours"},
       .phrase = "{}",
       .alwaysSaid = true},
      {.key = "table.shades",
       .option = "--shades",
       .label = "shades",
       .control = 'c',
       .section = Section::ColourTable,
       .is = "cells of the ramp from dark to bright",
       .role = Role::shortCut(kMaxShades),
       .field = holds([](auto& s) -> auto& { return s.table.shades; }),
       .range = {2, kMaxShades},
       .slider = Slider{2, kMaxShades, 1},
       .trials = {8, 32, 64, 128, kMaxShades},
       .need = {shaded, "ramps and chosen colours; a cube always has 240"},
       .phrase = "{} shades"},
      {.key = "table.i0",
       .option = "--i0",
       .label = "I0",
       .control = 'o',
       .section = Section::ColourTable,
       .is = "lowest intensity of the corrected table, where each shade is r times the one before",
       .role = Role::shortCut(0.02),
       .field = holds([](auto& s) -> auto& { return s.table.I0; }),
       .range = {0, 1, true},
       .slider = Slider{0.001, 0.5, 0.01, true, 3},
       .trials = {0.005, 0.02, 0.1},
       .need = kCorrected,
       .differsIn = "table"},
      {.key = "table.pick",
       .option = "--pick",
       .label = "pick",
       .control = 'J',
       .is = "how the corrected table picks the nearest shade",
       .role = Role::shortCut("search"),
       .field = chooses<kPickLabels>([](auto& s) -> auto& { return s.table.pick; }),
       .need = kCorrected,
       .differsIn = "table",
       .phrase = "nearest by {}"},
      {.key = "table.hue",
       .option = "--hue",
       .label = "hue",
       .control = 'H',
       .is = "hue of the ramp; gray suits projectors and red-blind eyes",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.table.hue; }),
       .letters = "r,g,b",
       .allowed = brightest,
       .allowedAre = "where the largest is 1",
       .need = {inOneHue, "one hue (--colors one); here the scene's own colours are shown"}},
      {.key = "table.bits",
       .option = "--bits",
       .label = "bits",
       .control = 'B',
       .is = "bits per red, green and blue value in a cell",
       .role = Role::shortCut("16"),
       .field = chooses<kBits>([](auto& s) -> auto& { return s.table.bits; }),
       .phrase = "{} bits"},
  };
}

}  // namespace xnewell
