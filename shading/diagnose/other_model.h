#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "shading/diagnose/approach.h"
#include "shading/light/equation.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// A scene as another program for the assignment has it: places in the units of the file, normals of faces
/// and vertices by each way to make them. It shares the camera and the snapped outlines with the picture, and
/// nothing of its shading.
class OtherModel {
 public:
  /// The picture has planes or not; it must outlive this.
  explicit OtherModel(const Picture& picture);

  [[nodiscard]] const Picture& picture() const { return picture_; }
  [[nodiscard]] const Mesh& mesh() const { return picture_.scene().mesh; }
  [[nodiscard]] const SnappedScene& snapped() const { return picture_.snapped(); }

  [[nodiscard]] const glm::dvec3& place(int corner) const { return points_[mesh().corners[corner]]; }
  /// Where flat shading evaluates a face.
  [[nodiscard]] glm::dvec3 centroid(int face, CentroidWay way) const;
  /// The normal of a face, before it is turned to a side.
  /// `from` is the first of three corners.
  [[nodiscard]] glm::dvec3 faceNormal(int face, NormalWay way, int from = 0) const;
  /// The normals at all corners, before they are turned to a side; made when they are first asked for.
  [[nodiscard]] const std::vector<glm::dvec3>& cornerNormals(const Approach& way);
  /// True if the viewer sees the back of a face.
  [[nodiscard]] bool isBack(int face) const;
  /// The faces at each point.
  [[nodiscard]] const std::vector<std::vector<int>>& facesAt() const { return facesAt_; }
  // In the units of the file.
  glm::dvec3 eye{0}, lookAt{0}, centre{0};
  std::vector<Light> lights;  ///< places in the file's units; range and c in the scene's
  double unit = 1;            ///< file units in a unit of the scene
  std::array<double, 3> Ia{};
  int channels = 1;        ///< 3: red, green and blue
  bool luminance = false;  ///< one hue shows the luminance of the three
  bool colors = false;     ///< the cells hold several hues
  bool ramps = false;      ///< each hue has a ramp of its own (ColorPlan::Hues)
  /// By material, the first is for faces without one; by channel.
  std::vector<std::array<Reflection, 3>> surface;
  /// Where the corners are: in pixels if they are in view, and their distance from the eye along the viewing
  /// direction (1 in a parallel view).
  struct Places {
    std::vector<std::optional<glm::dvec2>> onScreen;
    std::vector<double> depth;
  };
  /// By a view; null for that of the picture.
  [[nodiscard]] const Places& placesOf(const ViewMistake* view);
  /// A light's place, not moved where all else is in viewing coordinates: seen from P, in the world.
  [[nodiscard]] glm::dvec3 notMoved(const glm::dvec3& place, bool far, const glm::dvec3& P) const;
  std::vector<double> byDepth;  ///< of each snapped face, for shading by depth

 private:
  [[nodiscard]] std::vector<glm::dvec3> makeCornerNormals(const Approach& way) const;
  [[nodiscard]] glm::dvec3 mapped(NormalWay way, const glm::dvec3& N) const;
  [[nodiscard]] const std::vector<glm::dvec3>& pointsFor(NormalWay way) const;

  const Picture& picture_;
  std::vector<glm::dvec3> points_;  ///< in file units
  /// After projection: z in [-1, 0]; z along the viewing direction; and x and y in pixels, too.
  std::array<std::vector<glm::dvec3>, 3> projected_;
  std::vector<std::vector<int>> facesAt_;
  glm::dmat3 rotation_{1.0}, scaling_{1.0};  ///< to VRC; there, by S SH
  std::map<const ViewMistake*, Places> places_;
  glm::dvec3 towardsViewer_{0};
  std::map<std::tuple<std::optional<NormalRule>, VertexWay, NormalWay>, std::vector<glm::dvec3>>
      cornerNormals_;
};

}  // namespace xnewell
