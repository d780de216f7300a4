#pragma once

#include <unistd.h>

#include <iostream>
#include <string>
#include <tuple>

#include "geometry/files/visible.h"

namespace xnewell {

/// On a terminal, shows what is being done for as long as it lasts. Silent anywhere else.
class Doing {
 public:
  explicit Doing(const std::string& what) : told_{::isatty(STDERR_FILENO) == 1} {
    if (told_) std::cerr << "xnewell: " << visible(what) << " ..." << std::flush;
  }
  Doing(const Doing&) = delete;
  Doing& operator=(const Doing&) = delete;
  ~Doing() {
    if (told_) std::ignore = ::write(STDERR_FILENO, "\r\033[K", 4);  // go to the line's start and clear it
  }

 private:
  bool told_;
};

}  // namespace xnewell
