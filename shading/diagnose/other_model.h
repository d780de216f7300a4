#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "geometry/view/camera.h"
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

/// Where a program puts the points of a scene that goes about the viewing transformation in another way.

/// The steps of the viewing transformation. A mistake changes some of them.
///   perspective:  M S SH  R T(-from)     from: the eye
///   parallel:     S T SH  R T(-from)     from: VRP
/// Then come clipping, the division by w, and the viewport: x runs over size.x pixels from off.x.
struct ViewSteps {
  /// All lengths are in the units of the scene's file, which has `unit` of them in one of the camera's.
  ViewSteps(const Camera& camera, double unit, int width, int height);

  ViewSpec spec;
  glm::dvec3 eye{0}, lookAt{0}, from{0}, prp{0};
  glm::dmat4 M{1}, S{1}, T{1}, SH{1}, R{1};
  /// In place of R T(-from), and in place of the whole product.
  std::optional<glm::dmat4> view, all;
  glm::dvec2 size{0}, off{0};
  double aspect = 1, fov = 30;  ///< fov in degrees, of the window's height
  bool divides = true, clips = true, showsNothing = false;

  [[nodiscard]] bool isPerspective() const { return spec.projection == Projection::Perspective; }
  [[nodiscard]] glm::dmat4 clipFromVrc() const { return isPerspective() ? M * S * SH : S * T * SH; }
  [[nodiscard]] glm::dmat4 vrcFromWorld() const;
  [[nodiscard]] glm::dmat4 clipFromWorld() const;
  void scale(double x, double y) { S[0][0] *= x, S[1][1] *= y; }
  /// R with these axes as its rows.
  void turn(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& n);
};

struct ViewMistake {
  std::string_view key, sentence;
  void (*change)(ViewSteps&) = nullptr;
  bool isAllowed = false;
  /// True if faces lie less than a pixel off: only their edges tell.
  [[nodiscard]] bool isSmall() const { return key.starts_with("viewport-"); }
};
/// A row for each mistake; rows of one key are forms of one.
[[nodiscard]] std::span<const ViewMistake> viewMistakes();

/// A point on the screen: in pixels, y down; z, larger is nearer; w, which grows with the distance.
struct Placed {
  glm::dvec3 at{0};
  double w = 1;
  bool shows = false;  ///< false: behind the eye
};

/// Places points, and finds the face that each pixel shows.
class OtherView {
 public:
  OtherView(const ViewMistake& mistake, const Camera& camera, double unit, int width, int height);

  [[nodiscard]] Placed placed(const glm::dvec3& point) const {
    return onScreen(clip_ * glm::dvec4{point, 1.0});
  }
  /// What each pixel shows of convex polygons of points: the number of one, or kNothing; row by row.
  template <class Polygon>
  [[nodiscard]] std::vector<int> facesShown(int polygons, const Polygon& polygon) const {
    std::vector<int> shown(static_cast<std::size_t>(width_) * height_, -1);
    std::vector<double> nearest(shown.size(), -1e300);
    for (int k = 0; k < polygons && !steps_.showsNothing; ++k) paint(shown, nearest, k, polygon(k));
    return shown;
  }

 private:
  [[nodiscard]] Placed onScreen(const glm::dvec4& p) const;
  void paint(std::vector<int>& shown, std::vector<double>& nearest, int number,
             const std::vector<glm::dvec3>& polygon) const;

  ViewSteps steps_;
  glm::dmat4 clip_{1};
  int width_, height_;
};

}  // namespace xnewell
