#pragma once

#include <functional>
#include <string>

#include "shading/picture/picture.h"
#include "x11/options/options.h"
#include "x11/server/sent.h"

namespace xnewell {

/// Receives a snapshot: its picture, the bytes of a PNG file, the time that each stage took, and what was
/// sent to the server to present it.
using Taken = std::function<void(const Picture&, const std::string& png, const StageTimes&, const Sent&)>;

/// Draws the picture in a real window and reads it back from the server. With options.wholeWindow, it does so
/// with the whole window and its controls.
/// @throws X11Error, ViewError, and whatever `taken` throws
void takeSnapshot(const Options& options, Scene scene, const Taken& taken);

/// The text that `xnewell visuals` prints. @throws X11Error
[[nodiscard]] std::string visualsTable(const Options& options);

}  // namespace xnewell
