#include "shading/diagnose/hypothesis.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "shading/diagnose/hypothesis_rows.h"

namespace xnewell {

namespace {

using namespace rows;

/// What the course allows.
void addAllowed(std::vector<Hypothesis>& all) {
  constexpr std::string_view kStores255 = "It stores 255 I, not the table's colour.";
  constexpr std::string_view kTriangles = "Polygons are cut into triangles, each with its own centroid.";
  constexpr std::string_view kThree = "N is the normal of three of a face's corners.";
  constexpr std::string_view kStoresGamma = "It stores 255 I^(1/2.2), not the table's colour.";
  all.insert(
      all.end(),
      {allowed("table-gamma", "table", "The stored values are v^(1/2.2), as some courses ask.",
               [](W& w) { w.store = StoreWay::Gamma; }),
       allowed("L-constant", "L", "L is the same everywhere, as of a light far away.",
               [](W& w) { w.light = TowardsLight::Constant; }),
       allowed("V-constant", "V", "V is the same everywhere, as of an eye far away.",
               [](W& w) { w.eye = TowardsEye::Constant; }),
       allowed("V-constant", "V", "V is the same everywhere, as of an eye far away.", isTwoSided,
               [](W& w) { w.eye = TowardsEye::Constant, w.turnsByV = true; }),
       allowed("half-vector", "R.V", "The highlight is (N.H)^n, with the halfway vector.",
               [](W& w) { w.cosine = CosineWay::Halfway; }),
       allowed("half-vector-V-constant", "R.V; V", "The highlight is (N.H)^n, and V is the same everywhere.",
               [](W& w) { w.cosine = CosineWay::Halfway, w.eye = TowardsEye::Constant; }),
       allowed("NL-to-the-n", "R.V", "The highlight is (N.L)^n, as in the tutorial.",
               [](W& w) { w.cosine = CosineWay::Facing; }),
       allowed("first-corner", "P", "The equation is evaluated at a face's first corner.", isFlat,
               [](W& w) { w.centroid = CentroidWay::FirstCorner; }),
       allowed("mean-of-corners", "P", "The equation is evaluated at the mean of a face's corners.", isFlat,
               [](W& w) { w.centroid = CentroidWay::MeanOfCorners; }),
       allowed("triangles-apart", "P", kTriangles, isFlat,
               [](W& w) { w.centroid = CentroidWay::OfTriangle; }),
       allowed("triangles-apart", "P", kTriangles, isFlat,
               [](W& w) { w.centroid = CentroidWay::OfTriangle, w.otherDiagonal = true; }),
       allowed("three-corners", "N", kThree, isFlat, [](W& w) { w.normal = NormalWay::ThreeCorners; }),
       allowed("three-corners", "N", kThree, isFlat,
               [](W& w) { w.normal = NormalWay::ThreeCorners, w.threeFrom = 1; }),
       allowed("three-corners", "N", kThree, isFlat,
               [](W& w) { w.normal = NormalWay::ThreeCorners, w.threeFrom = 2; }),
       allowed("three-corners", "N", kThree, isFlat,
               [](W& w) { w.normal = NormalWay::ThreeCorners, w.threeFrom = 3; }),
       allowed("other-diagonal", "method", "Polygons are cut along the other diagonal.", hasVertices,
               [](W& w) { w.otherDiagonal = true; }),
       allowed("by-rows", "method", "Intensities are interpolated along edges, then along rows.", isGouraud,
               [](W& w) { w.byRows = true; }),
       allowed("clamped-late", "I", "I is clamped at the pixels, not at the vertices.", isGouraud,
               [](W& w) { w.clampsLate = true; }),
       allowed("cells-between", "color(I)", "Numbers of cells are interpolated, not intensities.", isGouraud,
               [](W& w) { w.cellsBetween = true; }),
       allowed("affine", "N", "Normals are interpolated over the screen, without perspective.", isPhong,
               [](W& w) { w.onScreen = true; }),
       allowed("VN-sum", "N at a vertex", "N at a vertex is the sum of the normals of the faces there.",
               hasVertices, [](W& w) { w.vertex = VertexWay::Sum; }),
       allowed("VN-distinct", "N at a vertex", "N at a vertex counts each plane there once.", hasVertices,
               [](W& w) { w.vertex = VertexWay::Distinct; }),
       allowed("VN-area", "N at a vertex", "N at a vertex weighs the faces by area.", hasVertices,
               [](W& w) { w.vertex = VertexWay::Area; }),
       allowed("VN-angle", "N at a vertex", "N at a vertex weighs the faces by angle.", hasVertices,
               [](W& w) { w.vertex = VertexWay::Angle; }),
       allowed("VN-patch", "N at a vertex", "N at a vertex is the normal of the patch or of the file.",
               hasVertices, [](W& w) { w.vertex = VertexWay::Patch; }),
       allowed("8-bits", "table", "Stored values are rounded to 8 bits, not to 16.", isCorrected,
               [](W& w) { w.store = StoreWay::Rounded8; }),
       allowed("stores-255-I", "color(I)", kStores255, [](W& w) { w.store = StoreWay::By255; }),
       allowed("stores-255-I", "color(I)", kStores255,
               [](W& w) { w.store = StoreWay::By255, w.cell = CellWay::Truncated; }),
       allowed("stores-256-I", "color(I)", "It stores 256 I, up to 255, not the table's colour.",
               [](W& w) { w.store = StoreWay::By256, w.cell = CellWay::Truncated; }),
       allowed("stores-gamma", "color(I)", kStoresGamma, [](W& w) { w.store = StoreWay::ByGamma; }),
       allowed("stores-gamma", "color(I)", kStoresGamma,
               [](W& w) { w.store = StoreWay::ByGamma, w.cell = CellWay::Truncated; })});
}

/// A form of a mistake that flows on into the turning of N towards the eye.
Hypothesis turning(Hypothesis row) {
  row.applies = isTwoSided;
  return row;
}

/// A mistake that changes only such lights. With others, it is what the scene asks for.
Hypothesis with(bool (*light)(const Light&), Hypothesis row) {
  row.changes = light;
  return row;
}
bool isFar(const Light& light) { return light.kind == LightKind::Directional; }
bool isPlaced(const Light& light) { return !isFar(light); }
bool fades(const Light& light) { return isPlaced(light) && light.attenuation != Attenuation::None; }

/// What a program computes once and uses twice has a row for each reach of a mistake in it: N.L counts in the
/// diffuse term, in R, and in whether a highlight is added; V counts in R.V, and turns N.
void addEquation(std::vector<Hypothesis>& all) {
  constexpr std::string_view NL = "max(0, N.L)", RV = "max(0, R.V)";
  all.insert(
      all.end(),
      {shared(Mistake::FacingUnclamped, NL, [](W& w) { w.facing = ClampWay::Signed; }),
       shared(Mistake::FacingUnclamped, NL,
              [](W& w) { w.facing = ClampWay::Signed, w.highlightBehind = true; }),
       shared(Mistake::FacingAbsolute, NL, [](W& w) { w.facing = ClampWay::Absolute; }),
       shared(Mistake::FacingAbsolute, NL,
              [](W& w) { w.facing = ClampWay::Absolute, w.highlightBehind = true; }),
       shared(Mistake::FacingAbsolute, NL,
              [](W& w) { w.facing = ClampWay::Absolute, w.facingFlowsOn = true; }),
       shared(Mistake::FacingByAngle, NL, [](W& w) { w.facing = ClampWay::ByAngle; }),
       shared(Mistake::FacingByAngle, NL, [](W& w) { w.facing = ClampWay::ByAngle, w.facingFlowsOn = true; }),
       shared(Mistake::ReflectedUnclamped, RV, [](W& w) { w.reflected = ClampWay::Signed; }),
       shared(Mistake::ReflectedAbsolute, RV, [](W& w) { w.reflected = ClampWay::Absolute; }),
       shared(Mistake::HighlightBehind, RV, [](W& w) { w.highlightBehind = true; }),
       shared(Mistake::HighlightBehind, RV, [](W& w) { w.highlightBehind = true, w.facingFlowsOn = true; }),
       wrong("I-wraps", "min(1, I)", "I is not clamped at 1, so the number of the cell overflows a byte.",
             [](W& w) { w.cellWraps = true; }),
       shared(Mistake::NotUnitN, "N", [](W& w) { w.normal = NormalWay::Newell; }),
       shared(Mistake::NotUnitN, "N", [](W& w) { w.normal = NormalWay::CornerProduct; }),
       shared(Mistake::InwardN, "N", [](W& w) { w.normal = NormalWay::Inward; }),
       wrong("N-one-sided", "N",
             "N is not turned towards the eye, so faces seen from behind are lit as their "
             "fronts.",
             isTwoSided, [](W& w) { w.twoSided = false; }),
       wrong("N-in-view-coords", "N", "N is in viewing coordinates, but L and V are in the world's.",
             [](W& w) { w.normal = NormalWay::InViewing; }),
       wrong("N-in-view-coords", "N", "N is in viewing coordinates, but L and V are in the world's.",
             isTwoSided, [](W& w) { w.normal = NormalWay::InViewing, w.turnsByV = true; }),
       wrong("N-after-projection", "N", "N is the normal of the projected corners.",
             [](W& w) { w.normal = NormalWay::Warped; }),
       wrong("N-after-projection", "N", "N is the normal of the projected corners.",
             [](W& w) { w.normal = NormalWay::WarpedDeep; }),
       wrong("N-after-projection", "N", "N is the normal of the projected corners.",
             [](W& w) { w.normal = NormalWay::WarpedInPixels; }),
       wrong("VN-triangles-twice", "N at a vertex",
             "N at a vertex sums triangles, so a polygon that was cut in two counts twice.", hasVertices,
             [](W& w) { w.vertex = VertexWay::TrianglesTwice; }),
       wrong("VN-last-face", "N at a vertex",
             "N at a vertex is that of the last face there: = in place of +=.", hasVertices,
             [](W& w) { w.vertex = VertexWay::LastFace; }),
       wrong("VN-own-face", "N at a vertex", "N at a vertex is the normal of the face itself.", hasVertices,
             [](W& w) { w.vertex = VertexWay::OwnFace; }),
       wrong("VN-sum-not-unit", "N at a vertex", "N at a vertex is a sum that is not divided by its length.",
             hasVertices, [](W& w) { w.vertex = VertexWay::SumNotUnit; }),
       wrong("VN-mean-not-unit", "N at a vertex",
             "N at a vertex is a mean, which is shorter than a unit "
             "vector.",
             hasVertices, [](W& w) { w.vertex = VertexWay::MeanNotUnit; }),
       shared(Mistake::ReversedL, "L", [](W& w) { w.light = TowardsLight::Away; }),
       wrong("L-not-unit", "L", "L is not divided by its length.",
             [](W& w) { w.light = TowardsLight::NotUnit; }),
       with(isFar,
            wrong("L-direction-as-place", "L", "The direction to the light is taken for the light's place.",
                  [](W& w) { w.light = TowardsLight::DirectionAsPlace; })),
       with(isPlaced,
            wrong("L-place-as-direction", "L", "The place of the light is taken for the direction to it.",
                  [](W& w) { w.light = TowardsLight::PlaceAsDirection; })),
       with(isPlaced,
            wrong("L-place-as-direction", "L", "The place of the light is taken for the direction to it.",
                  [](W& w) { w.light = TowardsLight::FarPlace; })),
       shared(Mistake::ReversedV, "V", [](W& w) { w.eye = TowardsEye::Away; }),
       turning(shared(Mistake::ReversedV, "V", [](W& w) { w.eye = TowardsEye::Away, w.turnsByV = true; })),
       wrong("V-not-unit", "V", "V is not divided by its length.", [](W& w) { w.eye = TowardsEye::NotUnit; }),
       wrong("V-is-eye", "V", "V is the place of the eye, without - P.",
             [](W& w) { w.eye = TowardsEye::PlaceOfEye; }),
       wrong("V-is-eye", "V", "V is the place of the eye, without - P.", isTwoSided,
             [](W& w) { w.eye = TowardsEye::PlaceOfEye, w.turnsByV = true; }),
       wrong("V-from-look-at", "V", "V points to the look-at point, not to the eye.",
             [](W& w) { w.eye = TowardsEye::FromLookAt; }),
       shared(Mistake::ReversedR, "R", [](W& w) { w.cosine = CosineWay::Reversed; }),
       shared(Mistake::RWithout2, "R", [](W& w) { w.cosine = CosineWay::Without2; }),
       wrong("R-plus-L", "R", "R is 2 N (N.L) + L, so it is no unit vector and leans towards the light.",
             [](W& w) { w.cosine = CosineWay::PlusL; }),
       wrong("R.L", "R.V", "The highlight has (R.L)^n, not (R.V)^n.",
             [](W& w) { w.cosine = CosineWay::WithL; }),
       shared(Mistake::PowerOfSum, "n", [](W& w) { w.power = PowerWay::OfSum; }),
       shared(Mistake::NoPower, "n", [](W& w) { w.power = PowerWay::Forgotten; }),
       wrong("n-times", "n", "The highlight has n (R.V), not (R.V)^n.",
             [](W& w) { w.power = PowerWay::Times; }),
       shared(Mistake::KsInPower, "ks", [](W& w) { w.power = PowerWay::WithKs; }),
       shared(Mistake::HighlightTimesFacing, "ks", [](W& w) { w.highlightTimesFacing = true; }),
       shared(Mistake::NoSpecular, "ks", [](W& w) { w.specular = 0; }),
       shared(Mistake::NoDiffuse, "kd", [](W& w) { w.diffuse = 0; }),
       shared(Mistake::SwappedKs, "kd, ks", [](W& w) { w.swapsKdKs = true; }),
       shared(Mistake::NoAmbient, "ka Ia", [](W& w) { w.ambient = 0; }),
       shared(Mistake::TwiceAmbient, "ka Ia", [](W& w) { w.ambient = 2; }),
       wrong("ambient-in-the-dark", "ka Ia", "The ambient term counts only where no light does.",
             [](W& w) { w.ambientInTheDark = true; }),
       wrong("max-for-the-sum", "I", "I is the largest of the terms, not their sum.",
             [](W& w) { w.sum = SumWay::Largest; }),
       wrong("max-for-the-sum", "I", "I is the largest of the terms, not their sum.",
             [](W& w) { w.sum = SumWay::LargerOfLight; }),
       wrong("tone-mapped", "min(1, I)", "I is compressed, as by I/(1 + I), not clamped.",
             [](W& w) { w.sum = SumWay::Tone; }),
       wrong("tone-mapped", "min(1, I)", "I is compressed, as by I/(1 + I), not clamped.",
             [](W& w) { w.sum = SumWay::Exponential; }),
       wrong("I-whole", "I", "I is a whole number, 0 or 1, as by a division of integers.",
             [](W& w) { w.sum = SumWay::Whole; }),
       wrong("ka-forgotten", "ka Ia", "The ambient term is Ia alone, without ka.",
             [](W& w) { w.noKa = true; }),
       wrong("ka-kd-swapped", "ka, kd", "ka and kd are in each other's place.",
             [](W& w) { w.swapsKaKd = true; }),
       shared(Mistake::NoIp, "Ip", [](W& w) { w.Ip = IpWay::Forgotten; }),
       wrong("Ip-not-on-diffuse", "Ip", "Only the highlight has Ip, so the diffuse term is too bright.",
             [](W& w) { w.Ip = IpWay::OnHighlight; }),
       shared(Mistake::IpNotOnHighlight, "Ip", [](W& w) { w.Ip = IpWay::OnDiffuse; }),
       with(fades, wrong("f-forgotten", "f", "Light does not fade with its distance.",
                         [](W& w) { w.fade = FadeWay::Forgotten; })),
       with([](const Light& light) { return isPlaced(light) && light.attenuation != Attenuation::Inverse; },
            wrong("f-1/d", "f", "Light fades by 1/d.", [](W& w) { w.fade = FadeWay::Inverse; })),
       with(
           [](const Light& light) {
             return isPlaced(light) && light.attenuation != Attenuation::InverseSquare;
           },
           wrong("f-1/d2", "f", "Light fades by 1/d^2.", [](W& w) { w.fade = FadeWay::InverseSquare; })),
       with(fades, wrong("f-above-1", "f", "f has no min(1, .), so a near light counts more than once.",
                         [](W& w) { w.fade = FadeWay::NoLimit; })),
       with(isPlaced,
            wrong("f-on-ambient", "f", "The ambient term fades with the distance of the light, too.",
                  [](W& w) { w.fade = FadeWay::OnAmbient; }))});
}

void addMethods(std::vector<Hypothesis>& all) {
  all.insert(all.end(),
             {wrong("method-flat", "method", "The faces are shaded flat.", hasVertices,
                    [](W& w) { w.method = Shading::Flat; }),
              wrong(
                  "method-gouraud", "method", "The faces have Gouraud shading.",
                  [](const S& s) { return !isGouraud(s); }, [](W& w) { w.method = Shading::Gouraud; }),
              wrong(
                  "method-phong", "method", "The faces have Phong shading.",
                  [](const S& s) { return !isPhong(s); }, [](W& w) { w.method = Shading::Phong; }),
              wrong("depth-cue", "method", "The faces are shaded by depth: nearer is brighter.",
                    [](W& w) { w.method = Shading::Depth; }),
              wrong("gouraud-averages-faces", "method",
                    "A vertex has the mean of the intensities of its faces, not that of its own N.",
                    isGouraud, [](W& w) { w.meansOfFaces = true; }),
              wrong("phong-not-renormalised", "N", "Interpolated normals are not made unit vectors again.",
                    isPhong, [](W& w) { w.longNormals = true; })});
}

std::vector<Hypothesis> allRows() {
  std::vector<Hypothesis> all{{"right", "It is right.", "", Meaning::Right, [](W&) {}, nullptr}};
  addAllowed(all);
  addEquation(all);
  addMethods(all);
  addTables(all);
  addPainting(all);
  addViews(all);
  addNumbers(all);
  return all;
}

}  // namespace

std::span<const Hypothesis> hypotheses() {
  static const std::vector<Hypothesis> all = allRows();
  return all;
}

const Hypothesis& rowOfNumber(NumberOf which) {
  const auto row = [](std::string_view key, std::string_view sentence) {
    return Hypothesis{key, sentence, key, Meaning::Numbers, nullptr, nullptr};
  };
  static const std::array<Hypothesis, 7> all{
      row("n", "n is another number."),   row("ka", "ka is another number."),
      row("kd", "kd is another number."), row("ks", "ks is another number."),
      row("Ia", "Ia is another number."), row("Ip", "Ip is another number."),
      row("I0", "I0 is another number."),
  };
  return all[static_cast<std::size_t>(which)];
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
