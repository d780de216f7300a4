#include "shading/laboratory/without.h"

#include <algorithm>

namespace xnewell {

namespace {

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

using Clock = double (*)();

template <class Step>
double timeOf(Clock clock, const Step& step) {
  const double start = clock();
  step();
  return clock() - start;
}

double faceNormals(const Picture& picture, Clock clock) {
  return timeOf(clock, [&] { (void)facePoints(picture.scene().mesh); });
}

double vertexNormals(const Picture& picture, Clock clock) {
  return timeOf(clock, [&] { (void)smoothVertices(picture.scene(), picture.settings()); });
}

double planes(const Picture& picture, Clock clock) {
  const PictureSettings& s = picture.settings();
  const Mesh& mesh = picture.shading().mesh(picture.scene());
  const ConvexParts& parts = picture.shading().parts(picture.scene());
  const ViewSpec& view = picture.camera().view;
  SnappedScene snapped = snap(mesh, parts, view, s.width, s.height, s.cull);
  return timeOf(clock, [&] { addPlanes(snapped, mesh, parts, view, s.width, s.height); });
}

double cutsOfConcaveFaces(const Picture& picture, Clock clock) {
  return timeOf(clock, [&] { (void)divideFaces(picture.scene().mesh); });
}

}  // namespace

const std::vector<CostRow>& costRows() {
  static const std::vector<CostRow> rows{
      {.name = "illumination", .without = [](Scene&, PictureSettings& s) { s.shading = Shading::Full; }},
      {.name = "channels", .without = inGray},
      {.name = "lights", .without = dark},
      {.name = "specular", .without = dull},
      {.name = "eye", .without = [](Scene&, PictureSettings& s) { s.light.constantV = true; }},
      {.name = "places", .without = everywhereTheSame},
      {.name = "spots", .without = openCones},
      {.name = "attenuation", .without = unattenuated},
      {.name = "face_normals", .alone = faceNormals},
      {.name = "vertex_normals", .alone = vertexNormals},
      {.name = "textures", .without = bare},
      {.name = "planes", .alone = planes},
      {.name = "ramps", .without = inGray},  // in one hue alone, a scene with colours computes three channels
      {.name = "cuts_of_concave_faces", .alone = cutsOfConcaveFaces},
  };
  return rows;
}

}  // namespace xnewell
