#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "shading/color/colored_image.h"
#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "shading/explain/term_values.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

/// What may be drawn of a scene: the picture, or the numbers behind it.

enum class View {
  Picture,
  Colors,
  MachBands,
  Normals,
  Difference,
  Exactness,
  Overdraw,
  Wireframe,
  Ambient,
  Diffuse,
  Specular,
  NdotL,
  Cosine
};
struct ViewRow {
  View id;
  std::string_view name, shows;
  int leastWidth, leastHeight;  ///< pixels; all words fit in this size
};
inline constexpr std::array kViews{
    ViewRow{View::Picture, "picture", "the picture", 1, 1},
    ViewRow{View::Colors, "colours", "the colour table: what every cell holds, and how much it is used", 768,
            560},
    ViewRow{View::MachBands, "machbands",
            "the intensity along a scanline and its change from pixel to pixel, for three methods", 720, 480},
    ViewRow{View::Normals, "normals", "the normals that the light is computed with, as colours and needles",
            400, 320},
    ViewRow{View::Difference, "difference", "the picture against a reference without any short cut", 640,
            560},
    ViewRow{View::Exactness, "exactness",
            "where the face that shows is right, wrong, or doubtful because two nearly touch", 640, 480},
    ViewRow{View::Overdraw, "overdraw", "how often each sample was painted, and what that costs", 640, 480},
    ViewRow{View::Wireframe, "wireframe", "the edges of all polygons, dashed where the depth sort cut one",
            640, 480},
    ViewRow{View::Ambient, "ambient", "the ambient term of the equation at every pixel", 640, 480},
    ViewRow{View::Diffuse, "diffuse", "the diffuse term, of all lights", 640, 480},
    ViewRow{View::Specular, "specular", "the specular term, of all lights", 640, 480},
    ViewRow{View::NdotL, "N.L", "N.L of the first light, below 0 where the light is behind", 640, 480},
    ViewRow{View::Cosine, "R.V", "R.V of the first light, or what --form takes for it", 640, 480},
};
[[nodiscard]] constexpr const ViewRow& rowOf(View view) { return kViews[static_cast<std::size_t>(view)]; }

/// The number of the equation that a view shows, if it is one of these.
[[nodiscard]] constexpr std::optional<Term> termOf(View view) {
  switch (view) {
    case View::Ambient:
      return Term::Ambient;
    case View::Diffuse:
      return Term::Diffuse;
    case View::Specular:
      return Term::Specular;
    case View::NdotL:
      return Term::NdotL;
    case View::Cosine:
      return Term::Cosine;
    default:
      return std::nullopt;
  }
}
/// True if the view has colours of its own, not those of the picture.
[[nodiscard]] constexpr bool hasOwnColors(View view) { return view == View::Normals || termOf(view); }

struct ViewSettings {
  View view = View::Picture;
  std::optional<int> scanline = {};  ///< for MachBands: a row of its picture; without it defaultScanline()
  std::optional<int> cell =
      {};  ///< for Colors: the inspected cell; without it the lit one, or else medianCell()
  PaletteEffects effects = {};  ///< for Colors
  PictureSettings picture;  ///< width and height are those of the whole view, at least the least of its row
  CellPlan cells{};
  Palette unneeded{};  ///< the colours of cells that are not needed, as in makePalette()
  bool gray = false;   ///< for Colors: the screen shows only grays
};

/// Makes the picture that the view shows, which is smaller than the view, and draws the view. Any but
/// View::Picture.
/// @throws ViewError as PictureCache::make(), std::invalid_argument where the scanline is not in the picture
[[nodiscard]] ColoredImage drawView(PictureCache& pictures, const ViewSettings& settings);

}  // namespace xnewell
