#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/view/project.h"
#include "shading/figure/figure.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Which parts of straight lines the faces of a scene hide.
///
/// A projection keeps lines straight and planes plane, also in depth. So the part of a line that a convex
/// face hides is an interval: where the line lies within each side of the face, and behind its plane. All of
/// these are linear along the line.
class HidingFaces {
 public:
  /// The scene must outlive this.
  HidingFaces(const SnappedScene& scene, int width, int height);

  using Interval = std::array<double, 2>;  ///< shares of the way from a to b
  /// The hidden parts of the line between two places of the snapped scene, apart and in ascending order. A
  /// face does not hide what lies in it, or nearer to it than its corners may be rounded.
  [[nodiscard]] std::vector<Interval> hidden(const glm::dvec3& a, const glm::dvec3& b) const;
  /// True if a face hides that place.
  [[nodiscard]] bool hides(const glm::dvec3& place) const;
  /// What intervals leave of [0, 1].
  [[nodiscard]] static std::vector<Interval> shown(const std::vector<Interval>& hidden);

 private:
  /// The part that one face hides; empty if it ends before it begins.
  [[nodiscard]] Interval hiddenBy(int face, const glm::dvec3& a, const glm::dvec3& b) const;
  struct Depth {
    double x, y, c, doubt;
  };
  [[nodiscard]] int cellOf(double at, int cells) const;

  const SnappedScene& scene_;
  std::vector<Depth> depths_;  ///< z of each face's plane over the screen
  double side_;                ///< of a cell of the grid over the page
  int columns_, rows_;
  std::vector<std::vector<int>> faces_;  ///< that may lie in each cell
};

/// The edges of the model's faces as strokes: what shows of them, and dashed what does not, if all are asked
/// for. Sides that only a division of a face, a clip or a split made are no edges.
[[nodiscard]] std::vector<FigureStroke> edgeStrokes(const SnappedScene& scene, const HidingFaces& faces,
                                                    ModelEdges edges);

/// Adds the parts of a line between two places of the snapped scene that faces do not hide, and to `unseen`
/// the others.
void addLine(const HidingFaces& faces, const glm::dvec3& a, const glm::dvec3& b, FigureStroke& seen,
             FigureStroke& unseen);

}  // namespace xnewell
