#pragma once

#include <vector>

#include "shading/scene/settings.h"

namespace xnewell {

/// The rows of settingRows(), by what they are about.
[[nodiscard]] std::vector<Setting> methodRows();  ///< how a picture is made
[[nodiscard]] std::vector<Setting> lightRows();   ///< lights and surfaces
[[nodiscard]] std::vector<Setting> tableRows();   ///< the cells of the colour table

}  // namespace xnewell
