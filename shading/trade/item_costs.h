#pragma once

#include <functional>
#include <string>
#include <vector>

#include "shading/picture/picture.h"
#include "shading/trade/timing.h"

namespace xnewell {

/// What an item of requiredBy() costs is measured in one of two ways. Either the picture is made of another
/// scene, or with other settings, which do not require the item: the difference in time is its cost. Or the
/// item is a step of its own, which is done alone.
struct ItemRow {
  std::string_view name;  ///< as in Required
  /// Changes the scene and the settings so that the item is not required, and as little else as possible.
  void (*without)(Scene& scene, PictureSettings& settings) = nullptr;
  /// The step alone, if `without` is null.
  std::function<void()> (*alone)(const Picture& picture) = nullptr;
};
/// One row for each item.
[[nodiscard]] const std::vector<ItemRow>& itemRows();

/// What one item costs that a picture requires (required.h).
struct ItemCost {
  std::string_view name;
  /// Milliseconds of the processor: those of the step alone, or the median share of the picture's time that
  /// is saved without the item, times the picture's time; 0 if chance explains the difference.
  double ms = 0;
};
/// The picture as it is and without one item each run in turn. The costs do not add up to the picture's time:
/// without light, for example, there are no highlights either.
[[nodiscard]] std::vector<ItemCost> itemCostsOf(const Picture& picture, const TimingLimits& limits,
                                                const TimingProgress& goOn = {});

}  // namespace xnewell
