#include "shading/picture/surface_evaluator.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

#include "depthsort/oracle.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/view/at_source.h"
#include "shading/fill/row_values.h"

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

namespace {

/// Calls of(face) once for each face that is seen.
template <class Of>
void forEachSeenFace(const SeenRows& seen, std::size_t faces, Of&& of) {
  std::vector<bool> shows(faces, false);
  for (const int f : seen.faces)
    if (f != kNothing) shows[f] = true;
  for (std::size_t f = 0; f < faces; ++f)
    if (shows[f]) of(static_cast<int>(f));
}

/// Sets result = at(i, j) at the samples of an outline that show the face.
template <class Value, class At>
void store(std::vector<Value>& result, const SeenRows& seen, int face, const glm::ivec3* outline, int count,
           const At& at) {
  forEachSpan(outline, count, seen.firstRow, seen.width, seen.endRow(), [&](int row, int from, int to) {
    const std::size_t first = std::size_t(row - seen.firstRow) * seen.width;
    for (int i = from; i < to; ++i)
      if (seen.faces[first + i] == face) result[first + i] = at(i, row);
  });
}

/// Interpolates the vectors `v` at the vertices over a triangle.
auto interpolated(const PixelPlanes& planes, const std::array<glm::dvec3, 3>& v) {
  std::array<PixelPlane, 3> plane;
  for (int axis = 0; axis < 3; ++axis) plane[axis] = planes({v[0][axis], v[1][axis], v[2][axis]});
  return [=, i0 = planes.i0(), j0 = planes.j0()](int i, int j) {
    glm::dvec3 result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = plane[axis].c + plane[axis].gx * (i - i0) + plane[axis].gy * (j - j0);
    return result;
  };
}

/// The normals at the vertices of a triangle; ofCorner(corner) is that of a corner. They point to the side
/// that the light is computed for.
template <class OfCorner>
std::array<glm::dvec3, 3> normalsOf(const Surfaces& s, const SnappedFace& face, const FaceTriangle& t,
                                    const OfCorner& ofCorner) {
  const double side = s.side(face);
  std::array<glm::dvec3, 3> N;
  for (int k = 0; k < 3; ++k) N[k] = side * atSource(s.snapped, s.snapped.source[t.vertex[k]], ofCorner);
  return N;
}

/// The intensity in an environment's map, clamped to 1 but not rounded to a cell.
double lookedUp(const Environment& environment, const glm::dvec3& N) {
  const auto place = [](double v) { return static_cast<std::size_t>(kMapCentre + kMapScale * v); };
  const bool away = environment.twoMaps && N.z < 0.0;
  return std::min(1.0F, (away ? environment.away : environment.front)[256 * place(N.y) + place(N.x)]);
}

}  // namespace

std::vector<double> intensitiesAt(const SeenRows& seen, const Surfaces& s, int channel,
                                  const std::vector<double>& ofFaces) {
  std::vector<double> I(seen.faces.size(), std::numeric_limits<double>::quiet_NaN());
  const SurfaceEvaluator evaluator{s, channel};
  forEachSeenFace(seen, s.snapped.faces.size(), [&](int f) {
    const SnappedFace& face = s.snapped.faces[f];
    const glm::ivec3* const outline = &s.snapped.vertices[face.first];
    const auto fill = [&](const glm::ivec3* p, int count, const auto& at) {
      store(I, seen, f, p, count, [&](int i, int j) {
        const double value = at(i, j);
        assert(!std::isnan(value));
        return std::clamp(value, 0.0, 1.0);
      });
    };
    const auto atVertex = [&](int source) {
      return atSource(s.snapped, source, [&](int corner) {
        return s.shading.intensities(channel).I[s.shading.vertices().ofCorner[corner]].seen(face.back);
      });
    };

    if (evaluator.evaluates(face)) {
      evaluator.forEachEvaluated(face, [&](const FaceTriangle& t, const auto& e) {
        fill(t.p.data(), 3, [&](int i, int j) { return e.intensity(i, j); });
      });
    } else if (s.settings.shading == Shading::Gouraud && s.settings.polygons == Polygons::Rows &&
               face.count > 3) {
      std::vector<double> v;
      for (int k = face.first; k < face.first + face.count; ++k) v.push_back(atVertex(s.snapped.source[k]));
      const RowValues rows{outline, face.count, std::move(v)};
      fill(outline, face.count, [&](int i, int j) { return rows.at(i, j); });
    } else if (s.settings.shading == Shading::Gouraud) {
      forEachTriangle(s.snapped, face, [&](const FaceTriangle& t) {
        const PixelPlanes planes{t.p};
        const PixelPlane plane =
            planes({atVertex(s.snapped.source[t.vertex[0]]), atVertex(s.snapped.source[t.vertex[1]]),
                    atVertex(s.snapped.source[t.vertex[2]])});
        fill(t.p.data(), 3, [&](int i, int j) {
          return plane.c + plane.gx * (i - planes.i0()) + plane.gy * (j - planes.j0());
        });
      });
    } else if (s.settings.shading == Shading::Environment) {
      const Environment& environment =
          s.shading.environments(channel)[s.scene.mesh.material[face.number] + 1];
      forEachTriangle(s.snapped, face, [&](const FaceTriangle& t) {
        const auto mapped = [&](int corner) {
          return s.shading.mapped(channel)[s.shading.vertices().ofCorner[corner]];
        };
        const auto N = interpolated(PixelPlanes{t.p}, normalsOf(s, face, t, mapped));
        fill(t.p.data(), 3, [&](int i, int j) { return lookedUp(environment, N(i, j)); });
      });
    } else {
      fill(outline, face.count, [&](int, int) { return ofFaces[f]; });
    }
  });
  return I;
}

std::vector<glm::dvec3> normalsAt(const SeenRows& seen, const Surfaces& s) {
  std::vector<glm::dvec3> normals(seen.faces.size(), glm::dvec3{0.0});
  const SurfaceEvaluator evaluator{s, 0};
  const bool interpolates = rowOf(s.settings.shading).interpolates;
  std::optional<Vertices> made;  // only for this, if the picture needed none
  const Vertices& vertices = interpolates && s.shading.vertices().vertices.empty()
                                 ? made.emplace(smoothVertices(s.scene, s.settings))
                                 : s.shading.vertices();
  const auto ofCorner = [&](int corner) { return vertices.vertices[vertices.ofCorner[corner]].N; };
  forEachSeenFace(seen, s.snapped.faces.size(), [&](int f) {
    const SnappedFace& face = s.snapped.faces[f];
    if (interpolates) {
      forEachTriangle(s.snapped, face, [&](const FaceTriangle& t) {
        std::array<glm::dvec3, 3> ofVertices = normalsOf(s, face, t, ofCorner);
        if (s.settings.shading == Shading::Phong && !keepsLengthOfN(s.settings)) {
          const std::array<double, 3> q = evaluator.overDepths(t);
          for (int k = 0; k < 3; ++k) ofVertices[k] *= q[k];
        }
        const auto N = interpolated(PixelPlanes{t.p}, ofVertices);
        store(normals, seen, f, t.p.data(), 3, [&](int i, int j) { return unit(N(i, j)); });
      });
    } else {
      const glm::dvec3 N =
          s.side(face) * unit(newellVector(s.scene.mesh.points, s.scene.mesh.face(face.number)));
      store(normals, seen, f, &s.snapped.vertices[face.first], face.count, [&](int, int) { return N; });
    }
  });
  return normals;
}

}  // namespace xnewell
