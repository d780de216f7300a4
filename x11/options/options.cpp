#include "x11/options/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

#include "geometry/files/text_file.h"
#include "x11/options/options_check.h"

namespace xnewell {

namespace {

/// Words of the command line that are fixed but do not do anything yet: they say so.
constexpr std::array<std::string_view, 2> kLaterCommands{"figure", "trade"};
constexpr std::array<std::string_view, 1> kLaterOptions{"--json"};

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& expected) {
  throw UsageError{option + ": " + inQuotes(text) + " is not " + expected};
}

/// All of `text` as comma-separated finite numbers, exactly `count` of them.
std::vector<double> numbers(const std::string& option, const std::string& text, std::size_t count,
                            const std::string& expected) {
  std::vector<double> values;
  const char* p = text.data();
  const char* const end = p + text.size();
  for (;;) {
    double v = 0;
    if (p != end && *p == '+') ++p;
    const auto [next, error] = std::from_chars(p, end, v);
    if (error != std::errc{} || !std::isfinite(v)) refuse(option, text, expected);
    values.push_back(v);
    if (next == end) break;
    if (*next != ',') refuse(option, text, expected);
    p = next + 1;
  }
  if (values.size() != count) refuse(option, text, expected);
  return values;
}

/// Options of one family share how they read their text and what they print as default.
class Reader {
 public:
  explicit Reader(CLI::App& app) : app_{app} {}

  /// A number in [low, high], or in (low, high) where `open`.
  template <class Number>
  void number(const std::string& name, Number& target, double low, double high, const std::string& help,
              bool open = false) {
    add(name, trimmed(static_cast<double>(target)), help, [=, &target](const std::string& text) {
      const bool whole = std::is_integral_v<Number>;
      const std::string expected = std::string{whole ? "a whole number" : "a number"} +
                                   (open ? " between " : " from ") + trimmed(low) +
                                   (open ? " and " : " to ") + trimmed(high);
      const double v = numbers(name, text, 1, expected)[0];
      const bool inside = open ? v > low && v < high : v >= low && v <= high;
      if (!inside || (whole && v != std::floor(v))) refuse(name, text, expected);
      target = static_cast<Number>(v);
    });
  }
  void point(const std::string& name, const std::string& help, const std::string& initially, auto&& set,
             const std::string& letters = "x,y,z") {
    add(name, initially, help, [=](const std::string& text) {
      const auto v = numbers(name, text, 3, "three finite numbers " + letters);
      set(glm::dvec3{v[0], v[1], v[2]});
    });
  }
  /// One row of a table of choices, by name.
  template <class Rows, class Id>
  void choice(const std::string& name, const Rows& rows, Id& target, const std::string& help) {
    std::string all;
    std::string initially;
    for (const auto& row : rows) {
      all += (all.empty() ? "" : ", ") + std::string{row.name};
      if (row.id == target) initially = row.name;
    }
    add(name, initially, help + ": " + all, [=, &rows, &target](const std::string& text) {
      const auto row = std::ranges::find(rows, text, [](const auto& r) { return r.name; });
      if (row != rows.end()) {
        target = row->id;
        return;
      }
      refuse(name, text, "one of " + all);
    });
  }
  void text(const std::string& name, const std::string& help, const std::string& initially,
            const std::function<void(const std::string&)>& take) {
    add(name, initially, help, take);
  }
  void flag(const std::string& name, bool& target, const std::string& help) {
    app_.add_flag(name, target, help)->disable_flag_override();
  }

