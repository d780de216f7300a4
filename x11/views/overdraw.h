#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/picture/picture.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/views/picture_sheet.h"

namespace xnewell {

/// How often each sample was painted. The painter's algorithm paints many samples more than once: this is the
/// price of its simplicity. A method that decides at each sample paints each once. @see Foley & van Dam 2e
/// §15.5

struct Overdraw {
  int width = 0;
  std::vector<int> times;    ///< of each sample, row by row
  std::int64_t painted = 0;  ///< the sum of these: the length of all spans
  std::int64_t samples = 0;  ///< samples painted at least once
  std::int64_t once = 0;     ///< samples painted exactly once
  int most = 0;
  std::size_t mostAt = 0;  ///< index of the first sample that was painted most often
  /// Mean over the samples that were painted; 0 if there are none.
  [[nodiscard]] double mean() const {
    return samples == 0 ? 0.0 : static_cast<double>(painted) / static_cast<double>(samples);
  }
};
[[nodiscard]] Overdraw overdrawOf(const Picture& picture);

/// The steps of the map: a sample is brighter the more often it was painted.
struct OverdrawStep {
  int most;  ///< times at most; the last step has no limit
  Cell cell;
  std::string_view label;
};
inline constexpr std::array kOverdrawSteps{
    OverdrawStep{1, Cell::WellLine, "once"}, OverdrawStep{2, Cell::Soft, "2"},
    OverdrawStep{3, Cell::Faint, "3"},       OverdrawStep{4, Cell::WellText, "4"},
    OverdrawStep{8, Cell::White, "5 to 8"},  OverdrawStep{1 << 30, Cell::Q, "more"},
};

[[nodiscard]] Finding findingOf(const Overdraw& overdraw, const Picture& picture);

/// Samples that were not painted stay background.
[[nodiscard]] IndexImage overdrawImage(const Overdraw& overdraw, const CellPlan& plan);

/// The map, its numbers, and what the order costs.
[[nodiscard]] Lens overdrawLens(const Picture& picture, const CellPlan& plan, const Palette& palette);

}  // namespace xnewell
