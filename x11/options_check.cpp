#include "x11/options_check.h"

#include <filesystem>
#include <string>

namespace {

void exclude(bool a, bool b, const std::string& both) {
  if (a && b) throw UsageError{both + " exclude each other"};
}

/// Whether two names lead to one file, which is regular or is to be made.
bool sameFile(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code missing;
  if (fs::exists(a, missing)) return fs::is_regular_file(a, missing) && fs::equivalent(a, b, missing);
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

void checkEffects(const Options& o) {
  if (o.cell && o.view != View::Colors) throw UsageError{"--cell goes with --view colours"};
  if (o.cell && o.wholeWindow) throw UsageError{"--cell and --whole-window exclude each other"};
  if (o.effects == PaletteEffects{}) return;
  constexpr std::array<std::string_view, 6> kEffects{"--store", "--turn",   "--gamma",
                                                     "--bend",  "--rotate", "--lit"};
  const std::string effect{*std::ranges::find_if(kEffects, [&](auto name) { return o.gave(name); })};
  if (o.command != Command::Draw && o.command != Command::Snapshot)
    throw UsageError{effect + " goes with draw and snapshot"};
  if (o.view != View::Picture && o.view != View::Colors)
    throw UsageError{effect + " goes with --view picture and colours"};
  exclude(true, o.wholeWindow, effect + " and --whole-window");
}

void checkView(const Options& o) {
  if (o.scanline && o.view != View::MachBands) throw UsageError{"--scanline goes with --view machbands"};
  if (o.view == View::Picture) return;
  const ViewRow& row = rowOf(o.view);
  const std::string view = "--view " + std::string{row.name};
  if (o.command != Command::Draw && o.command != Command::Snapshot)
    throw UsageError{view + " goes with draw and snapshot"};
  const bool inWindow = o.wholeWindow && o.view == View::Colors;
  const glm::ivec2 size = o.size.value_or(inWindow ? kWindowSize : kPictureSize);
  const glm::ivec2 least = inWindow ? kLeastWindow : glm::ivec2{row.leastWidth, row.leastHeight};
  if (size.x < least.x || size.y < least.y)
    throw UsageError{view + " needs a --size of at least " + std::to_string(least.x) + "x" +
                     std::to_string(least.y)};
  if (o.wholeWindow && !inWindow) throw UsageError{view + " and --whole-window exclude each other"};
  if (o.stats || !o.ids.empty())
    throw UsageError{view + " is more than a picture: --stats and --ids go with --view picture"};
  if (o.fill == Fill::XFillPolygon)
    throw UsageError{view + " is filled by the scanline: leave out --fill x11"};
}

void checkLight(const Options& o) {
  const Illumination& light = o.picture.light;
  if (o.gave("--range") && light.attenuation != Attenuation::Linear)
    throw UsageError{"--range goes with --attenuation linear"};
  if (o.gave("--coefficients") && light.attenuation != Attenuation::Textbook)
    throw UsageError{"--coefficients goes with --attenuation textbook"};
  if (light.attenuation != Attenuation::None && !light.lightPosition)
    throw UsageError{"--attenuation needs a light at a place: --light-at x,y,z"};
  exclude(o.lightGiven, light.lightPosition.has_value(), "--light and --light-at");
}

/// What each command needs and takes.
void checkCommand(const Options& o) {
  const bool sceneGiven = o.gave("scene");
  const bool makesPng = o.command == Command::Draw || o.command == Command::Snapshot;
  const std::string name{kCommands[static_cast<int>(o.command)].name};
  const bool traces = o.command == Command::Trace;
  if ((makesPng || traces) && !sceneGiven) throw UsageError{name + " needs a scene, such as teapot"};
  if (makesPng && o.output.empty()) throw UsageError{name + " needs -o FILE.png"};
  if (sceneGiven && o.scene.empty()) throw UsageError{"the scene's name is empty"};
  if (sceneGiven && !makesPng && !traces && o.command != Command::View)
    throw UsageError{name + " takes no scene"};
  if (!makesPng && !o.output.empty()) throw UsageError{"-o goes with draw and snapshot"};
  if (!makesPng && (o.stats || !o.ids.empty()))
    throw UsageError{"--stats and --ids go with draw and snapshot"};
  const bool file = !isBuiltIn(o.scene);
  for (const std::string* made : {&o.output, &o.ids})
    if (file && !made->empty() && sameFile(*made, o.scene))
      throw UsageError{"-o and --ids must not name the scene's own file: it would be lost"};
  if (!o.ids.empty() && sameFile(o.ids, o.output)) throw UsageError{"-o and --ids name the same file"};
  if (o.command != Command::Snapshot && o.wholeWindow) throw UsageError{"--whole-window goes with snapshot"};
  if (!traces && (o.quick || !o.frames.empty())) throw UsageError{"--quick and --frames go with trace"};
  if (traces && o.picture.order != Order::Newell)
    throw UsageError{"trace follows the depth sort: no --order but newell"};
  if (o.gave("--every") && o.frames.empty()) throw UsageError{"--every goes with --frames"};
  exclude(o.wholeWindow, !o.ids.empty(), "--whole-window and --ids");
  const bool serverless = o.command == Command::Draw || traces || o.command == Command::Scenes;
  if (serverless && !o.visual.empty()) throw UsageError{"--visual goes with view, snapshot and visuals"};
  if (serverless && (o.colormap != MapOwner::Private || o.nearest))
    throw UsageError{"--colormap shared and --nearest go with view and snapshot: they need a server"};
}

/// What shading, order and filler ask of each other.
void checkMethods(const Options& o) {
  const bool serverFills = o.fill == Fill::XFillPolygon;
  if (serverFills && (o.command == Command::Trace || o.command == Command::Draw))
    throw UsageError{"--fill x11 needs a server: use snapshot"};
  if (serverFills && rowOf(o.picture.shading).interpolates)
    throw UsageError{"--fill x11 gives a polygon one cell: use --shade none, depth or flat"};
  if (!o.texture.empty() && (!rowOf(o.picture.shading).lit || o.picture.shading == Shading::Environment))
    throw UsageError{"--texture goes with --shade flat, gouraud and phong"};
  if (serverFills && !o.texture.empty())
    throw UsageError{"--fill x11 gives a polygon one cell: it shows no --texture"};
  if (serverFills && o.picture.order == Order::Oracle)
    throw UsageError{
        "--order oracle decides each sample by itself: there is no polygon for --fill x11 to fill"};
  if (o.picture.adapt > 0 && o.picture.shading != Shading::Flat && o.picture.shading != Shading::Gouraud)
    throw UsageError{"--adapt goes with --shade flat and gouraud"};
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
  checkLight(o);
  checkCommand(o);
  checkMethods(o);
  checkCamera(o.picture.camera);
  checkView(o);
  checkEffects(o);
}
