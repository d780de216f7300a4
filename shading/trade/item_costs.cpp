#include "shading/trade/item_costs.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "geometry/view/scene_planes.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/required.h"

namespace xnewell {

namespace {

using Step = std::function<void()>;

glm::dvec3 grayOf(const glm::dvec3& color) { return glm::dvec3{luminance(color)}; }

void inGray(Scene& scene, PictureSettings& settings) {
  for (MeshMaterial& m : scene.mesh.materials) m.diffuse = grayOf(m.diffuse), m.specular = grayOf(m.specular);
  for (Light& light : scene.light.lights) light.Ip = grayOf(light.Ip);
  if (scene.light.Ia) scene.light.Ia = grayOf(*scene.light.Ia);
  for (Texture& t : scene.textures) t.channel = {t.gray, t.gray, t.gray}, t.colored = false;
  settings.colors = ColorPlan::OneHue;
}

void dark(Scene& scene, PictureSettings& settings) {
  scene.light.lights.clear();
  settings.light.Ip = 0.0;
}

void dull(Scene& scene, PictureSettings& settings) {
  for (MeshMaterial& m : scene.mesh.materials) m.ks = 0.0;
  settings.light.ks = 0.0;
}

void everywhereTheSame(Scene& scene, PictureSettings& settings) {
  settings.light.constantL = settings.light.constantV = true;
  for (Light& light : scene.light.lights)  // a cone is at a place, whatever L is
    if (light.kind == LightKind::Spot) light.kind = LightKind::Point;
}

void openCones(Scene& scene, PictureSettings&) {
  for (Light& light : scene.light.lights)
    if (light.kind == LightKind::Spot) light.kind = LightKind::Point;
}

void unattenuated(Scene&, PictureSettings& settings) { settings.light.attenuation = Attenuation::None; }

void bare(Scene& scene, PictureSettings&) {
  for (MeshMaterial& m : scene.mesh.materials) m.texture = -1;
  scene.textures.clear();
}

Step planes(const Picture& picture) {
  const PictureSettings& s = picture.settings();
  const Mesh& mesh = picture.shading().mesh(picture.scene());
  const ConvexParts& parts = picture.shading().parts(picture.scene());
  return [&, snapped = snap(mesh, parts, picture.camera().view, s.width, s.height, s.cull)]() mutable {
    ScenePlanes{snapped, mesh, parts, picture.camera().view, s.width, s.height}.makeAll();
  };
}

/// One channel and one ramp are the least that a picture can have.
bool isRequired(const Required& item) {
  return std::visit([](auto what) { return what > decltype(what){0}; }, item.what) &&
         !(item.name == "channels" && std::get<std::int64_t>(item.what) == 1) &&
         !(item.name == "ramps" && std::get<std::int64_t>(item.what) == 1);
}

double timeOf(const Step& step) {
  const double start = processorMs();
  step();
  return std::max(processorMs() - start, 1e-6);
}

}  // namespace

const std::vector<ItemRow>& itemRows() {
  static const std::vector<ItemRow> rows{
      {.name = "illumination", .without = [](Scene&, PictureSettings& s) { s.shading = Shading::Full; }},
      {.name = "channels", .without = inGray},
      {.name = "lights", .without = dark},
      {.name = "specular", .without = dull},
      {.name = "eye", .without = [](Scene&, PictureSettings& s) { s.light.constantV = true; }},
      {.name = "places", .without = everywhereTheSame},
      {.name = "spots", .without = openCones},
      {.name = "attenuation", .without = unattenuated},
      {.name = "face_normals",
       .alone = [](const Picture& p) -> Step { return [&p] { (void)facePoints(p.scene().mesh); }; }},
      {.name = "vertex_normals",
       .alone = [](const Picture& p) -> Step {
         return [&p] { (void)smoothVertices(p.scene(), p.settings()); };
       }},
      {.name = "textures", .without = bare},
      {.name = "planes", .alone = planes},
      {.name = "ramps", .without = inGray},  // in one hue alone, a scene with colours computes three channels
      {.name = "cuts_of_concave_faces",
       .alone = [](const Picture& p) -> Step { return [&p] { (void)divideFaces(p.scene().mesh); }; }},
  };
  return rows;
}

std::vector<ItemCost> itemCostsOf(const Picture& picture, const TimingLimits& limits,
                                  const TimingProgress& goOn) {
  std::vector<Timed> ways;
  // A scene is changed anew each time: several large ones might not fit into memory.
  const auto make = [&](void (*without)(Scene&, PictureSettings&)) {
    ways.push_back([&picture, without] {
      Scene scene = picture.scene();
      PictureSettings settings = picture.settings();
      settings.lights.reset();  // the scene has them
      if (without != nullptr) without(scene, settings);
      PictureCache pictures{std::move(scene)};
      return timeOf([&] { (void)pictures.make(settings, picture.ground()); });
    });
  };
  make(nullptr);
  const std::vector<Required> required = requiredBy(picture);
  std::vector<const ItemRow*> rows;
  for (const ItemRow& row : itemRows()) {
    if (!isRequired(*std::ranges::find(required, row.name, &Required::name))) continue;
    rows.push_back(&row);
    if (row.alone != nullptr)
      ways.push_back([&picture, &row] { return timeOf(row.alone(picture)); });
    else
      make(row.without);
  }
  const Timings timings = timeAll(ways, limits, goOn);
  std::vector<ItemCost> costs;
  for (std::size_t k = 0; timings.rounds > 0 && k < rows.size(); ++k) {
    const Timing& way = timings.of[k + 1];
    const double saved = way.tie ? 0.0 : timings.of[0].ms * (1.0 - way.ratio);
    costs.push_back({rows[k]->name, rows[k]->alone != nullptr ? way.ms : saved});
  }
  return costs;
}

}  // namespace xnewell
