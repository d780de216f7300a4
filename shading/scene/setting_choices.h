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
template <class Id>
struct WordedRow {
  Id id;
  std::string_view name, label;
  std::string_view words;  ///< Choice::words
};
inline constexpr std::array kCulls{WordedRow<Cull>{Cull::Keep, "none", "keep", "backs kept"},
                                   WordedRow<Cull>{Cull::Back, "back", "cull", "backs culled"}};
inline constexpr std::array kFillers{NamedRow<bool>{true, "x11", "XFillPolygon"},
                                     NamedRow<bool>{false, "scanline", "scanline"}};
inline constexpr std::array kSides{WordedRow<bool>{false, "one", "one", "fronts lit"},
                                   WordedRow<bool>{true, "two", "two", "both sides lit"}};
inline constexpr std::array kPickLabels{NamedRow<Pick>{Pick::Log, kPicks[0].name, "in ratio"},
                                        NamedRow<Pick>{Pick::Search, kPicks[1].name, "in difference"}};
inline constexpr std::array kBits{NamedRow<int>{8, "8", "8"}, NamedRow<int>{16, "16", "16"}};

}  // namespace xnewell
