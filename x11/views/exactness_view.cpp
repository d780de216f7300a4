#include "x11/views/exactness_view.h"

#include <algorithm>
#include <string>

#include "x11/drawing/wording.h"
#include "x11/views/picture_sheet.h"

namespace xnewell {

namespace {

constexpr int kVerdictStrip = Sheet::kSection + 22 + 5 * Sheet::kRow;

/// The sample that most needs a look: the first wrong one, or else the first doubtful one.
std::vector<SampleCheck>::const_iterator worstOf(const std::vector<SampleCheck>& verdicts) {
  const auto wrong = std::ranges::find(verdicts, SampleCheck::Wrong);
  return wrong != verdicts.end() ? wrong : std::ranges::find(verdicts, SampleCheck::Doubtful);
}

}  // namespace

IndexImage verdictImage(const std::vector<SampleCheck>& verdicts, int width, const CellPlan& plan) {
  IndexImage image{width, static_cast<int>(verdicts.size()) / width, plan[Cell::Well]};
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    if (verdicts[k] != SampleCheck::Nothing)
      image.pixels[k] = plan[kVerdictSteps[static_cast<std::size_t>(verdicts[k]) - 1].cell];
  return image;
}

Finding findingOf(const Exactness& e, Order order) {
  if (e.samples == 0) return {"Nothing shows.", ""};
  const std::string doubtful =
      e.doubtful == 0 ? ""
                      : "At " + counted(e.doubtful, "sample") +
                            " two faces lie so near to each other that the rounding of the file, or of the "
                            "screen grid, may have changed which one is nearer.";
  if (e.wrong > 0)
    return {"A wrong face shows at " + grouped(e.wrong) + " of " + counted(e.samples, "sample") + ".",
            "The oracle, which compares all faces at each sample, sees a nearer one there." +
                (doubtful.empty() ? "" : " " + doubtful)};
  if (e.doubtful > 0)
    return {"No face is wrong, but " + counted(e.doubtful, "sample") + " may be.", doubtful};
  return {"Every sample shows the right face.",
          order == Order::Oracle ? "The oracle painted it, and the oracle is the judge."
                                 : "The oracle, which compares all faces at each sample, sees the same."};
}

PictureSettings pictureForExactness(const ViewSettings& settings) {
  return PictureSheet::picture(settings, kVerdictStrip);
}

ColoredImage drawExactness(const Picture& picture, const ViewSettings& settings) {
  PictureSheet page{settings, kVerdictStrip};
  const std::vector<SampleCheck> verdicts = checkedSamples(picture);
  const Exactness e = exactnessOf(verdicts);
  const int width = picture.settings().width;
  page.place(verdictImage(verdicts, width, settings.cells));
  if (const auto worst = worstOf(verdicts); worst != verdicts.end()) {
    Painter painter = page.sheet.painter().within(page.at);
    const int k = static_cast<int>(worst - verdicts.begin());
    painter.ring(page.at.x + k % width, page.at.y + k / width, 8, page.sheet.cell(Cell::White));
    painter.ring(page.at.x + k % width, page.at.y + k / width, 9, page.sheet.cell(Cell::Black));
  }
  int y = page.section("faces");
  drawStepLegend(page.sheet.painter(), settings.cells, page.left + 2, y + 2, kVerdictSteps, "");
  page.finding(y, findingOf(e, picture.settings().order));
  y += 22;
  const auto row = [&](std::string_view label, const std::string& value) { y = page.row(y, label, value); };
  row("order", std::string{kOrders[static_cast<int>(picture.settings().order)].label});
  row("samples that show a face", grouped(e.samples));
  row("right", grouped(e.samples - e.doubtful - e.wrong));
  row("doubtful", grouped(e.doubtful));
  row("wrong", grouped(e.wrong));
  return {page.sheet.image(), picture.palette(settings.cells, settings.unneeded)};
}

}  // namespace xnewell
