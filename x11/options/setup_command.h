#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "shading/picture/picture.h"
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

/// A picture is its own source: its file carries the command that draws it, as setup_command.h words it.
/// Figures do, too (write_figure.h).

/// The longest command that a picture carries, in bytes. With a longer one it carries none.
inline constexpr std::size_t kLongestNote = 2000;

/// The note for the file of a picture that `draw`, `snapshot` or `figure` makes. It is "", so that the file
/// carries no set-up, if the command would be too long, is not UTF-8, rests on another file than the scene's
/// (--texture), or if there is none that draws the picture again.
[[nodiscard]] std::string noteOf(const Options& options, const Picture& picture);
/// The same for any other picture, in the words of SetupCommand::of().
[[nodiscard]] std::string noteOf(const Scene& scene, const PictureSettings& settings, int divisions,
                                 Fill fill, const Drawing& drawing);

/// The note for the picture of a step of a lesson, from 1. `lesson` is a built-in name or a file's name.
[[nodiscard]] std::string lessonNote(const std::string& lesson, glm::ivec2 size, int scale, int step);

/// What a picture's file carries.
struct CarriedSetup {
  std::string scene;                   ///< or the lesson
  bool lesson = false;                 ///< the picture shows a step of a lesson
  bool wholeWindow = false;            ///< the picture shows the window with all its controls
  std::vector<std::string> arguments;  ///< "--shade=phong": each an option of our own with its value
};
/// Reads the note of a file. A scene's file of a relative path is looked for from the picture's folder, then
/// from the working directory, then beside the picture by its name alone. Nothing that it says is trusted: it
/// is one of our commands, and it has no option that names a file, but the scene or the lesson. @throws
/// ParseError, std::system_error
[[nodiscard]] CarriedSetup readCarriedSetup(const std::string& file);

/// True if the name of a scene is that of a picture or a figure.
[[nodiscard]] bool isPicture(const std::string& scene);

/// The arguments that make sense for a command. `said` are the names of what the user gave beside the
/// picture.
[[nodiscard]] std::vector<std::string> argumentsFor(Command command, const std::set<std::string>& said,
                                                    const CarriedSetup& carried);

}  // namespace xnewell
