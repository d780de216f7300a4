#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

namespace xnewell {

/// xnewell itself as a child process, so that no test depends on state that a real start would not have.

/// The path of a program of the build folder that the running test program was linked in: "x11/xnewell".
[[nodiscard]] std::string builtProgram(const std::string& name = "x11/xnewell");

/// How the program ended. `status` is what a shell calls $?: the exit status, or 128 + n if signal n ended
/// it; -1 if it took longer than its limit and was killed.
struct Finished {
  int status = -1;
  std::string out, err;
};

/// Runs `xnewell arguments...` to its end. DISPLAY is unset if `display` is empty. Standard input is empty.
/// @throws std::system_error if no process can be made
[[nodiscard]] Finished runProgram(const std::vector<std::string>& arguments, const std::string& display = "");

/// The same, running while the test goes on, for tests of the window. It ends with the object, and also when
/// the test program crashes.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments, const std::string& display = "");
  /// Any other program of the machine. A program that does not exist ends with 127, as for a shell. It gets
  /// the signal `onCrash` when the test program crashes.
  RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& display, int onCrash = SIGKILL);
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  [[nodiscard]] pid_t pid() const { return pid_; }  ///< -1 after wait()
  [[nodiscard]] bool running();
  void signal(int number) const;
  [[nodiscard]] double megabytes() const;    ///< of memory that it uses
  [[nodiscard]] std::string output() const;  ///< what it has written to standard output so far
  /// Waits for the end, and kills the program after `limit`. Later calls give the same answer.
  Finished wait(std::chrono::seconds limit = std::chrono::seconds{150});

 private:
  void reap(int options);

  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;  ///< files in memory, so that a child with much output never waits
  int status_ = -1;
};

}  // namespace xnewell
