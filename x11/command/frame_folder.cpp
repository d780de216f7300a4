#include "x11/command/frame_folder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "geometry/files/text_file.h"
#include "x11/options/options.h"

namespace xnewell {

namespace {

/// A frame's number has at least four digits, so the file names sort in the order of the run.
std::string fileName(int number, std::string_view word) {
  std::string digits = std::to_string(number);
  return std::string(4 - digits.size(), '0') + digits + "-" + std::string{word} + ".png";
}

/// True for a frame of an earlier run, which would be mistaken for one of this run.
bool isFrame(const std::string& name) {
  return name.size() > 9 &&
         std::all_of(name.begin(), name.begin() + 4, [](unsigned char c) { return std::isdigit(c); }) &&
         name[4] == '-' && name.ends_with(".png");
}

}  // namespace

void makeFrameFolder(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::system_error{error, folder};
  fs::directory_iterator files{folder, error};
  if (error) throw std::system_error{error, folder};
  for (const fs::directory_entry& file : files)
    if (const std::string name = file.path().filename().string(); isFrame(name))
      throw UsageError{"--frames: " + inQuotes(folder) + " already holds frames, such as " + name +
                       "; name another folder, or remove them"};
}

std::string frameFile(const std::string& folder, int number, std::string_view word) {
  return (std::filesystem::path{folder} / fileName(number, word)).string();
}

}  // namespace xnewell
