#pragma once

#include <functional>
#include <optional>
#include <string>

#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

/// The window: events in, frames out. Returns the exit status: 0 when the user quits; a signal ends the
/// program with 130. @throws X11Error also at the end, if the server refused to show something; ViewError
/// `lesson` is shown from its first step; of Command::Lesson without one, the list is. `shown` is called when
/// the first picture, which may take long, is in the window.
[[nodiscard]] int runViewer(const Options& options, Scene scene, std::optional<Lesson> lesson,
                            const std::function<void()>& shown);

}  // namespace xnewell
