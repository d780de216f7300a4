#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "x11/drawing/painter.h"
#include "x11/kit/key_table.h"

namespace xnewell {

/// What the user changes: by its key and the arrows, with the pointer, or by typing a value. A view makes its
/// controls anew from its state whenever they are needed. `set` changes that state. control_list.h draws
/// them and turns keys and the pointer into calls of `set`.

/// The values of a slider or a number.
struct TrackRange {
  double low = 0, high = 1;
  double step = 0.01;  ///< an arrow moves one step; if logarithmic, a step is a share of the track
  bool logarithmic = false;
  int decimals = 2;
};
/// The position of a value on its track, in [0, 1], and the value at a position, rounded to the decimals.
/// Both clamp.
[[nodiscard]] double shareOf(const TrackRange& range, double value);
[[nodiscard]] double valueAt(const TrackRange& range, double share);
/// The value some steps further, within the range. It moves by at least one unit of the last decimal.
[[nodiscard]] double stepped(const TrackRange& range, double value, int steps);
/// The value as it is shown: 0.25, 1,024.
[[nodiscard]] std::string textOf(const TrackRange& range, double value);

/// A control's name among those of its view: its key; numbers that share a key have parts 0, 1, 2, ...
struct ControlId {
  char key = 0;
  int part = 0;
  bool operator==(const ControlId&) const = default;
};

struct Control {
  enum class Kind {
    Slider,  ///< a value on a track
    Choice,  ///< one of several options
    Toggle,  ///< on or off
    Number,  ///< a value without a track; several may share a key and a row
    Button,  ///< does what a key of its view does
    Own,     ///< a picture or words; the arrows call `move`, and a drag calls `drag`
  };
  Kind kind = Kind::Slider;
  char key = 0;
  int part = 0;
  std::string label = {};
  std::string heading = {};  ///< before a row of numbers, in place of the first one's label
  std::string is = {};       ///< what it changes, for the status line
  std::string legend = {};   ///< its words in the last line; "": it is not there
  double value = 0;          ///< of a choice: the option's index, or -1; of a toggle: 0 or 1
  TrackRange range = {};
  std::optional<double> initially = {};   ///< marked on the track
  std::vector<std::string> options = {};  ///< of a choice
  std::optional<double> next = {};  ///< of a choice: its key chooses this, not the option after the value
  std::vector<bool> lacking = {};   ///< the options without effect, drawn faint; empty: none
  std::string words = {};           ///< beside a toggle's box or for an Own value
  std::string off = {};             ///< why it has no effect, a sentence; "": it has one
  /// Gets a value as in `value`; a button gets 1. An Own control may lack it; with it, a value can be typed.
  std::function<void(double)> set = {};
  /// What the arrows do instead of stepping the value.
  std::function<void(int along, int up)> move = {};
  /// What a drag does instead of setting the value: the pointer is at (x, y), and came by (dx, dy), which is
  /// (0, 0) when the button is pressed.
  std::function<void(int x, int y, int dx, int dy)> drag = {};

  [[nodiscard]] ControlId id() const { return {key, part}; }
  /// The name of a row.
  [[nodiscard]] const std::string& name() const { return heading.empty() ? label : heading; }
  [[nodiscard]] bool enabled() const { return off.empty(); }
  /// True if the control can be selected, so that the arrows change it.
  [[nodiscard]] bool takesArrows() const {
    return kind == Kind::Slider || kind == Kind::Number || (kind == Kind::Own && move);
  }
};

/// The parts of a row of controls, in units from its left edge.
struct RowStyle {
  int width = 320;            ///< of the row; a value ends there
  int pitch = 22;             ///< from row to row
  int label = 24;             ///< after the key cap
  int value = 84;             ///< where a track or the first option begins
  int track = 168;            ///< the width of a track
  int numbers = 60;           ///< from one number of a row to the next
  int beyond = 6;             ///< how far the mark of the focus reaches past the row's end
  bool wordsAtValue = false;  ///< the words of an Own control stand where a track would begin
  bool boxAfterKey = false;   ///< a toggle's box stands where the labels begin, and its label follows
};

/// Where a control is.
struct ControlPlace {
  int x = 0, y = 0;  ///< the left edge of the key cap, and the baseline of the text
  Rect area;         ///< all of it: for the pointer, and for the mark of the focus
  Rect track = {};   ///< from the lowest value to the highest
  Rect grip = {};    ///< a press here begins a drag
  Rect box = {};     ///< a toggle's box, a button's frame, or a number's frame
  std::vector<Rect> options = {};
  RowStyle style = {};
  bool bare = false;     ///< the view draws the control itself
  bool passive = false;  ///< a press drags the control, but does not select it
  bool above = false;    ///< it lies on another control, and the pointer finds it first
};
/// The place of a control in a row with this baseline. `parts` numbers share the row. The height of `area`
/// is what the row needs: the options of a choice may need more lines.
[[nodiscard]] ControlPlace placeInRow(const Control& control, int x, int baseline, const RowStyle& style = {},
                                      int parts = 1);

/// How a control looks at the moment.
struct Look {
  bool focused = false, hovered = false, dragged = false;
  int option = -1;  ///< under the pointer
};
/// Draws a control at its place, except for its focus. An Own control shows its key, its label and its words.
void drawControl(Pen& pen, const Control& control, const ControlPlace& place, const Look& look);
/// The parts that a control with a drawing of its own may use.
void drawTrack(Pen& pen, const ControlPlace& place, double share, std::optional<double> initially,
               bool enabled, const Look& look);
void drawOptions(Pen& pen, const std::vector<std::string>& options, const std::vector<Rect>& frames,
                 int chosen, int hovered, const std::vector<bool>& lacking = {});
/// The frames of all options of a choice, in a line from x on within `width`. If there is too little room
/// for the words, more lines follow, each one `height` below the one before. `height` is at least that of
/// the text, 13.
[[nodiscard]] std::vector<Rect> optionFrames(const std::vector<std::string>& options, int x, int baseline,
                                             int width, int height = 19);

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
