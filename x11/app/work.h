#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "shading/picture/picture_cache.h"
#include "x11/window/controls.h"

namespace xnewell {

/// A scene, and all that the user did to it.
class Work {
 public:
  Work(Scene scene, const Setup& setup);

  /// Makes `next` the setup. undo() brings the present one back. Changes by one control, one after the other,
  /// are one step.
  void change(char control, const Setup& next);
  /// The next change begins a step of its own.
  void endStep() { lastChanged_ = 0; }
  /// Takes back a step, or a step back. Returns false if there is none.
  bool undo() { return restore(before_, after_); }
  bool redo() { return restore(after_, before_); }
  /// Divides the scene's patches as often as the setup says. If it does not say, they get the divisions that
  /// they were read with.
  void divide();
  /// Writes the set-up as a scene file. Throws std::system_error if it cannot.
  void save(const std::string& name);
  /// True if leaving loses nothing.
  [[nodiscard]] bool isSaved() const { return file.empty() || setup == saved; }

  PictureCache pictures;
  glm::dvec3 centre;  ///< of the scene, in the file's units
  Setup setup, defaults;
  std::string file;  ///< the scene file that this was saved in or opened from; "" for none
  Setup saved;       ///< the setup in that file
  int divisions;     ///< the divisions that the scene was read with

 private:
  static constexpr std::size_t kMostUndone = 1000;  // steps; each takes less than a kilobyte
  bool restore(std::vector<Setup>& from, std::vector<Setup>& to);

  std::vector<Setup> before_, after_;  ///< what undo() and redo() bring back, the next one last
  char lastChanged_ = 0;               ///< the control of the newest step; its further changes join that step
};

/// The setup that the options of readyScene() ask for.
[[nodiscard]] inline Setup setupOf(const Options& options) {
  return {.picture = options.picture, .fill = options.fill, .show = options.show};
}

/// Settings for a quick picture that still shows where everything is.
[[nodiscard]] PictureSettings coarse(PictureSettings settings);

}  // namespace xnewell
