#include <gtest/gtest.h>

#include "geometry/files/parse_error.h"
#include "tests/support/scene_text.h"

namespace xnewell::THIS_FILE {

// Every complaint names the place and what is allowed there.
TEST(SceneFile, ComplaintsNameThePlace) {
  EXPECT_EQ(complaint("{\n\"objects\": [\n1,,\n]}"), "s.json:3: not valid JSON here");
  EXPECT_EQ(complaint(""), "s.json:1: not valid JSON here");
  // A bracket that is not closed is found where it opens, not where the text ends or closes another.
  EXPECT_EQ(complaint("{\n\"objects\": [\n{\"name\": \"}\",\n\"polygons\": []\n]}"),
            "s.json:3: this { is not closed");
  EXPECT_EQ(complaint("{\"objects\": [\n{\"name\": \"a\",\n\"polygons\": []\n,\n{\"name\": \"b\"}]}"),
            "s.json:2: this { is not closed");
  EXPECT_EQ(complaint("{\n\"objects\": [\n\n"), "s.json:2: this [ is not closed");
  EXPECT_EQ(complaint("[]"), "s.json: an object { } is needed");
  EXPECT_EQ(complaint("{}"), "s.json: the scene has no faces");
  EXPECT_EQ(
      complaint(R"({"light": []})"),
      "s.json: unknown key 'light'; the keys are shows, up, camera, ambient, lights, shading, materials, "
      "objects, lines, labels");
  EXPECT_EQ(
      complaint(R"({"lights": [], "objects": [{"solid": "cube"}]})"),
      "s.json: lights: at least one light is needed; for a scene without lights, set Ip to 0 in shading");
  EXPECT_EQ(complaint(R"({"scene": "nope"})"),
            "s.json: scene: 'nope' is not a built-in scene; `xnewell scenes` lists them");
  EXPECT_EQ(complaint(R"({"up": "x"})"), "s.json: up: \"y\" or \"z\" is needed");
  EXPECT_EQ(complaint(R"({"objects": {}})"), "s.json: objects: a list [ ] is needed");
  EXPECT_EQ(complaint(withObject("{}")),
            "s.json: objects[0]: exactly one of file, polygons and solid is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cone"})")),
            "s.json: objects[0].solid: cube, sphere or torus is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "torus", "around": 2})")),
            "s.json: objects[0].around: a whole number from 3 to 4096 is needed");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[0,0,0],[1,0,0]]]})")),
            "s.json: objects[0].polygons[0]: a polygon needs at least 3 corners");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[0,0,0],[1,0,0],[1,1]]]})")),
            "s.json: objects[0].polygons[0][2]: a list of 3 numbers is needed");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[0,0,"a"],[1,0,0],[1,1,0]]]})")),
            "s.json: objects[0].polygons[0][0][2]: a number is needed");
  EXPECT_EQ(complaint(withObject(R"({"file": "x.txt"})")),
            "s.json: objects[0].file: a model file is needed: .obj, .ply, .off, .bpt");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cube", "scale": 0})")),
            "s.json: objects[0].scale: a number above 0 is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cube", "scale": 1e308, "move": [1e308, 0, 0]})")),
            "s.json: objects[0]: the object is scaled out of range");
  EXPECT_EQ(complaint(R"({"camera": {"fov": 180}, "objects": [)" + kTriangle + "]}"),
            "s.json: camera.fov: an angle between 0 and 180 degrees is needed");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[1e999,0,0],[1,0,0],[1,1,0]]]})")),
            "s.json:1: a number is too large");
  EXPECT_NE(complaint(withObject(R"({"file": "nosuch.obj"})")).find("No such file"), std::string::npos);
}

