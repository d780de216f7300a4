#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "shading/explain/equation_at.h"
#include "shading/picture/picture.h"

namespace xnewell {

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

}  // namespace xnewell
