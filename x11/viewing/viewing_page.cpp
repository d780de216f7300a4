#include "x11/viewing/viewing_page.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/options/options.h"

namespace xnewell {

namespace {

/// What a stage is called in a title and in a sentence; `parallel`: other words in a parallel projection.
struct StageWords {
  std::string_view title, deed, parallelTitle = {}, parallelDeed = {};
};
constexpr std::array<StageWords, kViewStages.size()> kStageWords{{
    {"the scene as it was built; light is computed here", "the world"},
    {"VRP is the origin; u, v and n are the axes", "the turn"},
    {"the eye is the origin, the pyramid stands upright", "the shear",
     "the volume stands upright, projectors run along z", "the shear"},
    {"near things grow, and the pyramid becomes a box", "the warp",
     "no warp here, the volume is scaled to a box of one size", "the scaling"},
    {"what lies in front, behind or far outside is cut off", "the clipping"},
    {"pixels; x runs right, y down, z towards you", "the viewport"},
    {"each vertex goes to a grid of 1/65,536 pixel", "the viewport"},
}};

bool isParallel(const ViewingStory& story) {
  return story.stages.letters(ViewStage::Sheared) == rowOf(ViewStage::Sheared).parallel;
}
std::string deedOf(const ViewingStory& story, ViewStage stage) {
  const StageWords& words = kStageWords[static_cast<std::size_t>(stage)];
  return std::string{isParallel(story) && !words.parallelDeed.empty() ? words.parallelDeed : words.deed};
}
std::string nameWithNumber(ViewStage stage) {
  return std::to_string(static_cast<int>(stage) + 1) + ' ' + std::string{rowOf(stage).name};
}
/// Up to the shear a stage has lengths; from the warp on, shares of the volume and then pixels.
double unitAt(ViewStage stage, double unit) { return stage <= ViewStage::Sheared ? unit : 1.0; }
glm::dvec4 inUnit(const glm::dvec4& p, double unit) { return {glm::dvec3{p} / unit, p.w}; }
bool hasMatrix(ViewStage stage) { return stage != ViewStage::Clipped && stage != ViewStage::Snapped; }
std::string three(double v) { return fixed(v, 3); }

}  // namespace

double lengthUnit(const Scene& scene) {
  constexpr int kMostExponent = 20;
  return std::abs(scene.exponent) > kMostExponent ? 1.0 : std::ldexp(1.0, -scene.exponent);
}

std::string lengthsText(const Scene& scene) {
  return lengthUnit(scene) == std::ldexp(1.0, -scene.exponent)
             ? ""
             : "lengths are multiples of 2^" + std::to_string(scene.exponent) + " of the file's";
}

FaceCorner vertexOf(const Picture& picture, const std::string& text) {
  if (text.empty()) return middleCorner(picture);
  const Mesh& mesh = picture.scene().mesh;
  if (const std::optional<FaceCorner> vertex = cornerOf(mesh, text)) return *vertex;
  throw UsageError{"--viewing: the scene has no vertex " + text + ": it has " +
                   grouped(static_cast<std::int64_t>(mesh.points.size())) + " vertices and " +
                   counted(mesh.faceCount(), "face") + ", counted from 0, and corners from 1"};
}

std::string partOf(const Scene& scene, const FaceCorner& vertex) {
  const std::string& group = scene.mesh.groupNames[scene.mesh.group[vertex.face]];
  return group.empty() ? "face " + std::to_string(vertex.face) : group;
}

glm::dvec4 shownAt(const ViewingStory& story, ViewStage stage, double unit) {
  return inUnit(story.of(stage).at, unitAt(stage, unit));
}

MatrixWithVertex matrixOf(const ViewingStory& story, ViewStage stage, ShownMatrix shown, double unit) {
  const ViewStages& s = story.stages;
  const bool toScreen = shown == ShownMatrix::ToTheScreen, all = shown == ShownMatrix::AllSoFar;
  const auto before = static_cast<ViewStage>(std::max(0, static_cast<int>(stage) - 1));
  const ViewStage from = toScreen ? stage : all ? ViewStage::World : before;
  const double fromUnit = unitAt(from, unit), toUnit = unitAt(toScreen ? ViewStage::Viewport : stage, unit);
  MatrixWithVertex m{.matrix = toScreen ? s.toScreen(stage)
                               : all    ? s.soFar(stage)
                                        : s.matrix(stage),
                     .from = story.of(from).at};
  m.to = m.matrix * m.from;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) m.matrix[column][row] /= toUnit;
    if (column < 3) m.matrix[column] *= fromUnit;
  }
  m.from = inUnit(m.from, fromUnit), m.to = inUnit(m.to, toUnit);
  return m;
}

