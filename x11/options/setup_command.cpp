#include "x11/options/setup_command.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <tuple>

#include "shading/figure/figure.h"
#include "shading/scene/settings.h"
#include "shading/scene/units.h"
#include "x11/options/read_value.h"
#include "x11/options/shell_words.h"

namespace xnewell {

namespace {

/// " --eye=-1,2,3": a value that begins with a minus goes with its option.
std::string option(std::string_view name, const std::string& value) {
  return ' ' + std::string{name} + (value.starts_with('-') ? '=' : ' ') + quoted(value);
}

using xnewell::textOf;
std::string textOf(const glm::dvec3& v) { return textOf(v.x) + ',' + textOf(v.y) + ',' + textOf(v.z); }

/// A name that begins with a minus would be taken for an option.
std::string asFile(const std::string& name) { return name.starts_with('-') ? "./" + name : name; }

[[noreturn]] void cannotSay() {
  throw ViewError{"no options can say this camera beside the scene's own; save the set-up as a file"};
}

/// An option for a part of the camera that differs from the scene's own.
template <class Part>
std::string part(std::string_view name, const std::optional<Part>& now, const std::optional<Part>& own) {
  if (now == own) return "";
  if (!now) cannotSay();
  return option(name, textOf(*now));
}

}  // namespace

SetupCommand::SetupCommand(const Scene& scene)
    : scene_{scene}, own_{scene.settings}, ownCamera_{scene.camera} {
  if (scene.name == scene.origin.of) return;
  const Scene named = readScene(scene.origin.of, 1);  // its polygons do not matter
  own_ = named.settings, ownCamera_ = named.camera;
}

bool SetupCommand::stripped(std::string_view what) const {
  const std::vector<std::string>& without = scene_.origin.without;
  return std::ranges::find(without, what) != without.end();
}

bool SetupCommand::scenesOwn(std::string_view what) const {
  if (what == "ambient") return scene_.light.Ia.has_value();
  if (what == "lights") return !scene_.light.lights.empty();
  return std::ranges::any_of(scene_.mesh.materials, [&](const MeshMaterial& m) {
    return what == "ka"   ? m.ka.has_value()
           : what == "kd" ? m.kd.has_value()
           : what == "ks" ? m.ks.has_value()
                          : what == "n" && m.n.has_value();
  });
}

bool SetupCommand::says(const Setting& setting, const PictureSettings& now) const {
  const std::string_view key = setting.key, what = setting.replaces;
  const Illumination& light = now.light;
  const Value value = setting.field.get(now);
  if (key == "fill" || std::holds_alternative<std::monostate>(value)) return false;
  if (setting.need.unmet != Need::Unmet::Noted && !hasEffect(setting, factsOf(now))) return false;
  if ((what == "ambient" || what == "lights") && scenesOwn(what)) return false;
  const bool placed = scene_.light.placed() || (!scenesOwn("lights") && light.lightPosition);
  if ((key == "attenuation" || key == "range" || key == "c") && !placed) return false;
  if (key == "light" && light.lightPosition) return false;
  if (key == "light" && own_.light.lightPosition) return true;  // it replaces this
  return value != setting.field.get(own_) || (!what.empty() && stripped(what));
}

std::string SetupCommand::settingsOf(const PictureSettings& now) const {
  std::string all, kept;
  for (const Setting& setting : settingRows()) {
    if (!says(setting, now)) continue;
    const Value value = setting.field.get(now);
    if (setting.field.kind == ValueKind::Flag)
      all += ' ' + std::string{setting.option} + (std::get<double>(value) != 0.0 ? "" : "=false");
    else
      all += option(setting.option, textOf(setting, value));
    if (!setting.replaces.empty() && scenesOwn(setting.replaces))
      kept += (kept.empty() ? "" : ",") + std::string{setting.replaces};
  }
  return all + (kept.empty() ? "" : option("--keep", kept));
}

CameraSettings SetupCommand::saidCamera(const PictureSettings& settings) const {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  const CameraSettings placed = saidOf(placeCamera(scene_, settings.camera, aspect), scene_);
  const CameraSettings& own = ownCamera_;
  CameraSettings said = settings.camera;
  if (!said.eye && !said.vpn && !said.prp && (own.eye || own.vpn || own.prp)) said.eye = placed.eye;
  if (!said.lookAt && !said.vrp && (own.lookAt || own.vrp)) said.lookAt = placed.lookAt;
  if (!said.up && !said.vup && (own.up || own.vup)) said.up = placed.up;
  const bool fits = said.parallel && !said.height && !said.oblique && !(own.parallel && !own.height);
  if (fits) said.height = placed.height;
  return said;
}

std::string SetupCommand::cameraOf(const PictureSettings& settings) const {
  const CameraSettings now = saidCamera(settings), &own = ownCamera_;
  std::string all;
  if (now.eye && (now.eye != own.eye || own.vpn || own.prp)) all += option("--eye", textOf(*now.eye));
  if (!now.eye) all += part("--vpn", now.vpn, own.vpn) + part("--prp", now.prp, own.prp);
  const auto oneOf = [&](std::string_view name, const auto& said, const auto& ownSaid,
                         std::string_view textbooks, const auto& said2, const auto& ownSaid2) {
    if (said == ownSaid && said2 == ownSaid2) return;
    all += said ? option(name, textOf(*said)) : option(textbooks, textOf(*said2));
  };
  oneOf("--look-at", now.lookAt, own.lookAt, "--vrp", now.vrp, own.vrp);
  oneOf("--up", now.up, own.up, "--vup", now.vup, own.vup);

  const auto seen = [](const CameraSettings& c) {
    return std::tuple{c.parallel, c.height, c.oblique, c.fov, c.window};
  };
  if (seen(now) != seen(own)) {
    const bool parallel = now.parallel || now.oblique;
    if (now.oblique) all += option("--oblique", textOf(*now.oblique));
    if (now.height) all += option("--parallel", textOf(*now.height));
    if (!parallel && !now.window) all += option("--fov", textOf(now.fov.value_or(kDefaultFov)));
    if (!parallel && now.window && (own.parallel || own.oblique)) cannotSay();
    if (const auto& w = now.window)
      all += option("--view-window",
                    textOf(w->x) + ',' + textOf(w->y) + ',' + textOf(w->z) + ',' + textOf(w->w));
  }
  return all + part("--front", now.front, own.front) + part("--back", now.back, own.back);
}

std::string SetupCommand::of(const PictureSettings& settings, int divisions, Fill fill,
                             const Drawing& drawing) const {
  if (settings.lights || scene_.origin.relit)
    throw ViewError{"no options can say the lights that were changed; save the set-up as a file (w)"};
  const bool server = fill == Fill::XFillPolygon;
  std::string command = server || drawing.wholeWindow ? "xnewell snapshot " : "xnewell draw ";
  command += quoted(asFile(scene_.origin.of));
  const glm::ivec2 size = drawing.size.value_or(glm::ivec2{settings.width, settings.height});
  command += option("--size", std::to_string(size.x) + 'x' + std::to_string(size.y));
  if (drawing.wholeWindow) command += " --whole-window";
  for (const auto& [name, value] : drawing.options) command += option(name, value);
  if (divisions == 0) divisions = scene_.origin.divisions;
  if (scene_.divisions > 0 && divisions != kDefaultDivisions)
    command += option("--divisions", std::to_string(divisions));
  command += settingsOf(settings);
  if (settings.mostPieces != PictureSettings{}.mostPieces)
    command += option("--max-fragments", std::to_string(settings.mostPieces));
  if (!scene_.origin.texture.empty()) command += option("--texture", scene_.origin.texture);
  if (const SceneMarks& marks = scene_.marks; marks.edges != ModelEdges::None) {
    command += option("--edges", std::string{kModelEdges[static_cast<std::size_t>(marks.edges)].name});
    if (marks.edgeColor != glm::dvec3{0})
      command += option("--edge-color", hexOf(figureColorOf(marks.edgeColor)));
  }
  if (server) command += " --fill x11";
  return command + cameraOf(settings) + " -o picture.png";
}

}  // namespace xnewell
