#include "shading/extremes/extremes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <glm/geometric.hpp>
#include <mutex>
#include <optional>
#include <span>
#include <thread>

#include "depthsort/oracle.h"
#include "geometry/exact/box.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/unit.h"
#include "shading/extremes/extreme_ways.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

PictureSettings inOneHue(PictureSettings settings) {
  settings.colors = ColorPlan::OneHue;
  settings.inPixels = false;
  return settings;
}

Start startOf(const Picture& picture) {
  const Scene& scene = picture.scene();
  const PictureSettings& settings = picture.settings();
  Start start{.scene = scene,
              .settings = settings,
              .camera = picture.camera(),
              .size = boxOf(scene.mesh.points).side(),
              .pixel = 0,
              .target = picture.camera().lookAt,
              .facing = unit(picture.camera().eye - picture.camera().lookAt)};
  const ViewSpec& view = start.camera.view;
  const double away = glm::dot(start.facing, start.camera.eye - start.camera.lookAt);
  start.pixel = (view.windowMax.y - view.windowMin.y) / settings.height *
                (view.projection == Projection::Perspective ? away / view.prp.z : 1.0);
  const Rays rays{scene, start.camera, settings};
  double nearest = 1e300;
  for (int j = 0; j < settings.height; ++j)
    for (int i = 0; i < settings.width; ++i) {
      const double x = i + 0.5 - settings.width / 2.0, y = j + 0.5 - settings.height / 2.0;
      if (x * x + y * y >= nearest) continue;
      const std::optional<Rays::Hit> hit = rays.nearest(i + 0.5, j + 0.5);
      if (!hit) continue;
      nearest = x * x + y * y;
      start.target = rays.point(i + 0.5, j + 0.5, hit->t);
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

void judge(ExtremeStep& step, const Picture& picture) {
  step.seen = judgedByRays(picture);
  step.shadesOff = shadesOff(picture);
  step.merged = mergedShades(picture.table());
}

/// Drives the scene one way. Returns nothing if `mayGoOn` says no.
std::optional<Extreme> driven(const Start& start, const Way& way,
                              const std::function<bool(const std::string&)>& mayGoOn) {
  Extreme extreme{way.name, way.unit, way.drives};
  std::optional<Picture> first;
  for (const double value : way.values) {
    if (!mayGoOn(std::string{way.name} + " " + shortly(value))) return std::nullopt;
    ExtremeStep& step = extreme.steps.emplace_back(ExtremeStep{.value = value});
    try {
      step.why = way.why(start, value);
      Case drive = way.at(start, value);
      const Picture picture = makePicture(std::move(drive.scene), drive.settings, 0);
      judge(step, picture);
      if (!first) first = picture;
      if (way.changesNothing) step.changed = changedFrom(*first, picture);
    } catch (const ViewError& e) {
      step.refused = e.what();
    }
  }
  return extreme;
}

}  // namespace

std::string shortly(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", v);
  int exponent = 0;
  if (std::frexp(v, &exponent) == 0.5 && std::atof(text.data()) != v)
    return "2^" + std::to_string(exponent - 1);
  return text.data();
}

Extremes extremesOf(const Scene& scene, const PictureSettings& settings,
                    const std::function<bool(const std::string&)>& goOn, int threads) {
  if (boxOf(scene.mesh.points).side() == 0) throw ViewError{"the scene has no extent"};
  const Picture asItIs = makePicture(scene, inOneHue(settings), 0);
  const Start start = startOf(asItIs);
  const std::span<const Way> ways = extremeWays();
  Extremes extremes{.setUp = {}, .allWays = static_cast<int>(ways.size())};
  judge(extremes.setUp, asItIs);

  std::mutex turn;
  bool goesOn = true;
  std::size_t next = 0;
  std::vector<std::optional<Extreme>> done(ways.size());
  const auto mayGoOn = [&](const std::string& doing) {
    const std::scoped_lock alone{turn};
    return goesOn = goesOn && (!goOn || goOn(doing));
  };
  const auto takeWays = [&] {
    for (;;) {
      std::size_t mine = 0;
      {
        const std::scoped_lock alone{turn};
        if (!goesOn || next == ways.size()) return;
        mine = next++;
      }
      done[mine] = driven(start, ways[mine], mayGoOn);
    }
  };
  std::vector<std::future<void>> others;
  const int all = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  for (int k = 1; k < std::min(all, extremes.allWays); ++k)
    others.push_back(std::async(std::launch::async | std::launch::deferred, takeWays));
  takeWays();
  for (std::future<void>& other : others) other.get();
  for (std::optional<Extreme>& way : done)
    if (way) extremes.ways.push_back(std::move(*way));
  return extremes;
}

}  // namespace xnewell
