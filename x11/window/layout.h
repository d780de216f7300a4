#pragma once

#include <string>

#include "x11/drawing/painter.h"
#include "x11/kit/control.h"
#include "x11/window/controls.h"

namespace xnewell {

/// The settings of a picture in words.

/// One line that says how a picture is made: "flat; sorted by farthest z; own scanline; perspective".
[[nodiscard]] std::string captionOf(const Setup& setup);
/// The mistake in the equation of a picture, "R reversed"; "" if it has none or shows none.
[[nodiscard]] std::string mistakeIn(const Setup& setup);
/// "sorted by farthest z"
[[nodiscard]] std::string orderText(Order order);
/// "Gouraud", "full intensity"
[[nodiscard]] std::string shadingText(Shading shading);

inline constexpr int kMargin = 16, kControls = 320;

/// How much of its controls a view shows: all, the few that a page of a lecture names, or none. The picture
/// gets the room that they leave.
enum class Drawer { Whole, Few, Shut };
inline constexpr int kHandle = 24, kFewControls = 176;  ///< widths, in units

/// The places of the window's parts, in units of the scale: a unit is `unit` x `unit` pixels. The whole
/// window is laid out in units, and Painter makes pixels of them; only pictures are made of pixels. `roomy`
/// is false if there is no room for the controls.
struct Layout {
  int width = 0, height = 0;  ///< the last unit may reach beyond the window
  int unit = 1;
  bool roomy = false, compact = false;
  bool low =
      false;  ///< lower than 600, as 1080 lines are at scale 2: the bands take less, the status one line
  Rect views, controls, strip, status;
  Rect picture;  ///< of view 1
  Rect well;     ///< the ground around it
  Rect frame;    ///< as large as the scene's picture is in all views; they may show it smaller
  Rect body;     ///< between the tabs and the strip, for a view without controls
  Drawer drawer = Drawer::Whole;
  Rect handle;             ///< opens the drawer, or shuts it if it has few controls; empty if all are there
  Rect headline, finding;  ///< above and below the picture; empty if all controls are there
  bool briefTabs = false;  ///< the tabs are only keys, so that a long title has room beside them
};
/// The largest rectangle of three to two in the middle of `room`, at most `most` wide. All pictures of the
/// scene are framed so: then all have the same camera.
[[nodiscard]] Rect framed(const Rect& room, int most = 1 << 20);
/// The layout of a window of so many pixels.
[[nodiscard]] Layout layoutOf(int width, int height, int unit = 1, Drawer drawer = Drawer::Whole);

/// The largest scale at which the window has room for the controls; 1 if there is none.
[[nodiscard]] int largestScale(int width, int height);

/// The drawer of a view's controls at the right edge of the window, while it has few of them or none.

/// The key that shuts the drawer and opens it.
inline constexpr char kDrawerKey = 'D';

/// The handle, as a control. `press` gets its letter.
[[nodiscard]] Control handleControl(const std::function<void(char)>& press);

/// Draws the background of the drawer and its handle, and places the handle. If the drawer is open, places
/// the controls whose keys are in `few`, one below the other, in the order of the keys; a control for which
/// there is no room has no place.
void drawDrawer(Pen& pen, const Layout& at, const Controls& controls, std::string_view few,
                ControlList& list);

}  // namespace xnewell
