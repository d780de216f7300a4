#include "shading/read_camera.h"

#include <optional>

CameraSettings readCamera(const Node& node) {
  node.expectKeys({"eye", "look_at", "up", "fov", "parallel", "oblique", "vrp", "vpn", "vup", "prp", "window",
                   "front", "back"});
  CameraSettings camera;
  const auto point = [&](const char* key, std::optional<glm::dvec3>& p) {
    if (node.has(key)) p = node.at(key).point();
  };
  point("eye", camera.eye), point("look_at", camera.lookAt), point("up", camera.up);
  point("vrp", camera.vrp), point("vpn", camera.vpn), point("vup", camera.vup), point("prp", camera.prp);
  if (node.has("window")) camera.window = node.at("window").numbers<4>();
  if (node.has("front")) camera.front = node.at("front").number();
  if (node.has("back")) camera.back = node.at("back").number();
  if (node.has("fov")) {
    camera.fov = node.at("fov").numberAbove(0);
    if (*camera.fov >= 180) node.at("fov").fail("an angle between 0 and 180 degrees is needed");
    if (node.has("parallel") || node.has("oblique"))
      node.at("fov").fail("a field of view is for perspective");
  }
  if (node.has("parallel")) {
    camera.height = node.at("parallel").numberAbove(0);
    camera.parallel = true;
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