 private:
  static std::string trimmed(double v) {
    std::array<char, 32> text;
    const bool plain = std::abs(v) >= 1e-4 && std::abs(v) < 1e9;
    const auto [end, error] = std::to_chars(text.begin(), text.end(), v,
                                            plain ? std::chars_format::fixed : std::chars_format::general);
    return {text.begin(), end};
  }
  void add(const std::string& name, const std::string& initially, const std::string& help,
           const std::function<void(const std::string&)>& take) {
    app_.add_option_function<std::string>(name, take,
                                          help + (initially.empty() ? "" : " [" + initially + "]"))
        ->type_name("");
  }
  CLI::App& app_;
};

glm::ivec2 parseSize(const std::string& text) {
  const std::string expected = "a size WxH from 1x1 to 8192x8192";
  const std::size_t x = text.find('x');
  if (x == std::string::npos) refuse("--size", text, expected);
  glm::ivec2 size{0};
  const auto part = [&](std::string_view digits, int& v) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), v);
    if (error != std::errc{} || end != digits.data() + digits.size() || v < 1 || v > kMaxPicture)
      refuse("--size", text, expected);
  };
  part(std::string_view{text}.substr(0, x), size.x);
  part(std::string_view{text}.substr(x + 1), size.y);
  return size;
}

Oblique parseOblique(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  Oblique oblique;
  if (kind == "cabinet")
    oblique.length = 0.5;
  else if (kind != "cavalier")
    refuse("--oblique", text, "cavalier or cabinet, with :ANGLE if you like");
  if (colon != std::string::npos)
    oblique.angle = numbers("--oblique", text.substr(colon + 1), 1, "an angle in degrees")[0];
  return oblique;
}

void addCamera(Reader& r, CameraSettings& camera) {
  r.point("--eye", "where the eye is, x,y,z in the world", "the scene framed whole",
          [&](glm::dvec3 p) { camera.eye = p; });
  r.point("--look-at", "what it looks at", "the scene's centre", [&](glm::dvec3 p) { camera.lookAt = p; });
  r.point("--up", "what is up", "z for .bpt, y for .obj", [&](glm::dvec3 p) { camera.up = p; });
  r.text("--fov", "perspective with this vertical field of view, degrees", "30",
         [&](const std::string& text) {
           camera.fov = numbers("--fov", text, 1, "an angle between 0 and 180 degrees")[0];
           if (!(*camera.fov > 0 && *camera.fov < 180))
             refuse("--fov", text, "an angle between 0 and 180 degrees");
         });
  r.text("--parallel", "parallel projection, the picture this many world units tall", "",
         [&](const std::string& text) {
           camera.height = numbers("--parallel", text, 1, "a height above 0")[0];
           if (!(*camera.height > 0)) refuse("--parallel", text, "a height above 0");
           camera.parallel = true;
         });
  r.text("--oblique", "oblique projection: cavalier or cabinet, then :ANGLE if you like", "angle 45",
         [&](const std::string& text) { camera.oblique = parseOblique(text); });
  r.point("--vrp", "the textbook's view reference point", "the look-at point",
          [&](glm::dvec3 p) { camera.vrp = p; });
  r.point("--vpn", "view plane normal", "from there to the eye", [&](glm::dvec3 p) { camera.vpn = p; });
  r.point("--vup", "view up vector", "up", [&](glm::dvec3 p) { camera.vup = p; });
  r.point("--prp", "projection reference point, in viewing coordinates", "the eye",
          [&](glm::dvec3 p) { camera.prp = p; });
  r.text("--view-window",
         "window umin,umax,vmin,vmax on the view plane; the height of --parallel then does not matter", "",
         [&](const std::string& text) {
           const auto v = numbers("--view-window", text, 4, "four finite numbers umin,umax,vmin,vmax");
           camera.window = {v[0], v[1], v[2], v[3]};
         });
  const auto plane = [&](const char* name, const char* help, const char* initially,
                         std::optional<double>& n) {
    r.text(name, help, initially,
           [name, &n](const std::string& text) { n = numbers(name, text, 1, "a finite number")[0]; });
  };
  plane("--front", "front clipping plane, its n", "just before the eye", camera.front);
  plane("--back", "back clipping plane, its n", "behind the scene", camera.back);
}

