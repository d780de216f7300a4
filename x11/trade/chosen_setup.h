#pragma once

#include "shading/trade/configuration.h"
#include "x11/window/controls.h"

namespace xnewell {

/// The setup with what a configuration changes.
[[nodiscard]] Setup withChanges(Setup setup, const Configuration& chosen);

/// What the measurements of a trade depend on: all but the colours in the cells, the filler, and what view 1
/// shows.
[[nodiscard]] Setup measuredPart(Setup setup);

}  // namespace xnewell
