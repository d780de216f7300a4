#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "shading/color/images.h"
#include "shading/explain/viewing_story.h"
#include "shading/picture/picture.h"
#include "x11/drawing/painter.h"
#include "x11/viewing/view_controls.h"

namespace xnewell {

/// The scene at a stage of the viewing transformation, seen from outside: from a place that has nothing to do
/// with the scene's own camera. Its parallel projection keeps lines straight.

/// How the outside view is turned and how near it is.
struct OutsideTurn {
  double around = 62, down = 20;  ///< degrees
  double zoom = 1;
  bool operator==(const OutsideTurn&) const = default;
};

/// From a stage's space to pixels of an image: x right, y down, and z larger nearer.
struct OutsideCamera {
  glm::dmat3 turn{1.0};
  double scale = 1;
  glm::dvec2 shift{0};
  bool operator==(const OutsideCamera&) const = default;
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p) const {
    const glm::dvec3 q = turn * p;
    return {shift.x + scale * q.x, shift.y - scale * q.y, scale * q.z};
  }
};

/// The viewing volume at a stage.
struct StageVolume {
  std::array<glm::dvec3, 4> front, window, back;  ///< from the lower left corner, counter-clockwise
  std::optional<glm::dvec3> eye;  ///< PRP; none from the warp on, where it is at infinity or out of the way
  bool parallel = false;          ///< the projectors do not meet in the eye
  glm::dvec3 origin{0};           ///< of the stage's axes
};
[[nodiscard]] StageVolume volumeAt(const ViewingStory& story, const ViewSpec& view, ViewStage stage);
/// What the volume was before this stage, in its space: the unsheared pyramid, or the pyramid before the warp
/// as it was scaled. Nothing where the two do not compare.
[[nodiscard]] std::optional<StageVolume> volumeBefore(const ViewingStory& story, const ViewSpec& view,
                                                      ViewStage stage);

/// The vertices of a scene at the stages up to the warp. All drawings of a view share them.
class StagePoints {
 public:
  /// The mesh must outlive it.
  StagePoints(const Mesh& mesh, const ViewStages& stages);
  [[nodiscard]] const std::vector<glm::dvec3>& at(ViewStage stage) const {
    return stage == ViewStage::World ? mesh_.points : at_[static_cast<std::size_t>(stage) - 1];
  }
  /// False for a vertex that the warp throws too far away, because it is near the eye's own plane or behind.
  [[nodiscard]] bool staysNear(int vertex) const { return near_[static_cast<std::size_t>(vertex)] != 0; }

 private:
  const Mesh& mesh_;
  std::array<std::vector<glm::dvec3>, static_cast<std::size_t>(ViewStage::Warped)> at_;
  std::vector<std::uint8_t> near_;
};

/// The memory of an image, which the next one may use again.
struct StageMemory {
  IndexImage image;
  std::vector<float> depth;
  std::vector<int> face;
};

/// A picture of the faces with hidden ones left out, by a z-buffer.
class StageImage {
 public:
  /// Draws the scene. Up to the warp it has all faces; then those that are left after clipping and culling.
  /// It keeps the camera `held`, or fits the scene and the volume into the image, with at least this margin
  /// of pixels above and below.
  StageImage(const Picture& picture, const LitParts& lit, const ViewingStory& story,
             const StagePoints& points, ViewStage stage, const OutsideTurn& turn, glm::ivec2 size,
             std::uint8_t ground, int margin = 0, const OutsideCamera* held = nullptr,
             StageMemory memory = {});
  /// Gives its memory away; after that it has no pixels.
  [[nodiscard]] StageMemory release() { return {std::move(image_), std::move(depth_), std::move(face_)}; }

  [[nodiscard]] const IndexImage& image() const { return image_; }
  [[nodiscard]] const OutsideCamera& camera() const { return camera_; }
  [[nodiscard]] const StageVolume& volume() const { return volume_; }
  /// The face at a pixel; -1 if none is there.
  [[nodiscard]] int faceAt(int x, int y) const;
  /// True unless a face is in front of this place, which camera() made.
  [[nodiscard]] bool shows(const glm::dvec3& place) const;

 private:
  struct Corner {
    glm::dvec3 at;
    double I;
  };
  void place(const std::vector<glm::dvec3>& points, const OutsideTurn& turn, const glm::dmat3& axes,
             int margin);
  void addMesh(const Picture& picture, const LitParts& lit, const StagePoints& points, ViewStage stage);
  void addSnapped(const Picture& picture, const LitParts& lit, ViewStage stage);
  void polygon(const std::vector<Corner>& corners, const CellOnRamp* ramp, std::uint8_t cell, int face);
  void triangle(const Corner& a, const Corner& b, const Corner& c, const CellOnRamp* ramp, std::uint8_t cell,
                int face);

  IndexImage image_;
  std::vector<float> depth_;
  std::vector<int> face_;
  OutsideCamera camera_;
  StageVolume volume_;
};

}  // namespace xnewell
