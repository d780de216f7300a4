#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <glm/geometric.hpp>
#include <iomanip>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include "geometry/exact/box.h"
#include "geometry/files/parse_error.h"
#include "shading/color/png.h"
#include "shading/picture/picture.h"
#include "shading/scene/scene.h"
#include "shading/scene/settings.h"
#include "x11/app/one_line.h"
#include "x11/app/snapshot.h"
#include "x11/app/viewer.h"
#include "x11/command/report.h"
#include "x11/command/trace.h"
#include "x11/command/write_frames.h"
#include "x11/command/write_lesson.h"
#include "x11/options/options.h"
#include "x11/views/views.h"
#include "x11/visual/x11_error.h"

namespace xnewell {

namespace {

/// Exit statuses of the contract.
enum Status { kDone = 0, kOutside = 1, kWrong = 2, kInterrupted = 130 };

/// Tells on a terminal what is being done, for as long as it lasts; silent anywhere else.
class Doing {
 public:
  explicit Doing(const std::string& what) : told_{::isatty(STDERR_FILENO) == 1} {
    if (told_) std::cerr << "xnewell: " << what << " ..." << std::flush;
  }
  Doing(const Doing&) = delete;
  Doing& operator=(const Doing&) = delete;
  ~Doing() {
    if (told_) std::cerr << "\r\033[K" << std::flush;  // back to the line's start, and clear it
  }

