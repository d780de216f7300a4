#pragma once

#include <array>
#include <bit>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/server/display.h"
#include "x11/visual/emulation.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// Cells of a map that others use too (`--colormap shared`), or of a map that is too small for the whole
/// table. We use only what nobody else can change: cells of our own, and read-only cells, which cannot change
/// as long as some program holds them, as we do. So it does not matter what other programs do to the map.
class SharedCells {
 public:
  /// Takes up to `shades` cells for a ramp, and cells for those interface colours that the map does not have
  /// yet. The interface gets at most a quarter of the free cells, so that few cells still make a picture. An
  /// interface colour without a cell is shown by the nearest colour there is, so those that would suffer most
  /// come first: black and white, which the map has anyway; then the grays between them; then the colours
  /// that carry a meaning; last those that hardly differ from black or white. A ramp of one shade is useless:
  /// its cell is given back. If `shades` is 0, we take only black and white.
  /// We leave kLeft cells to programs that start later, or a quarter if fewer than 4 kLeft were free. Of a
  /// map that is `ours`, we leave none. All other programs wait during this. So if two programs start
  /// together, they share the cells and neither gets none.
  SharedCells(Display* display, Colormap map, const VisualInfo& visual, int shades, bool ours);
  static constexpr std::size_t kLeft = 16;
  ~SharedCells();
  SharedCells(const SharedCells&) = delete;
  SharedCells& operator=(const SharedCells&) = delete;

  /// The cells that we may store into: the pixel values of shade 0, 1, ...
  [[nodiscard]] const std::vector<unsigned long>& ramp() const { return ramp_; }
  /// Gives all cells of the ramp back, for a caller that can show more without them. held() still returns the
  /// colours that it found before.
  void giveRampBack();
  /// The cell that shows an interface colour exactly, if there is one.
  [[nodiscard]] std::optional<unsigned long> interfaceCell(Cell cell) const {
    return interface_[static_cast<int>(cell)];
  }
  /// All read-only colours of the map; at least black and white. We take hold of each, with one request each.
  [[nodiscard]] std::vector<OfferedColor> held();
  /// The levels that each channel of a visual with channels can have. These are even levels, as far as cells
  /// are free or others show the same level, and levels that others show; at least 0 and full. Each costs one
  /// request.
  [[nodiscard]] std::array<std::vector<OfferedLevel>, 3> levels();

 private:
  /// Takes the read-only cell with that colour: one that the map has, or a new one if a cell is free.
  std::optional<unsigned long> take(Rgb16 color);

  Display* display_;
  Colormap map_;
  VisualInfo visual_;
  std::vector<unsigned long> ramp_;
  std::array<std::optional<unsigned long>, kCells> interface_{};
  std::vector<OfferedColor> held_;
  std::vector<unsigned long> taken_;  ///< the read-only cells, each listed as often as we took it
};

/// The picture's 256 colours on the server. An index either has a cell of ours, into which its colour is
/// stored, or it is emulated: by the nearest colour that the server has, or by a mixture of several. The
/// visual and `--colormap` decide which:
///   private map of 256 cells    each index i has its own cell. PseudoColor, GrayScale: its pixel value is i;
///                               DirectColor: its pixel value is (i, i, i)
///   shared map                  the ramp's indices have cells as far as cells were free; the others are
///                               emulated. If the map's own colours show more than so short a ramp, all are
///   private map of fewer cells  the same. But a private DirectColor map is filled with even levels once and
///                               then emulated; of a shared one we take as many levels as we can get
///   map that cannot be written  all are emulated
/// The cells are taken when the object is made. Only reconsider() changes them.
class ServerColormap {
 public:
  struct Settings {
    MapOwner owner = MapOwner::Private;
    bool dither = true;        ///< if false, each emulated index shows one colour, even if that is not the
                               ///< one wanted
    int shades = kMaxShades;   ///< of the ramp; we ask a shared map for no more
    bool severalHues = false;  ///< true if several hues divide the shades
  };
  /// The Display must outlive this object. If the default visual is 8 bits deep too, a private map starts as
  /// a copy of the default map, so cells that we do not need look as they do everywhere else. Otherwise it
  /// starts black. A shared map needs the default visual.
  /// @throws NoColormapError if there is no room for a map; X11Error if the server refuses anything else
  ServerColormap(Display* display, const VisualChoice& choice, const Settings& settings);
  ServerColormap(Display* display, const VisualChoice& choice)
      : ServerColormap{display, choice, Settings{}} {}

  [[nodiscard]] Colormap id() const { return own_.get() ? own_.get() : DefaultColormap(display_, screen_); }
  [[nodiscard]] const VisualInfo& visual() const { return visual_; }
  [[nodiscard]] Visual* xVisual() const { return xVisual_; }

  /// True if stored colours show at once, at least those of the ramp. If false, the picture must be drawn
  /// again.
  [[nodiscard]] bool live() const { return has_ != Own::Nothing; }
  /// True if index i is shown by pixel value i.
  [[nodiscard]] bool identity() const { return has_ == Own::Everything && !visual_.hasChannels(); }
  /// Call this when the scene gets several hues, or one hue again. If cells are shared, they are taken anew;
  /// the colours must then be stored, and the picture presented, again.
  void reconsider(bool severalHues);
  /// The longest ramp in which each shade has its own cell; 240 if no shade has one, because then all are
  /// emulated.
  [[nodiscard]] int mostShades() const;
  /// What we use, such as "PseudoColor 8, shared map, 143 of 240 shades".
  [[nodiscard]] std::string account() const;
  /// A sentence about what the user asked for and does not get; "" if nothing is missing.
  [[nodiscard]] std::string shortfall() const;

