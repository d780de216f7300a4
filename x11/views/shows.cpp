#include "x11/views/shows.h"

#include "x11/views/difference.h"
#include "x11/views/exactness_view.h"
#include "x11/views/normals_view.h"
#include "x11/views/overdraw.h"
#include "x11/views/step_legend.h"
#include "x11/views/terms_view.h"
#include "x11/views/wireframe.h"

namespace xnewell {

namespace {

constexpr int kLegend = 8;  // pixels from the upper left corner

}  // namespace

ShownPicture shownAs(Show show, const Picture& picture, const Palette& palette, const CellPlan& plan,
                     LastTruth& truth, int unit) {
  switch (show) {
    case Show::Shaded:
      break;
    case Show::Wireframe: {
      const Wireframe wires = wireframeOf(picture, plan);
      return {wires.image, palette, findingOf(wires, picture).bold};
    }
    case Show::Normals: {
      const ColoredImage normals = normalsImage(picture, plan, palette, unit);
      return {normals.image, normals.palette, "Red: N to the right. Green: up. Blue: towards the viewer."};
    }
    case Show::Overdraw: {
      const Overdraw overdraw = overdrawOf(picture);
      ShownPicture shown{overdrawImage(overdraw, plan), palette, findingOf(overdraw, picture).bold};
      std::vector<LegendStep> steps;
      for (const OverdrawStep& step : kOverdrawSteps) steps.push_back({step.cell, step.label});
      drawStepLegend({shown.image, unit}, plan, kLegend, kLegend, steps, "");
      return shown;
    }
    case Show::Difference: {
      const Compared compared = comparedWithReference(picture, truth.of(picture));
      ShownPicture shown{stepsImage(compared.difference, plan), palette, findingOf(compared.difference).bold};
      drawStepLegend({shown.image, unit}, plan, kLegend, kLegend, kDoublingSteps,
                     rowOf(compared.difference.kind).times);
      return shown;
    }
    case Show::Exactness: {
      const std::vector<SampleCheck> verdicts = checkedSamples(picture);
      ShownPicture shown{verdictImage(verdicts, picture.settings().width, plan), palette,
                         findingOf(exactnessOf(verdicts), picture.settings()).bold};
      ringSpots({shown.image, unit}, 0, 0, verdicts, picture.settings().width, plan);
      drawStepLegend({shown.image, unit}, plan, kLegend, kLegend, kVerdictSteps, "");
      return shown;
    }
    case Show::Ambient:
    case Show::Diffuse:
    case Show::Specular:
    case Show::NdotL:
    case Show::Cosine: {
      const TermValues found = termValuesOf(picture, *rowOf(show).term);
      const ColoredImage own = termImage(found, picture, plan, palette, unit);
      return {own.image, own.palette, findingOf(found, picture).bold};
    }
  }
  return {picture.image(), palette, ""};
}

}  // namespace xnewell
