#include "shading/trade/trade_sentences.h"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>

#include "geometry/exact/box.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

/// Two digits: 0.0012, 2.5, 12, 790.
std::string twoDigits(double v) {
  char text[32];
  if (v >= 100) {
    const double unit = std::pow(10.0, std::floor(std::log10(v)) - 1);
    std::snprintf(text, sizeof text, "%.0f", unit * std::round(v / unit));
  } else {
    std::snprintf(text, sizeof text, "%.2g", v);
  }
  return text;
}

std::string times(double ratio, const std::string& what) { return twoDigits(ratio) + " times " + what; }

/// How far the nearest lamp is from the scene's centre, in sides of the scene.
std::string whereTheLampIs(const Picture& picture) {
  const Scene& scene = picture.scene();
  const Box box = boxOf(scene.mesh.points);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Light& light : lightsOf(scene, picture.settings().light))
    if (light.kind != LightKind::Directional) {
      const glm::dvec3 to = light.position - box.centre();
      nearest = std::min(nearest, std::hypot(to.x, to.y, to.z));
    }
  return "The nearest lamp is " + times(nearest / box.side(), "the scene's side away.");
}

std::string whereTheEyeIs(const Picture& picture) {
  const Camera& camera = picture.camera();
  return "The eye is " +
         times(glm::length(camera.eye - camera.lookAt) / boxOf(picture.scene().mesh.points).side(),
               "the scene's side away.");
}

/// A sentence about the reason, if the numbers give one.
std::string reasonOf(const TradeRow& row, const Axis& axis, const Picture& picture) {
  const Errors& errors = row.measured.here;
  if (!axis.setting)
    return errors.patches ? "Its polygons are up to " + twoDigits(errors.patches->largestPixels) +
                                " pixels off the patches."
                          : "";
  if (axis.setting->key == "constant_l") return whereTheLampIs(picture);
  if (axis.setting->key == "constant_v") return whereTheEyeIs(picture);
  if (axis.setting->key == "method" && row.value == static_cast<double>(Shading::Flat) &&
      row.measured.cost.polygons > 0)
    return "A polygon covers about " +
           twoDigits(static_cast<double>(errors.samples) / static_cast<double>(row.measured.cost.polygons)) +
           " samples.";
  return "";
}

/// "4 more samples show a wrong face", "no sample shows a wrong face".
std::string facesOf(std::int64_t wrong, std::int64_t before) {
  const std::int64_t more = wrong - before;
  if (wrong == 0 && more != 0) return "no sample shows a wrong face";
  const std::int64_t count = std::abs(more);
  return std::to_string(count) + (more > 0 ? " more" : " fewer") +
         (count == 1 ? " sample shows" : " samples show") + " a wrong face";
}

}  // namespace

std::string sentenceOf(const TradeRow& row, const Axis& axis, const Measured& asked, const Picture& picture) {
  const Measured& one = row.measured;
  std::string text = "With " + one.configuration.name() + " it " +
                     (one.cost.time.ms > 0 ? savingOf(one.cost.time) : "was not timed");
  if (one.samePixels) return text + " and shows the same picture.";
  const double rms = one.here.afterTable.rootMeanSquare, before = asked.here.afterTable.rootMeanSquare;
  const bool alike = twoDigits(rms) == twoDigits(before);
  text += " and is off by " + twoDigits(rms) + (alike ? " as before" : " instead of " + twoDigits(before)) +
          ", at most by " + twoDigits(one.here.afterTable.largest);
  if (one.here.wrongFaces != asked.here.wrongFaces)
    text += "; " + facesOf(one.here.wrongFaces, asked.here.wrongFaces);
  const std::string reason = reasonOf(row, axis, picture);
  return text + '.' + (reason.empty() ? "" : ' ' + reason);
}

}  // namespace xnewell
