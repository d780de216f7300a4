#pragma once

#include "shading/picture/picture.h"
#include "x11/options/options.h"

namespace xnewell {

/// Writes the picture, a PNG file's bytes, where -o says and the face image where --ids says: both or
/// neither. @throws std::system_error
void writePictures(const Options& options, const Picture& picture, const std::string& png);

/// What is said of a picture that was written: a note on standard error for each option that did nothing,
/// and with --stats one JSON object on standard output.
void report(const Options& options, const Picture& picture, const StageTimes& times);

}  // namespace xnewell
