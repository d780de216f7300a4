#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/picture/picture.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// How often each sample was painted. The painter's algorithm pays for its simplicity with what is painted
/// over; a method that decides at each sample paints each once. @see Foley & van Dam 2e §15.5

struct Overdraw {
  int width = 0;
  std::vector<int> times;    ///< of each sample, row by row
  std::int64_t painted = 0;  ///< their sum: the length of all spans
  std::int64_t samples = 0;  ///< painted at least once
  std::int64_t once = 0;     ///< of them, exactly once
  int most = 0;
  std::size_t mostAt = 0;  ///< index of the first sample that was painted most often
  /// Of the samples that show something; 0 where none does.
  [[nodiscard]] double mean() const {
    return samples == 0 ? 0.0 : static_cast<double>(painted) / static_cast<double>(samples);
  }
};
[[nodiscard]] Overdraw overdrawOf(const Picture& picture);

/// The map's steps: brighter where it was painted more often.
struct OverdrawStep {
  int most;  ///< times; the last has no end
  Cell cell;
  std::string_view label;
};
inline constexpr std::array kOverdrawSteps{
    OverdrawStep{1, Cell::WellLine, "once"}, OverdrawStep{2, Cell::Soft, "2"},
    OverdrawStep{3, Cell::Faint, "3"},       OverdrawStep{4, Cell::WellText, "4"},
    OverdrawStep{8, Cell::White, "5 to 8"},  OverdrawStep{1 << 30, Cell::Q, "more"},
};

[[nodiscard]] Finding findingOf(const Overdraw& overdraw, const Picture& picture);

/// Where nothing was painted it stays ground.
[[nodiscard]] IndexImage overdrawImage(const Overdraw& overdraw, const CellPlan& plan);

/// The map, the numbers, and what the order costs.
[[nodiscard]] ColoredImage drawOverdraw(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForOverdraw(const ViewSettings& settings);

}  // namespace xnewell
