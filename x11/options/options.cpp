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
#include "x11/options/read_value.h"

namespace xnewell {

namespace {

/// Commands and options that have a name but do nothing yet. The program says so.
constexpr std::array<std::string_view, 2> kLaterCommands{"figure", "trade"};

/// Adds options to CLI11. The code here reads their values, so that the error messages are in our words.
class Reader {
 public:
  explicit Reader(CLI::App& app) : app_{app} {}

  /// Adds a setting of the picture. Everything comes from its row.
  void setting(const Setting& row, PictureSettings& settings) {
    std::string help{row.is};
    if (row.field.kind != ValueKind::Flag) help += "; " + expected(row);
    if (!row.unit.empty()) help += ", in " + std::string{row.unit};
    if (!row.more.empty()) help += ". " + std::string{row.more};
    const std::string name{row.option};
    if (row.field.kind == ValueKind::Flag) {
      app_.add_flag_callback(
              name, [&row, &settings] { row.field.set(settings, 1.0); }, help)
          ->disable_flag_override();
      return;
    }
    const std::string initially =
        row.initially.empty() ? textOf(row, row.field.get(settings)) : std::string{row.initially};
    text(name, help, initially,
         [&row, &settings](const std::string& given) { row.field.set(settings, valueOf(row, given)); });
  }
  /// Adds a number in [low, high].
  template <class Number>
  void number(const std::string& name, Number& target, double low, double high, const std::string& help) {
    text(name, help, textOf(static_cast<double>(target)), [=, &target](const std::string& given) {
      const bool whole = std::is_integral_v<Number>;
      const std::string needed =
          std::string{whole ? "a whole number" : "a number"} + " from " + textOf(low) + " to " + textOf(high);
      const double v = numbers(name, given, 1, needed)[0];
      if (v < low || v > high || (whole && v != std::floor(v))) refuse(name, given, needed);
      target = static_cast<Number>(v);
    });
  }
  void point(const std::string& name, const std::string& help, const std::string& initially, auto&& set) {
    text(name, help, initially, [=](const std::string& given) {
      const auto v = numbers(name, given, 3, "three finite numbers x,y,z");
      set(glm::dvec3{v[0], v[1], v[2]});
    });
  }
  /// Adds a choice of one row of a table, by its name.
  template <class Rows, class Id>
  void choice(const std::string& name, const Rows& rows, Id& target, const std::string& help) {
    std::string all, initially;
    for (const auto& row : rows) {
      all += (all.empty() ? "" : ", ") + std::string{row.name};
      if (row.id == target) initially = row.name;
    }
    text(name, help + ": " + all, initially, [=, &rows, &target](const std::string& given) {
      const auto row = std::ranges::find(rows, given, [](const auto& r) { return r.name; });
      if (row == rows.end()) refuse(name, given, "one of " + all);
      target = row->id;
    });
  }
  /// Adds the name of a `what`, such as a file. The name must not be empty.
  void named(const std::string& name, std::string& target, const std::string& what, const std::string& help) {
    text(name, help, "", [=, &target](const std::string& given) {
      if (given.empty()) throw UsageError{name + ": the " + what + "'s name is empty"};
      target = given;
    });
  }
  void text(const std::string& name, const std::string& help, const std::string& initially,
            const std::function<void(const std::string&)>& take) {
    app_.add_option_function<std::string>(name, take,
                                          help + (initially.empty() ? "" : " [" + initially + "]"))
        ->type_name("");
  }
  void flag(const std::string& name, bool& target, const std::string& help) {
    app_.add_flag(name, target, help)->disable_flag_override();
  }

