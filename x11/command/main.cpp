#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>

#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/parse_error.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/shared.h"
#include "shading/scene/scene.h"
#include "shading/scene/settings.h"
#include "x11/app/key_lists.h"
#include "x11/app/lecture.h"
#include "x11/app/snapshot.h"
#include "x11/app/viewer.h"
#include "x11/command/commands.h"
#include "x11/command/read_lecture.h"
#include "x11/command/report.h"
#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/options/exit_status.h"
#include "x11/options/options.h"
#include "x11/options/setup_command.h"
#include "x11/pixel/pixel_page.h"
#include "x11/scanline/scanline_trace.h"
#include "x11/terminal/terminal.h"
#include "x11/viewing/viewing_page.h"
#include "x11/views/views.h"
#include "x11/visual/x11_error.h"
#include "x11/window/controls.h"

extern const char* const kRunHeader;

namespace xnewell {

namespace {

/// What the command line names, as it was read.
struct Input {
  Scene scene;
  double msRead;
  page::Data accuracy;  ///< what --accuracy has chosen
};

/// From a scene to a picture in a file.
void drawPicture(const Options& options, Input in) {
  std::optional<Doing> drawing{"drawing"};
  const PictureSettings settings = settingsOf(options);
  const CellPlan plan{settings.table.kind};
  const Picture picture = makePicture(std::move(in.scene), settings, plan[Cell::Well]);
  if (const auto& refined = picture.shading().refined(); refined && refined->limit != RefineLimit::None)
    std::cerr << "xnewell: --adapt " << options.picture.adapt << " is not reached everywhere: "
              << (refined->limit == RefineLimit::Parts
                      ? "that would take more than a million polygons\n"
                      : "that would take parts smaller than a thousandth of a polygon\n");

  drawing.reset();
  const std::optional<Errors> errors = measuredErrors(options, picture);
  StageTimes times = picture.times();
  times.read = in.msRead;
  drawing.emplace("writing");
  const Stopwatch watch;
  const Palette palette = withEffects(picture.palette(plan), picture, plan, options.effects);
  writePictures(options, picture, encodePng(withMarks(picture, palette), palette, noteOf(options, picture)));
  times.present = watch.ms();
  drawing.reset();
  report(options, picture, errors, times, in.accuracy);
}

/// Says why a pixel has its colour, or what the viewing transformation does to a vertex.
void explainPixel(const Options& options, Scene scene) {
  const PictureSettings settings = settingsOf(options);
  std::optional<Doing> drawing{"drawing"};
  const Picture picture = makePicture(std::move(scene), settings, CellPlan{settings.table.kind}[Cell::Well]);
  drawing.reset();
  noteEmpty(std::cerr, picture);
  print(options,
        options.gave("--viewing")
            ? page::ofViewing({std::make_shared<const ViewingStory>(
                                   picture, vertexOf(picture, options.window.vertex.value_or(""))),
                               picture})
            : page::ofPixel(std::make_shared<const PixelStory>(picture, options.pixel->x, options.pixel->y)));
}

/// Draws the numbers behind the picture (--view) and writes them.
void drawNumbers(const Options& options, Scene scene) {
  const Doing drawing{"drawing"};
  PictureCache pictures{std::move(scene)};
  const ColoredImage view = drawView(pictures, {.view = options.view,
                                                .scanline = options.window.scanline,
                                                .cell = options.window.cell,
                                                .effects = options.effects,
                                                .picture = settingsOf(options),
                                                .cells = CellPlan{options.picture.table.kind}});
  writePictures(options, pictures.last(),
                encodePng(view.image, view.palette, noteOf(options, pictures.last())));
}

/// The walk through a run of the depth sort: read, shade, project, sort, trace.
void trace(const Options& options, Scene scene) {
  if (options.wholeWindow) {
    std::optional<Doing> drawing;
    return writeStepperFrames(options, std::move(scene), [&](int number, int all) {
      if (number % 25 != 1) return;
      drawing.emplace("drawing frame " + std::to_string(number) + " of " + std::to_string(all));
    });
  }
  std::optional<Doing> sorting{"sorting"};
  PictureSettings settings = settingsOf(options);
  settings.order = Order::Unsorted;  // the trace makes its own sort
  const bool oneHue = channelsOf(planOf(scene, settings)) == Channels::Rgb;
  if (oneHue) settings.colors = ColorPlan::OneHue;
  if (options.window.polygon) {
    const Picture picture =
        makePicture(std::move(scene), settings, CellPlan{settings.table.kind}[Cell::Well]);
    sorting.reset();
    return printScanline(options.scene, *options.window.polygon, picture, oneHue, std::cout);
  }
  const Picture picture = makePicture(std::move(scene), settings).withPlanes();
  const SortedScene sorted = recordedRun(options, picture);
  sorting.reset();
  if (!options.frames.empty()) {
    const Doing writing{"writing frames"};
    return writeFrames(options, picture, sorted);
  }
  std::optional<Doing> telling;
  // If standard output is a terminal, its lines show the progress.
  if (::isatty(STDOUT_FILENO) == 0) telling.emplace("writing the trace");
  printTrace(options, picture, sorted, std::cout);
}

void listScenes() {
  for (const BuiltInScene& scene : builtInScenes())
    std::cout << std::left << std::setw(18) << scene.name << ' ' << scene.shows << '\n';
  for (const LessonEntry& lesson : builtInLessons())
    std::cout << std::left << std::setw(26) << "lesson " + lesson.name << ' ' << lesson.shows << '\n';
  for (const LectureEntry& lecture : builtInLectures())
    std::cout << std::left << std::setw(26) << "lecture " + lecture.name << ' ' << lecture.shows << '\n';
}

int openWindow(const Options& options, Scene scene, std::optional<Lesson> lesson = {}) {
  std::optional<Doing> drawing{"drawing the first picture"};
  return runViewer(options, std::move(scene), std::move(lesson), [&] { drawing.reset(); });
}

/// Shows the pages of a lecture in the window.
int lecture(const Options& options) {
  std::optional<Doing> doing{"reading " + options.scene};
  std::vector<Page> pages = readLecture(options.scene);
  if (!options.page.empty()) return writePage(options), kDone;
  doing.emplace("drawing the first page");
  return runLecture(options, std::move(pages), [&] { doing.reset(); });
}

/// Says which sentences of a lesson rest on claims that do not hold. The program's own lessons have a test.
void warnOfClaims(const Lesson& lesson, const Options& options) {
  std::optional<Doing> checking{"checking the claims of " + options.scene};
  const std::vector<std::string> broken = brokenClaims(lesson, windowSize(options) / options.scale);
  checking.reset();
  for (const std::string& sentence : broken)
    std::cerr << "xnewell: " + oneLine(options.scene + ": " + sentence) + '\n';
}

/// Shows a lesson in the window, or writes its steps as pictures.
int teach(const Options& options) {
  std::optional<Lesson> lesson;
  if (options.gave("scene")) {
    const Doing reading{"reading " + options.scene};
    lesson = lessonNamed(options.scene);
    if (const auto steps = lesson->steps.size(); options.window.step > static_cast<int>(steps))
      throw UsageError{"--step: the lesson has " + counted(steps, "step")};
    if (std::filesystem::path{options.scene}.extension() == ".json") warnOfClaims(*lesson, options);
    checkOutputs(outputsOf(options));
  }
  if (!options.page.empty()) return writePage(options), kDone;
  if (options.frames.empty() && options.worksheet.empty())
    return openWindow(options, readScene("teapot"), std::move(lesson));
  const std::string all = " of " + std::to_string(lesson->steps.size());
  std::optional<Doing> writing;
  const auto write = options.frames.empty() ? writeWorksheet : writeLesson;
  write(options, std::move(*lesson),
        [&](int step) { writing.emplace("drawing step " + std::to_string(step) + all); });
  return kDone;
}

/// Draws the picture in a window of a server, reads it back and writes it.
void snapshot(const Options& options, Input in) {
  takeSnapshot(options, std::move(in.scene),
               [&](const Picture& picture, const std::string& png, StageTimes times, const Sent& sent) {
                 times.read = in.msRead;
                 const std::optional<Errors> errors = measuredErrors(options, picture);
                 writePictures(options, picture, png);
                 report(options, picture, errors, times, in.accuracy, &sent);
               });
}

/// What each command that draws a scene does with it, and what the others do.
struct RunRow {
  Command id;
  int (*run)(const Options&, Input) = nullptr;
  int (*alone)(const Options&) = nullptr;
};
constexpr std::array kRuns{
    RunRow{Command::View, [](auto& o, Input in) { return openWindow(o, std::move(in.scene)); }},
    RunRow{Command::Draw,
           [](auto& o, Input in) {
             if (o.view == View::Picture)
               drawPicture(o, std::move(in));
             else
               drawNumbers(o, std::move(in.scene));
             return int{kDone};
           }},
    RunRow{Command::Snapshot, [](auto& o, Input in) { return snapshot(o, std::move(in)), int{kDone}; }},
    RunRow{Command::Figure, [](auto& o, Input in) { return drawFigure(o, in.scene), int{kDone}; }},
    RunRow{Command::Explain,
           [](auto& o, Input in) { return explainPixel(o, std::move(in.scene)), int{kDone}; }},
    RunRow{Command::Trace, [](auto& o, Input in) { return trace(o, std::move(in.scene)), int{kDone}; }},
    RunRow{Command::Trade, [](auto& o, Input in) { return tellTrade(o, std::move(in.scene)); }},
    RunRow{Command::Extremes, [](auto& o, Input in) { return tellExtremes(o, in.scene); }},
    RunRow{Command::Diagnose, [](auto& o, Input in) { return tellDiagnosis(o, std::move(in.scene)); }},
    RunRow{Command::Judge,
           [](auto& o, Input in) {
             return o.window.run.empty() ? tellJudgement(o, std::move(in.scene))
                                         : tellRun(o, std::move(in.scene));
           }},
    RunRow{Command::Grade, [](auto& o, Input in) { return gradeFolder(o, std::move(in.scene)); }},
    RunRow{Command::Questions, [](auto& o, Input in) { return tellQuestions(o, in.scene); }},
    RunRow{Command::Lesson, nullptr, teach},
    RunRow{Command::Lecture, nullptr, lecture},
    RunRow{Command::Visuals, nullptr, [](auto& o) { return std::cout << visualsTable(o), int{kDone}; }},
    RunRow{Command::Scenes, nullptr, [](auto&) { return listScenes(), int{kDone}; }},
    RunRow{Command::Keys, nullptr, [](auto&) { return std::cout << keyLists(), int{kDone}; }},
    RunRow{Command::RunHeader, nullptr, [](auto&) { return std::cout << kRunHeader, int{kDone}; }},
};

int run(int argc, char** argv) {
  if (argc > 2 && std::string_view{argv[1]} == "complete" && std::string_view{argv[2]} == "--")
    return std::fputs(proposalsFor({argv + 3, argv + argc}).c_str(), stdout), kDone;  // with its tabs
  std::optional<Options> said = parseOptions(argc, argv);
  if (!said) return kDone;
  Options& options = *said;
  const RunRow& command = *std::ranges::find(kRuns, options.command, &RunRow::id);
  if (command.alone) {
    settle(options, {});
    return command.alone(options);
  }
  if (!options.sceneFor.empty()) return tellSceneFor(options);
  if (!options.handedIn.empty()) rememberInput(options.handedIn);
  const Stopwatch watch;
  Scene scene = readyScene(options);
  const double msRead = watch.ms();
  checkOutputs(outputsOf(options));
  page::Data accuracy;
  if (options.accuracy) accuracy = keepWithin(*options.accuracy, options, scene);
  return command.run(options, {std::move(scene), msRead, std::move(accuracy)});
}

int failed(ExitStatus status, const std::string& what) {
  const std::string line = "xnewell: " + oneLine(what) + '\n';  // before a part of it is on the terminal
  std::cerr << line;
  return status;
}

/// What std::terminate() did before. It tells of an exception that nothing catches.
std::terminate_handler terminateOtherwise = nullptr;

/// Ends the program where no exception leaves: if memory is refused before main(), or to a destructor of
/// nlohmann-json, which may need some. If there is none even for the exception, malloc() refuses a byte.
[[noreturn]] void endWithoutMemory() noexcept {
  bool refused = false;
  if (const std::exception_ptr what = std::current_exception()) {
    try {
      std::rethrow_exception(what);
    } catch (const std::bad_alloc&) {
      refused = true;
    } catch (...) {
    }
  } else {
    void* const byte = std::malloc(1);
    refused = byte == nullptr;
    std::free(byte);
  }
  if (!refused) terminateOtherwise();
  constexpr std::string_view line = "xnewell: out of memory\n";
  std::ignore = ::write(STDERR_FILENO, line.data(), line.size());
  _exit(kOutside);
}
/// Runs before the constructors of all static objects.
[[gnu::constructor(101)]] void awaitEndOfMemory() {
  terminateOtherwise = std::set_terminate(endWithoutMemory);
}

/// Opens /dev/null on each standard stream that was closed when we started. It stays unusable, and no file or
/// server connection of ours can get its number and be written to by mistake.
void occupyStandardStreams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

/// Returns the exit status.
int program(int argc, char** argv) try {
  const VisibleStream out{std::cout}, errors{std::cerr};
  keepFreedMemory();
  occupyStandardStreams();
  // An interrupted picture leaves no files behind. A window, too, ends at once, even while Xlib waits for a
  // server that hangs. The server frees what we have there, and any grab, when the connection closes.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, [](int number) { _exit(128 + number); });
    if (signal == SIGHUP && before == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup asked for that
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a file larger than the shell's limit is an error like a full disk
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