std::string stageTitle(const ViewingStory& story, ViewStage stage) {
  const StageWords& words = kStageWords[static_cast<std::size_t>(stage)];
  return nameWithNumber(stage) + ": " +
         std::string{isParallel(story) && !words.parallelTitle.empty() ? words.parallelTitle : words.title};
}

page::Finding findingOf(const ViewingStory& story, ViewStage stage) {
  const VertexAtStage &here = story.of(stage), &world = story.world();
  if (!world.NdotL && !world.equation.lights.empty())
    return {"This face has no area.", "It has no plane and no N, so only ambient light reaches it. I is " +
                                          three(world.I) + " at every stage, and no picture shows it."};
  if (!world.NdotL)
    return {"All light is ambient.",
            "The equation asks for no N and no L, so I is " + three(world.I) + " at every stage."};
  const std::string numbers = "N.L is " + three(*here.NdotL) + " and I is " + three(here.I);
  if (stage == ViewStage::World)
    return {"Light is computed here.", numbers +
                                           ". N, L and V have their true angles. Each later stage shows "
                                           "what the equation would have there."};
  if (here.keepsAngles) {
    if (stage == ViewStage::Vrc) return {"A turn keeps angles.", numbers + " as in the world."};
    if (stage > ViewStage::Sheared)
      return {"The same scale in x, y and z keeps angles.", numbers + " as in the world."};
    return {"Nothing is sheared: angles stay.",
            numbers + " as in the world. The window's middle is straight before the " +
                (isParallel(story) ? "projectors." : "eye.")};
  }
  // The first stage that does not keep angles: from there on, light would be wrong.
  int first = 1;
  while (story.at[static_cast<std::size_t>(first)].keepsAngles) ++first;
  const std::string deed = deedOf(story, static_cast<ViewStage>(first));
  std::string why = first < static_cast<int>(stage) ? "From " + deed + " on, angles are not kept"
                    : first == 2 ? "The shear leans each plane, and N with it; L goes along as a direction"
                                 : "Up to here all angles stayed, but " + deed + " does not keep them";
  if (!story.differsInNdotL(stage) && !story.differsInI(stage)) {
    why += ": this plane's N.L is still " + three(*here.NdotL) + ", by chance or because it faces away.";
  } else {
    why += ": N.L " + three(*world.NdotL) + " becomes " + three(*here.NdotL) + ", and the equation gives " +
           three(here.I) + " for " + three(world.I);
    if (const int cells = here.cell.value_or(0) - world.cell.value_or(0); here.cell && world.cell)
      why += cells == 0 ? ", here the same cell"
                        : ": " + counted(std::abs(cells), "cell") + (cells > 0 ? " too bright" : " too dark");
    why += ". So compute I in the world.";
  }
  return {"Shade in the world, not behind " + deed + ".", std::move(why), true};
}

