#pragma once

#include <iosfwd>
#include <string_view>

#include "shading/picture/picture.h"
#include "x11/options/options.h"
#include "x11/window/controls.h"

namespace xnewell {

/// A line for each option that was given and does nothing to this picture, for other choices leave it no say:
/// scripts may give all options always, but who tries one out should not wonder. So too for what of its scene
/// the picture leaves out, and where it shows nothing at all.
void noteMoot(std::ostream& out, const Options& options, const Picture& picture);

/// The same of the window's control of a key, for the `setup` that it has just changed: a sentence, "" where
/// the control counts. `picture` is the one before, of whose scene and plan of colours it is.
[[nodiscard]] std::string_view whyMoot(char control, const Picture& picture, const Setup& setup);

}  // namespace xnewell
