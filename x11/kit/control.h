#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "x11/drawing/pen.h"
#include "x11/drawing/rect.h"

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

}  // namespace xnewell
