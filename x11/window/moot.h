#pragma once

#include <iosfwd>
#include <string>

#include "shading/picture/picture.h"
#include "x11/options/options.h"
#include "x11/window/controls.h"

namespace xnewell {

/// A line for each option that was given and has no effect on this picture. Scripts may always give all options,
/// but whoever tries one out should not wonder. There is also a line for each part of the scene that the picture
/// leaves out, and for a picture that shows nothing.
void noteMoot(std::ostream& out, const Options& options, const Picture& picture);

/// The same for the control of a key, which has just changed `setup`: a sentence, "" where the control has an
/// effect. `picture` is the one before; its scene and its plan of colours are those of the next.
[[nodiscard]] std::string whyMoot(char control, const Picture& picture, const Setup& setup);

}  // namespace xnewell
