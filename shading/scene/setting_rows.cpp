#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "geometry/view/project.h"
#include "shading/color/color_table.h"
#include "shading/scene/settings.h"

namespace xnewell {

namespace {

/// The choices of settings that have no table of their own, or other labels in the window.

template <class Id>
struct NamedRow {
  Id id;
  std::string_view name, label;
};
template <class Id>
struct WordedRow {
  Id id;
  std::string_view name, label;
  std::string_view words;  ///< Choice::words
};
constexpr std::array kCulls{WordedRow<Cull>{Cull::Keep, "none", "keep", "backs kept"},
                            WordedRow<Cull>{Cull::Back, "back", "cull", "backs culled"}};
constexpr std::array kFillers{NamedRow<bool>{true, "x11", "XFillPolygon"},
                              NamedRow<bool>{false, "scanline", "scanline"}};
constexpr std::array kSides{WordedRow<bool>{false, "one", "one", "fronts lit"},
                            WordedRow<bool>{true, "two", "two", "both sides lit"}};
constexpr std::array kPickLabels{NamedRow<Pick>{Pick::Log, kPicks[0].name, "in ratio"},
                                 NamedRow<Pick>{Pick::Search, kPicks[1].name, "in difference"}};
constexpr std::array kBits{NamedRow<int>{8, "8", "8"}, NamedRow<int>{16, "16", "16"}};

/// These functions make the Field of a setting. `member` is a function from the settings to the member that
/// stores the value.

template <class T>
constexpr bool kOptional = false;
template <class T>
constexpr bool kOptional<std::optional<T>> = true;

/// A field for a number, a flag or three numbers, or for an optional number or an optional three numbers,
/// which may stay open.
template <class Member>
Field holds(Member member) {
  using T = std::remove_cvref_t<decltype(member(std::declval<PictureSettings&>()))>;
  Field field;
  if constexpr (std::is_same_v<T, bool>) field.kind = ValueKind::Flag;
  if constexpr (std::is_same_v<T, int>) field.kind = ValueKind::Whole;
  if constexpr (std::is_same_v<T, glm::dvec3> || std::is_same_v<T, std::optional<glm::dvec3>>)
    field.kind = ValueKind::Triple;
  field.get = [=](const PictureSettings& s) -> Value {
    if constexpr (kOptional<T>)
      return member(s) ? Value{*member(s)} : Value{};
    else if constexpr (std::is_same_v<T, glm::dvec3>)
      return member(s);
    else
      return static_cast<double>(member(s));
  };
  field.set = [=](PictureSettings& s, const Value& value) {
    if constexpr (kOptional<T>) {
      member(s).reset();
      if (const auto* v = std::get_if<typename T::value_type>(&value)) member(s) = *v;
    } else if constexpr (std::is_same_v<T, glm::dvec3>) {
      member(s) = std::get<glm::dvec3>(value);
    } else {
      member(s) = static_cast<T>(std::get<double>(value));
    }
  };
  return field;
}

/// True if each row says itself in words, or if rows of this table have no words.
template <class Rows>
constexpr bool allHaveWords(const Rows& rows) {
  return std::ranges::none_of(rows, [](const auto& row) {
    if constexpr (requires { row.words; }) return row.words.empty();
    return false;
  });
}

/// A field for a choice of one of the rows of a table, or for an optional one, which may stay open. A row may
/// have a label and words. The table must live as long as the program.
template <class Rows, class Member>
Field choosesFrom(const Rows& rows, Member member) {
  using T = std::remove_cvref_t<decltype(member(std::declval<PictureSettings&>()))>;
  Field field{.kind = ValueKind::Choice};
  for (const auto& row : rows) {
    Choice choice{.name = row.name, .label = row.name, .words = ""};
    if constexpr (requires { row.label; }) choice.label = row.label;
    if constexpr (requires { row.words; }) choice.words = row.words;
    field.choices.push_back(choice);
  }
  field.get = [member, &rows](const PictureSettings& s) -> Value {
    if constexpr (kOptional<T>)
      if (!member(s)) return {};
    const auto row = std::ranges::find_if(rows, [&](const auto& r) { return member(s) == r.id; });
    return static_cast<double>(row - rows.begin());
  };
  field.set = [member, &rows](PictureSettings& s, const Value& value) {
    if constexpr (kOptional<T>) {
      member(s).reset();
      if (std::holds_alternative<std::monostate>(value)) return;
    }
    member(s) = rows[static_cast<std::size_t>(std::get<double>(value))].id;
  };
  return field;
}
template <const auto& kRows, class Member>
Field chooses(Member member) {
  static_assert(allHaveWords(kRows), "a row of this table has no words");
  return choosesFrom(kRows, member);
}

namespace needs {

/// The conditions under which settings have an effect.

using Facts = const PictureFacts&;

bool interpolates(Facts f) { return rowOf(f.settings.shading).interpolates; }
bool creased(Facts f) {
  const NormalRule rule = f.settings.normals;
  const bool known =
      rule == NormalRule::File ? f.patches || f.normals : rule == NormalRule::Exact && f.patches;
  return interpolates(f) && !known;
}
bool gouraud(Facts f) { return f.settings.shading == Shading::Gouraud; }
bool phong(Facts f) { return f.settings.shading == Shading::Phong; }
bool mapped(Facts f) { return f.settings.shading == Shading::Environment; }
bool dividing(Facts f) {
  return (gouraud(f) || f.settings.shading == Shading::Flat) && f.settings.light.mistake == Mistake::None;
}
bool lit(Facts f) { return rowOf(f.settings.shading).lit; }
bool litInPlace(Facts f) { return lit(f) && !mapped(f); }
/// R stands only in the textbook's form.
bool takesMistake(Facts f) {
  const Illumination& light = f.settings.light;
  return litInPlace(f) && (!rowOf(light.mistake).changesR() || light.form == Form::Textbook);
}
bool textured(Facts f) { return litInPlace(f) && f.textures; }
bool overDepth(Facts f) { return f.settings.shading == Shading::Phong || textured(f); }
bool specular(Facts f) { return lit(f) && f.highlights; }
bool formed(Facts f) { return specular(f) && !mapped(f); }
bool asksForEye(Facts f) { return formed(f) && f.settings.light.form != Form::Tutorial; }
bool fadesLinearly(Facts f) { return f.settings.light.attenuation == Attenuation::Linear; }
bool fadesAsTextbook(Facts f) { return f.settings.light.attenuation == Attenuation::Textbook; }
bool inColors(Facts f) { return f.plan == ColorPlan::Cube || f.plan == ColorPlan::Chosen; }
bool inRamps(Facts f) { return !inColors(f); }
bool inOneHue(Facts f) { return f.plan == ColorPlan::OneHue; }
bool shaded(Facts f) { return f.plan != ColorPlan::Cube; }
bool corrected(Facts f) { return inRamps(f) && f.settings.table.kind == TableKind::Corrected; }

constexpr Need kLit{lit, "flat, gouraud, phong and envmap shading, which use light"};
constexpr Need kTextured{textured, "textures, in flat, gouraud and phong shading"};
constexpr Need kSpecular{specular, "highlights: ks above 0 and a shading method that uses light"};
constexpr Need kFormed{
    formed,
    "highlights (ks above 0) of flat, gouraud and phong shading; envmap always uses cos^n of N and L"};
constexpr Need kEye{asksForEye,
                    "highlights (ks above 0) of flat, gouraud and phong shading with V in their form"};
constexpr Need kInPlace{litInPlace, "flat, gouraud and phong shading; for envmap all lights are far away"};
constexpr Need kEvaluated{takesMistake,
                          "flat, gouraud and phong shading, which evaluate the equation; mistakes in "
                          "R only to the textbook's form"};
constexpr Need kCorrected{corrected, "ramps of the corrected table"};

}  // namespace needs

}  // namespace

/// ---- How a picture is made

using namespace needs;
using Unmet = Need::Unmet;

static std::vector<Setting> methodRows() {
  return {
      {.key = "method",
       .option = "--shade",
       .label = "shading",
       .control = 'S',
       .section = Section::Method,
       .is =
           "where the intensity is computed: per face, vertex or pixel, or (env) from a map of surroundings",
       .role = Role::shortCut("phong"),
       .field = chooses<kShadings>([](auto& s) -> auto& { return s.shading; }),
       .alwaysNamed = true},
      {.key = "normals",
       .option = "--normals",
       .label = "normals",
       .control = 'N',
       .section = Section::Method,
       .is = "how a vertex gets its normal: from the faces around it, the patches or the file",
       .role = Role::shortCut("file"),
       .field = chooses<kNormalRules>([](auto& s) -> auto& { return s.normals; }),
       .need = {interpolates, "gouraud, phong and envmap shading, which use normals at vertices"},
       .phrase = "{} normals",
       .alwaysNamed = true},
      {.key = "crease",
       .option = "--crease",
       .label = "crease",
       .control = 'R',
       .section = Section::Method,
       .is = "largest angle between faces that share a vertex normal",
       // A short cut like `normals`: it tells where to guess that polygons stand for a smooth surface. Where
       // that surface is known, its own normals are used, and elsewhere the polygons are all that is known.
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.crease; }),
       .range = {0, 180},
       .unit = "degrees",
       .slider = Slider{0, 180, 2},
       .trials = {0, 30, 180},
       .need =
           {creased,
            "gouraud, phong and envmap shading with normals that are not those of patches or of the file"}},
      {.key = "polygons",
       .option = "--polygons",
       .label = "polygons",
       .is = "how Gouraud shading interpolates over polygons of more than three corners",
       .role = Role::shortCut("triangles"),
       .field = chooses<kPolygons>([](auto& s) -> auto& { return s.polygons; }),
       .need = {gouraud, "gouraud shading"},
       .phrase = "by {}"},
      {.key = "interpolate",
       .option = "--interpolate",
       .label = "interpolated",
       .is = "what Gouraud shading interpolates: the intensity, or the number of its cell",
       .role = Role::shortCut("intensity"),
       .field = chooses<kInterpolated>([](auto& s) -> auto& { return s.interpolated; }),
       .need = {gouraud, "gouraud shading"}},
      {.key = "unnormalized",
       .option = "--unnormalized",
       .label = "N as interpolated",
       .is = "leave Phong's interpolated normals as they are, which is shorter than a unit vector",
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.unnormalized; }),
       .need = {phong, "phong shading"},
       .words = {"N made a unit vector", "N as interpolated"}},
      {.key = "adapt",
       .option = "--adapt",
       .label = "tolerance",
       .is = "divide polygons where flat or Gouraud shading is off by more than this intensity, 0 for none",
       .more = "At most a million pieces are made.",
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.adapt; }),
       .trials = {0, 0.1, 0.03, 0.01},
       .need = {dividing, "flat and gouraud shading without --mistake", Unmet::RefusedOrKept},
       .differsIn = "division"},
      {.key = "environment",
       .option = "--environment",
       .label = "environment",
       .is = "how envmap shading looks up its map",
       .role = Role::shortCut("rotated"),
       .field = chooses<kEnvironmentForms>([](auto& s) -> auto& { return s.environment; }),
       .need = {mapped, "envmap shading"}},
      {.key = "mapping",
       .option = "--mapping",
       .label = "mapping",
       .is = "how texture coordinates, and Phong's normals and places, are interpolated",
       .role = Role::shortCut("perspective"),
       .field = chooses<kTextureMappings>([](auto& s) -> auto& { return s.mapping; }),
       .need = {overDepth, "phong shading and textures"},
       .phrase = "{} mapping"},
      {.key = "order",
       .option = "--order",
       .label = "order",
       .control = 'O',
       .section = Section::Method,
       .is = "hidden-surface method: which faces are painted first, so that later ones cover them",
       .role = Role::shortCut("oracle"),
       .field = chooses<kOrders>([](auto& s) -> auto& { return s.order; }),
       .alwaysNamed = true},
      {.key = "fill",
       .option = "--fill",
       .label = "fill",
       .control = 'F',
       .section = Section::Method,
       .is = "which program fills polygons: the X server or xnewell",
       .role = Role::shortCut("scanline"),
       .field = chooses<kFillers>([](auto& s) -> auto& { return s.inPixels; })},
      {.key = "cull",
       .option = "--cull",
       .label = "backs",
       .control = 'K',
       .section = Section::Method,
       .is = "which faces are culled: back faces or none",
       .role = Role::shortCut("none"),
       .field = chooses<kCulls>([](auto& s) -> auto& { return s.cull; })},
      {.key = "colors",
       .option = "--colors",
       .label = "colours",
       .is = "which colours the cells of the scene hold",
       .role = Role::shortCut("needed"),
       .field = chooses<kColorPlans>([](auto& s) -> auto& { return s.colors; })},
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

