#pragma once

#include <string>
#include <vector>

#include "shading/explain/term_values.h"
#include "x11/drawing/sheet.h"
#include "x11/views/picture_sheet.h"

namespace xnewell {

/// One number of the illumination equation as a picture: a term, N.L or R.V. Grays are 0 to 1, whatever the
/// picture holds, so the three terms can be compared. What is below 0 is blue.

/// The values at the samples of a picture, and what there is to say of them.
struct TermValues {
  Term term = Term::Ambient;
  int width = 0;
  std::vector<double> values = {};  ///< row by row; NaN where there is none
  std::int64_t samples = 0;
  std::int64_t counted = 0;  ///< samples where a cosine is above 0, or a term half a shade of 240 or more
  double least = 0, most = 0, mean = 0;  ///< 0 if no sample has a value
};
[[nodiscard]] TermValues termValuesOf(const Picture& picture, Term term);

/// "N.H": a term, or the cosine that the form of the equation has in its place.
[[nodiscard]] std::string termName(Term term, Form form);
[[nodiscard]] Finding findingOf(const TermValues& found, const Picture& picture);

/// An image of the picture's size with a legend in its upper left corner. It has colours of its own in the
/// scene's cells; the rest of its palette is `palette`.
[[nodiscard]] ColoredImage termImage(const TermValues& found, const Picture& picture, const CellPlan& plan,
                                     const Palette& palette, int unit = 1);

/// The same with its numbers.
[[nodiscard]] Lens termLens(const Picture& picture, const CellPlan& plan, const Palette& palette, Term term,
                            int unit);

}  // namespace xnewell
