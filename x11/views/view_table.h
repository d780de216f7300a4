#pragma once

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "shading/explain/term_values.h"

namespace xnewell {

/// All that --view names: the views of the window, each with a tab and a key, and what is shown in the place
/// of the picture. `draw` and `snapshot` draw most of them as a sheet.

enum class View {
  Picture,
  DepthSort,
  Colors,
  MachBands,
  SideBySide,
  Trade,
  Lesson,
  Pixel,
  Viewing,
  Scanline,
  Wireframe,
  Normals,
  Overdraw,
  Difference,
  Exactness,
  Ambient,
  Diffuse,
  Specular,
  NdotL,
  Cosine
};
struct ViewRow {
  View id;
  std::string_view name;          ///< the value of --view
  std::string_view title;         ///< the words on its tab, or on the button of what the picture shows
  std::string_view shows;         ///< for lists of what may be asked
  char key = 0;                   ///< of its tab
  glm::ivec2 least = {};          ///< pixels of its sheet, in which all words fit; 0, 0: it has no sheet
  std::optional<Term> term = {};  ///< the number of the equation that it shows
  [[nodiscard]] constexpr bool hasSheet() const { return least.x > 0; }
  /// True if it has colours of its own, not those of the picture.
  [[nodiscard]] constexpr bool hasOwnColors() const { return id == View::Normals || term; }
};
inline constexpr std::array kViews{
    ViewRow{View::Picture, "picture", "Picture", "the picture", '1', {1, 1}},
    ViewRow{View::DepthSort, "depthsort", "Depth sort", "the depth sort, step by step", '2'},
    ViewRow{View::Colors,
            "colours",
            "Colours",
            "the colour table: what every cell holds, and how much it is used",
            '3',
            {768, 560}},
    ViewRow{View::MachBands,
            "machbands",
            "Mach bands",
            "the intensity along a scanline and its change from pixel to pixel, for three methods",
            '4',
            {720, 480}},
    ViewRow{View::SideBySide, "sidebyside", "Side by side",
            "two ways to draw the scene, and how much differs", '5'},
    ViewRow{View::Trade, "trade", "Trade", "what each method costs, and how far it is from the exact picture",
            '6'},
    ViewRow{View::Lesson, "lesson", "Lesson", "the lessons", '7'},
    ViewRow{View::Pixel, "pixel", "One pixel", "all that leads to one pixel", '8'},
    ViewRow{View::Viewing, "viewing", "Viewing", "the viewing transformation, stage by stage", '9'},
    ViewRow{View::Scanline, "scanline", "Scanline", "a polygon, filled row by row and pixel by pixel", '0'},
    ViewRow{View::Wireframe,
            "wireframe",
            "wire",
            "all edges, hidden ones darker, dashed where the depth sort cut",
            0,
            {640, 480}},
    ViewRow{View::Normals,
            "normals",
            "normals",
            "N as a colour: red to the right, green up, blue towards the viewer",
            0,
            {400, 320}},
    ViewRow{View::Overdraw,
            "overdraw",
            "overdraw",
            "how often each sample was painted: the brighter, the more often",
            0,
            {640, 480}},
    ViewRow{View::Difference,
            "difference",
            "difference",
            "from a reference without short cuts: the brighter, the more",
            0,
            {640, 560}},
    ViewRow{View::Exactness,
            "exactness",
            "exactness",
            "where the face that shows is right, wrong, or doubtful",
            0,
            {640, 480}},
    ViewRow{View::Ambient,
            "ambient",
            "ambient",
            "the ambient term: gray from 0 to 1",
            0,
            {640, 480},
            Term::Ambient},
    ViewRow{View::Diffuse,
            "diffuse",
            "diffuse",
            "the diffuse term, of all lights: gray from 0 to 1",
            0,
            {640, 480},
            Term::Diffuse},
    ViewRow{View::Specular,
            "specular",
            "specular",
            "the specular term, of all lights: gray from 0 to 1",
            0,
            {640, 480},
            Term::Specular},
    ViewRow{View::NdotL,
            "N.L",
            "N.L",
            "N.L of the first light: gray from 0 to 1, blue where the light is behind",
            0,
            {640, 480},
            Term::NdotL},
    ViewRow{View::Cosine,
            "R.V",
            "R.V",
            "R.V of the first light, or what --form takes for it: blue below 0",
            0,
            {640, 480},
            Term::Cosine},
};
[[nodiscard]] constexpr const ViewRow& rowOf(View view) { return kViews[static_cast<std::size_t>(view)]; }

/// The views of the window, in the order of their tabs.
inline constexpr std::span kWindowViews{kViews.begin(), std::ranges::find(kViews, 0, &ViewRow::key)};
/// What view 1 may show in the place of its picture, which is none of these.
inline constexpr std::span kInsteadOfPicture{kViews.begin() + kWindowViews.size(), kViews.end()};

}  // namespace xnewell
