#include "tests/x11/support/x_server.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tests/x11/support/child.h"

namespace xnewell {

namespace {

constexpr int kStartSeconds = 60;   ///< a loaded machine compiles the keymap slowly
constexpr char kMissing[] = "!\n";  ///< the child writes it if there is no such program

/// Reads up to the first newline. Returns what came until then if the writer closes or the time is over.
std::string readLine(int from) {
  std::string line;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kStartSeconds);
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    pollfd ready{from, POLLIN, 0};
    if (left.count() <= 0 || poll(&ready, 1, static_cast<int>(left.count())) <= 0) return line;
    char c = 0;
    if (read(from, &c, 1) != 1 || c == '\n') return line;
    line += c;
  }
}

std::string contents(int file) {
  std::array<char, 4096> text{};
  const ssize_t n = pread(file, text.data(), text.size(), 0);
  return {text.data(), n > 0 ? static_cast<std::size_t>(n) : 0};
}

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

XServer::XServer(const std::string& program, std::vector<std::string> arguments, const std::string& host) {
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe for the X server");
  const int log = memfd_create("x server", MFD_CLOEXEC);
  // These come first, so that what a test asks for overrides them.
  const std::vector<std::string> always{program,    "-nolisten",  "tcp",
                                        "-noreset", "-displayfd", std::to_string(pipe[1])};
  arguments.insert(arguments.begin(), always.begin(), always.end());
  std::vector<std::string> environment = environmentWith(host);
  const std::vector<char*> argv = pointers(arguments), envp = pointers(environment);

  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {  // only calls that are safe between fork and exec
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(1);  // the parent died before we could ask
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    fcntl(pipe[1], F_SETFD, 0);
    execvpe(program.c_str(), argv.data(), envp.data());
    if (errno == ENOENT && write(pipe[1], kMissing, 2) != 2) _exit(126);
    _exit(127);
  }
  close(pipe[1]);
  const std::string number = readLine(pipe[0]);
  close(pipe[0]);
  const std::string said = contents(log);
  close(log);
  if (!number.empty() && number[0] != kMissing[0]) {
    name_ = ":" + number;
    return;
  }
  stop();
  if (!number.empty())
    throw std::runtime_error("the tests need the program " + program + ", which is not installed");
  throw std::runtime_error(program + " did not start: " + said);
}

XServer::XServer(XServer&& o) noexcept : pid_{std::exchange(o.pid_, -1)}, name_{std::move(o.name_)} {}

void XServer::stop() {
  const pid_t pid = std::exchange(pid_, -1);
  if (pid <= 0) return;
  kill(pid, SIGTERM);
  for (int tries = 0; tries < 500; ++tries) {
    if (waitpid(pid, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(pid, SIGKILL);
  waitpid(pid, nullptr, 0);
}

}  // namespace xnewell
