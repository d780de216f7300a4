#include "shading/picture/surface_evaluator.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "geometry/view/at_source.h"

namespace xnewell {

namespace {

/// The plane of a quantity over a triangle. Its value at vertex k is over[k] times ofCorner(corner) there.
template <class OfCorner>
PixelPlane planeOf(const SnappedScene& snapped, const FaceTriangle& t, const PixelPlanes& planes,
                   const std::array<double, 3>& over, const OfCorner& ofCorner) {
  std::array<double, 3> v;
  for (int k = 0; k < 3; ++k) v[k] = over[k] * atSource(snapped, snapped.source[t.vertex[k]], ofCorner);
  return planes(v);
}

}  // namespace

SurfaceEvaluator::SurfaceEvaluator(const Surfaces& surfaces, int channel)
    : s_{surfaces}, channel_{channel}, towardsViewer_{glm::transpose(vrcRotation(surfaces.view))[2]} {}

bool SurfaceEvaluator::evaluates(const SnappedFace& face) const {
  const Shading method = s_.settings.shading;
  return rowOf(method).lit && method != Shading::Environment && (method == Shading::Phong || textured(face));
}

bool SurfaceEvaluator::textured(const SnappedFace& face) const {
  if (s_.scene.textures.empty()) return false;
  const int material = s_.mesh.material[face.number];
  return material >= 0 && s_.mesh.materials[material].texture >= 0;
}

std::array<double, 3> SurfaceEvaluator::overDepths(const FaceTriangle& t) const {
  if (s_.view.projection == Projection::Parallel || s_.settings.mapping == TextureMapping::Affine)
    return {1.0, 1.0, 1.0};
  std::array<double, 3> depth;
  for (int k = 0; k < 3; ++k)
    depth[k] = atSource(s_.snapped, s_.snapped.source[t.vertex[k]], [&](int corner) {
      return s_.view.prp.z - glm::dot(towardsViewer_, s_.mesh.points[s_.mesh.corners[corner]] - s_.view.vrp);
    });
  // so that the unit of length does not matter
  const double least = std::min({depth[0], depth[1], depth[2]});
  if (!(least > 0.0)) return {1.0, 1.0, 1.0};  // the eye is nearer than its coordinates are rounded
  return {least / depth[0], least / depth[1], least / depth[2]};
}

PhongTriangle SurfaceEvaluator::phong(const SnappedFace& face, const FaceTriangle& t, int channel) const {
  const PixelPlanes planes{t.p};
  const std::array<double, 3> q = overDepths(t);
  const auto plane = [&](const auto& ofCorner) { return planeOf(s_.snapped, t, planes, q, ofCorner); };
  PhongTriangle e;
  e.i0 = planes.i0(), e.j0 = planes.j0(), e.q = planes(q);
  e.lighting = &s_.shading.lighting();
  e.material = &e.lighting->materials[s_.mesh.material[face.number] + 1];
  e.channel = channel;
  e.placed = e.lighting->placed();
  e.variesV = e.lighting->variesV();
  e.unitN = !keepsLengthOfN(s_.settings);
  const double side = s_.side(face);
  const auto normalPlane = [&](const auto& ofCorner) {
    return planeOf(s_.snapped, t, planes, e.unitN ? q : std::array{1.0, 1.0, 1.0}, ofCorner);
  };
  const auto place = [&](int corner) { return s_.mesh.points[s_.mesh.corners[corner]]; };
  // The nearest vertex: places over w grow with the distance from it, and at most to their size there.
  const auto nearest = std::ranges::max_element(q) - q.begin();
  if (e.placed) e.origin = atSource(s_.snapped, s_.snapped.source[t.vertex[nearest]], place);
  for (int axis = 0; axis < 3; ++axis) {
    e.N[axis] = normalPlane([&](int corner) {
      return side * s_.shading.points().N[s_.shading.vertices().ofCorner[corner]][axis];
    });
    if (e.placed) e.at[axis] = plane([&](int corner) { return place(corner)[axis] - e.origin[axis]; });
    if (e.variesV) e.V[axis] = plane([&](int corner) { return e.lighting->eye[axis] - place(corner)[axis]; });
  }
  if (textured(face)) addTexture(e, face, t, planes, q, channel);
  return e;
}

TermsTriangle SurfaceEvaluator::ambient(const SnappedFace& face, const FaceTriangle& t, int channel) const {
  const PixelPlanes planes{t.p};
  TermsTriangle e;
  e.i0 = planes.i0(), e.j0 = planes.j0();
  e.rest.c = s_.shading.lighting().materials[s_.mesh.material[face.number] + 1].ambient[channel];
  return e;
}

TermsTriangle SurfaceEvaluator::terms(const SnappedFace& face, const FaceTriangle& t, int channel) const {
  const PixelPlanes planes{t.p};
  const std::array<double, 3> q = overDepths(t);
  TermsTriangle e;
  e.i0 = planes.i0(), e.j0 = planes.j0(), e.q = planes(q);
  const Terms &diffuse = s_.shading.diffuse(channel), &specular = s_.shading.specular(channel);
  const Material& material = s_.shading.lighting().materials[s_.mesh.material[face.number] + 1];
  if (s_.settings.shading == Shading::Gouraud) {
    const auto plane = [&](const Terms& terms) {
      return planeOf(s_.snapped, t, planes, {1.0, 1.0, 1.0}, [&](int corner) {
        return terms[s_.shading.vertices().ofCorner[corner]].seen(face.back);
      });
    };
    e.diffuse = plane(diffuse);
    e.rest = plane(specular);
  } else {
    const int point = s_.shading.pointOf(face);
    e.diffuse.c = diffuse[point].seen(face.back);
    e.rest.c = specular[point].seen(face.back);
  }
  e.rest.c += material.ambient[channel];
  addTexture(e, face, t, planes, q, channel);
  return e;
}

void SurfaceEvaluator::addTexture(EvaluatedTriangle& e, const SnappedFace& face, const FaceTriangle& t,
                                  const PixelPlanes& planes, const std::array<double, 3>& q,
                                  int channel) const {
  const Mesh& mesh = s_.mesh;
  e.texture = &s_.scene.textures[mesh.materials[mesh.material[face.number]].texture];
  const bool rgb = s_.shading.lighting().channels == 3;
  e.texels = (rgb ? e.texture->channel[channel] : e.texture->gray).data();
  // Textures repeat, so a whole number is subtracted from the coordinates. This keeps them small.
  e.repeats = false;
  for (int axis = 0; axis < 2; ++axis) {
    const auto coordinate = [&](int corner) { return mesh.uv[mesh.uvOfCorner[corner]][axis]; };
    const auto at = [&](int k) { return atSource(s_.snapped, s_.snapped.source[t.vertex[k]], coordinate); };
    const auto [least, most] = std::minmax({at(0), at(1), at(2)});
    const double copy = std::floor(least);
    e.repeats = e.repeats || most - copy > 1.0;
    (axis == 0 ? e.u : e.v) =
        planeOf(s_.snapped, t, planes, q, [&](int corner) { return coordinate(corner) - copy; });
  }
}

}  // namespace xnewell
