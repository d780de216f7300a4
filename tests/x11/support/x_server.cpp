#include "tests/x11/support/x_server.h"

#include <signal.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

namespace xnewell {

namespace {

constexpr std::chrono::seconds kStart{60};  ///< a loaded machine compiles the keymap slowly
constexpr std::chrono::seconds kEnd{5};

}  // namespace

XServer XServer::xvfb(int depth, int width, int height, std::vector<std::string> more) {
  std::vector<std::string> arguments{
      "-screen", "0", std::to_string(width) + "x" + std::to_string(height) + "x" + std::to_string(depth)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return {"Xvfb", arguments};
}

XServer XServer::xephyr(const XServer& host, int depth, int width, int height) {
  return {"Xephyr",
          {"-screen", std::to_string(width) + "x" + std::to_string(height) + "x" + std::to_string(depth)},
          host.name()};
}

XServer::XServer(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& host) {
  // The server closes the file into which it has written its number, so this is none of the standard ones.
  // Its first options come before those that a test asks for, which override them.
  std::vector<std::string> words{"-c", R"(exec "$0" -nolisten tcp -noreset -displayfd 3 "$@" 3>&1 >&2)",
                                 program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  running_ = std::make_unique<RunningProgram>("sh", words, host, SIGTERM);
  const auto end = std::chrono::steady_clock::now() + kStart;
  for (std::string said; running_->running() && std::chrono::steady_clock::now() < end;) {
    said = running_->output();
    if (said.ends_with('\n')) {
      name_ = ":" + said.substr(0, said.size() - 1);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
  running_->signal(SIGTERM);
  const Finished ended = running_->wait(kEnd);
  throw std::runtime_error(ended.status == 127
                               ? "the tests need the program " + program + ", which is not installed"
                               : program + " did not start: " + ended.err);
}

void XServer::stop() {
  if (const std::unique_ptr<RunningProgram> running = std::exchange(running_, nullptr)) {
    running->signal(SIGTERM);
    (void)running->wait(kEnd);
  }
}

}  // namespace xnewell
