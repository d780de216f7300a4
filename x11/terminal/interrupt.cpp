#include "x11/terminal/terminal.h"

#include <unistd.h>

#include <csignal>

#include "x11/options/exit_status.h"
#include "x11/options/options.h"

namespace xnewell {

namespace {

volatile std::sig_atomic_t seen = 0;

}  // namespace

void awaitInterrupt() {
  std::signal(SIGINT, [](int) {
    if (seen != 0) _exit(kInterrupted);
    seen = 1;
  });
}

bool wasInterrupted() { return seen != 0; }

}  // namespace xnewell
