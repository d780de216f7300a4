#include "x11/options/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/files/input_file.h"
#include "geometry/files/text_file.h"
#include "shading/scene/settings.h"
#include "x11/options/exit_status.h"
#include "x11/options/option_rows.h"
#include "x11/options/setup_command.h"
#include "x11/options/shell_words.h"

namespace xnewell {

namespace {

/// Makes the rows of the options. The code here reads their values, so that the error messages are in our
/// words. Each function returns the new row, until the next one is made.
class Reader {
 public:
  /// Adds a setting of the picture. Everything comes from its row. Its value joins `overrides`.
  OptionRow& setting(const Setting& row, std::vector<Override>& overrides) {
    const bool flag = row.field.kind == ValueKind::Flag;
    std::string help{row.is};
    if (!flag) help += "; " + expected(row);
    if (!row.unit.empty()) help += ", in " + std::string{row.unit};
    if (!row.more.empty()) help += ". " + std::string{row.more};
    const std::string name{row.option};
    std::string initially;
    if (flag)
      help += (help.ends_with('.') ? " " : ". ") + name + "=false ends what the scene asks for";
    else
      initially =
          row.initially.empty() ? textOf(row, row.field.get(PictureSettings{})) : std::string{row.initially};
    OptionRow& made = text(name, help, initially, [&](const std::string& given) {
      overrides.push_back({&row, valueOf(row, given)});
    });
    if (flag) made.takes = Takes::Nothing;
    return made.proposes(row.field.choices);
  }
  /// Adds the alias of a setting.
  OptionRow& alias(const Setting& row, std::vector<Override>& overrides) {
    return flag(std::string{row.alias},
                "the same as " + std::string{row.option} + ' ' + std::string{row.means}, [&] {
                  overrides.push_back({&row, valueOf(row, std::string{row.means})});
                });
  }
  /// Adds a number in [low, high]. `initially` is its default in words, if it is not the number's own; `why`
  /// ends the message that refuses another number.
  template <class Number>
  OptionRow& number(const std::string& name, Number& target, double low, double high, const std::string& help,
                    std::string initially = "", const std::string& why = "") {
    if (initially.empty()) initially = textOf(static_cast<double>(target));
    return text(name, help, initially, [=, &target](const std::string& given) {
      const bool whole = std::is_integral_v<Number>;
      const std::string needed = std::string{whole ? "a whole number" : "a number"} + " from " + textOf(low) +
                                 " to " + textOf(high) + why;
      const double v = numbers(name, given, 1, needed)[0];
      if (v < low || v > high || (whole && v != std::floor(v))) refuse(name, given, needed);
      target = static_cast<Number>(v);
    });
  }
  /// Adds a choice of one row of a table, by its name.
  template <class Rows, class Id>
  OptionRow& choice(const std::string& name, const Rows& rows, Id& target, const std::string& help) {
    std::string all, initially;
    for (const auto& row : rows) {
      all += (all.empty() ? "" : ", ") + std::string{row.name};
      if (row.id == target) initially = row.name;
    }
    return text(name, help + ": " + all, initially,
                [=, &rows, &target](const std::string& given) {
                  const auto row = std::ranges::find(rows, given, [](const auto& r) { return r.name; });
                  if (row == rows.end()) refuse(name, given, "one of " + all);
                  target = row->id;
                })
        .proposes(rows);
  }
  /// Adds the name of a `what`, such as a file. The name must not be empty.
  OptionRow& named(const std::string& name, std::string& target, const std::string& what,
                   const std::string& help) {
    OptionRow& row = text(name, help, "", [=, &target](const std::string& given) {
      if (given.empty()) throw UsageError{name + ": the " + what + "'s name is empty"};
      target = given;
    });
    if (what == "file") row.takes = Takes::File;
    if (what == "folder") row.takes = Takes::Folder;
    return row;
  }
  OptionRow& text(const std::string& name, const std::string& help, const std::string& initially,
                  std::function<void(const std::string&)> take) {
    return rows_.emplace_back(OptionRow{.name = name,
                                        .letter = {},
                                        .does = help + (initially.empty() ? "" : " [" + initially + "]"),
                                        .takes = Takes::Text,
                                        .take = std::move(take)});
  }
  OptionRow& flag(const std::string& name, const std::string& help, std::function<void()> set) {
    OptionRow& row = text(name, help, "", [name, set = std::move(set)](const std::string& given) {
      if (given != "true") throw UsageError{name + " takes no value"};
      set();
    });
    row.takes = Takes::Nothing;
    return row;
  }
  OptionRow& flag(const std::string& name, bool& target, const std::string& help) {
    return flag(name, help, [&target] { target = true; });
  }
  /// The rows, in the order of --help.
  [[nodiscard]] std::vector<OptionRow> rows() && { return std::move(rows_); }

