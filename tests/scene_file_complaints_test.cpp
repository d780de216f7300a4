#include <gtest/gtest.h>

#include "geometry/parse_error.h"
#include "tests/scene_text.h"

// Every complaint names the place and what is allowed there.
TEST(SceneFile, ComplaintsNameThePlace) {
  EXPECT_EQ(complaint("{\n\"objects\": [\n1,,\n]}"), "s.json:3: not JSON here");
  EXPECT_EQ(complaint(""), "s.json:1: not JSON here");
  EXPECT_EQ(complaint("[]"), "s.json: an object { } is needed");
  EXPECT_EQ(complaint("{}"), "s.json: holds no face");
  EXPECT_EQ(complaint(R"({"light": []})"),
            "s.json: unknown key 'light'; there are shows, up, camera, ambient, lights, shading, materials, "
            "objects");
  EXPECT_EQ(complaint(R"({"up": "x"})"), "s.json: up: \"y\" or \"z\" is needed");
  EXPECT_EQ(complaint(R"({"objects": {}})"), "s.json: objects: a list [ ] is needed");
  EXPECT_EQ(complaint(withObject("{}")), "s.json: objects[0]: one of file, polygons and solid is needed");
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
            "s.json: objects[0].file: an .obj or .bpt file is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cube", "scale": 0})")),
            "s.json: objects[0].scale: a number above 0 is needed");
  EXPECT_EQ(complaint(withObject(R"({"solid": "cube", "scale": 1e308, "move": [1e308, 0, 0]})")),
            "s.json: objects[0]: the object is scaled out of range");
  EXPECT_EQ(complaint(R"({"camera": {"fov": 180}, "objects": [)" + kTriangle + "]}"),
            "s.json: camera.fov: an angle between 0 and 180 degrees is needed");
  EXPECT_EQ(complaint(withObject(R"({"polygons": [[[1e999,0,0],[1,0,0],[1,1,0]]]})")),
            "s.json: a number is too large");
  EXPECT_NE(complaint(withObject(R"({"file": "nosuch.obj"})")).find("No such file"), std::string::npos);
}

