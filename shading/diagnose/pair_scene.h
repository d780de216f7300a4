#pragma once

#include <span>
#include <string>

#include "shading/diagnose/judge_order.h"

namespace xnewell {

/// "face 17", or "a piece of face 17".
[[nodiscard]] std::string stepName(const PaintStep& step);

/// The text of a scene file with the two polygons of the first wrong pair alone, in the same view, painted as
/// they are listed: `xnewell draw` shows the mistake again.
[[nodiscard]] std::string pairAsScene(const Picture& picture, const WrongPair& pair,
                                      std::span<const PaintStep> steps);

}  // namespace xnewell
