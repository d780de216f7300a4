#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "x11/kit/control.h"
#include "x11/kit/key_table.h"
#include "x11/kit/prompt.h"

namespace xnewell {

using Controls = std::vector<Control>;

/// Takes an option of a choice, or the next one if it is -1; flips a toggle; presses a button.
void activate(const Control& control, int option = -1);

/// Remembers which of a view's controls is selected and where each was drawn last; turns keys and the
/// pointer into calls of their `set`.
///
/// Focus: the control that the arrows change. Its letter selects it, Tab goes to the next, a click on its row
/// selects it. A letter that several numbers share goes through them.
class ControlList {
 public:
  /// The prompt must outlive it.
  explicit ControlList(Prompt& prompt) : prompt_{prompt} {}

  // Drawing. A view first forgets the old places, then places its controls, then draws them. A control that
  // is not placed still has its keys.
  void forgetPlaces() { places_.clear(); }
  void place(ControlId id, ControlPlace place) { places_.emplace_back(id, std::move(place)); }
  /// Places the controls of a key in a row with this baseline, and returns the baseline of the next row.
  int placeRow(const Controls& controls, char key, int x, int baseline, const RowStyle& style = {});
  /// Places all controls in rows, one below the other. Returns the baseline of the row after the last.
  int placeColumn(const Controls& controls, int x, int baseline, const RowStyle& style = {});
  [[nodiscard]] const ControlPlace* find(ControlId id) const;
  [[nodiscard]] const std::vector<std::pair<ControlId, ControlPlace>>& places() const { return places_; }
  [[nodiscard]] Look look(ControlId id) const;
  /// Draws the placed controls, the mark of the focus first, so that it covers none.
  void draw(Pen& pen, const Controls& controls);
  /// True if something changed that draw() has not shown yet.
  [[nodiscard]] bool late() const { return state_ != drawn_; }

  // The pointer. grab() returns true if the press was on a control; dragging() then says whether a drag has
  // begun.
  void hover(const Controls& controls, int x, int y);
  [[nodiscard]] bool grab(const Controls& controls, int x, int y);
  void dragTo(const Controls& controls, int x, int y);
  void drop() { state_.dragged.reset(); }
  [[nodiscard]] bool dragging() const { return state_.dragged.has_value(); }
  void leave() { state_.hovered.reset(), drop(); }

  // Keys.
  /// The selected control; null if there is none, or if it is not among these controls.
  [[nodiscard]] const Control* focused(const Controls& controls) const;
  [[nodiscard]] std::optional<ControlId> focus() const { return state_.focus; }
  /// "ka 0.90": the selected control and its value, if the view has placed it nowhere; "" else.
  [[nodiscard]] std::string focusOutOfSight(const Controls& controls) const;
  void setFocus(std::optional<ControlId> id) { state_.focus = id; }
  /// The user types a value of the control.
  void askForValue(const Control& control);
  /// True if a control that a press would act on lies there.
  [[nodiscard]] bool has(int x, int y) const;
  /// The control under the pointer.
  [[nodiscard]] const Control* hovered(const Controls& controls) const;
  /// Appends the rows of all keys to `table`: the arrows, Home, End, = and Tab for the selected control, and
  /// each control's letter. A key that the table has already keeps its meaning. The rows keep copies of the
  /// controls; this list must outlive them.
  void appendKeys(KeyTable& table, const Controls& controls);

 private:
  struct Hit {
    ControlId id;
    int option = -1;
    bool grip = false;
    bool operator==(const Hit&) const = default;
  };
  struct State {
    std::optional<ControlId> focus, dragged;
    std::optional<Hit> hovered;
    bool operator==(const State&) const = default;
  };
  [[nodiscard]] std::optional<Hit> at(int x, int y) const;
  void select(const Controls& controls, char key);
  void selectNext(const Controls& controls, int direction);
  void press(const Controls& controls, const Control& control);
  void move(const Control& control, int along, int up);

  Prompt& prompt_;
  State state_;
  std::optional<State> drawn_;
  std::vector<std::pair<ControlId, ControlPlace>> places_;
  int x_ = 0, y_ = 0;  ///< the pointer's last place during a drag
};

}  // namespace xnewell
