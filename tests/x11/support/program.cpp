#include "tests/x11/support/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <thread>

namespace xnewell {

namespace {

std::string contents(int file) {
  std::string text(static_cast<std::size_t>(lseek(file, 0, SEEK_END)), '\0');
  const ssize_t n = pread(file, text.data(), text.size(), 0);
  text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return text;
}

/// For execvpe(): this program's environment with DISPLAY as given, or without it where `display` is empty;
/// without a home, where a window would keep answers.
std::vector<std::string> environmentWith(const std::string& display) {
  std::vector<std::string> environment;
  for (char** e = environ; *e != nullptr; ++e)
    if (std::ranges::none_of(std::array<std::string_view, 3>{"DISPLAY=", "HOME=", "XDG_STATE_HOME="},
                             [e](std::string_view name) { return std::string_view{*e}.starts_with(name); }))
      environment.emplace_back(*e);
  if (!display.empty()) environment.push_back("DISPLAY=" + display);
  return environment;
}

/// Pointers to the strings, and a null at the end; made before fork(), after which nothing may be allocated.
std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  result.reserve(strings.size() + 1);
  for (std::string& s : strings) result.push_back(s.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

std::string builtProgram(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / name;
}

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const std::string& display)
    : RunningProgram{builtProgram(), arguments, display} {}

RunningProgram::RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                               const std::string& display, int onCrash)
    : out_{memfd_create("standard output", MFD_CLOEXEC)}, err_{memfd_create("standard error", MFD_CLOEXEC)} {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environmentWith(display);
  const std::vector<char*> argv = pointers(words), envp = pointers(environment);

  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw std::system_error{errno, std::generic_category(), "fork"};
  if (pid_ > 0) return;
  // Only calls that are safe between fork and exec.
  prctl(PR_SET_PDEATHSIG, onCrash);
  if (getppid() != parent) _exit(126);  // the parent died before we could ask
  dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  dup2(out_, STDOUT_FILENO);
  dup2(err_, STDERR_FILENO);
  ::signal(SIGPIPE, SIG_DFL);  // a test that has opened a display ignores it
  execvpe(argv[0], argv.data(), envp.data());
  _exit(127);
}

RunningProgram::~RunningProgram() {
  if (running()) {
    signal(SIGKILL);
    reap(0);
  }
  close(out_);
  close(err_);
}

bool RunningProgram::running() {
  reap(WNOHANG);
  return pid_ > 0;
}

void RunningProgram::signal(int number) const {
  if (pid_ > 0) kill(pid_, number);
}

void RunningProgram::reap(int options) {
  int status = 0;
  if (pid_ <= 0 || waitpid(pid_, &status, options) != pid_) return;
  pid_ = -1;
  status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

double RunningProgram::megabytes() const {
  long all = 0, resident = 0;
  std::ifstream{"/proc/" + std::to_string(pid_) + "/statm"} >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

std::string RunningProgram::output() const { return contents(out_); }

Finished RunningProgram::wait(std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (running() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  if (pid_ > 0) {
    signal(SIGKILL);
    reap(0);
    status_ = -1;
  }
  return {status_, contents(out_), contents(err_)};
}

Finished runProgram(const std::vector<std::string>& arguments, const std::string& display) {
  return RunningProgram{arguments, display}.wait();
}

}  // namespace xnewell
