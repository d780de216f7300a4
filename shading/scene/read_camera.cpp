#include "shading/scene/read_camera.h"

#include <optional>
#include <string>

#include "geometry/view/project.h"
#include "shading/scene/units.h"

namespace xnewell {

CameraSettings readCamera(const Node& node) {
  node.expectKeys({"eye", "look_at", "up", "fov", "parallel", "oblique", "vrp", "vpn", "vup", "prp", "window",
                   "front", "back"});
  const auto exclude = [&](const char* a, const char* b) {
    if (node.has(a) && node.has(b))
      node.at(b).fail("the camera has both " + std::string{a} + " and " + b + "; give one of them");
  };
  exclude("eye", "vpn"), exclude("eye", "prp"), exclude("look_at", "vrp"), exclude("up", "vup");
  exclude("fov", "window");
  CameraSettings camera;
  const auto point = [&](const char* key, std::optional<glm::dvec3>& p) {
    if (node.has(key)) p = node.at(key).point();
  };
  const auto direction = [&](const char* key, std::optional<glm::dvec3>& v) {
    if (node.has(key)) v = node.at(key).direction();
  };
  point("eye", camera.eye), point("look_at", camera.lookAt), direction("up", camera.up);
  point("vrp", camera.vrp), direction("vpn", camera.vpn), direction("vup", camera.vup);
  point("prp", camera.prp);
  if (node.has("window")) camera.window = node.at("window").numbers<4>();
  if (node.has("front")) camera.front = node.at("front").number();
  if (node.has("back")) camera.back = node.at("back").number();
  if (node.has("fov")) {
    camera.fov = node.at("fov").numberAbove(0);
    if (*camera.fov >= 180) node.at("fov").fail("an angle between 0 and 180 degrees is needed");
    if (node.has("parallel") || node.has("oblique"))
      node.at("fov").fail("a field of view applies only to perspective");
  }
  if (node.has("parallel")) {
    camera.parallel = true;
    if (!node.at("parallel").isTrue()) camera.height = node.at("parallel").numberAbove(0);
  }
  if (node.has("oblique")) {
    const Node oblique = node.at("oblique");
    oblique.expectKeys({"kind", "angle"});
    camera.oblique = Oblique{};
    if (oblique.has("kind")) {
      const std::string kind = oblique.at("kind").text();
      if (kind != "cavalier" && kind != "cabinet") oblique.at("kind").fail("cavalier or cabinet is needed");
      camera.oblique->length = kind == "cabinet" ? 0.5 : 1.0;
    }
    if (oblique.has("angle")) camera.oblique->angle = oblique.at("angle").number();
  }
  return camera;
}

void expectSees(const CameraSettings& camera, const Scene& scene, const Node& node) {
  // The parts that the file leaves out are chosen to keep clear of the scene; for a narrower picture they are
  // farther away. So what the narrowest picture cannot show, no other can.
  constexpr double kNarrowest = 1.0 / kMaxPicture;
  try {
    (void)canonicalFromVrc(placeCamera(scene, camera, kNarrowest).view);
  } catch (const ViewError& e) {
    node.fail(e.what());
  }
}

}  // namespace xnewell
