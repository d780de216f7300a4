#include "x11/options/option_rows.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>

#include "geometry/files/input_file.h"
#include "geometry/files/text_file.h"
#include "shading/figure/write_figure.h"
#include "shading/scene/settings.h"

namespace xnewell {

namespace {

void exclude(bool a, bool b, const std::string& both) {
  if (a && b) throw UsageError{both + " exclude each other"};
}

/// Options that exclude each other.
struct Clash {
  std::string_view a, b, both = {};  ///< `both`: the words for them, if they are not just their names
};
constexpr std::array kClashes{
    Clash{"explained", "--viewing", "a pixel and --viewing"},
    Clash{"handed-in", "--run", "an order and --run"},
    Clash{"--frames", "--answers"},
    Clash{"--worksheet", "--answers"},
    Clash{"--frames", "--step"},
    Clash{"--worksheet", "--step"},
    Clash{"--frames", "--worksheet"},
    Clash{"--frames", "--page"},
    Clash{"--worksheet", "--page"},
    Clash{"--answers", "--page"},
    Clash{"--accuracy", "--whole-window"},
    Clash{"--quick", "--whole-window"},
    Clash{"--scanline", "--quick"},
    Clash{"--scanline", "--frames"},
    Clash{"--whole-window", "--ids"},
    Clash{"--light", "--light-at"},
};

/// Whether the command line is at a place where an option works (OptionRow::places).
bool isAt(const Options& o, std::string_view place) {
  std::istringstream words{std::string{place}};
  std::string option;  // the word before, if it is an option
  for (std::string word; words >> word;) {
    const auto given = std::ranges::find(o.given, option.empty() ? word : option);
    const bool said = given != o.given.end();
    if (!option.empty() && !(said && o.values[given - o.given.begin()] == word)) return false;
    if (option.empty() && !(word.starts_with('-') ? said : rowOf(o.command).name == word)) return false;
    option = word.starts_with('-') ? word : "";
  }
  return true;
}

/// Refuses options where they do not work.
void checkPlaces(const Options& o, const std::vector<OptionRow>& rows) {
  const CommandRow& command = rowOf(o.command);
  for (const std::string& given : o.given) {
    const OptionRow& row = *std::ranges::find(rows, given, &OptionRow::name);
    if (!row.isOption() || (row.places.empty() && command.draws)) continue;
    if (row.places.empty())
      throw UsageError{row.shown() + " does not work with " + std::string{command.name} +
                       (o.command == Command::Lesson    ? ": the lesson decides how its steps are drawn"
                        : o.command == Command::Lecture ? ": the lecture decides how its pages are drawn"
                                                        : ": it draws no scene")};
    if (std::ranges::any_of(row.places, [&](std::string_view place) { return isAt(o, place); })) continue;
    std::string all;
    for (const std::string_view place : row.places)
      all += (all.empty() ? "" : place == row.places.back() ? " and " : ", ") + std::string{place};
    throw UsageError{row.shown() + " works only with " + all};
  }
}

void checkEffects(const Options& o) {
  if (o.effects == PaletteEffects{}) return;
  constexpr std::array<std::string_view, 6> kEffects{"--store", "--turn",   "--gamma",
                                                     "--bend",  "--rotate", "--lit"};
  const std::string effect{*std::ranges::find_if(kEffects, [&](auto name) { return o.gave(name); })};
  if (o.view != View::Picture && o.view != View::Colors)
    throw UsageError{effect + " works only with --view picture and colours"};
  exclude(true, o.wholeWindow, effect + " and --whole-window");
}

void needsSize(const std::string& view, glm::ivec2 size, glm::ivec2 least) {
  if (size.x < least.x || size.y < least.y)
    throw UsageError{view + " needs a --size of at least " + std::to_string(least.x) + "x" +
                     std::to_string(least.y)};
}

/// Refuses a window that has no room for its controls.
void needsWindow(const std::string& view, const Options& o) {
  needsSize(view, windowSize(o), kLeastWindow * o.scale);
}

void checkView(const Options& o) {
  if (const auto& few = o.window.controls;
      few && o.window.view != View::Picture && (o.window.view != View::DepthSort || !few->empty()))
    throw UsageError{"--controls names controls of view 1; none puts those of view 1 or 2 away"};
  if (o.window.controls && o.wholeWindow) needsWindow("--controls", o);
  if (o.view == View::Picture) return;
  const ViewRow& row = rowOf(o.view);
  const std::string view = "--view " + std::string{row.name};
  const bool window = o.command == Command::View || o.wholeWindow;
  if (window) return needsWindow(view, o);
  if (!row.hasSheet())
    throw UsageError{view + " is a view of the window: use view, or snapshot --whole-window"};
  needsSize(view, o.size.value_or(kPictureSize), row.least);
  if (o.stats || !o.ids.empty())
    throw UsageError{view +
                     " is not just the picture: --stats, --errors and --ids work only with --view picture"};
}

/// True if only a picture gives the option.
bool carries(const Options& o, std::string_view option) {
  return std::ranges::find(o.carried, option) != o.carried.end();
}

/// Refuses settings that have no effect, unless a picture carries them or their row asks only for a note.
void checkHaveEffect(const Options& o) {
  const PictureFacts facts = factsOf(o.picture);
  for (const Setting& setting : settingRows())
    if (setting.need.unmet != Need::Unmet::Noted && o.gave(setting.option) && !carries(o, setting.option) &&
        !hasEffect(setting, facts))
      throw UsageError{std::string{setting.option} + " applies only to " +
                       std::string{setting.need.appliesTo}};
}

/// Checks the names of the files that the command writes.
void checkOutput(const Options& o) {
  const CommandRow& row = rowOf(o.command);
  if (!row.output.empty() && o.output.empty())
    throw UsageError{std::string{row.name} + " needs -o " + std::string{row.output}};
  constexpr std::array<std::string_view, 8> kOtherPictures{".jpg", ".jpeg", ".gif", ".bmp",
                                                           ".ppm", ".tif",  ".svg", ".pdf"};
  exclude(o.command == Command::Judge && o.gave("--run"), !o.output.empty(), "-o and --run");
  if (row.is(kPng) && std::ranges::any_of(kOtherPictures, [&](auto end) { return o.output.ends_with(end); }))
    throw UsageError{"-o " + o.output + ": pictures are PNG files; call it .png"};
  if (o.command != Command::Figure) return;
  for (const std::string* file : {&o.output, &o.ids})
    if (!file->empty() && figureFormatOf(*file) == nullptr)
      throw UsageError{(file == &o.output ? "-o " : "--ids ") + *file +
                       ": figures are SVG, PDF or EPS files; call it .svg, .pdf or .eps"};
  if (o.smooth && figureFormatOf(o.output)->name != "PDF")
    throw UsageError{"--smooth needs -o FILE.pdf: only PDF has triangles with a colour at each corner"};
}

/// Checks the words that are no options: the scene, and what comes after it.
void checkWords(const Options& o) {
  const CommandRow& row = rowOf(o.command);
  const std::string name{row.name};
  const bool given = o.gave("scene");
  if (row.is(kNeedsScene) && !given) throw UsageError{name + " needs a scene, such as teapot"};
  if (!row.takes.empty() && o.handedIn.empty() && o.window.run.empty())
    throw UsageError{name + " needs, after the scene, " + std::string{row.takes}};
  if (o.command == Command::Explain && !o.pixel && !o.gave("--viewing"))
    throw UsageError{"explain needs a pixel X,Y of the picture, such as 400,300: xnewell explain " + o.scene +
                     " 400,300"};
  if (const glm::ivec2 size = o.size.value_or(kPictureSize);
      o.pixel && (o.pixel->x >= size.x || o.pixel->y >= size.y))
    refuseOutside(*o.pixel, size);
  if (given && o.scene.empty()) throw UsageError{"the scene's name is empty"};
  if (!given && o.gave("--run")) throw UsageError{"--run needs the scene of that run, such as cycle"};
  const std::filesystem::path path{o.scene};
  if (o.commandMeant && !isBuiltIn(o.scene) && path.extension().empty() && !isThere(path))
    throw UsageError{o.scene + ": not a command or a built-in scene; " +
                     didYouMean(o.scene, commandsAndScenes(),
                                "`xnewell --help` lists the commands, `xnewell scenes` the scenes")};
  if (given && !row.draws && !row.is(kPages)) throw UsageError{name + " takes no scene"};
}

void checkLesson(const Options& o) {
  const std::string how = !o.frames.empty() ? "--frames" : o.page.empty() ? "--worksheet" : "--page";
  const bool writes = o.gave(how), named = o.gave("scene"), begins = o.gave("--step");
  if (writes && !named) throw UsageError{how + " needs a lesson's name"};
  for (const char* option : {"--visual", "--colormap", "--nearest"})
    if (writes && o.gave(option))
      throw UsageError{std::string{option} + " needs a server, and lesson " + how + " uses none"};
  if (begins && !named) throw UsageError{"--step needs a lesson's name"};
  if (begins && o.window.step < 1) throw UsageError{"--step: the steps of a lesson count from 1"};
}

/// Checks what the command needs and takes.
void checkCommand(const Options& o, const std::vector<OptionRow>& rows) {
  if (o.command == Command::Diagnose && !o.sceneFor.empty()) {
    if (o.gave("scene")) throw UsageError{"--scene-for names a scene: leave out " + inQuotes(o.scene)};
    for (const std::string& given : o.given)
      if (given != "--scene-for" && given != "--json")
        throw UsageError{"--scene-for tries all methods and tables: leave out " + given};
    return;
  }
  checkWords(o);
  checkOutput(o);
  checkPlaces(o, rows);
  if (o.command == Command::Lesson) checkLesson(o);
  if (o.command == Command::Lecture && !o.gave("scene"))
    throw UsageError{"lecture needs a file, such as my-lecture.json; first-hour comes with the program"};
  for (const Clash& clash : kClashes)
    exclude(
        o.gave(clash.a), o.gave(clash.b),
        clash.both.empty() ? std::string{clash.a} + " and " + std::string{clash.b} : std::string{clash.both});
  if (const CommandRow& row = rowOf(o.command); row.is(kPages)) needsWindow("a " + std::string{row.name}, o);
  if (o.command == Command::Trace && o.wholeWindow) needsWindow("the stepper", o);
  if (o.window.polygon && !o.window.scanline && o.view == View::MachBands)
    throw UsageError{"--scanline: '" + *o.window.polygon + "' is not a whole number from 0 to " +
                     std::to_string(kMaxPicture - 1)};
}

/// Refuses a figure of an order that knows no polygons, or only those with samples.
void checkFigureMethods(const Options& o) {
  const OrderRow& order = rowOf(o.picture.order);
  const std::string name = "--order " + std::string{order.name};
  if (order.bySample)
    throw UsageError{name + " decides each sample by itself: a figure needs a painting order"};
  if (o.picture.order == Order::Bsp)
    throw UsageError{name + " leaves out what has no sample: use --order newell for a figure"};
}

/// Checks that shading, order, filler and texture go together.
void checkMethods(const Options& o) {
  const bool serverFills = o.fill == Fill::XFillPolygon;
  if (serverFills && !rowOf(o.command).is(kFills))
    throw UsageError{"--fill x11 needs a server: use snapshot"};
  exclude(o.accuracy.has_value(), serverFills, "--accuracy and --fill x11");
  if (serverFills && o.view != View::Picture && !o.wholeWindow && o.command != Command::View)
    throw UsageError{"--view " + std::string{rowOf(o.view).name} +
                     " uses the scanline filler: leave out --fill x11"};
  if (o.command == Command::Trace && o.picture.order != Order::Newell)
    throw UsageError{"trace follows the depth sort: it allows only --order newell"};
  if (o.command == Command::Figure) checkFigureMethods(o);
  if (serverFills && rowOf(o.picture.shading).interpolates)
    throw UsageError{"--fill x11 gives a polygon one cell: use --shade none, depth or flat"};
  if (serverFills && !o.texture.empty())
    throw UsageError{"--fill x11 gives a polygon one cell: it shows no --texture"};
  if (const OrderRow& order = rowOf(o.picture.order); serverFills && order.bySample)
    throw UsageError{"--order " + std::string{order.name} +
                     " decides each sample by itself: there is no polygon for --fill x11 to fill"};
}

void checkCamera(const CameraSettings& c) {
  exclude(c.eye.has_value(), c.vpn || c.prp, "--eye and the textbook's --vpn, --prp");
  exclude(c.lookAt.has_value(), c.vrp.has_value(), "--look-at and --vrp");
  exclude(c.up.has_value(), c.vup.has_value(), "--up and --vup");
  exclude(c.fov.has_value(), c.window.has_value(), "--fov and --view-window");
  if (c.fov && (c.parallel || c.oblique))
    throw UsageError{"--fov is for perspective: leave out --parallel and --oblique"};
}

}  // namespace

void refuseOutside(const glm::ivec2& pixel, const glm::ivec2& size) {
  throw UsageError{"pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) +
                   " lies outside the picture of " + std::to_string(size.x) + "x" + std::to_string(size.y)};
}

void checkUsage(const Options& o, const std::vector<OptionRow>& rows) {
  checkCommand(o, rows);
  checkCamera(o.picture.camera);
  checkView(o);
  checkEffects(o);
}

void settleOver(Options& o, const PictureSettings& scene) {
  PictureSettings settings = scene;
  settings.camera = o.picture.camera, settings.mostPieces = o.picture.mostPieces;
  if (!applyOverrides(settings, o.overrides)) throw UsageError{"--ia and --ip: their sum must not exceed 1"};
  for (const auto& [setting, value] : o.overrides)
    exclude(o.gave(setting->alias), textOf(*setting, value) != setting->means,
            std::string{setting->alias} + " and " + std::string{setting->option});
  // Here inPixels is true if --fill or the scene asks for the server's filler. --fill x11 always counts. A
  // scene's wish counts only for view and snapshot, which have a server, and only if the server can fill the
  // polygons.
  const bool server = std::exchange(settings.inPixels, false);
  const bool fillable = !rowOf(settings.order).bySample && !rowOf(settings.shading).interpolates;
  if (server && (o.gave("--fill") || (rowOf(o.command).is(kFills) && fillable))) o.fill = Fill::XFillPolygon;
  o.picture = settings;
  if (PictureSettings B = settings; o.window.beside && !applyOverrides(B, *o.window.beside))
    throw UsageError{"--beside: the sum of ia and ip must not exceed 1"};
  checkHaveEffect(o);
  checkMethods(o);
}

}  // namespace xnewell
