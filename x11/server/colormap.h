#pragma once

#include <array>
#include <bit>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shading/color/palette.h"
#include "x11/server/display.h"
#include "x11/server/shared_cells.h"
#include "x11/visual/emulation.h"
#include "x11/visual/tool_colors.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// The picture's 256 colours on the server. Each index has either a cell of ours there, into which its colour
/// is stored, or stands for the nearest of the colours that the server has, or several mixed. What the visual
/// and
/// `--colormap` give:
///   private map of 256 cells    PseudoColor, GrayScale: every index its own cell, pixel value = index;
///                               DirectColor: through pixel values (i, i, i)
///   shared map                  the ramp's indices as far as cells were free, the others emulated; or all
///                               emulated, where the map's own colours show more than so few shades
///   private map of fewer cells  the same, but DirectColor's is filled with even levels once, then emulated,
///                               and of a shared one so many levels are taken as are free
///   map that cannot be written  emulated
/// What cells there are is known when it is made, and changes with reconsider() alone.
class ServerColormap {
 public:
  struct Settings {
    MapOwner owner = MapOwner::Private;
    bool dither = true;        ///< else every index is one colour, also where that is not the one wanted
    int shades = kMaxShades;   ///< of the ramp: a shared map is asked for no more
    bool severalHues = false;  ///< the shades are divided among them
  };
  /// The Display must outlive it. Where the default visual is 8 bits deep too, a private map starts as a copy
  /// of the default one, so that cells we do not need look as they do everywhere else; elsewhere it starts
  /// black. A shared map needs the default visual.
  /// @throws NoColormapError; X11Error if the server refuses anything else
  ServerColormap(Display* display, const VisualChoice& choice, const Settings& settings);
  ServerColormap(Display* display, const VisualChoice& choice)
      : ServerColormap{display, choice, Settings{}} {}

  [[nodiscard]] Colormap id() const { return own_.get() ? own_.get() : DefaultColormap(display_, screen_); }
  [[nodiscard]] const VisualInfo& visual() const { return visual_; }
  [[nodiscard]] Visual* xVisual() const { return xVisual_; }

  /// Do stored colours show by themselves, at least those of the ramp? Else the picture is drawn again.
  [[nodiscard]] bool live() const { return has_ != Own::Nothing; }
  /// Is index i shown by pixel value i?
  [[nodiscard]] bool identity() const { return has_ == Own::Everything && !visual_.hasChannels(); }
  /// For a scene with several hues, or with one again: where cells are shared they are taken anew. What is
  /// shown meanwhile is to be stored and presented again.
  void reconsider(bool severalHues);
  /// How many shades a ramp can have so that each gets its own cell; where none does, all are emulated.
  [[nodiscard]] int mostShades() const;
  /// "PseudoColor 8, shared map, 143 of 240 shades"
  [[nodiscard]] std::string account() const;
  /// What the user gets less than was asked for, in a sentence; "" for nothing.
  [[nodiscard]] std::string shortfall() const;

  /// The default map's colours at the start (black where it is not copied): what makePalette() puts into
  /// unneeded cells.
  [[nodiscard]] const Palette& unneeded() const { return unneeded_; }
  /// The plan that leaves black and white where this server has them. Where pixel values are not indices, or
  /// the default map's are not of 8 bits, its pixels mean nothing here, and the plan is the usual one.
  [[nodiscard]] CellPlan plan(TableKind table) const;

  /// Looks up the pixel values that show `palette`; the sixteen cells of `plan` are never dithered, for text
  /// must be read. Returns true if some index is now shown by others: the index image must be presented
  /// again. Draws and stores nothing.
  bool lookUp(const Palette& palette, const CellPlan& plan = CellPlan{});
  /// lookUp(), and stores: one XStoreColors with the cells that changed since the last store, and nothing at
  /// all if none did; it leaves with the next flush, so that colours and cells that change together arrive
  /// together.
  bool store(const Palette& palette, const CellPlan& plan = CellPlan{});

