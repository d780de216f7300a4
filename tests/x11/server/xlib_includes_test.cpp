#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace xnewell::THIS_FILE {

namespace {

namespace fs = std::filesystem;

/// The folders, relative to the project's, whose files include a header of X11 themselves.
std::vector<std::string> foldersThatInclude(const std::string& what) {
  const fs::path project = fs::path{XNEWELL_DATA_DIR}.parent_path();
  std::vector<std::string> folders;
  int files = 0;
  for (const char* floor : {"geometry", "depthsort", "shading", "x11"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{project / floor}) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      ++files;
      std::ifstream in{entry.path()};
      for (std::string line; std::getline(in, line);)
        if (line.starts_with(what)) {
          folders.push_back(fs::relative(entry.path().parent_path(), project).string());
          break;
        }
    }
  EXPECT_GT(files, 200);
  return folders;
}

}  // namespace

// Only the server's room and the event loop include Xlib, and the student's program, which is none of ours.
// So its macros (None, Bool, Status) reach no file of another room.
TEST(XlibIncludes, AreInTheServersRoomAndTheEventLoop) {
  const std::vector<std::string> folders = foldersThatInclude("#include <X11/");
  EXPECT_THAT(folders, testing::Contains("x11/server"));
  EXPECT_THAT(folders, testing::Each(testing::AnyOf("x11/server", "x11/app", "x11/example")));
}

// The event loop is one file.
TEST(XlibIncludes, AreInOneFileOfTheApp) {
  const std::vector<std::string> folders = foldersThatInclude("#include <X11/");
  EXPECT_THAT(folders, testing::Contains("x11/app").Times(1));
}

}  // namespace xnewell::THIS_FILE
