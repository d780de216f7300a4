#pragma once

#include <functional>
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
  JudgedByRays seen = {};    ///< which faces it shows
  /// The most by which the cell of a sample is off, in shades of its ramp: from the cell of the intensity in
  /// double precision.
  int shadesOff = 0;
  /// For a way that should change no sample: how many samples differ from the first picture by another face
  /// or by more than one shade.
  int changed = 0;
  int merged = 0;   ///< shades of the table that an X server cannot tell from the next one
  std::string why;  ///< what explains an error at this value, with numbers

  [[nodiscard]] bool isWrong() const {
    return !refused.empty() || seen.wrong > 0 || shadesOff > 1 || changed > 0 || merged > 0;
  }
};

/// One way to an extreme. The first step is the scene as it is.
struct Extreme {
  std::string_view name;    ///< "moved by"
  std::string_view unit;    ///< "times its size"
  std::string_view drives;  ///< a sentence: what is done to the scene
  std::vector<ExtremeStep> steps = {};
};

/// A number with three digits: 0.01, 1e+15.
[[nodiscard]] std::string shortly(double v);

/// Drives the scene all ways. Calls `progress` before each with its name. Pictures have the size, camera and
/// method of the settings, but their cells hold one hue. The ways that test the light use Phong shading.
/// @throws ViewError if the scene itself has no picture
[[nodiscard]] std::vector<Extreme> extremesOf(const Scene& scene, const PictureSettings& settings,
                                              const std::function<void(std::string_view)>& progress = {});

/// What was found: "right up to 1e+09" or "wrong from 1e+10 on: 12 of 4,000 samples show another face".
[[nodiscard]] std::string findingOf(const Extreme& extreme);

}  // namespace xnewell
