#pragma once

#include <array>
#include <string_view>

namespace xnewell {

/// What the window may show, a tab and a key each.
enum class WindowView { Picture, DepthSort, Colors, MachBands, SideBySide, Lesson };
inline constexpr int kEveryWindowView = 6;
struct WindowViewRow {
  WindowView id;
  char key;
  std::string_view name, option;  ///< on the tab, and of --view
};
inline constexpr std::array kWindowViews{
    WindowViewRow{WindowView::Picture, '1', "Picture", "picture"},
    WindowViewRow{WindowView::DepthSort, '2', "Depth sort", "depthsort"},
    WindowViewRow{WindowView::Colors, '3', "Colours", "colours"},
    WindowViewRow{WindowView::MachBands, '4', "Mach bands", "machbands"},
    WindowViewRow{WindowView::SideBySide, '5', "Side by side", "sidebyside"},
    WindowViewRow{WindowView::Lesson, '7', "Lesson", "lesson"},
};

}  // namespace xnewell
