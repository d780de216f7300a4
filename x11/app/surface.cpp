#include "x11/app/surface.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "x11/app/viewer.h"
#include "x11/server/fill_polygons.h"
#include "x11/server/read_visuals.h"
#include "x11/visual/x11_error.h"

namespace xnewell {

Surface::Surface(const Options& options, Scene scene, const Setup& setup, Workbench::Server server,
                 std::function<void()> refresh, std::function<std::string()> png)
    : bench_{std::move(scene), setup,
             [&] {
               server.say = [](const std::string& text) { std::cout << text << std::flush; };
               server.picture = [this, refresh = std::move(refresh), png = std::move(png)] {
                 for (int k = 0; k < 3 && bench_.stale() != Workbench::Stale::Nothing; ++k) refresh();
                 return png();
               };
               return std::move(server);
             }()},
      scale_{options.gave("--scale") ? options.scale : 0} {
  if (!options.answers.empty()) bench_.lessons().keepAnswers(options.answers);
}

void Surface::scale(int usual, int width, int height) {
  if (!bench_.scaleIsChosen())
    bench_.scale(std::min(scale_ > 0 ? scale_ : usual, largestScale(width, height)));
}

void Surface::move(int x, int y) {
  if (dragging_)
    bench_.dragTo(x, y);
  else
    bench_.hover(x, y);
}

void Surface::letGo() {
  if (std::exchange(dragging_, false)) bench_.settle();
}

int Surface::tick() {
  constexpr double kTick = 40;
  if (!bench_.moving()) return -1;
  const double rest = kTick - sinceTick_.ms();
  if (rest > 0) return 1 + static_cast<int>(rest);
  sinceTick_ = {};
  bench_.tick();
  return 0;
}

int runViewer(const Options& options, Scene scene, std::optional<Lesson> lesson,
              const std::function<void()>& shown) {
  return showWindow(
      options, std::move(scene),
      [&](Workbench& bench) {
        bench.begin(options, std::move(lesson));
        if (options.command == Command::View && options.given.empty()) bench.welcome();
      },
      shown);
}

int runLecture(const Options& options, std::vector<Page> pages, const std::function<void()>& shown) {
  Scene scene = pages.front().scene;
  return showWindow(
      options, std::move(scene),
      [&](Workbench& bench) {
        bench.lecture({std::move(pages), options.play});
      },
      shown);
}

namespace {

/// Makes the colormap that the options ask for. If the server has no room for another map, it takes cells of
/// the default map. It prints on standard error what the user asked for and does not get.
ServerColormap openColormap(Display* display, const Options& options, const Scene& scene) {
  const ServerVisuals server = readVisuals(display);
  const std::optional<VisualWish> wish = wishOf(options);
  const VisualChoice choice = chooseVisual(server, wish, options.colormap);
  ServerColormap::Settings settings{.owner = options.colormap,
                                    .dither = !options.nearest,
                                    .shades = options.picture.table.shades,
                                    .severalHues = planOf(scene, options.picture) != ColorPlan::OneHue};
  const auto tell = [](const std::string& what) {
    if (!what.empty()) std::cerr << "xnewell: " << what << '\n';
  };
  try {
    ServerColormap colormap{display, choice, settings};
    tell(colormap.shortfall());
    return colormap;
  } catch (const NoColormapError& e) {
    const VisualInfo& standard = server.defaultVisual();
    if (options.colormap == MapOwner::Shared || (wish && choice.visual.name() != standard.name())) throw;
    settings.owner = MapOwner::Shared;
    ServerColormap colormap{display, chooseVisual(server, {}, MapOwner::Shared), settings};
    tell("the X server has no room for another colormap (" + std::string{e.what()} + "); using " +
         colormap.account());
    return colormap;
  }
}

}  // namespace

std::optional<VisualWish> wishOf(const Options& options) {
  if (options.visual.empty()) return std::nullopt;
  return parseVisualWish(options.visual);
}

Server::Server(const Options& options, const Scene& scene)
    : display{openDisplay()}, colormap{openColormap(display.get(), options, scene)} {}

void bringUpToDate(Server& server, Canvas& canvas, Workbench& bench, const std::function<void()>& update) {
  const Workbench::Stale stale = bench.stale();
  if (stale == Workbench::Stale::Nothing) return;
  update();
  const CellPlan plan = bench.plan();
  const Palette palette = server.colorsOf(bench.picture(), bench.palette());
  const bool otherPixels = server.colormap.lookUp(palette, plan);
  if (stale == Workbench::Stale::Colors && !otherPixels) {
    server.colormap.store(palette, plan);
    XFlush(server.display.get());
    return;
  }
  const Rect all{0, 0, canvas.width(), canvas.height()};
  canvas.upload(bench.image(), all);
  if (bench.serverFills()) {
    fillPolygons(server.display.get(), canvas, bench.picture(), bench.pictureArea(), bench.ground());
    for (const Rect& part : bench.overPicture()) canvas.upload(bench.image(), part);
  }
  const ServerGrab grab{server.display.get()};
  server.colormap.store(palette, plan);
  canvas.expose(all);
}

}  // namespace xnewell