 private:
  std::vector<OptionRow> rows_;
};

/// The keys of settings, or "" for the word none.
std::string parseControls(const std::string& text) {
  if (text == "none") return "";
  if (text.empty()) refuse("--controls", text, "the keys of settings in view 1, such as Ssn, or none");
  for (const char key : text)
    if (settingOf(key) == nullptr)
      refuse("--controls", text, "the keys of settings in view 1, such as Ssn, or none");
  return text;
}

/// The names of all views of draw, snapshot and the window, each once.
std::string viewNames() {
  std::string all;
  for (const ViewRow& row : kViews)
    if (row.hasSheet()) all += (all.empty() ? "" : ", ") + std::string{row.name};
  all += "; in a window";
  for (const ViewRow& row : kWindowViews)
    if (!row.hasSheet()) all += (all.ends_with("window") ? " " : ", ") + std::string{row.name};
  return all;
}

/// Returns false if no view has that name. checkView() checks later whether the command has this view.
bool takeView(Options& o, const std::string& name) {
  const auto* const view = std::ranges::find(kViews, name, &ViewRow::name);
  if (view == kViews.end()) return false;
  o.view = view->id;
  o.window.view = view->key ? view->id : View::Picture;
  o.show = view->key ? View::Picture : view->id;
  return true;
}

/// A row, or a polygon. checkPlaces() knows which of them the command has.
void takeScanline(Options& o, const std::string& text) {
  const std::size_t point = text.find('.');
  const auto isNumber = [](const std::string& s) {
    return !s.empty() && s.size() < 10 && std::ranges::all_of(s, [](char c) { return c >= '0' && c <= '9'; });
  };
  if (!isNumber(text.substr(0, point)) || (point != std::string::npos && !isNumber(text.substr(point + 1))))
    refuse("--scanline", text, "a row or a face, such as 59, or a part of a face, such as 59.2");
  o.window.polygon = text;
  if (const int row = std::stoi(text); point == std::string::npos && row < kMaxPicture)
    o.window.scanline = row;
}

/// What is shown, and where a window begins.
void addView(Reader& r, Options& o) {
  r.text("--view", "what to show: " + viewNames(), std::string{rowOf(o.view).name},
         [&](const std::string& s) {
           if (!takeView(o, s)) refuse("--view", s, viewNames());
         })
      .proposes(kViews)
      .only({"view", "draw", "snapshot"});
  r.number("--step", o.window.step, 0, 1'000'000'000,
           "the step of the depth sort, or the stage of --view viewing, that the window begins with; lesson: "
           "the lesson's step, from 1")
      .only({"--view depthsort", "--view viewing", "--view scanline", "lesson"});
  r.text("--pixel", "the pixel X,Y that the window begins with, in the picture of that view", "its middle",
         [&](const std::string& s) { o.window.pixel = pixelOf("--pixel", s); })
      .only({"--view pixel"});
  r.text("--viewing",
         "explain: what the viewing transformation does to a vertex, FACE.CORNER with corners from 1, or "
         "the number of a vertex, such as 495.1 or 1234; --view viewing begins with it",
         "in the middle of the picture",
         [&](const std::string& s) {
           const bool digits = s.find_first_not_of("0123456789.") == s.npos;
           const bool isOne = s.find('.') == s.rfind('.') && !s.starts_with('.') && !s.ends_with('.');
           if (!digits || !isOne || s.size() > 20)
             refuse("--viewing", s, "FACE.CORNER or the number of a vertex, such as 495.1 or 1234");
           o.window.vertex = s;
         })
      .only({"explain", "--view viewing"})
      .mayLack = true;
  r.text(
       "--controls",
       "the few controls that stand beside a larger picture in view 1, by their keys, such as Ssn; none puts "
       "those of view 1 or 2 away. All keys work all the time",
       "all controls", [&](const std::string& s) { o.window.controls = parseControls(s); })
      .only({"view", "--whole-window"});
  r.text(
       "--scanline",
       "the row of the picture that --view machbands follows, from 0 at its top; --view scanline and "
       "trace: the "
       "polygon that is filled, by its face number, such as 59, or with .2 for the face's second convex part",
       "the middle row, or the row that shows most if nothing shows there; a polygon of about 200 samples",
       [&](const std::string& s) { takeScanline(o, s); })
      .only({"--view machbands", "--view scanline", "trace"});
  r.text("--beside",
         "the settings of B that differ from those of A, such as \"order=none shade=phong\"; same: none of "
         "them",
         "z-sort beside an exact order, Newell's beside any other",
         [&](const std::string& s) { o.window.beside = besideOf(s); })
      .only({"--view sidebyside"});
  r.choice("--difference", kUnlikes, o.window.difference, "what --view sidebyside compares")
      .only({"--view sidebyside"});
}

struct ObliqueRow {
  std::string_view name;
  double length;
};
constexpr std::array kObliques{ObliqueRow{"cavalier", 1.0}, ObliqueRow{"cabinet", 0.5}};

Oblique parseOblique(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto* const row = std::ranges::find(kObliques, text.substr(0, colon), &ObliqueRow::name);
  if (row == kObliques.end()) refuse("--oblique", text, "cavalier or cabinet, optionally followed by :ANGLE");
  Oblique oblique{.length = row->length};
  if (colon != std::string::npos)
    oblique.angle = numbers("--oblique", text.substr(colon + 1), 1, "an angle in degrees")[0];
  return oblique;
}

/// The options of the camera.
void addCamera(Reader& r, CameraSettings& camera) {
  const auto point = [&](const char* name, std::optional<glm::dvec3>& target, const char* help,
                         const char* initially) {
    r.text(name, help, initially, [name, &target](const std::string& text) {
      const auto v = numbers(name, text, 3, "three finite numbers x,y,z");
      target = glm::dvec3{v[0], v[1], v[2]};
    });
  };
  point("--eye", camera.eye, "where the eye is, x,y,z in the world", "where the whole scene fits");
  point("--look-at", camera.lookAt, "the point that the eye looks at", "the scene's centre");
  point("--up", camera.up, "the up direction", "z for .bpt, y for .obj, .ply and .off");
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
         [&](const std::string& text) { camera.oblique = parseOblique(text); })
      .proposes(kObliques);
  point("--vrp", camera.vrp, "the textbook's view reference point", "the look-at point");
  point("--vpn", camera.vpn, "view plane normal", "from the reference point to the eye");
  point("--vup", camera.vup, "view up vector", "up");
  point("--prp", camera.prp, "projection reference point, in viewing coordinates", "the eye");
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

/// The effects on the stored colours, after the indices are picked.
void addEffects(Reader& r, Options& o) {
  const auto cell = [](const std::string& option, const std::string& text) {
    const std::string expected = "a cell, a whole number from 0 to 255";
    const double v = numbers(option, text, 1, expected)[0];
    if (v < 0 || v > 255 || v != std::floor(v)) refuse(option, text, expected);
    return static_cast<int>(v);
  };
  r.text("--cell", "the cell that --view colours inspects", "the middle one of the cells that polygons use",
         [&o, cell](const std::string& s) { o.window.cell = cell("--cell", s); })
      .only({"--view colours"});
  const auto drawn = {std::string_view{"draw"}, std::string_view{"snapshot"}};
  r.choice("--store", kTables, o.effects.stored,
           "keep the indices that --table picks, but store the colours of this table")
      .only(drawn);
  r.number("--turn", o.effects.hueTurn, -360, 360, "turn the hue of all stored colours by degrees")
      .only(drawn);
  r.number("--gamma", o.effects.gamma, kLeastGamma, kMostGamma,
           "store v^(1/gamma) for v, for a screen that shows v^gamma")
      .only(drawn);
  r.text("--bend", "CELL,VALUE: bend the curve of stored values so that this cell holds VALUE of 255", "",
         [&o, cell](const std::string& s) {
           const std::string expected = "CELL,VALUE with a value from 0 to 255";
           const auto v = numbers("--bend", s, 2, expected);
           if (v[1] < 0 || v[1] > 255) refuse("--bend", s, expected);
           o.effects.bend = CurvePoint{cell("--bend", s.substr(0, s.find(','))), v[1]};
         })
      .only(drawn);
  r.number("--rotate", o.effects.rotate, -255, 255, "move the stored colours up the ramp by this many cells")
      .only(drawn);
  r.text("--lit", "store yellow in this cell, to show which polygons have this shade", "",
         [&o, cell](const std::string& s) { o.effects.lit = cell("--lit", s); })
      .only(drawn);
}

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

AccuracyLimit parseAccuracy(const std::string& text) {
  const std::string expected =
      "a number between 0 and 1, and perhaps a comma and a whole number of samples: 0.03 or 0.03,20";
  const std::size_t comma = text.find(',');
  AccuracyLimit limit{numbers("--accuracy", text.substr(0, comma), 1, expected)[0], {}};
  if (!(limit.rms > 0 && limit.rms < 1)) refuse("--accuracy", text, expected);
  if (comma == std::string::npos) return limit;
  const double wrong = numbers("--accuracy", text.substr(comma + 1), 1, expected)[0];
  if (wrong < 0 || wrong > double{kMaxPicture} * kMaxPicture || wrong != std::floor(wrong))
    refuse("--accuracy", text, expected);
  limit.wrong = static_cast<std::int64_t>(wrong);
  return limit;
}

/// Takes the command off the arguments. CLI11's subcommands would read `draw -- -s.obj` as an option: in a
/// subcommand they parse what follows `--` as options again.
Command takeCommand(std::vector<std::string>& arguments) {
  if (arguments.empty()) return Command::View;
  const std::string first = arguments.front();
  const auto* const row = std::ranges::find(kCommands, first, &CommandRow::name);
  if (row == kCommands.end()) return Command::View;
  arguments.erase(arguments.begin());
  return row->id;
}

/// Says in our words what CLI11 found wrong. Only the `last` argument can lack a value: another one takes
/// what follows it.
[[noreturn]] void complain(const CLI::App& app, Command command, int code, const std::string& last) {
  if (code == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    std::vector<std::string> extra = app.remaining();
    std::erase(extra, "--");
    const bool option = extra.front().starts_with('-');
    const bool meansScene = command != Command::Lesson && command != Command::Lecture;
    const CLI::Option* const words = app.get_option("scene");
    const std::string scene = words->count() > 0 ? words->results().front() : Options{}.scene;
    if (!option && meansScene && !isBuiltIn(scene) && !isThere(scene))
      throw UsageError{inQuotes(scene) + ": not a command, a built-in scene or a file; " +
                       didYouMean(scene, commandsAndScenes(), "`xnewell --help` lists the commands")};
    if (!option) throw UsageError{"unexpected argument: " + inQuotes(extra.front())};
    std::vector<std::string> names;
    for (const OptionRow& row : optionRows()) names.push_back(row.name);
    const std::string meant = didYouMean(extra.front().substr(0, extra.front().find('=')), names, "");
    throw UsageError{"unknown option " + inQuotes(extra.front()) + (meant.empty() ? "" : "; " + meant)};
  }
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 1 && option->get_items_expected_max() > 0)
      throw UsageError{option->get_name() + " is given more than once"};
  if (const CLI::Option* const option = app.get_option_no_throw(last.substr(0, last.find('='))))
    throw UsageError{option->get_name() + " needs a value"};
  throw UsageError{inQuotes(last) + " ends no command"};
}

/// ".obj, .ply, .off"
std::string kindsOfScenes() {
  std::string all;
  for (const std::string_view kind : kSceneFiles) all += (all.empty() ? "" : ", ") + std::string{kind};
  return all;
}

/// "0 done, 1 ..."
std::string exitStatuses() {
  std::string all;
  for (const StatusRow& row : kStatuses)
    all += (all.empty() ? "" : ", ") + std::to_string(row.id) + " " + std::string{row.means};
  return all;
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
    return usage + "\nSCENE is a file (" + kindsOfScenes() +
           ") or a built-in name (`xnewell scenes`).\n"
           "A .png is a picture that xnewell wrote: it carries its scene's name and all settings.\n"
           "Defaults are in [ ]; a scene file may set others.\n";
  }
};

