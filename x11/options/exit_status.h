#pragma once

#include <array>
#include <string_view>

namespace xnewell {

/// The exit status of the program.
enum ExitStatus { kDone = 0, kOutside = 1, kWrong = 2, kHungUp = 129, kInterrupted = 130, kTerminated = 143 };
struct StatusRow {
  ExitStatus id;
  std::string_view means;
};
inline constexpr std::array kStatuses{
    StatusRow{kDone, "done"},
    StatusRow{kOutside, "a file or the server failed, or what was handed in is wrong"},
    StatusRow{kWrong, "wrong usage or bad contents"},
    StatusRow{kHungUp, "hung up (SIGHUP): the terminal has gone"},
    StatusRow{kInterrupted, "interrupted"},
    StatusRow{kTerminated, "terminated (SIGTERM)"},
};

}  // namespace xnewell
