#pragma once

#include <string_view>

#include "x11/window/bench.h"

namespace xnewell {

/// What keys do to a setup. A letter gives a slider the focus, or takes a choice's next option. Arrows change
/// the control that has the focus. This object remembers the focus.
class ControlKeys {
 public:
  /// The scene. Camera and light turn about it.
  struct Subject {
    const Scene& scene;
    glm::dvec3 centre;  ///< of the scene; the direction of a point light is measured from here
    double aspect;      ///< of the picture, width to height
  };

  [[nodiscard]] char focus() const { return focus_; }
  void setFocus(char control) { focus_ = control; }

  /// Handles a key for the controls in `which`. Returns false if none of them uses the key. The host gets the
  /// changes and the notices.
  bool press(const Key& key, std::string_view which, const Setup& setup, const Subject& subject, Host& host);

 private:
  bool pressLetter(char letter, const Setup& setup, const Subject& subject, Host& host);
  void move(int along, int up, const Setup& setup, const Subject& subject, Host& host);
  void toEnd(bool high, const Setup& setup, Host& host);
  void nextFocus(int direction, std::string_view which);
  void askForValue(const Setup& setup, Host& host);

  char focus_ = 's';
};

/// The letters of all controls.
[[nodiscard]] std::string_view allControls();

/// The camera of the setup.
[[nodiscard]] Camera cameraOf(const Setup& setup, const ControlKeys::Subject& subject);
/// turn() turns the camera about the scene, by degrees. zoom() moves it nearer by a factor.
void turn(Host& host, const Setup& setup, const ControlKeys::Subject& subject, double azimuth,
          double elevation);
void zoom(Host& host, const Setup& setup, const ControlKeys::Subject& subject, double factor);
/// Takes an option of a choice. If the server cannot fill such a picture, the scanline filler takes over, and
/// a notice says so.
void choose(Host& host, const ChoiceRow& row, int option);

}  // namespace xnewell
