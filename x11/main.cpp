#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <system_error>

#include "geometry/parse_error.h"
#include "shading/picture.h"
#include "shading/png.h"
#include "shading/scene.h"
#include "x11/options.h"
#include "x11/report.h"
#include "x11/viewer.h"
#include "x11/x11_error.h"

namespace {

/// Exit statuses of the contract.
enum Status { kDone = 0, kOutside = 1, kWrong = 2, kInterrupted = 130 };

/// The walk through one picture: read, shade, project, order, paint, write.
void draw(const Options& options, Picture& picture, double msRead) {
  PictureSettings settings = options.picture;
  const glm::ivec2 size = options.size.value_or(glm::ivec2{800, 600});
  settings.width = size.x;
  settings.height = size.y;
  picture.make(settings);

  const CellPlan plan{settings.table.kind};
  IndexImage image;
  picture.paint(image, plan[Cell::Well]);
  StageTimes times = picture.times();
  times.read = msRead;
  const Stopwatch watch;
  writePng(options.output, image, makePalette(plan, picture.table()));
  times.present = watch.ms();
  report(options, picture, times);
}

void listScenes() {
  for (const BuiltInScene& scene : kBuiltInScenes)
    std::cout << scene.name << std::string(12 - scene.name.size(), ' ') << scene.shows << '\n';
}

int run(Options options) {
  if (options.command == Command::Scenes) return listScenes(), kDone;
  if (options.command == Command::Visuals) return std::cout << visualsTable(options), kDone;

  const Stopwatch watch;
  Scene scene = readScene(options.scene, options.divisions);
  options.picture.camera = inSceneUnits(options.picture.camera, scene);
  if (!options.lightGiven) options.picture.light.light = defaultLight(scene.up);
  if (auto& light = options.picture.light.lightPosition) light = inSceneUnits(*light, scene);
  const double msRead = watch.ms();
  if (options.command == Command::View) return runViewer(options, std::move(scene));
  if (options.command == Command::Snapshot) return takeSnapshot(options, std::move(scene), msRead), kDone;
  Picture picture{std::move(scene)};
  return draw(options, picture, msRead), kDone;
}

int failed(Status status, const std::exception& e) {
  std::cerr << "xnewell: " << e.what() << '\n';
  return status;
}

}  // namespace

int main(int argc, char** argv) try {
  // A picture in the making leaves nothing behind (a window has its own way to end).
  std::signal(SIGINT, [](int) { _exit(kInterrupted); });
  const std::optional<Options> options = parseOptions(argc, argv);
  const int status = options ? run(*options) : kDone;
  std::cout.flush();
  if (!std::cout) throw std::system_error{errno, std::generic_category(), "standard output"};
  return status;
} catch (const UsageError& e) {
  return failed(kWrong, e);
} catch (const ViewError& e) {
  return failed(kWrong, e);
} catch (const ParseError& e) {
  return failed(kWrong, e);
} catch (const std::invalid_argument& e) {
  return failed(kWrong, e);
} catch (const std::exception& e) {
  return failed(kOutside, e);
}