// Complaints about light, surfaces, transforms and choices name the place and what is allowed there too.
TEST(SceneFile, ComplaintsOfEachPart) {
  const auto object = [](const std::string& more) {
    return complaint(withObject(R"({"polygons": [[[0,0,0],[1,0,0],[0,1,0]]], )" + more + "}"));
  };
  EXPECT_EQ(object(R"("scale": [1, 2])"), "s.json: objects[0].scale: a list of 3 numbers is needed");
  EXPECT_EQ(object(R"("scale": [1, -2, 1])"), "s.json: objects[0].scale[1]: a number above 0 is needed");
  EXPECT_EQ(object(R"("rotate": 90)"), "s.json: objects[0].rotate: a list [ ] is needed");
  EXPECT_EQ(object(R"("rotate": [0, 0, 1e7])"),
            "s.json: objects[0].rotate[2]: an angle within 1,000,000 degrees is needed");
  EXPECT_EQ(object(R"("rotate": {"axis": [0, 0, 0], "degrees": 3})"),
            "s.json: objects[0].rotate.axis: 0, 0, 0 is not a direction");
  EXPECT_EQ(object(R"("rotate": {"axis": [0, 0, 1]})"), "s.json: objects[0].rotate: degrees is needed");
  EXPECT_EQ(object(R"("rotate": {"angle": 1})"),
            "s.json: objects[0].rotate: unknown key 'angle'; the keys are axis, degrees");
  EXPECT_EQ(object(R"("divisions": 4)"),
            "s.json: objects[0].divisions: divisions apply only to the patches of a .bpt file");
  EXPECT_EQ(object(R"("color": [1, 1, 2])"), "s.json: objects[0].color: r, g, b from 0 to 1 are needed");
  EXPECT_EQ(object(R"("color255": [1, 1, 256])"),
            "s.json: objects[0].color255[2]: a number from 0 to 255 is needed");
  EXPECT_EQ(object(R"("color": [1, 1, 1], "color255": [1, 1, 1])"),
            "s.json: objects[0].color255: the colour is given twice");
  EXPECT_EQ(object(R"("color": [1, 1, 1], "color": [1, 1, 1])"),
            "s.json:1: the key 'color' appears twice in an object");
  EXPECT_EQ(object(R"("material": "tin")"), "s.json: objects[0].material: the file has no materials");
  EXPECT_EQ(
      complaint(
          R"({"materials": {"tin": {}, "bone": {}}, "objects": [{"solid": "cube", "material": "gold"}]})"),
      "s.json: objects[0].material: 'gold' is not one of bone, tin");
  EXPECT_EQ(object(R"("uv": [])"), "s.json: objects[0].uv: a list for each polygon is needed");
  EXPECT_EQ(object(R"("uv": [[[0, 0], [1, 0]]])"),
            "s.json: objects[0].uv[0]: [u, v] for each corner is needed");
  EXPECT_EQ(object(R"("uv": [[[0, 0], [1, 0], [1, 0, 0]]])"),
            "s.json: objects[0].uv[0][2]: a list of 2 numbers is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cube", "uv": []})")),
            "s.json: objects[0].uv: texture coordinates apply only to polygons");

  const auto material = [](const std::string& what) {
    return complaint(R"({"materials": {"tin": )" + what + R"(}, "objects": [)" +
                     kTriangle.substr(0, kTriangle.size() - 1) + R"(, "material": "tin"}]})");
  };
  EXPECT_EQ(material("3"), "s.json: materials.tin: an object { } is needed");
  EXPECT_EQ(material(R"({"shine": 1})"),
            "s.json: materials.tin: unknown key 'shine'; the keys are color, color255, specular, "
            "specular255, ka, kd, "
            "ks, n, texture");
  EXPECT_EQ(material(R"({"kd": 1.5})"), "s.json: materials.tin.kd: a number from 0 to 1 is needed");
  EXPECT_EQ(material(R"({"n": 2.5})"), "s.json: materials.tin.n: a whole number from 0 to 1000000 is needed");
  EXPECT_EQ(material(R"({"texture": 1})"), "s.json: materials.tin.texture: a string is needed");
  EXPECT_EQ(material(R"({"texture": "t.png"})"),
            "s.json: objects[0].material: 'tin' has a texture, but the object has no texture coordinates");
  EXPECT_EQ(complaint(R"({"materials": []})"), "s.json: materials: an object { } is needed");

  const auto light = [](const std::string& what) {
    return complaint(withTriangle(R"("lights": [)" + what + "]"));
  };
  EXPECT_EQ(light(R"({"kind": "sun"})"),
            "s.json: lights[0].kind: 'sun' is not one of directional, point, spot");
  EXPECT_EQ(light(R"({"kind": "point"})"), "s.json: lights[0]: at is missing: the position of the light");
  EXPECT_EQ(light(R"({"at": [0, 0, 1]})"),
            "s.json: lights[0]: unknown key 'at'; the keys are kind, color, Ip, towards");
  EXPECT_EQ(
      light(R"({"kind": "point", "at": [0, 0, 1], "inner": 3})"),
      "s.json: lights[0]: unknown key 'inner'; the keys are kind, color, Ip, at, attenuation, range, c");
  EXPECT_EQ(light(R"({"towards": [0, 0, 0]})"), "s.json: lights[0].towards: 0, 0, 0 is not a direction");
  EXPECT_EQ(light(R"({"Ip": 1.5})"), "s.json: lights[0].Ip: a number from 0 to 1 is needed");
  EXPECT_EQ(light(R"({"Ip": [0, 0, -1]})"), "s.json: lights[0].Ip: r, g, b from 0 to 1 are needed");
  EXPECT_EQ(light(R"({"Ip": 0.5, "color": 0.5})"),
            "s.json: lights[0].Ip: the light has both color and Ip; give one of them");
  const auto placed = [&](const std::string& what) {
    return light(R"({"kind": "spot", "at": [0, 0, 1], )" + what + "}");
  };
  EXPECT_EQ(
      placed(R"("attenuation": "fog")"),
      "s.json: lights[0].attenuation: 'fog' is not one of none, inverse, inverse-square, linear, textbook");
  EXPECT_EQ(placed(R"("range": 3)"), "s.json: lights[0].range: a range applies only to attenuation linear");
  EXPECT_EQ(placed(R"("attenuation": "linear", "range": 0)"),
            "s.json: lights[0].range: a number above 0 is needed");
  EXPECT_EQ(placed(R"("c": [1, 0, 0])"),
            "s.json: lights[0].c: c1, c2 and c3 apply only to attenuation textbook");
  EXPECT_EQ(placed(R"("attenuation": "textbook", "c": [1, -1, 0])"),
            "s.json: lights[0].c: c1, c2 and c3 must not be negative");
  EXPECT_EQ(placed(R"("shines": [0, 0, -1], "look_at": [0, 0, 0])"),
            "s.json: lights[0].look_at: the spot has both shines and look_at; give one of them");
  EXPECT_EQ(placed(R"("look_at": [0, 0, 1])"), "s.json: lights[0]: the spot points at its own position");
  EXPECT_EQ(placed(R"("inner": 30, "outer": 20)"), "s.json: lights[0].inner: inner must not exceed outer");
  EXPECT_EQ(placed(R"("outer": 181)"), "s.json: lights[0].outer: a number from 0 to 180 is needed");
  EXPECT_EQ(placed(R"("falloff": -1)"),
            "s.json: lights[0].falloff: a whole number from 0 to 1000000 is needed");
  EXPECT_EQ(complaint(withTriangle(R"("ambient": "dim")")), "s.json: ambient: a number is needed");
  EXPECT_EQ(complaint(R"({"objects": [{"solid": "cube", "scale": 1e-300}], "lights":
    [{"kind": "point", "at": [1e300, 0, 0]}]})"),
            "s.json: lights[0].at: too large for the size of the scene");

  const auto shading = [](const std::string& what) {
    return complaint(withTriangle(R"("shading": {)" + what + "}"));
  };
  EXPECT_EQ(shading(R"("method": "Gouraud")"),
            "s.json: shading.method: 'Gouraud' is not one of none, depth, flat, gouraud, phong, envmap");
  EXPECT_EQ(shading(R"("normals": 3)"),
            "s.json: shading.normals: '3' is not one of sum, distinct, area, angle, exact, file");
  EXPECT_EQ(shading(R"("shade": "flat")").substr(0, 36), "s.json: shading: unknown key 'shade'");
  EXPECT_EQ(shading(R"("crease": 181)"), "s.json: shading.crease: a number from 0 to 180 is needed");
  EXPECT_EQ(shading(R"("dither": 1)"), "s.json: shading.dither: true or false is needed");
  EXPECT_EQ(shading(R"("ks": -1)"), "s.json: shading.ks: a number from 0 to 1 is needed");
  EXPECT_EQ(shading(R"("Ia": 0.6, "Ip": 0.6)"), "s.json: shading: Ia + Ip must not exceed 1");
  EXPECT_EQ(shading(R"("light": [0, 0, 0])"),
            "s.json: shading.light: three finite numbers x,y,z, not all 0 are needed");
  EXPECT_EQ(shading(R"("table": {"gamma": 2})"),
            "s.json: shading.table: unknown key 'gamma'; the keys are kind, shades, i0, pick, hue, bits");
  EXPECT_EQ(shading(R"("table": {"shades": 1})"),
            "s.json: shading.table.shades: a whole number from 2 to 240 is needed");
  EXPECT_EQ(shading(R"("table": {"i0": 1})"), "s.json: shading.table.i0: a number between 0 and 1 is needed");
  EXPECT_EQ(
      shading(R"("table": {"hue": [0.5, 0, 0]})"),
      "s.json: shading.table.hue: three finite numbers r,g,b from 0 to 1, where the largest is 1 are needed");
  EXPECT_EQ(shading(R"("table": {"bits": 12})"), "s.json: shading.table.bits: '12' is not one of 8, 16");
}