 private:
  bool told_;
};

Scene read(const Options& options) {
  std::optional<Doing> reading{"reading " + options.scene};
  Scene scene = readScene(options.scene, options.divisions);
  reading.reset();
  for (const std::string& note : scene.mesh.notes) std::cerr << "xnewell: " << oneLine(note) << '\n';
  return scene;
}

PictureSettings settingsOf(const Options& options) {
  PictureSettings settings = options.picture;
  const glm::ivec2 size = options.size.value_or(kPictureSize);
  settings.width = size.x;
  settings.height = size.y;
  return settings;
}

/// The walk through one picture: read, shade, project, order, paint, write.
StageTimes draw(const Options& options, Picture& picture, double msRead) {
  const Doing drawing{"drawing"};
  picture.make(settingsOf(options));
  if (const auto& refined = picture.shading().refined(); refined && refined->limit != RefineLimit::None)
    std::cerr << "xnewell: --adapt " << options.picture.adapt << " is not reached everywhere: "
              << (refined->limit == RefineLimit::Pieces
                      ? "that would take more than a million polygons\n"
                      : "that would take pieces smaller than a thousandth of a polygon\n");

  const CellPlan plan{picture.settings().table.kind};
  IndexImage image;
  picture.paint(image, plan[Cell::Well]);
  StageTimes times = picture.times();
  times.read = msRead;
  const Stopwatch watch;
  const Palette palette = withEffects(picture.palette(plan), picture, plan, options.effects);
  writePictures(options, picture, encodePng(image, palette));
  times.present = watch.ms();
  return times;
}

/// The same for the numbers behind the picture, which is then a part of what is written.
void drawNumbers(const Options& options, Picture& picture) {
  const Doing drawing{"drawing"};
  const ColoredImage view = drawView(picture, {.view = options.view,
                                               .scanline = options.scanline,
                                               .cell = options.cell,
                                               .effects = options.effects,
                                               .picture = settingsOf(options),
                                               .cells = CellPlan{options.picture.table.kind}});
  writePictures(options, picture, encodePng(view.image, view.palette));
}

/// The walk through a run of the depth sort: read, shade, project, sort, tell.
void trace(const Options& options, Picture& picture) {
  if (options.wholeWindow) {
    std::optional<Doing> drawing;
    return writeStepperFrames(options, Scene{picture.scene()}, [&](int number, int all) {
      if (number % 25 != 1) return;
      drawing.reset();  // each tells in the place of the one before
      drawing.emplace("drawing frame " + std::to_string(number) + " of " + std::to_string(all));
    });
  }
  SortedScene sorted;
  {
    const Doing sorting{"sorting"};
    PictureSettings settings = settingsOf(options);
    settings.order = Order::Unsorted;  // the run that is told is the sort
    if (channelsOf(planOf(picture.scene(), settings)) == Channels::Rgb) settings.colors = ColorPlan::OneHue;
    picture.make(settings);
    picture.addPlanes();
    sorted = recordedRun(options, picture);
  }
  if (!options.frames.empty()) {
    const Doing writing{"writing frames"};
    return writeFrames(options, picture, sorted);
  }
  std::optional<Doing> telling;
  if (::isatty(STDOUT_FILENO) == 0) telling.emplace("telling");  // else the lines are seen
  printTrace(options, picture, sorted, std::cout);
}

void listScenes() {
  for (const BuiltInScene& scene : builtInScenes())
    std::cout << std::left << std::setw(18) << scene.name << ' ' << scene.shows << '\n';
  for (const LessonEntry& lesson : builtInLessons())
    std::cout << std::left << std::setw(26) << "lesson " + lesson.name << ' ' << lesson.shows << '\n';
}

int openWindow(const Options& options, Scene scene, std::optional<Lesson> lesson = {}) {
  std::optional<Doing> drawing{"drawing the first picture"};
  return runViewer(options, std::move(scene), std::move(lesson), [&] { drawing.reset(); });
}

/// A lesson in the window, or its steps as pictures.
int teach(const Options& options) {
  std::optional<Lesson> lesson;
  if (options.gave("scene")) {
    const Doing reading{"reading " + options.scene};
    lesson = lessonNamed(options.scene);
  }
  if (options.frames.empty()) return openWindow(options, readScene("teapot"), std::move(lesson));
  const std::string all = " of " + std::to_string(lesson->steps.size());
  std::optional<Doing> writing;
  writeLesson(options, std::move(*lesson), [&](int step) {
    writing.reset();  // each tells in the place of the one before
    writing.emplace("drawing step " + std::to_string(step) + all);
  });
  return kDone;
}

/// The scene's light and surfaces without what the command line says otherwise.
/// @throws UsageError where Ia + the sum of Ip then exceeds 1, or a texture is to be shown that cannot be
void giveWay(Scene& scene, const Options& options) {
  if (options.fill == Fill::XFillPolygon && !scene.textures.empty())
    throw UsageError{"--fill x11 gives a polygon one cell: it does not show the scene's textures"};
  for (const Setting& setting : settingRows())
    if (!setting.replaces.empty() && options.gave(setting.option)) strip(scene, setting.replaces);

  // What the user said of either has to do with what is left of the scene's.
  const Illumination& user = options.picture.light;
  const bool besideLights = options.gave("--ia") && !scene.light.lights.empty(),
             besideIa = options.gave("--ip") && scene.light.Ia;
  glm::dvec3 sum = scene.light.Ia.value_or(glm::dvec3{user.Ia});
  for (const Light& light : scene.light.lights) sum += light.Ip;
  if (scene.light.lights.empty()) sum += user.Ip;
  if ((besideLights || besideIa) && std::max({sum.r, sum.g, sum.b}) > kMostLight)
    throw UsageError{
        std::string{besideLights ? "--ia and the scene's lights" : "--ip and the scene's ambient light"} +
        ": their sum must not exceed 1"};
}

/// What the user says of attenuation counts for the scene's own lights at places where he has none: lengths
/// are in the scene's units by then. @throws UsageError where no light can fade
void fade(Scene& scene, const Options& options) {
  const Illumination& user = options.picture.light;
  if (!options.gave("--attenuation") || user.lightPosition) return;
  const glm::dvec3 centre = boxOf(scene.mesh.points).centre();
  bool any = false;
  for (Light& light : scene.light.lights) {
    if (light.kind == LightKind::Directional) continue;
    any = true;
    const double distance = std::max(glm::length(light.position - centre), 0x1p-20);
    light.attenuation = user.attenuation;
    light.range = user.range.value_or(2.0 * distance);
    light.c = user.c.value_or(glm::dvec3{1.0, 0.0, 1.0 / (distance * distance)});
  }
  if (!any && user.attenuation != Attenuation::None)
    throw UsageError{"--attenuation needs a light at a place: --light-at x,y,z, or a scene that has one"};
  if (any &&
      options.command == Command::View)  // whose set-ups name the scene, and not what became of its lights
    throw UsageError{
        "--attenuation of the scene's own lights goes with draw, snapshot and trace; for a window "
        "say --light-at x,y,z too"};
}

/// The picture through a window of a server.
void snapshot(const Options& options, Scene scene, double msRead) {
  takeSnapshot(options, std::move(scene),
               [&](const Picture& picture, const std::string& png, StageTimes times) {
                 times.read = msRead;
                 writePictures(options, picture, png);
                 report(options, picture, times);
               });
}

int run(int argc, char** argv) {
  std::optional<Options> said = parseOptions(argc, argv);
  if (!said) return kDone;
  if (said->command == Command::Scenes) return listScenes(), kDone;
  if (said->command == Command::Visuals) return std::cout << visualsTable(*said), kDone;

  if (said->command == Command::Lesson) return teach(*said);

  const Stopwatch watch;
  Scene scene = read(*said);
  if (said->command == Command::Trace) scene.settings.order = Order::Newell;  // what it follows
  Options options = *parseOptions(argc, argv, scene.settings);  // again, over what the scene asks for
  giveWay(scene, options);
  options.picture.camera = inSceneUnits(completed(options.picture.camera, scene.camera), scene);
  toSceneUnits(options.picture.light, scene);
  fade(scene, options);
  if (!options.texture.empty()) {
    wear(scene, readTexture(options.texture));
    scene.origin.texture = options.texture;
  }
  const double msRead = watch.ms();
  if (options.command == Command::View) return openWindow(options, std::move(scene));
  if (options.command == Command::Snapshot) return snapshot(options, std::move(scene), msRead), kDone;
  Picture picture{std::move(scene)};
  if (options.command == Command::Trace) return trace(options, picture), kDone;
  if (options.view != View::Picture) return drawNumbers(options, picture), kDone;
  const StageTimes times = draw(options, picture, msRead);
  report(options, picture, times);
  return kDone;
}

int failed(Status status, const std::string& what) {
  std::cerr << "xnewell: " << oneLine(what) << '\n';
  return status;
}

/// A standard stream that was closed when we started stays unusable: no file of ours, and no connection to a
/// server, may get its number and be written to by mistake.
void occupyStandardStreams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

/// Returns the exit status.
int program(int argc, char** argv) try {
  occupyStandardStreams();
  // A picture in the making leaves nothing behind.
  std::signal(SIGINT, [](int) { _exit(kInterrupted); });
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the shell's limit is an error like a full disk
  const int status = run(argc, argv);
  std::cout.flush();
  if (!std::cout) throw std::system_error{errno, std::generic_category(), "standard output"};
  return status;
} catch (const UsageError& e) {
  return failed(kWrong, e.what());
} catch (const ViewError& e) {
  return failed(kWrong, e.what());
} catch (const ParseError& e) {
  return failed(kWrong, e.what());
} catch (const std::invalid_argument& e) {
  return failed(kWrong, e.what());
} catch (const std::bad_alloc&) {
  return failed(kOutside, "out of memory");
} catch (const std::exception& e) {
  return failed(kOutside, e.what());
}

}  // namespace xnewell

int main(int argc, char** argv) { return xnewell::program(argc, argv); }
