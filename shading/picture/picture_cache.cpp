#include "shading/picture/picture_cache.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "depthsort/visibility.h"
#include "geometry/exact/give_up.h"
#include "geometry/view/scene_planes.h"
#include "shading/picture/shared.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

/// Runs a stage, or a part of it, and adds its time in milliseconds. @throws GivenUp instead
template <class Stage>
void timed(double& ms, Stage&& stage) {
  MayGiveUp::check();
  const Stopwatch watch;
  stage();
  ms += watch.ms();
}

}  // namespace

PictureSettings withoutColors(PictureSettings settings) {
  settings.table.hue = {};
  settings.table.bits = 0;
  return settings;
}

Picture PictureCache::make(const PictureSettings& wanted, std::optional<std::uint8_t> ground) {
  // The next picture begins as a copy of the last one. A stage that does not run again keeps its old result.
  Picture next = last_ ? *last_ : Picture{scene_};
  const auto changed = [&](auto... member) {
    return !last_ || ((wanted.*member != last_->settings_.*member) || ...);
  };
  using Asked = PictureSettings;
  if (changed(&Asked::lights)) {
    next.scene_ = scene_;
    if (wanted.lights) {
      Scene lit = *scene_;
      lit.light.lights = *wanted.lights;
      next.scene_ = std::move(lit);
    }
  }
  const Scene& scene = *next.scene_;
  const int width = wanted.width, height = wanted.height;
  next.settings_ = wanted;
  const PictureSettings inScene = inSceneUnits(wanted, scene);
  StageTimes& ms = next.times_ = {};

  // The camera. The user's choices come first. The scene gives the rest, which takes passes over its points.
  if (camera_)
    next.camera_ = *camera_;
  else if (changed(&Asked::camera, &Asked::width, &Asked::height, &Asked::cull))
    timed(ms.transform, [&] {
      const double aspect = static_cast<double>(width) / height;
      next.camera_ =
          placeCamera(inScene.camera, scene.mesh.points, scene.up, aspect, scene.parts, wanted.cull);
    });
  const ViewSpec& view = next.camera_.view;

  // Lighting and shades, in world coordinates. The diffuse term does not depend on the eye. The specular term
  // is computed again when the eye moves. It comes after the sort, in the memory that the sort gave back,
  // unless it divides polygons, or did so for the last picture.
  const ColorPlan plan = planOf(scene, wanted);
  const auto shade = [&] {
    timed(ms.shade,
          [&] { next.shading_ = next.shading_.next(scene, inScene, channelsOf(plan), next.camera_); });
  };
  const bool dividesFirst = wanted.adapt > 0.0 || next.shading_.refined();
  if (dividesFirst) shade();

  // View, shear, warp, clip, viewport, and one snap to the grid. From here on, everything is exact.
  const bool newView = changed(&Asked::width, &Asked::height, &Asked::cull) || view != last_->camera_.view ||
                       !next.shading_.hasMeshOf(last_->shading_);
  SnappedScene snapped;
  const Mesh& mesh = next.shading_.mesh(scene);
  const ConvexParts& parts = next.shading_.parts(scene);
  if (newView) timed(ms.transform, [&] { snapped = snap(mesh, parts, view, width, height, wanted.cull); });

  // The faces back to front; or the visible face at each sample. Orders that compare planes make them in a
  // new scene.
  if (newView || changed(&Asked::order, &Asked::inPixels))
    timed(ms.sort, [&] {
      const bool exact = rowOf(wanted.order).exact;
      std::optional<ScenePlanes> planes;
      if (newView && exact) planes.emplace(snapped, mesh, parts, view, width, height);
      if (!newView && exact) next.snapped_ = next.withPlanes().snapped_;
      Visibility visibility = visibilityOf(newView ? snapped : *next.snapped_, view, wanted.order,
                                           {.width = wanted.width,
                                            .height = wanted.height,
                                            .inPixels = wanted.inPixels,
                                            .planes = planes ? &*planes : nullptr,
                                            .mostPieces = wanted.mostPieces});
      next.visible_ = std::move(visibility.faces);
      next.sorted_ = std::move(visibility.sorted);
      if (newView) next.snapped_ = std::move(snapped);
    });

  if (!dividesFirst) shade();

  // The colour tables, and the cell of each intensity. A plan of colours chooses its colours later, from the
  // image.
  timed(ms.fill, [&] {
    SceneColors colors;
    colors.make(next.surfaces(), plan);
    next.colors_ = std::move(colors);
    next.cells_ = rowOf(wanted.shading).interpolates || channelsOf(plan) == Channels::Rgb
                      ? std::vector<std::uint8_t>{}
                      : next.cellsOf(0);
  });

  // The image.
  const bool newIndices = !last_ || withoutColors(wanted) != withoutColors(last_->settings_);
  if (newIndices) next.painted_.reset();
  if (ground && !(next.painted_ && next.painted_->ground == *ground))
    timed(ms.fill, [&] { next.painted_ = std::make_shared<const Painted>(next.paint(*ground)); });

  last_ = next;
  return next;
}

}  // namespace xnewell
