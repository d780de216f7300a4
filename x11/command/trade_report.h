#pragma once

#include <iosfwd>
#include <string>

#include "shading/trade/trade.h"
#include "x11/options/options.h"

namespace xnewell {

/// `trade`: what each short cut saves on a scene, and the error that it costs.

/// Prints a table for people: each short cut by itself with a sentence, then the front.
void printTrade(const Options& options, const Trade& trade, std::ostream& out);
/// Prints all numbers as one JSON object.
void printTradeAsJson(const Options& options, const Trade& trade, std::ostream& out);

/// The command that draws a configuration and tells its errors: the options that the user gave, with those of
/// the configuration in their place. With other divisions it says where the camera is, which otherwise
/// depends on the polygons. `exponent` is Trade::exponent.
[[nodiscard]] std::string commandOf(const Options& options, int exponent, const Configuration& configuration);

}  // namespace xnewell
