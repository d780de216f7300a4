#include "x11/lessons/lesson.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "geometry/files/model_file.h"
#include "geometry/files/text_file.h"
#include "geometry/view/view.h"
#include "shading/scene/json_text.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/settings.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/lessons/lesson_page.h"

namespace xnewell {

namespace {

/// The controls that are no settings of the picture, or that lessons call by another name. The server's
/// filler is not for lessons.
constexpr std::array kOwnControls{
    LessonControl{'l', "light", "light", "turn the light with the arrows"},
    LessonControl{'t', "turn", "turn", "turn the scene with the arrows", "arrows, or drag the picture"},
    LessonControl{'z', "zoom", "zoom", "come nearer or go away with the arrows", "arrows up and down"},
    LessonControl{'P', "projection", "project"},
    LessonControl{'J', "nearest", "nearest", "", "", "table.pick"},
    LessonControl{'L', "L constant", "L const.", "", "the light is far away", "constant_l"},
    LessonControl{'V', "V constant", "V const.", "", "the viewer is far away", "constant_v"},
    LessonControl{'M', "names", "names", "", "name the polygons"},
    LessonControl{'W', "wrong", "wrong", "", "mark them in the picture"},
    LessonControl{'v', "event", "step", "go through the run with the arrows"},
    LessonControl{'m', "rotate", "rotate", "", "move the ramp through its cells"},
    LessonControl{'g', "gamma", "gamma"},
};

constexpr std::size_t kLongestHeading = 26;  // letters of Voice::Title in a column of 320 pixels

/// Reads words with placeholders.
std::string readWords(const Node& node) {
  std::string words = node.text();
  if (const std::string wrong = checkPlaceholders(words); !wrong.empty()) node.fail(wrong);
  return words;
}

void need(const Node& node, std::initializer_list<const char*> keys) {
  for (const char* const key : keys)
    if (!node.has(key)) node.fail(std::string{key} + " is needed");
}

LessonAnswer readAnswer(const Node& node, const StepFigure& figure, SceneShelf& shelf) {
  node.expectKeys({"text", "holds", "says", "shown"});
  need(node, {"text", "says"});
  LessonAnswer answer;
  answer.text = node.at("text").text();
  answer.says = readWords(node.at("says"));
  answer.holds = node.has("holds") && node.at("holds").truth();
  if (!answer.holds && !node.has("shown")) node.fail("shown is needed: a wrong answer must be seen to fail");
  answer.shown = figure;
  answer.shown.claims.clear();
  if (node.has("shown")) {
    expectFigureKeys(node.at("shown"));
    answer.shown = readFigure(node.at("shown"), &figure, shelf);
  }
  return answer;
}

LessonQuestion readQuestion(const Node& node, const StepFigure& figure, SceneShelf& shelf) {
  node.expectKeys({"asks", "hint", "answers"});
  need(node, {"asks", "answers"});
  LessonQuestion question{.asks = node.at("asks").text(), .hint = {}, .answers = {}};
  if (node.has("hint")) question.hint = node.at("hint").text();
  const Node answers = node.at("answers");
  if (answers.size() < 2 || answers.size() > kMostAnswers) answers.fail("2 to 4 answers are needed");
  for (int k = 0; k < answers.size(); ++k)
    question.answers.push_back(readAnswer(answers.item(k), figure, shelf));
  if (std::ranges::count(question.answers, true, &LessonAnswer::holds) != 1)
    answers.fail("exactly one answer must hold");
  return question;
}

LessonStep readStep(const Node& node, const StepFigure* before, SceneShelf& shelf) {
  expectFigureKeys(node, {"heading", "caption", "controls", "question"});
  need(node, {"heading", "caption"});
  LessonStep step;
  step.heading = node.at("heading").text();
  if (step.heading.empty() || step.heading.size() > kLongestHeading)
    node.at("heading").fail("1 to 26 characters are needed");
  const Node caption = node.at("caption");
  if (caption.size() == 0) caption.fail("a paragraph is needed");
  for (int k = 0; k < caption.size(); ++k) step.caption.push_back(readWords(caption.item(k)));
  step.figure = readFigure(node, before, shelf);
  if (node.has("controls")) {
    const Node controls = node.at("controls");
    for (int k = 0; k < controls.size(); ++k) {
      step.controls.push_back(controls.item(k).choice(lessonControls()));
      if (std::ranges::count(step.controls, step.controls.back()) > 1)
        controls.item(k).fail("the control is listed twice");
    }
  }
  if (node.has("question")) step.question = readQuestion(node.at("question"), step.figure, shelf);
  return step;
}

LessonEntry readEntry(const Node& root) {
  need(root, {"title"});
  LessonEntry entry;
  entry.title = root.at("title").text();
  if (root.has("shows")) entry.shows = root.at("shows").text();
  if (root.has("number")) entry.number = root.at("number").whole(1, 99);
  return entry;
}

}  // namespace

const std::vector<LessonControl>& lessonControls() {
  static const std::vector<LessonControl> rows = [] {
    std::vector<LessonControl> all;
    for (const Setting& setting : settingRows())
      if (setting.control != 0 && setting.key != "fill" &&
          std::ranges::find(kOwnControls, setting.key, &LessonControl::setting) == kOwnControls.end())
        all.push_back({setting.control, setting.label, setting.label});
    all.insert(all.end(), kOwnControls.begin(), kOwnControls.end());
    return all;
  }();
  return rows;
}

Lesson parseLesson(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
  const JsonText json{text, name};
  const Node root = json.root();
  root.expectKeys({"title", "number", "shows", "steps"});
  need(root, {"title", "steps"});
  const LessonEntry entry = readEntry(root);
  Lesson lesson{.name = std::filesystem::path{name}.stem().string(),
                .title = entry.title,
                .shows = entry.shows,
                .number = entry.number,
                .steps = {}};
  const Node steps = root.at("steps");
  if (steps.size() < 1 || steps.size() > kMostSteps) steps.fail("1 to 12 steps are needed");
  SceneShelf shelf{folder};
  for (int k = 0; k < steps.size(); ++k)
    lesson.steps.push_back(readStep(steps.item(k), k > 0 ? &lesson.steps.back().figure : nullptr, shelf));
  return lesson;
}

Lesson readLesson(const std::filesystem::path& file) {
  Lesson lesson = parseLesson(readTextFile(file), file.string(), file.parent_path());
  lesson.source = file.parent_path() == dataFolder() / "lessons" ? lesson.name : file.string();
  return lesson;
}

std::vector<LessonEntry> builtInLessons() {
  std::vector<LessonEntry> lessons;
  for (const auto& found : std::filesystem::directory_iterator{dataFolder() / "lessons"}) {
    if (found.path().extension() != ".json") continue;
    const std::string name = found.path().string();
    LessonEntry entry =
        readEntry(JsonText{readTextFile(found.path()), name, {"title", "number", "shows"}}.root());
    entry.name = found.path().stem().string();
    entry.file = found.path();
    lessons.push_back(std::move(entry));
  }
  std::ranges::sort(lessons, {}, [](const LessonEntry& e) { return std::pair{e.number, e.name}; });
  return lessons;
}

std::vector<LectureEntry> builtInLectures() {
  std::vector<LectureEntry> lectures;
  for (const auto& found : std::filesystem::directory_iterator{dataFolder() / "lectures"}) {
    if (found.path().extension() != ".json") continue;
    const JsonText json{readTextFile(found.path()), found.path().string(), {"shows"}};
    const Node root = json.root();
    lectures.push_back({found.path().stem().string(), root.has("shows") ? root.at("shows").text() : ""});
  }
  std::ranges::sort(lectures, {}, &LectureEntry::name);
  return lectures;
}

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

void readListed(StepFigure& figure, const Node& node) {
  const Scene& scene = *figure.scene;
  const int faces = scene.mesh.faceCount();
  if (!scene.patches.empty() || !scene.textures.empty()) node.fail("is for scenes of plain polygons");
  if (node.size() != faces) node.fail("all " + std::to_string(faces) + " faces are needed, each once");
  std::vector<int> listed;
  for (int k = 0; k < faces; ++k) {
    listed.push_back(node.item(k).whole(0, faces - 1));
    if (std::ranges::count(listed, listed.back()) > 1) node.item(k).fail("the face is listed twice");
  }
  figure.scene = std::make_shared<const Scene>(relisted(scene, listed));
  for (NamedFace& named : figure.names)
    named.face = static_cast<int>(std::ranges::find(listed, named.face) - listed.begin());
}

void readNames(StepFigure& figure, const Node& node) {
  figure.names.clear();
  for (const std::string& name : node.keys()) {
    if (name.empty() || name.size() > 2) node.at(name).fail("a name of one or two letters is needed");
    figure.names.push_back({node.at(name).whole(0, figure.scene->mesh.faceCount() - 1), name});
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

void readBeside(StepFigure& figure, const Node& node) {
  node.expectKeys({"shading", "camera", "upper", "lower"});
  figure.beside = figure.settings;
  readSettings(figure.beside, node, *figure.scene);
  if (figure.beside.table != figure.settings.table)
    node.at("shading").fail("both pictures are in one colour table");
  if (node.has("upper")) figure.upperLine = node.at("upper").text();
  if (node.has("lower")) figure.lowerLine = node.at("lower").text();
}

void readScanline(StepFigure& figure, const Node& node) {
  node.expectKeys({"bits", "filled"});
  if (node.has("bits")) {
    figure.stepBits = node.at("bits").whole(8, 24);
    if (figure.stepBits % 8 != 0) node.at("bits").fail("8, 16 or 24");
  }
  if (node.has("filled")) figure.filled = node.at("filled").numberFrom(0, 1);
}

}  // namespace

namespace {

void readViewing(StepFigure& figure, const Node& node) {
  node.expectKeys({"stage", "shaded in", "vertex"});
  if (node.has("stage")) figure.viewStage = node.at("stage").choice(kViewStages);
  figure.shadedIn = node.has("shaded in") ? node.at("shaded in").choice(kViewStages) : ViewStage::World;
  if (!node.has("vertex")) return;
  const std::optional<FaceCorner> vertex = cornerOf(figure.scene->mesh, node.at("vertex").text());
  if (!vertex) node.at("vertex").fail("the scene has no such vertex");
  figure.vertex = *vertex;
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

void expectFigureKeys(const Node& node, std::initializer_list<std::string_view> more) {
  node.expectKeys({"scene", "divisions", "listed", "camera", "shading", "window", "line", "names", "extents",
                   "wrong", "beside", "effects", "event", "scanline", "viewing", "claims"},
                  more);
}

StepFigure readFigure(const Node& node, const StepFigure* base, SceneShelf& shelf) {
  StepFigure figure;
  if (base) figure = *base;
  figure.claims.clear();
  if (!base && !node.has("scene")) node.fail("a scene is needed");
  if (node.has("divisions") && !node.has("scene")) node.at("divisions").fail("goes with a scene");
  if (node.has("scene")) {
    const int divisions = node.has("divisions") ? node.at("divisions").whole(1, 64) : kDefaultDivisions;
    figure.scene = shelf.scene(node.at("scene"), divisions);
    figure.sceneName = figure.scene->name;
    figure.settings = figure.scene->settings;
    figure.settings.camera = figure.scene->camera;
    figure.settings.inPixels = false;
    figure.names.clear();
    figure.vertex = {};
  }
  if (node.has("viewing")) readViewing(figure, node.at("viewing"));
  if (node.has("names")) readNames(figure, node.at("names"));
  if (node.has("listed")) readListed(figure, node.at("listed"));
  readSettings(figure.settings, node, *figure.scene);
  if (node.has("window")) figure.stage = node.at("window").choice(stageRows());
  if (node.has("line")) figure.line = node.at("line").text();
  if (node.has("extents")) figure.extents = node.at("extents").truth();
  if (figure.extents && figure.names.empty()) node.fail("extents are those of named faces: names are needed");
  if (node.has("wrong")) figure.wrongMarked = node.at("wrong").truth();
  if (node.has("effects")) readEffects(figure.effects, node.at("effects"));
  if (node.has("event")) figure.event = readEvent(node.at("event"));
  if (node.has("scanline")) readScanline(figure, node.at("scanline"));
  if (node.has("beside")) readBeside(figure, node.at("beside"));
  if (figure.stage == View::SideBySide && !node.has("beside") && (!base || base->stage != View::SideBySide))
    node.fail("side by side needs beside");
  if (node.has("claims"))
    for (const std::string& name : node.at("claims").keys())
      figure.claims.push_back(readClaim(name, node.at("claims").at(name)));
  return figure;
}

std::vector<StageRow> stageRows() {
  std::vector<StageRow> rows;
  for (const View view : {View::Picture, View::DepthSort, View::Colors, View::MachBands, View::SideBySide,
                          View::Scanline, View::Viewing}) {
    rows.push_back({view, std::string{rowOf(view).title}});
    std::ranges::transform(rows.back().name, rows.back().name.begin(),
                           [](char c) { return std::tolower(c); });
  }
  return rows;
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
