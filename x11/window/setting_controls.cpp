#include "x11/window/setting_controls.h"

#include <algorithm>
#include <cmath>

#include "shading/scene/units.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Kind = Control::Kind;

Control sliderControl(const SliderRow& row, const Setup& shown, const Setup& defaults, ChangeSetup change) {
  return {.kind = Kind::Slider,
          .key = row.key,
          .label = std::string{row.label},
          .is = std::string{row.setting->is},
          .value = row.get(shown),
          .range = {row.low, row.high, row.step, row.logarithmic, row.decimals},
          .initially = row.get(defaults),
          .off = row.enabled(shown) ? std::string{} : row.whenOff(),
          .set = [&row, change = std::move(change)](double value) {
            change(row.key, [&](Setup& s) { row.set(s, value); });
          }};
}

Control choiceControl(const ChoiceRow& row, const Setup& shown, ChangeSetup change) {
  return {.kind = Kind::Choice,
          .key = row.key,
          .label = std::string{row.label},
          .is = std::string{row.tells},
          .value = static_cast<double>(row.get(shown)),
          .options = {row.options.begin(), row.options.end()},
          .next = row.next ? std::optional<double>{row.next(shown)} : std::nullopt,
          .set = [&row, change = std::move(change)](double option) {
            change(row.key, [&](Setup& s) { row.set(s, static_cast<int>(option)); });
          }};
}

Control toggleControl(const ToggleRow& row, const Setup& shown, ChangeSetup change) {
  return {.kind = Kind::Toggle,
          .key = row.key,
          .label = std::string{row.label},
          .is = std::string{row.setting->is},
          .value = row.get(shown) ? 1.0 : 0.0,
          .set = [&row, change = std::move(change)](double on) {
            change(row.key, [&](Setup& s) { row.setting->field.set(s.picture, on); });
          }};
}

Control hueControl(const Setup& shown, ChangeSetup change) {
  const auto* const now = std::ranges::find(kHues, shown.picture.table.hue, &HueRow::hue);
  Control control{
      .kind = Kind::Choice,
      .key = 'H',
      .label = std::string{settingOf('H')->label},
      .is = std::string{settingOf('H')->is},
      .value = now == kHues.end() ? -1.0 : static_cast<double>(now - kHues.begin()),
      .set = [change = std::move(change)](double option) {
        change('H', [&](Setup& s) { s.picture.table.hue = kHues[static_cast<std::size_t>(option)].hue; });
      }};
  for (const HueRow& row : kHues) control.options.emplace_back(row.name);
  return control;
}

}  // namespace

Control settingControl(char key, const Setup& shown, const Setup& defaults, ChangeSetup change) {
  if (key == 'H') return hueControl(shown, std::move(change));
  if (const SliderRow* const row = sliderOf(key))
    return sliderControl(*row, shown, defaults, std::move(change));
  if (const ChoiceRow* const row = choiceOf(key)) return choiceControl(*row, shown, std::move(change));
  return toggleControl(*toggleOf(key), shown, std::move(change));
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

std::string ownOfScene(char control, const Scene& scene) {
  const Setting* const setting = settingOf(control == '[' ? 'i' : control == ']' ? 'p' : control);
  const std::string_view what = control == 'l' ? "lights" : setting ? setting->replaces : "";
  if (what == "ambient")
    return scene.light.Ia ? "The scene has its own ambient light, so Ia cannot be changed." : "";
  if (what == "lights")
    return scene.light.lights.empty()
               ? ""
               : "The scene has its own lights, so Ip and the light's direction cannot be changed.";
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
  for (const SliderRow& row : sliders()) all.push_back(sliderControl(row, shown, defaults, change));
  for (const ToggleRow& row : toggles()) all.push_back(toggleControl(row, shown, change));
  for (const ChoiceRow& row : choices()) all.push_back(choiceControl(row, shown, change));
  all.push_back(hueControl(shown, change));
  for (const ChoiceRow& row : others()) all.push_back(choiceControl(row, shown, change));
  for (Control& control : all)
    if (control.enabled()) control.off = ownOfScene(control.key, scene);
  return all;
}

Controls cameraControls(const Setup& shown, const Subject& subject, const ChangeSetup& change) {
  return {{.kind = Kind::Own,
           .key = 't',
           .label = "turn",
           .is = "turn the scene with the arrows",
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

Control lightControl(const Setup& shown, const Subject& subject, const ChangeSetup& change) {
  const auto degrees = [](double angle) { return fixed(angle, 0) + "\u00B0"; };
  const LightAngles at = lightAngles(shown.picture.light, subject.scene.up, subject.centre);
  return {.kind = Kind::Own,
          .key = 'l',
          .label = "light",
          .is = "where the light is: drag it on the ball",
          .words = "azimuth " + degrees(at.azimuth) + ", elevation " + degrees(at.elevation),
          .off = ownOfScene('l', subject.scene),
          .move = [=](int along, int up) {
            change('l', [&](Setup& s) {
              turnLight(s.picture.light, subject.scene.up, along, up, subject.centre);
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
