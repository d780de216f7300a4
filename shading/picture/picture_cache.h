#pragma once

#include <cstdint>
#include <optional>

#include "shading/picture/picture.h"

namespace xnewell {

/// Makes pictures of one scene, one after the other. It keeps the last one: what that can lend to the next
/// is not computed again. A new colour table paints again from the stored intensities and sorts nothing.
class PictureCache {
 public:
  explicit PictureCache(Scene scene) : scene_{std::move(scene)} {}
  /// Begins with a picture that somebody else made: for another method or order of the same view.
  explicit PictureCache(const Picture& last) : scene_{last.scene_}, last_{last} {}

  /// The walk through one picture. With a ground cell the image is painted on it; without, the picture has
  /// no new image, which saves most of the time. @throws ViewError, and then the last picture stays.
  Picture make(const PictureSettings& settings, std::optional<std::uint8_t> ground = {});

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  /// Whether a picture was made.
  [[nodiscard]] bool hasLast() const { return last_.has_value(); }
  /// Precondition: hasLast().
  [[nodiscard]] const Picture& last() const { return *last_; }

 private:
  Shared<Scene> scene_;
  std::optional<Picture> last_;
};

/// A single picture of a scene.
[[nodiscard]] inline Picture makePicture(Scene scene, const PictureSettings& settings,
                                         std::optional<std::uint8_t> ground = {}) {
  return PictureCache{std::move(scene)}.make(settings, ground);
}

/// The settings without the colours that the cells hold: what the indices of an image depend on.
[[nodiscard]] PictureSettings withoutColors(PictureSettings settings);

}  // namespace xnewell
