#pragma once

#include <string>
#include <vector>

#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture.h"
#include "x11/views/colors_page.h"
#include "x11/window/host.h"
#include "x11/window/layout.h"
#include "x11/window/setting_controls.h"

namespace xnewell {

/// Milliseconds. During a drag, a picture that takes longer is drawn with coarser settings.
inline constexpr double kFluid = 40;

/// What a view is given to draw.
struct DrawContext {
  const Picture& picture;  ///< painted if WindowView::wantsImage()
  const CellPlan& plan;
  const Palette& palette;  ///< without effects
  const CellUse& use;      ///< the cells that the picture's image uses; empty if the view wants no image
  const Setup& setup;      ///< the setup; WindowView::painted() of it made the picture
  const Layout& layout;
  bool fresh = true;      ///< true if this picture is not the one that was shown last
  bool dragging = false;  ///< true during a drag: slow work may wait, because the next frame follows at once
  bool coarse = false;  ///< true if the picture was made with coarser settings than the setup's, to save time
  bool gray = false;    ///< true if the screen shows only grays
  int shownBits = 0;    ///< of each stored colour, as VisualInfo::shownBits(); 0 without a server
  std::string title = {};  ///< of the page of a lecture, or of the scene
  std::string few = {};    ///< the keys of the controls in a drawer that has few
};

/// The colours that a view chose for the cells, and words for them if the picture's words do not fit.
struct OwnColors {
  Palette palette;
  std::optional<SceneCellWords> words;
};

/// One view of the window, without a server: what keys and the pointer do to it, and how its body is drawn.
/// The workbench (workbench.h) has one bench for each view. It makes the scene's picture at the size that the
/// view asks for, and it draws the bands around the body.
///
/// A view says which controls and which keys it has at the moment. From these two lists come what the keys
/// and the pointer do, the window's last line, the list of all keys, and the manual's tables.
class WindowView {
 public:
  virtual ~WindowView() = default;

  /// The view's controls as they are now.
  [[nodiscard]] virtual Controls controls() { return {}; }
  /// The view's other keys, the most used first. They win over the letters of controls and over the keys
  /// that all views have.
  [[nodiscard]] virtual KeyTable ownKeys() { return {}; }
  /// All keys of this view, those of its controls too.
  [[nodiscard]] KeyTable keys() {
    KeyTable table = ownKeys();
    list_.appendKeys(table, controls());
    return table;
  }
  /// Handles a key. Returns false if it is not a key of this view.
  [[nodiscard]] virtual bool press(const Key& key) { return pressIn(keys(), key, host_); }
  /// True if the key waits for the next drawing; two are enough.
  [[nodiscard]] bool waits(const Key& key) {
    const KeyTable own = ownKeys();
    const KeyRow* const row = rowOf(own, key);
    return row && row->waits;
  }
  /// Where the controls were drawn last, and which one is selected.
  [[nodiscard]] const ControlList& list() const { return list_; }
  /// The selected control with its value, if the last drawing does not show it.
  [[nodiscard]] std::string selectedOutOfSight() { return list_.focusOutOfSight(controls()); }
  virtual void release(char) {}
  /// The pointer, in units of the window. hover(): it moved with no button pressed. grab(): the button was
  /// pressed; returns true if this begins a drag. dragTo(): it moved during the drag. drop(): the drag ended.
  virtual void hover(int x, int y) { list_.hover(controls(), x, y); }
  [[nodiscard]] virtual bool grab(int x, int y) { return list_.grab(controls(), x, y) && list_.dragging(); }
  virtual void dragTo(int x, int y) { list_.dragTo(controls(), x, y); }
  virtual void drop() { list_.drop(); }
  /// Comes nearer by a factor in a picture of the view's own. Returns false if it has none: then the scene's
  /// camera comes nearer.
  [[nodiscard]] virtual bool zoom(double) { return false; }
  /// enter() is called when the view appears, leave() when it disappears. leave() undoes whatever must not
  /// outlast the view.
  virtual void enter() {}
  virtual void leave() { list_.leave(); }
  /// Restores what the view itself has changed: by `r`, and for another scene. Returns false if that is
  /// nothing.
  virtual bool reset() { return false; }
  /// True if something moves by itself. Then tick() must be called at regular intervals.
  [[nodiscard]] virtual bool moving() const { return false; }
  virtual void tick() {}

  /// The place of the scene's picture, in units.
  [[nodiscard]] virtual Rect picture(const Layout& at) const = 0;
  /// As large as the workbench makes the picture: one size for all views, so that a vertex has one I and a
  /// scene one number of cuts. A view that needs all pixels of its place has its own.
  [[nodiscard]] virtual Rect frame(const Layout& at) const { return at.frame; }
  /// True if the view's controls can be put away, so that the picture is larger.
  [[nodiscard]] virtual bool hasDrawer() const { return false; }
  /// True if DrawContext::picture must be painted. If false, the picture is never made with coarser settings.
  [[nodiscard]] virtual bool wantsImage() const { return true; }
  /// The setup that the picture is painted with. It picks the indices.
  [[nodiscard]] virtual Setup painted(const Setup& setup) const { return setup; }
  /// Effects on the colours that are stored for the painted picture.
  [[nodiscard]] virtual PaletteEffects stored(const Setup&) const { return {}; }
  /// True if the body must be drawn again for a reason other than a change of the setup.
  [[nodiscard]] virtual bool late(const Setup&) const { return list_.late(); }
  /// Draws the body and the picture. The body is layout.body and the margins around it; it is filled with
  /// paper.
  virtual void draw(Painter paint, const DrawContext& context) = 0;

  // The functions below describe the last drawing.

  /// The first status line, and the softer text after it.
  [[nodiscard]] virtual std::string status() const = 0;
  [[nodiscard]] virtual std::string aside() const { return {}; }
  /// What the view has found, and its table: a line each.
  [[nodiscard]] virtual std::vector<std::string> report() const { return {status()}; }
  /// The command to copy with them, where it is not that of the picture that is shown.
  [[nodiscard]] virtual std::optional<std::string> command() const { return {}; }
  /// The cells that the strip counts; null for those of the scene's picture.
  [[nodiscard]] virtual const CellUse* use() const { return nullptr; }
  /// True if DrawContext::use must count polygons too.
  [[nodiscard]] virtual bool countsPolygons() const { return false; }
  /// Colours that the view chose for the cells when it drew; they change only with a new drawing. Null if the
  /// cells have the colours of the scene's picture.
  [[nodiscard]] virtual const OwnColors* colors() const { return nullptr; }
  /// The cell that the strip marks.
  [[nodiscard]] virtual std::optional<int> inspected() const { return std::nullopt; }

 protected:
  /// The host must outlive it.
  explicit WindowView(Host& host) : host_{host}, list_{host} {}
  /// Changes the window's setup.
  [[nodiscard]] ChangeSetup change() const {
    return [&host = host_](char control, const std::function<void(Setup&)>& edit) {
      host.change(control, edit);
    };
  }

  Host& host_;
  ControlList list_;
};

}  // namespace xnewell
