#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace xnewell {

/// xnewell itself as a child process: no test is fooled by state that a real start would not have.

/// How it ended. `status` is what a shell calls $?: the exit status, or 128 + n if signal n ended it; -1 if
/// it took longer than its limit and was killed.
struct Finished {
  int status = -1;
  std::string out, err;
};

/// Runs `xnewell arguments...` to its end, at most 60 s. DISPLAY is unset where `display` is empty; standard
/// input is empty. @throws std::system_error if no process can be made
[[nodiscard]] Finished runProgram(const std::vector<std::string>& arguments, const std::string& display = "");

/// The same, going on beside the test: for the window. It ends with the object, and also when the test
/// program crashes.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments, const std::string& display = "");
  /// Any other program of the machine. One that is not there ends with 127, as for a shell.
  RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& display);
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  [[nodiscard]] pid_t pid() const { return pid_; }  ///< -1 after wait()
  [[nodiscard]] bool running();
  void signal(int number) const;
  /// Waits for the end; kills it after `limit`. Later calls give the same answer.
  Finished wait(std::chrono::seconds limit = std::chrono::seconds{150});

 private:
  void reap(int options);

  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;  ///< files in memory: a child that says much is never held up
  int status_ = -1;
};

}  // namespace xnewell
