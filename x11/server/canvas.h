#pragma once

#include <map>
#include <memory>
#include <string>

#include "shading/color/index_image.h"
#include "shading/color/rgb_image.h"
#include "x11/drawing/rect.h"
#include "x11/server/colormap.h"
#include "x11/server/display.h"
#include "x11/server/transfer_image.h"

namespace xnewell {

/// A top-level window and the picture behind it: a pixmap of the same size that keeps what was presented, so
/// that uncovering the window asks nobody to draw. Sizes 1 x 1 to 8192 x 8192, also larger than the screen.
class Canvas {
 public:
  struct Settings {
    std::string title = "xnewell";
    int width = 1024, height = 768;
    int minWidth = 1, minHeight = 1;  ///< asked of the window manager
    bool sharedMemory = true;         ///< MIT-SHM where it works
  };

  /// Makes the window, not yet on the screen; the picture is all index 0. Display and colormap must outlive
  /// it.
  /// @throws X11Error if the server has no room for the picture.
  Canvas(Display* display, const ServerColormap& colormap, const Settings& settings);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// What window managers write over the window.
  void entitle(const std::string& title) const;
  void map() { XMapWindow(display_, window()); }
  [[nodiscard]] Window window() const { return window_.get(); }
  [[nodiscard]] int width() const { return size_.width; }
  [[nodiscard]] int height() const { return size_.height; }
  [[nodiscard]] bool sharedMemory() const { return transfer_->shared(); }
  /// Did the user press the close button?
  [[nodiscard]] bool isCloseRequest(const XEvent& event) const;

  /// Puts the part of `image` within `dirty` into the picture, not yet onto the window. What lies outside the
  /// image or the canvas is left out. Pixel values are those of the colormap's last lookUp().
  void upload(const IndexImage& image, const Rect& dirty);
  /// The same, and onto the window.
  void present(const IndexImage& image, const Rect& dirty);
  /// Copies `rect` of the picture to the window, as after an Expose event or after drawing into the picture.
  void expose(const Rect& rect);
  /// Gives the picture a new size (after ConfigureNotify); what fits is kept at the top left, new parts are
  /// index 0. Sets the fill of gc(). The window's own size is the user's and the window manager's
  /// business.
  /// @throws X11Error if the server has no room; the old picture is then kept.
  void resize(int width, int height);

  /// For drawing by the server: XFillPolygon into drawable(), gc() as setFill() left it, then expose().
  [[nodiscard]] Drawable drawable() const { return picture_.get(); }
  [[nodiscard]] GC gc() const { return gc_.get(); }
  /// What the server fills with gc() becomes the pixel values that upload() has for this index: one of them,
  /// or where it is dithered the tile, from the picture's upper left corner.
  void setFill(std::uint8_t index);

  /// The pixel values of `rect`, as the server has them. Precondition: rect is not empty and within the
  /// picture. @throws X11Error if the server cannot.
  [[nodiscard]] OwnedImage pixels(const Rect& rect) const;
  /// What they show, through the colormap, each value >> 8.
  [[nodiscard]] RgbImage readBack(const Rect& rect) const;

 private:
  Display* display_;
  const ServerColormap& colormap_;
  bool wantShm_;
  Rect size_;
  OwnedWindow window_;
  OwnedPixmap picture_;
  OwnedGC gc_;
  std::unique_ptr<TransferImage> transfer_;
  /// Tiles that the server has, and what they hold.
  struct ServerTile {
    Tile pixels;
    OwnedPixmap pixmap;
  };
  std::map<std::uint8_t, ServerTile> tiles_;
  Atom deleteWindow_ = 0, protocols_ = 0, netName_ = 0, utf8_ = 0;
};

}  // namespace xnewell
