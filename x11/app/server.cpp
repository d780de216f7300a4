#include "x11/app/server.h"

#include <algorithm>
#include <iostream>

#include "x11/server/fill_polygons.h"
#include "x11/server/read_visuals.h"
#include "x11/visual/x11_error.h"

namespace xnewell {

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
