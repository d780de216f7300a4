#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "shading/explain/equation_at.h"
#include "shading/fill/fill.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Rounds terms to some decimals so that what is written adds up: the sum of the results is the rounded sum
/// of the terms. Each is rounded down, and those with the largest remainders get one unit more. So each is
/// off by less than one unit of the last decimal. The terms are finite and below 2^52 units.
[[nodiscard]] std::vector<double> roundedTerms(const std::vector<double>& terms, int decimals);

/// One number of the illumination equation at every sample of a picture, as an explanation of that pixel has
/// it.

enum class Term { Ambient, Diffuse, Specular, NdotL, Cosine };
struct TermValueRow {
  Term id;
  std::string_view name;
  bool isCosine;  ///< from -1 to 1, before the equation clamps it; the others are parts of I
};
inline constexpr std::array kTerms{
    TermValueRow{Term::Ambient, "ambient", false},   TermValueRow{Term::Diffuse, "diffuse", false},
    TermValueRow{Term::Specular, "specular", false}, TermValueRow{Term::NdotL, "N.L", true},
    TermValueRow{Term::Cosine, "R.V", true},  ///< or what the form of the equation takes for it
};
[[nodiscard]] constexpr const TermValueRow& rowOf(Term term) {
  return kTerms[static_cast<std::size_t>(term)];
}

/// "R.V", or what the form of the equation takes for it.
[[nodiscard]] std::string_view cosineName(Form form);

/// The number in an equation. Diffuse and specular are sums over the lights; the cosines are those of the
/// first light. Of three channels it is the luminance. NaN for a cosine where all light is ambient.
[[nodiscard]] double valueOf(const ExplainedEquation& at, Term term, int channels);

/// True if the picture's method evaluates the equation: flat, Gouraud and Phong shading. The map of an
/// environment holds sums only.
[[nodiscard]] bool hasTerms(const PictureSettings& settings);

/// Flat shading has one value for each face, Phong shading one for each sample. With Gouraud shading the
/// values at the vertices are interpolated, as I is. NaN where nothing shows. Precondition: hasTerms().
[[nodiscard]] std::vector<double> termValues(const Picture& picture, const SeenRows& seen, Term term);

/// What the picture's own loops have at one sample. explain.h puts it beside the definitions.

struct LoopValue {
  double I = 0;                          ///< in [0, 1], as precise as the loop; it picks the cell
  std::uint8_t cell = 0;                 ///< or the value of a channel, where the cells hold colours
  std::optional<glm::ivec2> place = {};  ///< environment: column and row of the map
  bool away = false;
};

/// `face` is an index into snapped().faces and owns the sample of pixel (i, j). One channel, 0 to 2.
[[nodiscard]] LoopValue loopValueOf(const Picture& picture, int face, int channel, int i, int j);

/// What Gouraud shading interpolates, at a vertex of the face: the value on the ramp (Ramp::value). `vertex`
/// is an index into snapped().vertices.
[[nodiscard]] double gouraudValueAt(const Picture& picture, int face, int channel, int vertex);
/// What environment maps interpolate there: column and row of the map, and which of two maps.
[[nodiscard]] glm::dvec3 mapPlaceAt(const Picture& picture, int face, int channel, int vertex);

/// The triangle of a face that owns the sample of pixel (i, j), which the face owns.
[[nodiscard]] FaceTriangle triangleAt(const SnappedScene& scene, const SnappedFace& face, int i, int j);

/// A value along the edges and the row (Polygons::Rows); `v` has one for each vertex of the face.
[[nodiscard]] double alongRow(const SnappedScene& scene, const SnappedFace& face,
                              const std::vector<double>& v, int i, int j);

}  // namespace xnewell
