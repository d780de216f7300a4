#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/color/index_image.h"
#include "shading/fill/environment_map.h"
#include "shading/fill/ramp.h"
#include "shading/picture/surface_evaluator.h"

namespace xnewell {

/// Paints the faces of a picture, or pieces of them, one channel at a time. Whatever is interpolated belongs
/// to the face: a piece of it gets the same cells at the same samples.
class SurfacePainter {
 public:
  /// `ramps` by material, of none first. `cells` of snapped.faces, where each has one; they outlive this.
  SurfacePainter(const Surfaces& surfaces, int channel, std::vector<Ramp> ramps,
                 std::span<const std::uint8_t> cells);

  /// Back to front.
  void paintAll(IndexImage& image, const SortedScene& sorted);
  /// The face seen at each sample, row by row.
  void paintVisible(IndexImage& image, const std::vector<int>& visible);
  void paint(IndexImage& image, const SortedScene& sorted, const Fragment& fragment);
  /// Whether a face's samples are evaluated one by one.
  [[nodiscard]] bool evaluates(const SnappedFace& face) const { return evaluator_.evaluates(face); }
  /// The least and the greatest cell at the samples of a face in a picture of that size, whatever hides them;
  /// greatest < least where it has none.
  struct CellEnds {
    int least = 256, greatest = -1;
  };
  [[nodiscard]] CellEnds cellEnds(int face, int width, int height);
  /// Evaluations at pixels that were above 1.
  [[nodiscard]] std::int64_t clamped() const { return clamped_; }

 private:
  /// Calls fill(outline, count, shader) for the parts of a face that have a shader of their own.
  template <class Fill>
  void forEachShader(int face, Fill&& fill);
  void interpolateIntensity();
  void interpolateNormals();
  template <class Fill>
  void gouraud(const SnappedFace& face, const Ramp& ramp, Fill&& fill);
  template <class Fill>
  void environment(const SnappedFace& face, Fill&& fill);

  /// The cells of an environment's two maps: `mark` in place of `full` where the intensity was clamped. The
  /// boxes hold all places with a mark.
  struct Maps {
    std::vector<std::uint8_t> front, away;
    std::uint8_t mark, full;
    MapBox frontBox{front, mark}, awayBox{away, mark};
  };

  Surfaces s_;
  const Mesh& mesh_;
  const SnappedScene& snapped_;
  SurfaceEvaluator evaluator_;
  int channel_;
  std::vector<Ramp> ramps_;
  std::span<const std::uint8_t> cells_;
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
