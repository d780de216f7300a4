#include "x11/terminal/memory.h"

namespace xnewell {

// Frames are measured with the memory of the program.
[[maybe_unused]] const bool kKeepsFreedMemory = (keepFreedMemory(), true);

}  // namespace xnewell