// The same of light, surfaces, transforms and choices.
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
            "s.json: objects[0].rotate.axis: 0, 0, 0 is no direction");
  EXPECT_EQ(object(R"("rotate": {"axis": [0, 0, 1]})"), "s.json: objects[0].rotate: degrees is needed");
  EXPECT_EQ(object(R"("rotate": {"angle": 1})"),
            "s.json: objects[0].rotate: unknown key 'angle'; there are axis, degrees");
  EXPECT_EQ(object(R"("divisions": 4)"),
            "s.json: objects[0].divisions: divisions are for the patches of a .bpt file");
  EXPECT_EQ(object(R"("color": [1, 1, 2])"), "s.json: objects[0].color: r, g, b from 0 to 1 are needed");
  EXPECT_EQ(object(R"("color255": [1, 1, 256])"),
            "s.json: objects[0].color255[2]: a number from 0 to 255 is needed");
  EXPECT_EQ(object(R"("color": [1, 1, 1], "color255": [1, 1, 1])"),
            "s.json: objects[0].color255: the colour is said twice");
  EXPECT_EQ(object(R"("color": [1, 1, 1], "color": [1, 1, 1])"),
            "s.json: the key 'color' stands twice in an object");
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
            "s.json: objects[0].uv: texture coordinates are for polygons");

  const auto material = [](const std::string& what) {
    return complaint(R"({"materials": {"tin": )" + what + R"(}, "objects": [)" +
                     kTriangle.substr(0, kTriangle.size() - 1) + R"(, "material": "tin"}]})");
  };
  EXPECT_EQ(material("3"), "s.json: materials.tin: an object { } is needed");
  EXPECT_EQ(
      material(R"({"shine": 1})"),
      "s.json: materials.tin: unknown key 'shine'; there are color, color255, specular, specular255, ka, kd, "
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
  EXPECT_EQ(light(R"({"kind": "point"})"), "s.json: lights[0]: at is needed: where the light is");
  EXPECT_EQ(light(R"({"at": [0, 0, 1]})"),
            "s.json: lights[0]: unknown key 'at'; there are kind, color, Ip, towards");
  EXPECT_EQ(light(R"({"kind": "point", "at": [0, 0, 1], "inner": 3})"),
            "s.json: lights[0]: unknown key 'inner'; there are kind, color, Ip, at, attenuation, range, c");
  EXPECT_EQ(light(R"({"towards": [0, 0, 0]})"), "s.json: lights[0].towards: 0, 0, 0 is no direction");
  EXPECT_EQ(light(R"({"Ip": 1.5})"), "s.json: lights[0].Ip: a number from 0 to 1 is needed");
  EXPECT_EQ(light(R"({"Ip": [0, 0, -1]})"), "s.json: lights[0].Ip: r, g, b from 0 to 1 are needed");
  EXPECT_EQ(light(R"({"Ip": 0.5, "color": 0.5})"),
            "s.json: lights[0].Ip: the light's intensity is said twice");
  const auto placed = [&](const std::string& what) {
    return light(R"({"kind": "spot", "at": [0, 0, 1], )" + what + "}");
  };
  EXPECT_EQ(
      placed(R"("attenuation": "fog")"),
      "s.json: lights[0].attenuation: 'fog' is not one of none, inverse, inverse-square, linear, textbook");
  EXPECT_EQ(placed(R"("range": 3)"), "s.json: lights[0].range: a range is for attenuation linear");
  EXPECT_EQ(placed(R"("attenuation": "linear", "range": 0)"),
            "s.json: lights[0].range: a number above 0 is needed");
  EXPECT_EQ(placed(R"("c": [1, 0, 0])"), "s.json: lights[0].c: c1, c2 and c3 are for attenuation textbook");
  EXPECT_EQ(placed(R"("attenuation": "textbook", "c": [1, -1, 0])"),
            "s.json: lights[0].c: c1, c2 and c3 must not be negative");
  EXPECT_EQ(placed(R"("shines": [0, 0, -1], "look_at": [0, 0, 0])"),
            "s.json: lights[0].look_at: where it shines is said twice");
  EXPECT_EQ(placed(R"("look_at": [0, 0, 1])"), "s.json: lights[0]: the spot looks at its own place");
  EXPECT_EQ(placed(R"("inner": 30, "outer": 20)"), "s.json: lights[0].inner: it must not exceed outer");
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
  EXPECT_EQ(shading(R"("normals": 3)"), "s.json: shading.normals: a string is needed");
  EXPECT_EQ(shading(R"("shade": "flat")").substr(0, 36), "s.json: shading: unknown key 'shade'");
  EXPECT_EQ(shading(R"("crease": 181)"), "s.json: shading.crease: a number from 0 to 180 is needed");
  EXPECT_EQ(shading(R"("dither": 1)"), "s.json: shading.dither: true or false is needed");
  EXPECT_EQ(shading(R"("ks": -1)"), "s.json: shading.ks: a number from 0 to 1 is needed");
  EXPECT_EQ(shading(R"("Ia": 0.6, "Ip": 0.6)"), "s.json: shading: Ia + Ip must not exceed 1");
  EXPECT_EQ(shading(R"("light": [0, 0, 0])"), "s.json: shading.light: 0, 0, 0 is no direction");
  EXPECT_EQ(shading(R"("table": {"gamma": 2})"),
            "s.json: shading.table: unknown key 'gamma'; there are kind, shades, i0, pick, hue, bits");
  EXPECT_EQ(shading(R"("table": {"shades": 1})"),
            "s.json: shading.table.shades: a whole number from 2 to 240 is needed");
  EXPECT_EQ(shading(R"("table": {"i0": 1})"), "s.json: shading.table.i0: a number between 0 and 1 is needed");
  EXPECT_EQ(shading(R"("table": {"hue": [0.5, 0, 0]})"),
            "s.json: shading.table.hue: the largest of r, g, b must be 1");
  EXPECT_EQ(shading(R"("table": {"bits": 12})"), "s.json: shading.table.bits: 8 or 16 is needed");
}

// Cutting a scene file short at any byte is refused, never more.
TEST(SceneFile, TruncatedAnywhere) {
  const std::string whole =
      R"({"up": "z", "camera": {"eye": [3, 2, 1]}, "ambient": 0.1, "lights": [{"Ip": 0.5}],
    "shading": {"method": "flat", "table": {"shades": 9}}, "materials": {"m": {"ks": 1}}, "objects": [)" +
      kTriangle + R"(, {"solid": "cube", "material": "m", "rotate": [1, 2, 3]}]})";
  EXPECT_EQ(complaint(whole), "no complaint");
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THROW((void)parsed(whole.substr(0, n)), ParseError) << n;
}
