#pragma once

#include <iosfwd>
#include <vector>

#include "shading/extremes/extremes.h"
#include "x11/options/options.h"

namespace xnewell {

/// `extremes`: what becomes wrong first when a scene is driven to its extremes.

/// Prints a table for people: the ways, how far each one went, what was found, and what explains it.
void printExtremes(const std::vector<Extreme>& extremes, std::ostream& out);
/// Prints all steps as one JSON object.
void printExtremesAsJson(const Options& options, const std::vector<Extreme>& extremes, std::ostream& out);

}  // namespace xnewell
