#pragma once

#include <array>
#include <vector>

#include "geometry/view/at_source.h"
#include "shading/course/course.h"
#include "shading/explain/equation_at.h"
#include "shading/explain/term_values.h"
#include "shading/fill/fill.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// A sample on its face: the vertices around it, their weights, and the texel. The method of the picture says
/// which of these count.

/// The texel under a sample.
struct ExplainedTexel {
  double u = 0, v = 0;
  int column = 0, row = 0;
  ByChannel share{};  ///< what it leaves of the diffuse term, 0 to 1
};

class OnFace {
 public:
  /// `face` is one of the picture's snapped().faces.
  OnFace(const Surfaces& surfaces, const SnappedFace& face);

  [[nodiscard]] const SnappedFace& face() const { return face_; }
  [[nodiscard]] int material() const { return s_.mesh.material[face_.number]; }
  [[nodiscard]] bool onlyAmbient() const { return s_.shading.lighting().onlyAmbient(); }
  [[nodiscard]] bool isTextured() const;
  /// True if values are interpolated along the edges and the row of the whole polygon.
  [[nodiscard]] bool byRows() const;

  /// Goes to the sample of pixel (i, j), which the face owns.
  void moveTo(int i, int j);

  /// Indices into snapped().vertices: of the triangle around the sample; by rows, of the whole polygon.
  [[nodiscard]] const std::vector<int>& vertices() const { return vertices_; }
  [[nodiscard]] const Weights& onScreen() const { return onScreen_; }  ///< not by rows
  [[nodiscard]] const Weights& inWorld() const { return inWorld_; }    ///< not by rows
  /// The weights of the normals: those in the world, because N is made a unit vector, so that the length of
  /// the sum does not matter. A method that keeps the length has those on the screen.
  [[nodiscard]] const Weights& ofNormals() const {
    return keepsLengthOfN(s_.settings) ? onScreen_ : inWorld_;
  }

  [[nodiscard]] glm::dvec3 placeOf(int corner) const { return s_.mesh.points[s_.mesh.corners[corner]]; }
  /// Towards the side that is lit; 0 where all light is ambient.
  [[nodiscard]] glm::dvec3 normalOf(int corner) const;
  /// A value at a vertex: of(corner), or between two of these where clipping made the vertex.
  template <class OfCorner>
  [[nodiscard]] auto atVertex(int vertex, const OfCorner& of) const {
    return atSource(s_.snapped, s_.snapped.source[vertex], of);
  }
  /// The unit normal and the place that flat shading evaluates; 0 where it needs none.
  struct Centroid {
    glm::dvec3 P{0}, N{0};
  };
  [[nodiscard]] Centroid centroid() const;
  /// The sum of the vertices' normals, each times its weight.
  [[nodiscard]] glm::dvec3 sumOfNormals() const;
  /// What Phong shading evaluates: that sum as a unit vector, unless its length is kept.
  [[nodiscard]] glm::dvec3 normal() const;
  [[nodiscard]] glm::dvec3 place() const;
  /// Precondition: isTextured().
  [[nodiscard]] ExplainedTexel texel(int channels) const;

  /// Interpolates over the triangle on the screen; by rows, along the edges and the row. of(k) is the value
  /// at vertices()[k].
  template <class OfVertex>
  [[nodiscard]] double valueHere(const OfVertex& of) const {
    if (!byRows()) return interpolated(onScreen_, std::array{of(0), of(1), of(2)});
    std::vector<double> v;
    for (std::size_t k = 0; k < vertices_.size(); ++k) v.push_back(of(k));
    return alongRow(s_.snapped, face_, v, i_, j_);
  }

 private:
  Surfaces s_;
  const SnappedFace& face_;
  SurfaceEvaluator evaluator_;
  int i_ = 0, j_ = 0;
  std::vector<int> vertices_;
  Weights onScreen_{}, inWorld_{};
};

/// What was painted at one pixel, in which order, and which face should show there.

struct PaintedHere {
  Fragment fragment;  ///< a face, or a piece of one that the depth sort cut
  double z = 0;       ///< its depth at the sample, in pixels of the view plane; larger is nearer
};

struct PixelHistory {
  /// In the order of painting, so the last one shows. An order that decides each sample by itself paints one
  /// face alone; here are all the faces at the sample, as they were looked at, and `shown` says which won.
  std::vector<PaintedHere> painted;
  int shown = -1;  ///< index into `painted`; -1 if no face shows
  /// Faces at the sample that were not painted: the quick depth sort drops what shows nowhere.
  int notPainted = 0;
  SampleCheck check = SampleCheck::Nothing;  ///< is the right face shown?
  int nearest = -1;  ///< the face that should show, an index into snapped().faces; -1 if there is none
};

/// 0 <= i < width, 0 <= j < height. Work: about one edge test for each face of the picture.
[[nodiscard]] PixelHistory historyOf(const Picture& picture, int i, int j);

}  // namespace xnewell
