#include "tests/support/random_lit_scenes.h"

#include <array>
#include <nlohmann/json.hpp>
#include <random>

#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "tests/support/scene_text.h"

namespace xnewell {

namespace {

using Json = nlohmann::json;

class Chance {
 public:
  explicit Chance(unsigned seed) : random_{seed} {}
  double within(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  int whole(int low, int high) { return low + static_cast<int>(random_() % (high - low + 1)); }
  bool once(int in) { return whole(1, in) == 1; }
  Json point(double size) { return {within(-size, size), within(-size, size), within(-size, size)}; }

 private:
  std::mt19937 random_;
};

Json randomObject(Chance& chance) {
  Json object{{"color", {chance.within(0.3, 1), chance.within(0.3, 1), chance.within(0.3, 1)}}};
  switch (chance.whole(0, 4)) {
    case 0:
      object["solid"] = "cube";
      break;
    case 1:
      object.update({{"solid", "sphere"}, {"around", chance.whole(5, 40)}, {"down", chance.whole(3, 20)}});
      break;
    case 2:
      object.update({{"solid", "torus"}, {"around", chance.whole(5, 40)}, {"across", chance.whole(4, 20)}});
      break;
    case 3:
      object["file"] = "teapot.bpt";
      break;
    default:
      Json triangles = Json::array();
      for (int k = chance.whole(1, 30); k > 0; --k)
        triangles.push_back({chance.point(1.5), chance.point(1.5), chance.point(1.5)});
      object["polygons"] = triangles;
  }
  if (!object.contains("polygons")) {
    object["scale"] = object.contains("file") ? chance.within(0.2, 0.6) : chance.within(0.3, 1.2);
    object["move"] = chance.point(1.5);
  }
  return object;
}

}  // namespace

LitScene randomLitScene(unsigned seed) {
  Chance chance{seed};
  Json file{{"objects", Json::array()}};
  for (int k = chance.whole(1, 5); k > 0; --k) file["objects"].push_back(randomObject(chance));
  if (chance.once(3))
    file["lights"] = {{{"kind", "point"}, {"Ip", chance.within(0.4, 0.8)}, {"at", chance.point(4)}}};
  LitScene lit{parsed(file.dump()), {}};
  PictureSettings& s = lit.settings;
  s.width = 160, s.height = 120;
  constexpr std::array kMethods{Shading::Flat, Shading::Gouraud, Shading::Phong};
  s.shading = kMethods[chance.whole(0, 2)];
  s.light.kd = chance.within(0.4, 0.9);
  s.light.ks = chance.once(2) ? chance.within(0, 0.6) : 0;
  s.light.n = chance.whole(2, 60);
  const Picture asked = makePicture(lit.scene, s);
  s.camera =
      moved(s.camera, asked.camera(), asked.scene(), chance.within(-180, 180), chance.within(-40, 40), 1.0);
  return lit;
}

}  // namespace xnewell
