#pragma once

#include <string_view>

#include "x11/window/bench.h"

namespace xnewell {

/// What keys do to a setup: letters go to a control or take its next option, arrows change the one that has
/// the keyboard. Which control that is, is kept.
class ControlKeys {
 public:
  /// The scene that is set up: camera and light turn about it.
  struct Subject {
    const Scene& scene;
    glm::dvec3 centre;  ///< of the scene: where a point light is seen from
    double aspect;      ///< of the picture
  };

  [[nodiscard]] char focus() const { return focus_; }
  void setFocus(char control) { focus_ = control; }

  /// False where no control of `which` answers to the key. Changes and what is to be told go to the host.
  bool press(const Key& key, std::string_view which, const Setup& setup, const Subject& subject, Host& host);

 private:
  bool pressLetter(char letter, const Setup& setup, const Subject& subject, Host& host);
  void move(int along, int up, const Setup& setup, const Subject& subject, Host& host);
  void toEnd(bool high, const Setup& setup, Host& host);
  void nextFocus(int direction, std::string_view which);
  void askForValue(const Setup& setup, Host& host);

  char focus_ = 's';
};

/// Every letter that is a control's.
[[nodiscard]] std::string_view allControls();

/// As the setup has it.
[[nodiscard]] Camera cameraOf(const Setup& setup, const ControlKeys::Subject& subject);
/// Turns the camera about the scene by degrees, or comes nearer by a factor.
void turn(Host& host, const Setup& setup, const ControlKeys::Subject& subject, double azimuth,
          double elevation);
void zoom(Host& host, const Setup& setup, const ControlKeys::Subject& subject, double factor);
/// The option of a choice; where the server cannot fill such a picture we fill it, and that is told.
void choose(Host& host, const ChoiceRow& row, int option);

}  // namespace xnewell
