#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shading/scene/scene.h"
#include "x11/options/options.h"

namespace xnewell {

/// What a command draws, if it is not just the picture in the size that the settings say.
struct Drawing {
  std::optional<glm::ivec2> size = {};  ///< of the file's picture
  bool wholeWindow = false;             ///< the window with its controls, so the command is `snapshot`
  std::vector<std::pair<std::string, std::string>> options = {};  ///< "--view" and "machbands"
};

/// A set-up in words: the command that draws it again.
class SetupCommand {
 public:
  /// The scene must outlive this. If it was read from a set-up's file, the scene that the file names is read
  /// again, because the command names that one. @throws what readScene() throws
  explicit SetupCommand(const Scene& scene);

  /// "xnewell draw SCENE --size 800x600 --shade phong -o picture.png": every setting that differs from what
  /// the scene asks for by itself, its camera too. Settings without effect that the command would refuse are
  /// left out. The size of `settings` is that of the picture. `divisions` are those of the patches; 0: as the
  /// scene was read. Only a server fills with XFillPolygon, so the command is then `snapshot`.
  /// @throws ViewError if no options can say the camera: one that lacks a part that the scene's own has
  [[nodiscard]] std::string of(const PictureSettings& settings, int divisions = 0, Fill fill = Fill::Scanline,
                               const Drawing& drawing = {}) const;

 private:
  [[nodiscard]] bool stripped(std::string_view what) const;
  /// Whether the scene itself, as it is now, says what the setting would replace.
  [[nodiscard]] bool scenesOwn(std::string_view what) const;
  /// Whether the command gives the setting; `now` is in the file's units.
  [[nodiscard]] bool says(const Setting& setting, const PictureSettings& now) const;
  [[nodiscard]] std::string settingsOf(const PictureSettings& now) const;
  /// The camera in the file's units. Where it leaves out a part that the scene's own has, it says what was
  /// chosen for it.
  [[nodiscard]] CameraSettings saidCamera(const PictureSettings& settings) const;
  [[nodiscard]] std::string cameraOf(const PictureSettings& settings) const;

  const Scene& scene_;
  PictureSettings own_;       ///< what the scene asks for by itself, in the file's units
  CameraSettings ownCamera_;  ///< the same
};

}  // namespace xnewell
