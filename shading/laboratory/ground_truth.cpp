#include "shading/laboratory/ground_truth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "depthsort/oracle.h"
#include "geometry/exact/give_up.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/view/camera.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/divide_anew.h"
#include "shading/scene/settings.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

/// The camera of a picture, said in full but for the clipping planes, in the scene's units.
CameraSettings saidInFull(const Picture& picture) {
  const ViewSpec& view = picture.camera().view;
  const CameraSettings said = inSceneUnits(picture.settings().camera, picture.scene());
  CameraSettings full;
  full.vrp = view.vrp, full.vpn = view.vpn, full.vup = view.vup, full.prp = view.prp;
  full.window = glm::dvec4{view.windowMin.x, view.windowMax.x, view.windowMin.y, view.windowMax.y};
  full.parallel = view.projection == Projection::Parallel;
  full.front = said.front, full.back = said.back;
  return full;
}

/// What decides the truth, but for the scene and the camera.
PictureSettings modelOf(const Picture& picture) {
  PictureSettings model = trueSettings(picture.settings());
  CameraSettings planes;
  planes.front = model.camera.front, planes.back = model.camera.back;
  model.camera = planes;
  return model;
}

}  // namespace

FineScene fineSceneOf(const Scene& scene) {
  return isCoarse(scene) ? FineScene{finelyDivided(scene)} : std::nullopt;
}

Reference referenceOf(const Picture& picture, const FineScene& fine) {
  if (!fine) return Reference{picture};
  const Scene& scene = **fine;
  const PictureSettings settings = trueSettings(picture.settings());
  Camera camera =
      placeCamera(saidInFull(picture), scene.mesh.points, scene.up,
                  static_cast<double>(settings.width) / settings.height, scene.parts, settings.cull);
  camera.eye = picture.camera().eye, camera.lookAt = picture.camera().lookAt, camera.up = picture.camera().up;
  return Reference{PictureCache{*fine, camera}.make(settings)};
}

GroundTruth::GroundTruth(const Picture& of, const FineScene& fine) : reference_{referenceOf(of, fine)} {
  if (fine) polygons_.emplace(of);
}

bool CachedGroundTruth::knows(const Picture& picture) const {
  return truth_ && &of_->scene() == &picture.scene() && of_->camera() == picture.camera() &&
         modelOf(*of_) == modelOf(picture);
}

const GroundTruth& CachedGroundTruth::of(const Picture& picture) {
  if (knows(picture)) return *truth_;
  truth_.reset();
  if (!of_ || &of_->scene() != &picture.scene()) fine_ = fineSceneOf(picture.scene());
  of_ = picture;
  return truth_.emplace(picture, fine_);
}

Reference::Reference(const Picture& of) : PolygonGroundTruth{of}, gray_{isGray(picture().scene())} {
  const Scene& scene = picture().scene();
  const Illumination& user = picture().settings().light;
  Ia_ = ambientOf(scene.light, user);
  lights_ = lightsOf(scene, user);
  const auto add = [&](const MeshMaterial& m) {
    materials_.push_back({reflectionOf(m, user, 0), reflectionOf(m, user, 1), reflectionOf(m, user, 2)});
  };
  add({});
  for (const MeshMaterial& m : scene.mesh.materials) add(m);

  const int channels = gray_ ? 1 : 3;
  for (int c = 0; c < channels; ++c) I_[c].assign(faces().size(), 0.0);
  GiveUpNowAndThen giveUp;
  for (std::size_t k = 0; k < faces().size(); ++k) {
    giveUp();
    if (faces()[k] == kNothing) continue;
    const glm::dvec3 I = illumination(place(k), picture().snapped().faces[faces()[k]]);
    for (int c = 0; c < channels; ++c) I_[c][k] = std::clamp(I[c], 0.0, 1.0);
  }
}

glm::dvec3 Reference::illumination(const SurfacePlace& place, const SnappedFace& face) const {
  const Illumination& user = picture().settings().light;
  const Scene& scene = picture().scene();
  const Rgb& material = materials_[scene.mesh.material[face.number] + 1];
  const glm::dvec3 N = face.back && user.twoSided ? -place.N : place.N;
  const glm::dvec3 V = unit(picture().camera().eye - place.origin - place.at);
  const glm::dvec3 texel = this->texel(place, face.number);
  const int channels = gray_ ? 1 : 3;
  glm::dvec3 I{0.0};
  for (int c = 0; c < channels; ++c) I[c] = rowOf(user.mistake).ambient * Ia_[c] * material[c].ka;
  for (const Light& light : lights_) {
    const bool directional = light.kind == LightKind::Directional;
    const glm::dvec3 towards = directional ? light.direction : light.position - place.origin - place.at;
    const glm::dvec3 L = unit(towards);
    const double fatt = directional ? 1.0 : attenuation(light, glm::dot(towards, L), scene.light.unit);
    const double f = fatt * spotShare(light, L);
    for (int c = 0; c < channels; ++c) {
      const LightTerms terms = lightTerms(user.mistake, f, light.Ip[c], material[c], {N, L, V}, user.form);
      I[c] += terms.diffuse * texel[c] + terms.specular;
    }
  }
  return I;
}

