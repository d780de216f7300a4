#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/color/images.h"
#include "shading/fill/environment.h"
#include "shading/fill/ramp.h"
#include "shading/picture/surface_evaluator.h"

namespace xnewell {

/// Paints the faces of a picture, or pieces of them, one channel at a time. Interpolation uses the whole
/// face, so a piece gets the same cells as the face at the same samples.
class SurfacePainter {
 public:
  /// `ramps` are by material; the first is for faces without a material. `cells` has the cell of each of
  /// snapped.faces, if the method gives each face a single cell. `surfaces` and `cells` must outlive the
  /// painter.
  SurfacePainter(const Surfaces& surfaces, int channel, std::vector<Ramp> ramps,
                 std::span<const std::uint8_t> cells);

  /// Paints all fragments, back to front.
  void paintAll(IndexImage& image, const SortedScene& sorted);
  /// Paints at each sample the face that is visible there. `visible` is row by row.
  void paintVisible(IndexImage& image, const std::vector<int>& visible);
  void paint(IndexImage& image, const SortedScene& sorted, const Fragment& fragment);
  /// True if the samples of a face are evaluated one by one.
  [[nodiscard]] bool evaluates(const SnappedFace& face) const { return evaluator_.evaluates(face); }
  /// The least and the greatest cell at the samples of a face in a picture of that size, even where other
  /// faces hide it. greatest < least if the face has no sample.
  struct CellEnds {
    int least = 256, greatest = -1;
  };
  [[nodiscard]] CellEnds cellEnds(int face, int width, int height);
  /// The number of evaluations at pixels that exceeded 1.
  [[nodiscard]] std::int64_t clamped() const { return clamped_; }

 private:
  /// Calls fill(outline, count, shader) for each part of a face that has its own shader.
  template <class Fill>
  void forEachShader(int face, Fill&& fill);
  void interpolateIntensity();
  void interpolateNormals();
  template <class Fill>
  void gouraud(const SnappedFace& face, const Ramp& ramp, Fill&& fill);
  template <class Fill>
  void environment(const SnappedFace& face, Fill&& fill);

  /// The cells of an environment's two maps. Where the intensity was clamped, a map has `mark` instead of
  /// `full`. Each box encloses all places of its map that have a mark.
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
  /// The quantities that a fill interpolates, in the steps of AffineOver, one for each of snapped_.vertices.
  /// Those of a face lie side by side, because faces in depth order are scattered in memory.
  std::vector<std::uint32_t> steps_;  ///< the intensity
  struct MapSteps {
    std::uint32_t column, row, facing;
  };
  std::vector<MapSteps> mapSteps_;
  std::vector<Maps> maps_;  ///< by material; the first is for faces without one
  std::int64_t clamped_ = 0;
};

}  // namespace xnewell
