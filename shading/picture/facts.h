#pragma once

#include "shading/picture/picture.h"
#include "shading/scene/settings.h"

namespace xnewell {

/// The facts that decide whether a setting has an effect on this picture. They refer to the picture's
/// settings, so the picture must outlive them.
[[nodiscard]] PictureFacts factsOf(const Picture& picture);
/// The same facts after a change to `settings`, before the new picture is made.
[[nodiscard]] PictureFacts factsOf(const Picture& picture, const PictureSettings& settings);

/// True if a surface of the scene has a texture.
[[nodiscard]] bool hasTextures(const Scene& scene);

}  // namespace xnewell