  /// How the indices are shown since the last lookUp().
  [[nodiscard]] const PixelTable& table() const { return table_; }
  /// One pixel value each, the nearest.
  [[nodiscard]] const std::array<unsigned long, 256>& pixels() const { return table_.pixels(); }
  [[nodiscard]] unsigned long pixel(std::uint8_t index) const { return pixels()[index]; }
  /// What those pixels show, as the server says (a round trip).
  [[nodiscard]] Palette shown() const;

  /// Is it the map that the screen uses now?
  [[nodiscard]] bool installed() const;
  /// ICCCM §4.1.8 leaves installing to the window manager. Where there is none we do it. To be called
  /// when the window is mapped, entered or focused.
  void installUnlessManaged();

 private:
  enum class Own { Nothing, Ramp, Everything };  ///< which indices have their own
  void useEveryCell();
  void takeShades();
  void offerFixedColors();
  /// Do the colours of the shared map come nearer to those of a picture than the ramp does?
  [[nodiscard]] bool mixingShowsMore() const;
  /// What is done with the colours of a shared map that has too few cells.
  [[nodiscard]] std::string instead() const;
  void fillEvenly();  ///< a DirectColor map of fewer than 256 levels a channel
  /// The pixel value of the cell of ours that holds an index's colour, where there is one.
  using OwnCells = std::array<std::optional<unsigned long>, 256>;
  [[nodiscard]] OwnCells ownCells(const CellPlan& plan) const;
  /// What is on offer for the other indices while `palette` is stored.
  [[nodiscard]] OfferedColors offered(const Palette& palette, const OwnCells& own) const;
  /// What shows the tool's colours where they have no cells of their own; asked for where needed, for most
  /// maps have cells for all, and does not change.
  [[nodiscard]] const ToolColors& toolColors();
  /// A colour as this visual can show it.
  [[nodiscard]] Rgb16 seen(Rgb16 color) const { return visual_.gray() ? grayOf(color) : color; }

  Display* display_;
  int screen_;
  VisualInfo visual_;
  Visual* xVisual_;
  Settings settings_;
  Own has_ = Own::Nothing;
  int found_ = 0;      ///< shades that the map had cells for, also where it was better to give them back
  OwnedColormap own_;  ///< empty: the default map serves
  std::unique_ptr<SharedCells> shared_;  ///< of Own::Ramp, and where a shared map had none
  std::optional<OfferedColors> fixed_;   ///< of a map that does not change
  std::optional<ToolColors> tool_;
  Palette unneeded_{};
  struct LookedUp {
    Palette palette;
    CellPlan plan;
    bool operator==(const LookedUp&) const = default;
  };
  std::optional<LookedUp> lookedUp_;
  PixelTable table_;
  /// What an index's cell holds; nothing before the first store, for a new map's contents are undefined.
  struct Stored {
    unsigned long pixel;
    Rgb16 color;
    bool operator==(const Stored&) const = default;
  };
  std::array<std::optional<Stored>, 256> stored_;
};

/// What pixel values show through a colormap, as the server says.
class PixelColors {
 public:
  /// A round trip. @throws X11Error if the server does not answer
  PixelColors(Display* display, Colormap map, const VisualInfo& visual);
  [[nodiscard]] Rgb16 operator()(unsigned long pixel) const {
    return {cells_[field(pixel, masks_.red)].r, cells_[field(pixel, masks_.green)].g,
            cells_[field(pixel, masks_.blue)].b};
  }

 private:
  static std::size_t field(unsigned long pixel, unsigned long mask) {
    return (pixel & mask) >> std::countr_zero(mask);
  }
  ChannelMasks masks_;  ///< of a visual without channels all bits for each
  std::vector<Rgb16> cells_;
};

/// Does a window manager run on the default screen? Asked by the one thing that every window manager must do
/// and only one client at a time can: select SubstructureRedirect on the root window. The root's attributes
/// tell it in one round trip, also of managers too old for the WM_S0 selection, and we need not try to become
/// one.
[[nodiscard]] bool windowManagerRuns(Display* display);

}  // namespace xnewell
