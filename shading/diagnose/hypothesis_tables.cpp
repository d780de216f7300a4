#include "shading/diagnose/hypothesis_rows.h"

namespace xnewell::rows {

/// The rows of the tables, of the painting, and of numbers.

void addTables(std::vector<Hypothesis>& all) {
  constexpr std::string_view color = "color(I)", table = "table";
  all.insert(
      all.end(),
      {wrong("cell-off-by-one", color, "The first cell is one too low.",
             [](W& w) { w.cell = CellWay::OneLess; }),
       wrong("cell-one-more", color, "The first cell is one too high.",
             [](W& w) { w.cell = CellWay::OneMore; }),
       wrong("cell-ceil", color, "color(I) is rounded up.", [](W& w) { w.cell = CellWay::Upwards; }),
       wrong("cell-240I", color, "color(I) has 240 I, not 239 I.", isEvenTable,
             [](W& w) { w.cell = CellWay::By240; }),
       wrong("cell-255I", color, "color(I) has 255 I, not 239 I.", isEvenTable,
             [](W& w) { w.cell = CellWay::By255; }),
       wrong("cell-floor", color, "color(I) is cut off, not rounded.",
             [](W& w) { w.cell = CellWay::Truncated; }),
       wrong("cell-first-forgotten", color, "The first cell is forgotten: shades begin at cell 0.",
             [](W& w) { w.cell = CellWay::FromZero; }),
       wrong("cell-log-in-linear", color, "color(I) has the logarithm, but the table is even.", isEvenTable,
             [](W& w) { w.cell = CellWay::Ratios; }),
       wrong("cell-natural-log", color, "The logarithm is to the base e, not r.", isCorrected,
             [](W& w) { w.cell = CellWay::NaturalLog; }),
       wrong("cell-I0-forgotten", color, "The logarithm is that of I, not of I/I0.", isCorrected,
             [](W& w) { w.cell = CellWay::NoI0; }),
       wrong("cell-I0-forgotten", color, "The logarithm is that of I, not of I/I0.", isCorrected,
             [](W& w) { w.cell = CellWay::NoI0Wraps; }),
       wrong("cell-linear-in-corrected", color, "color(I) is even, but the table is corrected.", isCorrected,
             [](W& w) { w.cell = CellWay::Even; }),
       wrong("table-i-11", table, "Cell i holds (i - 11)/255.", isLinear,
             [](W& w) { w.store = StoreWay::Minus11; }),
       wrong("table-8-bit-in-16", table, "Values up to 255 are stored where the server takes up to 65535.",
             [](W& w) { w.store = StoreWay::EightIn16; }),
       wrong("table-r-240-steps", table, "r has 240 steps from I0 to 1, not 239.", isCorrected,
             [](W& w) { w.store = StoreWay::Ratio240; }),
       wrong("table-r-240-steps", table, "r has 240 steps from I0 to 1, not 239.", isCorrected,
             [](W& w) { w.store = StoreWay::Ratio240, w.cell = CellWay::Ratio240; }),
       wrong("table-r-64-steps", table, "r is that of a table of 64 shades.", isCorrected,
             [](W& w) { w.store = StoreWay::Ratio64, w.cell = CellWay::Ratio64; }),
       wrong("table-linear", table, "The table and color(I) are even, as in linear.", isCorrected,
             [](W& w) { w.table = TableKind::Linear; }),
       wrong("table-corrected", table, "The table and color(I) have equal ratios, as in corrected.",
             isEvenTable, [](W& w) { w.table = TableKind::Corrected; }),
       wrong("table-r-64-steps", table, "r is that of a table of 64 shades.", isCorrected,
             [](W& w) { w.store = StoreWay::Ratio64; }),
       wrong("table-reversed", table, "The table runs from bright to dark.",
             [](W& w) { w.store = StoreWay::Backwards; })});
}

void addPainting(std::vector<Hypothesis>& all) {
  constexpr std::string_view order = "order";
  all.insert(all.end(),
             {wrong("order-none", order,
                    "The faces are painted as they are listed: unsorted, or z is lost in the projection.",
                    [](W& w) { w.paint = PaintWay::Listed; }),
              wrong("order-reversed", order, "The faces are painted from front to back.",
                    [](W& w) { w.paint = PaintWay::Reversed; }),
              wrong("order-nearest-z", order, "The faces are sorted by their nearest z, not their farthest.",
                    [](W& w) { w.paint = PaintWay::NearestZ; }),
              wrong("cull-front", order, "The fronts are culled in place of the backs.",
                    [](W& w) { w.paint = PaintWay::BacksOnly; })});
}

/// The mistakes of the viewing transformation, and those of shading in viewing coordinates.
void addViews(std::vector<Hypothesis>& all) {
  for (const ViewMistake& row : viewMistakes())
    all.push_back({.key = row.key,
                   .sentence = row.sentence,
                   .term = "view",
                   .meaning = row.isAllowed ? Meaning::Allowed : Meaning::Wrong,
                   .change = [](W&) {},
                   .view = &row});
  all.insert(
      all.end(),
      {wrong("N-not-turned", "N", "N is in the world's coordinates, but L and V are in those of the view.",
             [](W& w) { w.normal = NormalWay::NotTurned; }),
       wrong("N-by-M", "N", "N is transformed by the matrix itself, not by its inverse transpose.",
             [](W& w) { w.normal = NormalWay::ByMatrix; }),
       wrong("N-scaled", "N", "N is not made a unit vector again after the scaling S.",
             [](W& w) { w.normal = NormalWay::Scaled; }),
       wrong("L-not-moved", "L",
             "The light stays in the world's coordinates where N and V are in the view's.",
             [](W& w) { w.light = TowardsLight::NotMoved; })});
}

/// Numbers that are often other ones. They are tried only if no mistake fits.
void addNumbers(std::vector<Hypothesis>& all) {
  all.insert(
      all.end(),
      {numbers("n-half", "n", "n is half of what it should be.", [](W& w) { w.nTimes = 0.5; }),
       numbers("n-double", "n", "n is twice what it should be.", [](W& w) { w.nTimes = 2; }),
       numbers("light-x", "L", "x of the light has the other sign.", [](W& w) { w.lightSigns.x = -1; }),
       numbers("light-y", "L", "y of the light has the other sign.", [](W& w) { w.lightSigns.y = -1; }),
       numbers("light-z", "L", "z of the light has the other sign.", [](W& w) { w.lightSigns.z = -1; }),
       numbers("light-yz", "L", "y and z of the light are in each other's place.",
               [](W& w) { w.swapsLightYz = true; }),
       numbers("light-yz", "L", "y and z of the light are in each other's place.",
               [](W& w) { w.swapsLightYz = true, w.lightSigns.z = -1; })});
}

}  // namespace xnewell::rows
