#include "x11/app/snapshot.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>
#include <utility>

#include "shading/picture/shared.h"
#include "x11/app/server.h"
#include "x11/app/workbench.h"
#include "x11/options/option_rows.h"
#include "x11/options/setup_command.h"
#include "x11/scanline/scanline_words.h"
#include "x11/server/fill_polygons.h"
#include "x11/server/read_cells.h"
#include "x11/server/read_visuals.h"
#include "x11/viewing/viewing_page.h"
#include "x11/views/views.h"

namespace xnewell {

namespace {

/// What a snapshot shows: the picture alone, or the whole window.
struct Shot {
  const Picture& picture;
  const IndexImage& image;
  const Palette& palette;
  CellPlan plan;             ///< the plan of the image's cells
  Rect area;                 ///< the picture's place in the image
  std::vector<Rect> over{};  ///< the parts of the image that lie over the picture
};

void present(Server& server, Canvas& canvas, const Shot& shot, Fill fill) {
  server.colormap.store(server.colorsOf(shot.picture, shot.palette), shot.plan);
  const Rect all{0, 0, shot.image.width, shot.image.height};
  canvas.upload(shot.image, all);
  if (fill == Fill::XFillPolygon) {
    fillPolygons(server.display.get(), canvas, shot.picture, shot.area, shot.plan[Cell::Well]);
    for (const Rect& part : shot.over) canvas.upload(shot.image, part);
  }
  canvas.expose(all);
}

/// Refuses a place where the window does not begin, unless a picture carries it: that may have had another
/// size.
void refuseOtherPlace(const Options& o, const Workbench& bench) {
  const WindowPlace &asked = o.window, shown = bench.place();
  const auto asks = [&](std::string_view option) {
    return o.gave(option) && std::ranges::find(o.carried, option) == o.carried.end();
  };
  const auto same = [&](std::string_view option, int wanted, int nearest) {
    if (wanted != nearest)
      throw UsageError{std::string{option} + ' ' + std::to_string(wanted) + " is not in --view " +
                       std::string{rowOf(o.view).name} + ": the nearest is " + std::to_string(nearest)};
  };
  const PictureSettings& settings = bench.picture().settings();
  if (asks("--pixel") && asked.pixel != shown.pixel)
    refuseOutside(*asked.pixel, {settings.width, settings.height});
  if (asks("--viewing")) (void)vertexOf(bench.picture(), asked.vertex.value_or(""));
  if (asks("--scanline") && shown.scanline) same("--scanline", *asked.scanline, *shown.scanline);
  if (asks("--scanline") && shown.polygon && faceNamed(bench.picture(), *asked.polygon) < 0)
    throw UsageError{noFace(bench.picture(), o.scene, *asked.polygon)};
  if (asks("--step")) same("--step", asked.step, shown.step);
}

}  // namespace

void takeSnapshot(const Options& options, Scene scene, const Taken& taken) {
  Server server{options, scene};
  const glm::ivec2 size = options.wholeWindow ? windowSize(options) : options.size.value_or(kPictureSize);
  Canvas canvas{server.display.get(), server.colormap, {.width = size.x, .height = size.y}};
  ErrorTrap trap{server.display.get()};
  canvas.map();

  const auto shoot = [&](const Shot& shot) {
    StageTimes times = shot.picture.times();
    const SentMeter meter{server.display.get()};
    const Stopwatch watch;
    present(server, canvas, shot, options.fill);
    Sent sent = meter.sent();
    trap.check();
    times.present = watch.ms();
    XWindowAttributes window{};
    XGetWindowAttributes(server.display.get(), canvas.window(), &window);
    measureImage(sent, server.display.get(), window.depth, canvas.width(), canvas.height());
    sent.sharedMemory = canvas.sharedMemory();
    if (strayErrors() > 0) throw X11Error{"the X server refused requests, so there is no picture"};
    taken(shot.picture, pngOf(canvas, server.colormap, shot.image, noteOf(options, shot.picture)), times,
          sent);
    std::cout.flush();
    nothingMoreIsNeeded();
  };
  if (options.wholeWindow) {
    Workbench bench{std::move(scene), server.setupOf(options), server.forBench()};
    bench.scale(options.scale);
    bench.resize(size.x, size.y);
    bench.goTo(options.window);
    bench.update();
    if (bench.view() == View::Trade)
      for (; bench.moving(); bench.tick()) std::this_thread::sleep_for(std::chrono::milliseconds{20});
    for (int k = 0; k == 0 || (k < 3 && bench.stale() != Workbench::Stale::Nothing); ++k) bench.update();
    refuseOtherPlace(options, bench);
    shoot({bench.picture(), bench.image(), bench.palette(), bench.plan(), bench.pictureArea(),
           bench.overPicture()});
    return;
  }
  PictureCache pictures{std::move(scene)};
  PictureSettings settings = server.fitted(options.picture);
  settings.width = size.x;
  settings.height = size.y;
  settings.inPixels = options.fill == Fill::XFillPolygon;
  const CellPlan plan = server.colormap.plan(settings.table.kind);
  if (options.view != View::Picture) {
    const ColoredImage view = drawView(pictures, {.view = options.view,
                                                  .scanline = options.window.scanline,
                                                  .cell = options.window.cell,
                                                  .effects = options.effects,
                                                  .picture = settings,
                                                  .cells = plan,
                                                  .unneeded = server.colormap.unneeded(),
                                                  .gray = server.gray()});
    return shoot({pictures.last(), view.image, view.palette, plan, {0, 0, size.x, size.y}});
  }
  const Picture picture = pictures.make(settings, plan[Cell::Well]);
  const Palette palette =
      withEffects(picture.palette(plan, server.colormap.unneeded()), picture, plan, options.effects);
  shoot({picture, withMarks(picture, palette), palette, plan, {0, 0, size.x, size.y}});
}

std::string visualsTable(const Options& options) {
  const OwnedDisplay display = openDisplay();
  const std::string table =
      describeVisuals(readVisuals(display.get(), /*countsCells=*/true), wishOf(options), options.colormap);
  XSync(display.get(), 0);
  if (strayErrors() > 0) throw X11Error{"the X server refused requests, so there is no table"};
  return table;
}

}  // namespace xnewell
