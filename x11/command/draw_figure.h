#pragma once

#include "shading/scene/scene.h"
#include "x11/options/options.h"

namespace xnewell {

/// `figure`: writes the picture of a scene as areas, to the file of -o. With --ids it also writes the figure
/// in the colours of the faces' numbers: both files or neither. With --stats it prints one JSON object. If
/// the colours come from samples, one line on standard error tells how far they are off.
/// @throws ViewError, TooManyPieces, std::system_error
void drawFigure(const Options& options, const Scene& scene);

}  // namespace xnewell
