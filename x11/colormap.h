#pragma once

#include <array>
#include <optional>

#include "shading/palette.h"
#include "x11/display.h"
#include "x11/visual.h"

/// The picture's 256 colours on the server. With PseudoColor a real, private colormap: its cells are the
/// palette's, and storing other colours changes what is shown without a drawing request. With TrueColor an
/// emulation: 256 pixel values, and the index image is presented again after a change.
/// Cells never run out: the map is private and all its 256 cells are ours.
class ServerColormap {
 public:
  /// The Display must outlive it. Where the default visual is 8 bits deep too, a private map starts as a copy
  /// of the default one, so that cells we do not need look as they do everywhere else; elsewhere it starts
  /// black.
  /// @throws X11Error if the server has no room for a colormap.
  ServerColormap(::Display* display, const VisualChoice& choice);

  [[nodiscard]] ::Colormap id() const { return own_.get() ? own_.get() : DefaultColormap(display_, screen_); }
  [[nodiscard]] const VisualInfo& visual() const { return visual_; }
  [[nodiscard]] ::Visual* xVisual() const { return xVisual_; }
  /// True: cells are stored on the server and pixel i is cell i. False: emulated.
  [[nodiscard]] bool real() const { return visual_.writable(); }

  /// The default map's colours at the start (black where emulated): what makePalette() puts into unneeded
  /// cells.
  [[nodiscard]] const Palette& unneeded() const { return unneeded_; }
  /// The plan that leaves black and white where this server has them. Where the default map is not one of
  /// 8 bits its pixels mean nothing here, and the plan is the usual one.
  [[nodiscard]] CellPlan plan(TableKind table) const;

  /// Makes `palette` the colours shown. Real: one XStoreColors with the cells that changed since the last
  /// store, and nothing at all if none did; it leaves with the next flush, so that colours and cells that
  /// change together arrive together. Emulated: sends nothing. Returns true if the index image must be
  /// presented again to show it.
  bool store(const Palette& palette);

  /// The pixel value of each index: what XSetForeground takes.
  [[nodiscard]] const std::array<unsigned long, 256>& pixels() const { return pixels_; }
  [[nodiscard]] unsigned long pixel(std::uint8_t index) const { return pixels_[index]; }
  /// The 256 colours as the server has them (a round trip), or the emulated ones as the screen shows them.
  [[nodiscard]] Palette shown() const;

  /// Is it the map that the screen uses now?
  [[nodiscard]] bool installed() const;
  /// ICCCM §4.1.8 leaves installing to the window manager. Where there is none we do it. To be called
  /// when the window is mapped, entered or focused.
  void installUnlessManaged();

 private:
  ::Display* display_;
  int screen_;
  VisualInfo visual_;
  ::Visual* xVisual_;
  unsigned long opaque_;  ///< bits set in every emulated pixel
  OwnedColormap own_;     ///< empty: the default map serves
  Palette unneeded_{};
  std::optional<Palette> stored_;  ///< what the cells hold; a new map's contents are undefined
  std::array<unsigned long, 256> pixels_{};
};

/// Does a window manager run on the default screen? Asked by the one thing that every window manager must do
/// and only one client at a time can: select SubstructureRedirect on the root window. The root's attributes
/// tell it in one round trip, also of managers too old for the WM_S0 selection, and we need not try to become
/// one.
[[nodiscard]] bool windowManagerRuns(::Display* display);
