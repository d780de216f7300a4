#pragma once

#include "x11/drawing/pen.h"
#include "x11/kit/control_list.h"
#include "x11/window/layout.h"

namespace xnewell {

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
