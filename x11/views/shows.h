#pragma once

#include <array>
#include <string>
#include <string_view>

#include "shading/laboratory/truth.h"
#include "x11/views/views.h"

namespace xnewell {

/// What the window may show in the place of the picture: the shaded surfaces, or one of the other views
/// without the sheet around it.

enum class Show {
  Shaded,
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
struct ShowRow {
  Show id;
  std::string_view name, label, shows;
  bool ownColors = false;         ///< colours of its own in the scene's cells
  std::optional<Term> term = {};  ///< the number of the equation that it shows
};
inline constexpr std::array kShows{
    ShowRow{Show::Shaded, "shaded", "shaded", "the picture"},
    ShowRow{Show::Wireframe, "wireframe", "wire",
            "all edges, hidden ones darker, dashed where the depth sort cut"},
    ShowRow{Show::Normals, "normals", "normals",
            "N as a colour: red to the right, green up, blue towards the viewer", true},
    ShowRow{Show::Overdraw, "overdraw", "overdraw",
            "how often each sample was painted: the brighter, the more often"},
    ShowRow{Show::Difference, "difference", "difference",
            "from a reference without short cuts: the brighter, the more"},
    ShowRow{Show::Exactness, "exactness", "exactness",
            "where the face that shows is right, wrong, or doubtful"},
    ShowRow{Show::Ambient, "ambient", "ambient", "the ambient term: gray from 0 to 1", true, Term::Ambient},
    ShowRow{Show::Diffuse, "diffuse", "diffuse", "the diffuse term: gray from 0 to 1", true, Term::Diffuse},
    ShowRow{Show::Specular, "specular", "specular", "the specular term: gray from 0 to 1", true,
            Term::Specular},
    ShowRow{Show::NdotL, "N.L", "N.L", "N.L: gray from 0 to 1, blue where the light is behind", true,
            Term::NdotL},
    ShowRow{Show::Cosine, "R.V", "R.V", "R.V, or what the form takes for it: blue below 0", true,
            Term::Cosine},
};

[[nodiscard]] constexpr const ShowRow& rowOf(Show show) { return kShows[static_cast<std::size_t>(show)]; }

struct ShownPicture {
  IndexImage image;  ///< of the picture's size
  Palette palette;   ///< the picture's own, except for ShowRow::ownColors
  std::string finding;
};

/// The image of a painted picture, and over it the edges, lines and labels of its scene, each in the
/// cell that looks most like its colour.
[[nodiscard]] IndexImage withMarks(const Picture& picture, const Palette& palette);

/// `picture` is painted; `palette` has its colours. Show::Difference needs the truth, which takes long to
/// make; it is kept in `truth`. Marks and legends are drawn in units of so many pixels.
[[nodiscard]] ShownPicture shownAs(Show show, const Picture& picture, const Palette& palette,
                                   const CellPlan& plan, LastTruth& truth, int unit = 1);

}  // namespace xnewell
