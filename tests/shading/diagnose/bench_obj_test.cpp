#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "shading/scene/scene.h"
#include "shading/scene/units.h"

namespace xnewell::THIS_FILE {

namespace {

using Json = nlohmann::json;

constexpr const char* kBenchObj = XNEWELL_DATA_DIR "/../x11/example/bench.obj";

/// "0.25": at most seven decimals.
std::string decimal(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7f", v);
  std::string all{text};
  while (all.ends_with('0')) all.pop_back();
  if (all.ends_with('.')) all.pop_back();
  return all == "-0" ? "0" : all;
}

Json sceneFile(const std::string& name) {
  return Json::parse(std::ifstream{XNEWELL_DATA_DIR "/scenes/" + name + ".json"});
}

/// A scene as a file that a student's program reads: places in the world, and faces in the scene's order.
std::string asObj(const Scene& scene) {
  const double unit = std::ldexp(1.0, scene.exponent);
  const auto numbers = [](const Json& list) {
    std::string all;
    for (const double v : list) all += ' ' + decimal(v);
    return all;
  };
  const Json bench = sceneFile("bench"), lamp = bench["lights"][0];
  EXPECT_EQ(bench["up"], "z");
  EXPECT_EQ(lamp["attenuation"], "inverse-square");
  std::string obj =
      "# The scenes bench and bench-n3 for programs that read .obj files. Faces have the scene's numbers.\n"
      "# Camera: eye" +
      numbers(bench["camera"]["eye"]) + ", look-at" + numbers(bench["camera"]["look_at"]) + ", up 0 0 1, " +
      decimal(bench["camera"]["fov"]) + " degrees high.\n# Light: Ia " + decimal(bench["ambient"]) +
      "; a lamp at" + numbers(lamp["at"]) + " with Ip " + decimal(lamp["Ip"]) +
      ", which fades by min(1, 1/d^2).\n# Materials: n is " + decimal(bench["shading"]["n"]) +
      " in bench and " + decimal(sceneFile("bench-n3")["shading"]["n"]) + " in bench-n3.\n";
  for (std::size_t m = 0; m < scene.mesh.materials.size(); ++m) {
    const Reflection r = reflectionOf(scene.mesh.materials[m], scene.settings.light, 0);
    obj += "#   m" + std::to_string(m) + ": ka " + decimal(r.ka) + ", kd " + decimal(r.kd) + ", ks " +
           decimal(r.ks) + "\n";
  }
  for (const glm::dvec3& p : scene.mesh.points)
    obj += "v " + decimal(unit * p.x) + ' ' + decimal(unit * p.y) + ' ' + decimal(unit * p.z) + '\n';
  int material = -1;
  for (int f = 0; f < scene.mesh.faceCount(); ++f) {
    if (scene.mesh.material[f] != material)
      obj += "usemtl m" + std::to_string(material = scene.mesh.material[f]) + '\n';
    obj += 'f';
    for (const int point : scene.mesh.face(f)) obj += ' ' + std::to_string(point + 1);
    obj += '\n';
  }
  return obj;
}

}  // namespace

// The file for students is the scene, to the letter. After a change of the scene, copy the new text from the
// file that a failure names.
TEST(BenchObj, IsTheScene) {
  const std::string obj = asObj(readScene("bench"));
  std::ostringstream stored;
  stored << std::ifstream{kBenchObj}.rdbuf();
  const std::string fresh = ::testing::TempDir() + "bench.obj";
  if (stored.str() != obj) std::ofstream{fresh} << obj;
  EXPECT_TRUE(stored.str() == obj) << "see " << fresh;
  const Scene n3 = readScene("bench-n3"), read = readScene(kBenchObj);
  EXPECT_EQ(read.mesh.faceCount(), n3.mesh.faceCount());
  EXPECT_EQ(read.mesh.corners, n3.mesh.corners);
}

}  // namespace xnewell::THIS_FILE
