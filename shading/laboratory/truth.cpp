#include "shading/laboratory/truth.h"

#include "geometry/view/camera.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/divide_anew.h"
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

Truth::Truth(const Picture& of, const FineScene& fine) : reference_{referenceOf(of, fine)} {
  if (fine) polygons_.emplace(of);
}

const Truth& LastTruth::of(const Picture& picture) {
  const bool sameScene = of_ && &of_->scene() == &picture.scene();
  if (truth_ && sameScene && of_->camera() == picture.camera() && modelOf(*of_) == modelOf(picture))
    return *truth_;
  truth_.reset();
  if (!sameScene) fine_ = fineSceneOf(picture.scene());
  of_ = picture;
  return truth_.emplace(picture, fine_);
}

}  // namespace xnewell
