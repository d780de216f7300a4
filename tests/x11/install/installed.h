#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"

namespace xnewell {

/// `cmake --install` into a folder, which is then moved to another place.

inline std::string textOfFile(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// Runs a command of the shell in a folder, without a display.
inline Finished inFolder(const std::filesystem::path& folder, const std::string& command) {
  RunningProgram shell{"bash", {"-c", "cd \"$0\" && " + command, folder.string()}, ""};
  return shell.wait();
}

class InstalledTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const std::filesystem::path first = folder_->file("first");
    const Finished done = inFolder(
        "/", XNEWELL_CMAKE " --install '" XNEWELL_BUILD "' --prefix '" + (first / "usr").string() + "'");
    ASSERT_EQ(done.status, 0) << done.err;
    std::filesystem::rename(first, folder_->file("another place"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  [[nodiscard]] static std::filesystem::path file(const std::string& name) { return folder_->file(name); }
  [[nodiscard]] static std::filesystem::path installed(const std::string& path) {
    return file("another place") / "usr" / path;
  }
  /// Runs the installed program in the root folder.
  [[nodiscard]] static Finished run(const std::string& words) {
    return inFolder("/", "'" + installed("bin/xnewell").string() + "' " + words);
  }

 private:
  inline static TemporaryFolder* folder_ = nullptr;
};

}  // namespace xnewell
