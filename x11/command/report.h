#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shading/laboratory/errors.h"
#include "shading/picture/picture.h"
#include "shading/trade/item_costs.h"
#include "x11/options/options.h"
#include "x11/server/sent.h"

namespace xnewell {

/// What takes long to know of a picture: --errors and --costs.
struct Measurements {
  std::optional<Errors> errors;
  std::vector<ItemCost> costs;
};
/// Measures what the options ask for, with its progress on a terminal. It comes before anything is written,
/// so that a command which is interrupted, or which cannot do all that it was asked, leaves nothing behind.
/// @throws ViewError if the errors cannot be measured
[[nodiscard]] Measurements measured(const Options& options, const Picture& picture);

/// Writes the picture (the bytes of a PNG file) to the file of -o, and the face image to the file of --ids.
/// It writes both or neither. @throws std::system_error
void writePictures(const Options& options, const Picture& picture, const std::string& png);

/// Reports on a picture that was written: a note on standard error for each option that had no effect, and
/// with --stats one JSON object on standard output. `accuracy` is what keepWithin() chose, or null. `sent` is
/// what a server got; null without one.
void report(const Options& options, const Picture& picture, const Measurements& measured,
            const StageTimes& times, const nlohmann::ordered_json& accuracy, const Sent* sent = nullptr);

}  // namespace xnewell
