#pragma once

#include <cmath>
#include <vector>

#include "depthsort/box_grid.h"
#include "depthsort/region.h"
#include "geometry/view/project.h"
#include "geometry/view/screen_plane.h"

namespace xnewell {

/// Finds which regions own a sample of the picture. The sample rule is that of scanline.h: the centre of a
/// pixel, moved by an infinitely small (e, e^2), lies inside.

/// The sign of a line at the sample of pixel (i, j). It is never 0.
[[nodiscard]] int signAtSample(const SnappedScene& scene, const Line& line, int i, int j);

/// True if the region owns a sample of the picture. Exact. Work: #sides times #rows, so use it for thin
/// regions.
[[nodiscard]] bool ownsSample(const SnappedScene& scene, const Region& region, int width, int height);

/// False only if the face owns no sample. The answer is exact if the face's box holds at most four samples;
/// for a larger box it is true.
[[nodiscard]] bool mayOwnSample(const SnappedScene& scene, const SnappedFace& face, const ScreenBox& box,
                                int width, int height);
/// The same for a region.
[[nodiscard]] bool mayOwnSample(const SnappedScene& scene, const Region& region, const ScreenBox& box,
                                int width, int height);

/// False only if the face shows nowhere in the picture. `inPixels` is true if faces are painted with their
/// vertices rounded to pixels; then a face without a sample may show.
[[nodiscard]] bool mayShow(const SnappedScene& scene, const SnappedFace& face, const ScreenBox& box,
                           int width, int height, bool inPixels);

/// True if the face has an area after its vertices are rounded to pixels, as they are for XFillPolygon
/// (fill_polygons.h). Such a face may show there without owning a sample.
[[nodiscard]] bool hasAreaInPixels(const SnappedScene& scene, const SnappedFace& face);

/// True if twice the area over the diameter is more than kThin. A thinner region is a sliver that only the
/// rounding of the model's vertices makes. Computed in doubles.
inline constexpr double kThin = 64.0;  // in grid steps: 1/1024 of a pixel
[[nodiscard]] bool isWide(const Region& region);

/// Finds which face is seen at each sample. It decides each sample by itself: it compares every face that
/// covers the sample with the nearest face so far, in exact arithmetic. It makes no order of faces, so it
/// cannot sort or cut wrongly. It shares the snapped scene and the sample rule with the painter, but no code.
/// Work: one comparison for every sample of every face.
///
/// The result is exact for the snapped scene, which is not the model. Faces that only touch in the model are
/// separated by the rounding of the snap, and the oracle sees them apart. Only equal planes tie. Faces that
/// overlap in one plane of the model share one plane record (coplanar.h); other planes may happen to be equal
/// on the grid.
///
/// Returns for each sample an index into scene.faces or kNothing, row by row from the top. In a tie the later
/// face of the scene wins.
inline constexpr int kNothing = -1;
[[nodiscard]] std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height);

/// The depths of one face's plane, estimated in doubles. The estimate is good enough to separate the faces at
/// most samples.
class DepthEstimate {
 public:
  DepthEstimate(const SnappedScene& scene, const SnappedFace& face, const ScreenPlane& plane)
      : anchor_{scene.vertices[face.first]},
        z_{depthAt(plane, anchor_.x, anchor_.y)},
        dzdx_{static_cast<double>(plane.A) / static_cast<double>(plane.C)},
        dzdy_{static_cast<double>(plane.B) / static_cast<double>(plane.C)} {
    double reach = 0.0;
    for (int v = face.first; v < face.first + face.count; ++v) {
      const glm::dvec2 d = glm::dvec2{scene.vertices[v]} - glm::dvec2{anchor_};
      reach = std::max(reach, std::abs(dzdx_ * d.x) + std::abs(dzdy_ * d.y));
    }
    // Samples lie in the hull of the vertices, so each term is at most `reach`. A slope has at most three
    // roundings of 2^-53 and z has four; each product and each sum adds one. So no term has more than six
    // roundings, and 2^-50 allows eight, of reach + |z|.
    error_ = 0x1p-50 * (reach + std::abs(z_));
  }
  /// The depth at the centre of pixel (i, j). Its error is at most error().
  [[nodiscard]] double at(int i, int j) const {
    return dzdx_ * (kGrid * (i + 0.5) - anchor_.x) + (dzdy_ * (kGrid * (j + 0.5) - anchor_.y) + z_);
  }
  [[nodiscard]] double error() const { return error_; }

 private:
  glm::ivec3 anchor_;
  double z_, dzdx_, dzdy_, error_ = 0;
};

/// The same as visibleFaces() for a part of the rows. A large picture needs less memory, and less time, in
/// bands of rows.
class VisibleFaces {
 public:
  /// The scene must outlive this.
  explicit VisibleFaces(const SnappedScene& scene);
  /// The faces at the samples of the rows from `first` to before `end`.
  [[nodiscard]] std::vector<int> rows(int first, int end, int width);

 private:
  const SnappedScene& scene_;
  std::vector<DepthEstimate> estimates_;  ///< of each face
  std::vector<double> nearest_;           ///< of each sample: the estimated depth of the face that is seen
};

}  // namespace xnewell
