#pragma once

#include <iosfwd>
#include <string>

#include "shading/explain/viewing_story.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What the viewing transformation does to a vertex and its plane, stage by stage, as text and as JSON.

/// The vertex of --viewing; "" is one in the middle of the picture. @throws UsageError if there is none
[[nodiscard]] FaceCorner vertexOf(const Picture& picture, const std::string& text);

void printViewing(const Picture& picture, const FaceCorner& vertex, std::ostream& out);
/// One JSON object with all digits. Lengths are in the unit that `unit` says, in the scene's units; matrices
/// are lists of rows.
void printViewingAsJson(const Picture& picture, const FaceCorner& vertex, std::ostream& out);

}  // namespace xnewell
