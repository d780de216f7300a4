#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "shading/picture/picture.h"

namespace xnewell {

/// From a pixel to the place of the scene that it shows, and back: two pictures of one scene, of other sizes
/// or cameras, show a place at other pixels.

/// The place of the surface that the sample of pixel (i, j) shows, in the world; nothing on the background.
[[nodiscard]] std::optional<glm::dvec3> placeSeen(const Picture& picture, int i, int j);

/// Where a place of the world is in the picture: columns to the right and rows down from the top left corner.
/// The pixel is the whole part. It may lie outside the picture. Nothing behind the eye.
[[nodiscard]] std::optional<glm::dvec2> placeInPicture(const Picture& picture, const glm::dvec3& place);

}  // namespace xnewell
