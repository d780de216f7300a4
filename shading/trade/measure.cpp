#include "shading/trade/measure.h"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include "geometry/view/scene_planes.h"
#include "geometry/view/view.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/required.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

/// How far the other views are turned: azimuth and elevation, in degrees. They are near enough to have the
/// same errors, and every sample falls on another place.
constexpr std::array kTurns{glm::dvec2{-1.5, 1.1}, glm::dvec2{1.7, -0.9}, glm::dvec2{0.8, 1.9}};
std::uint8_t groundOf(const PictureSettings& settings) { return CellPlan{settings.table.kind}[Cell::Well]; }
Palette paletteOf(const Picture& picture) { return picture.palette(CellPlan{picture.settings().table.kind}); }

/// The cells of a palette that the picture or the interface needs: those that do not follow the others. Black
/// and white do not count, because the server has them.
int cellsOf(const Picture& picture) {
  Palette white;
  white.fill({0xffff, 0xffff, 0xffff});
  const CellPlan plan{picture.settings().table.kind};
  const Palette a = picture.palette(plan), b = picture.palette(plan, white);
  int cells = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    cells += a[k] == b[k] && k != plan[Cell::Black] && k != plan[Cell::White];
  return cells;
}

/// Bytes that this program has on the heap; 0 if the system does not tell.
std::int64_t heapBytes() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const struct mallinfo2 heap = ::mallinfo2();
  return static_cast<std::int64_t>(heap.uordblks + heap.hblkhd);
#else
  return 0;
#endif
}

/// The picture, painted, with a camera that stays when the polygons change.
Picture held(const Picture& picture, std::uint8_t ground) {
  PictureSettings settings = picture.settings();
  settings.camera = heldCamera(picture);
  return PictureCache{picture}.make(settings, ground);
}

Errors briefErrors(const Comparison& comparison) {
  Errors errors;
  const std::vector<float> after = comparison.intensityErrors(TableSide::After);
  errors.afterTable = spreadOf(after);
  errors.worst = worstPlaces(comparison, after);
  errors.samples = errors.afterTable.count;
  errors.wrongFaces = comparison.wrongFaceCount();
  return errors;
}

}  // namespace

StageTimes Stages::medians() const {
  const auto median = [&](double StageTimes::*stage) {
    std::vector<double> times;
    for (const StageTimes& t : all_) times.push_back(t.*stage);
    return medianOf(std::move(times));
  };
  return {.shade = median(&StageTimes::shade),
          .transform = median(&StageTimes::transform),
          .sort = median(&StageTimes::sort),
          .fill = median(&StageTimes::fill)};
}

Measure::Measure(const Shared<Scene>& scene, const PictureSettings& settings)
    : scenes_{{scene->divisions, scene}},
      fine_{fineSceneOf(*scene)},
      asked_{held(PictureCache{scenes_.begin()->second}.make(settings), groundOf(settings)).onlyShown()},
      here_{seenFrom(asked_.settings().camera, settings, !fine_)} {
  for (const glm::dvec2& turn : kTurns) try {
      others_.push_back(
          seenFrom(moved(settings.camera, asked_.camera(), *scene, turn.x, turn.y, 1.0), settings, false));
    } catch (const ViewError&) {
      continue;  // nothing can be seen from there
    }
}

const Shared<Scene>& Measure::scene(int divisions) {
  const auto known = scenes_.find(divisions);
  if (known != scenes_.end()) return known->second;
  return scenes_.emplace(divisions, dividedAnew(asked_.scene(), divisions)).first->second;
}

Measure::SeenFrom Measure::seenFrom(const CameraSettings& camera, const PictureSettings& settings,
                                    bool keepsFaces) {
  PictureSettings seen = trueSettings(settings);
  seen.camera = camera;
  const Picture picture = PictureCache{scene(asked_.scene().divisions)}.make(seen);
  auto reference = std::make_shared<Reference>(referenceOf(picture, fine_));
  if (!keepsFaces) reference->keepShownOnly();
  return {camera, std::move(reference)};
}

