#include "shading/extremes/extreme_ways.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"
#include "geometry/model/bezier.h"
#include "geometry/model/coplanar.h"
#include "shading/extremes/extremes.h"
#include "shading/fill/evaluated.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

/// Powers of 2, or of 10 as the decimal numbers are read: std::pow() may round otherwise.
std::vector<double> powers(int base, int from, int to, int step) {
  std::vector<double> values;
  for (int k = from; step > 0 ? k <= to : k >= to; k += step) {
    const std::string decimal = "1e" + std::to_string(k);
    double power = std::ldexp(1.0, k);
    if (base == 10) std::from_chars(decimal.data(), decimal.data() + decimal.size(), power);
    values.push_back(power);
  }
  return values;
}

/// The patches after an affine map. There are none if rounding lets so many of their points coincide that
/// they no longer make the faces of the mesh.
std::vector<PatchRun> patchesAfter(const Scene& from, const std::function<glm::dvec3(glm::dvec3)>& map) {
  std::vector<PatchRun> patches = from.patches;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    PatchRun& run = patches[k];
    for (BezierPatch& patch : run.patches)
      for (glm::dvec3& p : patch.p) p = map(p);
    const auto corners = [](const PatchRun& r) { return cornerNormals(r.patches, r.divisions).size(); };
    if (corners(run) != corners(from.patches[k])) return {};
  }
  return patches;
}

/// The scene after an affine map of its points, in the file's units. Lengths grow by `scale`.
Case mapped(const Start& start, double scale, const std::function<glm::dvec3(glm::dvec3)>& map) {
  const Scene& from = start.scene;
  Mesh mesh = from.mesh;
  for (glm::dvec3& p : mesh.points) {
    p = map(inFileUnits(p, from));
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(p[axis])) throw ViewError{"the coordinates are out of the range of doubles"};
  }
  // The map moves a normal as a difference. It is made as long as the places are, so that rounding spares it.
  const glm::dvec3 zero = map(glm::dvec3{0.0});
  const double far = std::max(1.0, largest(glm::abs(zero)));
  for (glm::dvec3& N : mesh.normals) N = unit(map(far * N) - zero);
  for (double& u : mesh.rounding) u = std::ldexp(u, from.exponent) * scale;
  Case moved{makeScene(from.name, std::move(mesh), from.up, from.divisions), start.settings};
  Scene& to = moved.scene;
  to.patches = patchesAfter(from, map);
  to.textures = from.textures;
  to.light = from.light;
  to.light.unit = std::ldexp(std::ldexp(from.light.unit, from.exponent) * scale, -to.exponent);
  const auto fade = [](glm::dvec3& c, double length) { c = {c.x, c.y / length, c.z / length / length}; };
  const double length = std::ldexp(scale, from.exponent - to.exponent);
  for (Light& light : to.light.lights) {
    light.position = inSceneUnits(map(inFileUnits(light.position, from)), to), light.range *= length;
    fade(light.c, length);
  }
  Illumination& user = moved.settings.light;
  if (user.lightPosition) user.lightPosition = map(*user.lightPosition);
  if (user.range) *user.range *= scale;
  if (user.c) {
    const glm::dvec3 before = *user.c;
    fade(*user.c, scale);
    for (int k = 0; k < 3; ++k)
      if (before[k] != 0 && !std::isnormal((*user.c)[k]))
        throw ViewError{"c1, c2 and c3 are out of the range of doubles"};
  }
  CameraSettings& camera = moved.settings.camera;
  for (std::optional<glm::dvec3>* p : {&camera.eye, &camera.lookAt, &camera.vrp})
    if (*p) *p = map(**p);
  if (camera.prp) *camera.prp *= scale;
  for (std::optional<double>* v : {&camera.height, &camera.front, &camera.back})
    if (*v) **v *= scale;
  if (camera.window) *camera.window *= scale;
  return moved;
}

Case sameWith(const Start& start, const std::function<void(Case&)>& change) {
  Case changed{start.scene, start.settings};
  change(changed);
  return changed;
}

Case withSettings(const Start& start, const std::function<void(PictureSettings&)>& change) {
  return sameWith(start, [&](Case& c) { change(c.settings); });
}

/// The eye and the point that it looks at are in the scene's units.
CameraSettings perspective(const Start& start, glm::dvec3 eye, glm::dvec3 lookAt, std::optional<double> fov) {
  CameraSettings camera;
  camera.eye = inFileUnits(eye, start.scene), camera.lookAt = inFileUnits(lookAt, start.scene);
  camera.up = start.camera.up, camera.fov = fov;
  return camera;
}

Case multiplied(const Start& start, double v) {
  return mapped(start, v, [v](glm::dvec3 p) { return v * p; });
}

