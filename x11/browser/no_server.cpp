#include <stdexcept>

#include "x11/app/snapshot.h"
#include "x11/visual/x11_error.h"

namespace xnewell {

/// What only an X server can do.

void takeSnapshot(const Options&, Scene, const Taken&) {
  throw X11Error{"there is no X server here; `draw` makes the same picture"};
}

std::string visualsTable(const Options&) { throw X11Error{"there is no X server here"}; }

}  // namespace xnewell