/// ---- Lights and surfaces

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr ValueRange kAny{-kUnbounded, kUnbounded}, kNotNegative{0, kUnbounded};
constexpr Slider kShare{0, 1, 0.01, false, 2};

bool direction(const glm::dvec3& v) { return v != glm::dvec3{0.0}; }

}  // namespace

static std::vector<Setting> lightRows() {
  return {
      {.key = "Ia",
       .option = "--ia",
       .label = "Ia",
       .control = 'i',
       .section = Section::Light,
       .is = "intensity of the ambient light, Ia + Ip <= 1",
       .more = "It replaces the scene's.",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.Ia; }),
       .slider = kShare,
       .need = kLit,
       .replaces = "ambient",
       .differsIn = "light"},
      {.key = "Ip",
       .option = "--ip",
       .label = "Ip",
       .control = 'p',
       .section = Section::Light,
       .is = "intensity of the light source, Ia + Ip <= 1",
       .more = "It replaces all lights of the scene.",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.Ip; }),
       .slider = kShare,
       .need = kLit,
       .replaces = "lights",
       .differsIn = "light"},
      {.key = "light",
       .option = "--light",
       .label = "light from",
       .is = "direction towards the light",
       .more = "It replaces all lights of the scene.",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.light; }),
       .range = kAny,
       .letters = "x,y,z",
       .allowed = direction,
       .allowedAre = "not all 0",
       .need = kLit,
       .initially = "from the upper left",
       .replaces = "lights",
       .differsIn = "light"},
      {.key = "light_at",
       .option = "--light-at",
       .label = "light at",
       .is = "position of a point light; it replaces the direction",
       .more = "It replaces all lights of the scene.",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.lightPosition; }),
       .range = kAny,
       .letters = "x,y,z",
       .need = kLit,
       .initially = "infinity",
       .replaces = "lights",
       .differsIn = "light"},
      {.key = "attenuation",
       .option = "--attenuation",
       .label = "attenuation",
       .is = "how lights at places fade with distance d",
       .more = "It replaces what the scene says of its own.",
       .role = Role::model(),
       .field = chooses<kAttenuations>([](auto& s) -> auto& { return s.light.attenuation; }),
       .need = kLit,
       .initially = "none, or the scene's own",
       .differsIn = "light",
       .phrase = "attenuation {}"},
      {.key = "range",
       .option = "--range",
       .label = "range",
       .is = "distance at which attenuation linear reaches 0",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.range; }),
       .range = {0, kUnbounded, true},
       .unit = "world units",
       .need = {fadesLinearly, "attenuation linear", Unmet::Refused},
       .initially = "twice the distance to the scene's centre",
       .differsIn = "light"},
      {.key = "c",
       .option = "--coefficients",
       .label = "c1, c2, c3",
       .is = "coefficients of attenuation textbook, min(1, 1/(c1 + c2 d + c3 d^2))",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.c; }),
       .range = kNotNegative,
       .letters = "c1,c2,c3",
       .need = {fadesAsTextbook, "attenuation textbook", Unmet::Refused},
       .initially = "values that halve the light at the scene's centre",
       .differsIn = "light"},
      {.key = "form",
       .option = "--form",
       .alias = "--half-vector",
       .means = "half-vector",
       .label = "form",
       .is = "which cosine the specular term raises to the n-th power",
       .role = Role::model(),
       .field = chooses<kForms>([](auto& s) -> auto& { return s.light.form; }),
       .need = kFormed,
       .phrase = "{} form"},
      {.key = "mistake",
       .option = "--mistake",
       .label = "equation",
       .control = 'E',
       .is = "a mistake in the equation, to see what comes of it: a term left out, or a step done wrong",
       .more = "`xnewell explain` says what it does and computes with it.",
       .role = Role::model(),
       .field = choosesFrom(
           kMistakes, [](auto& s) -> auto& { return s.light.mistake; }),
       .need = kEvaluated,
       .differsIn = "equation"},
      {.key = "constant_l",
       .option = "--constant-l",
       .label = "L constant",
       .control = 'L',
       .section = Section::Light,
       .is = "take L at the scene's centre everywhere: the light is far away",
       .more = "A spot's share by its cone is still that of each place.",
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.light.constantL; }),
       .need = kInPlace,
       .differsIn = "L",
       .words = {"L from each place", "L constant"}},
      {.key = "constant_v",
       .option = "--constant-v",
       .label = "V constant",
       .control = 'V',
       .section = Section::Light,
       .is = "take V at the look-at point everywhere: the viewer is far away",
       .role = Role::shortCut(0),
       .field = holds([](auto& s) -> auto& { return s.light.constantV; }),
       .need = kEye,
       .differsIn = "V",
       .words = {"V from each place", "V constant"}},
      {.key = "sided",
       .option = "--sided",
       .label = "sides",
       .is = "how many sides of a face are lit",
       .role = Role::model(),
       .field = chooses<kSides>([](auto& s) -> auto& { return s.light.twoSided; }),
       .need = kLit,
       .differsIn = "light"},
      {.key = "ka",
       .option = "--ka",
       .label = "ka",
       .control = 'a',
       .section = Section::Surface,
       .is = "ambient reflection: the share of Ia that the surface reflects",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.ka; }),
       .slider = kShare,
       .need = kLit,
       .replaces = "ka",
       .differsIn = "surface"},
      {.key = "kd",
       .option = "--kd",
       .label = "kd",
       .control = 'd',
       .section = Section::Surface,
       .is = "diffuse reflection: the share of Ip that the surface scatters, times N.L",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.kd; }),
       .slider = kShare,
       .need = kLit,
       .replaces = "kd",
       .differsIn = "surface"},
      {.key = "ks",
       .option = "--ks",
       .label = "ks",
       .control = 's',
       .section = Section::Surface,
       .is = "specular reflection: the share of Ip in the highlight",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.ks; }),
       .slider = kShare,
       .need = kLit,
       .replaces = "ks",
       .differsIn = "surface"},
      {.key = "n",
       .option = "--n",
       .label = "n",
       .control = 'n',
       .section = Section::Surface,
       .is = "specular exponent: how sharp the highlight is, (R.V)^n",
       .role = Role::model(),
       .field = holds([](auto& s) -> auto& { return s.light.n; }),
       .range = {0, 1'000'000},
       .slider = Slider{1, 1000, 0.01, true, 0},
       .need = kSpecular,
       .replaces = "n",
       .differsIn = "surface"},
      {.key = "texel",
       .option = "--texel",
       .label = "texels",
       .is = "what a texel does to the diffuse colour of a surface: it takes its place, or multiplies it",
       .more = "Scenes read from .obj files begin with multiplies, because map_Kd is so defined.",
       .role = Role::model(),
       .field = chooses<kTexelUses>([](auto& s) -> auto& { return s.light.texel; }),
       .need = kTextured,
       .differsIn = "surface",
       .phrase = "a texel {} the colour"},
  };
}

/// ---- The cells of the colour table

namespace {

bool brightest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}) == 1.0; }

}  // namespace

static std::vector<Setting> tableRows() {
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
       .alwaysNamed = true},
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

const std::vector<Setting>& settingRows() {
  static const std::vector<Setting> rows = [] {
    std::vector<Setting> all = methodRows();
    for (const std::vector<Setting>& more : {lightRows(), tableRows()})
      std::ranges::copy(more, std::back_inserter(all));
    return all;
  }();
  return rows;
}

}  // namespace xnewell