void drawAngle(Pen& pen, const Rect& box, const ViewingStory& story, ViewStage stage, bool lit) {
  pen.paint.fillRect(box, pen(Cell::White));
  pen.paint.frame(box, pen(Cell::Rule));
  const VertexAtStage& here = story.of(stage);
  const bool wrong = lit && (story.differsInNdotL(stage) || story.differsInI(stage));
  const Cell cell = wrong ? Cell::Alarm : Cell::Ink;
  const int right = box.x + box.width - 7, pitch = (box.height - 8) / 4;
  int y = box.y + pitch;
  pen.boldRight(right, y, rowOf(stage).name);
  Painter paint = pen.paint.within(box);
  // An L below the surface needs room there.
  const double below = here.NdotL ? std::clamp(-*here.NdotL, 0.0, 1.0) : 0.0;
  constexpr int kLetter = 13;
  const int cx = box.x + 58, foot = below > 0 ? kLetter : 0,
            reach = std::min(44, static_cast<int>((box.height - 26 - foot) / (1 + below))),
            cy = box.y + box.height - 9 - foot - static_cast<int>(reach * below);
  paint.hline(cx - 40, cy, 74, pen(Cell::Faint));
  const auto arrow = [&](double angle, std::string_view name, Cell as) {
    const double dx = -std::sin(angle), dy = -std::cos(angle);
    const auto at = [](double v) { return static_cast<int>(std::lround(v)); };
    const int tx = at(cx + reach * dx), ty = at(cy + reach * dy);
    paint.line(cx, cy, tx, ty, pen(as), {.thickness = name == "N" ? 2 : 1});
    for (const double side : {-1.0, 1.0})
      paint.line(tx, ty, at(tx - 6 * dx + side * 3 * dy), at(ty - 6 * dy - side * 3 * dx), pen(as));
    paint.text(std::clamp(at(tx + 8 * dx) - 3, box.x + 3, right - 60),
               std::clamp(at(ty + 7 * dy) + 4, box.y + 12, box.y + box.height - 4), name, pen(as),
               Voice::Bold);
  };
  if (here.N != glm::dvec3{0.0}) arrow(0.0, "N", Cell::Ink);
  const double angle = here.NdotL ? std::acos(std::clamp(*here.NdotL, -1.0, 1.0)) : 0.0;
  if (here.NdotL) arrow(angle, "L", cell);
  pen.softRight(right, y += pitch,
                here.NdotL                     ? fixed(angle * 57.29577951308232, 1) + "\u00B0"
                : here.equation.lights.empty() ? "no L"
                                               : "no N");
  if (!lit) return;
  paint.textRight(right, y += pitch, "I " + three(here.I), pen(cell), Voice::Bold);
  if (!here.cell) return;
  paint.textRight(right - 26, y += pitch, std::to_string(*here.cell), pen(Cell::Soft));
  const Rect swatch{right - 22, y - 9, 22, 10};
  paint.fillRect(swatch, static_cast<std::uint8_t>(*here.cell));
  paint.frame(swatch, pen(Cell::Ink));
}

