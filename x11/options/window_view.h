#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace xnewell {

/// The views of the window. Each has a tab and a key.
enum class WindowView { Picture, DepthSort, Colors, MachBands, SideBySide, Trade, Lesson, Pixel };
struct WindowViewRow {
  WindowView id;
  char key;
  std::string_view name, option;  ///< the words on the tab, and the value of --view
};
inline constexpr std::array kWindowViews{
    WindowViewRow{WindowView::Picture, '1', "Picture", "picture"},
    WindowViewRow{WindowView::DepthSort, '2', "Depth sort", "depthsort"},
    WindowViewRow{WindowView::Colors, '3', "Colours", "colours"},
    WindowViewRow{WindowView::MachBands, '4', "Mach bands", "machbands"},
    WindowViewRow{WindowView::SideBySide, '5', "Side by side", "sidebyside"},
    WindowViewRow{WindowView::Trade, '6', "Trade", "trade"},
    WindowViewRow{WindowView::Lesson, '7', "Lesson", "lesson"},
    WindowViewRow{WindowView::Pixel, '8', "One pixel", "pixel"},
};

/// Where a view begins, beside its scene and the set-up.
struct WindowPlace {
  WindowView view = WindowView::Picture;
  int step = 0;                          ///< of the depth sort
  std::optional<int> scanline = {};      ///< of the view of Mach bands
  std::optional<int> cell = {};          ///< of the view of the colours
  std::optional<glm::ivec2> pixel = {};  ///< of view 8: column and row in its picture
  std::optional<std::string> controls =
      {};  ///< the keys of the few in view 1; "": put away; none: all of them
};

}  // namespace xnewell