glm::dvec3 Reference::texel(const SurfacePlace& place, int face) const {
  const Mesh& mesh = picture().scene().mesh;
  const int material = mesh.material[face];
  if (material < 0 || mesh.materials[material].texture < 0 || mesh.uvOfCorner.empty()) return glm::dvec3{1.0};
  for (int corner = mesh.firstCorner[face]; corner < mesh.firstCorner[face + 1]; ++corner)
    if (mesh.uvOfCorner[corner] < 0) return glm::dvec3{1.0};
  glm::dvec2 uv{0.0};
  for (int k = 0; k < 3; ++k) uv += place.share[k] * mesh.uv[mesh.uvOfCorner[place.corner[k]]];
  const Texture& texture = picture().scene().textures[mesh.materials[material].texture];
  const auto index = [](double share, int size) {  // share in [0, 1]
    return std::min(static_cast<int>(share * size), size - 1);
  };
  // v runs up the columns, and rows run down. The texture repeats.
  const int column = index(uv.x - std::floor(uv.x), texture.width);
  const int row = index(1.0 - (uv.y - std::floor(uv.y)), texture.height);
  const auto at = static_cast<std::size_t>(row) * texture.width + column;
  glm::dvec3 result;
  for (int c = 0; c < 3; ++c) result[c] = texture.channel[c][at] / 255.0;
  return result;
}

PictureSettings trueSettings(const PictureSettings& settings) {
  PictureSettings unpainted = withoutShortCuts(settings);
  unpainted.shading = Shading::Full;
  unpainted.colors = ColorPlan::OneHue;
  return unpainted;
}

PolygonGroundTruth::PolygonGroundTruth(const Picture& of)
    : picture_{PictureCache{of}.make(trueSettings(of.settings()))},
      faces_{picture_.seen(0, picture_.settings().height).faces},
      surface_{picture_.scene(), picture_.camera().view, picture_.settings().width,
               picture_.settings().height} {}

void PolygonGroundTruth::keepShownOnly() {
  picture_ = picture_.onlyShown();
  faces_ = picture_.seen(0, picture_.settings().height).faces;
}

SurfacePlace PolygonGroundTruth::place(std::size_t sample) const {
  const auto width = static_cast<std::size_t>(picture_.settings().width);
  return surface_.at(picture_.snapped().faces[faces_[sample]].part, static_cast<int>(sample % width),
                     static_cast<int>(sample / width));
}

TrueSurface::TrueSurface(const Scene& scene, const ViewSpec& view, int width, int height)
    : scene_{scene},
      view_{view},
      width_{width},
      height_{height},
      rotation_{vrcRotation(view)},
      runOf_(static_cast<std::size_t>(scene.mesh.faceCount()), -1) {
  int run = 0;
  for (const PatchRun& patches : scene.patches)
    std::fill_n(runOf_.begin() + firstFaceOf(scene.mesh, patches), facesOf(patches), run++);
  for (const RoundRun& round : scene.rounds)
    std::fill_n(runOf_.begin() + round.firstFace, round.faces, run++);
}

TrueSurface::Ray TrueSurface::rayThrough(int i, int j) const {
  const glm::dvec2 size = view_.windowMax - view_.windowMin;
  const glm::dvec3 onPlane{view_.windowMin.x + size.x * ((i + 0.5) / width_),
                           view_.windowMax.y - size.y * ((j + 0.5) / height_), 0.0};
  if (view_.projection == Projection::Perspective) return {view_.prp, onPlane - view_.prp};
  return {onPlane, glm::dvec3{(view_.windowMin + view_.windowMax) / 2.0, 0.0} - view_.prp};
}

bool TrueSurface::meet(const Ray& ray, const std::array<glm::dvec3, 3>& triangle,
                       std::array<double, 3>& share) const {
  const glm::dvec3 b = triangle[1] - triangle[0], c = triangle[2] - triangle[0],
                   from = ray.from - triangle[0];
  const glm::dvec3 across = glm::cross(ray.along, c);
  const double volume = glm::dot(b, across);
  share[1] = glm::dot(from, across) / volume;
  share[2] = glm::dot(ray.along, glm::cross(from, b)) / volume;
  share[0] = 1.0 - share[1] - share[2];
  return std::isfinite(share[1]) && std::isfinite(share[2]);
}

