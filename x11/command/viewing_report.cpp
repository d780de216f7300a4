#include "x11/command/viewing_report.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "x11/drawing/wording.h"
#include "x11/viewing/viewing_words.h"

namespace xnewell {

namespace {

using JsonOfStages = nlohmann::ordered_json;

constexpr int kStageName = 12, kPlace = 11, kNormal = 9;

std::string stageName(ViewStage stage) {
  return std::to_string(static_cast<int>(stage) + 1) + ' ' + std::string{rowOf(stage).name};
}

void printRow(const ViewingStory& story, ViewStage stage, double unit, std::ostream& out) {
  std::string name = stageName(stage);
  name.resize(kStageName, ' ');
  out << name;
  if (stage == ViewStage::Clipped) {
    out << clippedWords(story) << '\n';
    return;
  }
  if (stage == ViewStage::Snapped) {
    out << snappedWords(story) << '\n' << std::string(kStageName, ' ') << planeWords(story) << '\n';
    return;
  }
  const VertexAtStage& here = story.of(stage);
  const glm::dvec4 p = shownAt(story, stage, unit);
  for (int k = 0; k < 4; ++k) out << std::setw(kPlace) << fitted(p[k], 4, kPlace - 1);
  for (int k = 0; k < 3; ++k) out << std::setw(kNormal) << fixed(here.N[k], 4);
  out << std::setw(kNormal) << (here.NdotL ? fixed(*here.NdotL, 4) : "-") << std::setw(kNormal)
      << fixed(here.I, 4);
  if (here.cell) out << std::setw(6) << *here.cell;
  if (story.differsInNdotL(stage) || story.differsInI(stage)) out << "  not the world's";
  out << '\n';
}

void printMatrix(const ViewingStory& story, ViewStage stage, double unit, std::ostream& out) {
  const MatrixWithVertex m = matrixOf(story, stage, ShownMatrix::ThisStage, unit);
  out << "matrix of " << stageName(stage) << ": " << story.stages.letters(stage) << '\n';
  for (int row = 0; row < 4; ++row) {
    out << "  ";
    for (int column = 0; column < 4; ++column)
      out << std::setw(kPlace) << fitted(m.matrix[column][row], 4, kPlace - 1);
    out << "   |" << std::setw(kPlace) << fitted(m.from[row], 4, kPlace - 1) << (row == 1 ? "  =" : "   ")
        << std::setw(kPlace) << fitted(m.to[row], 4, kPlace - 1) << '\n';
  }
}

JsonOfStages listOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
JsonOfStages listOf(const glm::dvec4& v) { return {v.x, v.y, v.z, v.w}; }
JsonOfStages rowsOf(const glm::dmat4& m) {
  JsonOfStages rows = JsonOfStages::array();
  for (int row = 0; row < 4; ++row) rows.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
  return rows;
}

JsonOfStages namesOf(unsigned planes) {
  JsonOfStages names = JsonOfStages::array();
  for (int k = 0; k < 6; ++k)
    if (planes >> k & 1u) names.push_back(clipPlaneName(k));
  return names;
}

JsonOfStages stageAsJson(const ViewingStory& story, ViewStage stage, double unit) {
  const VertexAtStage& here = story.of(stage);
  JsonOfStages lights = JsonOfStages::array();
  for (const ExplainedLight& light : here.equation.lights)
    lights.push_back({{"L", listOf(light.L)}, {"N.L", light.NdotL}, {"cosine", light.cosine}});
  JsonOfStages object{{"name", rowOf(stage).name},
                      {"letters", story.stages.letters(stage)},
                      {"matrix", rowsOf(matrixOf(story, stage, ShownMatrix::ThisStage, unit).matrix)},
                      {"so_far", rowsOf(matrixOf(story, stage, ShownMatrix::AllSoFar, unit).matrix)},
                      {"at", listOf(shownAt(story, stage, unit))},
                      {"N", listOf(here.N)},
                      {"V", listOf(here.equation.V)},
                      {"lights", lights},
                      {"I", here.I},
                      {"keeps_angles", here.keepsAngles}};
  object["N.L"] = here.NdotL ? JsonOfStages(*here.NdotL) : JsonOfStages(nullptr);
  object["cell"] = here.cell ? JsonOfStages(*here.cell) : JsonOfStages(nullptr);
  return object;
}

std::string_view projectionOf(const Picture& picture) {
  return picture.camera().view.projection == Projection::Parallel ? "parallel" : "perspective";
}

}  // namespace

void printViewing(const Picture& picture, const FaceCorner& vertex, std::ostream& out) {
  const ViewingStory story{picture, vertex};
  const double unit = lengthUnit(picture.scene());
  out << "vertex " << textOf(vertex) << " of " << titleOf(picture.scene()) << " at "
      << sizeText(picture.settings().width, picture.settings().height) << ": "
      << partOf(picture.scene(), vertex) << ", point " << story.point << " of the mesh; "
      << projectionOf(picture) << '\n';
  if (const std::string lengths = lengthsInWords(picture.scene()); !lengths.empty()) out << lengths << '\n';
  std::string head = "stage";
  head.resize(kStageName, ' ');
  out << head;
  for (const char* name : {"x", "y", "z", "w"}) out << std::setw(kPlace) << name;
  for (const char* name : {"Nx", "Ny", "Nz", "N.L", "I"}) out << std::setw(kNormal) << name;
  out << (story.world().cell ? "  cell\n" : "\n");
  for (const ViewStageRow& row : kViewStages) printRow(story, row.id, unit, out);
  out << "N is the plane's normal; I is the equation's at the vertex with this N"
      << (picture.shading().lighting().channels > 1 ? ", as a gray" : "")
      << ". Behind the world, N goes where "
      << "the plane\ngoes, L and V where these directions go; fatt stays\n";
  if (const ShadingRow& method = rowOf(picture.settings().shading); !method.lit)
    out << "the picture itself has --shade " << method.name << ", which uses no light\n";
  for (const ViewStageRow& row : kViewStages)
    if (!story.stages.letters(row.id).empty()) printMatrix(story, row.id, unit, out);
  out << "  x, y and z are divided by w "
      << fitted(matrixOf(story, ViewStage::Viewport, ShownMatrix::ThisStage, unit).to.w, 4, 10)
      << ": that is the row of 6 viewport\n";
  for (const ViewStageRow& row : kViewStages) {
    if (row.id == ViewStage::Clipped || row.id == ViewStage::Snapped) continue;
    const ViewingFinding finding = findingOf(story, row.id);
    out << stageName(row.id) << ": " << finding.heading << ' ' << finding.why << '\n';
  }
  if (!story.snapped) return;
  out << "the picture's vertex is "
      << (story.agrees ? "the one that the stages lead to, to the last bit" : "ANOTHER ONE") << '\n';
}

void printViewingAsJson(const Picture& picture, const FaceCorner& vertex, std::ostream& out) {
  const ViewingStory story{picture, vertex};
  const double unit = lengthUnit(picture.scene());
  JsonOfStages stages = JsonOfStages::array();
  for (const ViewStageRow& row : kViewStages) stages.push_back(stageAsJson(story, row.id, unit));
  JsonOfStages all{{"vertex", textOf(vertex)},
                   {"face", vertex.face},
                   {"corner", vertex.corner + 1},
                   {"point", story.point},
                   {"group", partOf(picture.scene(), vertex)},
                   {"size", {picture.settings().width, picture.settings().height}},
                   {"projection", projectionOf(picture)},
                   {"unit", unit},
                   {"stages", stages},
                   {"outside", namesOf(story.outside)},
                   {"cut_by", namesOf(story.cut)},
                   {"face_gone", story.faceGone}};
  all["snapped"] = nullptr, all["plane"] = nullptr;
  if (story.snapped) all["snapped"] = {story.snapped->x, story.snapped->y, story.snapped->z};
  if (story.plane) all["plane"] = listOf(*story.plane);
  all.update({{"z_shift", story.zShift}, {"of_picture", story.ofPicture}, {"agrees", story.agrees}});
  out << all.dump(-1, ' ', false, JsonOfStages::error_handler_t::replace) << '\n';
}

}  // namespace xnewell
