#include "x11/command/write_lesson.h"

#include <algorithm>
#include <filesystem>

#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "x11/app/workbench.h"
#include "x11/command/frame_folder.h"

namespace xnewell {

Lesson lessonNamed(const std::string& nameOrFile) {
  for (const LessonEntry& entry : builtInLessons())
    if (entry.name == nameOrFile) return readLesson(entry.file);
  const std::filesystem::path file{nameOrFile};
  if (file.extension() == ".json" && std::filesystem::exists(file)) return readLesson(file);
  throw UsageError{"there is no lesson " + inQuotes(nameOrFile) + "; `xnewell scenes` lists the lessons"};
}

void visitSteps(const Options& options, Lesson lesson, const std::function<void(int)>& tell,
                const std::function<void(Workbench& bench, int step)>& visit) {
  const int steps = static_cast<int>(lesson.steps.size());
  Workbench bench{readScene("teapot"), Setup{}, {}};
  const glm::ivec2 size = windowSize(options);
  bench.scale(options.scale);
  bench.resize(size.x, size.y);
  bench.teach(std::move(lesson));
  for (int step = 0; step < steps; ++step) {
    tell(step + 1);
    bench.lessons().goTo(step);
    while (bench.stale() != Workbench::Stale::Nothing) bench.update();
    visit(bench, step);
  }
}

void writeLesson(const Options& options, Lesson lesson, const std::function<void(int)>& tell) {
  makeFrameFolder(options.frames);
  visitSteps(options, std::move(lesson), tell, [&](const Workbench& bench, int step) {
    writeFile(frameFile(options.frames, step + 1, "step"), encodePng(bench.image(), bench.palette()));
  });
}

}  // namespace xnewell
