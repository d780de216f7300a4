#include "x11/options/options_check.h"

#include <filesystem>
#include <string>

#include "shading/scene/settings.h"

namespace xnewell {

namespace {

void exclude(bool a, bool b, const std::string& both) {
  if (a && b) throw UsageError{both + " exclude each other"};
}

/// True if both names lead to the same regular file, or to the same place for a file that does not exist yet.
bool sameFile(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code missing;
  if (fs::exists(a, missing)) return fs::is_regular_file(a, missing) && fs::equivalent(a, b, missing);
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

void checkEffects(const Options& o) {
  if (o.cell && o.view != View::Colors) throw UsageError{"--cell works only with --view colours"};
  if (o.cell && o.wholeWindow) throw UsageError{"--cell and --whole-window exclude each other"};
  if (o.effects == PaletteEffects{}) return;
  constexpr std::array<std::string_view, 6> kEffects{"--store", "--turn",   "--gamma",
                                                     "--bend",  "--rotate", "--lit"};
  const std::string effect{*std::ranges::find_if(kEffects, [&](auto name) { return o.gave(name); })};
  if (o.command != Command::Draw && o.command != Command::Snapshot)
    throw UsageError{effect + " works only with draw and snapshot"};
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
  if (o.scanline && o.view != View::MachBands)
    throw UsageError{"--scanline works only with --view machbands"};
  if (o.viewName == "picture") return;
  const std::string view = "--view " + o.viewName;
  const bool window = o.command == Command::View || o.wholeWindow;
  if (o.scanline && window)
    throw UsageError{"--scanline works only with a view that is drawn without its window"};
  if (window) return needsWindow(view, o);
  if (o.command != Command::Draw && o.command != Command::Snapshot)
    throw UsageError{view + " works only with view, draw and snapshot"};
  if (o.view == View::Picture)
    throw UsageError{view + " is a view of the window: use view, or snapshot --whole-window"};
  const ViewRow& row = rowOf(o.view);
  needsSize(view, o.size.value_or(kPictureSize), {row.leastWidth, row.leastHeight});
  if (o.stats || !o.ids.empty())
    throw UsageError{
        view +
        " is not just the picture: --stats, --errors, --costs and --ids work only with --view picture"};
  if (o.fill == Fill::XFillPolygon)
    throw UsageError{view + " uses the scanline filler: leave out --fill x11"};
}

/// Refuses settings that have no effect, unless their row asks only for a note.
void checkSettings(const Options& o) {
  const PictureFacts facts = factsOf(o.picture);
  for (const Setting& setting : settingRows())
    if (setting.need.unmet != Need::Unmet::Noted && o.gave(setting.option) && !hasEffect(setting, facts))
      throw UsageError{std::string{setting.option} + " applies only to " +
                       std::string{setting.need.appliesTo}};
  exclude(o.gave("--light"), o.gave("--light-at"), "--light and --light-at");
}

/// Checks what each command needs and takes.
void checkCommand(const Options& o) {
  const bool sceneGiven = o.gave("scene");
  const bool makesPng = o.command == Command::Draw || o.command == Command::Snapshot;
  const std::string name{kCommands[static_cast<int>(o.command)].name};
  const bool traces = o.command == Command::Trace, trades = o.command == Command::Trade;
  const bool charts = trades || o.command == Command::Extremes, explains = o.command == Command::Explain;
  if ((makesPng || traces || charts || explains) && !sceneGiven)
    throw UsageError{name + " needs a scene, such as teapot"};
  if (explains && !o.pixel)
    throw UsageError{"explain needs a pixel X,Y of the picture, such as 400,300: xnewell explain " + o.scene +
                     " 400,300"};
  if (const glm::ivec2 size = o.size.value_or(kPictureSize);
      o.pixel && (o.pixel->x >= size.x || o.pixel->y >= size.y))
    throw UsageError{"pixel " + std::to_string(o.pixel->x) + "," + std::to_string(o.pixel->y) +
                     " lies outside the picture of " + std::to_string(size.x) + "x" + std::to_string(size.y)};
  if (makesPng && o.output.empty()) throw UsageError{name + " needs -o FILE.png"};
  constexpr std::array<std::string_view, 8> kOtherPictures{".jpg", ".jpeg", ".gif", ".bmp",
                                                           ".ppm", ".tif",  ".svg", ".pdf"};
  for (const std::string_view other : kOtherPictures)
    if ((makesPng || charts) && o.output.ends_with(other))
      throw UsageError{"-o " + o.output + ": pictures are PNG files; call it .png"};
  if (sceneGiven && o.scene.empty()) throw UsageError{"the scene's name is empty"};
  const std::filesystem::path path{o.scene};
  if (o.commandMeant && !isBuiltIn(o.scene) && path.extension().empty() && !std::filesystem::exists(path))
    throw UsageError{o.scene +
                     ": not a command or a built-in scene; `xnewell --help` lists the commands, "
                     "`xnewell scenes` the scenes"};
  const bool lesson = o.command == Command::Lesson;
  if (lesson) {
    constexpr std::array<std::string_view, 7> kTaken{"scene",    "--size",     "--scale",  "--frames",
                                                     "--visual", "--colormap", "--nearest"};
    for (const std::string& option : o.given)
      if (std::ranges::find(kTaken, option) == kTaken.end())
        throw UsageError{option + " does not work with lesson: the lesson decides how its steps are drawn"};
    if (!o.frames.empty() && !sceneGiven) throw UsageError{"--frames needs a lesson's name"};
    needsWindow("a lesson", o);
  }
  if (sceneGiven && !makesPng && !traces && !charts && !lesson && !explains && o.command != Command::View)
    throw UsageError{name + " takes no scene"};
  if (!makesPng && !charts && !o.output.empty())
    throw UsageError{"-o works only with draw, snapshot, trade and extremes"};
  if (!charts && !explains && o.json) throw UsageError{"--json works only with explain, trade and extremes"};
  for (const std::string_view option : {"--axes", "--without"})
    if (!trades && o.gave(option)) throw UsageError{std::string{option} + " works only with trade"};
  if (!trades && !o.accuracy && o.gave("--budget"))
    throw UsageError{"--budget works only with trade and --accuracy"};
  if (o.accuracy && !makesPng && o.command != Command::View)
    throw UsageError{"--accuracy works only in the window and with draw and snapshot"};
  exclude(o.accuracy.has_value(), o.fill == Fill::XFillPolygon, "--accuracy and --fill x11");
  exclude(o.accuracy.has_value(), o.wholeWindow, "--accuracy and --whole-window");
  if (!makesPng && (o.stats || !o.ids.empty()))
    throw UsageError{"--stats, --errors, --costs and --ids work only with draw and snapshot"};
  const bool file = !isBuiltIn(o.scene);
  for (const std::string* made : {&o.output, &o.ids})
    if (file && !made->empty() && sameFile(*made, o.scene))
      throw UsageError{"-o and --ids must not name the scene's own file: it would be lost"};
  if (!o.ids.empty() && sameFile(o.ids, o.output)) throw UsageError{"-o and --ids name the same file"};
  const bool stepper = traces && !o.frames.empty();
  if (o.wholeWindow && o.command != Command::Snapshot && !stepper)
    throw UsageError{"--whole-window works only with snapshot and with trace --frames"};
  exclude(o.quick, o.wholeWindow, "--quick and --whole-window");
  if (stepper && o.wholeWindow) needsWindow("the stepper", o);
  if (o.gave("--scale") && o.command != Command::View && !lesson && !o.wholeWindow)
    throw UsageError{"--scale works only with view, lesson and --whole-window"};
  if (!traces && o.quick) throw UsageError{"--quick works only with trace"};
  if (!traces && !lesson && !o.frames.empty()) throw UsageError{"--frames works only with trace and lesson"};
  if (traces && o.picture.order != Order::Newell)
    throw UsageError{"trace follows the depth sort: it allows only --order newell"};
  if (o.gave("--every") && o.frames.empty()) throw UsageError{"--every works only with --frames"};
  exclude(o.wholeWindow, !o.ids.empty(), "--whole-window and --ids");
  const bool serverless = o.command == Command::Draw || explains || traces || charts ||
                          o.command == Command::Scenes || o.command == Command::Keys ||
                          (lesson && !o.frames.empty());
  if (serverless && !o.visual.empty())
    throw UsageError{"--visual works only with view, snapshot and visuals"};
  if (serverless && (o.colormap != MapOwner::Private || o.nearest))
    throw UsageError{"--colormap shared and --nearest work only with view and snapshot: they need a server"};
}

/// Checks that shading, order, filler and texture go together.
void checkMethods(const Options& o) {
  const bool serverFills = o.fill == Fill::XFillPolygon;
  if (serverFills &&
      (o.command == Command::Trace || o.command == Command::Draw || o.command == Command::Explain ||
       o.command == Command::Trade || o.command == Command::Extremes))
    throw UsageError{"--fill x11 needs a server: use snapshot"};
  if (serverFills && rowOf(o.picture.shading).interpolates)
    throw UsageError{"--fill x11 gives a polygon one cell: use --shade none, depth or flat"};
  if (!o.texture.empty() && (!rowOf(o.picture.shading).lit || o.picture.shading == Shading::Environment))
    throw UsageError{"--texture works only with --shade flat, gouraud and phong"};
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

void checkTogether(const Options& o) {
  checkSettings(o);
  checkCommand(o);
  checkMethods(o);
  checkCamera(o.picture.camera);
  checkView(o);
  checkEffects(o);
}

}  // namespace xnewell
