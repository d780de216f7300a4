#include "shading/diagnose/pair_scene.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace xnewell {

using PairJson = nlohmann::ordered_json;

std::string stepName(const PaintStep& step) {
  if (!step.name.empty()) return step.name;
  return (step.piece.empty() ? "face " : "a piece of face ") + std::to_string(step.face);
}

std::string pairAsScene(const Picture& picture, const WrongPair& pair, std::span<const PaintStep> steps) {
  const double unit = std::ldexp(1.0, picture.scene().exponent);
  const auto list = [](const glm::dvec3& v) { return PairJson{v.x, v.y, v.z}; };
  const ViewSpec& view = picture.camera().view;
  PairJson camera{
      {"vrp", list(unit * view.vrp)},
      {"vpn", list(view.vpn)},
      {"vup", list(view.vup)},
      {"prp", list(unit * view.prp)},
      {"window",
       {unit * view.windowMin.x, unit * view.windowMax.x, unit * view.windowMin.y, unit * view.windowMax.y}},
      {"front", unit * view.front},
      {"back", unit * view.back}};
  if (view.projection == Projection::Parallel) camera["parallel"] = true;
  PairJson objects = PairJson::array();
  for (const auto& [step, color] :
       {std::pair{pair.hidden, PairJson{0.35, 0.6, 1}}, std::pair{pair.shown, PairJson{1, 0.6, 0.2}}}) {
    PairJson corners = PairJson::array();
    for (const glm::dvec3& p : stepInWorld(picture, steps[step])) corners.push_back(list(p));
    objects.push_back({{"name", stepName(steps[step])}, {"color", color}, {"polygons", {corners}}});
  }
  const PairJson scene{
      {"shows", "the first wrong pair: " + stepName(steps[pair.shown]) + " is painted over " +
                    stepName(steps[pair.hidden]) + ", which is nearer"},
      {"camera", camera},
      {"objects", objects},
      {"shading", {{"order", "none"}}}};
  return scene.dump(1) + '\n';
}

}  // namespace xnewell
