#pragma once

#include <array>
#include <string_view>

#include "geometry/view/project.h"
#include "shading/color/color_table.h"

namespace xnewell {

/// The choices of settings that have no table of their own, or other labels in the window.

template <class Id>
struct NamedRow {
  Id id;
  std::string_view name, label;
};
inline constexpr std::array kCulls{NamedRow<Cull>{Cull::Keep, "none", "keep"},
                                   NamedRow<Cull>{Cull::Back, "back", "cull"}};
inline constexpr std::array kFillers{NamedRow<bool>{true, "x11", "XFillPolygon"},
                                     NamedRow<bool>{false, "scanline", "scanline"}};
inline constexpr std::array kSides{NamedRow<bool>{false, "one", "one"}, NamedRow<bool>{true, "two", "two"}};
inline constexpr std::array kPickLabels{NamedRow<Pick>{Pick::Log, kPicks[0].name, "in ratio"},
                                        NamedRow<Pick>{Pick::Search, kPicks[1].name, "in difference"}};
inline constexpr std::array kBits{NamedRow<int>{8, "8", "8"}, NamedRow<int>{16, "16", "16"}};

}  // namespace xnewell
