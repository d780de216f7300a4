#include "shading/diagnose/hypothesis.h"

#include <algorithm>
#include <set>
#include <vector>

namespace xnewell {

namespace {

using W = Approach;
using S = PictureSettings;

bool isLinear(const S& s) { return s.table.kind == TableKind::Linear; }
bool isEvenTable(const S& s) { return isEven(s.table.kind); }
bool isCorrected(const S& s) { return s.table.kind == TableKind::Corrected; }
bool isFlat(const S& s) { return s.shading == Shading::Flat; }
bool isGouraud(const S& s) { return s.shading == Shading::Gouraud; }
bool isPhong(const S& s) { return s.shading == Shading::Phong; }
bool hasVertices(const S& s) { return rowOf(s.shading).interpolates; }
bool isTwoSided(const S& s) { return s.light.twoSided; }

/// A mistake of the editable equation: its words are there.
Hypothesis shared(Mistake mistake, std::string_view term, void (*change)(W&)) {
  const MistakeRow& row = rowOf(mistake);
  return {row.name, row.is, term, Meaning::Wrong, change, nullptr};
}

Hypothesis wrong(std::string_view key, std::string_view term, std::string_view sentence, void (*change)(W&),
                 bool (*applies)(const S&) = nullptr) {
  return {key, sentence, term, Meaning::Wrong, change, applies};
}

Hypothesis allowed(std::string_view key, std::string_view term, std::string_view sentence, void (*change)(W&),
                   bool (*applies)(const S&) = nullptr) {
  return {key, sentence, term, Meaning::Allowed, change, applies};
}

Hypothesis numbers(std::string_view key, std::string_view term, std::string_view sentence,
                   void (*change)(W&)) {
  return {key, sentence, term, Meaning::Numbers, change, nullptr};
}

/// What the course allows.
void addAllowed(std::vector<Hypothesis>& all) {
  all.insert(all.end(),
             {allowed("L-constant", "L", "L is the same everywhere, as of a light far away.",
                      [](W& w) { w.light = TowardsLight::Constant; }),
              allowed("V-constant", "V", "V is the same everywhere, as of an eye far away.",
                      [](W& w) { w.eye = TowardsEye::Constant; }),
              allowed("half-vector", "R.V", "The highlight is (N.H)^n, with the halfway vector.",
                      [](W& w) { w.cosine = CosineWay::Halfway; }),
              allowed("NL-to-the-n", "R.V", "The highlight is (N.L)^n, as in the tutorial.",
                      [](W& w) { w.cosine = CosineWay::Facing; }),
              allowed(
                  "first-corner", "P", "The equation is evaluated at a face's first corner.",
                  [](W& w) { w.centroid = CentroidWay::FirstCorner; }, isFlat),
              allowed(
                  "mean-of-corners", "P", "The equation is evaluated at the mean of a face's corners.",
                  [](W& w) { w.centroid = CentroidWay::MeanOfCorners; }, isFlat),
              allowed(
                  "three-corners", "N", "N is the normal of a face's first three corners.",
                  [](W& w) { w.normal = NormalWay::ThreeCorners; }, isFlat),
              allowed(
                  "other-diagonal", "method", "Polygons are cut along the other diagonal.",
                  [](W& w) { w.otherDiagonal = true; }, hasVertices),
              allowed(
                  "by-rows", "method", "Intensities are interpolated along edges, then along rows.",
                  [](W& w) { w.byRows = true; }, isGouraud),
              allowed(
                  "clamped-late", "I", "I is clamped at the pixels, not at the vertices.",
                  [](W& w) { w.clampsLate = true; }, isGouraud),
              allowed(
                  "cells-between", "color(I)", "Numbers of cells are interpolated, not intensities.",
                  [](W& w) { w.cellsBetween = true; }, isGouraud),
              allowed(
                  "affine", "N", "Normals are interpolated over the screen, without perspective.",
                  [](W& w) { w.onScreen = true; }, isPhong),
              allowed(
                  "VN-sum", "N at a vertex", "N at a vertex is the sum of the normals of the faces there.",
                  [](W& w) { w.vertex = VertexWay::Sum; }, hasVertices),
              allowed(
                  "VN-distinct", "N at a vertex", "N at a vertex counts each plane there once.",
                  [](W& w) { w.vertex = VertexWay::Distinct; }, hasVertices),
              allowed(
                  "VN-area", "N at a vertex", "N at a vertex weighs the faces by area.",
                  [](W& w) { w.vertex = VertexWay::Area; }, hasVertices),
              allowed(
                  "VN-angle", "N at a vertex", "N at a vertex weighs the faces by angle.",
                  [](W& w) { w.vertex = VertexWay::Angle; }, hasVertices),
              allowed(
                  "VN-patch", "N at a vertex", "N at a vertex is the normal of the patch.",
                  [](W& w) { w.vertex = VertexWay::Patch; }, hasVertices),
              allowed(
                  "8-bits", "table", "Stored values are rounded to 8 bits, not to 16.",
                  [](W& w) { w.store = StoreWay::Rounded8; }, isCorrected),
              allowed("direct-colours", "color(I)", "Each channel is 255 I, without a table of few colours.",
                      [](W& w) { w.directColors = true; })});
}

void addEquation(std::vector<Hypothesis>& all) {
  constexpr std::string_view NL = "max(0, N.L)", RV = "max(0, R.V)";
  all.insert(
      all.end(),
      {shared(Mistake::FacingUnclamped, NL, [](W& w) { w.facing = ClampWay::Signed; }),
       shared(Mistake::FacingAbsolute, NL, [](W& w) { w.facing = ClampWay::Absolute; }),
       shared(Mistake::FacingByAngle, NL, [](W& w) { w.facing = ClampWay::ByAngle; }),
       shared(Mistake::ReflectedUnclamped, RV, [](W& w) { w.reflected = ClampWay::Signed; }),
       shared(Mistake::ReflectedAbsolute, RV, [](W& w) { w.reflected = ClampWay::Absolute; }),
       shared(Mistake::HighlightBehind, RV, [](W& w) { w.highlightBehind = true; }),
       wrong("I-wraps", "min(1, I)", "I is not clamped at 1, so the number of the cell overflows a byte.",
             [](W& w) { w.cellWraps = true; }),
       shared(Mistake::NotUnitN, "N", [](W& w) { w.normal = NormalWay::Newell; }),
       shared(Mistake::NotUnitN, "N", [](W& w) { w.normal = NormalWay::CornerProduct; }),
       shared(Mistake::InwardN, "N", [](W& w) { w.normal = NormalWay::Inward; }),
       wrong(
           "N-one-sided", "N",
           "N is not turned towards the eye, so faces seen from behind are lit as their "
           "fronts.",
           [](W& w) { w.twoSided = false; }, isTwoSided),
       wrong("N-in-view-coords", "N", "N is in viewing coordinates, but L and V are in the world's.",
             [](W& w) { w.normal = NormalWay::InViewing; }),
       wrong("N-after-projection", "N", "N is the normal of the projected corners.",
             [](W& w) { w.normal = NormalWay::Warped; }),
       wrong("N-after-projection", "N", "N is the normal of the projected corners.",
             [](W& w) { w.normal = NormalWay::WarpedDeep; }),
       wrong("N-after-projection", "N", "N is the normal of the projected corners.",
             [](W& w) { w.normal = NormalWay::WarpedInPixels; }),
       wrong(
           "VN-triangles-twice", "N at a vertex",
           "N at a vertex sums triangles, so a polygon that was cut in two counts twice.",
           [](W& w) { w.vertex = VertexWay::TrianglesTwice; }, hasVertices),
       wrong(
           "VN-last-face", "N at a vertex", "N at a vertex is that of the last face there: = in place of +=.",
           [](W& w) { w.vertex = VertexWay::LastFace; }, hasVertices),
       wrong(
           "VN-own-face", "N at a vertex", "N at a vertex is the normal of the face itself.",
           [](W& w) { w.vertex = VertexWay::OwnFace; }, hasVertices),
       wrong(
           "VN-sum-not-unit", "N at a vertex", "N at a vertex is a sum that is not divided by its length.",
           [](W& w) { w.vertex = VertexWay::SumNotUnit; }, hasVertices),
       wrong(
           "VN-mean-not-unit", "N at a vertex",
           "N at a vertex is a mean, which is shorter than a unit "
           "vector.",
           [](W& w) { w.vertex = VertexWay::MeanNotUnit; }, hasVertices),
       shared(Mistake::ReversedL, "L", [](W& w) { w.light = TowardsLight::Away; }),
       wrong("L-not-unit", "L", "L is not divided by its length.",
             [](W& w) { w.light = TowardsLight::NotUnit; }),
       wrong("L-direction-as-place", "L", "The direction to the light is taken for the light's place.",
             [](W& w) { w.light = TowardsLight::DirectionAsPlace; }),
       wrong("L-place-as-direction", "L", "The place of the light is taken for the direction to it.",
             [](W& w) { w.light = TowardsLight::PlaceAsDirection; }),
       wrong("L-place-as-direction", "L", "The place of the light is taken for the direction to it.",
             [](W& w) { w.light = TowardsLight::FarPlace; }),
       shared(Mistake::ReversedV, "V", [](W& w) { w.eye = TowardsEye::Away; }),
       wrong("V-not-unit", "V", "V is not divided by its length.", [](W& w) { w.eye = TowardsEye::NotUnit; }),
       wrong("V-is-eye", "V", "V is the place of the eye, without - P.",
             [](W& w) { w.eye = TowardsEye::PlaceOfEye; }),
       shared(Mistake::ReversedR, "R", [](W& w) { w.cosine = CosineWay::Reversed; }),
       shared(Mistake::RWithout2, "R", [](W& w) { w.cosine = CosineWay::Without2; }),
       shared(Mistake::PowerOfSum, "n", [](W& w) { w.power = PowerWay::OfSum; }),
       shared(Mistake::NoPower, "n", [](W& w) { w.power = PowerWay::Forgotten; }),
       shared(Mistake::KsInPower, "ks", [](W& w) { w.power = PowerWay::WithKs; }),
       shared(Mistake::HighlightTimesFacing, "ks", [](W& w) { w.highlightTimesFacing = true; }),
       shared(Mistake::NoSpecular, "ks", [](W& w) { w.specular = 0; }),
       shared(Mistake::NoDiffuse, "kd", [](W& w) { w.diffuse = 0; }),
       shared(Mistake::SwappedKs, "kd, ks", [](W& w) { w.swapsKdKs = true; }),
       shared(Mistake::NoAmbient, "ka Ia", [](W& w) { w.ambient = 0; }),
       shared(Mistake::TwiceAmbient, "ka Ia", [](W& w) { w.ambient = 2; }),
       wrong("ka-forgotten", "ka Ia", "The ambient term is Ia alone, without ka.",
             [](W& w) { w.noKa = true; }),
       wrong("ka-kd-swapped", "ka, kd", "ka and kd are in each other's place.",
             [](W& w) { w.swapsKaKd = true; }),
       shared(Mistake::NoIp, "Ip", [](W& w) { w.Ip = IpWay::Forgotten; }),
       shared(Mistake::IpNotOnHighlight, "Ip", [](W& w) { w.Ip = IpWay::OnDiffuse; }),
       wrong("f-forgotten", "f", "Light does not fade with its distance.",
             [](W& w) { w.fade = FadeWay::Forgotten; }),
       wrong("f-1/d", "f", "Light fades by 1/d.", [](W& w) { w.fade = FadeWay::Inverse; }),
       wrong("f-1/d2", "f", "Light fades by 1/d^2.", [](W& w) { w.fade = FadeWay::InverseSquare; }),
       wrong("f-above-1", "f", "f has no min(1, .), so a near light counts more than once.",
             [](W& w) { w.fade = FadeWay::NoLimit; }),
       wrong("f-on-ambient", "f", "The ambient term fades with the distance of the light, too.",
             [](W& w) { w.fade = FadeWay::OnAmbient; })});
}

void addMethods(std::vector<Hypothesis>& all) {
  all.insert(all.end(),
             {wrong(
                  "method-flat", "method", "The faces are shaded flat.",
                  [](W& w) { w.method = Shading::Flat; }, hasVertices),
              wrong(
                  "method-gouraud", "method", "The faces have Gouraud shading.",
                  [](W& w) { w.method = Shading::Gouraud; }, [](const S& s) { return !isGouraud(s); }),
              wrong(
                  "method-phong", "method", "The faces have Phong shading.",
                  [](W& w) { w.method = Shading::Phong; }, [](const S& s) { return !isPhong(s); }),
              wrong("depth-cue", "method", "The faces are shaded by depth: nearer is brighter.",
                    [](W& w) { w.method = Shading::Depth; }),
              wrong(
                  "gouraud-averages-faces", "method",
                  "A vertex has the mean of the intensities of its faces, not that of its own N.",
                  [](W& w) { w.meansOfFaces = true; }, isGouraud),
              wrong(
                  "phong-not-renormalised", "N", "Interpolated normals are not made unit vectors again.",
                  [](W& w) { w.longNormals = true; }, isPhong)});
}

void addTables(std::vector<Hypothesis>& all) {
  constexpr std::string_view color = "color(I)", table = "table";
  all.insert(
      all.end(),
      {wrong("cell-off-by-one", color, "The first cell is one too low.",
             [](W& w) { w.cell = CellWay::OneLess; }),
       wrong(
           "cell-240I", color, "color(I) has 240 I, not 239 I.", [](W& w) { w.cell = CellWay::By240; },
           isEvenTable),
       wrong(
           "cell-255I", color, "color(I) has 255 I, not 239 I.", [](W& w) { w.cell = CellWay::By255; },
           isEvenTable),
       wrong("cell-floor", color, "color(I) is cut off, not rounded.",
             [](W& w) { w.cell = CellWay::Truncated; }),
       wrong("cell-first-forgotten", color, "The first cell is forgotten: shades begin at cell 0.",
             [](W& w) { w.cell = CellWay::FromZero; }),
       wrong(
           "cell-log-in-linear", color, "color(I) has the logarithm, but the table is even.",
           [](W& w) { w.cell = CellWay::Ratios; }, isEvenTable),
       wrong(
           "cell-natural-log", color, "The logarithm is to the base e, not r.",
           [](W& w) { w.cell = CellWay::NaturalLog; }, isCorrected),
       wrong(
           "cell-I0-forgotten", color, "The logarithm is that of I, not of I/I0.",
           [](W& w) { w.cell = CellWay::NoI0; }, isCorrected),
       wrong(
           "cell-I0-forgotten", color, "The logarithm is that of I, not of I/I0.",
           [](W& w) { w.cell = CellWay::NoI0Wraps; }, isCorrected),
       wrong(
           "cell-linear-in-corrected", color, "color(I) is even, but the table is corrected.",
           [](W& w) { w.cell = CellWay::Even; }, isCorrected),
       wrong(
           "table-i-11", table, "Cell i holds (i - 11)/255.", [](W& w) { w.store = StoreWay::Minus11; },
           isLinear),
       wrong("table-8-bit-in-16", table, "Values up to 255 are stored where the server takes up to 65535.",
             [](W& w) { w.store = StoreWay::EightIn16; }),
       wrong(
           "table-r-240-steps", table, "r has 240 steps from I0 to 1, not 239.",
           [](W& w) { w.store = StoreWay::Ratio240; }, isCorrected),
       wrong(
           "table-r-64-steps", table, "r is that of a table of 64 shades.",
           [](W& w) { w.store = StoreWay::Ratio64; }, isCorrected),
       wrong("table-reversed", table, "The table runs from bright to dark.",
             [](W& w) { w.store = StoreWay::Backwards; }),
       wrong("table-gamma", table, "The stored values are v^(1/2.2).",
             [](W& w) { w.store = StoreWay::Gamma; })});
}

void addPainting(std::vector<Hypothesis>& all) {
  constexpr std::string_view order = "order", screen = "picture";
  all.insert(
      all.end(),
      {wrong("order-none", order, "The faces are painted as they are listed, unsorted.",
             [](W& w) { w.paint = PaintWay::Listed; }),
       wrong("order-reversed", order, "The faces are painted from front to back.",
             [](W& w) { w.paint = PaintWay::Reversed; }),
       wrong("order-nearest-z", order, "The faces are sorted by their nearest z, not their farthest.",
             [](W& w) { w.paint = PaintWay::NearestZ; }),
       wrong("cull-front", order, "The fronts are culled in place of the backs.",
             [](W& w) { w.paint = PaintWay::BacksOnly; }),
       wrong("flip-y", screen, "The picture is upside down: y of the screen runs down.",
             [](W& w) { w.turn = TurnWay::UpsideDown; }),
       wrong("flip-x", screen, "The picture is its mirror image.", [](W& w) { w.turn = TurnWay::Mirrored; }),
       wrong("turned-180", screen, "The picture is turned by 180 degrees.",
             [](W& w) { w.turn = TurnWay::Turned; })});
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
               [](W& w) { w.swapsLightYz = true, w.lightSigns.z = -1; }),
       numbers("Ia-0.1", "Ia", "Ia is 0.1.", [](W& w) { w.Ia = 0.1; }),
       numbers("Ia-0.2", "Ia", "Ia is 0.2.", [](W& w) { w.Ia = 0.2; }),
       numbers("Ia-0.3", "Ia", "Ia is 0.3.", [](W& w) { w.Ia = 0.3; }),
       numbers("Ia-0.5", "Ia", "Ia is 0.5.", [](W& w) { w.Ia = 0.5; }),
       numbers("Ia-1", "Ia", "Ia is 1.", [](W& w) { w.Ia = 1; }),
       numbers("ks-0.5", "ks", "ks is 0.5.", [](W& w) { w.ks = 0.5; }),
       numbers("ks-0.9", "ks", "ks is 0.9.", [](W& w) { w.ks = 0.9; }),
       numbers("ks-1", "ks", "ks is 1.", [](W& w) { w.ks = 1; }),
       numbers("kd-0.5", "kd", "kd is 0.5.", [](W& w) { w.kd = 0.5; }),
       numbers("kd-1", "kd", "kd is 1.", [](W& w) { w.kd = 1; }),
       numbers("ka-1", "ka", "ka is 1.", [](W& w) { w.ka = 1; })});
}

