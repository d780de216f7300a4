#pragma once

#include <chrono>
#include <functional>

namespace xnewell {

/// Work that may take long, beside the thread that talks to the server.

/// For so long nothing is said: what comes and goes in a blink tells nobody anything.
inline constexpr std::chrono::milliseconds kPatience{1000};

/// Does `work` on a thread of its own and returns when it is done. From kPatience on `meanwhile` is called
/// about every tenth of a second, on the calling thread, with the whole seconds since the start. What either
/// throws is thrown when the work is done.
void doPatiently(const std::function<void()>& work, const std::function<void(int seconds)>& meanwhile);

}  // namespace xnewell
