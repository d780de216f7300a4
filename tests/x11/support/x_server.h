#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/x11/support/program.h"

namespace xnewell {

/// The test's own X server: Xvfb, or Xephyr inside another server. The server itself picks a free display
/// number (-displayfd), so that test programs that run at the same time do not meet. It ends with the object,
/// and also when the test program crashes.
class XServer {
 public:
  /// @throws std::runtime_error that says what is missing. A test without its server fails.
  static XServer xvfb(int depth, int width = 640, int height = 480, std::vector<std::string> more = {});
  static XServer xephyr(const XServer& host, int depth, int width = 320, int height = 240);
  /// Any program that takes -displayfd. `host` is that program's own $DISPLAY; empty for none.
  XServer(const std::string& program, const std::vector<std::string>& arguments,
          const std::string& host = {});
  ~XServer() { stop(); }
  XServer(XServer&&) noexcept = default;
  XServer& operator=(XServer&&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }  ///< as in ":7"
  [[nodiscard]] pid_t pid() const { return running_->pid(); }
  /// Ends the server and waits until it is gone: asks it to end, and kills it after 5 s.
  void stop();

 private:
  std::unique_ptr<RunningProgram> running_;
  std::string name_;
};

}  // namespace xnewell
