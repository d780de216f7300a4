#include "x11/options/options_check.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>

#include "geometry/files/text_file.h"
#include "shading/figure/write_figure.h"
#include "shading/scene/settings.h"

namespace xnewell {

namespace {

void exclude(bool a, bool b, const std::string& both) {
  if (a && b) throw UsageError{both + " exclude each other"};
}

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
  for (const std::string& given : o.given) {
    const auto row = std::ranges::find(rows, given, &OptionRow::name);
    if (row == rows.end()) continue;  // the scene
    if (row->places.empty()) {
      if (!rowOf(o.command).draws)
        throw UsageError{row->shown() + " does not work with " + std::string{rowOf(o.command).name} +
                         (o.command == Command::Lesson    ? ": the lesson decides how its steps are drawn"
                          : o.command == Command::Lecture ? ": the lecture decides how its pages are drawn"
                                                          : ": it draws no scene")};
      continue;
    }
    if (std::ranges::any_of(row->places, [&](std::string_view place) { return isAt(o, place); })) continue;
    std::string all;
    for (const std::string_view place : row->places)
      all += (all.empty() ? "" : place == row->places.back() ? " and " : ", ") + std::string{place};
    throw UsageError{row->shown() + " works only with " + all};
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
  if (const auto& few = o.window.controls; few && o.window.view != WindowView::Picture &&
                                           (o.window.view != WindowView::DepthSort || !few->empty()))
    throw UsageError{"--controls names controls of view 1; none puts those of view 1 or 2 away"};
  if (o.window.controls && o.wholeWindow) needsWindow("--controls", o);
  if (o.viewName == "picture") return;
  const std::string view = "--view " + o.viewName;
  const bool window = o.command == Command::View || o.wholeWindow;
  if (window) return needsWindow(view, o);
  if (o.view == View::Picture)
    throw UsageError{view + " is a view of the window: use view, or snapshot --whole-window"};
  const ViewRow& row = rowOf(o.view);
  needsSize(view, o.size.value_or(kPictureSize), {row.leastWidth, row.leastHeight});
  if (o.stats || !o.ids.empty())
    throw UsageError{
        view +
        " is not just the picture: --stats, --errors, --costs and --ids work only with --view picture"};
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

/// Checks what `figure` needs and takes.
void checkFigure(const Options& o) {
  if (o.output.empty()) throw UsageError{"figure needs -o FILE.svg, FILE.pdf or FILE.eps"};
  for (const std::string* file : {&o.output, &o.ids})
    if (!file->empty() && figureFormatOf(*file) == nullptr)
      throw UsageError{(file == &o.output ? "-o " : "--ids ") + *file +
                       ": figures are SVG, PDF or EPS files; call it .svg, .pdf or .eps"};
  if (o.smooth && figureFormatOf(o.output)->name != "PDF")
    throw UsageError{"--smooth needs -o FILE.pdf: only PDF has triangles with a colour at each corner"};
}

/// Checks what each command needs and takes.
void checkCommand(const Options& o, const std::vector<OptionRow>& rows) {
  const bool sceneGiven = o.gave("scene");
  const bool makesPng = o.command == Command::Draw || o.command == Command::Snapshot;
  const std::string name{rowOf(o.command).name};
  const bool traces = o.command == Command::Trace;
  const bool charts = o.command == Command::Trade || o.command == Command::Extremes;
  const bool explains = o.command == Command::Explain;
  const bool figure = o.command == Command::Figure;
  const bool diagnoses = o.command == Command::Diagnose, takes = !rowOf(o.command).takes.empty();
  const bool asks = o.command == Command::Questions, grades = o.command == Command::Grade;
  if (diagnoses && !o.sceneFor.empty()) {
    if (sceneGiven) throw UsageError{"--scene-for names a scene: leave out " + inQuotes(o.scene)};
    for (std::size_t k = 0; k < o.given.size(); ++k)
      if (o.given[k] != "--scene-for" && o.given[k] != "--json")
        throw UsageError{"--scene-for tries all methods and tables: leave out " + o.given[k]};
    return;
  }
  if ((makesPng || traces || charts || explains || figure || takes || asks) && !sceneGiven)
    throw UsageError{name + " needs a scene, such as teapot"};
  exclude(!o.handedIn.empty(), !o.run.empty(), "an order and --run");
  exclude(!o.output.empty(), !o.run.empty(), "-o and --run");
  if (takes && o.handedIn.empty() && o.run.empty())
    throw UsageError{name + " needs, after the scene, " + std::string{rowOf(o.command).takes}};
  if (grades && o.output.empty()) throw UsageError{"grade needs -o MARKS.csv"};
  if (explains && !o.pixel && !o.gave("--viewing"))
    throw UsageError{"explain needs a pixel X,Y of the picture, such as 400,300: xnewell explain " + o.scene +
                     " 400,300"};
  exclude(explains && o.pixel, o.gave("--viewing"), "a pixel and --viewing");
  if (const glm::ivec2 size = o.size.value_or(kPictureSize);
      o.pixel && (o.pixel->x >= size.x || o.pixel->y >= size.y))
    refuseOutside(*o.pixel, size);
  if (figure) checkFigure(o);
  if (makesPng && o.output.empty()) throw UsageError{name + " needs -o FILE.png"};
  constexpr std::array<std::string_view, 8> kOtherPictures{".jpg", ".jpeg", ".gif", ".bmp",
                                                           ".ppm", ".tif",  ".svg", ".pdf"};
  for (const std::string_view other : kOtherPictures)
    if ((makesPng || charts || diagnoses) && o.output.ends_with(other))
      throw UsageError{"-o " + o.output + ": pictures are PNG files; call it .png"};
  if (sceneGiven && o.scene.empty()) throw UsageError{"the scene's name is empty"};
  const std::filesystem::path path{o.scene};
  if (o.commandMeant && !isBuiltIn(o.scene) && path.extension().empty() && !std::filesystem::exists(path))
    throw UsageError{o.scene +
                     ": not a command or a built-in scene; `xnewell --help` lists the commands, "
                     "`xnewell scenes` the scenes"};
  const bool lesson = o.command == Command::Lesson, lecture = o.command == Command::Lecture;
  if (sceneGiven && !rowOf(o.command).draws && !lesson && !lecture)
    throw UsageError{name + " takes no scene"};
  checkPlaces(o, rows);
  if (lecture) {
    if (!sceneGiven)
      throw UsageError{"lecture needs a file, such as my-lecture.json; first-hour comes with the program"};
    needsWindow("a lecture", o);
  }
  if (lesson) {
    const bool writes = !o.frames.empty() || !o.worksheet.empty();
    const std::string how = o.frames.empty() ? "--worksheet" : "--frames";
    if (writes && !sceneGiven) throw UsageError{how + " needs a lesson's name"};
    for (const char* option : {"--visual", "--colormap", "--nearest"})
      if (writes && o.gave(option))
        throw UsageError{std::string{option} + " needs a server, and lesson " + how + " uses none"};
    exclude(writes, !o.answers.empty(), how + " and --answers");
    exclude(writes, o.gave("--step"), how + " and --step");
    if (o.gave("--step") && !sceneGiven) throw UsageError{"--step needs a lesson's name"};
    if (o.gave("--step") && o.window.step < 1) throw UsageError{"--step: the steps of a lesson count from 1"};
    exclude(!o.frames.empty(), !o.worksheet.empty(), "--frames and --worksheet");
    needsWindow("a lesson", o);
  }
  exclude(o.accuracy.has_value(), o.wholeWindow, "--accuracy and --whole-window");
  exclude(o.quick, o.wholeWindow, "--quick and --whole-window");
  const bool follows = o.window.polygon && traces;
  exclude(follows, o.quick, "--scanline and --quick");
  exclude(follows, !o.frames.empty(), "--scanline and --frames");
  if (o.window.polygon && !o.window.scanline && o.viewName == "machbands")
    throw UsageError{"--scanline: '" + *o.window.polygon + "' is not a whole number from 0 to " +
                     std::to_string(kMaxPicture - 1)};
  if (traces && o.wholeWindow) needsWindow("the stepper", o);
  exclude(o.wholeWindow, !o.ids.empty(), "--whole-window and --ids");
  exclude(o.gave("--light"), o.gave("--light-at"), "--light and --light-at");
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
  if (serverFills &&
      (o.command == Command::Trace || o.command == Command::Draw || o.command == Command::Explain ||
       o.command == Command::Figure || o.command == Command::Trade || o.command == Command::Extremes ||
       !rowOf(o.command).takes.empty() || o.command == Command::Questions))
    throw UsageError{"--fill x11 needs a server: use snapshot"};
  exclude(o.accuracy.has_value(), serverFills, "--accuracy and --fill x11");
  if (serverFills && o.view != View::Picture && !o.wholeWindow && o.command != Command::View)
    throw UsageError{"--view " + o.viewName + " uses the scanline filler: leave out --fill x11"};
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

void checkSettings(const Options& o) {
  checkHaveEffect(o);
  checkMethods(o);
}

void settle(Options& o, const PictureSettings& scene) try {
  PictureSettings settings = scene;
  settings.camera = o.picture.camera, settings.mostPieces = o.picture.mostPieces;
  if (!applyOverrides(settings, o.overrides)) throw UsageError{"--ia and --ip: their sum must not exceed 1"};
  if (o.halfVector) {
    if (o.gave("--form") && settings.light.form != Form::HalfVector)
      throw UsageError{"--half-vector and --form exclude each other"};
    settings.light.form = Form::HalfVector;
  }
  // Here inPixels is true if --fill or the scene asks for the server's filler. --fill x11 always counts. A
  // scene's wish counts only for view and snapshot, which have a server, and only if the server can fill the
  // polygons.
  const bool server = std::exchange(settings.inPixels, false);
  const bool window = o.command == Command::View || o.command == Command::Snapshot;
  const bool fillable = !rowOf(settings.order).bySample && !rowOf(settings.shading).interpolates;
  if (server && (o.gave("--fill") || (window && fillable))) o.fill = Fill::XFillPolygon;
  o.picture = settings;
  if (PictureSettings B = settings; o.window.beside && !applyOverrides(B, *o.window.beside))
    throw UsageError{"--beside: the sum of ia and ip must not exceed 1"};
  checkSettings(o);
} catch (const UsageError& e) {
  if (o.carrier.empty()) throw;
  throw UsageError{o.carrier + ": " + e.what()};
}

}  // namespace xnewell