void addLight(Reader& r, Illumination& light, bool& lightGiven) {
  r.number("--ia", light.Ia, 0, 1, "ambient intensity Ia, in place of the scene's; Ia + Ip <= 1");
  r.number("--ip", light.Ip, 0, 1, "intensity Ip of one light, in place of all lights of the scene");
  r.number("--ka", light.ka, 0, 1, "ambient reflection ka");
  r.number("--kd", light.kd, 0, 1, "diffuse reflection kd");
  r.number("--ks", light.ks, 0, 1, "specular reflection ks");
  r.number("--n", light.n, 0, 1'000'000, "specular exponent n");
  r.point("--light", "direction towards the light, in place of all lights of the scene",
          "from the upper left", [&](glm::dvec3 p) {
            if (p == glm::dvec3{0}) throw UsageError{"--light: 0,0,0 is no direction"};
            light.light = p;
            lightGiven = true;
          });
  r.point("--light-at", "a point light at this place instead", "",
          [&](glm::dvec3 p) { light.lightPosition = p; });
  r.flag("--constant-l", light.constantL,
         "take L at the scene's centre for every face: the light is far away");
  r.flag("--constant-v", light.constantV,
         "take V at the look-at point for every face: the viewer is far away");
  r.choice("--attenuation", kAttenuations, light.attenuation,
           "what distance d leaves of the point light, or of the scene's own");
  r.text("--range", "where attenuation linear reaches 0, in world units",
         "twice the way to the scene's centre", [&](const std::string& text) {
           light.range = numbers("--range", text, 1, "a distance above 0")[0];
           if (!(*light.range > 0)) refuse("--range", text, "a distance above 0");
         });
  r.point(
      "--coefficients", "c1,c2,c3 of attenuation textbook, min(1, 1/(c1 + c2 d + c3 d^2))",
      "half the light at the scene's centre",
      [&](glm::dvec3 c) {
        if (std::min({c.x, c.y, c.z}) < 0)
          throw UsageError{"--coefficients: c1, c2 and c3 must not be negative"};
        light.c = c;
      },
      "c1,c2,c3");
  r.choice("--form", kForms, light.form, "of which cosine the specular term is the n-th power");
}

void addSurfaces(Reader& r, Options& o) {
  r.choice("--normals", kNormalRules, o.picture.normals, "rule for the normals at vertices");
  r.number("--crease", o.picture.crease, 0, 180,
           "degrees; faces that meet at a larger angle share no normal");
  r.choice("--polygons", kPolygons, o.picture.polygons,
           "over what polygons of more than three corners interpolate");
  r.text("--adapt",
         "divide polygons where flat or Gouraud shading misses the illumination by more than this, into a "
         "million at most",
         "divide none", [&](const std::string& text) {
           const std::string expected = "an intensity above 0 and at most 1";
           o.picture.adapt = numbers("--adapt", text, 1, expected)[0];
           if (!(o.picture.adapt > 0 && o.picture.adapt <= 1)) refuse("--adapt", text, expected);
         });
  r.choice("--environment", kEnvironmentForms, o.picture.environment, "how --shade envmap looks up its map");
  r.text("--texture", "a PNG for the diffuse colour of all surfaces", "", [&](const std::string& s) {
    if (s.empty()) throw UsageError{"--texture: the file's name is empty"};
    o.texture = s;
  });
  r.choice("--mapping", kTextureMappings, o.picture.mapping,
           "how texture coordinates, and Phong's normals and places, are interpolated");
  r.choice("--colors", kColorPlans, o.picture.colors, "which colours the cells of the scene hold");
  r.flag("--dither", o.picture.dither, "ordered dithering, where the cells hold colours and not ramps");
}

void addTable(Reader& r, TableSettings& table) {
  r.choice("--table", kTables, table.kind, "colour table");
  r.number("--shades", table.shades, 2, kMaxShades, "shades in the table");
  r.number("--i0", table.I0, 0, 1, "lowest intensity of the corrected table", true);
  r.choice("--pick", kPicks, table.pick, "how the corrected table picks a shade");
  r.point(
      "--hue", "hue r,g,b of the ramp, each 0 to 1, the largest 1", "1,0,0",
      [&](glm::dvec3 h) {
        if (std::min({h.r, h.g, h.b}) < 0 || std::max({h.r, h.g, h.b}) != 1)
          throw UsageError{"--hue: r,g,b must lie from 0 to 1 and the largest must be 1"};
        table.hue = h;
      },
      "r,g,b");
  r.text("--bits", "what a cell keeps of its value: 8 or 16 bits", "16", [&](const std::string& text) {
    if (text != "8" && text != "16") refuse("--bits", text, "8 or 16");
    table.bits = text == "8" ? 8 : 16;
  });
}

