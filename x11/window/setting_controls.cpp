#include "x11/window/setting_controls.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shading/scene/units.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Kind = Control::Kind;

/// The hues that the key `H` visits.
struct HueRow {
  std::string_view name;
  glm::dvec3 hue;
};
constexpr std::array kHues{
    HueRow{"red", {1, 0, 0}},      HueRow{"amber", {1, 0.7, 0}}, HueRow{"green", {0, 1, 0}},
    HueRow{"blue", {0.3, 0.5, 1}}, HueRow{"gray", {1, 1, 1}},
};

/// The gammas that the key `g` visits.
constexpr std::array kGammas{1.0, 1.4, 1.8, 2.2};

/// The number of a setting: of three numbers, which are a hue, the index in kHues or -1. In the setup the
/// window keeps its own filler; the picture's setting is set only when a picture is made for the server.
double numberIn(const Setup& setup, const Setting& setting) {
  if (setting.key == "fill") return static_cast<double>(setup.fill);
  const Value value = setting.field.get(setup.picture);
  if (const auto* const number = std::get_if<double>(&value)) return *number;
  const auto* const now = std::ranges::find(kHues, std::get<glm::dvec3>(value), &HueRow::hue);
  return now == kHues.end() ? -1.0 : static_cast<double>(now - kHues.begin());
}

void setIn(Setup& setup, const Setting& setting, double number) {
  if (setting.key == "fill") {
    setup.fill = static_cast<Fill>(number);
    return;
  }
  const bool hue = setting.field.kind == ValueKind::Triple;
  const Value value = hue ? Value{kHues[static_cast<std::size_t>(number)].hue} : Value{number};
  (void)applyOverrides(setup.picture, {{&setting, value}});
}

Control controlOf(const Setting& setting, const Setup& shown, const Setup& defaults, ChangeSetup change) {
  Control control{.kind = setting.slider                          ? Kind::Slider
                          : setting.field.kind == ValueKind::Flag ? Kind::Toggle
                                                                  : Kind::Choice,
                  .key = setting.control,
                  .label = std::string{setting.label},
                  .is = std::string{setting.is},
                  .value = numberIn(shown, setting),
                  .set = [&setting, change = std::move(change)](double number) {
                    change(setting.control, [&](Setup& s) { setIn(s, setting, number); });
                  }};
  for (const Choice& choice : setting.field.choices) control.options.emplace_back(choice.label);
  if (setting.field.kind == ValueKind::Triple)
    for (const HueRow& row : kHues) control.options.emplace_back(row.name);
  if (const auto& track = setting.slider) {
    control.range = {track->low, track->high, track->step, track->logarithmic, track->decimals};
    control.initially = numberIn(defaults, setting);
    if (!hasEffect(setting, factsOf(shown.picture))) control.off = noEffect(setting.label, setting) + ".";
  }
  return control;
}

/// The terms of the equation share one option, the last; each choice of it goes on to the next term.
Control showControl(const Setup& shown, ChangeSetup change) {
  static const auto* const firstTerm = std::ranges::find(kViews, Term::Ambient, &ViewRow::term);
  static const std::ptrdiff_t terms = firstTerm - kViews.begin() - std::ssize(kWindowViews) + 1;
  const auto goesOn = [](const Setup& s) { return rowOf(s.show).term && s.show != kViews.back().id; };
  const auto optionOf = [](View show) {
    if (show == View::Picture) return std::ptrdiff_t{0};
    return std::min(terms, static_cast<std::ptrdiff_t>(show) - std::ssize(kWindowViews) + 1);
  };
  Control control{.kind = Kind::Choice,
                  .key = 'W',
                  .label = "show",
                  .is = "what the picture shows",
                  .value = static_cast<double>(optionOf(shown.show)),
                  .set = [goesOn, change = std::move(change)](double option) {
                    change('W', [&](Setup& s) {
                      const auto k = static_cast<std::size_t>(option);
                      if (k == static_cast<std::size_t>(terms) && goesOn(s))
                        s.show = static_cast<View>(static_cast<int>(s.show) + 1);
                      else
                        s.show = k == 0 ? View::Picture : kInsteadOfPicture[k - 1].id;
                    });
                  }};
  if (goesOn(shown)) control.next = static_cast<double>(terms);
  control.options.emplace_back("shaded");
  for (std::ptrdiff_t k = 1; k < terms; ++k) control.options.emplace_back(kInsteadOfPicture[k - 1].title);
  control.options.emplace_back("term");
  return control;
}

Control projectionControl(const Setup& shown, ChangeSetup change) {
  const CameraSettings& camera = shown.picture.camera;
  return {.kind = Kind::Choice,
          .key = 'P',
          .label = "project",
          .is = "the projection: in perspective, distant things look smaller",
          .value = camera.parallel || camera.oblique ? 0.0 : 1.0,
          .options = {"parallel", "perspective"},
          .set = [change = std::move(change)](double option) {
            change('P', [&](Setup& s) {
              s.picture.camera.parallel = option == 0;
              s.picture.camera.oblique.reset();
              s.picture.camera.height.reset();
            });
          }};
}

/// The order of the controls: sliders, toggles, choices, the hue, and the choices that have no place in the
/// column.
int rankOf(const Setting& setting) {
  if (setting.slider) return setting.section == Section::Method ? 2 : 0;  // `crease` follows the normals
  if (setting.field.kind == ValueKind::Flag) return 1;
  if (setting.field.kind == ValueKind::Triple) return 3;
  return setting.section == Section::Hidden ? 4 : 2;
}

}  // namespace