/// "ambient, lights, ka ..."
std::string strippable() {
  std::string all;
  for (const std::string_view what : kStrippable) all += (all.empty() ? "" : ", ") + std::string{what};
  return all;
}

/// All options, in the order of --help. They write what they say into `o`.
std::vector<OptionRow> rowsFor(Options& o) {
  Reader r;
  r.flag("--help", "print this help", [] {}).letter = "-h";
  r.flag("--version", "print the version", [] {});
  r.text("scene", "SCENE [teapot, in a window only]", "", [&](const std::string& s) { o.scene = s; });
  if (o.command == Command::Explain)
    r.text("explained", "X,Y, a pixel of the picture", "", [&](const std::string& s) {
      if (o.scene.find_first_not_of("0123456789,") == o.scene.npos && o.scene.find(',') != o.scene.npos)
        throw UsageError{"the scene comes first: xnewell explain " + s + ' ' + o.scene};
      o.pixel = pixelOf("X,Y", s);
    });
  if (const std::string_view what = rowOf(o.command).takes; !what.empty())
    r.text("handed-in", std::string{what}, "", [&](const std::string& s) { o.handedIn = s; });
  OptionRow& output =
      r.text("--output",
             "the PNG file to write; figure: an SVG, PDF or EPS file, by the end of its name; judge: a scene "
             "file; grade: a file of marks",
             "", [&](const std::string& s) { o.output = s; })
          .only({"draw", "snapshot", "figure", "trade", "extremes", "diagnose", "judge", "grade"});
  output.letter = "-o", output.takes = Takes::File;
  r.text("--size",
         "picture or window size WxH, at most 8192x8192; diagnose, judge and grade: that of what is handed "
         "in, if it is not given",
         "800x600, a window 1024x768 times --scale, extremes 160x120",
         [&](const std::string& s) { o.size = parseSize(s); })
      .only({"view", "draw", "snapshot", "figure", "explain", "trace", "trade", "extremes", "diagnose",
             "judge", "grade", "questions", "lesson", "lecture"});
  r.number("--scale", o.scale, 1, kMostScale,
           "how many times as large the window's letters, lines and controls are; the picture keeps its own "
           "pixels. For the window, and for pictures of it. Without it, the screen decides for the window",
           "", "; the letters are made of pixels, and a part of a pixel cannot be drawn")
      .only({"view", "lesson", "lecture", "--whole-window"});
  r.number("--divisions", o.divisions, 1, kMaxDivisions,
           "each Bezier patch becomes N x N polygons, unless the scene file gives the number");
  for (const Setting& row : settingRows()) r.setting(row, o.overrides);
  r.text("--keep",
         "what the scene keeps of its own although options give it, for example ka,n: " + strippable(),
         "nothing", [&](const std::string& s) {
           o.keep = commaWords(s);
           for (const std::string& what : o.keep)
             if (std::ranges::find(kStrippable, what) == kStrippable.end())
               refuse("--keep", s, "names of these, with commas between them: " + strippable());
         });
  r.number("--max-fragments", o.picture.mostPieces, 1, 1'000'000'000,
           "how many pieces the depth sort and the BSP tree make before they give up");
  for (const Setting& row : settingRows())
    if (!row.alias.empty()) r.alias(row, o.overrides);
  r.named("--texture", o.texture, "file", "a PNG for the diffuse colour of all surfaces");
  addCamera(r, o.picture.camera);
  r.named("--visual", o.visual, "visual", "use this visual or fail, for example PseudoColor8 or TrueColor24")
      .only({"view", "snapshot", "lesson", "lecture", "visuals"});
  r.choice("--colormap", kMapOwners, o.colormap,
           "a colormap of its own, or as many cells of the default colormap as are free")
      .only({"view", "snapshot", "lesson", "lecture", "visuals"});
  r.flag("--nearest", o.nearest,
         "show a colour that the server lacks as the nearest one it has, without mixing")
      .only({"view", "snapshot", "lesson", "lecture", "visuals"});
  addView(r, o);
  addEffects(r, o);
  r.named("--ids", o.ids, "file",
          "also write the face image: 8-bit RGB, face number + 1, 0 where there is no face; figure: also "
          "write the "
          "figure in these colours")
      .only({"draw", "snapshot", "figure"});
  const auto color = [&r](const char* name, auto& of, const char* does, const char* usual) -> OptionRow& {
    return r.text(name, does, usual, [name, &of](const std::string& s) {
      if (s.size() != 7 || s[0] != '#' || s.find_first_not_of("0123456789abcdefABCDEF", 1) != s.npos)
        refuse(name, s, "#rrggbb, a colour by six hexadecimal digits");
      const int rgb = std::stoi(s.substr(1), nullptr, 16);
      of = glm::dvec3{rgb >> 16, rgb >> 8 & 255, rgb & 255} / 255.0;
    });
  };
  color("--paper", o.paper, "figure: the colour behind it, such as #ffffff", "none, so that the page shows")
      .only({"figure"});
  r.choice("--edges", kModelEdges, o.edges,
           "the edges of the model's faces as lines, in front or all; hidden ones are dashed")
      .only({"view", "draw", "snapshot", "figure"});
  color("--edge-color", o.edgeColor, "the colour of the edges, such as #808080", "#000000")
      .only({"view", "draw", "snapshot", "figure"});
  r.flag("--smooth", o.smooth,
         "figure, PDF: Gouraud shading as triangles with a colour at each corner, which the reader "
         "interpolates; the file is small, and the shades have no borders")
      .only({"figure"});
  r.number(
       "--tolerance", o.tolerance, 0, 64,
       "figure: how far colours that change over a face may be off, in steps of 1/255; more makes smaller "
       "files")
      .only({"figure"});
  r.flag("--bare", o.bare,
         "the file carries no set-up, so that two files of the same pixels are the same, however they were "
         "drawn")
      .only({"draw", "snapshot", "figure"});
  r.flag("--stats", o.stats,
         "print counts and times as one JSON object; `saturated` counts intensities above 1 at faces "
         "(flat), at vertices (gouraud), or at pixels each time they are painted (phong, envmap, textures)")
      .only({"draw", "snapshot", "figure"});
  r.flag("--errors", o.errors,
         "print --stats with the errors of the picture: how far it is from a reference without short cuts, "
         "and where; with figure, how far the areas are from the picture and from that reference")
      .only({"draw", "snapshot", "figure"});
  r.text(
       "--accuracy",
       "RMS[,WRONG], window, draw, snapshot: measure a trade first, and take the cheapest point of its front "
       "that is off by no more than this intensity (root mean square), and shows a wrong face at no more "
       "samples than WRONG; without WRONG their number does not count. Options that you give stay",
       "", [&](const std::string& s) { o.accuracy = parseAccuracy(s); })
      .only({"view", "draw", "snapshot"});
  r.flag(
       "--json", o.json,
       "explain, trade, extremes, diagnose, judge: print all numbers as one JSON object instead of the text")
      .only({"explain", "trade", "extremes", "diagnose", "judge"});
  r.text("--axes", "trade: only these short cuts, named as their options: shade,order,divisions",
         "all that have an effect",
         [&](const std::string& s) {
           o.trade.axes = commaWords(s);
           if (o.trade.axes.empty()) refuse("--axes", s, "names of options, with commas between them");
         })
      .only({"trade"});
  r.text("--without", "trade: values to leave out, for example order=none,shade=depth", "",
         [&](const std::string& s) { o.trade.without = commaWords(s); })
      .only({"trade"});
  r.number("--budget", o.trade.seconds, 1, 3600,
           "about how many seconds of the processor's time to measure, at most",
           "trade " + textOf(TradeRequest{}.seconds) + ", --accuracy " + textOf(kAccuracySeconds))
      .only({"trade", "--accuracy"});
  r.named("--run", o.window.run, "file",
          "the steps of a depth sort of your own, as xnewell_run.h or trace writes them: view depthsort of a "
          "window shows them; judge: in place of an order")
      .only({"judge", "view", "--whole-window"});
  r.flag("--whole-window", o.wholeWindow,
         "snapshot: the window with all its controls; trace --frames: with the stepper at each step")
      .only({"snapshot", "trace --frames"});
  r.flag("--quick", o.quick,
         "trace: follow the accelerated run; the steps of the textbook's run grow with the square of the "
         "polygons")
      .only({"trace"});
  r.named("--frames", o.frames, "folder",
          "trace: write numbered pictures into this folder instead of lines; it must not hold any frames yet")
      .only({"trace", "lesson"});
  r.choice("--every", kEvery, o.every, "trace: the steps that --frames draws").only({"trace --frames"});
  r.named("--answers", o.answers, "file",
          "lesson, lecture: keep what is answered in this JSON file, beside what it has")
      .only({"lesson", "lecture"});
  r.named("--worksheet", o.worksheet, "file",
          "lesson: write an HTML file to print, with pictures, questions, room to write, and solutions at "
          "the end")
      .only({"lesson"});
  r.text("--scene-for",
         "A,B, diagnose: name the scene, the settings and the pixel that tell these two mistakes apart best, "
         "in place of a picture",
         "",
         [&](const std::string& s) {
           if (s.empty()) refuse("--scene-for", s, "two mistakes, such as RV-abs,RV-unclamped");
           o.sceneFor = s;
         })
      .only({"diagnose"});
  r.named("--page", o.page, "file",
          "grade: also write an HTML file with the pictures in it; lesson, lecture: write the window for "
          "browsers as one HTML file that begins with it")
      .only({"grade", "lesson", "lecture"});
  r.choice("--format", kMarksFormats, o.format,
           "the marks that -o writes, for a spreadsheet, a browser or a course system; those of gradescope, "
           "classroom50 and prairielearn are for a FOLDER of one student")
      .only({"grade"});
  r.named(
       "--rubric", o.rubric, "file",
       "grade: a line a stage: its name, which is that of the file handed in, its points, and the scene and "
       "options that say what is right, if the command line does not")
      .only({"grade"});
  r.named("--feedback", o.feedback, "folder",
          "grade: also write a page for each student into this folder, by the names that Moodle takes back")
      .only({"grade"});
  r.named("--solutions", o.solutions, "file",
          "lesson --worksheet, questions: write the solutions to this file, and not below the questions")
      .only({"lesson --worksheet", "questions"});
  r.number("--count", o.questions, 1, 10'000, "questions: how many").only({"questions"});
  r.number("--seed", o.seed, 0, 1'000'000'000, "questions: another number gives other questions")
      .only({"questions"});
  r.named("--gift", o.gift, "file", "questions: also write a file that Moodle imports, in its GIFT format")
      .only({"questions"});
  r.number(
       "--play", o.play, 0.5, 3600,
       "lecture: seconds without a key or click until a page turns by itself; after the last comes the first",
       "pages wait for a key")
      .only({"lecture"});
  return std::move(r).rows();
}

using Given = std::vector<std::pair<std::string, std::string>>;

/// Splits arguments into options and words without one, each with its text, in their order. Returns nothing
/// if it printed --help or --version. Nothing but this, complain() and Help knows of CLI11.
std::optional<Given> split(const std::vector<OptionRow>& rows, std::vector<std::string> arguments,
                           Command command) {
  CLI::App app{"xnewell: " + std::string{kAbout}};
  app.formatter(std::make_shared<Help>());
  app.footer("In the window, `?` shows all keys.\nExit status: " + exitStatuses() + ".");
  app.set_help_flag();
  // CLI11 compares each option with all before it. Only --help needs those that no argument names.
  const auto named = [&](std::string_view name) {
    return std::ranges::any_of(arguments, [&](const std::string& text) { return text.starts_with(name); });
  };
  const bool all = named("--help") || named("-h");
  for (const OptionRow& row : rows) {
    if (!all && row.isOption() && row.letter.empty() && !named(row.name)) continue;
    const std::string names = (row.letter.empty() ? "" : row.letter + ',') + row.name;
    if (row.takes == Takes::Nothing)
      app.add_flag(names, row.does)->take_last();
    else
      app.add_option(names, row.does)->expected(row.mayLack ? 0 : 1, 1);
  }
  const std::string last = arguments.empty() ? "" : arguments.back();
  const auto asks = [&](const char* option) {
    const CLI::Option* const row = app.get_option_no_throw(option);
    return row != nullptr && row->count() > 0;
  };
  try {
    std::ranges::reverse(arguments);  // CLI11 takes them in reverse order
    app.parse(arguments);
  } catch (const CLI::ParseError& e) {
    if (!asks("--help") && !asks("--version")) complain(app, command, e.get_exit_code(), last);
  }
  if (asks("--help") || asks("--version")) {
    std::cout << (asks("--help") ? app.help() : "xnewell " XNEWELL_VERSION "\n");
    return std::nullopt;
  }
  Given given;
  for (const CLI::Option* option : app.parse_order())
    given.emplace_back(option->get_name(), option->results().back());
  return given;
}

/// Takes what was given, in the order of the rows, and puts it on the lists of what was given.
void take(const std::vector<OptionRow>& rows, const Given& given, Options& o) {
  for (const auto& [name, text] : given) o.given.push_back(name), o.values.push_back(text);
  for (const OptionRow& row : rows)
    for (const auto& [name, text] : given)
      if (name == row.name) row.take(text);
  o.stats = o.stats || o.errors;
}

/// Complaints about what a picture carries begin with its name.
void blaming(const std::string& carrier, const auto& act) try { act(); } catch (const UsageError& e) {
  if (carrier.empty()) throw;
  throw UsageError{carrier + ": " + e.what()};
}

}  // namespace

std::vector<std::string> commandsAndScenes() {
  std::vector<std::string> names = namesOf(builtInScenes());
  for (const CommandRow& row : kCommands) names.emplace_back(row.name);
  return names;
}

std::string textOf(const Oblique& oblique) {
  const auto* const row = std::ranges::find(kObliques, oblique.length, &ObliqueRow::length);
  return std::string{row->name} + ':' + textOf(oblique.angle);
}

std::vector<OptionRow> optionRows() {
  Options options;
  std::vector<OptionRow> rows = rowsFor(options);
  std::erase_if(rows, [](const OptionRow& row) { return !row.isOption(); });
  for (OptionRow& row : rows) row.take = {};
  return rows;
}

std::optional<Options> parseOptions(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  Options o;
  const std::size_t words = arguments.size();
  o.command = takeCommand(arguments);
  o.commandMeant = !arguments.empty() && arguments.size() == words && !arguments.front().starts_with('-');
  const std::vector<OptionRow> rows = rowsFor(o);
  const std::optional<Given> said = split(rows, std::move(arguments), o.command);
  if (!said) return std::nullopt;

  const auto scene = std::ranges::find(*said, "scene", &Given::value_type::first);
  CarriedSetup carried;
  CameraSettings carriedCamera;
  if (rowOf(o.command).draws && scene != said->end() && isPicture(scene->second)) {
    o.carrier = scene->second;
    carried = readCarriedSetup(o.carrier);
    blaming(o.carrier, [&] {
      if (carried.lesson && o.command != Command::View)
        throw UsageError{"it shows a lesson, which opens in a window: xnewell " + xnewell::quoted(o.carrier)};
      if (carried.lesson) o.command = Command::Lesson, o.commandMeant = false;
      std::set<std::string> names;
      for (const auto& [name, text] : *said) names.insert(name);
      take(rows, split(rows, argumentsFor(o.command, names, carried), o.command).value(), o);
    });
    o.carried = o.given;
    carriedCamera = std::exchange(o.picture.camera, {});
  }
  take(rows, *said, o);
  if (!o.carrier.empty()) {
    o.picture.camera = completed(o.picture.camera, carriedCamera);
    o.scene = carried.scene;
  }
  if (o.command == Command::View && !o.window.run.empty() && !o.gave("--view"))
    o.view = o.window.view = View::DepthSort;
  blaming(o.carrier, [&] { checkUsage(o, rows); });
  return o;
}

void settle(Options& o, const PictureSettings& scene) {
  blaming(o.carrier, [&] { settleOver(o, scene); });
}

}  // namespace xnewell
