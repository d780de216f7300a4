#pragma once

#include <iosfwd>

#include "shading/extremes/extremes.h"
#include "x11/options/options.h"

namespace xnewell {

/// `extremes`: what becomes wrong first when a scene is driven to its extremes.

/// Prints a table for people: the ways, how far each one went, what was found, and what explains it. Above it
/// stands whether the set-up itself is wrong, and whether the user stopped it.
void printExtremes(const Extremes& extremes, std::ostream& out);
/// Prints all steps as one JSON object.
void printExtremesAsJson(const Options& options, const Extremes& extremes, std::ostream& out);

}  // namespace xnewell
