#include "geometry/view/view.h"
#include "geometry/exact/scale.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace xnewell {

namespace {

glm::dmat4 translation(glm::dvec3 t) { return glm::translate(glm::dmat4{1.0}, t); }
glm::dmat4 scaling(glm::dvec3 s) { return glm::scale(glm::dmat4{1.0}, s); }

/// Keeps z and moves a point by (x, y) for every unit of z.
glm::dmat4 shearAlongZ(glm::dvec2 xy) {
  glm::dmat4 m{1.0};
  m[2][0] = xy.x;
  m[2][1] = xy.y;
  return m;
}

void check(bool holds, const char* otherwise) {
  if (!holds) throw ViewError{otherwise};
}

void checkSpec(const ViewSpec& s) {
  check(s.windowMin.x < s.windowMax.x && s.windowMin.y < s.windowMax.y,
        "the view window is empty: umin < umax and vmin < vmax are needed");
  check(s.prp.z > 0.0, "the projection reference point must lie in front of the view plane (n > 0)");
  check(s.front > s.back, "the front plane must lie nearer than the back plane (larger n)");
  check(s.projection == Projection::Parallel || s.front < s.prp.z,
        "the front plane must lie in front of the eye (n below the projection reference point's)");
}

/// The number of pixels that a world unit spans on the view plane, horizontally.
double pixelsPerUnit(const ViewSpec& s, int width) { return width / (s.windowMax.x - s.windowMin.x); }

}  // namespace

glm::dmat3 vrcRotation(const ViewSpec& s) {
  const glm::dvec3 n = unit(s.vpn);
  check(n != glm::dvec3{0.0}, "the view plane normal is zero; eye and look-at point must differ");
  const glm::dvec3 u = unit(glm::cross(unit(s.vup), n));
  check(u != glm::dvec3{0.0}, "the up vector is zero or along the view plane normal");
  const glm::dvec3 v = glm::cross(n, u);
  return {{u.x, v.x, n.x}, {u.y, v.y, n.y}, {u.z, v.z, n.z}};  // columns
}

ViewMatrices viewMatrices(const ViewSpec& s) {
  checkSpec(s);
  const glm::dvec2 centre = (s.windowMin + s.windowMax) / 2.0, size = s.windowMax - s.windowMin;
  const glm::dvec3 dop = glm::dvec3{centre, 0.0} - s.prp;  // direction of projection
  ViewMatrices m{.minusVrp = translation(-s.vrp),
                 .R = glm::dmat4{vrcRotation(s)},
                 .SH = shearAlongZ(-glm::dvec2{dop} / dop.z)};
  if (s.projection == Projection::Parallel) {
    // Centre the window at the front plane, scale to the volume.
    m.T = translation({-centre, -s.front});
    m.S = scaling({2.0 / size.x, 2.0 / size.y, 1.0 / (s.front - s.back)});
    return m;
  }
  // Move the eye to the origin, shear the window's centre line onto the n axis, scale the pyramid to |x|, |y|
  // <= -z <= 1.
  const double vrpZ = -s.prp.z, backZ = vrpZ + s.back, frontZ = vrpZ + s.front;
  m.minusPrp = translation(-s.prp);
  m.S = scaling({2.0 * vrpZ / (size.x * backZ), 2.0 * vrpZ / (size.y * backZ), -1.0 / backZ});
  // Warp the pyramid to the parallel volume: the front plane z = zmax goes to 0, and z = -1 stays.
  const double zmax = -frontZ / backZ;
  m.M[2][2] = 1.0 / (1.0 + zmax);
  m.M[3][2] = -zmax / (1.0 + zmax);
  m.M[2][3] = -1.0;
  m.M[3][3] = 0.0;
  return m;
}

glm::dmat4 vrcFromWorld(const ViewSpec& s) { return glm::dmat4{vrcRotation(s)} * translation(-s.vrp); }

glm::dmat4 canonicalFromVrc(const ViewSpec& s) {
  const ViewMatrices m = viewMatrices(s);
  return s.projection == Projection::Parallel ? m.S * m.T * m.SH : m.M * (m.S * m.SH * m.minusPrp);
}

double frontDepth(const ViewSpec& s, int width) {
  if (s.projection == Projection::Parallel) return pixelsPerUnit(s, width) * (s.front - s.back);
  // z + 1 = (1/d - 1/dB) / (1/dF - 1/dB) at distance d from the eye. Its slope at d = D must be
  // pixelsPerUnit.
  const double D = s.prp.z, dF = D - s.front, dB = D - s.back;
  return pixelsPerUnit(s, width) * D * D * (1.0 / dF - 1.0 / dB);
}

glm::dmat4 screenFromCanonical(const ViewSpec& s, int width, int height) {
  const double zFront = frontDepth(s, width);
  return scaling({width / 2.0, -height / 2.0, zFront}) * translation({1.0, -1.0, 1.0});
}

}  // namespace xnewell
