#include "x11/app/ready_scene.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>

#include "shading/scene/settings.h"
#include "x11/kit/one_line.h"
#include "x11/terminal/terminal.h"

namespace xnewell {

namespace {

Scene read(const Options& options) {
  std::optional<Doing> reading{"reading " + options.scene};
  Scene scene = readScene(options.scene, options.divisions);
  reading.reset();
  for (const std::string& note : scene.mesh.notes) {
    const std::string line =
        oneLine(note);  // it may need memory, so it comes before a part is on the terminal
    std::cerr << "xnewell: note: " << line << '\n';
  }
  return scene;
}

/// Removes from the scene the light and surface values that the command line replaces.
/// @throws UsageError if the rest does not go with the command line: if Ia + the sum of Ip exceeds 1, if no
/// light can be attenuated, or if --fill x11 cannot show the scene's textures
void giveWay(Scene& scene, const Options& options) {
  if (options.fill == Fill::XFillPolygon && !scene.textures.empty())
    throw UsageError{"--fill x11 paints each polygon in one colour, so it cannot show the scene's textures"};
  for (const Setting& setting : settingRows())
    if (!setting.replaces.empty() && options.gave(setting.option) &&
        std::ranges::find(options.keep, setting.replaces) == options.keep.end())
      strip(scene, setting.replaces);

  // What is left of the lights must be able to fade as the user says.
  const Illumination& user = options.picture.light;
  if (options.gave("--attenuation") && user.attenuation != Attenuation::None && !user.lightPosition &&
      !scene.light.placed())
    throw UsageError{
        "--attenuation needs a light at a place: give --light-at x,y,z or a scene with such a light"};

  // A user's Ia must fit the scene's lights, and a user's Ip the scene's Ia.
  const bool besideLights = options.gave("--ia") && !scene.light.lights.empty(),
             besideIa = options.gave("--ip") && scene.light.Ia;
  glm::dvec3 sum = scene.light.Ia.value_or(glm::dvec3{user.Ia});
  for (const Light& light : scene.light.lights) sum += light.Ip;
  if (scene.light.lights.empty()) sum += user.Ip;
  if ((besideLights || besideIa) && std::max({sum.r, sum.g, sum.b}) > kMostLight)
    throw UsageError{
        std::string{besideLights ? "--ia and the scene's lights" : "--ip and the scene's ambient light"} +
        ": their sum must not exceed 1"};
}

}  // namespace

Scene readyScene(Options& options) {
  Scene scene = read(options);
  if (options.command == Command::Trace)
    scene.settings.order = Order::Newell;  // the trace follows this order
  settle(options, scene.settings);
  giveWay(scene, options);
  options.picture.camera = completed(options.picture.camera, scene.camera);
  if (!options.texture.empty()) {
    wear(scene, readTexture(options.texture));
    scene.origin.texture = options.texture;
  }
  scene.marks.edges = options.edges, scene.marks.edgeColor = options.edgeColor;
  return scene;
}

}  // namespace xnewell
