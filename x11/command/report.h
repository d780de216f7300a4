#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shading/picture/picture.h"
#include "x11/options/options.h"
#include "x11/server/sent.h"

namespace xnewell {

/// Writes the picture (the bytes of a PNG file) to the file of -o, and the face image to the file of --ids.
/// It writes both or neither. @throws std::system_error
void writePictures(const Options& options, const Picture& picture, const std::string& png);

/// Reports on a picture that was written: a note on standard error for each option that had no effect, and
/// with --stats one JSON object on standard output. `accuracy` is what keepWithin() chose, or null. `sent` is
/// what a server got; null without one.
void report(const Options& options, const Picture& picture, const StageTimes& times,
            const nlohmann::ordered_json& accuracy, const Sent* sent = nullptr);

}  // namespace xnewell
