#include "x11/lessons/read_exhibit.h"

#include <algorithm>

#include "geometry/view/view.h"
#include "shading/scene/read_camera.h"
#include "shading/scene/read_shading.h"
#include "x11/lessons/exhibit.h"
#include "x11/lessons/lesson_facts.h"

namespace xnewell {

namespace {

/// Puts the faces of the scene in another order: face k is then the old face `listed[k]`.
Scene relisted(const Scene& scene, const std::vector<int>& listed) {
  Mesh mesh = scene.mesh;
  mesh.corners.clear(), mesh.firstCorner = {0}, mesh.group.clear(), mesh.material.clear();
  mesh.normals.clear();
  for (const int face : listed)
    mesh.addFace(scene.mesh.face(face), scene.mesh.group[face], scene.mesh.material[face], {},
                 scene.mesh.normalsOf(face));
  Scene again = makeScene(scene.name, std::move(mesh), scene.up);
  again.exponent = scene.exponent;
  again.camera = scene.camera;
  again.settings = scene.settings;
  again.light = scene.light;
  return again;
}

void readListed(Exhibit& exhibit, const Node& node) {
  const Scene& scene = *exhibit.scene;
  const int faces = scene.mesh.faceCount();
  if (!scene.patches.empty() || !scene.textures.empty()) node.fail("is for scenes of plain polygons");
  if (node.size() != faces) node.fail("all " + std::to_string(faces) + " faces are needed, each once");
  std::vector<int> listed;
  for (int k = 0; k < faces; ++k) {
    listed.push_back(node.item(k).whole(0, faces - 1));
    if (std::ranges::count(listed, listed.back()) > 1) node.item(k).fail("the face is listed twice");
  }
  exhibit.scene = std::make_shared<const Scene>(relisted(scene, listed));
  for (NamedFace& named : exhibit.names)
    named.face = static_cast<int>(std::ranges::find(listed, named.face) - listed.begin());
}

void readNames(Exhibit& exhibit, const Node& node) {
  exhibit.names.clear();
  for (const std::string& name : node.keys()) {
    if (name.empty() || name.size() > 2) node.at(name).fail("a name of one or two letters is needed");
    exhibit.names.push_back({node.at(name).whole(0, exhibit.scene->mesh.faceCount() - 1), name});
  }
}

void readEffects(PaletteEffects& effects, const Node& node) {
  node.expectKeys({"stored", "hue turn", "gamma", "rotate", "lit", "bend"});
  effects = {};
  if (node.has("stored")) effects.stored = node.at("stored").choice(kTables);
  if (node.has("hue turn")) effects.hueTurn = node.at("hue turn").numberFrom(-360, 360);
  if (node.has("gamma")) {
    effects.gamma = node.at("gamma").number();
    if (effects.gamma < kLeastGamma || effects.gamma > kMostGamma)
      node.at("gamma").fail("a number from 0.1 to 10 is needed");
  }
  if (node.has("rotate")) effects.rotate = node.at("rotate").whole(-kMaxShades, kMaxShades);
  if (node.has("lit")) effects.lit = node.at("lit").whole(0, 255);
  if (node.has("bend")) {
    if (node.at("bend").size() != 2) node.at("bend").fail("a cell and its value are needed");
    effects.bend =
        CurvePoint{node.at("bend").item(0).whole(0, 255), node.at("bend").item(1).numberFrom(0, 255)};
  }
}

struct KindRow {
  Event::Kind id;
  std::string_view name;
};
constexpr std::array kKinds{
    KindRow{Event::Kind::Take, "take"},   KindRow{Event::Kind::Compare, "test"},
    KindRow{Event::Kind::Move, "move"},   KindRow{Event::Kind::Cycle, "cycle"},
    KindRow{Event::Kind::Split, "cut"},   KindRow{Event::Kind::Impossible, "impossible"},
    KindRow{Event::Kind::Vain, "vain"},   KindRow{Event::Kind::Void, "contact"},
    KindRow{Event::Kind::Paint, "paint"},
};

EventChoice readEvent(const Node& node) {
  node.expectKeys({"kind", "test", "number", "says"});
  EventChoice event;
  if (node.has("kind") == node.has("test")) node.fail("one of kind and test is needed");
  if (node.has("kind")) event.kind = node.at("kind").choice(kKinds);
  if (node.has("test")) event.test = node.at("test").choice(kTestRows);
  if (node.has("number")) event.number = node.at("number").whole(1, 1'000'000);
  if (node.has("says")) event.says = node.at("says").text();
  return event;
}

Claim readClaim(const std::string& name, const Node& node) {
  Claim claim;
  const std::optional<int> fact = factNamed(name);
  if (!fact) node.fail("there is no such fact; the facts are " + factNames());
  claim.fact = *fact;
  if (!node.isObject()) {
    claim.is = node.number();
    return claim;
  }
  node.expectKeys({"at least", "at most"});
  if (node.has("at least")) claim.least = node.at("at least").number();
  if (node.has("at most")) claim.most = node.at("at most").number();
  if (!claim.least && !claim.most) node.fail("one of at least and at most is needed");
  return claim;
}

/// Reads the settings of a picture from an object.
void readSettings(PictureSettings& settings, const Node& node, const Scene& scene) {
  if (node.has("shading")) {
    readShading(settings, node.at("shading"));
    if (settings.inPixels) node.at("shading").at("fill").fail("lessons are filled by the scanline");
    expectCounts(settings, scene.light, node.at("shading"));
  }
  if (!node.has("camera")) return;
  settings.camera = completed(readCamera(node.at("camera")), scene.camera);
  expectSees(settings.camera, scene, node.at("camera"));
}

void readBeside(Exhibit& exhibit, const Node& node) {
  node.expectKeys({"shading", "camera", "upper", "lower"});
  exhibit.beside = exhibit.settings;
  readSettings(exhibit.beside, node, *exhibit.scene);
  if (exhibit.beside.table != exhibit.settings.table)
    node.at("shading").fail("both pictures are in one colour table");
  if (node.has("upper")) exhibit.upperLine = node.at("upper").text();
  if (node.has("lower")) exhibit.lowerLine = node.at("lower").text();
}

void readScanline(Exhibit& exhibit, const Node& node) {
  node.expectKeys({"bits", "filled"});
  if (node.has("bits")) {
    exhibit.stepBits = node.at("bits").whole(8, 24);
    if (exhibit.stepBits % 8 != 0) node.at("bits").fail("8, 16 or 24");
  }
  if (node.has("filled")) exhibit.filled = node.at("filled").numberFrom(0, 1);
}

}  // namespace

namespace {

void readViewing(Exhibit& exhibit, const Node& node) {
  node.expectKeys({"stage", "shaded in", "vertex"});
  if (node.has("stage")) exhibit.viewStage = node.at("stage").choice(kViewStages);
  exhibit.shadedIn = node.has("shaded in") ? node.at("shaded in").choice(kViewStages) : ViewStage::World;
  if (!node.has("vertex")) return;
  const std::optional<FaceCorner> vertex = cornerOf(exhibit.scene->mesh, node.at("vertex").text());
  if (!vertex) node.at("vertex").fail("the scene has no such vertex");
  exhibit.vertex = *vertex;
}

}  // namespace

std::shared_ptr<const Scene> SceneShelf::scene(const Node& name, int divisions) {
  const std::string text = name.text();
  std::shared_ptr<const Scene>& found = scenes_[{text, divisions}];
  if (found) return found;
  const std::filesystem::path file = isBuiltIn(text) ? std::filesystem::path{text} : namedFile(folder_, text);
  if (!isBuiltIn(text) && !std::filesystem::is_regular_file(file))
    name.fail(inQuotes(text) + " is no built-in scene, and no file beside the lesson");
  Scene scene = readScene(file.string(), divisions);
  scene.name = text;
  found = std::make_shared<const Scene>(std::move(scene));
  return found;
}

void expectExhibitKeys(const Node& node, std::initializer_list<std::string_view> more) {
  node.expectKeys({"scene", "divisions", "listed", "camera", "shading", "window", "line", "names", "extents",
                   "wrong", "beside", "effects", "event", "scanline", "viewing", "claims"},
                  more);
}

Exhibit readExhibit(const Node& node, const Exhibit* base, SceneShelf& shelf) {
  Exhibit exhibit;
  if (base) exhibit = *base;
  exhibit.claims.clear();
  if (!base && !node.has("scene")) node.fail("a scene is needed");
  if (node.has("divisions") && !node.has("scene")) node.at("divisions").fail("goes with a scene");
  if (node.has("scene")) {
    const int divisions = node.has("divisions") ? node.at("divisions").whole(1, 64) : kDefaultDivisions;
    exhibit.scene = shelf.scene(node.at("scene"), divisions);
    exhibit.sceneName = exhibit.scene->name;
    exhibit.settings = exhibit.scene->settings;
    exhibit.settings.camera = exhibit.scene->camera;
    exhibit.settings.inPixels = false;
    exhibit.names.clear();
    exhibit.vertex = {};
  }
  if (node.has("viewing")) readViewing(exhibit, node.at("viewing"));
  if (node.has("names")) readNames(exhibit, node.at("names"));
  if (node.has("listed")) readListed(exhibit, node.at("listed"));
  readSettings(exhibit.settings, node, *exhibit.scene);
  if (node.has("window")) exhibit.stage = node.at("window").choice(kStages);
  if (node.has("line")) exhibit.line = node.at("line").text();
  if (node.has("extents")) exhibit.extents = node.at("extents").truth();
  if (exhibit.extents && exhibit.names.empty())
    node.fail("extents are those of named faces: names are needed");
  if (node.has("wrong")) exhibit.wrongMarked = node.at("wrong").truth();
  if (node.has("effects")) readEffects(exhibit.effects, node.at("effects"));
  if (node.has("event")) exhibit.event = readEvent(node.at("event"));
  if (node.has("scanline")) readScanline(exhibit, node.at("scanline"));
  if (node.has("beside")) readBeside(exhibit, node.at("beside"));
  if (exhibit.stage == Stage::SideBySide && !node.has("beside") &&
      (!base || base->stage != Stage::SideBySide))
    node.fail("side by side needs beside");
  if (node.has("claims"))
    for (const std::string& name : node.at("claims").keys())
      exhibit.claims.push_back(readClaim(name, node.at("claims").at(name)));
  return exhibit;
}

std::optional<int> stepOf(const SortedScene& run, const EventChoice& choice) {
  int left = choice.number;
  for (std::size_t k = 0; k < run.events.size(); ++k) {
    const Event& e = run.events[k];
    const bool one = choice.test ? e.kind == Event::Kind::Compare && e.test == *choice.test
                                 : !choice.kind || e.kind == *choice.kind;
    if (one && --left == 0) return static_cast<int>(k) + 1;
  }
  return std::nullopt;
}

}  // namespace xnewell
