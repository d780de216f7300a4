#pragma once

#include <cstdint>
#include <optional>

#include "shading/picture/picture.h"

namespace xnewell {

/// Makes pictures of one scene, one after the other. It keeps the last picture. The next one takes over every
/// result that is still valid. With a new colour table, it paints again from the stored intensities and does
/// not sort again.
class PictureCache {
 public:
  explicit PictureCache(Shared<Scene> scene) : scene_{std::move(scene)} {}
  /// All pictures have this camera, whatever their settings say of it.
  PictureCache(Shared<Scene> scene, const Camera& camera) : scene_{std::move(scene)}, camera_{camera} {}
  /// Begins with an existing picture, for example to try another method or order in the same view.
  explicit PictureCache(const Picture& last) : scene_{last.unlit_}, last_{last} {}

  /// Runs all stages of a picture. If `ground` is given, the image is painted, with that cell as its
  /// background. Otherwise no new image is painted, which saves most of the time. @throws ViewError, and
  /// TooManyPieces; the last picture then stays as it was.
  Picture make(const PictureSettings& settings, std::optional<std::uint8_t> ground = {});

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  /// True if the cache holds a picture.
  [[nodiscard]] bool hasLast() const { return last_.has_value(); }
  /// Precondition: hasLast().
  [[nodiscard]] const Picture& last() const { return *last_; }

 private:
  Shared<Scene> scene_;
  std::optional<Camera> camera_;
  std::optional<Picture> last_;
};

/// Makes a single picture of a scene.
[[nodiscard]] inline Picture makePicture(Scene scene, const PictureSettings& settings,
                                         std::optional<std::uint8_t> ground = {}) {
  return PictureCache{std::move(scene)}.make(settings, ground);
}

/// The settings without those that change only the colours in the cells (hue and bits). The indices of an
/// image depend on the rest.
[[nodiscard]] PictureSettings withoutColors(PictureSettings settings);

}  // namespace xnewell