/// What is stored in the cells once they are picked.
void addEffects(Reader& r, Options& o) {
  const auto cell = [](const std::string& option, const std::string& text) {
    const std::string expected = "a cell, a whole number from 0 to 255";
    const double v = numbers(option, text, 1, expected)[0];
    if (v < 0 || v > 255 || v != std::floor(v)) refuse(option, text, expected);
    return static_cast<int>(v);
  };
  r.text("--cell", "the cell that --view colours inspects", "the middle one of those that polygons show",
         [&o, cell](const std::string& s) { o.cell = cell("--cell", s); });
  r.text("--store",
         "hold the indices that --table picks and store the colours of this table: brief, linear, corrected",
         "", [&o](const std::string& s) {
           const auto row = std::ranges::find(kTables, s, &TableRow::name);
           if (row == kTables.end()) refuse("--store", s, "one of brief, linear, corrected");
           o.effects.stored = row->id;
         });
  r.number("--turn", o.effects.hueTurn, -360, 360, "turn the hue of all stored colours by degrees");
  r.number("--gamma", o.effects.gamma, kLeastGamma, kMostGamma,
           "store v^(1/gamma) for v: what a screen needs that shows v^gamma");
  r.text("--bend", "CELL,VALUE: drag the curve of stored values there to a value of 255", "",
         [&o, cell](const std::string& s) {
           const std::string expected = "CELL,VALUE with a value from 0 to 255";
           const auto v = numbers("--bend", s, 2, expected);
           if (v[1] < 0 || v[1] > 255) refuse("--bend", s, expected);
           o.effects.bend = CurvePoint{cell("--bend", s.substr(0, s.find(','))), v[1]};
         });
  r.number("--rotate", o.effects.rotate, -255, 255, "move the stored colours up the ramp by so many cells");
  r.text("--lit", "store yellow in this cell: which polygons have this shade?", "",
         [&o, cell](const std::string& s) { o.effects.lit = cell("--lit", s); });
}

/// Two thumbs on one bar: the one that was set pushes the other, so that Ia + Ip <= 1.
void coupleIntensities(Illumination& light, bool iaGiven, bool ipGiven) {
  if (light.Ia + light.Ip <= 1.0) return;
  if (iaGiven && ipGiven) throw UsageError{"--ia and --ip: their sum must not exceed 1"};
  (iaGiven ? light.Ip : light.Ia) = 1.0 - (iaGiven ? light.Ia : light.Ip);
}

/// Splits off the command; `arguments` keeps the rest.
Command takeCommand(std::vector<std::string>& arguments) {
  if (arguments.empty()) return Command::View;
  const std::string first = arguments.front();
  if (std::ranges::find(kLaterCommands, first) != kLaterCommands.end())
    throw UsageError{"the command '" + first + "' is not built yet; `xnewell --help` lists what is"};
  const auto* const row = std::ranges::find(kCommands, first, &CommandRow::name);
  if (row == kCommands.end()) return Command::View;
  arguments.erase(arguments.begin());
  return row->id;
}

/// What CLI11 found wrong, in words of ours.
[[noreturn]] void refuse(const CLI::App& app, const Options& o, const CLI::ParseError& e) {
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    std::vector<std::string> extra = app.remaining();
    std::erase(extra, "--");
    const bool option = extra.front().starts_with('-');
    const bool meansScene = o.command != Command::Lesson;
    if (!option && meansScene && !isBuiltIn(o.scene) && !std::filesystem::exists(o.scene))
      throw UsageError{inQuotes(o.scene) +
                       ": no command, no built-in scene and no file; `xnewell --help` lists the commands"};
    throw UsageError{(option ? "unknown option " : "one argument too many: ") + inQuotes(extra.front())};
  }
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 1 && option->get_items_expected_max() > 0)
      throw UsageError{name + " is given more than once"};
    if (e.what() == name + ": 1 required  missing") throw UsageError{name + " needs a value"};
  }
  throw UsageError{e.what()};
}

