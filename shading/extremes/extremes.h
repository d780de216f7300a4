#pragma once

#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "shading/extremes/rays.h"

namespace xnewell {

/// Drives a scene to its extremes, one way after the other, and finds what becomes wrong first.

/// One picture on the way.
struct ExtremeStep {
  double value = 0;
  std::string refused = {};  ///< why no picture could be made; "" if there is one
  ByGroundTruth seen = {};   ///< which faces it shows
  /// The most by which the cell of a sample is off, in shades of its ramp: from the cell of the intensity in
  /// double precision.
  int shadesOff = 0;
  /// For a way that should change no sample: how many samples differ from the first picture by another face
  /// or by more than one shade.
  int changed = 0;
  int merged = 0;        ///< shades of the table that an X server cannot tell from the next one
  std::string why = {};  ///< what explains an error at this value, with numbers

  [[nodiscard]] bool isWrong() const;
  /// True if it is not wrong, but the grid cannot tell everywhere which face is the nearest.
  [[nodiscard]] bool isDoubtful() const { return !isWrong() && seen.doubtful > 0; }
  /// True if no face shows, and rightly so.
  [[nodiscard]] bool isEmpty() const { return refused.empty() && seen.samples == 0; }
};

/// One way to an extreme.
struct Extreme {
  std::string_view name;    ///< "moved by"
  std::string_view unit;    ///< "times its size"
  std::string_view drives;  ///< a sentence: what is done to the scene
  std::vector<ExtremeStep> steps = {};
};

struct Extremes {
  ExtremeStep setUp;  ///< the scene as it is, with its own camera and method
  std::vector<Extreme> ways = {};
  int allWays = 0;  ///< how many there are; `ways` has fewer if the user stopped it
  [[nodiscard]] bool isStopped() const { return std::ssize(ways) < allWays; }
};

/// A number with at most four digits: 0.01, 1e+15. A power of two that would take more is written as one:
/// 2^900.
[[nodiscard]] std::string shortly(double v);

/// Drives the scene all ways, on so many threads; 0 stands for one on each processor. Calls `goOn` before
/// each picture, one call at a time, with what it shows ("moved by 1e+09"), and stops if that returns false;
/// only whole ways are returned. Pictures have the size, camera and method of the settings, but their cells
/// hold one hue. The ways that test the light use Phong shading.
/// @throws ViewError if the scene itself has no picture or no extent
[[nodiscard]] Extremes extremesOf(const Scene& scene, const PictureSettings& settings,
                                  const std::function<bool(const std::string& doing)>& goOn = {},
                                  int threads = 0);

/// What was found on a way, in words. What is said "up to" or "from ... on" holds at every value that was
/// tried there.

/// "Stopped: 5 of 13 ways were finished."; "" if all were.
[[nodiscard]] std::string stoppedText(const Extremes& extremes);

/// What is wrong with the picture of the scene as it is: "The set-up itself is wrong: a face that is not the
/// nearest at 96 of 720 samples.", or doubtful, or that it shows no face; "" if it is right.
[[nodiscard]] std::string findingOf(const ExtremeStep& setUp);

/// What was found on a way: "right up to 1e+09 times its size", or each fault with the values that have it:
/// "wrong from 1e+12 times its size on: another face or shade than at first at 1 of 477 samples". What is
/// wrong in the same way where the way begins as in the set-up is told without numbers. What is only
/// doubtful is called so.
[[nodiscard]] std::string findingOf(const Extreme& way, const ExtremeStep& setUp);

/// The first step with a fault that the way did not begin with because of the set-up; nullptr if there is
/// none.
[[nodiscard]] const ExtremeStep* firstWrong(const Extreme& way, const ExtremeStep& setUp);

/// The same, or if no step is wrong, the first that is doubtful or shows no face. Its `why` explains what was
/// found.
[[nodiscard]] const ExtremeStep* firstToExplain(const Extreme& way, const ExtremeStep& setUp);

}  // namespace xnewell
