#pragma once

#include <optional>
#include <string>

#include "shading/laboratory/errors.h"
#include "shading/picture/picture.h"
#include "x11/kit/page.h"
#include "x11/options/options.h"
#include "x11/server/sent.h"

namespace xnewell {

/// The settings of a picture without a window. `usual` is the size if the user gave none.
[[nodiscard]] PictureSettings settingsOf(const Options& options, glm::ivec2 usual = kPictureSize);

/// Prints what a command has to say, with --json as JSON. What stands there is not lost if a file cannot be
/// written afterwards.
void print(const Options& options, const page::Page& page);

/// The errors of a picture as JSON. errors.h says what the numbers are.
[[nodiscard]] page::Object spreadAsData(const Spread& spread);
[[nodiscard]] page::Object errorsAsData(const Errors& errors);

/// What --errors asks for. It comes before anything is written, so that a command which is interrupted, or
/// which cannot do all that it was asked, leaves nothing behind.
/// @throws ViewError if the errors cannot be measured
[[nodiscard]] std::optional<Errors> measuredErrors(const Options& options, const Picture& picture);

/// Writes the picture (the bytes of a PNG file) to the file of -o, and the face image to the file of --ids.
/// It writes both or neither. @throws std::system_error
void writePictures(const Options& options, const Picture& picture, const std::string& png);

/// Reports on a picture that was written: a note on standard error for each option that had no effect, and
/// with --stats one JSON object on standard output. `accuracy` is what keepWithin() chose, or null. `sent` is
/// what a server got; null without one.
void report(const Options& options, const Picture& picture, const std::optional<Errors>& errors,
            const StageTimes& times, const page::Data& accuracy, const Sent* sent = nullptr);

}  // namespace xnewell