// A number too large and a key given twice are told with their line, like text that is no JSON. This holds
// also if they end the line.
TEST(SceneFile, ComplaintsOfTextNameTheLine) {
  const std::string before = "{\n\"objects\": [\n{\"polygons\": [[[0,0,0],\n[1,0,", after = "0]\n]]}]}";
  EXPECT_EQ(complaint(before + "1e400\n],[0,1," + after), "s.json:4: a number is too large");
  EXPECT_EQ(complaint(before + "1e400],[0,1," + after), "s.json:4: a number is too large");
  EXPECT_EQ(complaint(before + "\n1e400\n],[0,1," + after), "s.json:5: a number is too large");
  EXPECT_EQ(complaint(before + "0\n],[0,1," + after), "no complaint");
  EXPECT_EQ(complaint("{\n\"up\": \"y\",\n\"up\"\n: \"z\"}"),
            "s.json:3: the key 'up' appears twice in an object");
}

// A camera that sees nothing in a picture of any size is a mistake in the file, and is told like one. A
// camera that sees something in a wide picture only, or shows nothing of the scene, is not a mistake.
TEST(SceneFile, ComplaintsOfTheCamera) {
  const auto camera = [](const std::string& what) {
    return complaint(withTriangle(R"("camera": {)" + what + "}"));
  };
  const std::string along = "s.json: camera: the up vector is zero or along the view plane normal";
  const std::string window =
      "s.json: camera: the view window is empty: umin < umax and vmin < vmax are needed";
  const std::string planes = "s.json: camera: the front plane must lie nearer than the back plane (larger n)";
  EXPECT_EQ(camera(R"("eye": [0, 0, 0], "look_at": [0, 0, 0])"),
            "s.json: camera: the view plane normal is zero; eye and look-at point must differ");
  for (const std::string key : {"vpn", "vup", "up"})
    EXPECT_EQ(camera('"' + key + R"(": [0, 0, 0])"),
              "s.json: camera." + key + ": 0, 0, 0 is not a direction");
  EXPECT_EQ(camera(R"("vpn": [0, 0, 2], "vup": [0, 0, -1])"), along);
  EXPECT_EQ(camera(R"("eye": [0, 3, 0], "look_at": [0, 0, 0], "up": [0, 1, 0])"), along);
  EXPECT_EQ(camera(R"("eye": [0, 3, 0], "look_at": [0, 0, 0])"), "no complaint");
  EXPECT_EQ(camera(R"("window": [1, -1, 1, -1])"), window);
  EXPECT_EQ(camera(R"("parallel": true, "window": [-1, 1, 1, 1])"), window);
  EXPECT_EQ(camera(R"("front": -3, "back": -2)"), planes);
  EXPECT_EQ(camera(R"("parallel": true, "front": -3, "back": -2)"), planes);
  EXPECT_EQ(camera(R"("eye": [0, 0, 5], "front": 6)"),
            "s.json: camera: the front plane must lie in front of the eye (n below the projection reference "
            "point's)");
  EXPECT_EQ(camera(R"("front": 6)"), "no complaint");  // the picture's shape decides how far away the eye is
  EXPECT_EQ(camera(R"("prp": [0, 0, -1])"),
            "s.json: camera: the projection reference point must lie in front of the view plane (n > 0)");
  EXPECT_EQ(camera(R"("eye": [0, 0, -5], "look_at": [0, 0, -9])"), "no complaint");
  const auto both = [](const std::string& a, const std::string& b) {
    return "s.json: camera." + b + ": the camera has both " + a + " and " + b + "; give one of them";
  };
  EXPECT_EQ(camera(R"("eye": [0, 0, 5], "vpn": [0, 1, 0])"), both("eye", "vpn"));
  EXPECT_EQ(camera(R"("eye": [0, 0, 5], "prp": [0, 0, 5])"), both("eye", "prp"));
  EXPECT_EQ(camera(R"("look_at": [0, 0, 5], "vrp": [0, 1, 0])"), both("look_at", "vrp"));
  EXPECT_EQ(camera(R"("up": [0, 0, 1], "vup": [0, 1, 0])"), both("up", "vup"));
  EXPECT_EQ(camera(R"("fov": 30, "window": [-1, 1, -1, 1])"), both("fov", "window"));
}

