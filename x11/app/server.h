#pragma once

#include <mutex>
#include <optional>

#include "x11/app/workbench.h"
#include "x11/options/options.h"

// Headers that include Xlib come last: our own code uses the words that its macros (None, Above) define.
#include "x11/server/canvas.h"
#include "x11/server/colormap.h"
#include "x11/server/display.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// A connection to a server, with its visual and colormap chosen: what every window needs.
struct Server {
  /// Connects to $DISPLAY and prepares the colours of the scene. What the user asked for and does not get is
  /// printed on standard error.
  /// @throws X11Error
  Server(const Options& options, const Scene& scene);

  [[nodiscard]] Workbench::Server forBench() {
    return {[this](TableKind table) { return colormap.plan(table); },
            colormap.unneeded(),
            [this] { return colormap.account(); },
            gray(),
            colormap.visual().shownBits(),
            [this](bool severalHues) {
              const std::scoped_lock alone{turn};
              colormap.reconsider(severalHues);
              return colormap.mostShades();
            }};
  }
  /// The settings, with the ramp shortened if there are not enough cells for its shades.
  [[nodiscard]] PictureSettings fitted(PictureSettings settings) const {
    settings.table.shades = std::min(settings.table.shades, colormap.mostShades());
    return settings;
  }
  [[nodiscard]] Setup setupOf(const Options& options) const {
    Setup setup = xnewell::setupOf(options);
    setup.picture = fitted(setup.picture);
    return setup;
  }

  [[nodiscard]] bool gray() const { return colormap.visual().gray(); }
  /// The colours to store for a picture: on a gray screen, their grays.
  [[nodiscard]] Palette colorsOf(const Picture& picture, const Palette& palette) const {
    return gray() ? forGrayScreen(palette, picture) : palette;
  }

  OwnedDisplay display;
  ServerColormap colormap;
  /// While work goes on beside the thread that has the window (long_work.h), both take turns: the work asks
  /// for cells when it opens a scene, and the window says that it is busy.
  std::mutex turn;
};

/// The visual that --visual asks for; no value without --visual.
[[nodiscard]] std::optional<VisualWish> wishOf(const Options& options);

/// Brings the window up to date if anything has changed. First it calls `update`, which must bring the bench
/// up to date. If only colours changed, it stores them and draws nothing. Otherwise the new indices go into
/// the pixmap behind the window first. Then the cells and the window change together, and no other client
/// sees one without the other.
void bringUpToDate(Server& server, Canvas& canvas, Workbench& bench, const std::function<void()>& update);

}  // namespace xnewell
