#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shading/trade/trade.h"
#include "x11/options/setup_command.h"

namespace xnewell {

/// `trade`: what each short cut saves on a scene, and the error that it costs.

/// The commands that draw the configurations of a trade and tell their errors.
struct TradeCommands {
  SetupCommand setup;
  CameraSettings camera;  ///< as the user said it
  /// With other divisions it says where the camera is, which otherwise depends on the polygons.
  [[nodiscard]] std::string of(const Configuration& configuration) const;
};

/// The milliseconds by the items' names. --costs adds them to --stats.
[[nodiscard]] nlohmann::ordered_json itemCostsAsJson(const std::vector<ItemCost>& items);

/// Prints a table for people: each short cut by itself with a sentence and the command that repeats it, then
/// the front.
void printTrade(const TradeCommands& commands, const Trade& trade, std::ostream& out);
/// Prints all numbers as one JSON object. `scene` is its name.
void printTradeAsJson(const std::string& scene, const TradeCommands& commands, const Trade& trade,
                      std::ostream& out);

}  // namespace xnewell
