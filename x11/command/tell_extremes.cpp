#include "x11/command/tell_extremes.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>

#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "shading/extremes/extremes.h"
#include "x11/command/doing.h"
#include "x11/command/extremes_report.h"
#include "x11/command/interrupt.h"
#include "x11/views/extremes_chart.h"

namespace xnewell {

namespace {

/// Finds out early whether a file can be written: it takes minutes until there is something to write.
/// @throws std::system_error `FILE: Permission denied`, if it surely cannot
void checkWritable(const std::string& file) {
  const auto check = [&](const std::string& path, int access) {
    if (::faccessat(AT_FDCWD, path.c_str(), access, AT_EACCESS) != 0)
      throw std::system_error{errno, std::generic_category(), file};
  };
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(file, none);
  if (std::filesystem::is_directory(status)) throw std::system_error{EISDIR, std::generic_category(), file};
  const bool exists = std::filesystem::exists(status);
  if (exists) check(file, W_OK);
  if (exists && !std::filesystem::is_regular_file(status)) return;
  // writeFile() makes a new file in the folder.
  const std::filesystem::path folder = std::filesystem::weakly_canonical(file, none).parent_path();
  check((folder.empty() ? "." : folder / ".").string(), W_OK | X_OK);
}

}  // namespace

int tellExtremes(const Options& options, const Scene& scene) {
  if (!options.output.empty()) checkWritable(options.output);
  awaitInterrupt();
  PictureSettings settings = options.picture;
  const glm::ivec2 size = options.size.value_or(kExtremesSize);
  settings.width = size.x, settings.height = size.y;
  std::optional<Doing> driving;
  const Extremes extremes = extremesOf(scene, settings, [&](const std::string& doing) {
    driving.reset();  // each message replaces the one before
    driving.emplace("trying: " + doing);
    return !wasInterrupted();
  });
  driving.reset();
  if (options.json)
    printExtremesAsJson(options, extremes, std::cout);
  else
    printExtremes(extremes, std::cout);
  std::cout.flush();  // a chart that cannot be written must not cost the table
  if (!options.output.empty()) {
    const ColoredImage chart = drawExtremes(extremes, "Extremes of " + titleOf(scene));
    writeFile(options.output, encodePng(chart.image, chart.palette));
  }
  return extremes.isStopped() ? kInterrupted : kDone;
}

}  // namespace xnewell
