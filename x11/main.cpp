#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iomanip>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include "geometry/parse_error.h"
#include "shading/picture.h"
#include "shading/png.h"
#include "shading/scene.h"
#include "shading/views.h"
#include "x11/options.h"
#include "x11/report.h"
#include "x11/trace.h"
#include "x11/viewer.h"
#include "x11/write_frames.h"
#include "x11/x11_error.h"

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

/// One line of bounded length, whatever names and words it quotes: control characters become '?', and a
/// very long text keeps its two ends.
std::string oneLine(std::string text) {
  constexpr std::size_t kBegin = 600, kEnd = 200;
  if (text.size() > kBegin + kEnd) text.replace(kBegin, text.size() - kBegin - kEnd, "...");
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
  return text;
}

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
  if (const auto& refined = picture.shading().refined(); refined && refined->limit == RefineLimit::Pieces)
    std::cerr << "xnewell: --adapt " << options.picture.adapt
              << " is not reached everywhere: that would take more than a million polygons\n";

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
}

/// The scene's light and surfaces without what the command line says otherwise.
/// @throws UsageError where Ia + the sum of Ip then exceeds 1, or a texture is to be shown that cannot be
void giveWay(Scene& scene, const Options& options) {
  if (options.fill == Fill::XFillPolygon && !scene.textures.empty())
    throw UsageError{"--fill x11 gives a polygon one cell: it does not show the scene's textures"};
  const Said& said = options.said;
  for (MeshMaterial& m : scene.mesh.materials) {
    if (said.ka) m.ka.reset();
    if (said.kd) m.kd.reset();
    if (said.ks) m.ks.reset();
    if (said.n) m.n.reset();
  }
  if (said.Ia) scene.light.Ia.reset();
  if (said.light) scene.light.lights.clear();

  // What the user said of either has to do with what is left of the scene's.
  const Illumination& user = options.picture.light;
  const bool besideLights = said.Ia && !scene.light.lights.empty(), besideIa = said.Ip && scene.light.Ia;
  glm::dvec3 sum = scene.light.Ia.value_or(glm::dvec3{user.Ia});
  for (const Light& light : scene.light.lights) sum += light.Ip;
  if (scene.light.lights.empty()) sum += user.Ip;
  if ((besideLights || besideIa) && std::max({sum.r, sum.g, sum.b}) > kMostLight)
    throw UsageError{
        std::string{besideLights ? "--ia and the scene's lights" : "--ip and the scene's ambient light"} +
        ": their sum must not exceed 1"};
}

int run(int argc, char** argv) {
  std::optional<Options> said = parseOptions(argc, argv);
  if (!said) return kDone;
  if (said->command == Command::Scenes) return listScenes(), kDone;
  if (said->command == Command::Visuals) return std::cout << visualsTable(*said), kDone;

  const Stopwatch watch;
  Scene scene = read(*said);
  if (said->command == Command::Trace) scene.settings.order = Order::Newell;  // what it follows
  Options options = *parseOptions(argc, argv, scene.settings);  // again, over what the scene asks for
  giveWay(scene, options);
  options.picture.camera = inSceneUnits(completed(options.picture.camera, scene.camera), scene);
  toSceneUnits(options.picture.light, scene);
  if (!options.texture.empty()) wear(scene, readTexture(options.texture));
  const double msRead = watch.ms();
  if (options.command == Command::View) return runViewer(options, std::move(scene));
  if (options.command == Command::Snapshot) return takeSnapshot(options, std::move(scene), msRead), kDone;
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

int main(int argc, char** argv) try {
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
