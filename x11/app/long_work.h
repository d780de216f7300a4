#pragma once

#include <chrono>
#include <functional>

namespace xnewell {

/// Does work that may take long on its own thread, while the calling thread talks to the server.

/// The program says nothing before this time, because nobody can read a message that vanishes at once.
inline constexpr std::chrono::milliseconds kPatience{1000};

/// Does `work` on a thread of its own and returns when it is done. After kPatience it calls `meanwhile` about
/// ten times a second, on the calling thread, with the whole seconds since the start. If that returns true,
/// `work` is given up once (give_up.h). An exception from `work` is thrown again here; one from `meanwhile`
/// is thrown after `work` is done. If the system refuses a thread, the calling thread does the work.
void doPatiently(const std::function<void()>& work, const std::function<bool(int seconds)>& meanwhile);

}  // namespace xnewell