SurfacePlace TrueSurface::at(int part, int i, int j) const {
  const Mesh& mesh = scene_.mesh;
  const ConvexParts& parts = scene_.parts;
  const int first = parts.firstCorner[part], count = parts.firstCorner[part + 1] - first;
  const int face = parts.face[part];
  const auto point = [&](int corner) -> const glm::dvec3& { return mesh.points[mesh.corners[corner]]; };
  const auto seen = [&](int k) { return rotation_ * (point(parts.from[first + k]) - view_.vrp); };

  SurfacePlace place;
  place.corner = {parts.from[first], parts.from[first + 1], parts.from[first + 2]};
  place.share = {1.0, 0.0, 0.0};
  const Ray ray = rayThrough(i, j);
  double best = -std::numeric_limits<double>::infinity();
  for (int k = 1; k + 1 < count && best < 0.0; ++k) {
    std::array<double, 3> share;
    if (!meet(ray, {seen(0), seen(k), seen(k + 1)}, share)) continue;
    if (const double least = std::min({share[0], share[1], share[2]}); least > best) {
      best = least;
      place.corner = {parts.from[first], parts.from[first + k], parts.from[first + k + 1]};
      place.share = share;
    }
  }
  double sum = 0.0;
  for (double& share : place.share) sum += share = std::max(0.0, share);
  for (double& share : place.share) share /= sum;

  place.origin = point(place.corner[0]);
  for (int k = 1; k < 3; ++k) place.at += place.share[k] * (point(place.corner[k]) - place.origin);
  const int run = runOf_[face], patchRuns = static_cast<int>(scene_.patches.size());
  if (run >= patchRuns) {
    place.N = normalOf(place, scene_.rounds[run - patchRuns]);
  } else if (run >= 0) {
    const PatchRun& patches = scene_.patches[run];
    const int cells = patches.divisions * patches.divisions;
    place.patch = &patches.patches[(face - firstFaceOf(mesh, patches)) / cells];
    place.uv = parametersOf(place, face);
    place.N = normal(*place.patch, place.uv.x, place.uv.y);
  }
  if (run < 0 && !mesh.normals.empty()) {
    glm::dvec3 N{0.0};
    bool all = true;
    for (int k = 0; k < 3; ++k) {
      N += place.share[k] * mesh.normals[place.corner[k]];
      all = all && mesh.normals[place.corner[k]] != glm::dvec3{0.0};
    }
    if (all) place.N = unit(N);
  }
  if (place.N == glm::dvec3{0.0}) place.N = unit(newellVector(mesh.points, mesh.face(face)));
  return place;
}

glm::dvec2 TrueSurface::parametersOf(const SurfacePlace& place, int face) const {
  const Mesh& mesh = scene_.mesh;
  std::array<glm::dvec2, 3> uv;
  for (int k = 0; k < 3; ++k) uv[k] = mesh.uv[mesh.uvOfCorner[place.corner[k]]];
  if (mesh.face(face).size() == 3) {
    // A cell with two corners at a pole: the face lists the later one of them. In its parameters the cell is
    // a rectangle, and the corner opposite of the missing one has a right angle. So the pole comes before it.
    const auto angle = [&](int k) {
      return glm::dot(uv[(k + 1) % 3] - uv[k], uv[(k + 2) % 3] - uv[k]);  // 0 exactly if it is right
    };
    const int opposite = angle(0) == 0.0 ? 0 : angle(1) == 0.0 ? 1 : 2;
    const int last = (opposite + 1) % 3, pole = (opposite + 2) % 3;
    const glm::dvec2 missing = uv[last] + uv[pole] - uv[opposite];
    const double along = place.share[opposite] + place.share[last];
    const double towards = along > 0.0 ? place.share[last] / along : 0.5;
    uv[pole] += towards * (missing - uv[pole]);
  }
  glm::dvec2 result{0.0};
  for (int k = 0; k < 3; ++k) result += place.share[k] * uv[k];
  return glm::clamp(result, 0.0, 1.0);
}

glm::dvec3 TrueSurface::normalOf(const SurfacePlace& place, const RoundRun& run) const {
  // In file coordinates. The difference of two places that are far from the origin is exact.
  const glm::dvec3 origin = scaled(place.origin, scene_.exponent) - run.centre;
  const glm::dmat3 ownFromFile = glm::inverse(run.axes);
  const glm::dvec3 p = ownFromFile * (origin + scaled(place.at, scene_.exponent));
  // The transposed inverse of the axes keeps a normal perpendicular to its surface.
  return unit(outward(run.solid, p) * ownFromFile);
}

double TrueSurface::distanceToPatch(const SurfacePlace& place) const {
  if (place.patch == nullptr) return 0.0;
  BezierPatch near;  // relative to the origin of the place
  for (std::size_t k = 0; k < near.p.size(); ++k)
    near.p[k] = scaled(place.patch->p[k], -scene_.exponent) - place.origin;
  return distanceFrom(near, place.at, place.uv);
}

double TrueSurface::pixelsPerUnit(const SurfacePlace& place) const {
  const double onPlane = height_ / (view_.windowMax.y - view_.windowMin.y);
  if (view_.projection == Projection::Parallel) return onPlane;
  const double depth = view_.prp.z - (rotation_ * (place.origin - view_.vrp + place.at)).z;
  return onPlane * view_.prp.z / depth;
}

}  // namespace xnewell