/// A second copy of all faces, moved towards the eye.
Case withLayer(const Start& start, double distance) {
  return sameWith(start, [&](Case& c) {
    const Mesh& single = start.scene.mesh;
    const glm::dvec3 nearer = distance * unit(start.camera.eye - start.camera.lookAt);
    Mesh both = single;
    const int points = static_cast<int>(single.points.size()), uvs = static_cast<int>(single.uv.size());
    for (const glm::dvec3& p : single.points) both.points.push_back(p + nearer);
    for (const glm::dvec2& uv : single.uv) both.uv.push_back(uv);
    for (int f = 0; f < single.faceCount(); ++f) {
      std::vector<int> corners{single.face(f).begin(), single.face(f).end()}, uv;
      for (int& p : corners) p += points;
      if (!single.uvOfCorner.empty())
        for (int k = single.firstCorner[f]; k < single.firstCorner[f + 1]; ++k)
          uv.push_back(single.uvOfCorner[k] < 0 ? -1 : single.uvOfCorner[k] + uvs);
      both.addFace(corners, single.group[f], single.material[f], uv, single.normalsOf(f));
    }
    c.scene.mesh = std::move(both);
    c.scene.patches.clear();
    c.scene.parts = divideFaces(c.scene.mesh);
    uniteCoplanar(c.scene.mesh, c.scene.parts);
  });
}

/// The whole scene, seen with this field of view.
CameraSettings narrowed(const Start& start, double fov) {
  CameraSettings camera;
  camera.up = start.settings.camera.up, camera.fov = fov;
  return camera;
}

/// What two doubles have between them where the scene is, if it is moved by this, in its units.
double stepAt(const Start& start, glm::dvec3 by) {
  Box moved;
  const Box box = boxOf(start.scene.mesh.points);
  moved.add(box.low + by), moved.add(box.high + by);
  const double most = moved.magnitude();
  return std::nextafter(most, HUGE_VAL) - most;
}

/// How deep the scene is, seen with this field of view, as a share of its middle's distance from the eye.
double depthOf(const Start& start, double fov) {
  const double aspect = static_cast<double>(start.settings.width) / start.settings.height;
  const Camera camera = placeCamera(start.scene, narrowed(start, fov), aspect);
  const glm::dvec3 away = unit(camera.lookAt - camera.eye);
  double nearest = HUGE_VAL, farthest = -HUGE_VAL;
  for (const glm::dvec3& p : start.scene.mesh.points) {
    const double distance = glm::dot(away, p - camera.eye);
    nearest = std::min(nearest, distance), farthest = std::max(farthest, distance);
  }
  return (farthest - nearest) / ((farthest + nearest) / 2);
}

PictureSettings& phong(PictureSettings& settings) {
  settings.shading = Shading::Phong;
  return settings;
}

/// By powers of `base` up to this one.
Way scaled(int base, int to) {
  const bool two = base == 2;
  const int step = two ? 100 : 30;
  return {.name = to > 0 ? "scaled up by" : "scaled down by",
          .unit = two ? "(powers of two)" : "(powers of ten)",
          .drives = two ? "All coordinates are multiplied by a power of two."
                        : "All coordinates are multiplied by a power of ten, which rounds them.",
          .values = powers(base, 0, to, to > 0 ? step : -step),
          .changesNothing = true,
          .at = multiplied,
          .why = [two](const Start&, double) -> std::string {
            return two ? "Multiplying by a power of two is exact." : "The products are rounded by 2^-53.";
          }};
}

}  // namespace

