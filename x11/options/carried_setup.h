#pragma once

#include <set>
#include <string>
#include <vector>

#include "shading/picture/picture.h"
#include "x11/options/options.h"
#include "x11/options/setup_command.h"

namespace xnewell {

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
