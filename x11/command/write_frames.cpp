#include "x11/command/write_frames.h"

#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "x11/app/workbench.h"
#include "x11/command/frame_folder.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_bench.h"

namespace xnewell {

namespace {

constexpr int kMostFrames = 9999;

/// The steps of the kind that --every names. @throws UsageError
std::vector<int> stepsToDraw(const Options& options, const SortedScene& sorted) {
  const std::string word{kEvery[static_cast<int>(options.every)].name};
  std::vector<int> steps = stepsOf(sorted, options.every);
  if (steps.empty())
    throw UsageError{options.scene + ": the run has no " + word +
                     ", so there is no frame to write; --every paint has " +
                     std::to_string(sorted.fragments.size())};
  if (steps.size() >= kMostFrames)
    throw UsageError{"--every " + word + ": " + std::to_string(steps.size()) +
                     " frames are too many; the most is 9,998"};
  return steps;
}

}  // namespace

void writeFrames(const Options& options, const Picture& picture, const SortedScene& sorted) {
  const std::vector<int> steps = stepsToDraw(options, sorted);
  makeFrameFolder(options.frames);

  Frames frames{picture, sorted, !options.quick, steps};
  int number = 0;
  const auto write = [&](const IndexImage& frame, std::string_view what) {
    writeFile(frameFile(options.frames, ++number, what), encodePng(frame, frames.palette()));
  };
  for (const int step : steps) write(frames.at(step), wordFor(sorted.events[step - 1].kind));
  write(frames.finished(), "done");
}

void writeStepperFrames(const Options& options, Scene scene, const std::function<void(int, int)>& tell) {
  Workbench bench{std::move(scene), {.picture = options.picture, .fill = options.fill}, {}};
  const glm::ivec2 size = windowSize(options);
  bench.scale(options.scale);
  bench.resize(size.x, size.y);
  bench.switchTo(WindowView::DepthSort);
  const auto draw = [&] {
    while (bench.stale() != Workbench::Stale::Nothing) bench.update();
  };
  draw();
  if (bench.stepper().tooLong())
    throw UsageError{options.scene + ": the run is too long to step through; try fewer --divisions"};
  const SortedScene& sorted = bench.stepper().run()->sorted();
  const std::vector<int> steps = stepsToDraw(options, sorted);
  makeFrameFolder(options.frames);

  // The last step shows every face painted, so it is the last frame, whatever its kind.
  const int end = bench.stepper().run()->steps();
  std::vector<int> shown = steps;
  if (shown.back() != end) shown.push_back(end);
  const int all = static_cast<int>(shown.size());
  for (int number = 1; number <= all; ++number) {
    tell(number, all);
    const int step = shown[static_cast<std::size_t>(number - 1)];
    bench.stepper().goTo(step);
    draw();
    writeFile(frameFile(options.frames, number, step == end ? "done" : wordFor(sorted.events[step - 1].kind)),
              encodePng(bench.image(), bench.palette()));
  }
}

}  // namespace xnewell
