#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "x11/app/lecture.h"
#include "x11/app/workbench.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

/// Runs the window: events in, frames out. Returns the exit status: 0 when the user quits. A signal ends the
/// program with status 128 + its number. If there is a `lesson`, its first step is shown. Command::Lesson
/// without a lesson shows the list of lessons. runViewer() calls `shown` when the first picture, which may
/// take long, is in the window.
/// @throws X11Error, also at the end if the server refused to show something; ViewError
[[nodiscard]] int runViewer(const Options& options, Scene scene, std::optional<Lesson> lesson,
                            const std::function<void()>& shown);

/// Runs the window with a lecture of at least one page. `options` are about the window.
[[nodiscard]] int runLecture(const Options& options, std::vector<Page> pages,
                             const std::function<void()>& shown);

/// Both call this, which an X server or a page of a browser implements: shows a window, at the place where
/// `begin` takes its workbench.
[[nodiscard]] int showWindow(const Options& options, Scene scene,
                             const std::function<void(Workbench&)>& begin,
                             const std::function<void()>& shown);

}  // namespace xnewell
