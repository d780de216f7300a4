#pragma once

#include <functional>
#include <string>

#include "shading/picture/picture.h"
#include "x11/options/options.h"

namespace xnewell {

/// Gets a snapshot: the picture that it is of, the bytes of a PNG file, and the time that each stage took.
using Taken = std::function<void(const Picture&, const std::string& png, const StageTimes&)>;

/// The picture (or with options.wholeWindow the window with its controls) through a real window, read back
/// from the server. @throws X11Error, ViewError, and what `taken` throws
void takeSnapshot(const Options& options, Scene scene, const Taken& taken);

/// What `xnewell visuals` prints. @throws X11Error
[[nodiscard]] std::string visualsTable(const Options& options);

}  // namespace xnewell
