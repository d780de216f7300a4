#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shading/picture.h"
#include "x11/controls.h"
#include "x11/panel.h"

/// The window without a server: what keys and the mouse do to the setup, and the index image and palette that
/// show it. The event loop (viewer.h) and the pictures of the whole window use the same one.

/// A key as the workbench knows it: a Latin-1 letter or one of these.
enum class NamedKey { Letter, Left, Right, Up, Down, Home, End, Tab, Escape };
struct Key {
  NamedKey name = NamedKey::Letter;
  char letter = 0;
  bool shift = false;
};

class Workbench {
 public:
  /// Cell plan of a table on the server at hand, and the colours of cells that nobody needs.
  struct Server {
    std::function<CellPlan(TableKind)> plan = [](TableKind t) { return CellPlan{t}; };
    Palette unneeded{};
    std::string visual;  ///< for the status line
  };
  Workbench(Scene scene, const Setup& setup, Server server);

  void resize(int width, int height);
  void press(const Key& key);
  /// The mouse dragged over the picture, in pixels: turns the scene with it.
  void drag(int dx, int dy);
  /// > 1 comes nearer.
  void zoom(double factor);
  /// A sentence for the status line until the next key.
  void notify(std::string notice) {
    state_.notice = std::move(notice);
    repaint_ = true;
  }

  [[nodiscard]] bool quitAsked() const { return quit_; }
  [[nodiscard]] const Setup& setup() const { return state_.setup; }

  /// What the last changes ask for, least first: nothing; other colours in the same cells; new indices.
  enum class Stale { Nothing, Colors, Everything };
  [[nodiscard]] Stale stale() const;
  /// Brings image and palette up to date. A setup that cannot be drawn is undone and told. While something
  /// is dragged the samples that show a wrong face are not counted: settle() asks for that afterwards.
  void update(bool dragging = false);
  void settle() { repaint_ = repaint_ || !counted_; }

  [[nodiscard]] const IndexImage& image() const { return image_; }
  [[nodiscard]] const Palette& palette() const { return palette_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const Picture& picture() const { return picture_; }
  /// Parts of image() that lie over the picture.
  [[nodiscard]] std::vector<Rect> overPicture() const { return drawnOverPicture(layout_, state_.help); }
  /// The picture's ground in image().
  [[nodiscard]] std::uint8_t ground() const { return server_.plan(setup().picture.table.kind)[Cell::Well]; }

 private:
  void change(char control, const std::function<void(Setup&)>& edit);
  void pressLetter(char letter);
  void choose(const ChoiceRow& row);
  void pressArrow(int along, int up);
  void pressEnd(bool high);
  void nextFocus(int direction);
  void drawFrame(bool dragging);
  [[nodiscard]] std::string exactnessText();
  /// The setup's picture at the size the window has for it, which is nothing to undo.
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
  Setup drawn_;  ///< what image_ shows
  bool any_ = false, repaint_ = true;
  bool counted_ = true;  ///< whether the caption knows how exact the picture is
  std::vector<Setup> undo_, redo_;
  char lastChanged_ = 0;  ///< control of the newest undo step: a run of its changes is one step
  bool quit_ = false;
};
