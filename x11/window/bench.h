#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture.h"
#include "shading/trade/trade_request.h"
#include "x11/views/color_strip.h"
#include "x11/window/controls.h"
#include "x11/window/key.h"
#include "x11/window/layout.h"

namespace xnewell {

/// One view of the window, without a server: what keys and the pointer do to it, and how its body is drawn.
/// The workbench (workbench.h) has one bench for each view. It makes the scene's picture at the size that the
/// view asks for, and it draws the bands around the body.

/// A question whose answer the user types on a line under the body. Return accepts the answer, Esc cancels.
struct Question {
  std::string asks;                      ///< "go to step"
  std::string text = {};                 ///< the text at first
  bool fresh = true;                     ///< true if the first letter typed replaces the text
  std::vector<std::string> offers = {};  ///< the texts that Up and Down put on the line
  /// Takes the text. Returns "", or a sentence that says what is wrong; then the user can correct the text.
  std::function<std::string(const std::string&)> take;
};

/// What a view may ask of the window that holds it.
class Host {
 public:
  virtual ~Host() = default;
  [[nodiscard]] virtual const Setup& setup() const = 0;
  /// The setup that `reset` restores.
  [[nodiscard]] virtual const Setup& defaults() const = 0;
  /// open() shows another scene with a setup of its own, and undo starts afresh. close() brings back what was
  /// there before the first open().
  virtual void open(Scene scene, const Setup& setup) = 0;
  virtual void close() = 0;
  virtual void switchTo(WindowView view) = 0;
  /// Shows the setup in view 5, beside B.
  virtual void compare(const Setup& B) = 0;
  /// From now on the window chooses its short cuts by itself, the cheapest that stay within this limit; or it
  /// no longer does.
  virtual void keepWithin(std::optional<AccuracyLimit> limit) = 0;
  [[nodiscard]] virtual std::optional<AccuracyLimit> keptWithin() const = 0;
  virtual void ask(Question question) = 0;
  /// Shows a warning, one sentence, in the status line until the next key or click.
  virtual void notify(std::string notice) = 0;
  /// Shows plain news there until the next key.
  virtual void tell(std::string news) = 0;
  /// Changes the setup in a way that can be undone. Changes in a row with the same `control` are undone as
  /// one.
  virtual void change(char control, const std::function<void(Setup&)>& edit) = 0;
  /// Presses a letter that works in all views, such as undo.
  virtual void pressLetter(char letter) = 0;
};

/// Milliseconds. During a drag, a picture that takes longer is drawn with coarser settings.
inline constexpr double kFluid = 40;

/// What a view is given to draw.
struct Desk {
  const Picture& picture;  ///< painted if Bench::wantsImage()
  const CellPlan& plan;
  const Palette& palette;  ///< without effects
  const CellUse& use;      ///< the cells that the picture's image uses; empty if the view wants no image
  const Setup& setup;      ///< the setup; Bench::painted() of it made the picture
  const Layout& layout;
  bool fresh = true;      ///< true if this picture is not the one that was shown last
  bool dragging = false;  ///< true during a drag: slow work may wait, because the next frame follows at once
  bool coarse = false;  ///< true if the picture was made with coarser settings than the setup's, to save time
  bool gray = false;    ///< true if the screen shows only grays
};

/// The colours that a view chose for the cells, and words for them if the picture's words do not fit.
struct OwnColors {
  Palette palette;
  std::optional<SceneCellWords> words;
};

/// An entry of the last line: keys, and what they do. "<" ">" "^" "v" stand for the arrow keys.
struct Legend {
  std::vector<std::string_view> keys;
  std::string_view does;
};

/// A line in the list of all keys: some keys, and what they do.
struct HelpLine {
  std::string_view keys, does;
};

class Bench {
 public:
  virtual ~Bench() = default;

  /// Handles a key. Returns false if it is not a key of this view. Then the workbench handles the keys in
  /// sharedKeys() and those that all views have: views, undo, help, quit.
  [[nodiscard]] virtual bool press(const Key& key, const Setup& setup) = 0;
  /// The letters of the controls that this view shares.
  [[nodiscard]] virtual std::string_view sharedKeys() const = 0;
  virtual void release(char) {}
  /// The pointer, in pixels of the window. hover(): it moved with no button pressed. grab(): the button was
  /// pressed; returns true if this begins a drag. dragTo(): it moved during the drag. drop(): the drag ended.
  virtual void hover(int, int) {}
  [[nodiscard]] virtual bool grab(int, int) { return false; }
  virtual void dragTo(int, int) {}
  virtual void drop() {}
  /// enter() is called when the view appears, leave() when it disappears. leave() undoes whatever must not
  /// outlast the view.
  virtual void enter() {}
  virtual void leave() {}
  /// True if something moves by itself. Then tick() must be called at regular intervals.
  [[nodiscard]] virtual bool moving() const { return false; }
  virtual void tick() {}

  /// The place of the scene's picture. The workbench makes the picture in this size; the view decides what to
  /// draw there.
  [[nodiscard]] virtual Rect picture(const Layout& at) const = 0;
  /// True if Desk::picture must be painted. If false, the picture is never made with coarser settings.
  [[nodiscard]] virtual bool wantsImage() const { return true; }
  /// The setup that the picture is painted with. It picks the indices.
  [[nodiscard]] virtual Setup painted(const Setup& setup) const { return setup; }
  /// Effects on the colours that are stored for the painted picture.
  [[nodiscard]] virtual PaletteEffects stored(const Setup&) const { return {}; }
  /// True if the body must be drawn again for a reason other than a change of the setup.
  [[nodiscard]] virtual bool late(const Setup& setup) const = 0;
  /// Draws the body and the picture. The body is layout.body and the margins around it; `image` is filled
  /// with paper there.
  virtual void draw(IndexImage& image, const Desk& desk) = 0;

  // The functions below describe the last drawing.

  /// The first status line, and the softer text after it.
  [[nodiscard]] virtual std::string status() const = 0;
  [[nodiscard]] virtual std::string aside() const { return {}; }
  [[nodiscard]] virtual std::vector<Legend> legend() const = 0;
  /// This view's own keys, for the list that `?` shows.
  [[nodiscard]] virtual std::vector<HelpLine> help() const { return {}; }
  /// The cells that the strip counts; null for those of the scene's picture.
  [[nodiscard]] virtual const CellUse* use() const { return nullptr; }
  /// True if Desk::use must count polygons too.
  [[nodiscard]] virtual bool countsPolygons() const { return false; }
  /// Colours that the view chose for the cells when it drew; they change only with a new drawing. Null if the
  /// cells have the colours of the scene's picture.
  [[nodiscard]] virtual const OwnColors* colors() const { return nullptr; }
  /// The cell that the strip marks.
  [[nodiscard]] virtual std::optional<int> inspected() const { return std::nullopt; }
};

}  // namespace xnewell
