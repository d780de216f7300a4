#pragma once

namespace xnewell {

/// Lets the program end by itself after an interrupt (SIGINT), so that it can tell what it has done: from now
/// on the first one only makes wasInterrupted() true. A second one ends the program.
void awaitInterrupt();
[[nodiscard]] bool wasInterrupted();

}  // namespace xnewell
