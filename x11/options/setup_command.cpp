#include "x11/options/setup_command.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <tuple>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "shading/figure/figure.h"
#include "shading/figure/write_figure.h"
#include "shading/scene/settings.h"
#include "shading/scene/units.h"
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

namespace {

using std::string_view;

constexpr string_view kOutput = " -o picture.png";  ///< the end of each command

/// The options of the picture that are no settings (settings.h).
constexpr std::array<string_view, 19> kOfPicture{
    "--size",        "--divisions", "--keep",    "--max-fragments", "--eye",       "--look-at", "--up",
    "--fov",         "--parallel",  "--oblique", "--vrp",           "--vpn",       "--vup",     "--prp",
    "--view-window", "--front",     "--back",    "--edges",         "--edge-color"};
/// What is drawn of the picture without the window, and how its colours are stored.
constexpr std::array<string_view, 8> kOfDrawing{"--scanline", "--cell", "--store",  "--turn",
                                                "--gamma",    "--bend", "--rotate", "--lit"};

/// Where the window begins.
constexpr std::array<string_view, 7> kOfWindow{"--scale",    "--step",   "--pixel",     "--viewing",
                                               "--controls", "--beside", "--difference"};

bool isOneOf(string_view name, const auto& names) { return std::ranges::find(names, name) != names.end(); }

bool mayCarry(string_view name) {
  return settingOf(name) != nullptr || isOneOf(name, kOfPicture) || isOneOf(name, kOfDrawing) ||
         isOneOf(name, kOfWindow) || name == "--view" || name == "--whole-window";
}

/// What a picture of a lesson says beside the lesson's name.
constexpr std::array<string_view, 3> kOfLesson{"--size", "--scale", "--step"};

bool isUtf8(const std::string& text) {
  try {
    return !nlohmann::json(text).dump().empty();
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

/// The file that a picture means by the name of its scene; "" if there is none.
std::string found(const std::string& scene, const std::filesystem::path& picture) {
  if (isBuiltIn(scene)) return scene;
  const std::filesystem::path name{scene}, folder = picture.parent_path();
  std::error_code missing;
  for (const auto& file : {folder / name, name, folder / name.filename()})
    if (std::filesystem::exists(file, missing) && !std::filesystem::is_directory(file, missing))
      return file.lexically_normal().string();
  return "";
}

string_view nameOf(string_view argument) { return argument.substr(0, argument.find('=')); }

}  // namespace

bool isPicture(const std::string& scene) {
  if (figureFormatOf(scene) != nullptr) return true;
  if (scene.size() < 4) return false;
  std::string end = scene.substr(scene.size() - 4);
  std::ranges::transform(end, end.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return end == ".png";
}

std::string noteOf(const Scene& scene, const PictureSettings& settings, int divisions, Fill fill,
                   const Drawing& drawing) {
  if (!scene.origin.texture.empty()) return "";
  try {
    std::string note = SetupCommand{scene}.of(settings, divisions, fill, drawing);
    return note.size() <= kLongestNote && isUtf8(note) ? note : "";
  } catch (const std::runtime_error&) {  // no options can say its camera, or a file has gone
    return "";
  }
}

std::string lessonNote(const std::string& lesson, glm::ivec2 size, int scale, int step) {
  std::string note =
      "xnewell lesson " + quoted(lesson) + " --size " + std::to_string(size.x) + 'x' + std::to_string(size.y);
  if (scale != 1) note += " --scale " + std::to_string(scale);
  note += " --step " + std::to_string(step);
  return note.size() <= kLongestNote && isUtf8(note) && !lesson.starts_with('-') ? note : "";
}

std::string noteOf(const Options& options, const Picture& picture) {
  if (options.bare) return "";
  Drawing drawing{.size = options.wholeWindow ? windowSize(options) : options.size.value_or(kPictureSize),
                  .wholeWindow = options.wholeWindow};
  for (std::size_t k = 0; k < options.given.size(); ++k) {
    const std::string& name = options.given[k];
    if (name == "--view" || isOneOf(name, kOfWindow) || isOneOf(name, kOfDrawing))
      drawing.options.emplace_back(name, options.values[k]);
  }
  PictureSettings settings = options.picture;
  settings.width = picture.settings().width, settings.height = picture.settings().height;
  return noteOf(picture.scene(), settings, picture.scene().divisions, options.fill, drawing);
}

CarriedSetup readCarriedSetup(const std::string& file) {
  const std::optional<std::string> note =
      figureFormatOf(file) != nullptr ? noteInFigure(file) : noteInPng(file);
  const auto fail = [&](const std::string& what) { throw ParseError{file, 0, what}; };
  if (!note) fail("the picture carries no set-up, so it is no scene");
  if (note->size() > kLongestNote)
    fail("the set-up that it carries is longer than " + std::to_string(kLongestNote) + " bytes");
  if (!isUtf8(*note)) fail("the set-up that it carries is not UTF-8");
  if (std::ranges::any_of(*note, [](unsigned char c) { return c < ' ' || c == 0x7F; }))
    fail("the set-up that it carries has control characters");
  const bool drawn = note->ends_with(kOutput);
  const auto words = wordsOf(string_view{*note}.substr(0, note->size() - (drawn ? kOutput.size() : 0)));
  const string_view command =
      words && words->size() >= 3 && words->at(0) == "xnewell" ? string_view{words->at(1)} : string_view{};
  if (!(drawn ? command == "draw" || command == "snapshot" : command == "lesson") || words->at(2).empty() ||
      words->at(2).starts_with('-'))
    fail("the set-up that it carries is no command of xnewell");

  CarriedSetup carried;
  carried.lesson = !drawn;
  carried.scene = words->at(2);
  if (isPicture(carried.scene)) fail("the scene of the set-up that it carries is a picture");
  if (!carried.lesson || carried.scene.ends_with(".json")) carried.scene = found(words->at(2), file);
  if (carried.scene.empty())
    fail("the scene of the set-up that it carries, " + words->at(2) + ", is not there");
  for (std::size_t k = 3; k < words->size(); ++k) {
    std::string argument = words->at(k);
    const std::string name{nameOf(argument)};
    if (!(carried.lesson ? isOneOf(name, kOfLesson) : mayCarry(name)))
      fail("a picture cannot carry " + inQuotes(name));
    if (argument == name && k + 1 < words->size() && !words->at(k + 1).starts_with('-'))
      argument += '=' + words->at(++k);
    carried.wholeWindow |= name == "--whole-window";
    carried.arguments.push_back(std::move(argument));
  }
  return carried;
}

std::vector<std::string> argumentsFor(Command command, const std::set<std::string>& said,
                                      const CarriedSetup& carried) {
  const bool window = command == Command::View, snapshot = command == Command::Snapshot;
  const bool shows = window || snapshot || command == Command::Draw;
  const bool whole = window || said.contains("--whole-window") || (snapshot && carried.wholeWindow);
  const auto fits = [&](string_view name) {
    if (carried.lesson) return true;
    if (name == "--fill") return window || snapshot;
    if (name.starts_with("--edge")) return shows || command == Command::Figure;
    if (name == "--size")
      return whole == carried.wholeWindow && command != Command::Extremes && rowOf(command).takes.empty() &&
             command != Command::Questions;
    if (name == "--view") return shows && (whole || !carried.wholeWindow);
    if (name == "--whole-window") return snapshot;
    if (name == "--order") return command != Command::Trace;  // it follows its own
    if (name == "--scale") return whole;
    if (isOneOf(name, kOfWindow)) return whole && !said.contains("--view");
    if (name == "--scanline" || name == "--cell")
      return shows && !said.contains("--view") && whole == carried.wholeWindow;
    if (isOneOf(name, kOfDrawing)) return shows && !whole && !said.contains("--view");
    return true;
  };
  const auto replaced = [&](const std::string& name) {
    const Setting* const setting = settingOf(name);
    return said.contains(name) || (setting && said.contains(std::string{setting->alias})) ||
           (name == "--light" && said.contains("--light-at")) ||
           (name == "--light-at" && said.contains("--light"));
  };
  std::vector<std::string> arguments;
  for (const std::string& argument : carried.arguments)
    if (fits(nameOf(argument)) && !replaced(std::string{nameOf(argument)})) arguments.push_back(argument);
  return arguments;
}

}  // namespace xnewell
