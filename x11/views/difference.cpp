#include "x11/views/difference.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_precision.hpp>

#include "depthsort/oracle.h"
#include "shading/color/quantize.h"

namespace xnewell {

namespace {

Difference differenceOf(Unlike kind, std::vector<float> errors, int width) {
  return {errorMap(std::move(errors), width, rowOf(kind).unit), kind};
}

/// The reference in the ramps of the picture. Several hues share the cells by what a picture shows of each,
/// so the reference's own ramps may be others.
void paintInRamps(IndexImage& image, const Picture& picture, const Reference& reference,
                  const Comparison& comparison) {
  const std::vector<Ramp> ramps = picture.colors().ramps();
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const int face = reference.faces()[k];
    if (face == kNothing) continue;
    const glm::dvec3 I = comparison.due(k);
    const int number = reference.picture().snapped().faces[face].number;
    image.pixels[k] =
        ramps[reference.picture().scene().mesh.material[number] + 1].cell(std::max({I.r, I.g, I.b}));
  }
}

/// The reference in the colours of the picture.
void paintInColors(IndexImage& image, const Picture& picture, const Palette& palette,
                   const Reference& reference, const Comparison& comparison) {
  RgbImage bytes{image.width, image.height};
  std::vector<std::uint8_t> shows(image.pixels.size(), 0);
  for (std::size_t k = 0; k < shows.size(); ++k) {
    if (reference.faces()[k] == kNothing) continue;
    shows[k] = 1;
    const Rgb16 color = comparison.dueColor(k);
    bytes.rgb[3 * k] = static_cast<std::uint8_t>(color.r >> 8);
    bytes.rgb[3 * k + 1] = static_cast<std::uint8_t>(color.g >> 8);
    bytes.rgb[3 * k + 2] = static_cast<std::uint8_t>(color.b >> 8);
  }
  std::vector<glm::u8vec3> colors;
  const int first = picture.table().first();
  for (int c = first; c < first + kMaxShades; ++c)
    colors.emplace_back(palette[c].r >> 8, palette[c].g >> 8, palette[c].b >> 8);
  paintNearest(bytes, shows, colors, false, first, image);
}

}  // namespace

Compared comparedWithReference(const Picture& picture, const Truth& truth) {
  const PictureSettings& settings = picture.settings();
  const Palette palette = picture.palette(CellPlan{settings.table.kind});
  const Reference& reference = truth.reference();
  const Comparison comparison{picture, truth, palette};
  Compared result{{settings.width, settings.height, picture.ground()}, {}};
  if (channelsOf(picture.colors().plan()) == Channels::Rgb) {
    result.difference = differenceOf(Unlike::Color, comparison.colorErrors(), settings.width);
    paintInColors(result.reference, picture, palette, reference, comparison);
  } else {
    result.difference =
        differenceOf(Unlike::Intensity, comparison.intensityErrors(TableSide::After), settings.width);
    paintInRamps(result.reference, picture, reference, comparison);
  }
  result.difference.wrongFaces = comparison.wrongFaceCount();
  return result;
}

}  // namespace xnewell
