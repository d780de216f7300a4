#pragma once

#include <optional>

#include "x11/app/workbench.h"
#include "x11/options/options.h"

// What includes Xlib comes last: its macros (None, Above) are words of ours.
#include "x11/server/canvas.h"
#include "x11/server/colormap.h"
#include "x11/server/display.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// A connection with its visual and colormap chosen: what every window needs.
struct Server {
  /// On $DISPLAY, for the scene's colours. What the user gets less than asked for is told on standard error.
  /// @throws X11Error
  Server(const Options& options, const Scene& scene);

  [[nodiscard]] Workbench::Server forBench() {
    return {[this](TableKind table) { return colormap.plan(table); }, colormap.unneeded(),
            [this] { return colormap.account(); }, gray(),
            [this](bool severalHues) {
              colormap.reconsider(severalHues);
              return colormap.mostShades();
            }};
  }
  /// With a ramp of as many shades as there are cells for.
  [[nodiscard]] PictureSettings fitted(PictureSettings settings) const {
    settings.table.shades = std::min(settings.table.shades, colormap.mostShades());
    return settings;
  }
  [[nodiscard]] Setup setupOf(const Options& options) const {
    return {.picture = fitted(options.picture), .fill = options.fill, .show = options.show};
  }

  [[nodiscard]] bool gray() const { return colormap.visual().gray(); }
  /// What to store for a picture's colours.
  [[nodiscard]] Palette colorsOf(const Picture& picture, const Palette& palette) const {
    return gray() ? forGrayScreen(palette, picture) : palette;
  }

  OwnedDisplay display;
  ServerColormap colormap;
};

/// The visual that the options insist on.
[[nodiscard]] std::optional<VisualWish> wishOf(const Options& options);

/// Brings the window up to date, if anything is late, and the bench by `update`. Colours alone are stored and
/// nothing is drawn. New indices go into the picture behind the window first; then cells and indices change
/// together, and no other client sees one without the other.
void bringUpToDate(Server& server, Canvas& canvas, Workbench& bench, const std::function<void()>& update);

}  // namespace xnewell
