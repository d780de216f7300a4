#pragma once

#include <cstdint>
#include <vector>

#include "depthsort/depth_sort.h"
#include "geometry/view/project.h"
#include "geometry/view/view.h"
#include "shading/color/index_image.h"
#include "shading/fill/environment_map.h"
#include "shading/fill/evaluated.h"
#include "shading/fill/ramp.h"
#include "shading/picture/scene_shading.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// What one channel of a picture is painted from; all of it is the picture's, and outlives this.
struct Surfaces {
  int width = 0, height = 0;
  const SnappedScene& snapped;
  const SortedScene& sorted;
  const std::vector<int>& visible;  ///< not empty: the face seen at each sample, whatever is sorted
  const Scene& scene;
  const Mesh& mesh;  ///< the scene's, or what it was refined to
  const ViewSpec& view;
  const PictureSettings& settings;
  const SceneShading& shading;
  int channel = 0;
  std::vector<Ramp> ramps;                 ///< by material, of none first
  const std::vector<std::uint8_t>& cells;  ///< of snapped.faces, where each has one
};

/// Paints the faces of a picture, or pieces of them, one channel at a time. Whatever is interpolated belongs
/// to the face: a piece of it gets the same cells at the same samples.
class SurfacePainter {
 public:
  explicit SurfacePainter(const Surfaces& surfaces);

  /// Back to front, or what is visible.
  void paintAll(IndexImage& image);
  void paint(IndexImage& image, const Fragment& fragment);
  /// Whether a face's samples are evaluated one by one, and by what.
  [[nodiscard]] bool evaluates(const SnappedFace& face) const;
  [[nodiscard]] EvaluatedTriangle evaluated(const SnappedFace& face, const FaceTriangle& triangle);
  /// The least and the greatest cell at the samples of a face, whatever hides them; greatest < least where it
  /// has none.
  struct CellEnds {
    int least = 256, greatest = -1;
  };
  [[nodiscard]] CellEnds cellEnds(int face);
  /// Evaluations at pixels that were above 1.
  [[nodiscard]] std::int64_t clamped() const { return clamped_; }
  /// 1 / w at the vertices, w their depth along the viewing direction over the least of the three.
  [[nodiscard]] std::array<double, 3> overDepths(const FaceTriangle& triangle) const;

 private:
  /// Calls fill(outline, count, shader) for the parts of a face that have a shader of their own.
  template <class Fill>
  void shade(int face, Fill&& fill);
  void interpolateIntensity();
  void interpolateNormals();
  template <class Fill>
  void gouraud(const SnappedFace& face, const Ramp& ramp, Fill&& fill);
  template <class Fill>
  void environment(const SnappedFace& face, Fill&& fill);
  void paintVisible(IndexImage& image);
  [[nodiscard]] bool textured(const SnappedFace& face) const;

  /// The cells that an environment's two sides show; where it was clamped `mark` in place of `full`, within
  /// the boxes.
  struct Maps {
    std::vector<std::uint8_t> front, away;
    std::uint8_t mark, full;
    MapBox frontBox{front, mark}, awayBox{away, mark};
  };

  Surfaces s_;
  const Mesh& mesh_;
  const SnappedScene& snapped_;
  glm::dvec3 towardsViewer_;  ///< the direction against which depth grows, unit, world
  /// What a fill interpolates, in the steps of AffineOver, at snapped_.vertices: side by side, for in depth
  /// order each face lies elsewhere in memory.
  std::vector<std::uint32_t> steps_;  ///< of the intensity
  struct MapSteps {
    std::uint32_t column, row, facing;
  };
  std::vector<MapSteps> mapSteps_;
  std::vector<Maps> maps_;  ///< by material, of none first
  std::int64_t clamped_ = 0;
};

}  // namespace xnewell