namespace page {

namespace {

/// What clipping does to the vertex and its face.
std::string clippedWords(const ViewingStory& story) {
  if (story.faceGone) return "the whole face lies outside: nothing of it is left";
  if (story.cut == 0) return "inside all six planes: nothing is cut, the numbers stay";
  std::string names;
  int count = 0;
  for (int k = 0; k < 6; ++k)
    if (story.cut >> k & 1u) names += (count++ > 0 ? ", " : "") + std::string{clipPlaneName(k)};
  return std::to_string(count) + " of the six planes cut" + (count == 1 ? "s" : "") + " the face (" + names +
         "): " + (story.outside == 0 ? "this vertex stays" : "this vertex is cut off");
}

/// "18,344,551  24,581,568  23,474,405 steps of 1/65,536 pixel"
std::string snappedWords(const ViewingStory& story) {
  if (!story.snapped) return "this vertex is cut off, so it is not snapped";
  const glm::ivec3 p = *story.snapped;
  return grouped(p.x) + "  " + grouped(p.y) + "  " + grouped(p.z) + " steps of 1/65,536 pixel" +
         (story.zShift > 0 ? ", z of " + grouped(1 << std::min(story.zShift, 30)) + "/65,536" : "");
}

/// "z = 0.1234 x - 0.5678 y + 12.34": the plane from the snap on, in pixels.
std::string planeWords(const ViewingStory& story) {
  if (!story.plane) return "the picture has no polygon of this face";
  const auto term = [](double v, const char* of) {
    return (v < 0 ? " - " : " + ") + fitted(std::abs(v), 4, 11) + of;
  };
  const glm::dvec3 k = *story.plane;
  return "z = " + fitted(k.x, 4, 11) + " x" + term(k.y, " y") + term(k.z, "");
}

List rowsOf(const glm::dmat4& m) {
  List rows;
  for (int row = 0; row < 4; ++row) rows.push_back(List{m[0][row], m[1][row], m[2][row], m[3][row]});
  return rows;
}
List namesOf(unsigned planes) {
  List names;
  for (int k = 0; k < 6; ++k)
    if (planes >> k & 1u) names.push_back(clipPlaneName(k));
  return names;
}

Entry number(double v, bool differs = false) {
  return {.tone = differs ? Tone::Alarm : Tone::Ink, .number = v};
}

/// A row for each stage, with a chosen one, or none.
Table stageTable(const OfViewing& of, int chosen) {
  const ViewingStory& story = *of.story;
  const double unit = lengthUnit(of.picture.scene());
  Table t{.columns = {{.weight = 2}, {"stage"}}, .chosen = chosen, .least = 7, .id = kPressStage};
  for (const char* name : {"x", "y", "z", "w", "Nx", "Ny", "Nz", "N.L", "I"})
    t.columns.push_back({.head = name, .right = true});
  t.columns.push_back({.head = "cell", .weight = 4});
  t.columns.push_back({.weight = 1});
  for (const ViewStageRow& row : kViewStages) {
    const VertexAtStage& here = story.of(row.id);
    std::vector<Entry>& cells = t.rows.emplace_back();
    cells = {{std::to_string(t.rows.size())}, {std::string{rowOf(row.id).name}}};
    glm::dvec4 p = shownAt(story, row.id, unit);
    const bool snapped = row.id == ViewStage::Snapped;
    if (row.id == ViewStage::Clipped || (snapped && !story.snapped)) {
      const bool whole = story.cut == 0 && !story.faceGone;
      cells.push_back({.words = snapped ? snappedWords(story) : clippedWords(story),
                       .tone = snapped || whole ? Tone::Soft : Tone::Ink,
                       .span = 11});
      continue;
    }
    if (snapped) {
      p = {glm::dvec3{*story.snapped} / double{kGrid}, 1.0};
      p.z = std::ldexp(p.z, story.zShift);
    }
    for (int k = 0; k < 3; ++k) cells.push_back(number(p[k]));
    if (snapped) {
      cells.push_back({.words = "whole steps; plane " + planeWords(story), .tone = Tone::Soft, .span = 8});
      continue;
    }
    cells.push_back(p.w == 1.0 ? Entry{"1"} : number(p.w));
    for (int k = 0; k < 3; ++k) cells.push_back(number(here.N[k]));
    const bool differs = story.differsInNdotL(row.id), dim = story.differsInI(row.id);
    cells.push_back(here.NdotL ? number(*here.NdotL, differs) : Entry{"-"});
    cells.push_back(number(here.I, dim));
    cells.push_back({.words = here.cell ? std::to_string(*here.cell) : "", .swatch = here.cell});
    cells.push_back({differs || dim ? "not the world's" : ""});
  }
  return t;
}

/// A matrix between brackets, times the vertex before it, is the vertex behind it.
Section matrixPart(const OfViewing& of, ViewStage stage, ShownMatrix shown) {
  const ViewingStory& story = *of.story;
  Section s{"matrix " + nameWithNumber(stage), shown == ShownMatrix::AllSoFar      ? "from the world"
                                               : shown == ShownMatrix::ToTheScreen ? "to pixels, before / w"
                                                                                   : ""};
  if (s.aside.empty()) s.aside = story.stages.letters(stage);
  if (!hasMatrix(stage) && shown == ShownMatrix::ThisStage) {
    const bool clipped = stage == ViewStage::Clipped;
    s.say(clipped
              ? "Clipping is no matrix. It cuts polygons at the front plane, at the back plane, and 8,192 "
                "pixels from the picture's corner. The sides of the window cut nothing: filling does that."
          : story.snapped ? "Rounding is no matrix. In steps of the grid:"
                          : "Rounding is no matrix. This vertex is cut off before it.",
          9);
    for (int k = 0; k < 3 && !clipped && story.snapped; ++k) {
      const double p = story.of(ViewStage::Viewport).at[k],
                   steps = p * (k < 2 ? double{kGrid} : std::ldexp(double{kGrid}, -story.zShift));
      s.say(std::string{"xyz"[k]} + "  " + fitted(p, 4, 10) + " px = " + fitted(steps, 2, 14) + ", so " +
                grouped((*story.snapped)[k]),
            9);
    }
    return s;
  }
  const MatrixWithVertex m = matrixOf(story, stage, shown, lengthUnit(of.picture.scene()));
  Table t{.least = 4};
  for (const char c : std::string_view{"[nnnn][n]=[n]"})
    t.columns.push_back(c == 'n' ? Column{.right = true} : Column{.bracket = c});
  for (int row = 0; row < 4; ++row) {
    const std::array v{m.matrix[0][row], m.matrix[1][row], m.matrix[2][row],
                       m.matrix[3][row], m.from[row],      m.to[row]};
    std::vector<Entry>& cells = t.rows.emplace_back();
    std::size_t k = 0;
    for (const Column& c : t.columns) {
      cells.emplace_back();
      if (c.bracket) continue;
      const double n = v[k++];
      if (n == 0.0 || n == 1.0)
        cells.back() = {.words = fixed(n, 0), .tone = Tone::Soft};
      else
        cells.back() = {.tone = k == 5 ? Tone::Ink : Tone::Bold, .number = n};
    }
  }
  s.add(std::move(t));
  return s;
}

std::string lightWords(const Picture& picture) {
  return rowOf(picture.settings().shading).lit ? "N and L at the true angle"
                                               : "the picture itself uses no light";
}

Data stageData(const OfViewing& of, ViewStage stage) {
  const ViewingStory& story = *of.story;
  const double unit = lengthUnit(of.picture.scene());
  const VertexAtStage& here = story.of(stage);
  List lights;
  for (const ExplainedLight& light : here.equation.lights)
    lights.push_back(Object{{"L", light.L}, {"N.L", light.NdotL}, {"cosine", light.cosine}});
  return Object{{"name", rowOf(stage).name},
                {"letters", story.stages.letters(stage)},
                {"matrix", rowsOf(matrixOf(story, stage, ShownMatrix::ThisStage, unit).matrix)},
                {"so_far", rowsOf(matrixOf(story, stage, ShownMatrix::AllSoFar, unit).matrix)},
                {"at", shownAt(story, stage, unit)},
                {"N", here.N},
                {"V", here.equation.V},
                {"lights", lights},
                {"I", here.I},
                {"keeps_angles", here.keepsAngles},
                {"N.L", here.NdotL},
                {"cell", here.cell}};
}

}  // namespace

Page ofViewing(const OfViewing& of) {
  const ViewingStory& story = *of.story;
  const Picture& picture = of.picture;
  const Scene& scene = picture.scene();
  const glm::ivec2 size{picture.settings().width, picture.settings().height};
  const std::string vertex = textOf(story.vertex), part = partOf(scene, story.vertex),
                    projection =
                        picture.camera().view.projection == Projection::Parallel ? "parallel" : "perspective";
  Page page{.of = "vertex " + vertex + " of " + titleOf(scene) + " at " + sizeText(size.x, size.y) + ": " +
                  part + ", point " + std::to_string(story.point) + " of the mesh; " + projection};
  Section s;
  s.fact("vertex", vertex), s.fact("face", story.vertex.face), s.fact("corner", story.vertex.corner + 1);
  s.fact("point", story.point), s.fact("group", part), s.fact("size", size);
  s.fact("projection", projection), s.fact("unit", lengthUnit(scene));
  List stages;
  for (const ViewStageRow& row : kViewStages) stages.push_back(stageData(of, row.id));
  s.fact("stages", stages), s.fact("outside", namesOf(story.outside)), s.fact("cut_by", namesOf(story.cut));
  s.fact("face_gone", story.faceGone), s.fact("snapped", story.snapped), s.fact("plane", story.plane);
  s.fact("z_shift", story.zShift), s.fact("of_picture", story.ofPicture), s.fact("agrees", story.agrees);
  if (const std::string lengths = lengthsText(scene); !lengths.empty()) s.say(lengths);
  s.add(stageTable(of, -1));
  s.say(snappedWords(story)).indent = 12;
  s.say(std::string{"N is the plane's normal; I is the equation's at the vertex with this N"} +
        (picture.shading().lighting().channels > 1 ? ", as a gray" : "") +
        ". Behind the world, N goes where the plane goes, L and V where these directions go; fatt stays");
  page.sections.push_back(std::move(s));
  for (const ViewStageRow& row : kViewStages)
    if (!story.stages.letters(row.id).empty())
      page.sections.push_back(matrixPart(of, row.id, ShownMatrix::ThisStage));
  Section& end = page.sections.emplace_back(Section{"shading", lightWords(picture)});
  end.say("x, y and z are divided by w " +
          fitted(matrixOf(story, ViewStage::Viewport, ShownMatrix::ThisStage, 1.0).to.w, 4, 10) +
          ": that is the row of 6 viewport");
  for (const ViewStageRow& row : kViewStages)
    if (hasMatrix(row.id)) {
      Finding& found = end.add(findingOf(story, row.id));
      found.bold = nameWithNumber(row.id) + ": " + found.bold;
    }
  if (story.snapped)
    end.say(std::string{"the picture's vertex is "} +
            (story.agrees ? "the one that the stages lead to, to the last bit" : "ANOTHER ONE"));
  return page;
}

Page stagesOf(const OfViewing& of, ViewStage stage) {
  const FaceCorner& vertex = of.story->vertex;
  const std::string face = "face " + std::to_string(vertex.face), part = partOf(of.picture.scene(), vertex);
  return {.sections = {{"a vertex and its plane",
                        (part == face ? face : face + ", " + part) + ", corner " +
                            std::to_string(vertex.corner + 1) + "; click another, or press g",
                        {stageTable(of, static_cast<int>(stage))}}}};
}

Page matrixAndLight(const OfViewing& of, ViewStage stage, ShownMatrix shown) {
  Section light{"shading", lightWords(of.picture)};
  light.add(Sketch{.draw =
                       [story = of.story, stage](Pen& pen, const Rect& at) {
                         const int half = (at.width - 16) / 2;
                         drawAngle(pen, {at.x, at.y, half, at.height}, *story, ViewStage::World);
                         drawAngle(pen, {at.x + half + 16, at.y, half, at.height}, *story,
                                   stage == ViewStage::World ? ViewStage::Vrc : stage);
                       },
                   .lines = 5,
                   .weight = 9});
  light.add(findingOf(*of.story, stage));
  return {.sections = {matrixPart(of, stage, shown), std::move(light)}};
}

}  // namespace page

}  // namespace xnewell
