#include "shading/extremes/extremes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <optional>

#include "depthsort/oracle.h"
#include "geometry/exact/box.h"
#include "geometry/exact/plane.h"
#include "shading/extremes/extreme_ways.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

Start startOf(const Scene& scene, PictureSettings settings) {
  settings.colors = ColorPlan::OneHue;
  settings.inPixels = false;
  const Picture picture = makePicture(scene, settings);
  Start start{.scene = scene,
              .settings = settings,
              .camera = picture.camera(),
              .size = boxOf(scene.mesh.points).side(),
              .pixel = 0,
              .target = picture.camera().lookAt,
              .facing = glm::normalize(picture.camera().eye - picture.camera().lookAt)};
  const ViewSpec& view = start.camera.view;
  const double away = glm::length(start.camera.eye - start.camera.lookAt);
  start.pixel = (view.windowMax.y - view.windowMin.y) / settings.height *
                (view.projection == Projection::Perspective ? away / view.prp.z : 1.0);
  const Rays rays{scene, start.camera, settings};
  double nearest = 1e300;
  for (int j = 0; j < settings.height; ++j)
    for (int i = 0; i < settings.width; ++i) {
      const double x = i + 0.5 - settings.width / 2.0, y = j + 0.5 - settings.height / 2.0;
      if (x * x + y * y >= nearest) continue;
      const std::optional<Rays::Hit> hit = rays.nearest(i + 0.5L, j + 0.5L);
      if (!hit) continue;
      nearest = x * x + y * y;
      start.target = rays.point(i + 0.5L, j + 0.5L, hit->t);
      const glm::dvec3 N = newellPlane(scene.mesh.points, scene.mesh.face(hit->face)).N;
      start.facing = glm::dot(N, start.camera.eye - start.target) < 0 ? -N : N;
    }
  return start;
}

/// The most by which a painted cell differs from the cell of the intensity in double precision.
int shadesOff(const Picture& picture) {
  const SeenRows rows = picture.seen(0, picture.settings().height);
  const std::vector<double> I = picture.intensities(rows);
  int most = 0;
  for (std::size_t k = 0; k < I.size(); ++k)
    if (rows.faces[k] != kNothing)
      most = std::max(most, std::abs(picture.image().pixels[k] - picture.table().cell(I[k])));
  return most;
}

int changedFrom(const Picture& first, const Picture& picture) {
  const std::vector<std::uint32_t> before = first.faceImage(), after = picture.faceImage();
  int changed = 0;
  for (std::size_t k = 0; k < before.size(); ++k)
    changed += before[k] != after[k] || std::abs(first.image().pixels[k] - picture.image().pixels[k]) > 1;
  return changed;
}

int mergedShades(const ColorTable& table) {
  int merged = 0;
  for (int j = 0; j + 1 < table.shades(); ++j) merged += table.color(j) == table.color(j + 1);
  return merged;
}

}  // namespace

std::string shortly(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", v);
  return text.data();
}

std::vector<Extreme> extremesOf(const Scene& scene, const PictureSettings& settings,
                                const std::function<void(std::string_view)>& progress) {
  const Start start = startOf(scene, settings);
  std::vector<Extreme> extremes;
  for (const Way& way : extremeWays()) {
    if (progress) progress(way.name);
    Extreme& extreme = extremes.emplace_back(Extreme{way.name, way.unit, way.drives});
    std::optional<Picture> first;
    for (const double value : way.values) {
      ExtremeStep& step =
          extreme.steps.emplace_back(ExtremeStep{.value = value, .why = way.why(start, value)});
      try {
        Case drive = way.at(start, value);
        const Picture picture = makePicture(std::move(drive.scene), drive.settings, 0);
        step.seen = judgedByRays(picture);
        step.shadesOff = shadesOff(picture);
        step.merged = mergedShades(picture.table());
        if (!first) first = picture;
        if (way.changesNothing) step.changed = changedFrom(*first, picture);
      } catch (const ViewError& e) {
        step.refused = e.what();
      }
    }
  }
  return extremes;
}

std::string findingOf(const Extreme& extreme) {
  const bool said = extreme.unit.empty() || extreme.unit.starts_with('(');
  const std::string unit = said ? "" : " " + std::string{extreme.unit};
  const auto wrong = std::ranges::find_if(extreme.steps, &ExtremeStep::isWrong);
  if (wrong == extreme.steps.end()) return "right up to " + shortly(extreme.steps.back().value) + unit;
  std::string text = "from " + shortly(wrong->value) + unit + " on: ";
  if (!wrong->refused.empty()) return text + wrong->refused;
  std::string what;
  const auto add = [&](const std::string& words) { what += (what.empty() ? "" : ", ") + words; };
  if (wrong->seen.wrong > 0)
    add(std::to_string(wrong->seen.wrong) + " of " + std::to_string(wrong->seen.samples) +
        " samples show a face that is not the nearest");
  if (wrong->shadesOff > 1) add("cells are off by up to " + std::to_string(wrong->shadesOff) + " shades");
  if (wrong->changed > 0)
    add(std::to_string(wrong->changed) + " of " + std::to_string(wrong->seen.samples) + " samples change");
  if (wrong->merged > 0) add(std::to_string(wrong->merged) + " shades look like the next one");
  return text + what;
}

}  // namespace xnewell
