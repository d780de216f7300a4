#include "shading/diagnose/hypothesis.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <vector>

namespace xnewell {

namespace rows {

namespace {

using S = PictureSettings;
using M = Meaning;

bool isLinear(const S& s) { return s.table.kind == TableKind::Linear; }
bool isEvenTable(const S& s) { return isEven(s.table.kind); }
bool isCorrected(const S& s) { return !isEvenTable(s); }
bool hasVertices(const S& s) { return rowOf(s.shading).interpolates; }
bool isTwoSided(const S& s) { return s.light.twoSided; }
template <Shading method>
bool is(const S& s) {
  return s.shading == method;
}
template <Shading method>
bool isNo(const S& s) {
  return s.shading != method;
}
// With other lights, such a mistake is what the scene asks for.
bool isFar(const Light& light) { return light.kind == LightKind::Directional; }
bool isPlaced(const Light& light) { return !isFar(light); }
template <Attenuation way>
bool fadesOtherThan(const Light& light) {
  return isPlaced(light) && light.attenuation != way;
}

using V = std::string_view;
using Forms = std::vector<Approach>;
/// The forms of one key.
using Rows = std::vector<Hypothesis>;
using Applies = bool (*)(const S&);
using Changes = bool (*)(const Light&);
Rows rows(M meaning, V key, V term, V sentence, const Forms& forms, Applies applies, Changes changes) {
  Rows all;
  for (const Approach& form : forms) all.push_back({key, sentence, term, meaning, form, applies, changes});
  return all;
}
Rows wrong(V key, V term, V is, const Forms& forms, Applies applies = nullptr, Changes changes = nullptr) {
  return rows(M::Wrong, key, term, is, forms, applies, changes);
}
Rows allowed(V key, V term, V is, const Forms& forms, Applies applies = nullptr) {
  return rows(M::Allowed, key, term, is, forms, applies, nullptr);
}
Rows number(V key, V term, V is, const Forms& forms) {
  return rows(M::Numbers, key, term, is, forms, nullptr, nullptr);
}
/// A mistake of the editable equation: its words are there. The forms do more than it.
Rows shared(Mistake mistake, V term, Forms forms = {{}}) {
  const MistakeRow& row = rowOf(mistake);
  for (Approach& form : forms) {
    Approach more = {.equation = row};
    more.add(form);
    form = more;
  }
  return wrong(row.name, term, row.is, forms);
}

constexpr std::string_view NL = "max(0, N.L)", RV = "max(0, R.V)", VN = "N at a vertex", color = "color(I)";

/// What a program computes once and uses twice has a form for each reach of a mistake in it: N.L counts in
/// the diffuse term, in R, and in whether a highlight is added; V counts in R.V, and turns N.
std::vector<Rows> rowsBeforeViews() {
  return {
      rows(M::Right, "right", "", "It is right.", {{}}, nullptr, nullptr),
      allowed("table-gamma", "table", "The stored values are v^(1/2.2), as some courses ask.",
              {{.store = StoreWay::Gamma}, {.store = StoreWay::Gamma8}}),
      allowed("L-constant", "L", "L is the same everywhere, as of a light far away.",
              {{.light = TowardsLight::Constant}}),
      allowed("V-constant", "V", "V is the same everywhere, as of an eye far away.",
              {{.eye = TowardsEye::Constant}, {.equation = {.turnsByV = true}, .eye = TowardsEye::Constant}}),
      allowed("half-vector", "R.V", "The highlight is (N.H)^n, with the halfway vector.",
              {{.form = Form::HalfVector}}),
      allowed("half-vector-V-constant", "R.V; V", "The highlight is (N.H)^n, and V is the same everywhere.",
              {{.form = Form::HalfVector, .eye = TowardsEye::Constant}}),
      allowed("NL-to-the-n", "R.V", "The highlight is (N.L)^n, as in the tutorial.",
              {{.form = Form::Tutorial}}),
      allowed("first-corner", "P", "The equation is evaluated at a face's first corner.",
              {{.centroid = CentroidWay::FirstCorner}}, is<Shading::Flat>),
      allowed("mean-of-corners", "P", "The equation is evaluated at the mean of a face's corners.",
              {{.centroid = CentroidWay::MeanOfCorners}}, is<Shading::Flat>),
      allowed("triangles-apart", "P", "Polygons are cut into triangles, each with its own centroid.",
              {{.centroid = CentroidWay::OfTriangle},
               {.centroid = CentroidWay::OfTriangle, .otherDiagonal = true}},
              is<Shading::Flat>),
      allowed("three-corners", "N", "N is the normal of three of a face's corners.",
              {{.normal = NormalWay::ThreeCorners},
               {.normal = NormalWay::ThreeCorners, .threeFrom = 1},
               {.normal = NormalWay::ThreeCorners, .threeFrom = 2},
               {.normal = NormalWay::ThreeCorners, .threeFrom = 3}},
              is<Shading::Flat>),
      allowed("other-diagonal", "method", "Polygons are cut along the other diagonal.",
              {{.otherDiagonal = true}}, hasVertices),
      allowed("by-rows", "method", "Intensities are interpolated along edges, then along rows.",
              {{.byRows = true}}, is<Shading::Gouraud>),
      allowed("clamped-late", "I", "I is clamped at the pixels, not at the vertices.", {{.clampsLate = true}},
              is<Shading::Gouraud>),
      allowed("cells-between", color, "Numbers of cells are interpolated, not intensities.",
              {{.cellsBetween = true}}, is<Shading::Gouraud>),
      allowed("affine", "N", "Normals are interpolated over the screen, without perspective.",
              {{.onScreen = true}}, is<Shading::Phong>),
      allowed("VN-sum", VN, "N at a vertex is the sum of the normals of the faces there.",
              {{.rule = NormalRule::Sum}}, hasVertices),
      allowed("VN-distinct", VN, "N at a vertex counts each plane there once.",
              {{.rule = NormalRule::Distinct}}, hasVertices),
      allowed("VN-area", VN, "N at a vertex weighs the faces by area.", {{.rule = NormalRule::Area}},
              hasVertices),
      allowed("VN-angle", VN, "N at a vertex weighs the faces by angle.", {{.rule = NormalRule::Angle}},
              hasVertices),
      allowed("VN-patch", VN, "N at a vertex is the normal of the patch or of the file.",
              {{.rule = NormalRule::File}}, hasVertices),
      allowed("8-bits", "table", "Stored values are rounded to 8 bits, not to 16.",
              {{.store = StoreWay::Rounded8}}, isCorrected),
      allowed("stores-255-I", color, "It stores 255 I, not the table's colour.",
              {{.store = StoreWay::By255}, {.cell = CellWay::Truncated, .store = StoreWay::By255}}),
      allowed("stores-256-I", color, "It stores 256 I, up to 255, not the table's colour.",
              {{.cell = CellWay::Truncated, .store = StoreWay::By256}}),
      allowed("stores-gamma", color, "It stores 255 I^(1/2.2), not the table's colour.",
              {{.store = StoreWay::ByGamma}, {.cell = CellWay::Truncated, .store = StoreWay::ByGamma}}),
      shared(Mistake::FacingUnclamped, NL, {{}, {.equation = {.highlightBehind = true}}}),
      shared(Mistake::FacingAbsolute, NL,
             {{}, {.equation = {.highlightBehind = true}}, {.equation = {.facingFlowsOn = true}}}),
      shared(Mistake::FacingByAngle, NL, {{}, {.equation = {.facingFlowsOn = true}}}),
      shared(Mistake::ReflectedUnclamped, RV),
      shared(Mistake::ReflectedAbsolute, RV),
      shared(Mistake::HighlightBehind, RV, {{}, {.equation = {.facingFlowsOn = true}}}),
      wrong("I-wraps", "min(1, I)", "I is not clamped at 1, so the number of the cell overflows a byte.",
            {{.cellWraps = true}}),
      shared(Mistake::NotUnitN, "N", {{.normal = NormalWay::Newell}, {.normal = NormalWay::CornerProduct}}),
      shared(Mistake::InwardN, "N"),
      wrong("N-one-sided", "N",
            "N is not turned towards the eye, so faces seen from behind are lit as their fronts.",
            {{.oneSided = true}}, isTwoSided),
      wrong("N-in-view-coords", "N", "N is in viewing coordinates, but L and V are in the world's.",
            {{.normal = NormalWay::InViewing},
             {.equation = {.turnsByV = true}, .normal = NormalWay::InViewing}}),
      wrong("N-after-projection", "N", "N is the normal of the projected corners.",
            {{.normal = NormalWay::Warped},
             {.normal = NormalWay::WarpedDeep},
             {.normal = NormalWay::WarpedInPixels}}),
      wrong("VN-triangles-twice", VN,
            "N at a vertex sums triangles, so a polygon that was cut in two counts twice.",
            {{.vertex = VertexWay::TrianglesTwice}}, hasVertices),
      wrong("VN-last-face", VN, "N at a vertex is that of the last face there: = in place of +=.",
            {{.vertex = VertexWay::LastFace}}, hasVertices),
      wrong("VN-own-face", VN, "N at a vertex is the normal of the face itself.",
            {{.vertex = VertexWay::OwnFace}}, hasVertices),
      wrong("VN-sum-not-unit", VN, "N at a vertex is a sum that is not divided by its length.",
            {{.vertex = VertexWay::SumNotUnit}}, hasVertices),
      wrong("VN-mean-not-unit", VN, "N at a vertex is a mean, which is shorter than a unit vector.",
            {{.vertex = VertexWay::MeanNotUnit}}, hasVertices),
      shared(Mistake::ReversedL, "L"),
      wrong("L-not-unit", "L", "L is not divided by its length.", {{.light = TowardsLight::NotUnit}}),
      wrong("L-direction-as-place", "L", "The direction to the light is taken for the light's place.",
            {{.light = TowardsLight::DirectionAsPlace}}, nullptr, isFar),
      wrong("L-place-as-direction", "L", "The place of the light is taken for the direction to it.",
            {{.light = TowardsLight::PlaceAsDirection}, {.light = TowardsLight::FarPlace}}, nullptr,
            isPlaced),
      shared(Mistake::ReversedV, "V", {{}, {.equation = {.turnsByV = true}}}),
      wrong("V-not-unit", "V", "V is not divided by its length.", {{.eye = TowardsEye::NotUnit}}),
      wrong(
          "V-is-eye", "V", "V is the place of the eye, without - P.",
          {{.eye = TowardsEye::PlaceOfEye}, {.equation = {.turnsByV = true}, .eye = TowardsEye::PlaceOfEye}}),
      wrong("V-from-look-at", "V", "V points to the look-at point, not to the eye.",
            {{.eye = TowardsEye::FromLookAt}}),
      shared(Mistake::ReversedR, "R"),
      shared(Mistake::RWithout2, "R"),
      wrong("R-plus-L", "R", "R is 2 N (N.L) + L, so it is no unit vector and leans towards the light.",
            {{.equation = {.LinR = 1}}}),
      wrong("R.L", "R.V", "The highlight has (R.L)^n, not (R.V)^n.", {{.equation = {.highlightAtL = true}}}),
      shared(Mistake::PowerOfSum, "n"),
      shared(Mistake::NoPower, "n"),
      wrong("n-times", "n", "The highlight has n (R.V), not (R.V)^n.",
            {{.equation = {.power = PowerOf::Factor}}}),
      shared(Mistake::KsInPower, "ks"),
      shared(Mistake::HighlightTimesFacing, "ks"),
      shared(Mistake::NoSpecular, "ks"),
      shared(Mistake::NoDiffuse, "kd"),
      shared(Mistake::SwappedKs, "kd, ks"),
      shared(Mistake::NoAmbient, "ka Ia"),
      shared(Mistake::TwiceAmbient, "ka Ia"),
      wrong("ambient-in-the-dark", "ka Ia", "The ambient term counts only where no light does.",
            {{.ambientInTheDark = true}}),
      wrong("max-for-the-sum", "I", "I is the largest of the terms, not their sum.",
            {{.sum = SumWay::Largest}, {.sum = SumWay::LargerOfLight}}),
      wrong("tone-mapped", "min(1, I)", "I is compressed, as by I/(1 + I), not clamped.",
            {{.sum = SumWay::Tone}, {.sum = SumWay::Exponential}}),
      wrong("I-whole", "I", "I is a whole number, 0 or 1, as by a division of integers.",
            {{.sum = SumWay::Whole}}),
      wrong("ka-forgotten", "ka Ia", "The ambient term is Ia alone, without ka.", {{.noKa = true}}),
      wrong("ka-kd-swapped", "ka, kd", "ka and kd are in each other's place.", {{.swapsKaKd = true}}),
      shared(Mistake::NoIp, "Ip"),
      wrong("Ip-not-on-diffuse", "Ip", "Only the highlight has Ip, so the diffuse term is too bright.",
            {{.equation = {.IpOnDiffuse = false}}}),
      shared(Mistake::IpNotOnHighlight, "Ip"),
      wrong("f-forgotten", "f", "Light does not fade with its distance.", {{.fade = Attenuation::None}},
            nullptr, fadesOtherThan<Attenuation::None>),
      wrong("f-1/d", "f", "Light fades by 1/d.", {{.fade = Attenuation::Inverse}}, nullptr,
            fadesOtherThan<Attenuation::Inverse>),
      wrong("f-1/d2", "f", "Light fades by 1/d^2.", {{.fade = Attenuation::InverseSquare}}, nullptr,
            fadesOtherThan<Attenuation::InverseSquare>),
      wrong("f-above-1", "f", "f has no min(1, .), so a near light counts more than once.",
            {{.fadesAbove1 = true}}, nullptr, fadesOtherThan<Attenuation::None>),
      wrong("f-on-ambient", "f", "The ambient term fades with the distance of the light, too.",
            {{.ambientFades = true}}, nullptr, isPlaced),
      wrong("method-flat", "method", "The faces are shaded flat.", {{.method = Shading::Flat}}, hasVertices),
      wrong("method-gouraud", "method", "The faces have Gouraud shading.", {{.method = Shading::Gouraud}},
            isNo<Shading::Gouraud>),
      wrong("method-phong", "method", "The faces have Phong shading.", {{.method = Shading::Phong}},
            isNo<Shading::Phong>),
      wrong("depth-cue", "method", "The faces are shaded by depth: nearer is brighter.",
            {{.method = Shading::Depth}}),
      wrong("gouraud-averages-faces", "method",
            "A vertex has the mean of the intensities of its faces, not that of its own N.",
            {{.meansOfFaces = true}}, is<Shading::Gouraud>),
      wrong("phong-not-renormalised", "N", "Interpolated normals are not made unit vectors again.",
            {{.longNormals = true}}, is<Shading::Phong>),
      wrong("cell-off-by-one", color, "The first cell is one too low.", {{.cell = CellWay::OneLess}}),
      wrong("cell-one-more", color, "The first cell is one too high.", {{.cell = CellWay::OneMore}}),
      wrong("cell-ceil", color, "color(I) is rounded up.", {{.cell = CellWay::Upwards}}),
      wrong("cell-240I", color, "color(I) has 240 I, not 239 I.", {{.cell = CellWay::By240}}, isEvenTable),
      wrong("cell-255I", color, "color(I) has 255 I, not 239 I.", {{.cell = CellWay::By255}}, isEvenTable),
      wrong("cell-floor", color, "color(I) is cut off, not rounded.", {{.cell = CellWay::Truncated}}),
      wrong("cell-first-forgotten", color, "The first cell is forgotten: shades begin at cell 0.",
            {{.cell = CellWay::FromZero}}),
      wrong("cell-log-in-linear", color, "color(I) has the logarithm, but the table is even.",
            {{.cell = CellWay::Ratios}}, isEvenTable),
      wrong("cell-natural-log", color, "The logarithm is to the base e, not r.",
            {{.cell = CellWay::NaturalLog}}, isCorrected),
      wrong("cell-I0-forgotten", color, "The logarithm is that of I, not of I/I0.",
            {{.cell = CellWay::NoI0}, {.cell = CellWay::NoI0Wraps}}, isCorrected),
      wrong("cell-linear-in-corrected", color, "color(I) is even, but the table is corrected.",
            {{.cell = CellWay::Even}}, isCorrected),
      wrong("table-i-11", "table", "Cell i holds (i - 11)/255.", {{.store = StoreWay::Minus11}}, isLinear),
      wrong("table-8-bit-in-16", "table", "Values up to 255 are stored where the server takes up to 65535.",
            {{.store = StoreWay::EightIn16}}),
      wrong("table-r-240-steps", "table", "r has 240 steps from I0 to 1, not 239.",
            {{.store = StoreWay::Ratio240}, {.cell = CellWay::Ratio240, .store = StoreWay::Ratio240}},
            isCorrected),
      wrong("table-r-64-steps", "table", "r is that of a table of 64 shades.",
            {{.cell = CellWay::Ratio64, .store = StoreWay::Ratio64}, {.store = StoreWay::Ratio64}},
            isCorrected),
      wrong("table-linear", "table", "The table and color(I) are even, as in linear.",
            {{.table = TableKind::Linear}}, isCorrected),
      wrong("table-corrected", "table", "The table and color(I) have equal ratios, as in corrected.",
            {{.table = TableKind::Corrected}}, isEvenTable),
      wrong("table-reversed", "table", "The table runs from bright to dark.",
            {{.store = StoreWay::Backwards}}),
      wrong("order-none", "order",
            "The faces are painted as they are listed: unsorted, or z is lost in the projection.",
            {{.paint = PaintWay::Listed}}),
      wrong("order-reversed", "order", "The faces are painted from front to back.",
            {{.paint = PaintWay::Reversed}}),
      wrong("order-nearest-z", "order", "The faces are sorted by their nearest z, not their farthest.",
            {{.paint = PaintWay::NearestZ}}),
      wrong("cull-front", "order", "The fronts are culled in place of the backs.",
            {{.paint = PaintWay::BacksOnly}}),
  };
}

/// Mistakes of shading in viewing coordinates; and numbers that are often other ones. These are tried only if
/// no mistake fits.
std::vector<Rows> rowsAfterViews() {
  return {
      wrong("N-not-turned", "N", "N is in the world's coordinates, but L and V are in those of the view.",
            {{.normal = NormalWay::NotTurned}}),
      wrong("N-by-M", "N", "N is transformed by the matrix itself, not by its inverse transpose.",
            {{.normal = NormalWay::ByMatrix}}),
      wrong("N-scaled", "N", "N is not made a unit vector again after the scaling S.",
            {{.normal = NormalWay::Scaled}}),
      wrong("L-not-moved", "L", "The light stays in the world's coordinates where N and V are in the view's.",
            {{.light = TowardsLight::NotMoved}}),
      number("n-half", "n", "n is half of what it should be.", {{.nTimes = 0.5}}),
      number("n-double", "n", "n is twice what it should be.", {{.nTimes = 2}}),
      number("light-x", "L", "x of the light has the other sign.", {{.lightSigns = {-1, 1, 1}}}),
      number("light-y", "L", "y of the light has the other sign.", {{.lightSigns = {1, -1, 1}}}),
      number("light-z", "L", "z of the light has the other sign.", {{.lightSigns = {1, 1, -1}}}),
      number("light-yz", "L", "y and z of the light are in each other's place.",
             {{.swapsLightYz = true}, {.lightSigns = {1, 1, -1}, .swapsLightYz = true}}),
  };
}

Rows allRows() {
  Rows all;
  for (const Rows& row : rowsBeforeViews()) all.insert(all.end(), row.begin(), row.end());
  for (const ViewMistake& row : viewMistakes())
    all.push_back({row.key, row.sentence, "view", row.isAllowed ? M::Allowed : M::Wrong, {.view = &row}});
  for (const Rows& row : rowsAfterViews()) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// Where two ways differ.
using E = EquationWay;
using A = Approach;
constexpr auto kOfEquation = std::make_tuple(
    &E::N, &E::L, &E::V, &E::longN, &E::turnsByV, &E::NinR, &E::LinR, &E::highlightAtL, &E::facing,
    &E::reflected, &E::facingFlowsOn, &E::highlightBehind, &E::power, &E::highlightTimesFacing, &E::ambient,
    &E::diffuse, &E::specular, &E::swapsKdKs, &E::IpOnDiffuse, &E::IpOnHighlight);
constexpr auto kOthers = std::make_tuple(
    &A::method, &A::form, &A::cellWraps, &A::normal, &A::oneSided, &A::rule, &A::vertex, &A::light, &A::eye,
    &A::ambientInTheDark, &A::sum, &A::noKa, &A::swapsKaKd, &A::fade, &A::fadesAbove1, &A::ambientFades,
    &A::centroid, &A::threeFrom, &A::meansOfFaces, &A::longNormals, &A::onScreen, &A::otherDiagonal,
    &A::byRows, &A::clampsLate, &A::cellsBetween, &A::cell, &A::store, &A::table, &A::paint, &A::view,
    &A::number, &A::nTimes, &A::lightSigns, &A::swapsLightYz);

/// Takes those fields from `other` that differ from the default.
template <class Fields, class Of>
void take(const Fields& fields, const Of& other, Of& way) {
  const Of usual = {};
  std::apply(
      [&](auto... field) {
        ((other.*field != usual.*field ? void(way.*field = other.*field) : void()), ...);
      },
      fields);
}

}  // namespace

}  // namespace rows

void Approach::add(const Approach& other) {
  rows::take(rows::kOfEquation, other.equation, equation);
  rows::take(rows::kOthers, other, *this);
}

Approach Approach::with(const PictureSettings& s) const {
  Approach way = *this;
  way.method = method.value_or(s.shading);
  way.form = equation.changesR() || equation.highlightAtL ? Form::Textbook : form.value_or(s.light.form);
  way.rule = rule.value_or(s.normals);
  way.table = table.value_or(s.table.kind);
  way.oneSided |= !s.light.twoSided;
  way.equation.turnsByV &= !way.oneSided;
  way.byRows |= s.polygons == Polygons::Rows;
  way.cellsBetween |= s.interpolated == Interpolated::Cell;
  way.longNormals |= s.unnormalized;
  way.onScreen |= s.unnormalized || s.mapping == TextureMapping::Affine;
  if (s.light.constantL && light == TowardsLight::Unit) way.light = TowardsLight::Constant;
  if (s.light.constantV && eye == TowardsEye::Unit) way.eye = TowardsEye::Constant;
  // A program need not know that a cosine is at most 1: its vectors may be of any length.
  if (equation.reflected == Clamp::Cosine) way.equation.reflected = Clamp::Positive;
  return way;
}

std::span<const Hypothesis> hypotheses() {
  static const std::vector<Hypothesis> all = rows::allRows();
  return all;
}

const Hypothesis& rowOfNumber(NumberOf which) {
  const auto row = [](std::string_view key, std::string_view sentence) {
    return Hypothesis{key, sentence, key, Meaning::Numbers};
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

}  // namespace xnewell
