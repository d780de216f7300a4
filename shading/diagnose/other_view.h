#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/view/camera.h"

namespace xnewell {

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
