#pragma once

#include "shading/scene/scene.h"
#include "x11/options/options.h"

namespace xnewell {

/// Says which mistake the program made that drew options.handedIn, and writes a sheet that shows it. Returns
/// the exit status: kDone if the picture is right, else kOutside.
/// @throws UsageError for what cannot be diagnosed; ParseError, std::system_error for the picture
int tellDiagnosis(Options& options, Scene scene);

}  // namespace xnewell