  /// The default map's colours when this object was made; black if they were not copied. makePalette() puts
  /// them into cells that it does not need.
  [[nodiscard]] const Palette& unneeded() const { return unneeded_; }
  /// The plan that keeps black and white at this server's pixel values. If pixel values are not indices, or
  /// the default map is not 8 bits deep, the server's pixel values mean nothing here, and the plan is the
  /// usual one.
  [[nodiscard]] CellPlan plan(TableKind table) const;

  /// Looks up the pixel values that show `palette`. The sixteen cells of `plan` are never dithered, because
  /// text must be legible. Returns true if the pixel values of some index changed: the index image must then
  /// be presented again. It draws nothing and stores nothing.
  bool lookUp(const Palette& palette, const CellPlan& plan = CellPlan{});
  /// Calls lookUp(), then stores the cells that changed since the last store, with one XStoreColors; if none
  /// changed, it sends nothing. The request leaves with the next flush, so colours and cells that change
  /// together arrive together.
  bool store(const Palette& palette, const CellPlan& plan = CellPlan{});

  /// The pixel values of the indices since the last lookUp().
  [[nodiscard]] const PixelTable& table() const { return table_; }
  /// One pixel value for each index: its cell's, or that of the nearest colour.
  [[nodiscard]] const std::array<unsigned long, 256>& pixels() const { return table_.pixels(); }
  [[nodiscard]] unsigned long pixel(std::uint8_t index) const { return pixels()[index]; }
  /// The colours that those pixels show, read from the server (a round trip).
  [[nodiscard]] Palette shown() const;

  /// True if the screen uses this map now.
  [[nodiscard]] bool installed() const;
  /// Installs our map if no window manager runs; ICCCM §4.1.8 leaves it to the window manager otherwise. Call
  /// this when the window is mapped, entered or focused.
  void installUnlessManaged();

 private:
  enum class Own { Nothing, Ramp, Everything };  ///< which indices have a cell of ours
  void useEveryCell();
  void takeShades();
  void offerFixedColors();
  /// How far from a picture's colours its pixels are on average, in 8-bit values: as mixtures of the colours
  /// that the shared map has, and with the ramp. Measured for this map. Nothing where it is clear that a ramp
  /// shows more.
  struct Misses {
    double mixing = 0, ramp = 0;
  };
  [[nodiscard]] std::optional<Misses> missesOfMap() const;
  /// Says what is done with the colours of a shared map that has too few cells.
  [[nodiscard]] std::string instead() const;
  void fillEvenly();  ///< fills a DirectColor map that has fewer than 256 levels per channel
  /// The pixel value of the cell of ours that holds an index's colour; no value if the index has no such
  /// cell.
  using OwnCells = std::array<std::optional<unsigned long>, 256>;
  [[nodiscard]] OwnCells ownCells(const CellPlan& plan) const;
  /// The colours that can stand for the other indices while `palette` is stored.
  [[nodiscard]] OfferedColors offered(const Palette& palette, const OwnCells& own) const;
  /// What shows the interface colours that have no cell of their own. It is computed when first needed,
  /// because most maps have cells for all of them. It does not change.
  [[nodiscard]] const ToolColors& toolColors();
  /// The colour as this visual can show it.
  [[nodiscard]] Rgb16 seen(Rgb16 color) const { return visual_.gray() ? grayOf(color) : color; }

  Display* display_;
  int screen_;
  VisualInfo visual_;
  Visual* xVisual_;
  Settings settings_;
  Own has_ = Own::Nothing;
  int found_ = 0;                        ///< shades that the map had cells for, even if we gave them back
  std::optional<Misses> misses_;         ///< of a map with few free cells
  OwnedColormap own_;                    ///< empty if we use the default map
  std::unique_ptr<SharedCells> shared_;  ///< set if cells were taken one by one, even if there were none for
                                         ///< the ramp
  std::optional<OfferedColors> fixed_;   ///< set if the map's colours do not change
  std::optional<ToolColors> tool_;
  Palette unneeded_{};
  struct LookedUp {
    Palette palette;
    CellPlan plan;
    bool operator==(const LookedUp&) const = default;
  };
  std::optional<LookedUp> lookedUp_;
  PixelTable table_;
  /// What the cell of each index holds. It is empty before the first store, because the contents of a new map
  /// are undefined.
  struct Stored {
    unsigned long pixel;
    Rgb16 color;
    bool operator==(const Stored&) const = default;
  };
  std::array<std::optional<Stored>, 256> stored_;
};

/// Tells which colours pixel values show through a colormap, as the server says.
class PixelColors {
 public:
  /// Takes a round trip. @throws X11Error if the server does not answer
  PixelColors(Display* display, Colormap map, const VisualInfo& visual);
  [[nodiscard]] Rgb16 operator()(unsigned long pixel) const {
    return {cells_[field(pixel, masks_.red)].r, cells_[field(pixel, masks_.green)].g,
            cells_[field(pixel, masks_.blue)].b};
  }

 private:
  static std::size_t field(unsigned long pixel, unsigned long mask) {
    return (pixel & mask) >> std::countr_zero(mask);
  }
  ChannelMasks masks_;  ///< for a visual without channels, each mask has all bits
  std::vector<Rgb16> cells_;
};

/// True if a window manager runs on the default screen. Every window manager must select SubstructureRedirect
/// on the root window, and only one client at a time can. The root's attributes show this in one round trip,
/// even for managers too old for the WM_S0 selection, and we need not try to become one ourselves.
[[nodiscard]] bool windowManagerRuns(Display* display);

}  // namespace xnewell
