#pragma once
#include "shading/views.h"
[[nodiscard]] ColoredImage drawDifference(Picture& picture, const ViewSettings& settings);
