#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture.h"
#include "x11/views/color_strip.h"
#include "x11/window/controls.h"
#include "x11/window/key.h"
#include "x11/window/layout.h"

namespace xnewell {

/// One of the window's views, without a server: what keys and pointer do to it, and how its body is drawn.
/// The workbench (workbench.h) has one of each, makes the scene's picture at the size that the view asks
/// for, and draws the bands around it.

/// A line that is typed under the body; Return takes it, Esc leaves it.
struct Question {
  std::string asks;                      ///< "go to step"
  std::string text = {};                 ///< what stands there at first
  bool fresh = true;                     ///< the first letter replaces the text
  std::vector<std::string> offers = {};  ///< what up and down put there
  /// What is wrong with the text, as a sentence, or "" if it was taken. What is wrong can be mended.
  std::function<std::string(const std::string&)> take;
};

/// What a view may ask of the window around it.
class Host {
 public:
  virtual ~Host() = default;
  [[nodiscard]] virtual const Setup& setup() const = 0;
  /// What it was at first.
  [[nodiscard]] virtual const Setup& defaults() const = 0;
  /// Another scene and how it is set up, for as long as until close(): then what was there before the first
  /// of them comes back. Undo begins anew.
  virtual void open(Scene scene, const Setup& setup) = 0;
  virtual void close() = 0;
  virtual void switchTo(WindowView view) = 0;
  virtual void ask(Question question) = 0;
  /// A sentence for the status line until the next key.
  virtual void notify(std::string notice) = 0;
  /// The same for plain news.
  virtual void tell(std::string news) = 0;
  /// A change of the setup that can be undone; several in a row with one `control` are one.
  virtual void change(char control, const std::function<void(Setup&)>& edit) = 0;
  /// A letter that all views have: undo and the like.
  virtual void pressLetter(char letter) = 0;
};

/// Milliseconds. While something is dragged, a picture that takes longer is made more coarsely.
inline constexpr double kFluid = 40;

/// What a view draws.
struct Desk {
  const Picture& picture;  ///< painted, if Bench::wantsImage()
  const CellPlan& plan;
  const Palette& palette;  ///< without effects
  const CellUse& use;      ///< of the image
  const Setup& setup;      ///< that the picture was made by
  const Layout& layout;
  bool fresh = true;      ///< the picture is not the one that was shown last
  bool dragging = false;  ///< more is to follow at once: what takes long may wait
  bool coarse = false;    ///< the picture is not made as the setup says, but sooner
  bool gray = false;      ///< the screen shows grays only
};

/// The colours of the cells as a view chose them, and in words where they are not the picture's.
struct OwnColors {
  Palette palette;
  std::optional<SceneCellWords> words;
};

/// A word in the last line: the keys, "<" ">" "^" "v" for arrows, and what they do.
struct Legend {
  std::vector<std::string_view> keys;
  std::string_view does;
};

/// A line under all keys: what they are, what they do.
struct HelpLine {
  std::string_view keys, does;
};

class Bench {
 public:
  virtual ~Bench() = default;

  /// Keys of its own; false: not one of them, and the workbench does what it does in any view, if it is one
  /// of sharedKeys() or one that all views have (views, undo, help, quit).
  [[nodiscard]] virtual bool press(const Key& key, const Setup& setup) = 0;
  /// Letters of the controls that this view has too.
  [[nodiscard]] virtual std::string_view sharedKeys() const = 0;
  virtual void release(char) {}
  /// The pointer, in pixels of the window: moved with no button pressed; pressed: whether what follows until
  /// it is let go is a drag; then moved, and let go.
  virtual void hover(int, int) {}
  [[nodiscard]] virtual bool grab(int, int) { return false; }
  virtual void dragTo(int, int) {}
  virtual void drop() {}
  /// The view is shown from now on, or no longer: what is undone on leaving is undone.
  virtual void enter() {}
  virtual void leave() {}
  /// Whether it moves by itself: then tick() is to be called every so often.
  [[nodiscard]] virtual bool moving() const { return false; }
  virtual void tick() {}

  /// Where the scene's picture goes: its size counts, what is drawn there is the view's.
  [[nodiscard]] virtual Rect picture(const Layout& at) const = 0;
  /// Whether Desk::picture is to be painted. If not, it is never made more coarsely.
  [[nodiscard]] virtual bool wantsImage() const { return true; }
  /// The setup by which indices are picked.
  [[nodiscard]] virtual Setup painted(const Setup& setup) const { return setup; }
  /// What is stored instead of the painted picture's colours.
  [[nodiscard]] virtual PaletteEffects stored(const Setup&) const { return {}; }
  /// Whether the body would be drawn otherwise than it was, the setup's own changes apart.
  [[nodiscard]] virtual bool late(const Setup& setup) const = 0;
  /// The body, layout.body of `image` and its margins, which are paper; and the picture.
  virtual void draw(IndexImage& image, const Desk& desk) = 0;

  // Of what was drawn last.

  /// The first line of the status, and what stands behind it, softer.
  [[nodiscard]] virtual std::string status() const = 0;
  [[nodiscard]] virtual std::string aside() const { return {}; }
  [[nodiscard]] virtual std::vector<Legend> legend() const = 0;
  /// Its own keys, under `?`.
  [[nodiscard]] virtual std::vector<HelpLine> help() const { return {}; }
  /// Cells that the strip counts; null: those of the scene's picture.
  [[nodiscard]] virtual const CellUse* use() const { return nullptr; }
  /// Whether Desk::use shall hold polygons too.
  [[nodiscard]] virtual bool countsPolygons() const { return false; }
  /// Of a view that chooses the colours of the cells when it draws, so that none change without it; null:
  /// they are the scene's picture's.
  [[nodiscard]] virtual const OwnColors* colors() const { return nullptr; }
  /// The cell that the strip marks.
  [[nodiscard]] virtual std::optional<int> inspected() const { return std::nullopt; }
};

}  // namespace xnewell
