#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/x11/support/watched_viewer.h"
#include "tests/x11/support/x_proxy.h"

namespace xnewell {

/// Ways to use the program through a proxy that may make a bad server of a good one.

inline const std::string kTeapot = "teapot --divisions 2", kSmall = " --size 120x90";
inline constexpr std::chrono::seconds kEnough{90};

/// What the program says when its connection ends and the server answers another one.
inline std::string cutAt(const std::string& display) {
  return "xnewell: the X server of display '" + display +
         "' still runs, but has ended our connection, as xkill makes it do\n";
}

inline XServer serverFor(int depth) { return XServer::xvfb(depth, 320, 240); }

/// A way to use the program, from its start to its end.
struct Use {
  std::string name;
  std::vector<std::string> arguments;
  std::string file = "";  ///< what it writes
  /// What the user does meanwhile, as long as `hoping` is true.
  std::function<void(const XServer&, const std::function<bool()>& hoping)> act = [](auto&&...) {};
};

inline Use visuals() { return {"visuals", {"visuals"}}; }

/// The server fills, which makes more kinds of request and sends the picture first.
inline Use snapshot(const TemporaryFolder& folder,
                    const std::string& more = "--divisions 2 --fill x11" + kSmall) {
  std::vector<std::string> arguments = words("snapshot teapot " + more);
  arguments.insert(arguments.end(), {"-o", folder.file("picture.png")});
  return {"snapshot", arguments, folder.file("picture.png")};
}

/// As soon as there is a window: a new table, a new size, a new hue, and the close button.
inline Use view() {
  return {"view", words("view " + kTeapot + kSmall), "", [](const XServer& server, const auto& hoping) {
            try {
              const WatchedWindow window{server, 0, hoping};
              const ErrorTrap trap{window.display()};  // the window may be gone
              window.moveTo(60, 45);
              window.type("T");
              window.resize(140, 100);
              window.type("H");
              window.askToClose();
            } catch (const std::runtime_error&) {
              EXPECT_FALSE(hoping());
            }
          }};
}

/// The number of segments of System V shared memory that a process made and that still exist.
inline std::ptrdiff_t segmentsOf(pid_t maker) {
  std::ifstream table{"/proc/sysvipc/shm"};
  std::string line;
  std::getline(table, line);
  std::ptrdiff_t count = 0;
  for (long key, id, size, made; std::getline(table, line);) {
    std::string permissions;
    if (std::istringstream{line} >> key >> id >> permissions >> size >> made) count += made == maker;
  }
  return count;
}

/// How a use of the program went on the proxy's server.
struct Course {
  Finished end{};
  bool carriedOut = false;
  std::vector<XRequest> requests{}, answered{};
  std::chrono::milliseconds toEnd{};  ///< from the interrupt to the end
};

/// Runs the program to its end. If it is stalled, it is interrupted.
inline Course runThrough(const Use& use, const XServer& server, XProxy& proxy,
                         const std::optional<XFaultPlan>& plan = {}) {
  std::filesystem::remove(use.file);
  proxy.begin(plan);
  RunningProgram program{use.arguments, proxy.name()};
  const pid_t pid = program.pid();
  const bool stalls = plan && plan->fault == XFault::Stalled;
  const auto hoping = [&] { return program.running() && !(stalls && proxy.carriedOut()); };
  use.act(server, hoping);
  if (stalls && comesTrue([&] { return !hoping(); })) program.signal(SIGINT);
  const auto asked = std::chrono::steady_clock::now();
  Course course{.end = program.wait(kEnough)};
  course.toEnd =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - asked);
  course.carriedOut = proxy.carriedOut();
  course.requests = proxy.requests();
  course.answered = proxy.answered();
  // The shared memory and the window go only when the server has let them go too.
  EXPECT_TRUE(comesTrue([&] { return segmentsOf(pid) == 0; }));
  EXPECT_TRUE(comesToShowNone(openDisplay(server.name()).get()));
  return course;
}

}  // namespace xnewell
