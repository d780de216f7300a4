#pragma once

#include "shading/picture/picture.h"
#include "shading/scene/settings.h"

namespace xnewell {

/// What decides whether settings have an effect on a picture that is made; for as long as the picture stays.
[[nodiscard]] PictureFacts factsOf(const Picture& picture);
/// The same after a change to `settings`, whose picture is not made yet.
[[nodiscard]] PictureFacts factsOf(const Picture& picture, const PictureSettings& settings);

/// Whether a surface of the scene wears a texture.
[[nodiscard]] bool hasTextures(const Scene& scene);

}  // namespace xnewell
