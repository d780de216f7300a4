#include "x11/write_frames.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "geometry/text_file.h"
#include "shading/frames.h"
#include "shading/output_file.h"
#include "shading/png.h"

namespace {

constexpr int kMostFrames = 9999;

/// A frame's number has at least four digits; the folder's names are in order of the run.
std::string fileName(int number, std::string_view word) {
  std::string digits = std::to_string(number);
  return std::string(4 - digits.size(), '0') + digits + "-" + std::string{word} + ".png";
}

/// A frame of an earlier run, which would be mistaken for one of this.
bool isFrame(const std::string& name) {
  return name.size() > 9 &&
         std::all_of(name.begin(), name.begin() + 4, [](unsigned char c) { return std::isdigit(c); }) &&
         name[4] == '-' && name.ends_with(".png");
}

void makeEmptyFolder(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::system_error{error, folder};
  fs::directory_iterator files{folder, error};
  if (error) throw std::system_error{error, folder};
  for (const fs::directory_entry& file : files)
    if (const std::string name = file.path().filename().string(); isFrame(name))
      throw UsageError{"--frames: " + inQuotes(folder) + " holds frames already, such as " + name +
                       ": name another folder, or remove them"};
}

}  // namespace

void writeFrames(const Options& options, const Picture& picture, const SortedScene& sorted) {
  const std::vector<int> steps = stepsOf(sorted, options.every);
  const std::string word{kEvery[static_cast<int>(options.every)].name};
  if (steps.empty())
    throw UsageError{options.scene + ": the run has no " + word + " to make a frame of; --every paint has " +
                     std::to_string(sorted.fragments.size())};
  if (steps.size() >= kMostFrames)
    throw UsageError{"--every " + word + ": " + std::to_string(steps.size()) +
                     " frames are too many; at most 9,998 are written"};
  makeEmptyFolder(options.frames);

  Frames frames{picture, sorted, !options.quick, steps};
  int number = 0;
  const auto write = [&](const IndexImage& frame, std::string_view what) {
    writeFile((std::filesystem::path{options.frames} / fileName(++number, what)).string(),
              encodePng(frame, frames.palette()));
  };
  for (const int step : steps) write(frames.at(step), wordFor(sorted.events[step - 1].kind));
  write(frames.finished(), "done");
}