 private:
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
    refuse("--oblique", text, "cavalier or cabinet, optionally followed by :ANGLE");
  if (colon != std::string::npos)
    oblique.angle = numbers("--oblique", text.substr(colon + 1), 1, "an angle in degrees")[0];
  return oblique;
}

void addCamera(Reader& r, CameraSettings& camera) {
  r.point("--eye", "where the eye is, x,y,z in the world", "where the whole scene fits",
          [&](glm::dvec3 p) { camera.eye = p; });
  r.point("--look-at", "the point that the eye looks at", "the scene's centre",
          [&](glm::dvec3 p) { camera.lookAt = p; });
  r.point("--up", "the up direction", "z for .bpt, y for .obj", [&](glm::dvec3 p) { camera.up = p; });
  r.text("--fov", "perspective with this vertical field of view, degrees", "30",
         [&](const std::string& text) {
           camera.fov = numbers("--fov", text, 1, "an angle between 0 and 180 degrees")[0];
           if (!(*camera.fov > 0 && *camera.fov < 180))
             refuse("--fov", text, "an angle between 0 and 180 degrees");
         });
  r.text("--parallel", "parallel projection; the picture's height in world units", "",
         [&](const std::string& text) {
           camera.height = numbers("--parallel", text, 1, "a height above 0")[0];
           if (!(*camera.height > 0)) refuse("--parallel", text, "a height above 0");
           camera.parallel = true;
         });
  r.text("--oblique", "oblique projection: cavalier or cabinet, optionally followed by :ANGLE", "angle 45",
         [&](const std::string& text) { camera.oblique = parseOblique(text); });
  r.point("--vrp", "the textbook's view reference point", "the look-at point",
          [&](glm::dvec3 p) { camera.vrp = p; });
  r.point("--vpn", "view plane normal", "from the reference point to the eye",
          [&](glm::dvec3 p) { camera.vpn = p; });
  r.point("--vup", "view up vector", "up", [&](glm::dvec3 p) { camera.vup = p; });
  r.point("--prp", "projection reference point, in viewing coordinates", "the eye",
          [&](glm::dvec3 p) { camera.prp = p; });
  r.text("--view-window",
         "window umin,umax,vmin,vmax on the view plane; it overrides the height of --parallel", "",
         [&](const std::string& text) {
           const auto v = numbers("--view-window", text, 4, "four finite numbers umin,umax,vmin,vmax");
           camera.window = {v[0], v[1], v[2], v[3]};
         });
  const auto plane = [&](const char* name, const char* help, const char* initially,
                         std::optional<double>& n) {
    r.text(name, help, initially,
           [name, &n](const std::string& text) { n = numbers(name, text, 1, "a finite number")[0]; });
  };
  plane("--front", "n of the front clipping plane", "just before the eye", camera.front);
  plane("--back", "n of the back clipping plane", "behind the scene", camera.back);
}

/// Adds the effects on the stored colours, after the indices are picked.
void addEffects(Reader& r, Options& o) {
  const auto cell = [](const std::string& option, const std::string& text) {
    const std::string expected = "a cell, a whole number from 0 to 255";
    const double v = numbers(option, text, 1, expected)[0];
    if (v < 0 || v > 255 || v != std::floor(v)) refuse(option, text, expected);
    return static_cast<int>(v);
  };
  r.text("--cell", "the cell that --view colours inspects", "the middle one of the cells that polygons use",
         [&o, cell](const std::string& s) { o.cell = cell("--cell", s); });
  std::string tables;
  for (const TableRow& row : kTables) tables += (tables.empty() ? "" : ", ") + std::string{row.name};
  r.text("--store", "keep the indices that --table picks, but store the colours of this table: " + tables, "",
         [&o, tables](const std::string& s) {
           const auto row = std::ranges::find(kTables, s, &TableRow::name);
           if (row == kTables.end()) refuse("--store", s, "one of " + tables);
           o.effects.stored = row->id;
         });
  r.number("--turn", o.effects.hueTurn, -360, 360, "turn the hue of all stored colours by degrees");
  r.number("--gamma", o.effects.gamma, kLeastGamma, kMostGamma,
           "store v^(1/gamma) for v, for a screen that shows v^gamma");
  r.text("--bend", "CELL,VALUE: bend the curve of stored values so that this cell holds VALUE of 255", "",
         [&o, cell](const std::string& s) {
           const std::string expected = "CELL,VALUE with a value from 0 to 255";
           const auto v = numbers("--bend", s, 2, expected);
           if (v[1] < 0 || v[1] > 255) refuse("--bend", s, expected);
           o.effects.bend = CurvePoint{cell("--bend", s.substr(0, s.find(','))), v[1]};
         });
  r.number("--rotate", o.effects.rotate, -255, 255, "move the stored colours up the ramp by this many cells");
  r.text("--lit", "store yellow in this cell, to show which polygons have this shade", "",
         [&o, cell](const std::string& s) { o.effects.lit = cell("--lit", s); });
}

/// Takes the command off the arguments. CLI11's subcommands would read `draw -- -s.obj` as an option: in a
/// subcommand they parse what follows `--` as options again.
Command takeCommand(std::vector<std::string>& arguments) {
  if (arguments.empty()) return Command::View;
  const std::string first = arguments.front();
  if (std::ranges::find(kLaterCommands, first) != kLaterCommands.end())
    throw UsageError{"the command '" + first + "' is not built yet; `xnewell --help` lists the commands"};
  const auto* const row = std::ranges::find(kCommands, first, &CommandRow::name);
  if (row == kCommands.end()) return Command::View;
  arguments.erase(arguments.begin());
  return row->id;
}

/// Says in our words what CLI11 found wrong.
[[noreturn]] void refuse(const CLI::App& app, const Options& o, const CLI::ParseError& e) {
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    std::vector<std::string> extra = app.remaining();
    std::erase(extra, "--");
    const bool option = extra.front().starts_with('-');
    const bool meansScene = o.command != Command::Lesson;
    if (!option && meansScene && !isBuiltIn(o.scene) && !std::filesystem::exists(o.scene))
      throw UsageError{inQuotes(o.scene) +
                       ": not a command, a built-in scene or a file; `xnewell --help` lists the commands"};
    throw UsageError{(option ? "unknown option " : "unexpected argument: ") + inQuotes(extra.front())};
  }
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 1 && option->get_items_expected_max() > 0)
      throw UsageError{name + " is given more than once"};
    if (e.what() == name + ": 1 required  missing") throw UsageError{name + " needs a value"};
  }
  throw UsageError{e.what()};
}

