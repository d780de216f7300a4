#pragma once

#include <iosfwd>
#include <string>

#include "shading/picture/picture.h"
#include "x11/options/options.h"
#include "x11/window/controls.h"

namespace xnewell {

/// Writes a note for each option that was given but has no effect on this picture. Scripts may always give
/// all options; a user who tries one out should learn why nothing changes. There is also a note for each part
/// of the scene that the picture leaves out, and for a picture that shows nothing.
void noteNoEffect(std::ostream& out, const Options& options, const Picture& picture);

/// Writes a note if the picture shows nothing, and says why.
void noteEmpty(std::ostream& out, const Picture& picture);

/// The same for a control that has just changed `setup`: a sentence, or "" if the control has an effect.
/// `picture` is the one before the change; the next one has the same scene and the same plan of colours.
[[nodiscard]] std::string whyNoEffect(char control, const Picture& picture, const Setup& setup);

}  // namespace xnewell