/// CLI11 knows one command line; ours has several forms.
class Help : public CLI::Formatter {
  std::string make_usage(const CLI::App*, std::string) const override {
    std::string usage = "\nUsage:\n";
    for (const CommandRow& row : kCommands) {
      usage += "  xnewell " + std::string{row.usage};
      usage +=
          std::string(row.usage.size() < 40 ? 40 - row.usage.size() : 1, ' ') + std::string{row.does} + "\n";
    }
    return usage +
           "\nSCENE is a file (.obj, .bpt, .json) or a built-in name (`xnewell scenes`). Defaults stand in [ "
           "];\n"
           "a scene file may ask for others.\n";
  }
};

/// Every view that draw, snapshot or the window has, once.
std::string viewNames() {
  std::string all;
  for (const ViewRow& row : kViews) all += (all.empty() ? "" : ", ") + std::string{row.name};
  all += "; in a window";
  for (const WindowViewRow& row : kWindowViews)
    if (std::ranges::find(kViews, row.option, &ViewRow::name) == kViews.end())
      all += (all.ends_with("window") ? " " : ", ") + std::string{row.option};
  return all;
}

/// False: there is no view of that name. Which command has it is checked when all is read.
bool takeView(Options& o, const std::string& name) {
  o.viewName = name;
  const auto* const view = std::ranges::find(kViews, name, &ViewRow::name);
  const auto* const window = std::ranges::find(kWindowViews, name, &WindowViewRow::option);
  const auto* const show = std::ranges::find(kShows, name, &ShowRow::name);
  o.view = view == kViews.end() ? View::Picture : view->id;
  o.windowView = window == kWindowViews.end() ? WindowView::Picture : window->id;
  o.show = show == kShows.end() ? Show::Shaded : show->id;
  return view != kViews.end() || window != kWindowViews.end();
}

}  // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv, const PictureSettings& initially) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  Options o;
  o.picture = initially;
  const std::size_t words = arguments.size();
  o.command = takeCommand(arguments);
  o.commandMeant = !arguments.empty() && arguments.size() == words && !arguments.front().starts_with('-');
  for (const std::string& a : arguments)
    if (std::ranges::find(kLaterOptions, a.substr(0, a.find('='))) != kLaterOptions.end())
      throw UsageError{a.substr(0, a.find('=')) + " is not built yet"};

  CLI::App app{"xnewell: shading and hidden surfaces through real X11 colormaps"};
  app.formatter(std::make_shared<Help>());
  app.footer(
      "In the window, `?` shows all keys. Exit status: 0 done, 1 something outside failed, 2 wrong usage or "
      "bad\n"
      "contents, 130 interrupted.");

  Reader r{app};
  app.add_option_function<std::string>(
         "scene", [&](const std::string& s) { o.scene = s; }, "SCENE [teapot]")
      ->type_name("");
  r.text("-o,--output", "where the PNG goes", "", [&](const std::string& s) { o.output = s; });
  r.text("--size", "picture or window size WxH, at most 8192x8192", "800x600, a window 1024x768",
         [&](const std::string& s) { o.size = parseSize(s); });
  r.number("--divisions", o.divisions, 1, kMaxDivisions,
           "each Bezier patch becomes N x N polygons, unless a scene file says so itself");
  r.choice("--shade", kShadings, o.picture.shading, "shading method");
  r.choice("--order", kOrders, o.picture.order, "hidden-surface method");
  r.choice("--fill", kFills, o.fill, "who fills the polygons");
  r.text("--cull", "back faces: back leaves them out, none keeps them", "none", [&](const std::string& s) {
    if (s != "back" && s != "none") refuse("--cull", s, "back or none");
    o.picture.cull = s == "back" ? Cull::Back : Cull::Keep;
  });
  r.text("--sided", "light one side of a face or two", "two", [&](const std::string& s) {
    if (s != "one" && s != "two") refuse("--sided", s, "one or two");
    o.picture.light.twoSided = s == "two";
  });
  addLight(r, o.picture.light, o.lightGiven);
  r.flag("--half-vector", o.halfVector, "the same as --form half-vector");
  addSurfaces(r, o);
  addTable(r, o.picture.table);
  addCamera(r, o.picture.camera);
  r.text("--visual", "insist on a visual, such as PseudoColor8 or TrueColor24", "",
         [&](const std::string& s) {
           if (s.empty()) throw UsageError{"--visual: the name is empty"};
           o.visual = s;
         });
  r.choice("--colormap", kMapOwners, o.colormap,
           "a map of our own, or cells of the default one, as many shades as it has free");
  r.flag("--nearest", o.nearest, "colours that the server has not got: the nearest it has, not mixed");
  r.text("--view", "what to show: " + viewNames(), o.viewName, [&](const std::string& s) {
    if (!takeView(o, s)) refuse("--view", s, viewNames());
  });
  r.text("--scanline", "the row of the picture that --view machbands follows, from 0 at its top",
         "the middle one; where nothing shows there, the one that shows most", [&](const std::string& s) {
           const std::string expected = "a whole number from 0 to " + std::to_string(kMaxPicture - 1);
           const double v = numbers("--scanline", s, 1, expected)[0];
           if (v < 0 || v >= kMaxPicture || v != std::floor(v)) refuse("--scanline", s, expected);
           o.scanline = static_cast<int>(v);
         });
  addEffects(r, o);
  r.text("--ids", "also write the face image: 8-bit RGB, face number + 1, 0 where nothing is", "",
         [&](const std::string& s) {
           if (s.empty()) throw UsageError{"--ids: the file's name is empty"};
           o.ids = s;
         });
  r.flag("--stats", o.stats,
         "print counts and times as one JSON object; its `saturated` counts intensities above 1: of faces "
         "(flat), vertices (gouraud) or pixels as often as painted (phong, envmap, textures)");
  r.flag("--whole-window", o.wholeWindow,
         "snapshot: the window with all its controls; trace --frames: with the stepper at each step");
  r.flag("--quick", o.quick,
         "trace: the accelerated run; without it the textbook's, whose steps grow with the square of the "
         "polygons");
  r.text("--frames",
         "trace: write numbered pictures into this folder, which may hold none yet, instead of lines", "",
         [&](const std::string& s) {
           if (s.empty()) throw UsageError{"--frames: the folder's name is empty"};
           o.frames = s;
         });
  r.choice("--every", kEvery, o.every, "trace: the steps of which --frames makes pictures");

  try {
    std::ranges::reverse(arguments);  // as CLI11 takes them
    app.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return std::nullopt;
  } catch (const CLI::ParseError& e) {
    refuse(app, o, e);
  }
  for (const CLI::Option* option : app.parse_order()) o.given.push_back(option->get_name());
  const auto said = [&](std::string_view option) { return o.gave(option); };
  o.said = {.Ia = said("--ia"),
            .Ip = said("--ip"),
            .light = said("--ip") || said("--light") || said("--light-at"),
            .ka = said("--ka"),
            .kd = said("--kd"),
            .ks = said("--ks"),
            .n = said("--n")};
  if (o.lightGiven && !said("--light-at")) {  // in place of the scene's, and of how that fades
    o.picture.light.lightPosition.reset();
    if (!said("--attenuation")) o.picture.light.attenuation = Attenuation::None;
  }
  coupleIntensities(o.picture.light, o.said.Ia, o.said.Ip);
  // A scene's wish for the window: elsewhere there is no server, and what the user says comes first.
  const bool window = o.command == Command::View || o.command == Command::Snapshot;
  const bool fillable = o.picture.order != Order::Oracle && !rowOf(o.picture.shading).interpolates;
  if (std::exchange(o.picture.inPixels, false) && window && fillable && !said("--fill"))
    o.fill = Fill::XFillPolygon;
  if (o.halfVector) {
    if (said("--form") && o.picture.light.form != Form::HalfVector)
      throw UsageError{"--half-vector and --form exclude each other"};
    o.picture.light.form = Form::HalfVector;
  }
  checkTogether(o);
  return o;
}

}  // namespace xnewell
