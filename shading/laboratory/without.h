#pragma once

#include <string_view>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// What an item of requiredBy() costs is measured in one of two ways. Either the picture is made of another
/// scene, or with other settings, which do not require the item: the difference in time is its cost. Or the
/// item is a step of its own, which is done alone.
struct CostRow {
  std::string_view name;  ///< as in Required
  /// Changes the scene and the settings so that the item is not required, and as little else as possible.
  void (*without)(Scene& scene, PictureSettings& settings) = nullptr;
  /// Does the step alone, if `without` is null. Returns its time in milliseconds, by a clock of them.
  double (*alone)(const Picture& picture, double (*clock)()) = nullptr;
};

/// One row for each item.
[[nodiscard]] const std::vector<CostRow>& costRows();

}  // namespace xnewell