Measure::Polygons& Measure::polygons(int divisions, const SeenFrom& seen, const Picture& picture) {
  const auto known = polygons_.find({divisions, &seen});
  if (known != polygons_.end()) return known->second;
  // Without finer surfaces the reference of the user's view has the polygons of the set-up.
  const bool same = !fine_ && &seen == &here_ && divisions == asked_.scene().divisions;
  Polygons made{same ? seen.reference : std::make_shared<const PolygonGroundTruth>(picture), {}};
  return polygons_.emplace(std::pair{divisions, &seen}, std::move(made)).first->second;
}

double Measure::rmsOf(const Picture& picture, const SeenFrom& seen) {
  const Palette palette = paletteOf(picture);
  const Comparison comparison{picture, *seen.reference, palette};
  return spreadOf(comparison.intensityErrors(TableSide::After)).rootMeanSquare;
}

std::optional<Measured> Measure::glance(const Configuration& configuration) try {
  constexpr double kEnough = 6;  // ms
  Measured one{.configuration = configuration, .here = {}, .cost = {}};
  PictureSettings settings = configuration.settings;
  settings.camera = here_.camera;
  double all = 0;
  for (int k = 0; k < 9 && all < kEnough; ++k) {
    PictureCache pictures{scene(configuration.divisions)};
    const double start = processorMs();
    const Picture picture = pictures.make(settings, groundOf(configuration.settings));
    const double ms = std::max(processorMs() - start, 1e-6);
    if (k == 0) one.here.afterTable.rootMeanSquare = rmsOf(picture, here_);
    if (k == 0 || ms < one.cost.time.ms) {
      const StageTimes& t = picture.times();  // by the clock on the wall
      const double share = ms / std::max(t.total(), 1e-6);
      one.cost.time.ms = ms;
      one.cost.stages = {.shade = share * t.shade,
                         .transform = share * t.transform,
                         .sort = share * t.sort,
                         .fill = share * t.fill};
    }
    all += ms;
  }
  return one;
} catch (const std::runtime_error&) {
  return std::nullopt;
}

Picture Measure::painted(const Configuration& configuration, const CameraSettings& camera) {
  PictureSettings settings = configuration.settings;
  settings.camera = camera;
  return PictureCache{scene(configuration.divisions)}.make(settings, groundOf(settings));
}

std::string Measure::refusal(const Configuration& configuration) {
  try {
    static_cast<void>(painted(configuration, here_.camera));
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

double Measure::run(const Configuration& configuration, Stages& stages) {
  PictureSettings settings = configuration.settings;
  settings.camera = here_.camera;
  PictureCache pictures{scene(configuration.divisions)};
  const double start = processorMs();
  const Picture picture = pictures.make(settings, groundOf(settings));
  const double ms = processorMs() - start;
  stages.add(picture.times());
  return std::max(ms, 1e-6);
}

Measured Measure::measured(const Configuration& configuration, bool whole) {
  Measured measured;
  measured.configuration = configuration;
  const std::int64_t before = heapBytes();
  const Picture picture = painted(configuration, here_.camera);
  measured.cost.bytes = std::max<std::int64_t>(0, heapBytes() - before);
  measured.cost.polygons = static_cast<std::int64_t>(picture.sorted().fragments.size());
  measured.cost.cells = cellsOf(picture);
  const Palette palette = paletteOf(picture);
  Polygons& faces = polygons(configuration.divisions, here_, picture);
  const Comparison comparison{picture, *here_.reference, palette, *faces.view};
  measured.here = whole ? errorsOf(comparison) : briefErrors(comparison);
  if (whole) {
    if (!faces.off) faces.off = distanceFromPatches(*faces.view);
    measured.here.patches = *faces.off;
  }
  measured.samePixels = picture.image().pixels == asked_.image().pixels && palette == paletteOf(asked_);
  for (const SeenFrom& other : others_)
    measured.elsewhere = std::max(measured.elsewhere, rmsOf(painted(configuration, other.camera), other));
  return measured;
}

/// ---- What each item costs that a picture requires

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
