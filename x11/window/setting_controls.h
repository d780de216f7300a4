#pragma once

#include <functional>

#include "x11/kit/control.h"
#include "x11/window/controls.h"
#include "x11/window/host.h"

namespace xnewell {

/// The controls of a setup and of its scene, for any view that shows them. Each is made from the row of its
/// setting (settings.h), so all views have the same letter, name, range and words for it.

/// Changes a setup. Changes in a row with the same `control` are undone as one.
using ChangeSetup = std::function<void(char control, const std::function<void(Setup&)>& edit)>;

/// The scene that is pictured. Camera and light turn about its centre.
struct Subject {
  const Scene& scene;
  glm::dvec3 centre;  ///< in the file's units; the direction of a point light is measured from here
  double aspect;      ///< of the picture, width to height
};

/// The control of a setting's key, of `P` or of `W`. It shows `shown`, and `defaults` on its track. Ia and Ip
/// are two thumbs on one bar: the thumb that moves pushes the other, so that Ia + Ip <= 1.
[[nodiscard]] Control settingControl(char key, const Setup& shown, const Setup& defaults, ChangeSetup change);
/// The screen's gamma that the colours are corrected for: one of a few. It is no setting of a picture.
[[nodiscard]] Control gammaControl(double shown, std::function<void(double gamma)> change);
/// The controls of all settings, in the order of their rows. What the scene has of its own is off.
[[nodiscard]] Controls settingControls(const Setup& shown, const Setup& defaults, const ChangeSetup& change,
                                       const Scene& scene);
/// Why the control of a key has no effect on the scene: a sentence, where the scene has of its own what the
/// setting would say (Setting::replaces). "" if it has not.
[[nodiscard]] std::string ownOfScene(char control, const Setup& shown, const Scene& scene);

/// Turning and zooming, as controls that the arrows change.
[[nodiscard]] Controls cameraControls(const Setup& shown, const Subject& subject, const ChangeSetup& change);
/// Where one of lampsOf() is, as a control that the arrows turn. Its words are the angles.
[[nodiscard]] Control lightControl(const Setup& shown, const Subject& subject, const ChangeSetup& change,
                                   std::size_t lamp = 0);

/// `+` and `-`: nearer and farther by a tenth.
[[nodiscard]] KeyTable zoomKeys(const Setup& shown, const Subject& subject, const ChangeSetup& change);

/// The camera of the setup.
[[nodiscard]] Camera cameraOf(const Setup& setup, const Subject& subject);
/// turn() turns the camera about the scene, by degrees; dragging turns half a degree a unit. zoom() moves it
/// nearer by a factor.
void turn(const ChangeSetup& change, const Setup& shown, const Subject& subject, double azimuth,
          double elevation);
void zoom(const ChangeSetup& change, const Setup& shown, const Subject& subject, double factor);

}  // namespace xnewell
