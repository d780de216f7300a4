#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "shading/explain/term_values.h"
#include "shading/laboratory/errors.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// Where a picture shows the right face, where a wrong one, and where rounding leaves it open.

/// What the map shows for SampleCheck::Right and those after it.
inline constexpr std::array kVerdictSteps{
    LegendStep{Cell::WellLine, "right"},
    LegendStep{Cell::Q, "doubtful"},
    LegendStep{Cell::Alarm, "wrong"},
};

/// The verdicts as an image of the picture's size. Samples that show no face stay background.
[[nodiscard]] IndexImage verdictImage(const std::vector<SampleCheck>& verdicts, int width,
                                      const CellPlan& plan);

/// The places that need a look: wrong samples, or doubtful ones if none is wrong. The picture is divided into
/// blocks; samples in one block, or in two that touch, are in one spot. Returns the box of each spot.
inline constexpr int kSpotBlock = 16;  ///< pixels
[[nodiscard]] std::vector<Rect> spotsOf(const std::vector<SampleCheck>& verdicts, int width);
/// Draws a ring around each spot, in a picture whose upper left corner is at (x, y). A single sample is hard
/// to find without one. There is no ring around a spot that is larger than a quarter of the picture's height.
void ringSpots(Painter painter, int x, int y, const std::vector<SampleCheck>& verdicts, int width,
               const CellPlan& plan);

/// The oracle judges by the faces that are drawn. If some are culled, the finding says so: the truth of all
/// faces is with the errors. The picture is named by its size: --errors may count in a larger one.
[[nodiscard]] Finding findingOf(const Exactness& exactness, const PictureSettings& of);

/// The map, its numbers, and what they mean.
[[nodiscard]] Lens exactnessLens(const Picture& picture, const CellPlan& plan, const Palette& palette);

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
