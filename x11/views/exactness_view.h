#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "shading/laboratory/exactness.h"
#include "x11/drawing/rect.h"
#include "x11/drawing/sheet.h"
#include "x11/views/picture_sheet.h"

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

}  // namespace xnewell
