#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shading/picture.h"
#include "x11/colors_bench.h"
#include "x11/controls.h"
#include "x11/key.h"
#include "x11/panel.h"

/// The window without a server: what keys and the mouse do to the setup, and the index image and palette that
/// show it. The event loop (viewer.h) and the pictures of the whole window use the same one.

class Workbench {
 public:
  /// Cell plan of a table on the server at hand, and the colours of cells that nobody needs.
  struct Server {
    std::function<CellPlan(TableKind)> plan = [](TableKind t) { return CellPlan{t}; };
    Palette unneeded{};
    std::string visual;  ///< for the status line
    bool gray = false;   ///< shows grays only
  };
  Workbench(Scene scene, const Setup& setup, Server server);

  void resize(int width, int height);
  void press(const Key& key);
  /// A letter let go, where that means something.
  void release(char letter);
  /// The button pressed: whether what follows until it is let go, and settle(), is a drag.
  [[nodiscard]] bool grab(int x, int y);
  /// The mouse dragged, in pixels: turns the scene with it, or bends the curve of the colours stored.
  void drag(int dx, int dy);
  /// The mouse moved with no button pressed.
  void hover(int x, int y);
  /// > 1 comes nearer.
  void zoom(double factor);
  /// A sentence for the status line until the next key.
  void notify(std::string notice) {
    state_.notice = std::move(notice);
    repaint_ = true;
  }

  [[nodiscard]] bool quitAsked() const { return quit_; }
  [[nodiscard]] const Setup& setup() const { return state_.setup; }

  /// Whether colours move by themselves: then tick() is to be called every so often.
  [[nodiscard]] bool moving() const { return showsColors() && colors_.moving(); }
  void tick() { colors_.tick(); }

  /// What the last changes ask for, least first: nothing; other colours in the same cells; new indices. In
  /// the view of the colours words about them are indices, and follow the colours in a second update().
  enum class Stale { Nothing, Colors, Everything };
  [[nodiscard]] Stale stale() const;
  /// Brings image and palette up to date. A setup that cannot be drawn is undone and told. While something
  /// is dragged the samples that show a wrong face are not counted: settle() asks for that afterwards.
  void update(bool dragging = false);
  void settle();

  [[nodiscard]] const IndexImage& image() const { return image_; }
  [[nodiscard]] const Palette& palette() const { return palette_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const Picture& picture() const { return picture_; }
  /// Whether an X server is to fill the polygons at layout().picture.
  [[nodiscard]] bool serverFills() const { return setup().fill == Fill::XFillPolygon && !showsColors(); }
  /// Parts of image() that lie over the picture.
  [[nodiscard]] std::vector<Rect> overPicture() const { return drawnOverPicture(layout_, state_.help); }
  /// Where the tool's colours are in palette(): by the table that picks the indices.
  [[nodiscard]] CellPlan plan() const { return server_.plan(painted().picture.table.kind); }
  /// The picture's ground in image().
  [[nodiscard]] std::uint8_t ground() const { return plan()[Cell::Well]; }

 private:
  void change(char control, const std::function<void(Setup&)>& edit);
  void pressLetter(char letter);
  void choose(const ChoiceRow& row);
  void pressArrow(int along, int up);
  void pressEnd(bool high);
  void nextFocus(int direction);
  void show(WindowView view);
  void pressInColors(const Key& key);
  void drawFrame(bool dragging);
  void drawPicture(bool dragging);
  /// Of the picture as it was made.
  void makePalette();
  [[nodiscard]] Palette plainPalette() const;
  [[nodiscard]] std::string exactnessText();
  /// Where there is no room for it the picture is shown instead.
  [[nodiscard]] bool showsColors() const { return state_.view == WindowView::Colors && layout_.roomy; }
  /// The setup by which indices are picked.
  [[nodiscard]] Setup painted() const { return showsColors() ? colors_.painted(state_.setup) : state_.setup; }
  /// That picture at the size the window has for it, which is nothing to undo.
  [[nodiscard]] PictureSettings sized() const;
  /// As the setup has it now, which may be newer than the picture.
  [[nodiscard]] Camera camera() const;

  Picture picture_;
  glm::dvec3 centre_{0};  ///< of the scene: where a point light is seen from
  Server server_;
  PanelState state_;
  Layout layout_;
  IndexImage image_, pictureImage_;
  Palette palette_{};
  ColorsBench colors_;
  Setup drawn_, drawnIndices_;  ///< what palette_ shows, and what image_ was painted by
  PaletteEffects stored_;       ///< in palette_
  bool any_ = false, repaint_ = true;
  bool counted_ = true;  ///< whether the caption knows how exact the picture is
  std::vector<Setup> undo_, redo_;
  char lastChanged_ = 0;  ///< control of the newest undo step: a run of its changes is one step
  bool quit_ = false;
};
