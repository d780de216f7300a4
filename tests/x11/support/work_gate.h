#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "tests/support/temporary_folder.h"

namespace xnewell {

/// A gate before the program's work: while it is shut, a thread that the program xnewell_held
/// (held_threads.cpp) starts does nothing. Work takes as long as the test wants, on every machine.
class WorkGate {
 public:
  /// The gate is shut.
  WorkGate() : lock_{::open(folder_.write("gate", "").c_str(), O_RDONLY | O_CLOEXEC)} {
    if (lock_ < 0) throw std::runtime_error{"the gate's file cannot be opened"};
    setenv("XNEWELL_GATE", folder_.file("gate").c_str(), 1);
    shut();
  }
  WorkGate(const WorkGate&) = delete;
  WorkGate& operator=(const WorkGate&) = delete;
  ~WorkGate() {
    close(lock_);
    unsetenv("XNEWELL_GATE");
  }

  void open() const { flock(lock_, LOCK_UN); }
  /// Threads that start from now on wait.
  void shut() const { flock(lock_, LOCK_EX); }

 private:
  TemporaryFolder folder_;
  int lock_;
};

}  // namespace xnewell
