#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/picture/picture.h"
#include "shading/scene/divide_anew.h"
#include "shading/scene/settings.h"

namespace xnewell {

/// How wrong a picture may be.
struct AccuracyLimit {
  double rms = 0.03;  ///< of the intensity after the table
  /// Samples of the user's view that may show a wrong face; any number if nothing is said. The RMS error
  /// alone is small where wrong faces have nearly the right intensity.
  std::optional<std::int64_t> wrong = {};
  bool operator==(const AccuracyLimit&) const = default;
};

/// How long a choice within a limit may take, in seconds of the processor's time.
inline constexpr double kAccuracySeconds = 8;

/// What a trade (trade.h) is asked to look at.
struct TradeRequest {
  std::vector<std::string> axes = {};     ///< names of axes; empty for all
  std::vector<std::string> without = {};  ///< "order=none": values to leave out
  /// Leaves out what a choice does not need: colours, and the distance from patches.
  bool brief = false;
  double seconds = 30;   ///< of the processor's time, about; above 0
  int mostRounds = 200;  ///< of timing
  unsigned seed = 1;
};

/// The short cuts of a picture, and what else could be chosen for each.

/// One short cut: a setting whose role is one, or the divisions of the patches.
struct Axis {
  const Setting* setting = nullptr;  ///< null for the divisions
  double now = 0;                    ///< the value that the user chose
  std::vector<double> others;        ///< what else to try

  /// Its option without the dashes: "order", "divisions".
  [[nodiscard]] std::string_view name() const {
    return setting ? setting->option.substr(2) : std::string_view{"divisions"};
  }
  /// A value as the option has it: "zsort", "8".
  [[nodiscard]] std::string text(double value) const;
};

/// A set-up in which some short cuts have other values than the user chose.
struct Change {
  const Setting* setting = nullptr;  ///< null for the divisions
  double value = 0;
  bool operator==(const Change&) const = default;
};
struct Configuration {
  PictureSettings settings;
  int divisions = 0;  ///< of the patches; 0 if the scene has none
  std::vector<Change> changes = {};

  /// "flat, Newell, 4 divisions"; "as it is" without changes.
  [[nodiscard]] std::string name() const;
  /// What to add to the command line: "--shade flat --divisions 4"; "" without changes. A flag that is off
  /// has no option: then leave out the option.
  [[nodiscard]] std::string options() const;
};

/// The short cuts that have an effect on a picture as it is, or all: some have one only beside others, such
/// as the rule for normals if the method is flat shading.
enum class Reach { Alone, BesideOthers };
/// The axes in the order of the rows, the divisions first. An X server would have to time its own filler, so
/// `fill` is not among them. The divisions are one where they change a patch: where the scene's file does not
/// set those of all.
[[nodiscard]] std::vector<Axis> axesOf(const Picture& picture, Reach reach = Reach::Alone);

/// The names of those axes on which the program may choose by itself: all but the plan of the colours. A
/// picture in one hue has one intensity, and a picture in colours has three, so their errors do not compare,
/// and the intensity does not tell that colours are lost.
[[nodiscard]] std::vector<std::string> choosableAxes(const Picture& picture);

/// True if each change has an effect on this picture, beside the others.
[[nodiscard]] bool allHaveEffect(const Configuration& configuration, const Picture& asked);

/// The configuration with another value of one short cut.
[[nodiscard]] Configuration changed(Configuration configuration, const Axis& axis, double value);

/// The camera of a picture, said in full. So it stays when the polygons change.
[[nodiscard]] CameraSettings heldCamera(const Picture& picture);

}  // namespace xnewell