std::vector<Hypothesis> allRows() {
  std::vector<Hypothesis> all{{"right", "It is right.", "", Meaning::Right, [](W&) {}, nullptr}};
  addAllowed(all);
  addEquation(all);
  addMethods(all);
  addTables(all);
  addPainting(all);
  addNumbers(all);
  return all;
}

}  // namespace

std::span<const Hypothesis> hypotheses() {
  static const std::vector<Hypothesis> all = allRows();
  return all;
}

int mistakesKnown() {
  std::set<std::string_view> keys;
  for (const Hypothesis& h : hypotheses())
    if (h.meaning == Meaning::Wrong) keys.insert(h.key);
  return static_cast<int>(keys.size());
}

const Hypothesis* hypothesisNamed(std::string_view key) {
  const auto row = std::ranges::find(hypotheses(), key, &Hypothesis::key);
  return row == hypotheses().end() ? nullptr : &*row;
}

Approach approachOf(const PictureSettings& settings) {
  Approach way;
  way.method = settings.shading;
  way.twoSided = settings.light.twoSided;
  way.byRows = settings.polygons == Polygons::Rows;
  way.cellsBetween = settings.interpolated == Interpolated::Cell;
  way.longNormals = settings.unnormalized;
  way.onScreen = settings.unnormalized || settings.mapping == TextureMapping::Affine;
  if (settings.light.constantL) way.light = TowardsLight::Constant;
  if (settings.light.constantV) way.eye = TowardsEye::Constant;
  return way;
}

}  // namespace xnewell
