#include "x11/command/tell_extremes.h"

#include <iostream>
#include <optional>

#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "shading/extremes/extremes.h"
#include "x11/command/extremes_chart.h"
#include "x11/command/extremes_report.h"
#include "x11/options/exit_status.h"
#include "x11/terminal/doing.h"
#include "x11/terminal/interrupt.h"

namespace xnewell {

int tellExtremes(const Options& options, const Scene& scene) {
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