// A key with no effect at its place is refused, and so is one that is given twice.
TEST(SceneFile, ComplaintsOfWhatDoesNotCount) {
  const auto shading = [](const std::string& what, const std::string& beside = "") {
    return complaint(withTriangle(beside + R"("shading": {)" + what + "}"));
  };
  const std::string at = R"("light_at": [0, 0, 9])";
  const std::string noLight =
      "s.json: shading.attenuation: attenuation needs a point light: give light_at. "
      "Each of the scene's lights has its own attenuation";
  EXPECT_EQ(shading(R"("attenuation": "linear")"), noLight);
  EXPECT_EQ(
      shading(R"("attenuation": "linear")", R"("lights": [{"kind": "point", "at": [0, 0, 9], "Ip": 0.5}], )"),
      noLight);
  EXPECT_EQ(shading(R"("attenuation": "none")"), "no complaint");
  EXPECT_EQ(shading(at + R"(, "attenuation": "linear", "range": 20)"), "no complaint");
  EXPECT_EQ(shading(R"("range": 1)"),
            "s.json: shading.range: this setting applies only to attenuation linear");
  EXPECT_EQ(shading(at + R"(, "attenuation": "inverse", "range": 1)"),
            "s.json: shading.range: this setting applies only to attenuation linear");
  EXPECT_EQ(shading(at + R"(, "attenuation": "linear", "c": [1, 0, 0])"),
            "s.json: shading.c: this setting applies only to attenuation textbook");
  EXPECT_EQ(shading(R"("method": "phong", "adapt": 0.1)"),
            "s.json: shading.adapt: this setting applies only to flat and gouraud shading without --mistake");
  EXPECT_EQ(shading(R"("method": "gouraud", "adapt": 0)"), "no complaint");
  EXPECT_EQ(shading(R"("method": "gouraud", "adapt": 0.1)"), "no complaint");

  EXPECT_EQ(shading(R"("Ia": 0.1)", R"("ambient": 0.1, )"),
            "s.json: shading.Ia: the ambient light is given twice: here and in ambient");
  EXPECT_EQ(shading(R"("Ia": 0.1)", R"("lights": [{"Ip": 0.1}], )"), "no complaint");
  for (const std::string key : {"light", "light_at"}) {
    const std::string where = '"' + key + R"(": [0, 0, 9])";
    EXPECT_EQ(shading(where, R"("lights": [{"Ip": 0.1}], )"),
              "s.json: shading." + key + ": the light is given twice: here and in lights");
    EXPECT_EQ(shading(where, R"("ambient": 0.1, )"), "no complaint");
  }

  const auto solid = [](const std::string& what) { return complaint(withObject('{' + what + '}')); };
  EXPECT_EQ(solid(R"("solid": "cube", "around": 5)"),
            "s.json: objects[0].around: applies only to a sphere or a torus");
  EXPECT_EQ(solid(R"("solid": "torus", "down": 5)"), "s.json: objects[0].down: applies only to a sphere");
  EXPECT_EQ(solid(R"("solid": "sphere", "across": 5)"), "s.json: objects[0].across: applies only to a torus");
  EXPECT_EQ(solid(R"("file": "teapot.bpt", "around": 5)"),
            "s.json: objects[0].around: applies only to a sphere or a torus");
  EXPECT_EQ(solid(R"("solid": "sphere", "around": 5, "down": 5)"), "no complaint");
  EXPECT_EQ(solid(R"("solid": "torus", "around": 5, "across": 5)"), "no complaint");
}

// A scene file cut short at any byte is refused, and does no other harm.
TEST(SceneFile, TruncatedAnywhere) {
  const std::string whole =
      R"({"up": "z", "camera": {"eye": [3, 2, 1]}, "ambient": 0.1, "lights": [{"Ip": 0.5}],
    "shading": {"method": "flat", "table": {"shades": 9}}, "materials": {"m": {"ks": 1}}, "objects": [)" +
      kTriangle + R"(, {"solid": "cube", "material": "m", "rotate": [1, 2, 3]}]})";
  EXPECT_EQ(complaint(whole), "no complaint");
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THROW((void)parsed(whole.substr(0, n)), ParseError) << n;
}

}  // namespace xnewell::THIS_FILE
