#pragma once

#include <iosfwd>
#include <string>

#include "shading/explain/viewing_story.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What the viewing transformation does to a vertex and its plane, stage by stage, as text and as JSON.

void printViewing(const Picture& picture, const FaceCorner& vertex, std::ostream& out);
/// One JSON object with all digits. Lengths are in the unit that `unit` says, in the scene's units; matrices
/// are lists of rows.
void printViewingAsJson(const Picture& picture, const FaceCorner& vertex, std::ostream& out);

}  // namespace xnewell
