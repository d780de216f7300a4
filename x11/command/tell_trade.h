#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shading/scene/scene.h"
#include "x11/options/options.h"

namespace xnewell {

/// The settings of a picture without a window.
[[nodiscard]] PictureSettings settingsOf(const Options& options);

/// `trade`: measures what each short cut saves and costs, and tells it. An interrupt ends the measuring, and
/// it prints what is known; a second interrupt ends the program. Returns the exit status.
[[nodiscard]] int tellTrade(const Options& options, Scene scene);

/// --accuracy: puts the short cuts of the cheapest point of the measured front within `limit` into the
/// options, and the divisions into the scene. Options that the user gave stay. Says on standard error what
/// was chosen and why, and returns the same for --stats.
[[nodiscard]] nlohmann::ordered_json keepWithin(const AccuracyLimit& limit, Options& options, Scene& scene);

}  // namespace xnewell
