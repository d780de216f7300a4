#include "shading/explain/pixel_place.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "shading/explain/pixel_history.h"

namespace xnewell {

namespace {

glm::dmat4 screenFromWorld(const Picture& picture) {
  const ViewSpec& view = picture.camera().view;
  return screenFromCanonical(view, picture.settings().width, picture.settings().height) *
         canonicalFromVrc(view) * vrcFromWorld(view);
}

}  // namespace

std::optional<glm::dvec3> placeSeen(const Picture& picture, int i, int j) {
  const PixelHistory history = historyOf(picture, i, j);
  if (history.shown < 0) return std::nullopt;
  const double z = history.painted[static_cast<std::size_t>(history.shown)].z;
  const glm::dvec4 place = glm::inverse(screenFromWorld(picture)) * glm::dvec4{i + 0.5, j + 0.5, z, 1.0};
  return glm::dvec3{place} / place.w;
}

std::optional<glm::dvec2> placeInPicture(const Picture& picture, const glm::dvec3& place) {
  const glm::dvec4 at = screenFromWorld(picture) * glm::dvec4{place, 1.0};
  if (!(at.w > 0.0)) return std::nullopt;
  return glm::dvec2{at} / at.w;
}

}  // namespace xnewell