const std::vector<Way>& extremeWays() {
  static const std::vector<Way> all{
      scaled(2, 900),
      scaled(2, -900),
      scaled(10, 270),
      scaled(10, -270),
      {.name = "moved by",
       .unit = "times its size",
       .drives = "All coordinates are moved by (d, -d, d), and so is the camera.",
       .values =
           [] {
             std::vector<double> values = powers(10, 0, 15, 1);
             values.insert(values.begin(), 0.0);
             return values;
           }(),
       .changesNothing = true,
       .at =
           [](const Start& s, double v) {
             const double d = v * std::ldexp(s.size, s.scene.exponent);
             return mapped(s, 1, [d](glm::dvec3 p) { return p + glm::dvec3{d, -d, d}; });
           },
       .why =
           [](const Start& s, double v) {
             const double d = v * s.size;
             return "Doubles this far from the origin are " + shortly(stepAt(s, {d, -d, d}) / s.pixel) +
                    " pixels apart.";
           }},
      {.name = "field of view down to",
       .unit = "degrees",
       .drives = "The field of view narrows; the eye moves back so that the scene stays in view.",
       .values = {30, 10, 3, 1, 0.3, 0.1, 0.03, 0.01},
       .at = [](const Start& s,
                double v) { return withSettings(s, [&](PictureSettings& p) { p.camera = narrowed(s, v); }); },
       .why =
           [](const Start& s, double v) {
             return "The scene's depth is only " + shortly(depthOf(s, v)) +
                    " of its distance; the depth of a sample keeps 30 bits.";
           }},
      {.name = "field of view up to",
       .unit = "degrees",
       .drives = "The field of view widens around the same eye.",
       .values = {30, 60, 90, 120, 150, 170, 179, 179.9},
       .at =
           [](const Start& s, double v) {
             return withSettings(
                 s, [&](PictureSettings& p) { p.camera = perspective(s, s.camera.eye, s.camera.lookAt, v); });
           },
       .why =
           [](const Start& s, double v) {
             const double away = glm::length(s.camera.eye - s.camera.lookAt);
             const double pixel = 2 * away * std::tan(v * M_PI / 360) / s.settings.height;
             return "The longest side of the scene is only " + shortly(s.size / pixel) + " pixels.";
           }},
      {.name = "eye falls to",
       .unit = "of its distance",
       .drives = "The eye falls onto the surface in the middle of the picture.",
       .values = powers(10, 0, -12, -1),
       .at =
           [](const Start& s, double v) {
             return withSettings(s, [&](PictureSettings& p) {
               p.camera = perspective(s, s.target + v * (s.camera.eye - s.target), s.target, p.camera.fov);
             });
           },
       .why =
           [](const Start& s, double v) {
             const double distance = v * glm::length(s.camera.eye - s.target);
             const glm::dvec3 eye = glm::abs(s.target + v * (s.camera.eye - s.target));
             const double most = std::max({eye.x, eye.y, eye.z});
             return "The eye is " + shortly(distance / s.size) +
                    " of the scene's size away, and doubles at the eye are " +
                    shortly((std::nextafter(most, 2 * most + 1) - most) / distance) +
                    " of that apart. Unless one face fills the picture, what is nearer than 2^-15 of the "
                    "way to the back plane is cut away.";
           }},
      {.name = "flattened to",
       .unit = "of its height",
       .drives = "The scene is flattened along its up axis, so that upright faces become slivers.",
       .values = powers(10, 0, -12, -1),
       .at =
           [](const Start& s, double v) {
             const int axis = s.scene.up == UpAxis::Y ? 1 : 2;
             const double middle = std::ldexp(boxOf(s.scene.mesh.points).centre()[axis], s.scene.exponent);
             return mapped(s, 1, [=](glm::dvec3 p) {
               p[axis] = middle + v * (p[axis] - middle);
               return p;
             });
           },
       .why =
           [](const Start& s, double v) {
             const Box box = boxOf(s.scene.mesh.points);
             const double high = (box.high - box.low)[s.scene.up == UpAxis::Y ? 1 : 2];
             return "The scene is " + shortly(v * high / s.pixel) + " pixels high.";
           }},
      {.name = "a copy in front at",
       .unit = "of its size",
       .drives = "A second copy of all faces lies in front of the first. It should hide it.",
       .values = powers(10, -1, -12, -1),
       .at = [](const Start& s, double v) { return withLayer(s, v * s.size); },
       .why =
           [](const Start& s, double v) {
             return "The copies are " + shortly(v * s.size / s.pixel) +
                    " pixels apart; the grid has 1/65536.";
           }},
      {.name = "exponent n up to",
       .unit = "",
       .drives = "The specular exponent grows, with Phong shading.",
       .values = {1, 10, 100, 1'000, 10'000, 100'000, 1'000'000},
       .at =
           [](const Start& s, double v) {
             return sameWith(s, [&](Case& c) {
               phong(c.settings).light.n = static_cast<int>(v);
               strip(c.scene, "n");
             });
           },
       .why =
           [](const Start&, double v) {
             const bool single = v <= kMostForSingle;
             return "The n-th power multiplies an error of the cosine by n: " +
                    shortly(v * (single ? 0x1p-24 : 0x1p-53)) + (single ? " in single" : " in double") +
                    " precision.";
           }},
      {.name = "I0 down to",
       .unit = "",
       .drives = "The corrected table begins at a lower intensity, with Phong shading.",
       .values = powers(10, -1, -6, -1),
       .at =
           [](const Start& s, double v) {
             return withSettings(s, [v](PictureSettings& p) {
               phong(p).table.kind = TableKind::Corrected;
               p.table.I0 = v;
             });
           },
       .why =
           [](const Start& s, double v) {
             const int bits = s.settings.table.bits;
             return "A cell has " + std::to_string(bits) + " bits a channel: its darkest value above 0 is " +
                    shortly(1.0 / ((1 << bits) - 1)) + ", and I0 is " + shortly(v) + ".";
           }},
      {.name = "light falls to",
       .unit = "of the size",
       .drives = "A point light falls onto the surface in the middle, with Phong shading.",
       .values =
           [] {
             std::vector<double> values = powers(10, 0, -15, -1);
             values.push_back(0);
             return values;
           }(),
       .at =
           [](const Start& s, double v) {
             return sameWith(s, [&](Case& c) {
               Illumination& light = phong(c.settings).light;
               strip(c.scene, "lights");
               light.lightPosition = inFileUnits(s.target + v * s.size * s.facing, s.scene);
               light.attenuation = Attenuation::InverseSquare;
             });
           },
       .why =
           [](const Start& s, double v) {
             return "The light is " + shortly(v * s.size / s.pixel) +
                    " pixels above the surface; only that many pixels around it are lit.";
           }},
  };
  return all;
}

}  // namespace xnewell