/// CLI11 prints one usage line; this prints one for each command.
class Help : public CLI::Formatter {
  std::string make_usage(const CLI::App*, std::string) const override {
    std::string usage = "\nUsage:\n";
    for (const CommandRow& row : kCommands) {
      usage += "  xnewell " + std::string{row.usage};
      usage +=
          std::string(row.usage.size() < 40 ? 40 - row.usage.size() : 1, ' ') + std::string{row.does} + "\n";
    }
    return usage +
           "\nSCENE is a file (.obj, .bpt, .json) or a built-in name (`xnewell scenes`).\n"
           "Defaults are in [ ]; a scene file may set others.\n";
  }
};

/// The names of all views of draw, snapshot and the window, each once.
std::string viewNames() {
  std::string all;
  for (const ViewRow& row : kViews) all += (all.empty() ? "" : ", ") + std::string{row.name};
  all += "; in a window";
  for (const WindowViewRow& row : kWindowViews)
    if (std::ranges::find(kViews, row.option, &ViewRow::name) == kViews.end())
      all += (all.ends_with("window") ? " " : ", ") + std::string{row.option};
  return all;
}

/// Returns false if no view has that name. checkTogether() checks later whether the command has this view.
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

/// Works out what the options mean together, after all of them are read.
void settle(Options& o) {
  o.stats = o.stats || o.errors;
  Illumination& light = o.picture.light;
  if (o.gave("--light") && !o.gave("--light-at")) {  // it replaces the scene's light, and its attenuation too
    light.lightPosition.reset();
    if (!o.gave("--attenuation")) light.attenuation = Attenuation::None;
  }
  if (!keepWithinOne(light, o.gave("--ia"), o.gave("--ip")))
    throw UsageError{"--ia and --ip: their sum must not exceed 1"};
  // Here inPixels is true if --fill or the scene asks for the server's filler. --fill x11 always counts. A
  // scene's wish counts only for view and snapshot, which have a server, and only if the server can fill the
  // polygons.
  const bool server = std::exchange(o.picture.inPixels, false);
  const bool window = o.command == Command::View || o.command == Command::Snapshot;
  const bool fillable = !rowOf(o.picture.order).bySample && !rowOf(o.picture.shading).interpolates;
  if (server && (o.gave("--fill") || (window && fillable))) o.fill = Fill::XFillPolygon;
  if (!o.halfVector) return;
  if (o.gave("--form") && light.form != Form::HalfVector)
    throw UsageError{"--half-vector and --form exclude each other"};
  light.form = Form::HalfVector;
}

}  // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv, const PictureSettings& initially) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  Options o;
  o.picture = initially;
  const std::size_t words = arguments.size();
  o.command = takeCommand(arguments);
  o.commandMeant = !arguments.empty() && arguments.size() == words && !arguments.front().starts_with('-');

  CLI::App app{"xnewell: shading and hidden surfaces through real X11 colormaps"};
  app.formatter(std::make_shared<Help>());
  app.footer(
      "In the window, `?` shows all keys. Exit status: 0 done, 1 a file or the server failed, 2 wrong usage "
      "or "
      "bad\n"
      "contents, 130 interrupted.");

  Reader r{app};
  app.add_option_function<std::string>(
         "scene", [&](const std::string& s) { o.scene = s; }, "SCENE [teapot]")
      ->type_name("");
  r.text("-o,--output", "the PNG file to write", "", [&](const std::string& s) { o.output = s; });
  r.text("--size", "picture or window size WxH, at most 8192x8192",
         "800x600, a window 1024x768, extremes 160x120",
         [&](const std::string& s) { o.size = parseSize(s); });
  r.number("--divisions", o.divisions, 1, kMaxDivisions,
           "each Bezier patch becomes N x N polygons, unless the scene file gives the number");
  for (const Setting& row : settingRows()) r.setting(row, o.picture);
  r.flag("--half-vector", o.halfVector, "the same as --form half-vector");
  r.named("--texture", o.texture, "file", "a PNG for the diffuse colour of all surfaces");
  addCamera(r, o.picture.camera);
  r.named("--visual", o.visual, "visual", "use this visual or fail, for example PseudoColor8 or TrueColor24");
  r.choice("--colormap", kMapOwners, o.colormap,
           "a colormap of its own, or as many cells of the default colormap as are free");
  r.flag("--nearest", o.nearest,
         "show a colour that the server lacks as the nearest one it has, without mixing");
  r.text("--view", "what to show: " + viewNames(), o.viewName, [&](const std::string& s) {
    if (!takeView(o, s)) refuse("--view", s, viewNames());
  });
  r.text("--scanline", "the row of the picture that --view machbands follows, from 0 at its top",
         "the middle row, or the row that shows most if nothing shows there", [&](const std::string& s) {
           const std::string expected = "a whole number from 0 to " + std::to_string(kMaxPicture - 1);
           const double v = numbers("--scanline", s, 1, expected)[0];
           if (v < 0 || v >= kMaxPicture || v != std::floor(v)) refuse("--scanline", s, expected);
           o.scanline = static_cast<int>(v);
         });
  addEffects(r, o);
  r.named("--ids", o.ids, "file",
          "also write the face image: 8-bit RGB, face number + 1, 0 where there is no face");
  r.flag("--stats", o.stats,
         "print counts and times as one JSON object; `saturated` counts intensities above 1 at faces "
         "(flat), at vertices (gouraud), or at pixels each time they are painted (phong, envmap, textures)");
  r.flag("--errors", o.errors,
         "print --stats with the errors of the picture: how far it is from a reference without short cuts, "
         "and where");
  r.flag("--json", o.json, "extremes: print every step as one JSON object instead of the table");
  r.flag("--whole-window", o.wholeWindow,
         "snapshot: the window with all its controls; trace --frames: with the stepper at each step");
  r.flag("--quick", o.quick,
         "trace: follow the accelerated run; the steps of the textbook's run grow with the square of the "
         "polygons");
  r.named(
      "--frames", o.frames, "folder",
      "trace: write numbered pictures into this folder instead of lines; it must not hold any frames yet");
  r.choice("--every", kEvery, o.every, "trace: the steps that --frames draws");

  try {
    std::ranges::reverse(arguments);  // CLI11 takes them in reverse order
    app.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return std::nullopt;
  } catch (const CLI::ParseError& e) {
    refuse(app, o, e);
  }
  for (const CLI::Option* option : app.parse_order()) o.given.push_back(option->get_name());
  settle(o);
  checkTogether(o);
  return o;
}

}  // namespace xnewell