Control settingControl(char key, const Setup& shown, const Setup& defaults, ChangeSetup change) {
  if (key == 'W') return showControl(shown, std::move(change));
  if (key == 'P') return projectionControl(shown, std::move(change));
  return controlOf(*settingOf(key), shown, defaults, std::move(change));
}

Control gammaControl(double shown, std::function<void(double gamma)> change) {
  const auto* const now = std::ranges::find(kGammas, shown);
  Control control{.kind = Kind::Choice,
                  .key = 'g',
                  .label = "gamma",
                  .is = "the gamma of the screen that the colours are corrected for",
                  .value = now == kGammas.end() ? -1.0 : static_cast<double>(now - kGammas.begin()),
                  .set = [change = std::move(change)](double option) {
                    change(kGammas[static_cast<std::size_t>(option)]);
                  }};
  for (const double gamma : kGammas) control.options.push_back(fixed(gamma, 1));
  return control;
}

std::string ownOfScene(char control, const Setup& shown, const Scene& scene) {
  const Setting* const setting = settingOf(control == '[' ? 'i' : control == ']' ? 'p' : control);
  const std::string_view what = setting ? setting->replaces : "";
  if (what == "ambient" && scene.light.Ia)
    return "The scene has its own ambient light, so Ia cannot be changed.";
  if (what == "ambient" && control != '[') return "";
  if (what == "lights" || control == '[')
    return hasOwnLamps(shown, scene)
               ? "The scene has its own lights: in view 1, l chooses one and p changes its Ip."
               : "";
  const auto own = [&](int material) {
    if (material < 0) return false;
    const MeshMaterial& m = scene.mesh.materials[static_cast<std::size_t>(material)];
    return what == "ka" ? !!m.ka : what == "kd" ? !!m.kd : what == "ks" ? !!m.ks : !!m.n;
  };
  if (what.empty() || !std::ranges::all_of(scene.mesh.material, own)) return "";
  return "All surfaces of the scene have their own " + std::string{what} + ", so it cannot be changed.";
}

Controls settingControls(const Setup& shown, const Setup& defaults, const ChangeSetup& change,
                         const Scene& scene) {
  Controls all;
  for (int rank = 0; rank <= 4; ++rank) {
    if (rank == 2) all.push_back(showControl(shown, change));
    for (const Setting& setting : settingRows()) {
      if (setting.control == 0 || rankOf(setting) != rank) continue;
      all.push_back(controlOf(setting, shown, defaults, change));
      if (setting.key == "fill") all.push_back(projectionControl(shown, change));
    }
  }
  for (Control& control : all)
    if (control.enabled()) control.off = ownOfScene(control.key, shown, scene);
  return all;
}

Controls cameraControls(const Setup& shown, const Subject& subject, const ChangeSetup& change) {
  return {{.kind = Kind::Own,
           .key = 't',
           .label = "turn",
           .is = "turn the scene; its light turns with it, as the ring on the ball shows",
           .move = [=](int along, int up) { turn(change, shown, subject, -2.0 * along, -2.0 * up); },
           .drag =
               [=](int, int, int dx, int dy) {
                 if (dx != 0 || dy != 0) turn(change, shown, subject, -0.5 * dx, 0.5 * dy);
               }},
          {.kind = Kind::Own,
           .key = 'z',
           .label = "zoom",
           .is = "come nearer or go away with the arrows",
           .move = [=](int along, int up) { zoom(change, shown, subject, std::pow(1.02, along + up)); }}};
}

Control lightControl(const Setup& shown, const Subject& subject, const ChangeSetup& change,
                     std::size_t lamp) {
  const auto degrees = [](double angle) { return fixed(angle, 0) + "\u00B0"; };
  const glm::dvec3 centre = inSceneUnits(subject.centre, subject.scene);
  const LightAngles at = lightAngles(lampsOf(shown, subject.scene)[lamp], subject.scene.up, centre);
  return {.kind = Kind::Own,
          .key = 'l',
          .part = static_cast<int>(lamp),
          .label = "light",
          .is = "where the light is: drag it on the ball",
          .words = "azimuth " + degrees(at.azimuth) + ", elevation " + degrees(at.elevation),
          .move = [=](int along, int up) {
            change('l', [&](Setup& s) {
              Light light = lampsOf(s, subject.scene)[lamp];
              turnLight(light, subject.scene.up, along, up, centre);
              putLamp(s, subject.scene, lamp, light);
            });
          }};
}

KeyTable zoomKeys(const Setup& shown, const Subject& subject, const ChangeSetup& change) {
  const auto by = [=](double factor) { return [=](const Key&) { zoom(change, shown, subject, factor); }; };
  const std::string does = "come nearer, go away; or turn the wheel";
  return {{{'+'}, "zoom", does, by(1.1)}, {{'-'}, "zoom", does, by(1.0 / 1.1)}};
}

Camera cameraOf(const Setup& setup, const Subject& subject) {
  return placeCamera(subject.scene, setup.picture.camera, subject.aspect);
}

void turn(const ChangeSetup& change, const Setup& shown, const Subject& subject, double azimuth,
          double elevation) {
  const Camera camera = cameraOf(shown, subject);
  change('t', [&](Setup& s) {
    s.picture.camera = moved(s.picture.camera, camera, subject.scene, azimuth, elevation, 1.0);
  });
}

void zoom(const ChangeSetup& change, const Setup& shown, const Subject& subject, double factor) {
  const Camera camera = cameraOf(shown, subject);
  change('z', [&](Setup& s) {
    s.picture.camera = moved(s.picture.camera, camera, subject.scene, 0.0, 0.0, factor);
  });
}

}  // namespace xnewell
